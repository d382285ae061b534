"""The inner loops of stripe extraction, for a stripe that crosses the columns of an image.

Every loop runs over row views, since an image lies in memory row by row.
"""

import numpy as np
from numpy.typing import NDArray

from app.metrology.compiled import kernel
from app.metrology.frames import Floats

# The score of a row: the mean of the 5 rows about it, its brightest one left out
# (a hot pixel counts for nothing), over the brighter of its two surroundings (the
# edge of a lit face counts for nothing).
CORE = 2
SURROUND = 12
SURROUND_ROWS = 3

# Columns of the table of fits.
CENTRE, AMPLITUDE, SIGMA, BACKGROUND, VARIANCE, CHI2, PIXELS = range(7)


@kernel
def peak_rows(
    image: NDArray[np.integer],
    where: NDArray[np.bool_],
    level: Floats,
    peak: NDArray[np.int64],
) -> None:
    """The row of the highest score in each column, and that score.

    Args:
        image: (H, W), H > 2 SURROUND.
        where: (H, W) pixels that may hold a peak, or (0, 0) for all.
        level, peak: (W,) filled with the score in grey levels and its row.
    """
    height, width = image.shape
    level[:] = 0.0
    peak[:] = -1
    score = np.empty(width, dtype=np.float32)
    masked = where.shape[0] == height
    for r in range(CORE, height - CORE):
        a, b, c, d, e = image[r - 2], image[r - 1], image[r], image[r + 1], image[r + 2]
        above = max(r - SURROUND, 1)
        below = min(r + SURROUND, height - 2)
        f, g, h = image[above - 1], image[above], image[above + 1]
        k, m, n = image[below - 1], image[below], image[below + 1]
        for i in range(width):
            va, vb, vc = np.int32(a[i]), np.int32(b[i]), np.int32(c[i])
            vd, ve = np.int32(d[i]), np.int32(e[i])
            brightest = max(max(max(va, vb), max(vd, ve)), vc)
            core = va + vb + vc + vd + ve - brightest
            before = np.int32(f[i]) + np.int32(g[i]) + np.int32(h[i])
            after = np.int32(k[i]) + np.int32(m[i]) + np.int32(n[i])
            score[i] = np.float32(core) * np.float32(0.25) - np.float32(
                max(before, after)
            ) * np.float32(1.0 / 3.0)
        if masked:
            allowed = where[r]
            for i in range(width):
                if not allowed[i]:
                    score[i] = np.float32(0.0)
        for i in range(width):
            if score[i] > level[i]:
                level[i] = score[i]
                peak[i] = r


@kernel
def neighbour_differences(image: NDArray[np.integer], step: int, counts: NDArray[np.int64]) -> None:
    """Histogram of ``|I(r, c) - I(r, c + 1)|`` over every ``step``-th row."""
    height, width = image.shape
    last = len(counts) - 1
    for r in range(0, height, step):
        row = image[r]
        for i in range(width - 1):
            difference = np.int64(row[i]) - np.int64(row[i + 1])
            if -last < difference < last:
                counts[abs(difference)] += 1
            else:
                counts[last] += 1


@kernel
def solve4(N: Floats, g: Floats, x: Floats) -> bool:
    """Solves ``N x = g`` for a symmetric (4, 4), destroying N; False where not positive."""
    for j in range(4):
        for k in range(j):
            N[j, j] -= N[j, k] * N[j, k]
        if N[j, j] <= 0.0:
            return False
        N[j, j] = np.sqrt(N[j, j])
        for i in range(j + 1, 4):
            for k in range(j):
                N[i, j] -= N[i, k] * N[j, k]
            N[i, j] /= N[j, j]
    for i in range(4):
        x[i] = g[i]
        for k in range(i):
            x[i] -= N[i, k] * x[k]
        x[i] /= N[i, i]
    for i in range(3, -1, -1):
        for k in range(i + 1, 4):
            x[i] -= N[k, i] * x[k]
        x[i] /= N[i, i]
    return True


@kernel
def half_width(profile: Floats, centre: int, saturated: float) -> tuple[float, float, float]:
    """Centre, width at half height and background of the peak at ``centre`` of a profile.

    The width is 0 where the profile never falls to half.
    """
    n = len(profile)
    reach = SURROUND + 2
    first, last = max(centre - reach, 0), min(centre + reach, n - 1)
    top = profile[centre]
    for i in range(max(centre - CORE, 0), min(centre + CORE, n - 1) + 1):
        top = max(top, profile[i])
    left_floor = (profile[first] + profile[first + 1] + profile[first + 2]) / 3
    right_floor = (profile[last] + profile[last - 1] + profile[last - 2]) / 3
    background = min(left_floor, right_floor)
    half = 0.5 * (min(top, saturated) + max(left_floor, right_floor))
    left, right = centre, centre
    while left > 0 and profile[left] > half:
        left -= 1
    while right < n - 1 and profile[right] > half:
        right += 1
    if profile[left] > half or profile[right] > half or right - left < 2:
        return 0.0, 0.0, background
    lower = left + (half - profile[left]) / (profile[left + 1] - profile[left])
    upper = right - (half - profile[right]) / (profile[right - 1] - profile[right])
    return 0.5 * (lower + upper), upper - lower, background


@kernel
def window(profile: Floats, centre: float, sigma: float, saturated: float) -> tuple[int, int]:
    """First and last pixel of a fit: wide enough to hold both flanks beside clipped pixels."""
    reach = 2.6 * sigma + 1.0
    first = max(int(np.ceil(centre - reach)), 0)
    last = min(int(np.floor(centre + reach)), len(profile) - 1)
    clipped = 0
    for r in range(first, last + 1):
        if profile[r] >= saturated:
            clipped += 1
    if clipped == 0:
        return first, last
    # a clipped profile looks wider than it is at half height, and has its foot further out
    return max(first - 2, 0), min(last + 2, len(profile) - 1)


@kernel
def normal_equations(
    profile: Floats, p: Floats, noise: Floats, saturated: float, N: Floats, g: Floats
) -> tuple[float, int]:
    """Fills ``N`` (4, 4), lower half, and ``g`` (4,) at parameters p; chi squared and pixels.

    ``profile`` begins where p[0] counts from.
    """
    J = np.empty(4)
    N[:, :] = 0.0
    g[:] = 0.0
    chi2, used = 0.0, 0
    for r in range(len(profile)):
        if profile[r] >= saturated:
            continue
        t = (r - p[0]) / p[2]
        J[1] = np.exp(-0.5 * t * t)
        J[0] = p[1] * J[1] * t / p[2]
        J[2] = J[0] * t
        J[3] = 1.0
        signal = p[1] * J[1]
        weight = 1.0 / (noise[0] + signal * (noise[1] + signal * noise[2]))
        residual = profile[r] - p[3] - signal
        chi2 += weight * residual * residual
        used += 1
        for i in range(4):
            g[i] += weight * J[i] * residual
            for j in range(i + 1):
                N[i, j] += weight * J[i] * J[j]
    return chi2, used


@kernel
def fit_gaussian(
    profile: Floats, start: Floats, noise: Floats, saturated: float, fit: Floats
) -> bool:
    """Weighted Gauss-Newton fit of a Gaussian on a background, clipped pixels left out.

    Args:
        profile: (H,) grey levels of one column.
        start: centre, amplitude, sigma, background to start from.
        noise: variance of a pixel at signal s is ``noise[0] + noise[1] s + noise[2] s^2``.
        saturated: the grey level from which a pixel is clipped.
        fit: (7,) the result, in the order CENTRE ... PIXELS.

    Returns:
        False where the fit does not settle on a peak within the window.
    """
    first, last = window(profile, start[0], start[2], saturated)
    part = profile[first : last + 1]
    p = start.copy()
    p[0] -= first
    N, g, step = np.empty((4, 4)), np.empty(4), np.empty(4)
    settled = False
    for _ in range(30):
        chi2, used = normal_equations(part, p, noise, saturated, N, g)
        if used < 5 or not solve4(N, g, step):
            return False
        # half a width and half a height at most, so that a poor start does no harm
        largest = max(abs(step[0]) / p[2], abs(step[2]) / p[2], abs(step[1]) / (2 * p[1]))
        p += min(1.0, 0.5 / max(largest, 1e-12)) * step
        if p[2] < 0.2 or p[0] < 0.0 or p[0] > len(part) - 1:
            return False
        if largest < 1e-4:
            settled = True
            break
    if not settled:
        return False
    chi2, used = normal_equations(part, p, noise, saturated, N, g)
    g[:] = 0.0
    g[0] = 1.0
    if not solve4(N, g, step):
        return False
    fit[CENTRE], fit[AMPLITUDE], fit[SIGMA], fit[BACKGROUND] = p[0] + first, p[1], p[2], p[3]
    fit[VARIANCE], fit[CHI2], fit[PIXELS] = step[0], chi2, used
    return True


@kernel
def fit_columns(
    image: NDArray[np.integer],
    columns: NDArray[np.int64],
    peak: NDArray[np.int64],
    noise: Floats,
    saturated: float,
    fits: Floats,
) -> None:
    """Fits every column's peak; a row of ``fits`` (n, 7) stays NaN where there is none."""
    height = image.shape[0]
    reach = 40
    profile = np.zeros(2 * reach + 1)
    start = np.zeros(4)
    for i in range(len(columns)):
        fits[i, :] = np.nan
        first = max(peak[i] - reach, 0)
        last = min(peak[i] + reach, height - 1)
        part = profile[: last - first + 1]
        for r in range(first, last + 1):
            part[r - first] = image[r, columns[i]]
        centre, width, background = half_width(part, peak[i] - first, saturated)
        if width == 0.0:
            continue
        start[0], start[2], start[3] = centre, max(width / 2.3548, 0.4), background
        start[1] = part[int(centre + 0.5)] - background
        if start[1] > 0.0 and fit_gaussian(part, start, noise, saturated, fits[i]):
            fits[i, CENTRE] += first
        else:
            fits[i, :] = np.nan


@kernel
def residual_moments(
    image: NDArray[np.integer],
    columns: NDArray[np.int64],
    fits: Floats,
    saturated: float,
    sums: Floats,
    squares: Floats,
    counts: NDArray[np.int64],
) -> None:
    """Sums squared residuals of the fits by the signal's level, one bin per grey-level step.

    Args:
        sums, squares, counts: (bins,) sum of signal, of squared residual (freed of
            the fit's own share), and number of pixels, per bin of the signal's
            share of ``saturated``.
    """
    height = image.shape[0]
    bins = len(counts)
    for i in range(len(columns)):
        fit = fits[i]
        # a narrow spike that the speckle made, fitted far above what the pixels hold
        if not (fit[PIXELS] > 5 and fit[AMPLITUDE] < saturated):
            continue
        share = fit[PIXELS] / (fit[PIXELS] - 4.0)
        reach = 2.6 * fit[SIGMA]
        first = max(int(np.ceil(fit[CENTRE] - reach)), 0)
        last = min(int(np.floor(fit[CENTRE] + reach)), height - 1)
        for r in range(first, last + 1):
            value = float(image[r, columns[i]])
            if value >= saturated:
                continue
            t = (r - fit[CENTRE]) / fit[SIGMA]
            signal = fit[AMPLITUDE] * np.exp(-0.5 * t * t)
            residual = value - fit[BACKGROUND] - signal
            k = min(int(signal / saturated * bins), bins - 1)
            sums[k] += signal
            squares[k] += residual * residual * share
            counts[k] += 1
