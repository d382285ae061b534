"""Peaks of many columns side by side: their pixels, and where a fit of them starts.

Columns are taken LANES at a time, side by side, so that every step is one for all of
them: a block's numbers lie in one array of single precision, in rows of LANES. Indices
are unsigned, since a signed one could count from the end, which keeps a loop slow.
"""

import numpy as np
from numpy.typing import NDArray

from app.metrology.compiled import vector_kernel
from app.metrology.grey_lanes import Grey
from app.metrology.lanes import WIDTH, all_lanes, highest, load, load_whole, store, where

Singles = NDArray[np.float32]

LANES = 64
# Rows of a block: the lower half of the normal matrix (row by row), its right-hand side,
# chi squared and the number of pixels; the parameters; first and last
# pixel of the fit, what became of the lane, its last step in shares of the width, the centre's
# variance, and how many pixels are clipped.
SUM_ROWS, _PARAMETERS, _STATES = 16, 4, 6
(N00, N10, N11, N20, N21, N22, N30, N31, N32, N33, G0, G1, G2, G3, CHI2, USED) = (
    np.uintp(LANES * i) for i in range(SUM_ROWS)
)
C, A, S, B = (np.uintp(LANES * (SUM_ROWS + i)) for i in range(_PARAMETERS))
FIRST, LAST, STATE, MOVED, VAR, CLIPPED = (
    np.uintp(LANES * (SUM_ROWS + _PARAMETERS + i)) for i in range(_STATES)
)
# Of the start, in the place of a sum: the level of half height.
LEVEL = N00
ALL = np.uintp(LANES)
TWO = np.uintp(2)
ONE = np.uintp(1)
BLOCK_ROWS = SUM_ROWS + _PARAMETERS + _STATES
# What became of a lane: no peak; a peak that needs more rows than the block holds; a peak.
NO_PEAK, WIDER, PEAK = np.float32(0), np.float32(1), np.float32(2)

# A fit reaches so many standard deviations and pixels from the centre, and further out
# beside clipped pixels: a clipped profile looks wider, and has its foot further out.
REACH, REACH_PX, BESIDE_CLIPPED_PX = np.float32(3.2), np.float32(1), np.float32(2)
LEAST_START = np.float32(0.4)
HALF_WIDTHS = np.float32(1 / 2.3548)
# Neighbouring columns whose peaks are so many rows apart are taken at once.
MOST_APART = 31
FARTHEST_LEAP = np.uintp(16)
# Rows about a peak that are looked at where the usual number does not do.
WIDEST_REACH = 40
PROFILE_ROWS = 2 * WIDEST_REACH + 1 + MOST_APART


@vector_kernel
def to_brightest(
    pixels: Grey, width: int, columns: NDArray[np.int32], rows: NDArray[np.int32], core: int
) -> None:
    """Moves the rows (n,) of peaks to the brightest pixel of their core, the row before on."""
    for i in range(len(columns)):
        at = np.uintp((rows[i] - 1) * width + columns[i])
        best, top = 0, pixels[at]
        for k in range(1, core):
            at += np.uintp(width)
            if pixels[at] > top:
                best, top = k, pixels[at]
        rows[i] += best - 1


@vector_kernel
def gather(
    pixels: Grey,
    width: int,
    columns: NDArray[np.int32],
    rows: NDArray[np.int32],
    reach: int,
    raw: Grey,
    profile: Singles,
) -> None:
    """Takes the pixels about the peaks, for a block.

    Args:
        pixels: (H W,) the image's pixels.
        columns, rows: (n <= LANES,) where the peaks are; the last fills up the block.
        reach: rows about ``rows``; those beyond the image repeat its border.
        raw: room to work in, as long as profile.
        profile: (PROFILE_ROWS LANES,), of which the first 2 reach + 1 rows are filled.
    """
    height = len(pixels) // width
    for group in range(0, LANES, int(WIDTH)):
        behind = group + int(WIDTH)
        if behind <= len(columns) and columns[behind - 1] - columns[group] == behind - group - 1:
            lowest = highest = int(rows[group])
            for i in range(group, behind):
                lowest, highest = min(lowest, int(rows[i])), max(highest, int(rows[i]))
            inside = lowest >= reach and highest + reach < height
            if inside and highest - lowest <= MOST_APART:
                for i in range(group, behind):
                    profile[i] = rows[i] - lowest  # its first row comes last
                first = np.uintp((lowest - reach) * width + columns[group])
                gather_neighbours(pixels, width, first, highest - lowest, reach, profile, group)
                continue
        gather_apart(pixels, width, columns, rows, reach, raw, profile, group)


@vector_kernel
def gather_neighbours(
    pixels: Grey,
    width: int,
    first: np.uintp,
    apart: int,
    reach: int,
    profile: Singles,
    group: int,
) -> None:
    """Takes the pixels for the lanes from ``group`` on, of columns side by side.

    Args:
        first: the pixel of the first column in the first row of the lowest.
        apart: rows from the lowest to the highest.
        profile: its first row says by how many rows each lane is over the lowest.
    """
    at, line = np.uintp(group), np.uintp(width)
    over, most = load(profile, at), np.uintp(apart)
    last = np.uintp(2 * reach + 1)
    for k in range(last + most):
        store(profile, k * ALL + at, load_whole(pixels, first + k * line))
    # every lane goes up by so many rows as it is over: by sixteen where it is, by eight, ...
    leap = FARTHEST_LEAP
    while leap > 0:
        if leap <= most:
            goes = over >= np.float32(leap)
            for k in range(last + min(leap - ONE, most - leap)):
                there = load(profile, (k + leap) * ALL + at)
                store(profile, k * ALL + at, where(goes, there, load(profile, k * ALL + at)))
            over = where(goes, over - np.float32(leap), over)
        leap >>= ONE


@vector_kernel
def gather_apart(
    pixels: Grey,
    width: int,
    columns: NDArray[np.int32],
    rows: NDArray[np.int32],
    reach: int,
    raw: Grey,
    profile: Singles,
    group: int,
) -> None:
    """Takes the pixels for the lanes from ``group`` on, wherever they are; see ``gather``."""
    n = len(columns)
    height = len(pixels) // width
    for i in range(group, group + int(WIDTH)):
        lane = min(i, n - 1)
        row = rows[lane] - reach
        to = np.uintp(i)
        if row >= 0 and row + 2 * reach < height:
            pixel = np.uintp(row * width + columns[lane])
            for _ in range(2 * reach + 1):
                raw[to] = pixels[pixel]
                pixel += np.uintp(width)
                to += ALL
        else:
            for k in range(2 * reach + 1):
                inside = min(max(row + k, 0), height - 1)
                raw[to] = pixels[np.uintp(inside * width + columns[lane])]
                to += ALL
    at = np.uintp(group)
    for k in range(np.uintp(2 * reach + 1)):
        store(profile, k * ALL + at, load_whole(raw, k * ALL + at))


@vector_kernel
def start(block: Singles, profile: Singles, reach: int, saturated: np.float32) -> None:
    """Centre, width at half height, height and background of every lane's peak."""
    middle = np.uintp(reach) * ALL
    end = np.uintp(2 * reach) * ALL
    third, half = np.float32(1 / 3), np.float32(0.5)
    for i in range(ALL):
        here = middle + i
        top = max(max(profile[here - ALL], profile[here + ALL]), profile[here])
        top = max(max(profile[here - TWO * ALL], profile[here + TWO * ALL]), top)
        low = (profile[i] + profile[ALL + i] + profile[TWO * ALL + i]) * third
        to = end + i
        high = (profile[to] + profile[to - ALL] + profile[to - TWO * ALL]) * third
        background = min(low, high)
        block[B + i] = background
        block[A + i] = top - background
        block[LEVEL + i] = half * (min(top, saturated) + max(low, high))
    crossings(block, profile, middle, reach, FIRST, False)
    crossings(block, profile, middle, reach, LAST, True)
    for i in range(ALL):
        left, right = np.float32(reach) - block[FIRST + i], np.float32(reach) + block[LAST + i]
        whole = (block[FIRST + i] > 0) & (block[LAST + i] > 0)
        state = PEAK if whole else WIDER
        state = state if block[A + i] > 0 else NO_PEAK
        state = NO_PEAK if whole & (right - left < np.float32(1)) else state
        block[STATE + i] = state
        block[C + i] = half * (left + right) if whole else np.float32(reach)
        block[S + i] = max((right - left) * HALF_WIDTHS, LEAST_START) if whole else np.float32(1)
        block[A + i] = block[A + i] if block[A + i] > 0 else np.float32(1)


@vector_kernel
def crossings(
    block: Singles, profile: Singles, middle: np.uintp, reach: int, to: np.uintp, downwards: bool
) -> None:
    """How far from its middle row a lane's profile first falls to the level; 0 for never."""
    zero = all_lanes(np.float32(0))
    for group in range(0, ALL, WIDTH):
        at = np.uintp(group)
        level = load(block, LEVEL + at)
        inside = outside = load(profile, middle + at)
        far = zero
        for k in range(1, reach + 1):
            away = np.uintp(k) * ALL
            pixel = load(profile, (middle + away if downwards else middle - away) + at)
            seeking = outside > level
            inside = where(seeking, outside, inside)
            outside = where(seeking, pixel, outside)
            far = where(seeking, all_lanes(np.float32(k)), far)
        away_px = far - (level - outside) / (inside - outside)
        store(block, to + at, where((outside <= level) & (inside > level), away_px, zero))


@vector_kernel
def set_windows(block: Singles, profile: Singles, reach: int, saturated: np.float32) -> None:
    """The pixels that every lane's fit takes: both flanks, even beside clipped pixels."""
    last = np.float32(2 * reach)
    for i in range(ALL):
        away = REACH * block[S + i] + REACH_PX
        block[FIRST + i] = np.ceil(block[C + i] - away)
        block[LAST + i] = np.floor(block[C + i] + away)
    for at in range(0, ALL, WIDTH):
        count_clipped(block, profile, saturated, np.uintp(at))
    for i in range(ALL):
        out = BESIDE_CLIPPED_PX if block[CLIPPED + i] > 0 else np.float32(0)
        block[FIRST + i] -= out
        block[LAST + i] += out
        short = (block[FIRST + i] < 0) | (block[LAST + i] > last)
        block[STATE + i] = min(block[STATE + i], WIDER) if short else block[STATE + i]


@vector_kernel
def count_clipped(block: Singles, profile: Singles, saturated: np.float32, at: np.uintp) -> None:
    """How many pixels of their windows are clipped, of the lanes from ``at`` on."""
    zero, one, level = all_lanes(np.float32(0)), all_lanes(np.float32(1)), all_lanes(saturated)
    first, last = load(block, FIRST + at), load(block, LAST + at)
    clipped = zero
    begin, end = rows_used(block, profile, at)
    brightest, k = zero, begin
    while k <= end:
        pixel = load(profile, k * ALL + at)
        brightest = where(pixel > brightest, pixel, brightest)
        k += ONE
    if highest(brightest) >= saturated:
        k = begin
        while k <= end:
            x = all_lanes(np.float32(k))
            counts = (load(profile, k * ALL + at) >= level) & (x >= first) & (x <= last)
            clipped = clipped + where(counts, one, zero)
            k += ONE
    store(block, CLIPPED + at, clipped)


@vector_kernel
def rows_used(block: Singles, profile: Singles, at: np.uintp) -> tuple[np.uintp, np.uintp]:
    """First row of a profile that the fit of any of the lanes from ``at`` on takes, and last."""
    zero = all_lanes(np.float32(0))
    first = -highest(zero - load(block, FIRST + at))
    last = highest(load(block, LAST + at))
    end = min(np.uintp(max(last, np.float32(0))), np.uintp(len(profile)) // ALL - ONE)
    return np.uintp(max(first, np.float32(0))), end
