"""An overexposed laser line, placed by its two flanks.

Where the line's core is clipped, only its flanks tell where it lies. Their common shape is
taken from the picture itself: at the distance d from the line's middle the signal is
``exp(b - slope d - bend d^2)``, with a brightness b of each column's own and a slope and a
bend that all columns share (a Gaussian beam is all bend, light scattered in paper all slope).
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.metrology import stripe_flank_kernels as kernels
from app.metrology.frames import Floats

Image = NDArray[np.uint8] | NDArray[np.uint16]

# Pixels looked at beside the core on each side; those further out show the background.
FLANK, OUTERMOST = 11, 24
# The least height of clipping over the background, as a share of the clipping level.
LEAST_TOP = 0.2
# The signals that count, in shares of the height at which pixels are clipped.
LOWEST, HIGHEST = 0.05, 1.3
# The shared shape needs this many columns.
FEWEST_COLUMNS = 40
ROUNDS, SHAPE_ROUNDS = 10, 6
SETTLED_PX = 1e-3
# The middle of the flanks lies near the middle of the core, in shares of the core's width.
MOST_SHIFT = 0.3
# Backgrounds on both sides that differ by more than this factor tell two brightnesses of
# the surface: the flank on the brighter one reaches further.
UNEVEN = 1.5
# Steps in which the noise is looked up by the signal's height; the redundancy that one needs.
NOISE_STEPS, LEAST_FREE = 12, 5.0
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


def fit_flanks(image: Image, cores: Cores, saturated: float) -> FlankFits:
    """Fits all columns together; those whose flanks do not fit are left out."""
    height = image.shape[0]
    whole = (cores.first - OUTERMOST >= 0) & (cores.last + OUTERMOST < height)
    cores = cores.chosen(whole)
    places, signal, top, background = _signals(image, cores, saturated)
    lit = top.min(axis=1) > LEAST_TOP * saturated
    places, signal, top, background = (a[lit] for a in (places, signal, top, background))
    cores = cores.chosen(lit)
    if len(cores.columns) < FEWEST_COLUMNS:
        return FlankFits(np.zeros(0, dtype=np.int64), *np.zeros((3, 0)))
    middle = (cores.first + cores.last) / 2
    half = (cores.last - cores.first + 1) / 2
    fit = _Fit(places, signal, top, middle.copy(), half)
    for i in range(ROUNDS):
        shift = fit.round(with_shape=i < SHAPE_ROUNDS)
        if i >= SHAPE_ROUNDS and float(np.median(shift)) < SETTLED_PX:
            break
    variance, uneven = fit.variance(), _uneven_variance(background, fit.decay)
    kept = np.isfinite(variance) & (
        np.abs(fit.centre - middle) < np.maximum(MOST_SHIFT * 2 * half, 1)
    )
    return FlankFits(cores.columns[kept], fit.centre[kept], variance[kept], uneven[kept])


def averaged(fits: FlankFits, width_px: float) -> FlankFits:
    """The line smoothed along itself over its own core's width.

    Light from so broad a spot shows nothing finer. A straight line is fitted to the
    points about each one; where they are not straight, the point stays as it is.
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
    sums = [np.convolve(w, (t**k)[::-1], "same")[at] for k in range(3)]
    first = [np.convolve(w * y, (t**k)[::-1], "same")[at] for k in range(2)]
    square = np.convolve(w * y**2, np.ones(len(t)), "same")[at]
    count = np.convolve(w > 0, np.ones(len(t)), "same")[at]
    det = sums[0] * sums[2] - sums[1] ** 2
    with np.errstate(divide="ignore", invalid="ignore"):
        here = (sums[2] * first[0] - sums[1] * first[1]) / det
        slope = (sums[0] * first[1] - sums[1] * first[0]) / det
        misfit = (square - here * first[0] - slope * first[1]) / (count - 2)
        variance = sums[2] / det
    straight = (count > reach) & (misfit < UNSTRAIGHT * float(np.nanmedian(misfit)))
    return FlankFits(
        fits.columns,
        np.where(straight, here + level, fits.centre),
        np.where(straight, variance, fits.variance),
        fits.uneven,
    )


def _signals(image: Image, cores: Cores, saturated: float) -> tuple[Floats, Floats, Floats, Floats]:
    """Pixels beside the cores: places and signals (n, 2 FLANK), clipping heights, backgrounds.

    Clipped pixels have a signal of NaN; heights (n, 2 FLANK) and backgrounds (n, 2) are
    those of the pixel's side.
    """
    out = np.arange(1, FLANK + 1)
    far = np.arange(FLANK + 1, OUTERMOST + 1)
    rows = np.concatenate([cores.first[:, None] - out, cores.last[:, None] + out], axis=1)
    away = np.concatenate([cores.first[:, None] - far, cores.last[:, None] + far], axis=1)
    levels = image[rows, cores.columns[:, None]].astype(np.float64)
    beyond = image[away, cores.columns[:, None]].astype(np.float64)
    background = np.median(beyond.reshape(len(rows), 2, OUTERMOST - FLANK), axis=2)
    floor = np.repeat(background, FLANK, axis=1)
    signal = np.where(levels < saturated, levels - floor, np.nan)
    return rows.astype(np.float64), signal, saturated - floor, background


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
        self, places: Floats, signal: Floats, top: Floats, centre: Floats, half: Floats
    ) -> None:
        self._places, self._top = places, top
        self._clipped = np.isnan(signal)
        self._signal = np.where(self._clipped, 0.0, signal)
        self._usual = float(np.median(half))  # distances count from the usual core's edge
        self.centre = centre
        self.shape = self._first_shape()
        self.log_height = np.log(top[:, 0]) + self.shape[0] * (half - self._usual)
        self._noise = np.ones(NOISE_STEPS)
        self._normal = np.zeros((3, len(centre)))

    @property
    def decay(self) -> float:
        """Distance over which the signal at the core's edge falls by e."""
        return float(1 / max(self.shape[0], 0.02))

    def round(self, with_shape: bool) -> Floats:
        """One Gauss-Newton step; returns how far the middles moved (n,)."""
        away = self._places - self.centre[:, None]
        d = np.abs(away) - self._usual
        model = np.exp(
            np.clip(self.log_height[:, None] - d * (self.shape[0] + self.shape[1] * d), -9, 12)
        )
        share = model / self._top
        counts = (share > LOWEST) & (share < HIGHEST) & ~self._clipped
        left = np.where(counts, self._signal - model, 0.0)
        step = np.clip(share * NOISE_STEPS / HIGHEST, 0, NOISE_STEPS - 1).astype(np.int64)
        weight = np.where(counts, 1 / self._noise[step], 0.0)
        by_centre = model * (self.shape[0] + 2 * self.shape[1] * d) * np.sign(away)
        wc, wm = weight * by_centre, weight * model
        cc, cm, mm = (np.sum(a, axis=1) for a in (wc * by_centre, wc * model, wm * model))
        gc, gm = np.sum(wc * left, axis=1), np.sum(wm * left, axis=1)
        det = cc * mm - cm**2
        # both flanks must count: one alone tells brightness from place no more
        sides = counts.reshape(len(d), 2, -1).any(axis=2).all(axis=1)
        good = sides & (det > 1e-9 * cc * mm) & (mm > 0)
        safe = np.where(good, det, 1.0)
        move = np.where(good, (mm * gc - cm * gm) / safe, 0.0)
        brighten = np.where(good, (cc * gm - cm * gc) / safe, 0.0)
        if with_shape:
            self._reshape(d, model, weight, left, mm, good)
        self.centre = self.centre + np.clip(move, -1.0, 1.0)
        self.log_height = self.log_height + np.clip(brighten, -0.5, 0.5)
        misfit = np.sum(weight * left**2, axis=1) / np.maximum(counts.sum(axis=1) - 2, 1)
        leverage = (
            weight
            * (
                by_centre**2 * mm[:, None]
                - 2 * by_centre * model * cm[:, None]
                + model**2 * cc[:, None]
            )
            / safe[:, None]
        )
        self._learn_noise(step, left, 1 - leverage, counts & good[:, None])
        self._normal = np.array([np.where(good, mm / safe, np.nan), misfit, counts.sum(axis=1)])
        return np.abs(move)

    def variance(self) -> Floats:
        """(n,) of the middles; NaN where a column cannot be fitted."""
        by_noise, misfit, count = self._normal
        worse = np.where((count > 4) & (misfit > 3), misfit, 1.0)
        return np.asarray(by_noise * worse)

    def _first_shape(self) -> Floats:
        """From how the usual signal falls between the first pixels beside the cores."""
        usual = [
            float(np.median(self._signal[:, [k, FLANK + k]][~self._clipped[:, [k, FLANK + k]]]))
            for k in (0, 2)
        ]
        fall = np.log(max(usual[0], 1.0) / max(usual[1], 1.0)) / 2
        return np.array([float(np.clip(fall, 0.1, 2.0)), 0.0])

    def _reshape(
        self,
        d: Floats,
        model: Floats,
        weight: Floats,
        left: Floats,
        mm: Floats,
        good: NDArray[np.bool_],
    ) -> None:
        """One step of the shared shape, freed of what the columns' own brightness takes up."""
        terms = np.stack([-model * d, -model * d**2], axis=2)[good]
        w, m = weight[good], model[good]
        own = np.einsum("nk,nk,nkj->nj", w, m, terms) / mm[good, None]
        terms -= own[:, None, :] * m[:, :, None]
        N = np.einsum("nk,nki,nkj->ij", w, terms, terms)
        g = np.einsum("nk,nki,nk->i", w, terms, left[good])
        step = np.linalg.lstsq(N, g, rcond=1e-9)[0]
        largest = float(np.max(np.abs(step) / (0.3 * self.shape[0] + np.array([0.0, 0.05]))))
        self.shape = self.shape + step / max(largest, 1.0)

    def _learn_noise(
        self,
        step: NDArray[np.int64],
        left: Floats,
        redundancy: Floats,
        counts: NDArray[np.bool_],
    ) -> None:
        """The pixels' variance by the height of the signal, from what is left of them.

        Each is divided by its redundancy, the share of its error that the fit leaves
        (Foerstner's estimate), so that pixels which the fit follows seem no better.
        """
        flat = step[counts]
        free = np.bincount(flat, redundancy[counts], minlength=NOISE_STEPS)
        squares = np.bincount(flat, left[counts] ** 2, minlength=NOISE_STEPS)
        known = np.flatnonzero(free > LEAST_FREE)
        if len(known):
            found = np.maximum(squares[known] / free[known], 1 / 12)
            self._noise = np.interp(np.arange(NOISE_STEPS), known, found)
