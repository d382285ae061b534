"""The check of claimed against observed uncertainty: a wrong claim fails it."""

import numpy as np
import pytest

from tests.uncertainty_ratio import (
    EXACT,
    ratio_of_deviations,
    ratio_of_pulls,
    ratio_of_rms,
    rows_of,
)


def pulls(count: int) -> np.ndarray:
    return np.random.default_rng(0).normal(size=count)


@pytest.mark.parametrize("wrong", [0.8, 1.25])
def test_a_wrong_claim_fails_with_the_ratios_standard_error(wrong: float) -> None:
    many = pulls(2000)
    ratio_of_pulls(many).assert_within(*EXACT)
    with pytest.raises(AssertionError, match=r"± 0\.0[12]\d \(its standard error\)"):
        ratio_of_pulls(many / wrong).assert_within()
    with pytest.raises(AssertionError, match=r"expected 1 to 1\.07, with 3 standard errors 0\.9"):
        ratio_of_deviations(np.full(2000, wrong), many).assert_within()


def test_the_standard_error_is_that_of_the_sample() -> None:
    assert ratio_of_rms(1.1, 1.0, 200).error == pytest.approx(1.1 / 20)
    assert ratio_of_pulls(pulls(200)).error == pytest.approx(1 / 20, rel=0.1)
    deviations = ratio_of_deviations(np.ones(2000), pulls(2000))
    assert deviations.error == pytest.approx(1 / np.sqrt(4000), rel=0.1)


def test_neighbours_that_err_together_count_as_one() -> None:
    alike = np.repeat(pulls(200), 10)
    ratio = ratio_of_pulls(rows_of(alike, 10))
    assert ratio.error == pytest.approx(1 / 20, rel=0.15)
    assert ratio.error > 2.5 * ratio_of_pulls(alike).error
    assert rows_of(alike[:25], 10).shape == (2, 10)
