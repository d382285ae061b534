"""By how much the delay varies about its course: from stretch to stretch, and from frame to frame.

The stamps of an arm whose packets wait on their way, or arrive several at once, are late by times
that vary. A course of constant pieces or of one rate does not describe this.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.time_delay.course import PPM
from crenel.metrology.time_delay.delay_fit import DelayEstimate, count_reversals, scores_spread
from crenel.metrology.transforms import Floats

LEAST_STRETCHES, MOST_STRETCHES = 5, 30
REVERSALS = 2
"""Minimum of a stretch, so that errors of plane and calibration do not pass for its delay."""
SIGNIFICANT_STRETCHES, SIGNIFICANT_FRAMES = 3.0, 3.5
"""A variation counts from this multiple of the standard deviation that chance gives it."""
HEIGHT_DEGREE = 8
"""The degree of the polynomial in the height that takes errors of the calibration from the
distances."""


@dataclass(frozen=True)
class Unsteadiness:
    """Standard deviations of the delay about its course; 0 where chance explains what is seen."""

    stretch_ns: float = 0.0
    frame_ns: float = 0.0

    @property
    def uncertainty_ns(self) -> float:
        """What the variation adds to the uncertainty (k = 1) of the delay at one moment.

        Of lateness with any distribution, mean and median are at most one standard deviation apart,
        and the estimate lies between them: a rectangular distribution of this half width.
        """
        return max(self.stretch_ns, self.frame_ns / math.sqrt(3.0))

    def uncertainties(self, fit: DelayEstimate, seconds: float) -> Floats:
        """(m,) of the values of a course (k = 1), with the variation.

        A jump is the difference of two moments; the drift may be, at worst, that of a variation
        that is as slow as the pass.
        """
        terms = np.full(len(fit.values), np.sqrt(2.0) * self.uncertainty_ns)
        terms[0] = self.uncertainty_ns
        if fit.shape.drifts:
            terms[1] = np.sqrt(12.0) * self.uncertainty_ns / max(1e9 * seconds, 1.0) / PPM
        return np.asarray(np.hypot(fit.uncertainties, terms))


def estimate_unsteadiness(fit: DelayEstimate) -> Unsteadiness:
    """The variation of the delay about a fitted course."""
    turns = count_reversals(fit.across_mm_s)
    stretches = min(MOST_STRETCHES, turns // REVERSALS)
    if stretches < LEAST_STRETCHES or not np.isfinite(fit.covariance).all():
        return Unsteadiness()
    frames = len(fit.across_mm_s)
    root = np.sqrt(fit.weight)
    slope, off = root * fit.rows.slope_mm_s * 1e-9, root * fit.rows.off_mm
    cumulated = np.cumsum((slope**2)[:frames] + (slope**2)[frames:])
    stretch = np.minimum((cumulated / cumulated[-1] * stretches).astype(np.int64), stretches - 1)
    return Unsteadiness(
        _between_stretches_ns(fit, root, slope, off, stretch), _between_frames_ns(fit, stretch)
    )


def _between_stretches_ns(
    fit: DelayEstimate, root: Floats, slope: Floats, off: Floats, stretch: NDArray[np.int64]
) -> float:
    """What a delay of its own for each stretch explains of the residuals, beyond chance.

    Chance is what the errors that adjacent frames share make of the delay of the whole pass.
    """
    m, count = len(fit.values), int(stretch.max()) + 1
    J = root[:, None] * fit.rows.J
    Q, Q_plane = np.linalg.qr(J)[0], np.linalg.qr(J[:, m:])[0]
    off = off - Q @ (Q.T @ off)
    own = slope[:, None] * (np.concatenate([stretch, stretch])[:, None] == np.arange(count))
    own -= Q @ (Q.T @ own)
    N, g = own.T @ own, own.T @ off
    explained = float(g @ np.linalg.lstsq(N, g, rcond=1e-9)[0])
    alone = slope - Q_plane @ (Q_plane.T @ slope)
    shared = scores_spread((alone * off)[:, None], fit.across_mm_s)[0, 0] / float(alone @ alone)
    chance = max(float(shared), 1.0)
    free = count - m
    if free < 1 or explained / chance - free < SIGNIFICANT_STRETCHES * np.sqrt(2.0 * free):
        return 0.0
    return float(np.sqrt((explained - chance * free) / np.trace(N)))


def _between_frames_ns(fit: DelayEstimate, stretch: NDArray[np.int64]) -> float:
    """What of the squared distances grows with the squared velocity.

    Errors of calibration and arm do not. Its significance is the scatter between the stretches.
    """
    frames = len(stretch)
    height = fit.rows.J[:frames, -2]
    powers = np.vander(height / max(float(np.abs(height).max()), 1e-9), HEIGHT_DEGREE + 1)
    off = fit.rows.off_mm[:frames]
    square = (off - powers @ np.linalg.lstsq(powers, off, rcond=None)[0]) ** 2
    velocity = np.convolve(np.pad(fit.across_mm_s, 1, mode="edge"), np.ones(3) / 3, "valid")
    A = np.column_stack([1e-18 * velocity**2, powers[:, -3:]])
    size = np.linalg.norm(A, axis=0)
    A /= size
    inverse = np.linalg.pinv(A.T @ A)
    values = inverse @ (A.T @ square)
    score = np.zeros((int(stretch.max()) + 1, A.shape[1]))
    np.add.at(score, stretch, A * (square - A @ values)[:, None])
    deviation = float(np.sqrt((inverse @ (score.T @ score) @ inverse)[0, 0]))
    if not values[0] > SIGNIFICANT_FRAMES * deviation:
        return 0.0
    return float(np.sqrt(values[0] / size[0]))
