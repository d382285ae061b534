"""Steps in a series are found where they are, and nowhere else."""

import numpy as np
import pytest

from app.metrology.change_points import MOST_VALUES, find_changes
from app.metrology.transforms import Floats


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
