"""Sub-pixel points on the block's edges in a picture, searched where a camera predicts them."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.metrology.camera import Camera, project
from app.metrology.compiled import kernel
from app.metrology.frames import Floats
from app.metrology.visibility import Wireframe, seen

# Half the length along the edge, in pixels, over which one point gathers light.
HALF_LENGTH_PX = 2.5


@dataclass(frozen=True)
class Stations:
    """Places along the visible edges at which the picture is to be measured.

    Arrays of one length N: ``edge`` (row in the wireframe), ``part`` (visible part),
    ``points_mm`` (N, 3), ``uv_px`` (N, 2) where they are expected, ``normal`` (N, 2)
    unit, towards the part's first region, ``room_px`` (N, 2) distance along
    and against the normal to the next edge, ``length_px`` (N,) of edge each stands for.
    ``regions`` (parts, 2): what adjoins each part.
    """

    edge: NDArray[np.int64]
    part: NDArray[np.int64]
    points_mm: Floats
    uv_px: Floats
    normal: Floats
    room_px: Floats
    length_px: Floats
    regions: NDArray[np.int64]


@kernel
def _room(
    uv: Floats, normal: Floats, part: NDArray[np.int64], ends: Floats
) -> Floats:  # pragma: no cover - compiled
    """Distances (N, 2) along and against each normal to the nearest other part (P, 4)."""
    room = np.full((len(uv), 2), np.inf)
    for i in range(len(uv)):
        nu, nv = normal[i, 0], normal[i, 1]
        for p in range(len(ends)):
            if p == part[i]:
                continue
            row = ends[p]
            du, dv = row[2] - row[0], row[3] - row[1]
            det = nu * dv - nv * du
            length = np.sqrt(du * du + dv * dv)
            if abs(det) < 1e-6 * length:
                continue
            ru, rv = row[0] - uv[i, 0], row[1] - uv[i, 1]
            along = (nv * ru - nu * rv) / det
            reach = HALF_LENGTH_PX / length
            if along < -reach or along > 1.0 + reach:
                continue
            away = (ru * dv - rv * du) / det
            if away >= 0:
                room[i, 0] = min(room[i, 0], away)
            else:
                room[i, 1] = min(room[i, 1], -away)
    return room


def stations(frame: Wireframe, camera: Camera, spacing_px: float, margin_px: float) -> Stations:
    """Stations every ``spacing_px`` along all edges that ``camera`` sees in its picture.

    They keep ``margin_px`` from the ends of each visible part, where other edges meet it.
    """
    parts = seen(frame, camera.centre_mm)
    begin, along = frame.starts_mm[parts.edge], (frame.ends_mm - frame.starts_mm)[parts.edge]
    first = begin + parts.start[:, None] * along
    last = begin + parts.end[:, None] * along
    both = project(camera, np.vstack([first, last]))
    ends = np.column_stack([both[: len(first)], both[len(first) :]])
    length = np.hypot(ends[:, 2] - ends[:, 0], ends[:, 3] - ends[:, 1])
    usable = length - 2 * margin_px
    count = np.where(usable > 0, np.maximum(np.rint(usable / spacing_px), 1), 0).astype(np.int64)
    count[~np.isfinite(length)] = 0
    part = np.repeat(np.arange(len(count)), count)
    within = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    share = (margin_px + (within + 0.5) * (usable / np.maximum(count, 1))[part]) / length[part]
    points = first[part] + share[:, None] * (last - first)[part]
    uv = project(camera, points)
    step = project(camera, points + 1e-3 * (last - first)[part]) - uv
    tangent = step / np.linalg.norm(step, axis=1, keepdims=True)
    normal = np.column_stack([-tangent[:, 1], tangent[:, 0]])
    edge_of_frame = HALF_LENGTH_PX + 1
    limit = np.array([camera.width_px, camera.height_px]) - 1 - edge_of_frame
    inside = np.all((uv >= edge_of_frame) & (uv <= limit), axis=1)
    room = _room(uv[inside], normal[inside], part[inside], ends)
    return Stations(
        parts.edge[part][inside],
        part[inside],
        points[inside],
        uv[inside],
        normal[inside],
        room,
        (usable / np.maximum(count, 1))[part][inside],
        parts.regions,
    )


@kernel
def _bilinear(image: Floats, u: float, v: float) -> float:  # pragma: no cover - compiled
    column, row = int(np.floor(u)), int(np.floor(v))
    if column < 0 or row < 0 or column >= image.shape[1] - 1 or row >= image.shape[0] - 1:
        return np.nan
    a, b = u - column, v - row
    upper, lower = image[row], image[row + 1]
    above = (1 - a) * upper[column] + a * upper[column + 1]
    below = (1 - a) * lower[column] + a * lower[column + 1]
    return float((1 - b) * above + b * below)


@kernel
def _search(
    image: Floats, uv: Floats, normal: Floats, room: Floats, radius: float
) -> Floats:  # pragma: no cover - compiled
    """Per station: offset along the normal and slope (grey levels per pixel) of the steepest place.

    Rows of NaN where the picture has no value. The search stops halfway to the next edge.
    """
    found = np.full((len(uv), 2), np.nan)
    reach = int(np.ceil(radius)) + 2
    profile = np.empty(2 * reach + 1)
    slope = np.empty(2 * reach + 1)
    for i in range(len(uv)):
        nu, nv = normal[i, 0], normal[i, 1]
        for k in range(2 * reach + 1):
            u, v = uv[i, 0] + (k - reach) * nu, uv[i, 1] + (k - reach) * nv
            total = 0.0
            for j in range(-1, 2):
                total += _bilinear(image, u - 1.5 * j * nv, v + 1.5 * j * nu)
            profile[k] = total / 3.0
        high = min(radius, max(0.5 * room[i, 0], 1.0))
        low = -min(radius, max(0.5 * room[i, 1], 1.0))
        best, at = -1.0, -1
        for k in range(1, 2 * reach):
            slope[k] = 0.5 * (profile[k + 1] - profile[k - 1])
        for k in range(2, 2 * reach - 1):
            offset = k - reach
            if low <= offset <= high and abs(slope[k]) > best:
                best, at = abs(slope[k]), k
        if at < 0:
            continue
        left, right = abs(slope[at - 1]), abs(slope[at + 1])
        bend = left - 2 * best + right
        shift = 0.5 * (left - right) / bend if bend < 0 else 0.0
        found[i, 0] = at - reach + min(max(shift, -0.5), 0.5)
        found[i, 1] = slope[at]
    return found


def search(image: Floats, at: Stations, radius_px: float) -> tuple[Floats, Floats]:
    """Offsets (N,) in px along the normals and slopes (N,), grey levels a pixel, of the edges.

    The steepest place of the picture within ``radius_px`` of each station; NaN where
    there is none. Good to some tenths of a pixel: ``measure`` refines.
    """
    found = _search(image, at.uv_px, at.normal, at.room_px, radius_px)
    return found[:, 0], found[:, 1]


@kernel
def _erf_step(x: float) -> float:  # pragma: no cover - compiled
    """The Gaussian's integral from minus infinity."""
    return float(0.5 * math.erfc(-0.7071067811865476 * x))


@kernel
def _measure(
    image: Floats, uv: Floats, normal: Floats, room: Floats, blur: Floats, free_blur: bool
) -> Floats:  # pragma: no cover - compiled
    """Per station: offset, its sd, step height, blur, noise; NaN where there is no sound edge.

    Least squares on the pixels themselves (nothing is interpolated) of a blurred
    step between two slopes: b + c x + (a + d x) F + d blur^2 f, F and f the Gaussian's
    integral and density at the edge.
    """
    found = np.full((len(uv), 5), np.nan)
    height, width = image.shape
    size = 6 if free_blur else 5
    J = np.empty(6)
    for i in range(len(uv)):
        nu, nv = normal[i, 0], normal[i, 1]
        sigma = blur[i]
        half = max(3.0, 2.5 * sigma + 1.0)
        # The neighbouring edge's blur must stay out of the window.
        high = min(half, room[i, 0] - 2.0 * sigma)
        low = min(half, room[i, 1] - 2.0 * sigma)
        if min(high, low) < 1.5 * sigma + 0.5:
            continue
        reach = int(np.ceil(np.hypot(half, HALF_LENGTH_PX)))
        row0, row1 = int(np.rint(uv[i, 1])) - reach, int(np.rint(uv[i, 1])) + reach
        col0, col1 = int(np.rint(uv[i, 0])) - reach, int(np.rint(uv[i, 0])) + reach
        if row0 < 0 or col0 < 0 or row1 >= height or col1 >= width:
            continue
        beta = np.zeros(6)
        offset, sound, used, rest = 0.0, True, 0, 0.0
        inverse = np.zeros((6, 6))
        for turn in range(8):
            A = np.zeros((size, size))
            g = np.zeros(size)
            used, rest, masked = 0, 0.0, False
            for row in range(row0, row1 + 1):
                line = image[row]
                for col in range(col0, col1 + 1):
                    du, dv = col - uv[i, 0], row - uv[i, 1]
                    along = -du * nv + dv * nu
                    across = du * nu + dv * nv
                    if abs(along) > HALF_LENGTH_PX or across > high or across < -low:
                        continue
                    value = line[col]
                    if np.isnan(value):
                        masked = True
                        break
                    x = across - offset
                    F = _erf_step(x / sigma)
                    f = 0.3989422804014327 * np.exp(-0.5 * (x / sigma) ** 2) / sigma
                    ramp = x * F + sigma * sigma * f
                    J[0], J[1], J[2], J[3] = 1.0, F, x, ramp
                    J[4] = -beta[1] * f - beta[2] - beta[3] * F
                    J[5] = -beta[1] * f * x / sigma + beta[3] * sigma * f
                    model = beta[0] + beta[1] * F + beta[2] * x + beta[3] * ramp
                    off = value - model
                    rest += off * off
                    used += 1
                    if turn == 0:
                        J[4], J[5] = 0.0, 0.0
                    for p in range(size):
                        g[p] += J[p] * off
                        for q in range(p + 1):
                            A[p, q] += J[p] * J[q]
                if masked:
                    break
            if masked or used < 4 * size:
                sound = False
                break
            for p in range(size):
                if turn == 0 and p >= 4:
                    A[p, p] = 1.0
                for q in range(p):
                    A[q, p] = A[p, q]
            # A weak hand on the two slopes keeps faint edges from going astray.
            for p in range(size):
                A[p, p] *= 1.0 + 1e-9
            if np.linalg.cond(A) > 1e14:
                sound = False
                break
            inverse_now = np.linalg.inv(A)
            step = inverse_now @ g
            for p in range(4):
                beta[p] += step[p]
            if turn > 0:
                shift = min(max(step[4], -1.0), 1.0)
                offset += shift
                if free_blur:
                    sigma = min(max(sigma + step[5], 0.6 * sigma), 1.6 * sigma)
                for p in range(size):
                    for q in range(size):
                        inverse[p, q] = inverse_now[p, q]
                if abs(offset) > 0.6 * half or sigma < 0.2:
                    sound = False
                    break
                if abs(shift) < 1e-4 and (not free_blur or abs(step[5]) < 1e-3 * sigma):
                    break
        if not sound:
            continue
        variance = max(rest / (used - size), 0.05)
        found[i, 0] = offset
        found[i, 1] = np.sqrt(variance * inverse[4, 4])
        found[i, 2] = beta[1]
        found[i, 3] = sigma
        found[i, 4] = np.sqrt(variance)
    return found


@dataclass(frozen=True)
class Measured:
    """What ``measure`` gives per station, arrays (N,); NaN where there is no sound edge.

    ``offset_px`` along the normal and its ``sigma_px``; ``step``: height in grey levels
    from the second region to the first; ``blur_px``: the blur's standard deviation;
    ``noise``: the scatter of the pixels about the fit, grey levels.
    """

    offset_px: Floats
    sigma_px: Floats
    step: Floats
    blur_px: Floats
    noise: Floats


def measure(
    image: Floats, at: Stations, blur_px: float | Floats, free_blur: bool = False
) -> Measured:
    """Sub-pixel edges at stations that lie within a blur's width of them.

    ``image`` (H, W) float64, NaN where it must not count. ``blur_px``: the standard
    deviation of the picture's blur; ``free_blur`` fits it too.
    """
    blur = np.broadcast_to(np.asarray(blur_px, dtype=np.float64), (len(at.edge),)).copy()
    found = _measure(image, at.uv_px, at.normal, at.room_px, blur, free_blur)
    return Measured(found[:, 0], found[:, 1], found[:, 2], found[:, 3], found[:, 4])
