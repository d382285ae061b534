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


@kernel
def _terms(x: float, sigma: float, beta: Floats, J: Floats) -> float:
    """The model at x from the edge, and its derivatives J (6,).

    A step blurred by a Gaussian, between two slopes: b + c x + (a + d x) F +
    d sigma^2 f with beta = (b, a, c, d), F and f the Gaussian's integral and density;
    then the derivatives to the edge's place and to sigma.
    """
    F = 0.5 * math.erfc(-0.7071067811865476 * x / sigma)
    f = 0.3989422804014327 * math.exp(-0.5 * (x / sigma) ** 2) / sigma
    ramp = x * F + sigma * sigma * f
    J[0], J[1], J[2], J[3] = 1.0, F, x, ramp
    J[4] = -beta[1] * f - beta[2] - beta[3] * F
    J[5] = -beta[1] * f * x / sigma + beta[3] * sigma * f
    return float(beta[0] + beta[1] * F + beta[2] * x + beta[3] * ramp)


@kernel
def _gather(
    image: Floats, place: Floats, window: Floats, state: Floats, A: Floats, g: Floats
) -> tuple[int, float]:
    """Normal equations A (6, 6), g (6,) over the window's pixels; their count and squares.

    ``place``: u, v and unit normal; ``window``: reach along and against the normal, half
    length; ``state``: beta (4), the edge's offset, sigma. A count of -1: a pixel of the
    window is hidden, or out of the picture.
    """
    nu, nv = place[2], place[3]
    reach = math.ceil(math.hypot(max(window[0], window[1]), window[2]))
    row0, col0 = int(np.rint(place[1])) - reach, int(np.rint(place[0])) - reach
    if row0 < 0 or col0 < 0:
        return -1, 0.0
    if row0 + 2 * reach >= image.shape[0] or col0 + 2 * reach >= image.shape[1]:
        return -1, 0.0
    A[:] = 0.0
    g[:] = 0.0
    J = np.empty(6)
    used, squares = 0, 0.0
    for row in range(row0, row0 + 2 * reach + 1):
        line = image[row]
        dv = row - place[1]
        for col in range(col0, col0 + 2 * reach + 1):
            du = col - place[0]
            across = du * nu + dv * nv
            if across > window[0] or across < -window[1] or abs(dv * nu - du * nv) > window[2]:
                continue
            if np.isnan(line[col]):
                return -1, 0.0
            off = line[col] - _terms(across - state[4], state[5], state, J)
            squares += off * off
            used += 1
            for p in range(6):
                g[p] += J[p] * off
                for q in range(p + 1):
                    A[p, q] += J[p] * J[q]
    for p in range(6):
        for q in range(p):
            A[q, p] = A[p, q]
    return used, squares


@kernel
def _fit_step(
    image: Floats, place: Floats, window: Floats, blur: float, size: int, found: Floats
) -> None:
    """Gauss-Newton of one step; fills offset, sd, step, its sd, blur, noise, or leaves NaN."""
    state = np.array([0.0, 0.0, 0.0, 0.0, 0.0, blur])
    A, g = np.empty((6, 6)), np.empty(6)
    for turn in range(_TURNS):
        used, squares = _gather(image, place, window, state, A, g)
        if used < 4 * size:
            return
        # Brightness and slopes first; then the edge's place (and the blur) as well.
        free = 4 if turn == 0 else size
        inverse = np.eye(size)
        for p in range(size):
            if not A[p, p] > 0.0:
                A[p, p] = 1e-12
        scale = 1.0 / np.sqrt(np.diag(A)[:free])
        scaled = A[:free, :free] * np.outer(scale, scale)
        if np.linalg.cond(scaled) > 1e12:
            return
        inverse = np.linalg.inv(scaled) * np.outer(scale, scale)
        step = inverse @ g[:free]
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
    variance = max(squares / (used - size), _LEAST_VARIANCE)
    found[0], found[1] = state[4], np.sqrt(variance * inverse[4, 4])
    found[2], found[3] = state[1], np.sqrt(variance * inverse[1, 1])
    found[4], found[5] = state[5], np.sqrt(variance)


@kernel
def _measure(
    image: Floats, places: Floats, windows: Floats, blur: float, free_blur: bool
) -> Floats:
    found = np.full((len(places), 6), np.nan)
    for i in range(len(places)):
        _fit_step(image, places[i], windows[i], blur, 6 if free_blur else 5, found[i])
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
