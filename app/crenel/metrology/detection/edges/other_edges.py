"""Edges that the picture shows at other positions than the certificate."""

from collections.abc import Callable
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.metrology.detection.edges.dimension_test import (
    FURTHEST_MM,
    count_in_place,
    moves_px_per_mm,
    planes,
)
from crenel.metrology.detection.edges.measure_all import EdgeMeasurements
from crenel.metrology.detection.edges.stations import EdgeStations, place_stations, sample_profiles
from crenel.metrology.detection.edges.step_fit import select_stations
from crenel.metrology.detection.rejection import RejectionReason, size_mismatch
from crenel.metrology.robust import median, sigma_from_median
from crenel.metrology.transforms import Floats

# Shifts smaller than this are not reported as a different dimension, px.
_NEAREST_PX = 1.6
# Spacing of stations; lines are followed over this many of them.
_SPACING_PX, _AVERAGING = 3.0, 13
# Minimum ratio of a line's height to the usual one of the edges, and to its surroundings.
_STEP, _OVER_NOISE = 0.1, 5.0
# Minimum share of the edges of a dimension that must show elsewhere if the dimension is wrong,
# beyond the share in the place of the certificate and at other positions; minimum number of these
# edges that are free of others; and maximum share that may show in the place of the certificate.
_STANDS_OUT, _FREE, _HERE = 0.15, 0.4, 0.25
# Evidence that supports a position from the ends of edges must stand out by this much.
_BEARS_OUT = 0.08
# Minimum distance between the likeliest position and the next.
_APART_PX = 6.0
# Share of one edge, or of each of two, that shows there.
_MOST_OF_IT, _PART_OF_IT = 0.6, 0.3
# Minimum length, px, of a dimension's edges in the picture for a statement.
_LENGTH_PX = 25.0
# Maximum distance between a line and an edge, in px, for the line to belong to the edge.
_STRAIGHT_PX = 1.5
# Gaussian: a step of height a blurred by s has the slope a / (s sqrt(2 pi)).
_ROOT_TWO_PI = 2.5066


def find_wrong_dimension(
    grey: Floats, found: EdgeMeasurements, in_place_by_ends: Callable[[float, float], bool]
) -> RejectionReason | None:
    """A dimension of the certificate that differs in the picture, if any.

    Faces of equal brightness, shadows and occlusions hide edges, which is not a fault. But if the
    edges of one dimension (all those in one plane) are missing, and would all be visible if the
    plane were elsewhere, the block has another dimension.

    Args:
        grey: (H, W) the picture, NaN at pixels that must not count.
        found: the measured edges.
        in_place_by_ends: whether edges end in the plane at a position (mm) along X, rather than a
            distance (mm) further: then lines there are borders of shadows, or shading.
    """
    lines = _lines_about(grey, found)
    for axis, at_mm, edges in planes(found.frame):
        rows = np.flatnonzero(np.isin(lines.at.edge, edges))
        offset = _find_plane_offset(found, lines, rows, axis, count_in_place(found, edges, axis))
        if offset is not None and not (axis == 0 and in_place_by_ends(at_mm, offset.by_mm)):
            name = found.frame.names[lines.at.edge[rows[0]]]
            return size_mismatch(name, abs(offset.by_mm), offset.by_px, edges, offset.alone)
    return None


def lines_lie_at(
    grey: Floats,
    found: EdgeMeasurements,
    edges: tuple[int, ...],
    axis: int,
    by_mm: float,
    off_px: float,
) -> bool:
    """Whether lines run where a plane's edges would be if it were shifted along its axis, rather
    than elsewhere.

    ``by_mm``: the shift, accurate to ``off_px`` in the picture.
    """
    lines = _lines_about(grey, found)
    rows = np.flatnonzero(np.isin(lines.at.edge, edges))
    px_per_mm = moves_px_per_mm(found.camera, select_stations(lines.at, rows), axis)
    fastest = float(np.abs(px_per_mm).max(initial=0.0))
    if fastest * abs(by_mm) < _NEAREST_PX:
        return False
    steps, away = _shifts(px_per_mm)
    edge, length = lines.at.edge[rows], lines.at.length_px[rows]
    seen, _ = _lines_at(lines, rows, away)
    share = seen @ length / length.sum()
    there = np.abs(steps - by_mm) * fastest <= off_px
    best = int(np.argmax(np.where(there, share, -1.0)))
    second = float(share[np.abs(steps - steps[best]) * fastest > _APART_PX].max(initial=0.0))
    shows = _shares(seen[best], length, edge)
    return bool(shows.max() > _PART_OF_IT and share[best] - second > _BEARS_OUT)


@dataclass(frozen=True)
class _Lines:
    """Lines beside stations, along their edges.

    ``there``: (N, 2 reach + 1) whether there is one at each offset along the normal; ``free``: (N,
    2 reach + 1) whether no other predicted edge is near.
    """

    at: EdgeStations
    there: NDArray[np.bool_]
    free: NDArray[np.bool_]


@dataclass(frozen=True)
class _PlaneOffset:
    """The apparent shift of a plane: in mm along its axis, and in px in the picture; ``alone``: one
    of its edges supports it, and another contradicts it."""

    by_mm: float
    by_px: float
    alone: bool


def _lines_about(grey: Floats, found: EdgeMeasurements) -> _Lines:
    hidden = np.isnan(grey)
    smooth: Floats = np.asarray(
        cv2.GaussianBlur(np.nan_to_num(grey), (0, 0), max(1.0, found.blur_px)), dtype=np.float64
    )
    smooth[hidden] = np.nan
    at = place_stations(found.frame, found.camera, _SPACING_PX, _STRAIGHT_PX)
    depth = at.points_mm @ found.camera.rotation[2] + found.camera.translation_mm[2]
    px_per_mm = found.camera.matrix[0, 0] / median(depth)
    reach = int(np.ceil(FURTHEST_MM * px_per_mm)) + 2
    slope = np.gradient(sample_profiles(smooth, at.uv_px, at.normal, reach), axis=1)
    blur = float(np.hypot(found.blur_px, max(1.0, found.blur_px)))
    usual = median(np.abs(found.step[found.used])) / (_ROOT_TWO_PI * blur)
    peak = np.zeros(slope.shape, dtype=bool)
    for part in np.unique(at.part):
        rows = at.part == part
        along = np.abs(_average_along(slope[rows]))
        noise = sigma_from_median(along)
        peak[rows] = along >= max(_STEP * usual, _OVER_NOISE * noise)
        peak[rows, 1:-1] &= (along[:, 1:-1] >= along[:, :-2]) & (along[:, 1:-1] >= along[:, 2:])
    peak[:, [0, -1]] = False
    there = cv2.dilate(peak.astype(np.uint8), np.ones((1, 3), np.uint8)) > 0
    offset = np.arange(-reach, reach + 1)
    clear = 2 * blur + 1
    free = (offset < at.clearance_px[:, :1] - clear) & (offset > -(at.clearance_px[:, 1:] - clear))
    return _Lines(at, there, free)


def _average_along(slope: Floats) -> Floats:
    """Slopes (N, M) averaged over adjacent stations, which suppresses texture."""
    known = np.isfinite(slope)
    size = (1, min(_AVERAGING, len(slope)))
    total = cv2.boxFilter(np.where(known, slope, 0.0), -1, size, borderType=cv2.BORDER_ISOLATED)
    share = cv2.boxFilter(known.astype(np.float64), -1, size, borderType=cv2.BORDER_ISOLATED)
    return np.asarray(total / np.maximum(share, 1e-3), dtype=np.float64)


def _find_plane_offset(
    found: EdgeMeasurements, lines: _Lines, rows: NDArray[np.int64], axis: int, staying: int
) -> _PlaneOffset | None:
    """Shift along an axis at which the edges at some stations appear; None if there is none.

    Every shift of their plane moves each station's edge along its normal by a known amount.
    ``staying``: the number of edges that are seen in place; at least one more must be elsewhere.
    """
    at = lines.at
    px_per_mm = moves_px_per_mm(found.camera, select_stations(at, rows), axis)
    length = at.length_px[rows]
    sensitive = np.abs(px_per_mm) * FURTHEST_MM > 2 * _NEAREST_PX
    if float(length[sensitive].sum()) < _LENGTH_PX:
        return None
    rows, px_per_mm, length = rows[sensitive], px_per_mm[sensitive], length[sensitive]
    fastest = float(np.abs(px_per_mm).max())
    reach = lines.there.shape[1] // 2
    steps, away = _shifts(px_per_mm)
    seen, free = _lines_at(lines, rows, away)
    share = seen @ length / np.maximum(free @ length, _FREE * length.sum())
    best = int(np.argmax(share))
    here = float(lines.there[rows, reach] @ length / length.sum())
    # In texture, and between parallel lines, there is an edge everywhere.
    apart = np.abs(steps - steps[best]) * fastest > _APART_PX
    second = float(share[apart].max(initial=0.0))
    edge = at.edge[rows]
    shows = _shares(seen[best], length, edge)
    most = int(np.sum(shows > _MOST_OF_IT))
    # A single line may belong to a shadow; it must be there for most of the edge.
    like_edges = most > 0 or np.sum(shows > _PART_OF_IT) > 1
    stands_out = like_edges and share[best] - here - second > _STANDS_OUT
    if most <= staying and staying > 0:
        return None
    several = most > 1
    displaced = (stands_out and here < _HERE * share[best]) or (several and here < share[best] / 2)
    if not displaced:
        return None
    say = shows - _shares(lines.there[rows, reach], length, edge)
    alone = bool(np.sum(say > _PART_OF_IT) < 2 and np.any(say < -_PART_OF_IT))
    return _PlaneOffset(float(steps[best]), float(np.abs(away[best]).max()), alone)


def _shifts(px_per_mm: Floats) -> tuple[Floats, NDArray[np.int64]]:
    """Shifts (S,), mm, every half px of the fastest station, and the resulting motions (S, N),
    px."""
    steps = np.arange(-FURTHEST_MM, FURTHEST_MM, 0.5 / float(np.abs(px_per_mm).max()))
    return steps, np.rint(steps[:, None] * px_per_mm).astype(np.int64)


def _lines_at(
    lines: _Lines, rows: NDArray[np.int64], away_px: NDArray[np.int64]
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Whether a line is at these distances (..., R) from stations (R,), and whether one could
    be."""
    reach = lines.there.shape[1] // 2
    column = np.clip(away_px + reach, 0, 2 * reach)
    free = lines.free[rows, column] & (np.abs(away_px) >= _NEAREST_PX)
    return lines.there[rows, column] & free, free


def _shares(there: NDArray[np.bool_], length: Floats, edge: NDArray[np.int64]) -> Floats:
    """For each edge (E,), the share of its stations' length at which there is a line."""
    every, number = np.unique(edge, return_inverse=True)
    total = np.bincount(number, length, len(every))
    shown = np.bincount(number, length * there, len(every))
    return np.where(total > _LENGTH_PX, shown / np.maximum(total, _LENGTH_PX), 0.0)
