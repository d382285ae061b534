"""Fitting a Gaussian on a background to the peaks of many columns at once."""

import numpy as np
from numpy.typing import NDArray

from app.metrology.compiled import vector_kernel
from app.metrology.frames import Floats
from app.metrology.lanes import WIDTH, Lanes, all_lanes, load, store, where
from app.metrology.stripe_block import (
    ALL,
    CHI2,
    CLIPPED,
    FIRST,
    G0,
    G1,
    G2,
    G3,
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
    NO_PEAK,
    ONE,
    PEAK,
    STATE,
    USED,
    VAR,
    WIDER,
    A,
    B,
    C,
    S,
    Singles,
    gather,
    set_windows,
    start,
)
from app.metrology.stripe_search import Grey

F = np.float32
Factors = tuple[F, F, F, F, F, F, F, F, F, F]

FEWEST_PIXELS = np.float32(5)
# Half a width and half a height is the most that a step may move by.
LONGEST_STEP = np.float32(0.5)
# The longest step, in shares of the width, after which what is left to go is none: the
# next would be a tenth as long.
SETTLED = np.float32(0.05)
# Rows about some peaks that tell the usual width.
USUAL_REACH = 20
# Rows of the table of fits.
CENTRE, AMPLITUDE, SIGMA, BACKGROUND, VARIANCE, CHI2_OF, PIXELS, CLIPPED_OF, BECAME = range(9)
NARROWEST = np.float32(0.2)


@vector_kernel
def bell(t: Lanes) -> Lanes:
    """``exp(-t^2 / 2)``, to five digits where it counts: a polynomial's sixteenth power."""
    x = t * t * np.float32(-0.5 / 16)
    x = where(x > np.float32(-0.75), x, all_lanes(np.float32(-0.75)))
    y = x * np.float32(1 / 120) + np.float32(1 / 24)
    y = (((y * x + np.float32(1 / 6)) * x + np.float32(0.5)) * x + np.float32(1)) * x
    y = y + np.float32(1)
    y = y * y
    y = y * y
    y = y * y
    return y * y


@vector_kernel
def rows_used(block: Singles, profile: Singles, at: np.uintp) -> tuple[np.uintp, np.uintp]:
    """First row of a profile that the fit of any of the lanes from ``at`` on takes, and last."""
    first, last = block[FIRST + at], block[LAST + at]
    for i in range(at, at + WIDTH):
        first, last = min(first, block[FIRST + i]), max(last, block[LAST + i])
    end = min(np.uintp(max(last, np.float32(0))), np.uintp(len(profile)) // ALL - ONE)
    return np.uintp(max(first, np.float32(0))), end


@vector_kernel
def normal_equations(
    block: Singles, profile: Singles, noise: Singles, saturated: np.float32
) -> None:
    """Fills every lane's normal equations, chi squared and number of pixels.

    In shares of the lane's own height and width, so that all terms are about one.

    Args:
        noise: (3,) the variance of a pixel at signal s is
            ``noise[0] + noise[1] s + noise[2] s^2``.
    """
    for at in range(0, ALL, WIDTH):
        add_up(block, profile, noise, saturated, np.uintp(at))


@vector_kernel
def add_up(
    block: Singles, profile: Singles, noise: Singles, saturated: np.float32, at: np.uintp
) -> None:
    """The normal equations of the lanes from ``at`` on; see ``normal_equations``."""
    zero, one = all_lanes(np.float32(0)), all_lanes(np.float32(1))
    n0, n1, n2 = noise[0], noise[1], noise[2]
    centre, background = load(block, C + at), load(block, B + at)
    height = load(block, A + at)
    per_height, per_width = one / height, one / load(block, S + at)
    first, last = load(block, FIRST + at), load(block, LAST + at)
    n00 = n10 = n11 = n20 = n22 = n30 = n31 = n32 = n33 = zero
    g0 = g1 = g2 = g3 = chi2 = used = zero
    k, end = rows_used(block, profile, at)
    while k <= end:
        x = all_lanes(np.float32(k))
        pixel = load(profile, k * ALL + at)
        t = (x - centre) * per_width
        e = bell(t)
        signal = height * e
        counts = (x >= first) & (x <= last) & (pixel < saturated)
        weight = where(counts, one / (signal * (signal * n2 + n1) + n0), zero)
        left = pixel - background - signal
        chi2 = chi2 + weight * left * left
        used = used + where(counts, one, zero)
        weight = weight * height * height
        left = left * per_height
        et = e * t
        ett = et * t
        wet, we, wett = weight * et, weight * e, weight * ett
        n00, n10, n11 = n00 + wet * et, n10 + wet * e, n11 + we * e
        n20, n22 = n20 + wett * et, n22 + wett * ett
        n30, n31, n32, n33 = n30 + wet, n31 + we, n32 + wett, n33 + weight
        g0, g1, g2, g3 = g0 + wet * left, g1 + we * left, g2 + wett * left, g3 + weight * left
        k += ONE
    store(block, N00 + at, n00)
    store(block, N10 + at, n10)
    store(block, N11 + at, n11)
    store(block, N20 + at, n20)
    # the same product of three: (e t^2) e is (e t) (e t)
    store(block, N21 + at, n00)
    store(block, N22 + at, n22)
    store(block, N30 + at, n30)
    store(block, N31 + at, n31)
    store(block, N32 + at, n32)
    store(block, N33 + at, n33)
    store(block, G0 + at, g0)
    store(block, G1 + at, g1)
    store(block, G2 + at, g2)
    store(block, G3 + at, g3)
    store(block, CHI2 + at, chi2)
    store(block, USED + at, used)


@vector_kernel
def factored(block: Singles, i: int) -> Factors:
    """A lane's normal matrix as ``L D L'``: the four of D, then L below its ones, by columns."""
    d0 = block[N00 + i]
    l1, l2, l3 = block[N10 + i] / d0, block[N20 + i] / d0, block[N30 + i] / d0
    d1 = block[N11 + i] - l1 * block[N10 + i]
    m2 = (block[N21 + i] - l1 * block[N20 + i]) / d1
    m3 = (block[N31 + i] - l1 * block[N30 + i]) / d1
    d2 = block[N22 + i] - l2 * block[N20 + i] - m2 * m2 * d1
    o3 = (block[N32 + i] - l2 * block[N30 + i] - m2 * m3 * d1) / d2
    d3 = block[N33 + i] - l3 * block[N30 + i] - m3 * m3 * d1 - o3 * o3 * d2
    return d0, d1, d2, d3, l1, l2, l3, m2, m3, o3


@vector_kernel
def step(block: Singles) -> None:
    """Moves every lane's parameters by one Gauss-Newton step.

    A lane whose fit leaves its window, or has no solution, is no peak and stays.
    """
    least = np.float32(1e-6)
    for i in range(ALL):
        d0, d1, d2, d3, l1, l2, l3, m2, m3, o3 = factored(block, i)
        y0 = block[G0 + i]
        y1 = block[G1 + i] - l1 * y0
        y2 = block[G2 + i] - l2 * y0 - m2 * y1
        y3 = block[G3 + i] - l3 * y0 - m3 * y1 - o3 * y2
        x3 = y3 / d3
        x2 = y2 / d2 - o3 * x3
        x1 = y1 / d1 - m2 * x2 - m3 * x3
        x0 = y0 / d0 - l1 * x1 - l2 * x2 - l3 * x3
        # the inverse's first element
        z2 = l1 * m2 - l2
        z3 = l1 * m3 - l3 - o3 * z2
        inverse = np.float32(1) / d0 + l1 * l1 / d1 + z2 * z2 / d2 + z3 * z3 / d3
        sound = (d0 > 0) & (d1 > least * block[N11 + i]) & (d2 > least * block[N22 + i])
        sound &= (d3 > least * block[N33 + i]) & (block[USED + i] >= FEWEST_PIXELS)
        largest = max(max(abs(x0), abs(x2)), np.float32(0.5) * abs(x1))
        share = min(np.float32(1), LONGEST_STEP / max(largest, np.float32(1e-9)))
        width, height = block[S + i], block[A + i]
        centre = block[C + i] + share * x0 * width
        wider = width * (np.float32(1) + share * x2)
        higher = height * (np.float32(1) + share * x1)
        sound &= (wider >= NARROWEST) & (higher > 0)
        sound &= (centre >= block[FIRST + i]) & (centre <= block[LAST + i])
        moving = sound & (block[STATE + i] == PEAK)
        block[STATE + i] = block[STATE + i] if moving else min(block[STATE + i], WIDER)
        block[STATE + i] = block[STATE + i] if sound else NO_PEAK
        block[C + i] = centre if moving else block[C + i]
        block[S + i] = wider if moving else width
        block[A + i] = higher if moving else height
        block[B + i] = block[B + i] + share * x3 * height if moving else block[B + i]
        block[MOVED + i] = largest if moving else np.float32(0)
        block[VAR + i] = inverse * width * width


@vector_kernel
def invert(block: Singles) -> None:
    """Puts the inverse of every lane's normal matrix in the matrix's place."""
    one = np.float32(1)
    for i in range(ALL):
        d0, d1, d2, d3, l1, l2, l3, m2, m3, o3 = factored(block, i)
        c0, c1, c2, c3 = one / d0, one / d1, one / d2, one / d3
        # the inverse of L in N = L D L'
        z20 = m2 * l1 - l2
        z31 = o3 * m2 - m3
        z30 = m3 * l1 - l3 - o3 * z20
        block[N00 + i] = c0 + l1 * l1 * c1 + z20 * z20 * c2 + z30 * z30 * c3
        block[N10 + i] = z30 * z31 * c3 - l1 * c1 - z20 * m2 * c2
        block[N11 + i] = c1 + m2 * m2 * c2 + z31 * z31 * c3
        block[N20 + i] = z20 * c2 - z30 * o3 * c3
        block[N21 + i] = -m2 * c2 - z31 * o3 * c3
        block[N22 + i] = c2 + o3 * o3 * c3
        block[N30 + i] = z30 * c3
        block[N31 + i] = z31 * c3
        block[N32 + i] = -o3 * c3
        block[N33 + i] = c3


@vector_kernel
def farthest(block: Singles) -> np.float32:
    """The longest of all lanes' last steps."""
    longest = np.float32(0)
    for i in range(ALL):
        longest = max(longest, block[MOVED + i])
    return longest


@vector_kernel
def settle(
    block: Singles, profile: Singles, noise: Singles, saturated: np.float32, steps: int
) -> None:
    """Steps until no lane moves further; those that still do need more room."""
    for _ in range(steps):
        normal_equations(block, profile, noise, saturated)
        step(block)
        if farthest(block) < SETTLED:
            return
    for i in range(ALL):
        unsettled = block[MOVED + i] >= SETTLED
        block[STATE + i] = min(block[STATE + i], WIDER) if unsettled else block[STATE + i]


@vector_kernel
def usual_width(
    pixels: Grey,
    width: int,
    columns: NDArray[np.int32],
    rows: NDArray[np.int32],
    saturated: np.float32,
    raw: Grey,
    block: Singles,
    profile: Singles,
) -> np.float32:
    """The median standard deviation of some of the peaks, by their width at half height."""
    n = len(columns)
    taken = min(n, LANES)
    some_columns, some_rows = np.empty(taken, np.int32), np.empty(taken, np.int32)
    for i in range(taken):
        some_columns[i], some_rows[i] = columns[i * n // taken], rows[i * n // taken]
    gather(pixels, width, some_columns, some_rows, USUAL_REACH, raw, profile)
    start(block, profile, USUAL_REACH, saturated)
    found = 0
    widths = np.empty(taken, np.float32)
    for i in range(taken):
        if block[STATE + np.uintp(i)] == PEAK:
            widths[found] = block[S + np.uintp(i)]
            found += 1
    return np.float32(np.sort(widths[:found])[found // 2]) if found else np.float32(1)


@vector_kernel
def fit_peaks(
    pixels: Grey,
    width: int,
    columns: NDArray[np.int32],
    rows: NDArray[np.int32],
    reach: int,
    noise: Singles,
    saturated: np.float32,
    steps: int,
    raw: Grey,
    block: Singles,
    profile: Singles,
    fits: Floats,
) -> None:
    """Fits every peak.

    Args:
        pixels: (H W,) the image's pixels.
        columns, rows: (n,) where the peaks are, to a row or two.
        reach: rows about them that are looked at.
        noise: see ``normal_equations``.
        saturated: the grey level from which a pixel is clipped.
        steps: Gauss-Newton steps at most.
        raw, block, profile: room to work in, for ``WIDEST_REACH``.
        fits: (9, n) filled, in the order CENTRE ... BECAME.
    """
    n = len(columns)
    for b in range(0, n, LANES):
        end = min(b + LANES, n)
        gather(pixels, width, columns[b:end], rows[b:end], reach, raw, profile)
        part = profile[: LANES * (2 * reach + 1)]
        start(block, part, reach, saturated)
        set_windows(block, part, reach, saturated)
        settle(block, part, noise, saturated, steps)
        for i in range(end - b):
            lane, to = np.uintp(i), b + i
            fits[CENTRE][to] = rows[to] - reach + np.float64(block[C + lane])
            fits[AMPLITUDE][to] = block[A + lane]
            fits[SIGMA][to] = block[S + lane]
            fits[BACKGROUND][to] = block[B + lane]
            fits[VARIANCE][to] = block[VAR + lane]
            fits[CHI2_OF][to] = block[CHI2 + lane]
            fits[PIXELS][to] = block[USED + lane]
            fits[CLIPPED_OF][to] = block[CLIPPED + lane]
            fits[BECAME][to] = block[STATE + lane]
