"""An overexposed laser line, placed by its two flanks.

Where the line's core is clipped, only its flanks tell where it lies. Their common shape is
taken from the picture itself: at the distance d from the line's middle the signal is
``exp(b - slope d - bend d^2)``, with a brightness b of each column's own and a slope and a
bend that all columns share (a Gaussian beam is all bend, light scattered in paper all slope).
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import nnls

from app.metrology import stripe_flank_kernels as kernels
from app.metrology.frames import Floats

Image = NDArray[np.uint8] | NDArray[np.uint16]

# Pixels looked at beside the core on each side; those further out show the background.
FLANK, OUTERMOST = 11, 24
# Pixels beside the core that the image must hold.
NEAREST = 4
# The least height of clipping over the background, as a share of the clipping level.
LEAST_TOP = 0.2
# The shared shape needs this many columns.
FEWEST_COLUMNS = 40
# Rounds at most; those that find the shape; from which on the noise is told.
ROUNDS, SHAPE_ROUNDS, NOISE_ROUND = 12, 6, 4
SETTLED_PX = 1e-3
# The middle of the flanks lies near the middle of the core, in shares of the core's width.
MOST_SHIFT = 0.3
# Backgrounds on both sides that differ by more than this factor tell two brightnesses of
# the surface: the flank on the brighter one reaches further.
UNEVEN = 1.5
# The redundancy that a step of the noise needs, in all and per pixel; the gain it begins
# with, in shares of the clipping level.
LEAST_FREE, LEAST_SHARE, FIRST_GAIN = 5.0, 0.15, 0.1 / 255
# The variance of a median of many values, in shares of their mean's.
MEDIAN = 1.57
# A fit's chi squared that is no chance, in its standard deviations.
UNLIKELY = 5.0
# A window that scatters so many times as much as usual holds a step or a bend.
UNSTRAIGHT = 9.0


@dataclass(frozen=True)
class Cores:
    """The clipped core of the line in n columns: its first and its last pixel."""

    columns: NDArray[np.int64]
    first: NDArray[np.int64]
    last: NDArray[np.int64]
    track: NDArray[np.int64]  # cores of one number follow one another

    @property
    def width(self) -> float:
        """The usual width of a core in px."""
        return float(np.median(self.last - self.first + 1))

    def chosen(self, kept: NDArray[np.bool_]) -> "Cores":
        return Cores(self.columns[kept], self.first[kept], self.last[kept], self.track[kept])

    def beside(self, width: int) -> NDArray[np.bool_]:
        """The columns of an image (width,) that hold no core."""
        beside = np.ones(width, dtype=np.bool_)
        beside[self.columns] = False
        return beside


@dataclass(frozen=True)
class FlankFits:
    """The middle of both flanks in n columns.

    ``variance`` is by the pixels' noise, ``uneven`` what two brightnesses of the surface
    on both sides may shift the middle by, squared: no averaging takes that away.
    """

    columns: NDArray[np.int64]
    centre: Floats
    variance: Floats
    uneven: Floats

    def chosen(self, kept: NDArray[np.int64]) -> "FlankFits":
        return FlankFits(
            self.columns[kept], self.centre[kept], self.variance[kept], self.uneven[kept]
        )


def clipped_cores(image: Image, saturated: float) -> Cores:
    """The clipped runs of pixels that follow one another from column to column.

    Of several in a column, the one of the longest track counts.
    """
    none = np.zeros(0, dtype=np.int64)
    if image.size == 0 or image.max() < saturated:
        return Cores(none, none, none, none)
    width = image.shape[1]
    first = np.full((width, kernels.RUNS), -1, dtype=np.int64)
    last, track = first.copy(), first.copy()
    kernels.clipped_runs(image, saturated, first, last)
    kernels.link(first, last, track)
    counts = np.append(np.bincount(track[track >= 0].ravel(), minlength=1), 0)
    best = np.argmax(counts[track], axis=1)  # track -1 looks up the appended zero
    columns = np.flatnonzero(first[np.arange(width), best] >= 0)
    best = best[columns]
    return Cores(columns, first[columns, best], last[columns, best], track[columns, best])


def fit_flanks(image: Image, cores: Cores, saturated: float, read: float) -> FlankFits:
    """Fits all columns together; those whose flanks do not fit are left out.

    Args:
        image: (H, W) with the line across its columns.
        cores: the clipped cores that belong to the line.
        saturated: the grey level from which a pixel is clipped.
        read: variance of a dark pixel in grey levels squared, to begin with.
    """
    height = image.shape[0]
    whole = (cores.first - NEAREST >= 0) & (cores.last + NEAREST < height)
    cores = cores.chosen(whole)
    places, signal, top, background = _signals(image, cores, saturated)
    lit = top.min(axis=1) > LEAST_TOP * saturated
    places, signal, top, background = (a[lit] for a in (places, signal, top, background))
    cores = cores.chosen(lit)
    if len(cores.columns) < FEWEST_COLUMNS:
        return FlankFits(np.zeros(0, dtype=np.int64), *np.zeros((3, 0)))
    middle = (cores.first + cores.last) / 2
    half = (cores.last - cores.first + 1) / 2
    fit = _Fit(places, signal, top, middle.copy(), half, read, FIRST_GAIN * saturated)
    for i in range(ROUNDS):
        shift = fit.round(with_shape=i < SHAPE_ROUNDS, with_noise=i >= NOISE_ROUND)
        if i >= SHAPE_ROUNDS and float(np.median(shift)) < SETTLED_PX:
            break
    variance, uneven = fit.variance(), _uneven_variance(background, fit.decay)
    kept = np.isfinite(variance) & (
        np.abs(fit.centre - middle) < np.maximum(MOST_SHIFT * 2 * half, 1)
    )
    return FlankFits(cores.columns[kept], fit.centre[kept], variance[kept], uneven[kept])


def averaged(fits: FlankFits, width_px: float) -> FlankFits:
    """The line smoothed along itself over its own core's width.

    Light from so broad a spot shows nothing finer. A line, bent as its neighbourhood is,
    is fitted to the points about each one; where they do not fit, the point stays as it is.
    """
    reach = int(width_px / 2)
    start = int(fits.columns[0]) - reach
    span = int(fits.columns[-1]) + reach + 1 - start
    y, w = np.zeros(span), np.zeros(span)
    at = fits.columns - start
    level = float(np.mean(fits.centre))
    y[at], w[at] = fits.centre - level, 1 / (fits.variance + fits.uneven)
    t = np.arange(-reach, reach + 1, dtype=np.float64)
    # correlation, so the kernel is turned round
    sums = [np.convolve(w, (t**k)[::-1], "same")[at] for k in range(4)]
    first = [np.convolve(w * y, (t**k)[::-1], "same")[at] for k in range(2)]
    square = np.convolve(w * y**2, np.ones(len(t)), "same")[at]
    count = np.convolve(w > 0, np.ones(len(t)), "same")[at]
    det = sums[0] * sums[2] - sums[1] ** 2
    with np.errstate(divide="ignore", invalid="ignore"):
        here = (sums[2] * first[0] - sums[1] * first[1]) / det
        slope = (sums[0] * first[1] - sums[1] * first[0]) / det
        misfit = (square - here * first[0] - slope * first[1]) / (count - 2)
        variance = sums[2] / det
        by_bend = 0.5 * (sums[2] ** 2 - sums[1] * sums[3]) / det
    straight = (count > reach) & (misfit < UNSTRAIGHT * float(np.nanmedian(misfit)))
    bend = _bend(fits.columns, np.where(straight, here, np.nan), len(t))
    share = np.abs(by_bend) / len(t) ** 2  # the bend is told by means that this one is of
    return FlankFits(
        fits.columns,
        np.where(straight, here - by_bend * bend + level, fits.centre),
        np.where(straight, variance * (1 + 4 * share + 6 * share**2), fits.variance),
        fits.uneven,
    )


def _bend(columns: NDArray[np.int64], mean: Floats, span: int) -> Floats:
    """(n,) second derivative of the line, by its means that lie ``span`` columns apart.

    A step or a gap (a mean of NaN) between them bends nothing; there, and where the line
    begins and ends, the nearest known bend counts.
    """
    whole = np.full(int(columns[-1] - columns[0]) + 1 + 2 * span, np.nan)
    at = columns - columns[0] + span
    whole[at] = mean
    broken = np.concatenate([[0], np.cumsum(np.isnan(whole))])
    known = np.flatnonzero(broken[at + span + 1] == broken[at - span])
    if len(known) == 0:
        return np.zeros(len(columns))
    at = at[known]
    bend = (whole[at - span] - 2 * whole[at] + whole[at + span]) / span**2
    return np.asarray(np.interp(columns, columns[known], bend))


def _signals(image: Image, cores: Cores, saturated: float) -> tuple[Floats, Floats, Floats, Floats]:
    """Pixels beside the cores: places and signals (n, 2 FLANK), clipping heights, backgrounds.

    Clipped pixels and those beyond the image have a signal of NaN; heights and
    backgrounds (n, 2) are by side.
    """
    out = np.arange(1, FLANK + 1)
    far = np.arange(FLANK + 1, OUTERMOST + 1)
    rows = np.concatenate([cores.first[:, None] - out, cores.last[:, None] + out], axis=1)
    away = np.concatenate([cores.first[:, None] - far, cores.last[:, None] + far], axis=1)
    border = image.shape[0] - 1  # beyond it, its own pixel is the best guess
    levels = image[np.clip(rows, 0, border), cores.columns[:, None]].astype(np.float64)
    beyond = image[np.clip(away, 0, border), cores.columns[:, None]].astype(np.float64)
    background = np.median(beyond.reshape(len(rows), 2, OUTERMOST - FLANK), axis=2)
    floor = np.repeat(background, FLANK, axis=1)
    held = (rows >= 0) & (rows < image.shape[0])
    signal = np.where(held & (levels < saturated), levels - floor, np.nan)
    return rows.astype(np.float64), signal, saturated - background, background


def _uneven_variance(background: Floats, decay_px: float) -> Floats:
    """(n,) what two brightnesses of the surface may shift the middle by, squared.

    A side twice as bright carries its flank ``decay ln 2`` further out.
    """
    low, high = np.sort(np.maximum(background, 1.0), axis=1).T
    shift = 0.5 * decay_px * np.log(high / low)
    return np.asarray(np.where(high > UNEVEN * low, shift**2, 0.0))


class _Fit:
    """Middle and brightness of every column, and the shape that all share."""

    def __init__(
        self,
        places: Floats,
        signal: Floats,
        top: Floats,
        centre: Floats,
        half: Floats,
        read: float,
        gain: float,
    ) -> None:
        self._places, self._top, self._signal = places, top, signal
        self._usual = float(np.median(half))  # distances count from the usual core's edge
        self.centre = centre
        self.shape = self._first_shape()
        self.log_height = np.log(top[:, 0]) + self.shape[0] * (half - self._usual)
        self._read, self._gain = read, gain
        self._first = np.array([read, gain])
        self._fits = np.zeros((len(centre), 4))

    @property
    def decay(self) -> float:
        """Distance over which the signal at the core's edge falls by e."""
        return float(1 / max(self.shape[0], 0.02))

    def round(self, with_shape: bool, with_noise: bool) -> Floats:
        """One Gauss-Newton step; returns how far the middles moved (n,)."""
        N, g, moments = np.zeros((2, 2)), np.zeros(2), np.zeros((kernels.NOISE_STEPS, 4))
        noise = np.array([self._read, self._gain, MEDIAN * self._read / (OUTERMOST - FLANK)])
        kernels.flank_round(
            self._places,
            self._signal,
            self._top,
            self._usual,
            self.shape,
            noise,
            self.centre,
            self.log_height,
            self._fits,
            N,
            g,
            moments,
        )
        if with_shape:
            self._reshape(N, g)
        if with_noise:
            self._learn_noise(moments)
        return np.asarray(self._fits[:, kernels.MOVE])

    def variance(self) -> Floats:
        """(n,) of the middles; NaN where a column cannot be fitted."""
        misfit, count = self._fits[:, kernels.MISFIT], self._fits[:, kernels.COUNT]
        free = np.maximum(count - 2, 1)
        worse = np.where(misfit > 1 + UNLIKELY * np.sqrt(2 / free), misfit, 1.0)
        return np.asarray(self._fits[:, kernels.VARIANCE] * worse)

    def _first_shape(self) -> Floats:
        """From how the usual signal falls between the first pixels beside the cores."""
        usual = np.nanmedian(self._signal[:, [0, FLANK, 2, FLANK + 2]].reshape(-1, 2, 2), (0, 2))
        fall = np.log(max(usual[0], 1.0) / max(usual[1], 1.0)) / 2
        return np.array([float(np.clip(fall, 0.1, 2.0)), 0.0])

    def _reshape(self, N: Floats, g: Floats) -> None:
        """One step of the shared shape."""
        step = np.linalg.lstsq(N, g, rcond=1e-9)[0]
        largest = float(np.max(np.abs(step) / (0.3 * self.shape[0] + np.array([0.0, 0.05]))))
        self.shape = self.shape + step / max(largest, 1.0)

    def _learn_noise(self, moments: Floats) -> None:
        """Read noise and gain from what is left of the pixels, by the height of the signal.

        Each is divided by its redundancy, the share of its error that the fit leaves
        (Foerstner's estimate), so that pixels which the fit follows seem no better. A
        line through the steps, and not each on its own: steps whose pixels the fit follows
        closely would take up all weight. What no step tells stays near what it was first.
        """
        free, pixels = moments[:, kernels.FREE], moments[:, kernels.PIXELS]
        known = moments[(free > LEAST_FREE) & (free > LEAST_SHARE * pixels)]
        signal = known[:, kernels.SIGNALS] / known[:, kernels.PIXELS]
        found = known[:, kernels.SQUARES] / known[:, kernels.FREE]
        # a variance is known to a share of itself; the first guess to its own size
        weight = np.sqrt(known[:, kernels.FREE]) / (self._read + self._gain * signal)
        terms = np.column_stack([weight, weight * signal])
        rows = np.vstack([terms, np.diag(1 / self._first)])
        read, gain = nnls(rows, np.concatenate([weight * found, [1.0, 1.0]]))[0]
        self._read, self._gain = max(float(read), 1 / 12), float(gain)
