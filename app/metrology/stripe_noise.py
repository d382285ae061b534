"""The sensor's noise, told by the image itself."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.metrology.compiled import kernel, vector_kernel
from app.metrology.frames import Floats
from app.metrology.grey_lanes import Grey
from app.metrology.lanes import WIDTH, Lanes, all_lanes, load, store, where
from app.metrology.stripe_block import (
    ALL,
    FIRST,
    LANES,
    LAST,
    MOVED,
    N00,
    N10,
    N11,
    N20,
    N21,
    N22,
    N30,
    N31,
    N32,
    N33,
    ONE,
    PEAK,
    STATE,
    USED,
    A,
    B,
    C,
    S,
    Singles,
    rows_used,
    set_windows,
)
from app.metrology.stripe_fit import SETTLED, USUAL_REACH, invert, sample, step
from app.metrology.stripe_normal import bell, normal_equations

# Pieces of rows, evenly over the image, whose neighbours are compared, and their length.
PIECES, PIECE_PX = 32, 192
# Levels by which neighbours may differ; what differs by more is told as the last. They are
# counted in so many lists in turn, since a count waits for the one before it.
LEVELS, LISTS = 4096, 4
# Peaks, taken evenly, whose fits tell how the noise grows with the signal, in blocks.
BLOCKS = 2
# A residual beyond so many variances is no noise, once the noise is roughly known.
OUTLYING = 25.0
# Fewer pixels tell nothing.
FEWEST = 60
# Pixels that the fit follows more closely than this share tell nothing.
LEAST_SHARE = np.float32(0.2)
# What the noise is before it is told: grey levels squared per level, of a full scale of 255.
FIRST_GAIN = 0.01 / 255


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


@kernel
def read_noise(image: Grey, counts: NDArray[np.int32]) -> float:
    """Variance of a dark pixel in grey levels squared, from differences of neighbours.

    Most of an image is unlit, so the bulk of the differences is noise; what exceeds
    three times their median is scene and is cut off. Rounding adds 1/12 at least.

    Args:
        counts: (LISTS, LEVELS or fewer) room to work in.
    """
    height, width = image.shape
    pieces = min(PIECES, height)
    length = min(PIECE_PX, width - 1)
    most = counts.shape[1] - 1
    counts[:] = 0
    for piece in range(pieces):
        row = image[(2 * piece + 1) * height // (2 * pieces)]
        # a third of the width further on each time, so that no place is left out
        first = (piece * width // 3 + piece * length) % (width - length)
        part = row[first : first + length + 1]
        for i in range(length):
            difference = abs(np.int64(part[i]) - np.int64(part[i + 1]))
            counts[i % LISTS, min(difference, most)] += 1
    half, seen, median = pieces * length / 2, 0, 0
    while seen + counts[:, median].sum() < half:
        seen += counts[:, median].sum()
        median += 1
    kept, total = 0, 0
    for level in range(min(4 * median + 3, most)):
        alike = counts[:, level].sum()
        kept += alike
        total += alike * level * level
    return max(total / max(kept, 1) / 2, 1 / 12)


@vector_kernel
def moments(
    block: Singles,
    profile: Singles,
    noise: Singles,
    saturated: np.float32,
    outlying: np.float32,
    sums: Singles,
    at: np.uintp,
) -> None:
    """Adds up what the residuals of the lanes from ``at`` on tell of the noise, lane by lane.

    A squared residual is divided by its redundancy, the share of the pixel's error that
    the fit leaves (Foerstner's estimate): the fit follows some pixels closely.

    Args:
        noise: (3,) the model by which they are weighed, see ``normal_equations``.
        outlying: the most that a squared residual counts for, in variances.
        sums: (6 LANES,) sums of s^2, s^3, s^4, s d, s^2 d and 1, where s is a pixel's signal
            and d its squared residual over its redundancy, less the read noise.
    """
    zero, one = all_lanes(np.float32(0)), all_lanes(np.float32(1))
    two = np.float32(2)
    n0, n1, n2 = noise[0], noise[1], noise[2]
    centre, background, height = load(block, C + at), load(block, B + at), load(block, A + at)
    per_width = one / load(block, S + at)
    first, last = load(block, FIRST + at), load(block, LAST + at)
    told = (load(block, STATE + at) >= PEAK) & (load(block, USED + at) > np.float32(5))
    # a narrow spike that the speckle made is fitted far above what the pixels hold
    told = told & (load(block, MOVED + at) < SETTLED) & (height < saturated)
    i00, i10, i11 = load(block, N00 + at), load(block, N10 + at), load(block, N11 + at)
    i20, i21, i22 = load(block, N20 + at), load(block, N21 + at), load(block, N22 + at)
    i30, i31, i32 = load(block, N30 + at), load(block, N31 + at), load(block, N32 + at)
    i33 = load(block, N33 + at)
    ss = sc = cc = sd = cd = number = zero
    height2 = height * height
    k, end = rows_used(block, profile, at)
    while k <= end:
        x = all_lanes(np.float32(k))
        pixel = load(profile, k * ALL + at)
        t = (x - centre) * per_width
        e = bell(t)
        s = height * e
        variance = s * (s * n2 + n1) + n0
        left = pixel - background - s
        # the share of a pixel's error that the fit leaves
        per_variance = one / variance
        et = e * t
        ett = et * t
        taken = et * (et * i00 + (e * i10 + ett * i20) * two)
        taken = taken + e * (e * i11 + ett * i21 * two) + ett * ett * i22 + i33
        taken = taken + (et * i30 + e * i31 + ett * i32) * two
        share = one - taken * height2 * per_variance
        counts = told & (x >= first) & (x <= last) & (pixel < saturated) & (share > LEAST_SHARE)
        squared, most = left * left / share, variance * outlying
        # a lane without a solution may hold no numbers at all
        d = where(counts, where(squared < most, squared, most) - n0, zero)
        s = where(counts, s, zero)
        weight = where(counts, per_variance * per_variance, zero)
        ws = weight * s
        wss = ws * s
        ss, sc, cc = ss + wss, sc + wss * s, cc + wss * s * s
        sd, cd = sd + ws * d, cd + wss * d
        number = number + where(counts, one, zero)
        k += ONE
    add(sums, at, ss)
    add(sums, ALL + at, sc)
    add(sums, ALL + ALL + at, cc)
    add(sums, ALL + ALL + ALL + at, sd)
    add(sums, ALL + ALL + ALL + ALL + at, cd)
    add(sums, ALL + ALL + ALL + ALL + ALL + at, number)


@vector_kernel
def add(sums: Singles, at: np.uintp, more: Lanes) -> None:
    """Adds to the sums from ``at`` on."""
    store(sums, at, load(sums, at) + more)


@kernel
def non_negative(sums: Singles, noise: Singles) -> None:
    """Least squares of gain and contrast, neither below zero, into ``noise``."""
    total = np.zeros(6)
    for j in range(6):
        for i in range(LANES):
            total[j] += sums[j * LANES + i]
    ss, sc, cc, sd, cd = total[0], total[1], total[2], total[3], total[4]
    if total[5] < FEWEST:
        return
    det = ss * cc - sc * sc
    gain, contrast = -1.0, -1.0
    if det > 1e-9 * ss * cc:
        gain, contrast = (cc * sd - sc * cd) / det, (ss * cd - sc * sd) / det
    if gain < 0.0 or contrast < 0.0:
        gain, contrast = max(sd / ss, 0.0), max(cd / cc, 0.0)
        # the one that takes more off the sum of squares
        if gain * sd > contrast * cd:
            contrast = 0.0
        else:
            gain = 0.0
    noise[1], noise[2] = gain, contrast


@kernel
def rows_about(number: int, reach: int) -> int:
    """Rows about its peaks that a block has: the first was begun with enough for most widths."""
    return max(reach, USUAL_REACH) if number == 0 else reach


@vector_kernel
def tell_noise(
    pixels: Grey,
    width: int,
    columns: NDArray[np.int32],
    rows: NDArray[np.int32],
    reach: int,
    taken: int,
    saturated: np.float32,
    raw: Grey,
    blocks: Singles,
    profiles: Singles,
    noise: Singles,
) -> None:
    """How the noise grows with the signal, told by what fits to some of the peaks leave.

    Args:
        pixels, columns, rows, reach, saturated: see ``stripe_fit.fit_peaks``.
        taken: how many blocks are used.
        blocks, profiles: (BLOCKS, ...) room to work in; the first block is begun already, on
            ``USUAL_REACH`` rows.
        noise: (3,) the read noise, and a first guess of the others; filled.
    """
    for b in range(taken):
        far = rows_about(b, reach)
        block, profile = blocks[b], profiles[b]
        if b > 0 or far > USUAL_REACH:
            sample(pixels, width, columns, rows, b, taken, far, saturated, raw, block, profile)
        set_windows(block, profile[: LANES * (2 * far + 1)], far, saturated)
    sums = np.empty(6 * LANES, np.float32)
    for outlying in (np.inf, OUTLYING, OUTLYING):
        sums[:] = 0
        for b in range(taken):
            used = LANES * (2 * rows_about(b, reach) + 1)
            block, profile = blocks[b], profiles[b][:used]
            for lane in range(0, LANES, int(WIDTH)):
                at = np.uintp(lane)
                normal_equations(block, profile, noise, saturated, at)
                step(block, at)
                invert(block, at)
                moments(block, profile, noise, saturated, np.float32(outlying), sums, at)
        non_negative(sums, noise)
