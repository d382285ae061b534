"""The normal equations of Gaussians on a background, of many columns at once."""

import numpy as np

from app.metrology.compiled import vector_kernel
from app.metrology.lanes import Lanes, all_lanes, load, store, where
from app.metrology.stripe_block import (
    ALL,
    CHI2,
    FIRST,
    G0,
    G1,
    G2,
    G3,
    LAST,
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
    TWO,
    USED,
    A,
    B,
    C,
    S,
    Singles,
    rows_used,
)

F = np.float32
Factors = tuple[F, F, F, F, F, F, F, F, F, F, F, F, F, F]


@vector_kernel
def exponential(a: Lanes) -> Lanes:
    """``exp(a)`` of -12 to 12, to five digits where it counts: a polynomial's sixteenth power."""
    farthest = np.float32(0.75)
    x = a * np.float32(1 / 16)
    x = where(x > -farthest, x, all_lanes(-farthest))
    x = where(x < farthest, x, all_lanes(farthest))
    y = x * np.float32(1 / 120) + np.float32(1 / 24)
    y = (((y * x + np.float32(1 / 6)) * x + np.float32(0.5)) * x + np.float32(1)) * x
    y = y + np.float32(1)
    y = y * y
    y = y * y
    y = y * y
    return y * y


@vector_kernel
def bell(t: Lanes) -> Lanes:
    """``exp(-t^2 / 2)``; see ``exponential``."""
    return exponential(t * t * np.float32(-0.5))


@vector_kernel
def normal_equations(
    block: Singles, profile: Singles, noise: Singles, saturated: np.float32, at: np.uintp
) -> None:
    """Fills the normal equations, chi squared and number of pixels of the lanes from ``at`` on.

    In shares of the lane's own height and width, so that all terms are about one. From the
    middle row outwards, the Gaussian of a row is that of the row before times a factor, which
    itself changes by the same factor from row to row.

    Args:
        noise: (3,) the variance of a pixel at signal s is
            ``noise[0] + noise[1] s + noise[2] s^2``.
    """
    zero, one = all_lanes(np.float32(0)), all_lanes(np.float32(1))
    half = np.float32(0.5)
    per_height = one / load(block, A + at)
    n0, n1 = per_height * per_height * noise[0], per_height * noise[1]
    n2 = all_lanes(noise[2])
    background = load(block, B + at) * per_height
    apart = one / load(block, S + at)
    centre = load(block, C + at)
    first = (load(block, FIRST + at) - half - centre) * apart
    last = (load(block, LAST + at) + half - centre) * apart
    begin, end = rows_used(block, profile, at)
    middle = min(max(np.uintp(len(profile)) // ALL // TWO, begin), end)
    there = (all_lanes(np.float32(middle)) - centre) * apart
    slope, bend = exponential(zero - there * apart), exponential(apart * apart * -half)
    top, fall = bell(there), bend * bend
    n00 = n10 = n11 = n20 = n22 = n30 = n31 = n32 = n33 = zero
    g0 = g1 = g2 = g3 = chi2 = used = zero
    for way in range(2):
        if way == 0:
            rows, k, further = end + ONE - middle, middle, ONE
            t, e, factor = there, top, slope * bend
        else:
            rows, k, further = middle - begin, middle - ONE, np.uintp(0) - ONE
            factor = bend / slope
            t, e = there - apart, top * factor
            apart, factor = zero - apart, factor * fall
        for _ in range(rows):
            pixel = load(profile, k * ALL + at)
            counts = (t >= first) & (t <= last) & (pixel < saturated)
            weight = where(counts, one / (e * (e * n2 + n1) + n0), zero)
            used = used + where(counts, one, zero)
            left = pixel * per_height - background - e
            pull = weight * left
            chi2 = chi2 + pull * left
            et = e * t
            ett = et * t
            wet, we, wett = weight * et, weight * e, weight * ett
            n00, n10, n11 = n00 + wet * et, n10 + wet * e, n11 + we * e
            n20, n22 = n20 + wett * et, n22 + wett * ett
            n30, n31, n32, n33 = n30 + wet, n31 + we, n32 + wett, n33 + weight
            g0, g1, g2, g3 = g0 + pull * et, g1 + pull * e, g2 + pull * ett, g3 + pull
            t, e, factor = t + apart, e * factor, factor * fall
            k += further
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
    """A lane's normal matrix as ``L D L'``: D, its inverse, and L below its ones by columns."""
    one = np.float32(1)
    d0 = block[N00 + i]
    c0 = one / d0
    l1, l2, l3 = block[N10 + i] * c0, block[N20 + i] * c0, block[N30 + i] * c0
    d1 = block[N11 + i] - l1 * block[N10 + i]
    c1 = one / d1
    m2 = (block[N21 + i] - l1 * block[N20 + i]) * c1
    m3 = (block[N31 + i] - l1 * block[N30 + i]) * c1
    d2 = block[N22 + i] - l2 * block[N20 + i] - m2 * m2 * d1
    c2 = one / d2
    o3 = (block[N32 + i] - l2 * block[N30 + i] - m2 * m3 * d1) * c2
    d3 = block[N33 + i] - l3 * block[N30 + i] - m3 * m3 * d1 - o3 * o3 * d2
    return d0, d1, d2, d3, c0, c1, c2, one / d3, l1, l2, l3, m2, m3, o3
