"""When a device loses much of its data."""

import pytest

from crenel.station.devices.losses import HELD_S, LossAlarm
from crenel_hardware.interfaces import LinkHealth


def run(seconds: list[tuple[int, int, int]]) -> list[bool]:
    """Whether the alarm is on after each second with so many records received, lost and late."""
    alarm, counts, now_s = LossAlarm(), LinkHealth(), 100.0
    states = []
    alarm.note(now_s, counts)
    for received, lost, late in seconds:
        for tenth in range(1, 11):
            now_s += 0.1
            counts.received += received * tenth // 10 - received * (tenth - 1) // 10
            counts.lost += lost * tenth // 10 - lost * (tenth - 1) // 10
            counts.late += late if tenth == 1 else 0
            alarm.note(now_s, counts)
        states.append(alarm.is_on(now_s))
    return states


def test_losses_in_a_row_raise_it_and_it_lasts() -> None:
    quiet, lossy = (25, 0, 0), (15, 10, 0)
    ended = int(HELD_S) + 2
    states = run([quiet, lossy, *ended * [quiet]])
    assert states[:3] == [False, True, True]
    assert not states[-1]


def test_late_records_raise_it() -> None:
    assert run([(25, 0, 0), (6, 0, 1)]) == [False, True]


@pytest.mark.parametrize("second", [(25, 2, 0), (1000, 100, 0), (2, 2, 0)])
def test_single_losses_do_not(second: tuple[int, int, int]) -> None:
    assert run(10 * [second]) == 10 * [False]


def test_another_device_begins_without_it() -> None:
    alarm = LossAlarm()
    alarm.note(0.0, LinkHealth())
    alarm.note(1.0, LinkHealth(received=3, lost=30))
    assert alarm.is_on(1.0)
    alarm.clear()
    alarm.note(1.1, LinkHealth())
    assert not alarm.is_on(1.1)
