"""The place of a step of brightness, from the pixels about it, with its standard deviation."""

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from app.metrology.compiled import kernel
from app.metrology.detection.edge_points import Stations
from app.metrology.frames import Floats

# The window reaches this far from the edge: so many blurs and pixels, at least three.
_REACH_BLURS, _REACH_PX, _LEAST_REACH_PX = 2.5, 1.0, 3.0
# A neighbouring edge's light reaches this many of its blurs.
_NEIGHBOUR_BLURS = 2.0
# What must be left of the window on either side.
_NEEDED_BLURS, _NEEDED_PX = 1.5, 0.5
# Grey levels squared: rounding alone scatters the pixels by a twelfth.
_LEAST_VARIANCE = 1.0 / 12.0
_TURNS = 10
# What of a scaled equation the others leave, from which on it says nothing new.
_SINGULAR = 1e-12


@dataclass(frozen=True)
class Measured:
    """What ``measure`` gives per station, arrays (N,); NaN where there is no sound edge.

    ``offset_px`` along the normal and its ``sigma_px``; ``step``: height in grey levels
    from the second region to the first, and its ``step_sigma``; ``blur_px``: the
    blur's standard deviation; ``noise``: the scatter of the pixels about the fit,
    grey levels.
    """

    offset_px: Floats
    sigma_px: Floats
    step: Floats
    step_sigma: Floats
    blur_px: Floats
    noise: Floats


# The Gaussian's integral, and its density, at every so much of its standard deviation.
_PER_SIGMA, _OUTERMOST = 128, 9
_NODES = np.arange(-_OUTERMOST * _PER_SIGMA, _OUTERMOST * _PER_SIGMA + 1) / _PER_SIGMA
_INTEGRAL = np.array([0.5 * math.erfc(-z / math.sqrt(2.0)) for z in _NODES])
_DENSITY = np.exp(-0.5 * _NODES**2) / math.sqrt(2.0 * math.pi)


@kernel
def _gaussian(z: float) -> tuple[float, float]:
    """Integral and density of the unit Gaussian at z: Taylor's series about the nearest node.

    Good to 1e-14. Without a branch or a call, so that the processor does several at a time.
    """
    inside = min(max(z, -_OUTERMOST + 0.001), _OUTERMOST - 0.001)
    node = np.int32(inside * _PER_SIGMA + _OUTERMOST * _PER_SIGMA + 0.5)
    at = node * (1 / _PER_SIGMA) - _OUTERMOST
    F, f, d = _INTEGRAL[node], _DENSITY[node], inside - at
    # Hermite's polynomials: the density's derivatives over the density.
    h2 = at * at - 1.0
    h3 = at * (at * at - 3.0)
    h4 = at * at * (at * at - 6.0) + 3.0
    integral = 1.0 + d * (
        at * (-1 / 2) + d * (h2 * (1 / 6) + d * (h3 * (-1 / 24) + d * h4 * (1 / 120)))
    )
    density = 1.0 + d * (-at + d * (h2 * (1 / 2) + d * (h3 * (-1 / 6) + d * h4 * (1 / 24))))
    return F + f * d * integral, f * density


@kernel
def _window_pixels(image: Floats, place: Floats, window: Floats, pixels: Floats) -> int:
    """Fills ``pixels`` (2, M): distance across the edge and grey level of each in the window.

    ``place``: u, v and unit normal; ``window``: reach along and against the normal, half
    length. Their count; 0: one of them is hidden, or out of the picture.
    """
    nu, nv = place[2], place[3]
    reach = math.ceil(math.hypot(max(window[0], window[1]), window[2]))
    row0, col0 = int(np.rint(place[1])) - reach, int(np.rint(place[0])) - reach
    if row0 < 0 or col0 < 0:
        return 0
    if row0 + 2 * reach >= image.shape[0] or col0 + 2 * reach >= image.shape[1]:
        return 0
    count = 0
    for row in range(row0, row0 + 2 * reach + 1):
        line = image[row]
        dv = row - place[1]
        for col in range(col0, col0 + 2 * reach + 1):
            du = col - place[0]
            across = du * nu + dv * nv
            if across > window[0] or across < -window[1] or abs(dv * nu - du * nv) > window[2]:
                continue
            if np.isnan(line[col]):
                return 0
            pixels[0, count], pixels[1, count] = across, line[col]
            count += 1
    return count


@kernel
def _derivatives(pixels: Floats, count: int, state: Floats, columns: Floats) -> None:
    """Fills ``columns`` (7, M): the pixels' residuals, and their derivatives by the state.

    A step blurred by a Gaussian, between two slopes: b + c x + (a + d x) F +
    d sigma^2 f with ``state`` = (b, a, c, d, the edge's offset, sigma), F and f the
    Gaussian's integral and density at x, the distance from the edge.
    """
    b, a, c, d, offset, sigma = state
    per_sigma = 1.0 / sigma
    for i in range(count):
        x = pixels[0, i] - offset
        F, f = _gaussian(x * per_sigma)
        f *= per_sigma
        ramp = x * F + sigma * sigma * f
        columns[0, i] = pixels[1, i] - (b + a * F + c * x + d * ramp)
        columns[1, i], columns[2, i], columns[3, i], columns[4, i] = 1.0, F, x, ramp
        columns[5, i] = -a * f - c - d * F
        columns[6, i] = -a * f * x * per_sigma + d * sigma * f


@kernel
def _products(columns: Floats, count: int, A: Floats) -> None:
    """Fills A, its lower half, with the sums over ``count`` of every two columns' products."""
    for p in range(len(A)):
        for q in range(p + 1):
            total = 0.0
            for i in range(count):
                total += columns[p, i] * columns[q, i]
            A[p, q] = total


@kernel
def _decomposed(A: Floats, size: int, scale: Floats, L: Floats) -> bool:
    """Cholesky's L of the leading ``size`` rows of A, scaled to a unit diagonal; whether it is.

    ``scale`` (6,): what rows and columns are multiplied by.
    """
    for p in range(size):
        scale[p] = 1.0 / math.sqrt(A[p, p]) if A[p, p] > 0.0 else 1e6
        for q in range(p + 1):
            rest = A[p, q] * scale[p] * scale[q] if p != q else 1.0
            for k in range(q):
                rest -= L[p, k] * L[q, k]
            if p != q:
                L[p, q] = rest / L[q, q]
            elif rest < _SINGULAR:
                return False
            else:
                L[p, p] = math.sqrt(rest)
    return True


@kernel
def _solved(L: Floats, size: int, scale: Floats, right: Floats, out: Floats) -> None:
    """Fills ``out`` with the solution for a right hand side (6,), by ``_decomposed``."""
    for p in range(size):
        rest = right[p] * scale[p]
        for k in range(p):
            rest -= L[p, k] * out[k]
        out[p] = rest / L[p, p]
    for p in range(size - 1, -1, -1):
        rest = out[p]
        for k in range(p + 1, size):
            rest -= L[k, p] * out[k]
        out[p] = rest / L[p, p]
    for p in range(size):
        out[p] *= scale[p]


@kernel
def _fit_step(
    pixels: Floats,
    count: int,
    furthest: float,
    blur: float,
    size: int,
    columns: Floats,
    found: Floats,
) -> None:
    """Gauss-Newton of one step; fills offset, sd, step, its sd, blur, noise, or leaves NaN.

    ``furthest``: from where the edge is expected; ``size``: 5, or 6 to fit the blur too;
    ``columns`` (7, M) is overwritten.
    """
    state = np.array([0.0, 0.0, 0.0, 0.0, 0.0, blur])
    # The squares' sum, then J^T r, then J^T J.
    products, L = np.empty((size + 1, size + 1)), np.empty((size, size))
    A, g = products[1:, 1:], products[1:, 0]
    scale, step = np.empty(size), np.empty(size)
    for turn in range(_TURNS):
        _derivatives(pixels, count, state, columns)
        _products(columns, count, products)
        # Brightness and slopes first; then the edge's place (and the blur) as well.
        free = 4 if turn == 0 else size
        if not _decomposed(A, free, scale, L):
            return
        _solved(L, free, scale, g, step)
        state[:4] += step[:4]
        if turn == 0:
            continue
        shift = min(max(step[4], -1.0), 1.0)
        state[4] += shift
        settled = abs(shift) < 1e-4
        if size == 6:
            settled = settled and abs(step[5]) < 1e-3 * state[5]
            state[5] = min(max(state[5] + step[5], 0.6 * state[5]), 1.6 * state[5])
        if abs(state[4]) > furthest or state[5] < 0.2:
            return
        if settled:
            break
    variance = max(products[0, 0] / (count - size), _LEAST_VARIANCE)
    # The place and the height, each with its deviation.
    for column, p in ((0, 4), (2, 1)):
        unit = np.zeros(size)
        unit[p] = 1.0
        _solved(L, size, scale, unit, step)
        found[column], found[column + 1] = state[p], math.sqrt(variance * step[p])
    found[4], found[5] = state[5], math.sqrt(variance)


@kernel
def _measure(
    image: Floats, places: Floats, windows: Floats, blur: float, free_blur: bool
) -> Floats:
    found = np.full((len(places), 6), np.nan)
    size = 6 if free_blur else 5
    widest = 0.0
    for window in windows:
        widest = max(widest, math.hypot(max(window[0], window[1]), window[2]))
    most = (2 * math.ceil(widest) + 1) ** 2
    pixels, columns = np.empty((2, most)), np.empty((7, most))
    for i in range(len(places)):
        window = windows[i]
        count = _window_pixels(image, places[i], window, pixels)
        if count >= 4 * size:
            furthest = 0.6 * max(window[0], window[1])
            _fit_step(pixels, count, furthest, blur, size, columns, found[i])
    return found


def with_room(at: Stations, blur_px: float) -> Stations:
    """The stations whose next edges are far enough for a blur of this standard deviation."""
    needed = (_NEIGHBOUR_BLURS + _NEEDED_BLURS) * blur_px + _NEEDED_PX
    return chosen(at, at.room_px.min(axis=1) >= needed)


def chosen(at: Stations, keep: NDArray[np.bool_] | NDArray[np.int64]) -> Stations:
    """Some of the stations."""
    return replace(
        at,
        edge=at.edge[keep],
        part=at.part[keep],
        points_mm=at.points_mm[keep],
        uv_px=at.uv_px[keep],
        normal=at.normal[keep],
        room_px=at.room_px[keep],
        length_px=at.length_px[keep],
    )


def joined(one: Stations, other: Stations) -> Stations:
    """The stations of both, of the same visible parts."""
    return replace(
        one,
        edge=np.concatenate([one.edge, other.edge]),
        part=np.concatenate([one.part, other.part]),
        points_mm=np.concatenate([one.points_mm, other.points_mm]),
        uv_px=np.concatenate([one.uv_px, other.uv_px]),
        normal=np.concatenate([one.normal, other.normal]),
        room_px=np.concatenate([one.room_px, other.room_px]),
        length_px=np.concatenate([one.length_px, other.length_px]),
    )


def measure(image: Floats, at: Stations, blur_px: float, free_blur: bool = False) -> Measured:
    """Sub-pixel edges at stations that lie within about two pixels, or two blurs, of them.

    Least squares on the pixels themselves: nothing is interpolated, so nothing
    depends on how an edge lies to the rows and columns.

    Args:
        image: (H, W) grey levels, NaN where they must not count.
        at: stations with room (``with_room``).
        blur_px: standard deviation of the picture's blur; fitted too if ``free_blur``.
    """
    reach = max(_LEAST_REACH_PX, _REACH_BLURS * blur_px + _REACH_PX)
    room = np.minimum(reach, at.room_px - _NEIGHBOUR_BLURS * blur_px)
    windows = np.column_stack([room, np.full(len(room), at.half_length_px)])
    places = np.column_stack([at.uv_px, at.normal])
    found = _measure(image, places, windows, blur_px, free_blur)
    return Measured(*(found[:, k] for k in range(6)))
