"""The common slope of groups is found, with an uncertainty that holds."""

import numpy as np
import pytest

from app.metrology.common_slope import fit_common_slope


def test_levels_of_groups_do_not_look_like_a_slope() -> None:
    groups = np.repeat(np.arange(4), 5)
    hours = np.tile(np.linspace(0, 100, 5), 4) + 10.0 * groups
    values = 50.0 * groups + 0.02 * hours
    found = fit_common_slope(hours, values, groups)
    assert found is not None
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
        assert constant is not None
        covered += abs(aged.value - 0.01) <= aged.expanded_uncertainty
        by_chance += constant.is_significant
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
