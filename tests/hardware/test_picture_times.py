"""Times of pictures: the camera's stamps, and settings that change while pictures arrive late."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from crenel_hardware.sensor.genicam.picture_times import PictureTimes, SettingHistory
from crenel_hardware.sensor.image_source import StampAt

PERIOD_NS = 20_000_000
DELAY_NS = 300_000


def test_a_picture_before_the_change_has_the_old_value() -> None:
    history = SettingHistory(1000.0)
    history.change(50, 2000.0)
    history.change(90, 3000.0)
    values = [history.value_at(time) for time in (-5, 49, 50, 89, 90, 500)]
    assert values == [1000.0, 1000.0, 2000.0, 2000.0, 3000.0, 3000.0]
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


@pytest.fixture
def times() -> PictureTimes:
    return PictureTimes(SettingHistory(2000.0), "exposure-start", 0.0)


def show(
    times: PictureTimes, exposures: SettingHistory, begun_ns: int, stamp_at: StampAt, jitter_ns: int
) -> tuple[int, float]:
    """One picture of a camera whose clock is a day behind; its middle and exposure as computed."""
    exposure_ns = round(1000 * exposures.value_at(begun_ns))
    after_begin = {"exposure-start": 0, "mid-exposure": exposure_ns // 2}.get(stamp_at, exposure_ns)
    arrival_ns = begun_ns + exposure_ns + DELAY_NS + jitter_ns
    return times.middle(begun_ns + after_begin - 86_400_000_000_000, arrival_ns, None)


@pytest.mark.parametrize("stamp_at", ["exposure-start", "mid-exposure", "exposure-end"])
def test_the_middle_is_that_of_the_exposure_whatever_is_stamped(stamp_at: StampAt) -> None:
    rng = np.random.default_rng(3)
    exposures = SettingHistory(2000.0)
    times = PictureTimes(exposures, stamp_at, DELAY_NS / 1000)
    late_ns = []
    for index in range(100):
        begun_ns = 10**12 + index * PERIOD_NS
        jitter_ns = int(rng.integers(0, 3_000_000))
        middle_ns, exposure_us = show(times, exposures, begun_ns, stamp_at, jitter_ns)
        late_ns.append(middle_ns - begun_ns - 1_000_000)
        assert exposure_us == 2000.0
    # the first arrivals may all be late; then the earliest ones count
    assert max(np.abs(late_ns[50:])) < 200_000
    assert times.stamps == "device"


@pytest.mark.parametrize("stamp_at", ["exposure-start", "mid-exposure", "exposure-end"])
def test_a_changed_exposure_holds_for_pictures_that_began_after_it(stamp_at: StampAt) -> None:
    exposures = SettingHistory(2000.0)
    times = PictureTimes(exposures, stamp_at, DELAY_NS / 1000)
    found = []
    for index in range(100):
        begun_ns = 10**12 + index * PERIOD_NS
        found.append((show(times, exposures, begun_ns, stamp_at, 0), begun_ns))
        if index == 49:
            exposures.change(begun_ns + 10_000_000, 8000.0)
    assert [exposure for (_, exposure), _ in found] == 50 * [2000.0] + 50 * [8000.0]
    for (middle_ns, exposure_us), begun_ns in found:
        assert middle_ns == pytest.approx(begun_ns + 500 * exposure_us, abs=100_000)


def test_the_exposure_that_comes_with_the_picture_counts(times: PictureTimes) -> None:
    assert times.middle(10**9, 10**12, 5000.0) == (10**12 - 2_500_000, 5000.0)


def test_without_stamps_the_arrival_is_the_end_of_the_exposure() -> None:
    times = PictureTimes(SettingHistory(2000.0), "exposure-start", 100.0)
    assert times.middle(None, 10**12, None) == (10**12 - 1_100_000, 2000.0)
    assert (times.stamps, times.stamp_at) == ("arrival", "frame-end")


def test_middles_increase_whatever_arrives(times: PictureTimes) -> None:
    arrivals = [10**12, 10**12, 10**12 - 5_000_000, 10**12 + 1]
    middles = [times.middle(None, arrival, None)[0] for arrival in arrivals]
    assert np.all(np.diff(middles) > 0)


def test_once_the_clocks_are_compared_arrivals_do_not_matter(times: PictureTimes) -> None:
    for number in range(100):
        begun_ns = number * PERIOD_NS
        times.compare(begun_ns - 500_000_000_000, begun_ns)
        late_ns = begun_ns + 70_000_000 + 1_000_000 * (number % 7)
        middle_ns, _ = times.middle(begun_ns - 500_000_000_000, late_ns, None)
        assert abs(middle_ns - begun_ns - 1_000_000) < 1000


@pytest.mark.parametrize("off_ns", [-10_000_000_000, 1_000_000_000])
def test_a_clock_that_the_pictures_contradict_is_not_used(times: PictureTimes, off_ns: int) -> None:
    """The arrivals count, as without it."""
    for number in range(100):
        begun_ns = number * PERIOD_NS
        times.compare(begun_ns, begun_ns + off_ns)
        middle_ns, _ = times.middle(begun_ns, begun_ns + 2_000_000 + DELAY_NS, None)
        assert abs(middle_ns - begun_ns - DELAY_NS - 1_000_000) < 1000


def test_a_clock_that_was_compared_badly_at_first_is_used_once_known(times: PictureTimes) -> None:
    """On a busy computer the first answers may be noted late; and a picture, very late."""
    off_ns = []
    for number in range(200):
        begun_ns = 10**12 + number * PERIOD_NS
        times.compare(begun_ns - 86_400_000_000_000, begun_ns + (number < 3) * 400_000_000)
        way_ns = 4_000_000_000 if number == 150 else 150_000_000
        middle_ns, _ = times.middle(begun_ns - 86_400_000_000_000, begun_ns + way_ns, None)
        off_ns.append(middle_ns - begun_ns - 1_000_000)
    assert max(np.abs(off_ns[100:])) < 200_000_000
    assert max(np.abs(off_ns[175:])) < 1000


@pytest.mark.parametrize(
    ("set_by_ns", "jumps"),
    [(-3_600_000_000_000, True), (-100_000_000, True), (3_600_000_000_000, True), (0, False)],
)
def test_a_clock_set_between_two_shows(times: PictureTimes, set_by_ns: int, jumps: bool) -> None:
    for number in range(100):
        begun_ns = 10**13 + number * PERIOD_NS
        way_ns = 2_500_000_000 if number in (20, 60) else DELAY_NS  # as of a busy computer
        camera_ns = begun_ns + (set_by_ns if number >= 50 else 0)
        assert times.has_jumped(camera_ns, begun_ns + way_ns) == (jumps and number == 50)


def test_an_overtaken_picture_is_a_straggler_two_show_a_set_clock(times: PictureTimes) -> None:
    seen = []
    for at_ns in (100, 200, 150, 300, 250, 400, 350, 360):
        if times.is_straggler(at_ns):
            seen.append("straggler")
        else:
            seen.append("jumped" if times.has_jumped(at_ns, at_ns + DELAY_NS) else "picture")
    assert [seen.index("jumped"), seen.count("straggler"), seen.count("picture")] == [7, 3, 4]


def test_a_clock_that_is_set_in_a_pause_shows_by_the_next_comparison(times: PictureTimes) -> None:
    """A late answer is no sign of it; a camera may begin to stamp from zero when it is started."""
    for number in range(30):
        at_ns = 10**13 + number * 1_000_000_000
        times.compare(at_ns, at_ns + (number % 3) * 300_000_000)
        assert not times.has_jumped(at_ns, at_ns + DELAY_NS)
    times.restart()
    assert not times.has_jumped(0, at_ns + DELAY_NS)
    times.compare(at_ns + 5_000_000_000, at_ns + 2_000_000_000)
    assert times.has_jumped(1_000_000, at_ns + DELAY_NS + 2_000_000)
