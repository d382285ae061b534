"""Standard deviations estimated from the data: variance components.

A sum of squares is compared with its degrees of freedom: the number of values that the data
determined, and not the scale itself (Foerstner's estimate, iterated).
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from crenel.metrology.adjustment.core.arm_errors import LEVER_MM
from crenel.metrology.transforms import Floats

# Usual values if nothing is known; they count like one observation, so that the estimate converges.
# Links: as those of an arm whose tip is off by some 20 µm rms; the rotation of a link moves the
# next one about as far as its translation does.
USUAL_LINKS_MM, USUAL_CONTACT_MM = 0.003, 0.003
USUAL_LINKS_RAD = USUAL_LINKS_MM / LEVER_MM
USUAL_COUNT = 1.0
# The prior of links counts a little more, and the ratio of rotations to translations more still:
# the likelihood alone can diverge along either.
USUAL_LINKS_COUNT, TOGETHER_COUNT = 2.0, 3.0
CONVERGED = 0.01
MOST_ROUNDS = 15


@dataclass(frozen=True)
class Scales:
    """The noise level of each kind of observation.

    ``links_rad``, ``links_mm``: rotation and translation of one link's error; ``noise``: factor on
    the noise of each reading; ``touch_mm``: noise of one touch, in addition.
    """

    links_rad: float
    links_mm: float
    noise: float
    touch_mm: float

    def link_error_sds(self, count: int) -> Floats:
        """(6 count,) standard deviations of the errors of ``count`` links."""
        return np.tile(np.repeat([self.links_rad, self.links_mm], 3), count)


def default_scales(noise_factor: float) -> Scales:
    return Scales(USUAL_LINKS_RAD, USUAL_LINKS_MM, noise_factor, USUAL_CONTACT_MM)


def estimate_noise_factor(values: Floats, variances: Floats, scale: float, usual: float) -> float:
    """The scale of values (N,) with the variances ``variances`` (N,) under the assumed
    ``scale``."""
    if not len(values):
        return scale
    determined = max(float(len(values) - np.sum(variances) / scale**2), 0.0)
    squares = float(values @ values) + USUAL_COUNT * usual**2
    return float(np.sqrt(squares / (determined + USUAL_COUNT)))


def estimate_link_errors(links: Floats, variances: Floats, scales: Scales) -> tuple[float, float]:
    """The scales of rotations (rad) and translations (mm), from the errors (6n,) of all links.

    An arm with large errors of one kind is assumed to have large errors of the other kind if no
    data show it: the prior of each follows from both, in their usual proportion.
    """
    usual = np.array([USUAL_LINKS_RAD, USUAL_LINKS_MM])
    now = np.array([scales.links_rad, scales.links_mm])
    squares = (links**2).reshape(-1, 2, 3).sum(axis=(0, 2))
    unknown = variances.reshape(-1, 2, 3).sum(axis=(0, 2))
    determined = np.maximum(len(links) / 2 - unknown / now**2, 0.0)
    count = USUAL_LINKS_COUNT
    common = (np.sum(squares / usual**2) + count) / (np.sum(determined) + count)
    estimated = (squares + TOGETHER_COUNT * common * usual**2) / (determined + TOGETHER_COUNT)
    rad, mm = np.sqrt(estimated)
    return float(rad), float(mm)


def size_prior(scales: Scales) -> float:
    """Logarithm of the prior density of the sizes (of their logarithms) of link errors, up to a
    constant; the counts are as in ``estimate_link_errors``."""
    turns = np.log(scales.links_rad / USUAL_LINKS_RAD)
    shifts = np.log(scales.links_mm / USUAL_LINKS_MM)
    common = (turns + shifts) / 2
    usual = -USUAL_LINKS_COUNT * (common + np.exp(-2 * common) / 2)
    return float(usual - TOGETHER_COUNT * np.log(np.cosh(turns - shifts)))


def estimate_contact_sd(
    residuals_mm: Floats, noise_mm2: Floats, fitted_mm2: Floats, scales: Scales
) -> float:
    """The noise of one touch, from contact residuals (N,) after the fit.

    Each residual counts with the part that the encoder variance ``noise_mm2`` (N,) does not
    explain; ``fitted_mm2`` (N,) is the variance of the fit itself at the contact points.
    """
    variance = scales.touch_mm**2 + noise_mm2
    weight = scales.touch_mm**2 / variance
    squares = float(np.sum((weight * residuals_mm) ** 2)) + USUAL_COUNT * USUAL_CONTACT_MM**2
    determined = float(np.sum(weight * np.maximum(1 - fitted_mm2 / variance, 0.0)))
    return float(np.sqrt(squares / (determined + USUAL_COUNT)))


def iterate_scales(scales: Scales, estimate: Callable[[Scales], Scales]) -> Scales:
    """The scales at which ``estimate`` no longer changes them, or nearly so."""
    for _ in range(MOST_ROUNDS):
        before, scales = scales, estimate(scales)
        if largest_change(before, scales) < CONVERGED:
            break
    return scales


def largest_change(a: Scales, b: Scales) -> float:
    """Largest relative change of any scale."""
    pairs = (
        (a.links_rad, b.links_rad),
        (a.links_mm, b.links_mm),
        (a.noise, b.noise),
        (a.touch_mm, b.touch_mm),
    )
    return max(abs(float(np.log(x / y))) for x, y in pairs)
