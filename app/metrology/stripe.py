"""The laser stripe in an image: its centre below a pixel, and how far to trust it."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.metrology import stripe_kernels as kernels
from app.metrology.frames import Floats
from app.metrology.refusal import Refusal
from app.metrology.stripe_flanks import (
    FEWEST_COLUMNS,
    Cores,
    FlankFits,
    Image,
    averaged,
    clipped_cores,
    fit_flanks,
)

# A peak stands out of the noise by this many standard deviations of its score; what
# noise passes makes no run.
STANDS_OUT = 4.0
# A point belongs to a run of at least this many neighbouring points.
SHORTEST_RUN = 6
LARGEST_GAP = 3
# Rows by which the stripe may climb from one column to the next.
STEEPEST = 4.0
# Widths, in shares of the image's typical one, and misfit beyond which a peak is no stripe.
WIDTHS = (0.45, 2.2)
# Columns between which laser speckle has become independent.
SPECKLE_LAG = 6
# Where most of the line is clipped, points dimmer than this share of it are none of it.
DIM = 0.25
# Share of its columns in which a piece of the line must be clipped, and its least length
# in widths of its core.
DENSE, LONG = 0.7, 4
# Columns within which a clipped piece goes on where the rest of the line ends.
JOINING = 8


@dataclass(frozen=True)
class Stripe:
    """Points of the laser stripe, at most one a column (axis u) or a row (axis v).

    ``intensity`` is the height of the stripe over its background in grey levels,
    ``sigma_px`` the standard deviation of the point across the stripe's direction
    of counting: of v for axis u, of u for axis v.
    """

    u: Floats  # (N,)
    v: Floats  # (N,)
    intensity: Floats  # (N,)
    sigma_px: Floats  # (N,)
    axis: str = "u"

    @property
    def uv_px(self) -> Floats:
        """(N, 2)"""
        return np.column_stack([self.u, self.v])

    @property
    def across(self) -> Floats:
        """(2,) the unit pixel direction in which ``sigma_px`` counts."""
        return np.array([0.0, 1.0]) if self.axis == "u" else np.array([1.0, 0.0])


@dataclass(frozen=True)
class Noise:
    """Variance of a pixel at signal s: ``read + gain s + contrast s^2``, in grey levels squared.

    The three terms are read noise, shot noise and what scales with the signal
    (speckle, fixed pattern).
    """

    read: float
    gain: float
    contrast: float

    @property
    def terms(self) -> Floats:
        return np.array([self.read, self.gain, self.contrast])


def extract_stripe(image: Image, axis: str = "u", where: NDArray[np.bool_] | None = None) -> Stripe:
    """One point per column (axis ``u``) or row (axis ``v``) where the stripe crosses it.

    A Gaussian on a constant background is fitted to each peak, weighted by the
    pixels' noise, which is estimated from the image itself; clipped pixels are left
    out. Where a broad core is clipped, the line is placed by its two flanks and smoothed
    along itself over the core's width (``stripe_flanks``).

    Args:
        image: (H, W) of uint8 or uint16 (9 to 16 significant bits).
        axis: the image axis along which points are counted.
        where: (H, W) pixels in which the stripe may lie; None: anywhere.

    Returns:
        The points in ascending order; none where the image holds no stripe.

    Raises:
        Refusal: not a grey image of whole numbers, or an unknown axis.
    """
    grey = _as_grey(image, axis)
    if min(grey.shape) <= 2 * kernels.SURROUND:
        return _empty(axis)
    saturated = saturation_level(grey)
    allowed = np.zeros((0, 0), dtype=np.bool_) if where is None else _as_seen(where, grey, axis)
    cores = clipped_cores(grey, saturated)
    if where is not None:
        cores = cores.chosen(allowed[(cores.first + cores.last) // 2, cores.columns])
    level, peak = np.empty(grey.shape[1]), np.empty(grey.shape[1], dtype=np.int64)
    kernels.peak_rows(grey, allowed, level, peak)
    beside = np.ones(grey.shape[1], dtype=np.bool_)
    beside[cores.columns] = False
    peaks = _peaks(grey, level, peak, beside, saturated)
    ours = _of_the_line(cores, peaks)
    if not ours.all():
        cores = cores.chosen(ours)
        beside[:] = True
        beside[cores.columns] = False
        peaks = _peaks(grey, level, peak, beside, saturated)
    return _joined(
        peaks, fit_flanks(grey, cores, saturated, _read_noise(grey)), cores, axis, saturated
    )


def together(parts: Sequence[Stripe]) -> Stripe:
    """The points of stripes that were counted along the same axis, one after the other."""
    return Stripe(
        np.concatenate([part.u for part in parts]),
        np.concatenate([part.v for part in parts]),
        np.concatenate([part.intensity for part in parts]),
        np.concatenate([part.sigma_px for part in parts]),
        parts[0].axis,
    )


def saturation_level(image: Image) -> float:
    """The grey level at which this image's pixels are clipped.

    255 for 8 bits; for 16-bit images the sensor's own depth where the brightest
    pixel shows it (1023, 4095, ..., also shifted to the upper bits), else 65535.
    """
    if image.dtype == np.uint8:
        return 255.0
    top = int(image.max())
    if top:
        significant = top >> ((top & -top).bit_length() - 1)
        if significant & (significant + 1) == 0 and 9 <= significant.bit_length() <= 16:
            return float(top)
    return 65535.0


def _as_grey(image: Image, axis: str) -> Image:
    """The image with the stripe across its columns, rows contiguous in memory."""
    array = np.asarray(image)
    if array.ndim != 2 or array.dtype not in (np.uint8, np.uint16):
        raise Refusal(
            "image-not-grey",
            f"an image of shape {array.shape} and type {array.dtype}",
            "a stripe is extracted from grey images of 8 to 16 bits, height by width",
        )
    if axis not in ("u", "v"):
        raise Refusal("axis-unknown", f'stripe axis "{axis}"', 'it is "u" or "v"')
    return np.ascontiguousarray(array if axis == "u" else array.T)


def _as_seen(where: NDArray[np.bool_], grey: Image, axis: str) -> NDArray[np.bool_]:
    """The mask turned as the image was."""
    turned = np.ascontiguousarray(where if axis == "u" else where.T)
    if turned.shape != grey.shape:
        raise Refusal("mask-size", f"a mask of shape {where.shape} for an image of another shape")
    return turned


def _read_noise(image: Image) -> float:
    """Variance of a dark pixel in grey levels squared, from differences of neighbours.

    Most of an image is unlit, so the bulk of the differences is noise; what exceeds
    three times their median is scene and is cut off. Rounding adds 1/12 at least.
    """
    counts = np.zeros(4096, dtype=np.int64)
    kernels.neighbour_differences(image, max(image.shape[0] // 128, 1), counts)
    cumulative = np.cumsum(counts)
    median = int(np.searchsorted(cumulative, cumulative[-1] / 2))
    kept = counts[: 4 * median + 3]
    variance = float(np.sum(kept * np.arange(len(kept)) ** 2.0) / max(kept.sum(), 1)) / 2
    return max(variance, 1 / 12)


def _noise_of(
    image: Image, columns: NDArray[np.int64], fits: Floats, saturated: float, read: float
) -> Noise:
    """The noise model that the residuals of a first round of fits show."""
    bins = 32
    sums, squares = np.zeros(bins), np.zeros(bins)
    counts = np.zeros(bins, dtype=np.int64)
    kernels.residual_moments(image, columns, fits, saturated, sums, squares, counts)
    filled = counts > 20
    if filled.sum() < 3:
        return Noise(read, 0.01 * saturated / 255, 0.0)
    signal = sums[filled] / counts[filled]
    excess = np.maximum(squares[filled] / counts[filled] - read, 0.0)
    # each bin's variance is known to a share of itself, so weigh by 1 / variance
    weight = np.sqrt(counts[filled]) / (excess + read)
    terms = np.column_stack([signal, signal**2])
    gain, contrast = _non_negative(terms * weight[:, None], excess * weight)
    return Noise(read, gain, contrast)


def _non_negative(terms: Floats, values: Floats) -> tuple[float, float]:
    """Least squares of two terms, neither below zero."""
    both = np.linalg.lstsq(terms, values)[0]
    if both.min() >= 0:
        return float(both[0]), float(both[1])
    alone = np.maximum(np.sum(terms * values[:, None], axis=0) / np.sum(terms**2, axis=0), 0.0)
    left = [float(np.sum((values - terms[:, i] * alone[i]) ** 2)) for i in range(2)]
    return (float(alone[0]), 0.0) if left[0] < left[1] else (0.0, float(alone[1]))


@dataclass(frozen=True)
class _Peaks:
    """The fitted peaks by their column."""

    along: Floats
    across: Floats
    amplitude: Floats
    variance: Floats

    def chosen(self, kept: NDArray[np.bool_]) -> "_Peaks":
        return _Peaks(
            self.along[kept], self.across[kept], self.amplitude[kept], self.variance[kept]
        )


def _peaks(
    grey: Image,
    level: Floats,
    peak: NDArray[np.int64],
    sought: NDArray[np.bool_],
    saturated: float,
) -> _Peaks:
    """The peaks of the columns sought (W,) that look like a stripe: of its width, in runs."""
    read = _read_noise(grey)
    # the score's variance: 4 of 5 core pixels' mean and a mean of 3
    threshold = STANDS_OUT * np.sqrt(read * (1 / 4 + 1 / 3))
    columns = np.flatnonzero(sought & (level > threshold) & (peak >= 0))
    fits = np.empty((len(columns), 7))
    guess = Noise(read, 0.01 * saturated / 255, 0.0)
    kernels.fit_columns(grey, columns, peak[columns], guess.terms, saturated, fits)
    noise = _noise_of(grey, columns, fits, saturated, read)
    kernels.fit_columns(grey, columns, peak[columns], noise.terms, saturated, fits)
    fitted = np.isfinite(fits[:, kernels.CENTRE])
    along, fits = columns[fitted].astype(np.float64), fits[fitted]
    widths = fits[:, kernels.SIGMA]
    typical = float(np.median(widths)) if len(widths) else 0.0
    good = (widths > WIDTHS[0] * typical) & (widths < WIDTHS[1] * typical) & (widths > 0.5)
    along, fits = along[good], fits[good]
    misfit = fits[:, kernels.CHI2] / np.maximum(fits[:, kernels.PIXELS] - 4, 1)
    variance = fits[:, kernels.VARIANCE] * np.where(misfit > 3, misfit, 1.0)
    return _Peaks(along, fits[:, kernels.CENTRE], fits[:, kernels.AMPLITUDE], variance)


def _of_the_line(cores: Cores, peaks: _Peaks) -> NDArray[np.bool_]:
    """Which clipped cores (n,) belong to the line, and not to a highlight beside it.

    A track does that is longer than all that is not clipped, or begins or ends where the
    unclipped line ends or begins; and that is several times as long as wide.
    """
    ours = np.zeros(len(cores.columns), dtype=np.bool_)
    if len(cores.columns) == 0:
        return ours
    widths = cores.last - cores.first + 1
    wide = (widths > WIDTHS[0] * cores.width) & (widths < WIDTHS[1] * cores.width)
    runs = in_runs(peaks.along, peaks.across)
    along, across = peaks.along[runs], peaks.across[runs]
    middle = (cores.first + cores.last) / 2
    for track in np.unique(cores.track):
        own = np.flatnonzero(cores.track == track)
        span = cores.columns[own[-1]] - cores.columns[own[0]] + 1
        if len(own) < max(DENSE * span, LONG * cores.width):
            continue  # hardly overexposed: the peak is told by what is beside the clipped pixels
        joins = len(own) >= len(along)
        for end in (own[0], own[-1]):
            gap = np.abs(along - cores.columns[end])
            near = (gap <= JOINING) & (np.abs(across - middle[end]) <= STEEPEST * gap)
            joins = joins or bool(near.any())
        ours[own] = joins
    ours &= wide
    return ours if ours.sum() >= FEWEST_COLUMNS else np.zeros_like(ours)


def _joined(peaks: _Peaks, flanks: FlankFits, cores: Cores, axis: str, saturated: float) -> Stripe:
    """Fitted peaks and flanks as one stripe, points in runs only, with their deviations."""
    if len(flanks.columns) > len(peaks.along):
        peaks = peaks.chosen(peaks.amplitude > DIM * saturated)
    columns = flanks.columns.astype(np.float64)
    along = np.concatenate([peaks.along, columns])
    across = np.concatenate([peaks.across, flanks.centre])
    order = np.argsort(along, kind="stable")
    kept = order[in_runs(along[order], across[order])]
    clipped = kept >= len(peaks.along)
    along, across = along[kept], across[kept]
    height, variance = np.full(len(kept), saturated), np.empty(len(kept))
    rest = kept[~clipped]
    height[~clipped] = np.minimum(peaks.amplitude[rest], saturated)
    known = peaks.variance[rest]
    scatter = _speckle_variance(peaks.along[rest], peaks.across[rest], known, SPECKLE_LAG)
    if clipped.any():
        line = averaged(flanks.chosen(kept[clipped] - len(peaks.along)), cores.width)
        unsure = line.variance + line.uneven
        # points that share no column are as far apart as the core is wide
        lag = int(cores.width) + 1
        rough = _speckle_variance(along[clipped], line.centre, unsure, lag, lag)
        across[clipped], variance[clipped] = line.centre, unsure + rough
        # a few points between clipped ones lie on the same rough surface
        scatter = max(scatter, rough)
    variance[~clipped] = known + scatter
    u, v = (along, across) if axis == "u" else (across, along)
    return Stripe(u, v, height, np.sqrt(variance), axis)


def in_runs(along: Floats, across: Floats) -> NDArray[np.bool_]:
    """Which points (N,) lie in a run of neighbours that is long enough."""
    if len(along) == 0:
        return np.zeros(0, dtype=np.bool_)
    gap = np.diff(along)
    breaks = (gap > LARGEST_GAP) | (np.abs(np.diff(across)) > STEEPEST * gap)
    run = np.concatenate([[0], np.cumsum(breaks)])
    return np.asarray(np.bincount(run)[run] >= SHORTEST_RUN)


def _speckle_variance(
    along: Floats, across: Floats, variance: Floats, lag: int, alike: int = 0
) -> float:
    """What the points scatter by beyond the pixels' noise, in px squared.

    Speckle shifts the light itself and is alike in neighbouring columns, so it shows
    only between points ``lag`` columns apart: the fourth difference over such lags
    of a smooth surface is noise alone. The median is robust to steps and
    texture. Where ``alike`` neighbours share their noise, few points are independent: what
    their median may exceed the known variance by in chance is none.
    """
    unbroken = along[4 * lag :] - along[: -4 * lag] == 4 * lag
    if unbroken.sum() < 30:
        return 0.0
    parts = [slice(i * lag, len(along) - (4 - i) * lag) for i in range(5)]
    factors = (1, -4, 6, -4, 1)
    pairs = list(zip(factors, parts, strict=True))
    squares = np.sum([f * across[p] for f, p in pairs], axis=0)[unbroken] ** 2
    known = np.sum([f**2 * variance[p] for f, p in pairs], axis=0)[unbroken]
    # the standard deviation of a median of squared deviates, in shares of itself
    chance = 2.33 * np.sqrt(alike / len(squares))
    if float(np.median(squares / known)) / 0.4549 - 1 < chance:
        return 0.0
    total = sum(f**2 for f in factors)
    speckle = 0.0
    for _ in range(30):
        # the median of a squared standard normal deviate is 0.4549
        surplus = float(np.median(squares / (known + total * speckle))) / 0.4549 - 1
        speckle = max(speckle + surplus * (float(np.median(known)) / total + speckle), 0.0)
    return speckle


def _empty(axis: str) -> Stripe:
    return Stripe(np.zeros(0), np.zeros(0), np.zeros(0), np.zeros(0), axis)
