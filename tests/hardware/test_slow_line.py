"""A line that is too slow for the pictures, and a receive buffer that is too small for one."""

from pathlib import Path

import pytest

from hardware.sensor.genicam.gige_vision.receive_buffer import receive_buffer_remedy
from hardware.sensor.genicam.slow_line import SlowLine

MS = 1_000_000
PERIOD_MS = 40


def judge(arrivals_ms: list[float]) -> list[bool]:
    """Pictures exposed every 40 ms, by their arrivals."""
    line = SlowLine()
    return [
        line.holds_up(number * PERIOD_MS * MS, round(at * MS))
        for number, at in enumerate(arrivals_ms)
    ]


def test_pictures_that_come_later_and_later_are_held_up() -> None:
    assert judge([5, 45, 85, 250, 415, 580]) == [False, False, False, False, False, True]


def test_a_pause_of_the_computer_is_no_slow_line() -> None:
    """All that waited follow at once; and a clock that was compared badly is only an offset."""
    arrivals_ms = [5.0, 45, 900, 901, 902, 903, 904, 905, 1300, 1301, 1302]
    assert not any(judge(arrivals_ms))
    assert not any(judge([number * PERIOD_MS + 700.0 for number in range(20)]))


def test_jitter_is_no_slow_line() -> None:
    assert not any(judge([5, 45, 110, 175, 240, 241, 260, 300, 365, 430]))


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
