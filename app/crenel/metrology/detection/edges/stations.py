"""Sub-pixel points on the block's edges in a picture, searched at their predicted positions."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.detection.visibility import Wireframe, find_visible_edges
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.transforms import Floats
from crenel.native.arguments import F64, I64, Array, Function, Integer, Real
from crenel.native.library import CRENEL

# Faces seen at a flatter angle than this, as sines, may be hidden or visible.
_EDGE_ON = 0.004
_LONGEST_PICTURES = 4.0
"""An edge that appears longer than so many pictures has its stations farther apart: the hypotheses
of a search may place the camera almost on the block."""

_measure_clearance = Function(
    CRENEL,
    "edge_clearance",
    Array(F64, "n", 2),
    Array(F64, "n", 2),
    Array(I64, "n"),
    Array(F64, "p", 4),
    Real(),
    Array(F64, "n", 2, written=True),
    Array(F64, 4, "p", written=True),
)
_search = Function(
    CRENEL,
    "steepest_places",
    Array(F64, "height", "width"),
    Array(F64, "n", 2),
    Array(F64, "n", 2),
    Array(F64, "n", 2),
    Real(),
    Integer(),
    Array(F64, "n", 2, written=True),
    Array(F64, 2, "line", written=True),
)
_profiles = Function(
    CRENEL,
    "profiles_across",
    Array(F64, "height", "width"),
    Array(F64, "n", 2),
    Array(F64, "n", 2),
    Array(F64, "n", "line", written=True),
)


@dataclass(frozen=True)
class EdgeStations:
    """Places along the visible edges at which the picture is measured.

    Arrays of one length N: ``edge`` (row in the wireframe), ``part`` (visible part), ``points_mm``
    (N, 3), ``uv_px`` (N, 2) expected positions, ``normal`` (N, 2) unit, towards the part's first
    region, ``clearance_px`` (N, 2) distance along and against the normal to the next edge that is
    visible, or would be from a slightly different view, ``length_px`` (N,) length of edge that each
    represents. ``regions`` (parts, 2): the regions adjacent to each part. ``half_length_px``:
    length along the edge over which each gathers light to either side; the smallest if they differ.
    """

    edge: NDArray[np.int64]
    part: NDArray[np.int64]
    points_mm: Floats
    uv_px: Floats
    normal: Floats
    clearance_px: Floats
    length_px: Floats
    regions: NDArray[np.int64]
    half_length_px: float


def block_ahead(frame: Wireframe, camera: Camera) -> bool:
    """Whether the block is in front of the camera, and the camera in front of its front face and
    above it."""
    if not all(np.isfinite(one).all() for one in (camera.matrix, camera.translation_mm)):
        return False
    _, y, z = camera.centre_mm
    if y >= frame.starts_mm[:, 1].min() or z <= frame.starts_mm[:, 2].max():
        return False
    depth = frame.starts_mm @ camera.rotation[2] + camera.translation_mm[2]
    return bool(depth.min() > 0.1 * depth.max() > 0)


def place_stations(
    frame: Wireframe, camera: Camera, spacing_px: float, margin_px: float
) -> EdgeStations:
    """Stations every ``spacing_px`` along all edges that ``camera`` sees in its picture.

    They keep ``margin_px`` from the ends of each visible part, where other edges meet it. The block
    must be in front of the camera (``block_ahead``).
    """
    parts = find_visible_edges(frame, camera.centre_mm)
    begin, along = frame.starts_mm[parts.edge], (frame.ends_mm - frame.starts_mm)[parts.edge]
    first = begin + parts.start[:, None] * along
    last = begin + parts.end[:, None] * along
    behind = _just_hidden(frame, parts.edge, camera.centre_mm)
    both = project(camera, np.vstack([first, frame.starts_mm[behind], last, frame.ends_mm[behind]]))
    near = np.column_stack(np.split(both, 2))
    ends = near[: len(first)]
    length = np.hypot(ends[:, 2] - ends[:, 0], ends[:, 3] - ends[:, 1])
    usable = length - 2 * margin_px
    most = _LONGEST_PICTURES * (camera.width_px + camera.height_px) / spacing_px
    count = np.clip(np.rint(usable / spacing_px), 1, most)
    count = np.where(usable > 0, count, 0).astype(np.int64)
    part, within = number_points(count)
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
    uv, normal, part = uv[inside], normal[inside], part[inside]
    clearance = np.empty((len(uv), 2))
    _measure_clearance(uv, normal, part, near, half_length, clearance, np.empty((4, len(near))))
    return EdgeStations(
        parts.edge[part],
        part,
        points[inside],
        uv,
        normal,
        clearance,
        (usable / np.maximum(count, 1))[part],
        parts.regions,
        half_length,
    )


def number_points(count: NDArray[np.int64]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """For points on lines, ``count`` (L,) on each: the line of every point, and its number there.

    Example:
        >>> line, within = number_points(np.array([2, 0, 3]))
        >>> line.tolist(), within.tolist()
        ([0, 0, 2, 2, 2], [0, 1, 0, 1, 2])
    """
    line = np.repeat(np.arange(len(count)), count)
    return line, np.arange(len(line)) - np.repeat(np.cumsum(count) - count, count)


def _just_hidden(
    frame: Wireframe, visible: NDArray[np.int64], centre_mm: Floats
) -> NDArray[np.int64]:
    """Hidden edges of faces that are seen almost edge on: a slightly different view would show
    them."""
    aside = np.abs(frame.starts_mm - centre_mm)
    edge_on = aside < _EDGE_ON * np.sqrt((aside**2).sum(axis=1, keepdims=True))
    edge_on &= frame.starts_mm == frame.ends_mm
    hidden = edge_on.any(axis=1)
    hidden[visible] = False
    return np.flatnonzero(hidden)


def search_edges(image: Floats, at: EdgeStations, radius_px: float) -> tuple[Floats, Floats]:
    """Offsets (N,) in px along the normals and slopes (N,), grey levels per pixel, of the edges.

    The steepest place of the picture within ``radius_px`` of each station; NaN if there is none.
    Accurate to some tenths of a pixel: ``measure`` refines it.
    """
    found = np.empty((len(at.uv_px), 2))
    workspace = np.empty((2, 2 * (int(np.ceil(radius_px)) + 2) + 1))
    half = int(at.half_length_px)
    _search(image, at.uv_px, at.normal, at.clearance_px, radius_px, half, found, workspace)
    return found[:, 0], found[:, 1]


def sample_profiles(image: Floats, uv_px: Floats, normal: Floats, reach_px: int) -> Floats:
    """The picture along the normals (N, 2) at positions (N, 2), every pixel from -reach to reach.

    (N, 2 reach + 1), NaN outside the picture.
    """
    found = np.empty((len(uv_px), 2 * reach_px + 1))
    _profiles(image, uv_px, normal, found)
    return found
