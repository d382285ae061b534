"""Tests the dimensions of the certificate: would the edges fit far better with one plane shifted?

All edges in one of the block's planes shift together if a dimension is wrong, and the fitted camera
absorbs part of the shift. The shift of each plane is therefore estimated together with the camera,
in one adjustment, and judged relative to its standard deviation by the remaining scatter (Baarda's
test of one alternative hypothesis, with the variance estimated).
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.messages.message import Text, message
from crenel.metrology.detection.edges.camera_from_edges import (
    WITH_K1,
    WITH_K2,
    prior_rows,
    residuals_with_jacobian,
)
from crenel.metrology.detection.edges.measure_all import EdgeMeasurements
from crenel.metrology.detection.edges.stations import EdgeStations
from crenel.metrology.detection.edges.step_fit import select_stations
from crenel.metrology.detection.visibility import Wireframe
from crenel.metrology.robust import huber_weights, sigma_from_median
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.transforms import Floats

# The points of each part are merged into at most this many pieces, of at least this many points.
_PIECES, _IN_PIECE = 3, 4
# Error of an edge's position beyond noise and marks, relative to the blur.
_LEFT_BLURS = 0.03
# A plane is located if its shift by 1 mm would move this many points by this many px.
_SENSITIVE_POINTS, _SENSITIVE_PX = 4, 2.0
# Pieces further off than this many standard deviations have less weight (Huber), and iterations.
_HUBER, _ROUNDS = 2.5, 3
# Largest error of a dimension considered, in mm.
FURTHEST_MM = 2.6
# An edge is in place if at least this many px of it, and this share of its points, lie within this
# many px of it, and would move by twice that if the dimension were wrong.
_ENOUGH_PX, _MOST_OF_IT, _IN_PLACE_PX = 18.0, 0.6, 1.6


@dataclass(frozen=True)
class PlaneShift:
    """The estimated shift of a plane of the block from its position in the certificate.

    ``axis`` and ``at_mm``: the plane; ``edges``: the rows of its edges in the wireframe; ``by_mm``:
    the shift along the axis; ``ratio``: the shift over its standard deviation, including that of
    the certificate.
    """

    axis: int
    at_mm: float
    edges: tuple[int, ...]
    by_mm: float
    ratio: float


@dataclass(frozen=True)
class _Pieces:
    """Merged points: distances (M,) from the predicted edges, their variances (M,) in px squared,
    and their derivatives by the camera's parameters (M, P) and by the planes' shifts (M, K), px per
    mm."""

    off_px: Floats
    variance: Floats
    camera: Floats
    shifts: Floats


def planes(frame: Wireframe) -> list[tuple[int, float, tuple[int, ...]]]:
    """Every plane of the block's faces: its axis, its coordinate in mm, the edges in it."""
    both = np.stack([frame.starts_mm, frame.ends_mm], axis=1)
    found = []
    for axis in range(3):
        for value in np.unique(both[..., axis]):
            edges = np.flatnonzero((np.abs(both[..., axis] - value) < 1e-9).all(axis=1))
            found.append((axis, float(value), tuple(int(edge) for edge in edges)))
    return found


def lines_along_x(frame: Wireframe, kinds: tuple[str, ...]) -> list[list[int]]:
    """Edges along X, grouped by line, from left to right."""
    lines: dict[tuple[str, str], list[int]] = {}
    for edge, name in enumerate(frame.names):
        words = name.split(":")
        if words[0] in kinds and words[-1] in ("front", "back"):
            lines.setdefault((words[0], words[-1]), []).append(edge)
    return list(lines.values())


def moves_px_per_mm(camera: Camera, at: EdgeStations, axis: int) -> Floats:
    """(N,) shift of each station's edge along its normal by a shift along an axis."""
    ahead = project(camera, at.points_mm + 0.1 * np.eye(3)[axis]) - at.uv_px
    return np.asarray(10.0 * (ahead * at.normal).sum(axis=1))


def count_in_place(found: EdgeMeasurements, edges: tuple[int, ...], axis: int) -> int:
    """The number of a plane's edges that are almost completely visible where the certificate puts
    them.

    Only edges count that a shift of the plane would move in the picture.
    """
    at = found.at
    count = 0
    for edge in edges:
        rows = np.flatnonzero(at.edge == edge)
        there = found.used[rows] & (np.abs(found.off_px[rows]) < _IN_PLACE_PX)
        moves = np.abs(moves_px_per_mm(found.camera, select_stations(at, rows), axis))
        there &= moves * FURTHEST_MM > 2 * _IN_PLACE_PX
        enough = at.length_px[rows][there].sum() > _ENOUGH_PX
        count += bool(enough and there.sum() >= _MOST_OF_IT * len(rows))
    return count


def estimate_shifts(found: EdgeMeasurements, certificate_mm: float) -> list[PlaneShift]:
    """The estimated shift of each plane; planes whose edges show nothing of it are omitted.

    Args:
        found: the measured edges, and the camera fitted to them.
        certificate_mm: standard uncertainty of the block's coordinates.
    """
    faces = planes(found.frame)
    free = WITH_K2 if found.camera.distortion[1] != 0.0 else WITH_K1
    pieces = _gather_pieces(found, faces, free, certificate_mm)
    if len(pieces.off_px) <= len(free) + 1:
        return []
    held = prior_rows(found.camera, free)
    shifts = []
    for k, (axis, at_mm, edges) in enumerate(faces):
        by_mm, ratio = _estimate_shift(pieces, held, k, certificate_mm)
        shifts.append(PlaneShift(axis, at_mm, edges, by_mm, abs(ratio)))
    return shifts


def find_unobserved_planes(found: EdgeMeasurements) -> tuple[tuple[int, int], ...]:
    """The block's planes, by axis and number, that no measured edge locates.

    Faces of equal brightness, shadows and the frame hide edges; a wrong dimension there would go
    unnoticed.
    """
    faces = planes(found.frame)
    rows = np.flatnonzero(found.used)
    sensitive = (np.abs(shift_effects(found, rows, faces)) > _SENSITIVE_PX).sum(axis=0)
    count = dict.fromkeys(range(3), 0)
    hidden = []
    for (axis, _, _), points in zip(faces, sensitive, strict=True):
        if points < _SENSITIVE_POINTS:
            hidden.append((axis, count[axis]))
        count[axis] += 1
    return tuple(hidden)


def describe_plane(axis: int, number: int) -> Text:
    """The name of the n-th plane along an axis; merlons are counted from the left."""
    if axis == 0:
        side = ("left", "right")[number % 2]
        return message("side-merlon", side=side, number=number // 2 + 1)
    if axis == 1:
        return message("side-of-block", side=("front", "back")[number])
    return message("height-of-level", level=("base", "floors", "crests")[number])


def _gather_pieces(
    found: EdgeMeasurements,
    faces: list[tuple[int, float, tuple[int, ...]]],
    free: tuple[int, ...],
    certificate_mm: float,
) -> _Pieces:
    """The used points, merged into pieces of their parts."""
    rows = np.flatnonzero(found.used)
    at, camera = found.at, found.camera
    part = at.part[rows]
    _, effects = residuals_with_jacobian(
        camera, at.points_mm[rows], found.uv_px[rows], at.normal[rows]
    )
    effects = np.column_stack([effects[:, list(free)], shift_effects(found, rows, faces)])
    depth = at.points_mm[rows] @ camera.rotation[2] + camera.translation_mm[2]
    certificate_px = certificate_mm * camera.matrix[0, 0] / depth
    weight = 1 / found.sigma_along_px[rows] ** 2
    off, variance, means = [], [], []
    for one in np.unique(part):
        own = np.flatnonzero(part == one)
        if len(own) < _IN_PIECE:
            continue
        for piece in np.array_split(own, min(_PIECES, len(own) // _IN_PIECE)):
            total = weight[piece].sum()
            off.append(weight[piece] @ found.off_px[rows[piece]] / total)
            means.append(weight[piece] @ effects[piece] / total)
            marks = found.marks_px[rows[piece[0]]]
            variance.append(1 / total + marks**2 + certificate_px[piece].mean() ** 2)
    table = np.array(means).reshape(len(off), -1)
    return _Pieces(
        np.array(off),
        np.array(variance) + (_LEFT_BLURS * found.blur_px) ** 2,
        table[:, : len(free)],
        table[:, len(free) :],
    )


def shift_effects(
    found: EdgeMeasurements,
    rows: NDArray[np.int64],
    faces: list[tuple[int, float, tuple[int, ...]]],
) -> Floats:
    """Change of the points' distances, (N, K) px, by a shift of each plane by 1 mm."""
    points, normal = found.at.points_mm[rows], found.at.normal[rows]
    here = project(found.camera, points)
    along = [
        100.0
        * ((project(found.camera, points + 0.01 * np.eye(3)[axis]) - here) * normal).sum(axis=1)
        for axis in range(3)
    ]
    edge = found.at.edge[rows]
    return np.column_stack(
        [np.where(np.isin(edge, edges), along[axis], 0.0) for axis, _, edges in faces]
    )


def _estimate_shift(
    pieces: _Pieces, held: Floats, plane: int, certificate_mm: float
) -> tuple[float, float]:
    """A plane's shift in mm and over its standard deviation; zeros if the camera explains it
    equally well.

    ``held`` (H, P): prior knowledge about cameras, as additional rows of the camera's parameters.
    """
    weight = 1 / np.sqrt(pieces.variance)
    count, spare = len(pieces.off_px), len(pieces.off_px) - pieces.camera.shape[1] - 1
    nothing = np.zeros(len(held))
    by_mm = deviation = 0.0
    for _ in range(_ROUNDS):
        table = np.vstack([pieces.camera * weight[:, None], held])
        basis, _ = np.linalg.qr(table / np.linalg.norm(table, axis=0))
        shift = np.append(pieces.shifts[:, plane] * weight, nothing)
        off = np.append(pieces.off_px * weight, nothing)
        alone = shift - basis @ (basis.T @ shift)
        rest = off - basis @ (basis.T @ off)
        square = float(alone @ alone)
        if square <= 1e-6 * float(shift @ shift):
            return 0.0, 0.0
        by_mm = float(alone @ rest) / square
        left = (rest - by_mm * alone)[:count]
        scale = max(1.0, float(np.sqrt(left @ left / spare)))
        deviation = float(np.hypot(scale / np.sqrt(square), certificate_mm))
        spread = max(1.0, sigma_from_median(np.abs(left)))
        weight = weight * np.sqrt(huber_weights(np.abs(left), _HUBER * spread))
    return by_mm, by_mm / deviation
