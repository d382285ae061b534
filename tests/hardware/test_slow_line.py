"""A line that is too slow for the pictures, and a receive buffer that is too small for one."""

from pathlib import Path

import pytest

from crenel_hardware.sensor.genicam.aravis_source import receive_buffer_remedy
from crenel_hardware.sensor.genicam.slow_line import SlowLine

MS = 1_000_000
PERIOD_MS = 40


def judge(arrivals_ms: list[float]) -> list[bool]:
    """Pictures exposed every 40 ms, by their arrivals."""
    line = SlowLine()
    return [
        line.holds_up(number, number * PERIOD_MS * MS, round(at * MS))
        for number, at in enumerate(arrivals_ms)
    ]


def test_pictures_that_come_later_and_later_are_held_up() -> None:
    assert judge([5, 45, 85, 250, 415, 580]) == [False, False, False, False, False, True]


def test_a_pause_of_the_computer_or_jitter_is_no_slow_line() -> None:
    """All that waited follow at once; and a clock that was compared badly is only an offset."""
    arrivals_ms = [5.0, 45, 900, 901, 902, 903, 904, 905, 1300, 1301, 1302]
    assert not any(judge(arrivals_ms))
    assert not any(judge([number * PERIOD_MS + 700.0 for number in range(20)]))
    assert not any(judge([5, 45, 110, 175, 240, 241, 260, 300, 365, 430]))


def begun_line() -> SlowLine:
    line = SlowLine()
    for number in range(2):
        line.holds_up(number, number * PERIOD_MS * MS, number * PERIOD_MS * MS)
    return line


def watch(pictures_ms: list[float], until_ms: int, busy: bool = True) -> list[int]:
    """The times in ms at which the line is said to be too slow, looked at every 50 ms. Pictures,
    exposed every 40 ms, are complete at ``pictures_ms``; ``busy``: bytes arrive all the time."""
    line, said, come = begun_line(), [], 0
    for at_ms in range(0, until_ms, 50):
        now = sum(at <= at_ms for at in pictures_ms)
        if line.is_too_slow(at_ms * MS, (at_ms if busy else 0) + now, now > come):
            said.append(at_ms)
        come = now
    return said


def test_a_picture_that_takes_long_is_noticed_before_it_has_arrived() -> None:
    assert watch([], 2000) == [400]
    # once for each, from when it has taken too long
    assert watch([1000.0, 2000.0], 3000) == [400, 1200, 2400]


def test_a_line_on_which_a_picture_takes_a_tenth_of_a_second_is_noticed() -> None:
    assert watch([100.0 * number for number in range(1, 20)], 700)[0] == 400


def test_a_line_that_carries_all_pictures_or_is_idle_between_them_is_not_slow() -> None:
    assert not watch([50.0 * number for number in range(60)], 3000)
    assert not watch([300.0 * number for number in range(10)], 3000, busy=False)


def test_after_a_pause_of_the_computer_the_line_is_watched_again() -> None:
    line = begun_line()
    looks_ms = [0, 50, 1050, 1100, 1400, 1450]
    assert not any(line.is_too_slow(at * MS, at + 1, False) for at in looks_ms)


def test_a_buffer_smaller_than_a_picture_is_said(tmp_path: Path) -> None:
    limit = tmp_path / "rmem_max"
    assert receive_buffer_remedy(1_310_720, limit) == ""
    limit.write_text("212992\n")
    text = str(receive_buffer_remedy(1_310_720, limit))
    assert "213 kB" in text
    assert "1311 kB" in text or "1,311 kB" in text
    assert "sudo sysctl -w net.core.rmem_max=33554432" in text
    assert receive_buffer_remedy(200_000, limit) == ""


@pytest.mark.parametrize("content", ["", "much"])
def test_a_limit_that_cannot_be_read_is_not_judged(tmp_path: Path, content: str) -> None:
    limit = tmp_path / "rmem_max"
    limit.write_text(content)
    assert receive_buffer_remedy(1_310_720, limit) == ""
