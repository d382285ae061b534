"""Periods, steps and slopes in series of figures, and what moved between two calibrations."""

from dataclasses import replace
from datetime import datetime, timedelta

import numpy as np
import pytest

from crenel.metrology.calibration.drift import ARCSEC, Drift, MountedSensor, measure_drift
from crenel.metrology.change_points import MOST_VALUES, find_changes
from crenel.metrology.common_slope import fit_common_slope
from crenel.metrology.figure_history import FigureHistory, find_history
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.transforms import Floats, rigid, rotation_from_vector
from tests.formats.builders import little_calibration
from tests.present import present

START = datetime(2026, 1, 1)
DAY = timedelta(days=1)
MONTH = 30
UV = np.array([(u, v) for u in (10, 20, 30, 40, 50) for v in (15, 24, 33)], dtype=float)


def history(
    *levels: float, seed: int = 0, every: int = 3, right_since: datetime | None = None
) -> FigureHistory:
    """Tests of as many months as there are levels, each with its calibration; scatter 2 µm."""
    rng = np.random.default_rng(seed)
    days = range(1, len(levels) * MONTH, every)
    values = [28.0 + levels[day // MONTH] + float(rng.normal(0, 2.0)) for day in days]
    used = [f"cal-{day // MONTH}" for day in days]
    return find_history([START + DAY * day for day in days], values, used, right_since)


def months_of(found: FigureHistory) -> list[list[int]]:
    """Of each period, the months whose middle is surely in it."""
    middles = [START + DAY * (MONTH * month + MONTH // 2) for month in range(20)]
    within = (one.surely_contains for one in found.periods)
    return [[month for month, at in enumerate(middles) if holds(at)] for holds in within]


@pytest.mark.parametrize("seed", range(5))
def test_two_wrong_months_of_different_levels_are_one_period_that_ends(seed: int) -> None:
    found = history(0, 0, 0, 12, 6, 0, 0, 0, 0, 0, seed=seed)
    assert months_of(found) == [[3, 4]]
    (period,) = found.periods
    assert period.ended is not None
    assert len(period.levels) == 2
    assert abs(period.size - 12.0) < 4 * period.standard_uncertainty


@pytest.mark.parametrize("seed", range(5))
def test_the_level_of_most_values_is_right_if_the_first_month_is_wrong(seed: int) -> None:
    found = history(12, *[0] * 9, seed=seed)
    assert months_of(found) == [[0]]
    (period,) = found.periods
    assert period.change is None
    assert period.since is None
    assert found.right is not None
    assert (found.right.because, found.right.values) == ("most", 90)


def test_a_level_that_lasts_is_judged_by_the_first_one_or_by_a_chosen_one() -> None:
    levels = [0.0] * 5 + [12.0] * 5
    found = history(*levels)
    assert found.right is not None
    assert (found.right.because, found.right.values) == ("first", 50)
    assert months_of(found)[0][:5] == [5, 6, 7, 8, 9]
    chosen = history(*levels, right_since=START + DAY * 170)
    assert chosen.right is not None
    assert (chosen.right.because, chosen.right.values) == ("chosen", 50)
    assert months_of(chosen) == [[0, 1, 2, 3, 4]]
    late = history(*levels, right_since=START + DAY * 1000)
    assert months_of(late) == [[0, 1, 2, 3, 4]]


def test_ordinary_errors_of_calibrations_are_no_changes() -> None:
    accused = 0
    for seed in range(60):
        errors = np.random.default_rng(seed).normal(0, 3.0, 12)
        found = history(*errors, seed=seed)
        accused += bool(found.periods)
        assert found.spread.standard_deviation is not None
    assert accused <= 4


def test_a_calibration_well_outside_the_spread_is_found_with_its_dates() -> None:
    named = 0
    for seed in range(30):
        errors = np.random.default_rng(seed).normal(0, 3.0, 12)
        errors[4] = 36.0
        found = history(*errors, seed=seed)
        named += months_of(found) == [[4]]
    assert named >= 28


def test_a_calibration_at_the_edge_of_the_spread_is_called_perhaps_wrong_with_its_dates() -> None:
    noted = 0
    for seed in range(30):
        errors = np.random.default_rng(seed).normal(0, 3.0, 12)
        errors[4] = 15.0
        found = history(*errors, seed=seed)
        for one in found.spread.doubtful:
            if one.calibration_id == "cal-4":
                assert abs(one.size - 15.0) < 9.0
                assert START + DAY * 120 <= one.since < one.until < START + DAY * 150
        names = {one.calibration_id for one in found.spread.doubtful}
        noted += "cal-4" in names or months_of(found) == [[4]]
    assert noted >= 20


def test_a_change_while_a_calibration_is_in_use_needs_no_spread() -> None:
    errors = np.random.default_rng(3).normal(0, 3.0, 12)
    rng = np.random.default_rng(4)
    days = range(1, 12 * MONTH)
    moved = [12.0 if 130 <= day < 150 else 0.0 for day in days]
    pairs = zip(days, moved, strict=True)
    values = [errors[day // MONTH] + more + rng.normal() for day, more in pairs]
    used = [f"cal-{day // MONTH}" for day in days]
    found = find_history([START + DAY * day for day in days], values, used)
    (period,) = found.periods
    assert period.change is not None
    assert period.ended is not None
    assert period.change.earliest < START + DAY * 130 <= period.change.latest
    assert period.ended.earliest < START + DAY * 150 <= period.ended.latest


def test_few_calibrations_do_not_tell_their_spread() -> None:
    found = history(0, 0, 12, seed=1)
    assert found.spread.standard_deviation is None
    assert found.spread.calibrations == 3
    assert months_of(found)[0][0] == 2


@pytest.mark.parametrize("high", [1, 2])
def test_one_or_two_high_values_stand_out_and_are_no_period(high: int) -> None:
    rng = np.random.default_rng(high)
    values = 28.0 + rng.normal(0, 2.0, 40)
    values[20 : 20 + high] += 25.0
    times = [START + DAY * day for day in range(40)]
    found = find_history(times, values.tolist())
    assert found.periods == ()
    assert [one.at for one in found.standing_out] == times[20 : 20 + high]
    quiet = find_history(times, (28.0 + rng.normal(0, 2.0, 40)).tolist())
    assert quiet.standing_out == ()


def test_no_values_and_few_values_have_a_history() -> None:
    assert find_history([], []).right is None
    assert find_history([START], [1.0]).levels == ()
    three = find_history([START + DAY * n for n in range(3)], [1.0, 2.0, 1.5])
    assert present(three.right).values == 3


def series(seed: int, *levels: tuple[int, float]) -> Floats:
    """Segments of so many values about a mean, with a standard deviation of 1."""
    rng = np.random.default_rng(seed)
    return np.concatenate([level + rng.normal(size=count) for count, level in levels])


def test_a_month_of_ten_is_found_with_both_ends() -> None:
    for seed in range(20):
        found = find_changes(series(seed, (60, 30.0), (15, 36.0), (75, 30.0)))
        assert len(found) == 2, seed
        for change, place, size in zip(found, (60, 75), (6.0, -6.0), strict=True):
            assert change.first_index <= place <= change.last_index
            assert abs(change.size - size) < 4 * change.standard_uncertainty


def test_what_does_not_change_has_none() -> None:
    wrong = sum(bool(find_changes(series(seed, (100, 5.0)))) for seed in range(100))
    assert wrong <= 5


@pytest.mark.slow
def test_the_interval_holds_the_step_as_often_as_it_says() -> None:
    held = found = 0
    for seed in range(200):
        changes = find_changes(series(seed, (40, 0.0), (40, 2.0)))
        if len(changes) == 1:
            found += 1
            held += changes[0].first_index <= 40 <= changes[0].last_index
    assert found > 150
    assert held / found > 0.9


def test_a_single_outlier_is_no_change() -> None:
    for seed in range(20):
        values = series(seed, (80, 10.0))
        values[40] += 25.0
        assert find_changes(values) == []


def test_a_small_step_has_a_wide_interval() -> None:
    (large,) = find_changes(series(1, (50, 0.0), (50, 8.0)))
    (small,) = find_changes(series(1, (50, 0.0), (50, 1.5)))
    assert large.last_index - large.first_index < small.last_index - small.first_index


def test_steps_within_the_stated_uncertainty_are_none() -> None:
    values = series(2, (50, 0.0), (50, 3.0))
    assert find_changes(values)
    assert find_changes(values, least_sd=20.0) == []


def test_few_or_equal_values_have_none_and_too_many_are_refused() -> None:
    assert find_changes(np.array([1.0, 9.0, 1.0])) == []
    assert find_changes(np.full(50, 3.0)) == []
    with pytest.raises(ValueError, match="more than"):
        find_changes(np.zeros(MOST_VALUES + 1))


def test_levels_of_groups_do_not_look_like_a_slope() -> None:
    groups = np.repeat(np.arange(4), 5)
    hours = np.tile(np.linspace(0, 100, 5), 4) + 10.0 * groups
    values = 50.0 * groups + 0.02 * hours
    found = present(fit_common_slope(hours, values, groups))
    assert found.value == pytest.approx(0.02)
    assert found.is_significant
    assert (found.values, found.groups) == (20, 4)


def test_the_uncertainty_covers_the_slope_in_95_of_100_cases() -> None:
    rng = np.random.default_rng(3)
    groups = np.repeat(np.arange(5), 4)
    covered, by_chance, runs = 0, 0, 2000
    for _ in range(runs):
        hours = rng.uniform(0, 500, len(groups))
        level = rng.normal(0, 20, 5)[groups]
        noise = rng.normal(0, 2, len(groups))
        aged = fit_common_slope(hours, level + 0.01 * hours + noise, groups)
        constant = fit_common_slope(hours, level + noise, groups)
        assert aged is not None
        covered += abs(aged.value - 0.01) <= aged.expanded_uncertainty
        by_chance += present(constant).is_significant
    assert 0.935 <= covered / runs <= 0.965
    assert 0.035 <= by_chance / runs <= 0.065


@pytest.mark.parametrize(
    ("arguments", "groups"),
    [
        ([], []),
        ([1.0, 2.0, 3.0], [0, 1, 2]),
        ([1.0, 2.0], [0, 0]),
        ([20.0, 20.0, 21.0, 21.0], [0, 0, 1, 1]),
    ],
)
def test_too_few_values_have_no_slope(arguments: list[float], groups: list[int]) -> None:
    values = np.array(arguments, dtype=np.float64) * 2
    numbers = np.array(groups, dtype=np.int64)
    assert fit_common_slope(np.array(arguments, dtype=np.float64), values, numbers) is None


@pytest.fixture
def mounted() -> MountedSensor:
    found = little_calibration()
    return MountedSensor(found.camera, found.plane, found.T_flange_sensor)


def drift_of(before: MountedSensor, after: MountedSensor) -> Drift:
    return present(measure_drift(before, after, UV))


def test_a_sensor_that_stayed_did_not_move(mounted: MountedSensor) -> None:
    found = drift_of(mounted, mounted)
    assert (found.sensor_um, found.plane_um, found.points_um) == (0, 0, 0)
    assert found.sensor_arcsec == pytest.approx(0, abs=1e-2)


def test_a_shift_and_a_turn_are_distinguished(mounted: MountedSensor) -> None:
    T = mounted.T_flange_sensor
    shifted = replace(mounted, T_flange_sensor=rigid(np.eye(3), np.array([0.03, 0, 0.04])) @ T)
    found = drift_of(mounted, shifted)
    assert found.sensor_um == pytest.approx(50)
    assert found.points_um == pytest.approx(50)
    assert found.sensor_arcsec == pytest.approx(0, abs=1e-2)
    assert found.plane_um <= 50
    turn = rotation_from_vector(np.array([0, 60 / ARCSEC, 0]))
    turned = replace(mounted, T_flange_sensor=T @ rigid(turn, np.zeros(3)))
    assert drift_of(mounted, turned).sensor_arcsec == pytest.approx(60, rel=1e-6)


def test_a_plane_that_tilts_is_reported_in_seconds_of_arc(mounted: MountedSensor) -> None:
    plane = mounted.plane
    along = np.cross(plane.normal, [1.0, 0.0, 0.0])
    tilt = rotation_from_vector(along / np.linalg.norm(along) * 30 / ARCSEC)
    flipped = LaserPlane(-(tilt @ plane.normal), -plane.offset_mm)
    assert drift_of(mounted, replace(mounted, plane=flipped)).plane_arcsec == pytest.approx(
        30, rel=1e-6
    )


def test_too_few_common_points_give_no_drift(mounted: MountedSensor) -> None:
    assert measure_drift(mounted, mounted, UV[:5]) is None
