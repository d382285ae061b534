"""Settings over time: pictures that arrive late get the value of their exposure."""

from hypothesis import given
from hypothesis import strategies as st

from hardware.sensor.genicam.history import SettingHistory


def test_a_picture_before_the_change_has_the_old_value() -> None:
    history = SettingHistory(1000.0)
    history.change(50, 2000.0)
    history.change(90, 3000.0)
    assert [history.value_at(time) for time in (-5, 49, 50, 89, 90, 500)] == [
        1000.0,
        1000.0,
        2000.0,
        2000.0,
        3000.0,
        3000.0,
    ]
    assert history.latest == 3000.0


def test_between_two_times_all_values_count() -> None:
    history = SettingHistory(False)
    history.change(10, True)
    history.change(20, False)
    assert history.values_between(11, 19) == {True}
    assert history.values_between(9, 12) == {False, True}
    assert history.values_between(15, 25) == {False, True}
    assert history.values_between(20, 30) == {False}


@given(st.lists(st.integers(1, 1000), min_size=20, max_size=60))
def test_the_latest_changes_are_kept(steps: list[int]) -> None:
    history, time = SettingHistory(0.0), 0
    for number, step in enumerate(steps, 1):
        time += step
        history.change(time, float(number))
    assert history.value_at(time) == len(steps)
    assert history.value_at(time - 1) == len(steps) - 1
    assert history.value_at(0) > 0
