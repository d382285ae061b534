"""The inner loops that find the clipped core of an overexposed laser line, and fit its flanks."""

import numpy as np
from numpy.typing import NDArray

from app.metrology.compiled import kernel
from app.metrology.frames import Floats

# Clipped runs kept in a column, their widths in px, and unclipped pixels that break none.
RUNS = 6
NARROWEST, WIDEST = 5, 64
BREAK = 2
# The signals that count, in shares of the height at which pixels are clipped.
LOWEST, HIGHEST = 0.05, 1.3
# Steps of the signal's share by which the noise is told, and the columns of their table.
NOISE_STEPS = 12
FREE, SQUARES, SIGNALS, PIXELS = range(4)
# Columns of the table of fits.
MOVE, VARIANCE, MISFIT, COUNT = range(4)
# Columns that a track may skip, and rows by which it may climb from one column to the next.
SKIP, STEEPEST = 3, 4.0


@kernel
def clipped_runs(
    image: NDArray[np.integer],
    saturated: float,
    first: NDArray[np.int64],
    last: NDArray[np.int64],
) -> None:
    """First and last row of the clipped runs of every column, into (W, RUNS); -1 for none."""
    height, width = image.shape
    begun = np.full(width, -1, dtype=np.int64)
    ended = np.full(width, -1, dtype=np.int64)
    kept = np.zeros(width, dtype=np.int64)
    dark = np.zeros(width, dtype=image.dtype)
    for r in range(height + BREAK + 2):
        row = image[r] if r < height else dark
        for i in range(width):
            lit = row[i] >= saturated
            if lit:
                if begun[i] < 0:
                    begun[i] = r
                ended[i] = r
            elif begun[i] >= 0 and r - ended[i] > BREAK:
                if NARROWEST <= ended[i] - begun[i] + 1 <= WIDEST and kept[i] < RUNS:
                    first[i, kept[i]] = begun[i]
                    last[i, kept[i]] = ended[i]
                    kept[i] += 1
                begun[i] = -1


@kernel
def link(first: NDArray[np.int64], last: NDArray[np.int64], track: NDArray[np.int64]) -> None:
    """Numbers the runs (W, RUNS) so that those that follow one another share a track."""
    width, runs = first.shape
    tracks = 0
    for i in range(width):
        for k in range(runs):
            if first[i, k] < 0:
                continue
            middle = 0.5 * (first[i, k] + last[i, k])
            nearest = np.inf
            for back in range(1, min(SKIP, i) + 1):
                for j in range(runs):
                    if first[i - back, j] < 0:
                        continue
                    climb = abs(middle - 0.5 * (first[i - back, j] + last[i - back, j]))
                    if climb <= STEEPEST * back and climb < nearest:
                        nearest = climb
                        track[i, k] = track[i - back, j]
                if nearest < np.inf:
                    break
            if track[i, k] < 0:
                track[i, k] = tracks
                tracks += 1


@kernel
def flank_round(
    places: Floats,
    signal: Floats,
    top: Floats,
    usual: float,
    shape: Floats,
    noise: Floats,
    centre: Floats,
    log_height: Floats,
    fits: Floats,
    N: Floats,
    g: Floats,
    moments: Floats,
) -> None:
    """One Gauss-Newton step of every column's middle and brightness, at a given shape.

    Args:
        places, signal: (n, 2 k) row and signal of the pixels beside the cores, k on each
            side; a signal of NaN counts for nothing.
        top: (n, 2) the height at which pixels are clipped, by side.
        usual: the distance in px from which distances count.
        shape: (2,) slope and bend.
        noise: (3,) variance of a pixel's signal s is ``noise[0] + noise[1] s``, that of
            a side's background ``noise[2]``.
        centre, log_height: (n,) stepped in place.
        fits: (n, 4) filled with MOVE ... COUNT; VARIANCE is NaN where one flank is missing.
        N, g: (2, 2) and (2,) filled with the normal equations of the shape, freed of
            what each column's own brightness takes up.
        moments: (NOISE_STEPS, 4) filled with sums of FREE ... PIXELS: redundancy, squared
            residual, signal and one.
    """
    n, pixels = signal.shape
    k = pixels // 2
    model, slope, weight, away = (
        np.zeros(pixels),
        np.zeros(pixels),
        np.zeros(pixels),
        np.zeros(pixels),
    )
    N[:, :] = 0.0
    g[:] = 0.0
    moments[:, :] = 0.0
    for i in range(n):
        cc, cm, mm, gc, gm, chi2 = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
        own0, own1 = 0.0, 0.0
        seen = np.zeros(2)
        side_c, side_m = np.zeros(2), np.zeros(2)
        for j in range(pixels):
            weight[j] = 0.0
            if np.isnan(signal[i, j]):
                continue
            side = j // k
            off = places[i, j] - centre[i]
            d = abs(off) - usual
            m = np.exp(min(max(log_height[i] - d * (shape[0] + shape[1] * d), -9.0), 12.0))
            if not LOWEST * top[i, side] < m < HIGHEST * top[i, side]:
                continue
            c = m * (shape[0] + 2.0 * shape[1] * d)
            if off < 0.0:
                c = -c
            w = 1.0 / (noise[0] + noise[1] * m)
            left = signal[i, j] - m
            model[j], slope[j], weight[j], away[j] = m, c, w, d
            seen[side] += 1.0
            side_c[side] += w * c
            side_m[side] += w * m
            cc += w * c * c
            cm += w * c * m
            mm += w * m * m
            gc += w * c * left
            gm += w * m * left
            chi2 += w * left * left
            own0 += w * m * m * d
            own1 += w * m * m * d * d
        det = cc * mm - cm * cm
        count = seen[0] + seen[1]
        fits[i, MOVE] = 0.0
        fits[i, VARIANCE] = np.nan
        fits[i, MISFIT] = chi2 / max(count - 2.0, 1.0)
        fits[i, COUNT] = count
        # both flanks must count: one alone tells brightness from place no more
        if seen[0] == 0.0 or seen[1] == 0.0 or det <= 1e-9 * cc * mm:
            continue
        by_sides = 0.0
        for side in range(2):
            by_sides += ((mm * side_c[side] - cm * side_m[side]) / det) ** 2
        fits[i, VARIANCE] = mm / det + by_sides * noise[2]
        for j in range(pixels):
            if weight[j] == 0.0:
                continue
            m, c, w, d = model[j], slope[j], weight[j], away[j]
            left = signal[i, j] - m
            step = min(int(m / top[i, j // k] * (NOISE_STEPS / HIGHEST)), NOISE_STEPS - 1)
            moments[step, FREE] += 1.0 - w * (c * c * mm - 2.0 * c * m * cm + m * m * cc) / det
            moments[step, SQUARES] += left * left
            moments[step, SIGNALS] += m
            moments[step, PIXELS] += 1.0
            t0, t1 = -m * (d - own0 / mm), -m * (d * d - own1 / mm)
            N[0, 0] += w * t0 * t0
            N[0, 1] += w * t0 * t1
            N[1, 1] += w * t1 * t1
            g[0] += w * t0 * left
            g[1] += w * t1 * left
        move = min(max((mm * gc - cm * gm) / det, -1.0), 1.0)
        centre[i] += move
        log_height[i] += min(max((cc * gm - cm * gc) / det, -0.5), 0.5)
        fits[i, MOVE] = abs(move)
    N[1, 0] = N[0, 1]
