"""Evidence against a hypothesis of the block's pose, and where the picture shows it."""

from functools import partial

import numpy as np

from crenel.messages.message import message, quantity
from crenel.metrology.detection.edges.dimension_test import estimate_shifts
from crenel.metrology.detection.edges.edge_ends import (
    ends_in_place,
    find_misplaced_ends,
    measure_ends,
)
from crenel.metrology.detection.edges.edge_overrun import find_overrun
from crenel.metrology.detection.edges.measure_all import EdgeMeasurements
from crenel.metrology.detection.edges.other_edges import find_wrong_dimension
from crenel.metrology.detection.edges.outlier_edges import (
    drop_outlier_edges,
    drop_single_outlier,
    find_outlier_edges,
    measure_parts,
)
from crenel.metrology.detection.errors import COMPLETE_SHARE
from crenel.metrology.detection.rejection import RejectionReason, size_mismatch
from crenel.metrology.detection.search.coarse_pose import SearchResult
from crenel.metrology.detection.visibility import find_visible_edges
from crenel.metrology.robust import median
from crenel.metrology.sensor.camera import project
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.transforms import Floats

# A plane of the block is off if all edges together place it elsewhere by more than this many
# standard deviations and blurs, or pixels: less is due to the finish of an edge and the lighting.
_SHIFTED, _SHIFTED_BLURS = 6.0, 0.5
# Pixels of current sensors are square; tolerance of a fitted camera.
_SQUARE = 0.005
# No lens of a sensor has more distortion than this.
_K1, _K2 = 1.2, 3.0
# Minimum share of the predicted edge length that must show: faces of equal brightness hide some.
LEAST_VISIBLE = 0.35
# Minimum share of the points that show and agree with their edge.
_LEAST_AGREEING = 0.8
# and for the edges below the crests.
_BELOW = ("floor", "base")
_LEAST_LOWER = 0.05
# Number of merlon sides that identify the visible part of the object, and share of its edges.
_SIDES, _LEAST_IN_FRAME = 4, 0.4
# With less support than this at the small scale, nothing like the block was found.
LEAST_SUPPORT = 0.5
# Share of straight segments in three perpendicular directions that indicates a block.
_BLOCK_LIKE = 0.7


def check_measurements(
    grey: Floats, found: EdgeMeasurements, certificate_mm: float
) -> tuple[EdgeMeasurements, RejectionReason | None]:
    """The survey without single edges that a shadow or damage moved, and the evidence against it.

    Args:
        grey: (H, W) the picture, NaN at pixels that must not count.
        found: the edges measured in it.
        certificate_mm: standard uncertainty of the block's coordinates.
    """
    against = _check_visibility(found) or _check_camera(found)
    if against is not None:
        return found, against
    found = drop_single_outlier(drop_outlier_edges(found, certificate_mm), certificate_mm)
    parts = measure_parts(found, certificate_mm)
    if not parts:
        return found, RejectionReason(message("too-few-edges-could-measured"))
    against = (
        _find_shifted_plane(found, certificate_mm)
        or _find_misplaced_edges(grey, found)
        or find_outlier_edges(found, parts, certificate_mm)
    )
    return found, against


def _find_misplaced_edges(grey: Floats, found: EdgeMeasurements) -> RejectionReason | None:
    """Edges that the picture shows at other positions, or with other ends, than the certificate."""
    ends = measure_ends(grey, found)
    return (
        find_wrong_dimension(grey, found, partial(ends_in_place, ends))
        or find_overrun(grey, found)
        or find_misplaced_ends(grey, found, ends)
    )


def _find_shifted_plane(found: EdgeMeasurements, certificate_mm: float) -> RejectionReason | None:
    """A plane of the block that lies elsewhere according to all edges together."""
    depth = found.at.points_mm[found.used] @ found.camera.rotation[2]
    px_per_mm = found.camera.matrix[0, 0] / float(median(depth) + found.camera.translation_mm[2])
    least_mm = _SHIFTED_BLURS * max(1.0, found.blur_px) / px_per_mm
    shifts = [one for one in estimate_shifts(found, certificate_mm) if abs(one.by_mm) > least_mm]
    shift = max(shifts, key=lambda one: one.ratio, default=None)
    if shift is None or shift.ratio < _SHIFTED:
        return None
    off_mm = abs(shift.by_mm)
    return size_mismatch(found.frame.names[shift.edges[0]], off_mm, off_mm * px_per_mm, shift.edges)


def _check_visibility(found: EdgeMeasurements) -> RejectionReason | None:
    """Too little of the block shows to identify it."""
    at = found.at
    shown = float(at.length_px[found.shows].sum()) / max(float(at.length_px.sum()), 1e-9)
    missing = tuple(int(edge) for edge in set(at.edge) - set(at.edge[found.used]))
    if shown < LEAST_VISIBLE:
        text = message("only-visible-edges-show-picture", shown=quantity(100 * shown, "%"))
        return RejectionReason(text, edges=missing)
    agreeing = float(found.used.sum()) / max(int(found.shows.sum()), 1)
    if agreeing < _LEAST_AGREEING:
        text = message("only-edge-points-lie-edges", agreeing=quantity(100 * agreeing, "%"))
        return RejectionReason(text, edges=missing)
    if _lower_visible_share(found) < _LEAST_LOWER:
        text = message("none-edges-floors-base-shows-picture")
        return RejectionReason(text, edges=missing, hidden=True)
    return None


def _check_camera(found: EdgeMeasurements) -> RejectionReason | None:
    """A camera that no real sensor has."""
    off_square = abs(found.camera.matrix[1, 1] / found.camera.matrix[0, 0] - 1)
    if off_square > _SQUARE:
        return RejectionReason(
            message(
                "edges-would-fit-only-if-cameras", off_square=quantity(100 * off_square, "%", 1)
            ),
            True,
        )
    k1, k2 = found.camera.distortion[:2]
    if abs(k1) > _K1 or abs(k2) > _K2:
        return RejectionReason(
            message(
                "edges-would-fit-only-lens-distorted",
                k1=quantity(k1, "", 1),
                k2=quantity(k2, "", 1),
            ),
            True,
        )
    return None


def _lower_visible_share(found: EdgeMeasurements) -> float:
    """Share of the lower edges' length that shows: without these edges, any height would fit."""
    lower = np.array([name.startswith(_BELOW) for name in found.frame.names])
    rows = lower[found.at.edge]
    shown = float(found.at.length_px[rows & found.used].sum())
    return shown / max(float(found.at.length_px[rows].sum()), 1e-9)


def is_block_like(found: SearchResult) -> bool:
    """Whether most straight segments follow three perpendicular directions."""
    return found.segment_count >= 12 and found.explained >= _BLOCK_LIKE


def is_symmetric(block: Crenellated) -> bool:
    """Whether the block is symmetric left to right, to ten times its uncertainty."""
    x = np.array(block.edges_x_mm)
    there, back = x - x[0], x[-1] - x[::-1]
    return bool(np.abs(there - back).max() < 10 * max(block.standard_uncertainty_mm, 0.001))


def is_cut_off(found: EdgeMeasurements, block: Crenellated, share: float) -> bool:
    """Whether too little of the block is in the frame.

    A camera needs two levels, that of the crests and one below, and four sides of crests: as many
    as two merlons have. ``share``: share of the visible edges in the frame.
    """
    names = {found.frame.names[edge] for edge in found.at.edge[found.used]}
    sides = sum(
        f"crest:{i}:{side}" in names for i in range(block.merlon_count) for side in ("L", "R")
    )
    below = any(name.startswith(_BELOW) for name in names)
    return share < COMPLETE_SHARE and (sides < _SIDES or not below or share < _LEAST_IN_FRAME)


def share_in_frame(found: EdgeMeasurements) -> float:
    """Share of the visible edges' length that lies within the picture."""
    parts = find_visible_edges(found.frame, found.camera.centre_mm)
    begin = found.frame.starts_mm[parts.edge]
    along = found.frame.ends_mm[parts.edge] - begin
    span = (parts.end - parts.start) * np.linalg.norm(along, axis=1)
    total, inside = 0.0, 0.0
    for share in (np.arange(20) + 0.5) / 20:
        at = parts.start + share * (parts.end - parts.start)
        uv = project(found.camera, begin + at[:, None] * along)
        within = (uv >= 0).all(axis=1)
        within &= (uv < [found.camera.width_px, found.camera.height_px]).all(axis=1)
        total += float(span.sum())
        inside += float(span[within].sum())
    return inside / max(total, 1e-9)
