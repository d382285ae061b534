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


# The Gaussian's integral and density at every so much of its standard deviation.
_NODES_PER_SIGMA, _OUTERMOST = 128, 9
_NODES = np.array(
    [
        (0.5 * math.erfc(-z / math.sqrt(2.0)), math.exp(-0.5 * z * z) / math.sqrt(2.0 * math.pi))
        for z in np.arange(-_OUTERMOST * _NODES_PER_SIGMA, _OUTERMOST * _NODES_PER_SIGMA + 1)
        / _NODES_PER_SIGMA
    ]
)


@kernel
def _gaussian(z: float) -> tuple[float, float]:
    """Integral and density of the unit Gaussian at z: Taylor's series about the nearest node.

    Good to 1e-14, in a quarter of the time of ``erfc`` and ``exp``.
    """
    if abs(z) >= _OUTERMOST:
        return (1.0 if z > 0 else 0.0), 0.0
    node = int(np.rint(z * _NODES_PER_SIGMA))
    at = node / _NODES_PER_SIGMA
    d = z - at
    F, f = _NODES[node + _OUTERMOST * _NODES_PER_SIGMA]
    # Hermite's polynomials: the density's derivatives over the density.
    h2 = at * at - 1.0
    h3 = at * (at * at - 3.0)
    h4 = at * at * (at * at - 6.0) + 3.0
    integral = F + f * d * (1.0 + d * (-at / 2 + d * (h2 / 6 + d * (-h3 / 24 + d * h4 / 120))))
    return integral, f * (1.0 + d * (-at + d * (h2 / 2 + d * (-h3 / 6 + d * h4 / 24))))


@kernel
def _window_pixels(image: Floats, place: Floats, window: Floats, pixels: Floats) -> int:
    """Fills ``pixels`` (M, 2): distance across the edge and grey level of each in the window.

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
            pixels[count, 0], pixels[count, 1] = across, line[col]
            count += 1
    return count


@kernel
def _normal_equations(pixels: Floats, state: Floats, size: int) -> Floats:
    """J^T J, J^T r and r^T r of the pixels' residuals r, as one (size + 1, size + 1).

    A step blurred by a Gaussian, between two slopes: b + c x + (a + d x) F +
    d sigma^2 f with ``state`` = (b, a, c, d, the edge's offset, sigma), F and f the
    Gaussian's integral and density at x, the distance from the edge. J by the first
    ``size`` of them.
    """
    rows = np.empty((len(pixels), size + 1))
    b, a, c, d, offset, sigma = state
    for i in range(len(pixels)):
        row = rows[i]
        x = pixels[i, 0] - offset
        F, f = _gaussian(x / sigma)
        f /= sigma
        ramp = x * F + sigma * sigma * f
        row[0], row[1], row[2], row[3] = 1.0, F, x, ramp
        row[4] = -a * f - c - d * F
        if size == 6:
            row[5] = -a * f * x / sigma + d * sigma * f
        row[size] = pixels[i, 1] - (b + a * F + c * x + d * ramp)
    products: Floats = np.dot(rows.T, rows)
    return products


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
def _fit_step(pixels: Floats, window: Floats, blur: float, size: int, found: Floats) -> None:
    """Gauss-Newton of one step; fills offset, sd, step, its sd, blur, noise, or leaves NaN."""
    state = np.array([0.0, 0.0, 0.0, 0.0, 0.0, blur])
    A, L = np.zeros((size + 1, size + 1)), np.empty((size, size))
    scale, step = np.empty(size), np.empty(size)
    for turn in range(_TURNS):
        A = _normal_equations(pixels, state, size)
        # Brightness and slopes first; then the edge's place (and the blur) as well.
        free = 4 if turn == 0 else size
        if not _decomposed(A, free, scale, L):
            return
        _solved(L, free, scale, A[size], step)
        state[:4] += step[:4]
        if turn == 0:
            continue
        shift = min(max(step[4], -1.0), 1.0)
        state[4] += shift
        settled = abs(shift) < 1e-4
        if size == 6:
            settled = settled and abs(step[5]) < 1e-3 * state[5]
            state[5] = min(max(state[5] + step[5], 0.6 * state[5]), 1.6 * state[5])
        if abs(state[4]) > 0.6 * max(window[0], window[1]) or state[5] < 0.2:
            return
        if settled:
            break
    variance = max(A[size, size] / (len(pixels) - size), _LEAST_VARIANCE)
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
    pixels = np.empty(((2 * math.ceil(widest) + 1) ** 2, 2))
    for i in range(len(places)):
        count = _window_pixels(image, places[i], windows[i], pixels)
        if count >= 4 * size:
            _fit_step(pixels[:count], windows[i], blur, size, found[i])
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
