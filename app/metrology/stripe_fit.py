"""Fitting a Gaussian on a background to the peaks of many columns at once."""

import numpy as np
from numpy.typing import NDArray

from app.metrology.compiled import vector_kernel
from app.metrology.grey_lanes import Grey
from app.metrology.lanes import WIDTH, highest, load, store
from app.metrology.stripe_block import (
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
from app.metrology.stripe_normal import factored, normal_equations

FEWEST_PIXELS = np.float32(5)
# Half a width and half a height is the most that a step may move by.
LONGEST_STEP = np.float32(0.5)
# The longest step, in shares of the width, after which what is left to go is none: the
# next would be a tenth as long.
SETTLED = np.float32(0.08)
# Rows about some peaks that tell the usual width.
USUAL_REACH = 20
# Rows of the table of fits; the centre is counted from the peak's row on.
CENTRE, AMPLITUDE, SIGMA, VARIANCE, CHI2_OF, PIXELS, CLIPPED_OF, BECAME = range(8)
FIT_ROWS = 8
NARROWEST = np.float32(0.2)


@vector_kernel
def step(block: Singles, at: np.uintp) -> None:
    """Moves the parameters of the lanes from ``at`` on by one Gauss-Newton step.

    A lane whose fit leaves its window, or has no solution, is no peak and stays.
    """
    least = np.float32(1e-6)
    for i in range(at, at + WIDTH):
        d0, d1, d2, d3, c0, c1, c2, c3, l1, l2, l3, m2, m3, o3 = factored(block, i)
        y0 = block[G0 + i]
        y1 = block[G1 + i] - l1 * y0
        y2 = block[G2 + i] - l2 * y0 - m2 * y1
        y3 = block[G3 + i] - l3 * y0 - m3 * y1 - o3 * y2
        x3 = y3 * c3
        x2 = y2 * c2 - o3 * x3
        x1 = y1 * c1 - m2 * x2 - m3 * x3
        x0 = y0 * c0 - l1 * x1 - l2 * x2 - l3 * x3
        # the inverse's first element
        z2 = l1 * m2 - l2
        z3 = l1 * m3 - l3 - o3 * z2
        inverse = c0 + l1 * l1 * c1 + z2 * z2 * c2 + z3 * z3 * c3
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
def invert(block: Singles, at: np.uintp) -> None:
    """Puts the inverse of the normal matrix of the lanes from ``at`` on in the matrix's place."""
    for i in range(at, at + WIDTH):
        _, _, _, _, c0, c1, c2, c3, l1, l2, l3, m2, m3, o3 = factored(block, i)
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
def settle(
    block: Singles,
    profile: Singles,
    noise: Singles,
    saturated: np.float32,
    steps: int,
    at: np.uintp,
) -> None:
    """Steps until none of the lanes from ``at`` on moves further; which do need more room."""
    for _ in range(steps):
        normal_equations(block, profile, noise, saturated, at)
        step(block, at)
        if highest(load(block, MOVED + at)) < SETTLED:
            return
    for i in range(at, at + WIDTH):
        unsettled = block[MOVED + i] >= SETTLED
        block[STATE + i] = min(block[STATE + i], WIDER) if unsettled else block[STATE + i]


@vector_kernel
def sample(
    pixels: Grey,
    width: int,
    columns: NDArray[np.int32],
    rows: NDArray[np.int32],
    number: int,
    blocks: int,
    reach: int,
    saturated: np.float32,
    raw: Grey,
    block: Singles,
    profile: Singles,
) -> None:
    """Starts a block on some of the peaks, evenly taken: the ``number``-th of so many blocks."""
    n = len(columns)
    some_columns, some_rows = np.empty(LANES, np.int32), np.empty(LANES, np.int32)
    for i in range(LANES):
        one = (i * blocks + number) * n // (blocks * LANES)
        some_columns[i], some_rows[i] = columns[one], rows[one]
    gather(pixels, width, some_columns, some_rows, reach, raw, profile)
    start(block, profile, reach, saturated)


@vector_kernel
def usual_width(block: Singles) -> np.float32:
    """The median standard deviation of a block's peaks, by their width at half height."""
    found = 0
    widths = np.empty(LANES, np.float32)
    for i in range(np.uintp(LANES)):
        if block[STATE + i] == PEAK:
            widths[found] = block[S + i]
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
    fits: Singles,
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
        fits: (FIT_ROWS, whole blocks) filled in the order CENTRE ... BECAME.
    """
    n = len(columns)
    for b in range(0, n, LANES):
        end = min(b + LANES, n)
        gather(pixels, width, columns[b:end], rows[b:end], reach, raw, profile)
        part = profile[: LANES * (2 * reach + 1)]
        start(block, part, reach, saturated)
        set_windows(block, part, reach, saturated)
        for at in range(0, LANES, int(WIDTH)):
            settle(block, part, noise, saturated, steps, np.uintp(at))
        keep(block, reach, fits, b)


@vector_kernel
def keep(block: Singles, reach: int, fits: Singles, first: int) -> None:
    """Puts what became of a block's peaks into the table of fits, from column ``first`` on."""
    table, row, middle = fits.reshape(-1), fits.shape[1], np.float32(reach)
    for lane in range(0, LANES, int(WIDTH)):
        at = np.uintp(lane)
        store(table, np.uintp(CENTRE * row + first) + at, load(block, C + at) - middle)
        store(table, np.uintp(AMPLITUDE * row + first) + at, load(block, A + at))
        store(table, np.uintp(SIGMA * row + first) + at, load(block, S + at))
        store(table, np.uintp(VARIANCE * row + first) + at, load(block, VAR + at))
        store(table, np.uintp(CHI2_OF * row + first) + at, load(block, CHI2 + at))
        store(table, np.uintp(PIXELS * row + first) + at, load(block, USED + at))
        store(table, np.uintp(CLIPPED_OF * row + first) + at, load(block, CLIPPED + at))
        store(table, np.uintp(BECAME * row + first) + at, load(block, STATE + at))
