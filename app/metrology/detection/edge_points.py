"""Sub-pixel points on the block's edges in a picture, searched where a camera predicts them."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.metrology.camera import Camera, project
from app.metrology.compiled import kernel
from app.metrology.detection.visibility import Wireframe, seen
from app.metrology.frames import Floats

# Faces that are seen at less than this, as sines, may as well be hidden, or seen.
_EDGE_ON = 0.004


@dataclass(frozen=True)
class Stations:
    """Places along the visible edges at which the picture is to be measured.

    Arrays of one length N: ``edge`` (row in the wireframe), ``part`` (visible part),
    ``points_mm`` (N, 3), ``uv_px`` (N, 2) where they are expected, ``normal`` (N, 2)
    unit, towards the part's first region, ``room_px`` (N, 2) distance along
    and against the normal to the next edge that shows, or would from a little aside,
    ``length_px`` (N,) of edge each stands for. ``regions`` (parts, 2): what adjoins each
    part. ``half_length_px``: how far along the edge each gathers light to either side, the
    least of them where they differ.
    """

    edge: NDArray[np.int64]
    part: NDArray[np.int64]
    points_mm: Floats
    uv_px: Floats
    normal: Floats
    room_px: Floats
    length_px: Floats
    regions: NDArray[np.int64]
    half_length_px: float


@kernel
def _room(
    uv: Floats, normal: Floats, part: NDArray[np.int64], ends: Floats, half_length: float
) -> Floats:
    """Distances (N, 2) along and against each normal to the nearest other part (P, 4)."""
    room = np.full((len(uv), 2), np.inf)
    du, dv = ends[:, 2] - ends[:, 0], ends[:, 3] - ends[:, 1]
    length = np.sqrt(du * du + dv * dv)
    for i in range(len(uv)):
        u, v, nu, nv, own = uv[i, 0], uv[i, 1], normal[i, 0], normal[i, 1], part[i]
        ahead, behind = np.inf, np.inf
        for p in range(len(ends)):
            det = nu * dv[p] - nv * du[p]
            if p == own or abs(det) < 1e-6 * length[p]:
                continue
            ru, rv = ends[p, 0] - u, ends[p, 1] - v
            # How far along the part, times det squared.
            along = (nv * ru - nu * rv) * det
            beyond = half_length / length[p] * det * det
            if along < -beyond or along > det * det + beyond:
                continue
            away = (ru * dv[p] - rv * du[p]) / det
            if away >= 0:
                ahead = min(ahead, away)
            else:
                behind = min(behind, -away)
        room[i, 0], room[i, 1] = ahead, behind
    return room


def block_ahead(frame: Wireframe, camera: Camera) -> bool:
    """Whether the block lies before the camera, and the camera before its front and above it."""
    if not all(np.isfinite(one).all() for one in (camera.matrix, camera.translation_mm)):
        return False
    _, y, z = camera.centre_mm
    if y >= frame.starts_mm[:, 1].min() or z <= frame.starts_mm[:, 2].max():
        return False
    depth = frame.starts_mm @ camera.rotation[2] + camera.translation_mm[2]
    return bool(depth.min() > 0.1 * depth.max() > 0)


def stations(frame: Wireframe, camera: Camera, spacing_px: float, margin_px: float) -> Stations:
    """Stations every ``spacing_px`` along all edges that ``camera`` sees in its picture.

    They keep ``margin_px`` from the ends of each visible part, where other edges meet it.
    The block lies before the camera (``block_ahead``).
    """
    parts = seen(frame, camera.centre_mm)
    begin, along = frame.starts_mm[parts.edge], (frame.ends_mm - frame.starts_mm)[parts.edge]
    first = begin + parts.start[:, None] * along
    last = begin + parts.end[:, None] * along
    behind = _just_hidden(frame, parts.edge, camera.centre_mm)
    both = project(camera, np.vstack([first, frame.starts_mm[behind], last, frame.ends_mm[behind]]))
    near = np.column_stack(np.split(both, 2))
    ends = near[: len(first)]
    length = np.hypot(ends[:, 2] - ends[:, 0], ends[:, 3] - ends[:, 1])
    usable = length - 2 * margin_px
    count = np.where(usable > 0, np.maximum(np.rint(usable / spacing_px), 1), 0).astype(np.int64)
    part = np.repeat(np.arange(len(count)), count)
    within = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    share = (margin_px + (within + 0.5) * (usable / np.maximum(count, 1))[part]) / length[part]
    points = first[part] + share[:, None] * (last - first)[part]
    uv = project(camera, points)
    step = project(camera, points + 1e-3 * (last - first)[part]) - uv
    tangent = step / np.linalg.norm(step, axis=1, keepdims=True)
    normal = np.column_stack([-tangent[:, 1], tangent[:, 0]])
    half_length = spacing_px / 2
    edge_of_frame = half_length + 1
    limit = np.array([camera.width_px, camera.height_px]) - 1 - edge_of_frame
    inside = np.all((uv >= edge_of_frame) & (uv <= limit), axis=1)
    room = _room(uv[inside], normal[inside], part[inside], near, half_length)
    return Stations(
        parts.edge[part][inside],
        part[inside],
        points[inside],
        uv[inside],
        normal[inside],
        room,
        (usable / np.maximum(count, 1))[part][inside],
        parts.regions,
        half_length,
    )


def _just_hidden(
    frame: Wireframe, visible: NDArray[np.int64], centre_mm: Floats
) -> NDArray[np.int64]:
    """Hidden edges of faces that are seen nearly edge on: a camera little aside would see them."""
    aside = np.abs(frame.starts_mm - centre_mm)
    edge_on = aside < _EDGE_ON * np.sqrt((aside**2).sum(axis=1, keepdims=True))
    edge_on &= frame.starts_mm == frame.ends_mm
    hidden = edge_on.any(axis=1)
    hidden[visible] = False
    return np.flatnonzero(hidden)


@kernel
def _bilinear(image: Floats, u: float, v: float) -> float:
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
    image: Floats, uv: Floats, normal: Floats, room: Floats, radius: float, half: int
) -> Floats:
    """Per station: offset along the normal and slope (grey levels per pixel) of the steepest place.

    Rows of NaN where the picture has no value. The search stops halfway to the next edge.
    """
    found = np.full((len(uv), 2), np.nan)
    reach = int(np.ceil(radius)) + 2
    profile = np.empty(2 * reach + 1)
    slope = np.empty(2 * reach + 1)
    for i in range(len(uv)):
        nu, nv = normal[i, 0], normal[i, 1]
        high = min(radius, max(0.5 * room[i, 0], 1.0))
        low = -min(radius, max(0.5 * room[i, 1], 1.0))
        first = max(reach + int(np.ceil(low)), 2)
        last = min(reach + int(np.floor(high)), 2 * reach - 2)
        for k in range(first - 2, last + 3):
            u, v = uv[i, 0] + (k - reach) * nu, uv[i, 1] + (k - reach) * nv
            total = 0.0
            for j in range(-half, half + 1):
                total += _bilinear(image, u - j * nv, v + j * nu)
            profile[k] = total / (2 * half + 1)
        best, at = -1.0, -1
        for k in range(first - 1, last + 2):
            slope[k] = 0.5 * (profile[k + 1] - profile[k - 1])
        for k in range(first, last + 1):
            if abs(slope[k]) > best:
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
    found = _search(image, at.uv_px, at.normal, at.room_px, radius_px, int(at.half_length_px))
    return found[:, 0], found[:, 1]


@kernel
def _profiles(image: Floats, uv: Floats, normal: Floats, reach: int) -> Floats:
    out = np.empty((len(uv), 2 * reach + 1))
    for i in range(len(uv)):
        for k in range(2 * reach + 1):
            u, v = uv[i, 0] + (k - reach) * normal[i, 0], uv[i, 1] + (k - reach) * normal[i, 1]
            out[i, k] = _bilinear(image, u, v)
    return out


def profiles(image: Floats, uv_px: Floats, normal: Floats, reach_px: int) -> Floats:
    """The picture along the normals (N, 2) at places (N, 2), every pixel from -reach to reach.

    (N, 2 reach + 1), NaN outside of the picture.
    """
    return _profiles(image, uv_px, normal, reach_px)
