"""Periods end where the right level is back; ordinary errors of calibrations are no changes."""

from datetime import datetime, timedelta

import numpy as np
import pytest

from app.metrology.figure_history import FigureHistory, find_history

START = datetime(2026, 1, 1)
DAY = timedelta(days=1)
MONTH = 30


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
    return [
        [month for month, at in enumerate(middles) if one.surely_contains(at)]
        for one in found.periods
    ]


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
    values = [
        errors[day // MONTH] + more + rng.normal() for day, more in zip(days, moved, strict=True)
    ]
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
    assert three.right is not None
    assert three.right.values == 3
