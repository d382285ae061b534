"""The ratio of claimed to observed uncertainty, against what is claimed of it and its own scatter.

README.md claims a ratio between 1.00 and 1.07. A ratio of few observations scatters: a test allows
so many of its own standard errors beside the claim, and names them where it fails.
"""

from dataclasses import dataclass

import numpy as np

from crenel.metrology.transforms import Floats

LOWEST, HIGHEST = 1.0, 1.07
"""What README.md states of calibrations."""
EXACT = (1.0, 1.0)
"""Of a claim that follows from the noise by linear propagation."""


@dataclass(frozen=True)
class UncertaintyRatio:
    """Claimed over observed uncertainty, and the standard error of that by its sample."""

    value: float
    error: float

    def assert_within(self, lowest: float = LOWEST, highest: float = HIGHEST, k: float = 3) -> None:
        """Between what is expected, but for ``k`` standard errors."""
        share = k * self.error / self.value
        low, high = lowest * (1 - share), highest * (1 + share)
        assert low <= self.value <= high, (
            f"claimed / observed: {self.value:.3f} ± {self.error:.3f} (its standard error); "
            f"expected {lowest:g} to {highest:g}, with {k} standard errors {low:.3f} to {high:.3f}"
        )


def ratio_of_rms(claimed: float, observed: float, count: int) -> UncertaintyRatio:
    """By the rms of ``count`` independent deviations: 1/√(2 n) of the ratio."""
    value = claimed / observed
    return UncertaintyRatio(value, value / np.sqrt(2 * count))


def ratio_of_pulls(pulls: Floats) -> UncertaintyRatio:
    """By deviations over their claimed uncertainty, (N,) independent ones or (N, M) rows of M that
    err together, whose own scatter gives the standard error."""
    squares = np.mean(np.square(pulls).reshape(len(pulls), -1), axis=1)
    value = float(1 / np.sqrt(np.mean(squares)))
    if pulls.ndim == 1:
        return ratio_of_rms(value, 1.0, len(pulls))
    return UncertaintyRatio(value, value * _relative_error(squares))


def ratio_of_deviations(claimed: Floats, observed: Floats) -> UncertaintyRatio:
    """Of the rms of claimed uncertainties (N,) and of independent deviations (N,)."""
    squares = np.square(observed)
    value = float(np.sqrt(np.mean(np.square(claimed)) / np.mean(squares)))
    return UncertaintyRatio(value, value * _relative_error(squares))


def _relative_error(squares: Floats) -> float:
    """Standard error of the root of the mean of independent squares (N,), as a share of it."""
    return float(np.std(squares, ddof=1) / np.sqrt(len(squares)) / np.mean(squares) / 2)


def rows_of(pulls: Floats, length: int) -> Floats:
    """(N, M) rows of neighbours that err together, of pulls (K,) in order; the rest is left out."""
    count = len(pulls) // length
    return np.asarray(pulls)[: count * length].reshape(count, length)
