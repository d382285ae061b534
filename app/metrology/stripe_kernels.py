"""From the scores of an image's strips to the points of its stripe, in two compiled steps."""

import numpy as np
from numpy.typing import NDArray

from app.metrology.compiled import kernel
from app.metrology.frames import Floats
from app.metrology.grey_lanes import Grey
from app.metrology.stripe_block import LANES, PEAK, WIDER, WIDEST_REACH, Singles, to_brightest
from app.metrology.stripe_choice import choose, in_long_runs
from app.metrology.stripe_fit import (
    AMPLITUDE,
    BECAME,
    CENTRE,
    CHI2_OF,
    CLIPPED_OF,
    FIT_ROWS,
    PIXELS,
    SIGMA,
    USUAL_REACH,
    VARIANCE,
    fit_peaks,
    sample,
    usual_width,
)
from app.metrology.stripe_noise import BLOCKS, FIRST_GAIN, tell_noise
from app.metrology.stripe_peaks import list_peaks
from app.metrology.stripe_scatter import speckle_variance
from app.metrology.stripe_search import CORE_ROWS

# Widths, in shares of the image's typical one, beyond which a peak is no stripe, and the
# least standard deviation in px; the misfit from which a point is told to be worse.
NARROW, WIDE, LEAST_SIGMA_PX = 0.45, 2.2, 0.5
MISFIT = 3.0
# Rows about a peak that are looked at, by the usual standard deviation.
REACH_SIGMAS, REACH_MORE = 3.6, 4.0
# Steps of a fit, and of one that needs more of everything.
STEPS, MORE_STEPS = 3, 30
# Widths that the usual one is the median of.
WIDTHS = 63
# Columns that a run may skip, and rows by which it may climb from one column to the next.
LARGEST_GAP, STEEPEST = 3.0, 4.0
# Columns between which laser speckle has become independent.
SPECKLE_LAG = 6
# Rows of the table of peaks, and of the table of points.
ALONG, ACROSS, HEIGHT, UNSURE, BROAD = range(5)


@kernel
def measure(
    image: Grey,
    score: Grey,
    at: NDArray[np.uint8],
    sought: NDArray[np.bool_],
    rule: int,
    shortest: int,
    threshold: float,
    widths_px: tuple[float, float],
    read: float,
    saturated: float,
    places: NDArray[np.int32],
    chosen: NDArray[np.int32],
    raw: Grey,
    blocks: Singles,
    profiles: Singles,
    fits: Singles,
    peaks: Floats,
    told: Singles,
) -> tuple[int, int]:
    """Chooses, fits and sifts the peaks of all columns sought.

    Args:
        image: (H, W).
        score, at: see ``stripe_search.search_part``.
        sought: (W,) or (0,) for all columns.
        rule, shortest: see ``stripe_choice.choose``.
        threshold: the least score of a peak, and height of its fit.
        widths_px: least and greatest standard deviation; NaN for what the image tells.
        read: variance of a dark pixel.
        places: (3, n) room for columns, rows and heights of all peaks.
        chosen: (2, W) room for those of the chosen.
        raw, blocks, profiles: see ``stripe_noise.tell_noise``.
        fits: (FIT_ROWS, W, in whole blocks) filled, see ``stripe_fit.fit_peaks``.
        peaks: (5, W) filled, in the order ALONG ... BROAD: UNSURE is the variance, BROAD the
            standard deviation of the width.
        told: (4,) the noise's terms and the usual standard deviation of the width, filled
            where the first is 0, else taken for known.

    Returns:
        How many peaks there are, and the most pixels that are clipped in one.
    """
    width = image.shape[1]
    pixels = image.reshape(-1)
    level = np.float32(saturated)
    found = list_peaks(score, at, int(threshold), places[0], places[1], places[2])
    n = choose(
        places[0][:found],
        places[1][:found],
        places[2][:found],
        width,
        rule,
        shortest,
        chosen[0],
        chosen[1],
    )
    if len(sought):
        n = keep_sought(chosen, n, sought)
    if n == 0:
        return 0, 0
    columns, rows = chosen[0][:n], chosen[1][:n]
    to_brightest(pixels, width, columns, rows, CORE_ROWS)
    noise = told[:3]
    known = noise[0] > 0
    if not known:
        taken = min(-(-n // LANES), BLOCKS)
        sample(
            pixels,
            width,
            columns,
            rows,
            0,
            taken,
            USUAL_REACH,
            level,
            raw,
            blocks[0],
            profiles[0],
        )
        told[3] = usual_width(blocks[0])
        noise[0], noise[1], noise[2] = read, FIRST_GAIN * saturated, 0.0
    reach = min(int(np.ceil(REACH_SIGMAS * told[3] + REACH_MORE)), WIDEST_REACH)
    if not known:
        tell_noise(pixels, width, columns, rows, reach, taken, level, raw, blocks, profiles, noise)
    fit_peaks(
        pixels, width, columns, rows, reach, noise, level, STEPS, raw, blocks[0], profiles[0], fits
    )
    fit_wider(pixels, width, columns, rows, noise, level, raw, blocks[0], profiles[0], fits)
    clipped = 0.0
    for i in range(n):
        clipped = max(clipped, fits[CLIPPED_OF, i])
    return sift(columns, rows, fits, threshold, widths_px, peaks), int(clipped)


@kernel
def keep_sought(chosen: NDArray[np.int32], n: int, sought: NDArray[np.bool_]) -> int:
    """Keeps the columns that are sought."""
    kept = 0
    for i in range(n):
        if sought[chosen[0, i]]:
            chosen[0, kept], chosen[1, kept] = chosen[0, i], chosen[1, i]
            kept += 1
    return kept


@kernel
def fit_wider(
    pixels: Grey,
    width: int,
    columns: NDArray[np.int32],
    rows: NDArray[np.int32],
    noise: Singles,
    saturated: np.float32,
    raw: Grey,
    block: Singles,
    profile: Singles,
    fits: Singles,
) -> None:
    """Fits those peaks anew that needed more rows or more steps."""
    more = np.flatnonzero(fits[BECAME, : len(columns)] == WIDER)
    if len(more) == 0:
        return
    again = np.empty((FIT_ROWS, -(-len(more) // LANES) * LANES), np.float32)
    fit_peaks(
        pixels,
        width,
        columns[more],
        rows[more],
        WIDEST_REACH,
        noise,
        saturated,
        MORE_STEPS,
        raw,
        block,
        profile,
        again,
    )
    for i in range(len(more)):
        fits[:, more[i]] = again[:, i]


@kernel
def sift(
    columns: NDArray[np.int32],
    rows: NDArray[np.int32],
    fits: Singles,
    threshold: float,
    widths_px: tuple[float, float],
    peaks: Floats,
) -> int:
    """Keeps the peaks that are as wide and high as a stripe; returns how many."""
    n = len(columns)
    found, some = 0, np.empty(WIDTHS)
    every = (n + WIDTHS - 1) // WIDTHS
    for i in range(0, n, every):
        if fits[BECAME, i] == PEAK:
            some[found] = fits[SIGMA, i]
            found += 1
    if found == 0:
        return 0
    usual = np.sort(some[:found])[found // 2]
    narrowest, widest = widths_px
    if np.isnan(narrowest):
        narrowest = max(NARROW * usual, LEAST_SIGMA_PX)
    if np.isnan(widest):
        widest = max(WIDE * usual, narrowest)
    kept = 0
    for i in range(n):
        if fits[BECAME, i] != PEAK or not narrowest < fits[SIGMA, i] < widest:
            continue
        if fits[AMPLITUDE, i] < threshold:
            continue
        free = max(fits[PIXELS, i] - 4, 1.0)
        worse = fits[CHI2_OF, i] / free if fits[CHI2_OF, i] > MISFIT * free else 1.0
        peaks[ALONG, kept], peaks[ACROSS, kept] = columns[i], rows[i] + np.float64(fits[CENTRE, i])
        peaks[HEIGHT, kept], peaks[BROAD, kept] = fits[AMPLITUDE, i], fits[SIGMA, i]
        peaks[UNSURE, kept] = fits[VARIANCE, i] * worse
        kept += 1
    return kept


@kernel
def finish(peaks: Floats, shortest: int, saturated: float) -> Floats:
    """The points (4, N) of the peaks (5, n) that lie in runs, with their standard deviations."""
    n = peaks.shape[1]
    kept = np.empty(n, np.bool_)
    in_long_runs(peaks[ALONG], peaks[ACROSS], peaks[BROAD], LARGEST_GAP, STEEPEST, shortest, kept)
    points = np.empty((4, int(np.sum(kept))))
    found = 0
    for i in range(n):
        if kept[i]:
            points[ALONG, found], points[ACROSS, found] = peaks[ALONG, i], peaks[ACROSS, i]
            points[HEIGHT, found] = min(peaks[HEIGHT, i], saturated)
            points[UNSURE, found] = peaks[UNSURE, i]
            found += 1
    scatter = speckle_variance(points[ALONG], points[ACROSS], points[UNSURE], SPECKLE_LAG, 0)
    for i in range(found):
        points[UNSURE, i] = np.sqrt(points[UNSURE, i] + scatter)
    return points
