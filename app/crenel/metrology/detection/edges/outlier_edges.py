"""Single edges that disagree with the rest of the block: shadows, damage, wrong dimensions."""

from dataclasses import dataclass

import numpy as np

from crenel.messages.message import message, quantity
from crenel.metrology.detection.edges.dimension_test import PlaneShift, estimate_shifts
from crenel.metrology.detection.edges.measure_all import EdgeMeasurements, refit_without
from crenel.metrology.detection.rejection import RejectionReason, describe_edge
from crenel.metrology.robust import median, sigma_from_median
from crenel.metrology.sensor.camera import project

# An edge that is off by this many standard deviations does not fit the certificate.
_SIGMAS = 5.0
# A single edge that is off by this many, with its neighbours in place, is excluded; and the maximum
# share of excluded parts of edges.
_ODD, _FEW = 3.5, 0.1
# A single edge that is off by less than this, px, may be excluded.
_LONE_PX = 1.0
# A plane that all edges together shift by less than this many standard deviations is in place.
_STAYS = 3.0
# Error of a whole edge due to the camera model and the edge's finish, relative to the longer side.
_MODEL = 0.05 / 1280
# All edges together may be off by this many standard deviations.
_SPREAD = 3.0
# Maximum average offset of edges, relative to the blur.
_STRAIN_BLURS = 0.3
# Minimum number of points of a part.
_POINTS = 4


@dataclass(frozen=True)
class EdgePart:
    """A measured part of an edge: its number and edge, its distance from the predicted edge, and
    that distance relative to image noise, certificate and camera model."""

    number: int
    edge: int
    name: str
    distance_um: float
    distance_px: float
    ratio: float


def measure_parts(found: EdgeMeasurements, certificate_mm: float) -> list[EdgePart]:
    """The measured parts with enough points.

    ``certificate_mm``: standard uncertainty of the block's coordinates.
    """
    at = found.at
    model_px = _MODEL * max(found.camera.width_px, found.camera.height_px)
    depth = (at.points_mm @ found.camera.rotation.T + found.camera.translation_mm)[:, 2]
    parts = []
    for part in np.unique(at.part[found.used]):
        rows = np.flatnonzero(found.used & (at.part == part))
        if len(rows) < _POINTS:
            continue
        mm_per_px = median(depth[rows]) / found.camera.matrix[0, 0]
        off = median(found.off_px[rows])
        own = 1.25 * median(found.sigma_px[rows]) / np.sqrt(len(rows))
        allowed = np.sqrt(own**2 + (certificate_mm / mm_per_px) ** 2 + model_px**2)
        edge = int(at.edge[rows[0]])
        parts.append(
            EdgePart(
                int(part),
                edge,
                found.frame.names[edge],
                1000 * abs(off) * mm_per_px,
                abs(off),
                float(abs(off) / allowed),
            )
        )
    return parts


def drop_outlier_edges(found: EdgeMeasurements, certificate_mm: float) -> EdgeMeasurements:
    """The survey without the few parts that were each moved individually."""
    parts = measure_parts(found, certificate_mm)
    displaced = _find_displaced(parts, _ODD)
    if not displaced:
        return found
    planes = estimate_shifts(found, certificate_mm)
    odd = [
        part
        for part in displaced
        if _others_agree(found, part, parts) or _planes_stay(part, planes)
    ]
    rest = max((part.ratio for part in parts if part not in odd), default=0.0)
    if not odd or len(odd) > _FEW * len(parts) or rest >= _ODD:
        return found
    return refit_without(found, [part.number for part in odd], certificate_mm) or found


def drop_single_outlier(found: EdgeMeasurements, certificate_mm: float) -> EdgeMeasurements:
    """The survey without a single edge that is slightly off, if everything else is then in place.

    Such an offset is too small to be distinguished from the border of a shadow or a worn edge; what
    only this edge shows of the block then counts as not seen.
    """
    displaced = _find_displaced(measure_parts(found, certificate_mm), _SIGMAS)
    little = max((part.distance_px for part in displaced), default=np.inf) < _LONE_PX
    if not little or not _is_single_edge(found, displaced, certificate_mm):
        return found
    return refit_without(found, [part.number for part in displaced], certificate_mm) or found


def _planes_stay(part: EdgePart, planes: list[PlaneShift]) -> bool:
    """Whether all edges together leave the planes of a part's edge in place."""
    own = [plane.ratio for plane in planes if part.edge in plane.edges]
    return bool(own) and max(own) < _STAYS


def find_outlier_edges(
    found: EdgeMeasurements, parts: list[EdgePart], certificate_mm: float
) -> RejectionReason | None:
    """Edges that are too far from their position in the certificate."""
    displaced = _find_displaced(parts, _SIGMAS)
    if not displaced:
        return _find_strain(found, parts)
    worst = max(displaced, key=lambda part: part.ratio)
    return RejectionReason(
        message(
            "lies-where-certificate-puts",
            edge=describe_edge(worst.name),
            distance=quantity(worst.distance_um, "µm"),
        ),
        True,
        tuple({part.edge for part in displaced}),
        _is_single_edge(found, displaced, certificate_mm),
        max(part.distance_px for part in displaced),
    )


def _is_single_edge(
    found: EdgeMeasurements, displaced: list[EdgePart], certificate_mm: float
) -> bool:
    """Whether only a single edge indicates this: without it, its planes are in place."""
    if len({part.edge for part in displaced}) > 1:
        return False
    rest = refit_without(found, [part.number for part in displaced], certificate_mm)
    if rest is None or _find_displaced(measure_parts(rest, certificate_mm), _SIGMAS):
        return False
    return _planes_stay(displaced[0], estimate_shifts(rest, certificate_mm))


def _find_strain(found: EdgeMeasurements, parts: list[EdgePart]) -> RejectionReason | None:
    """All edges are off by more than texture explains: the camera had to absorb a wrong
    dimension."""
    usual_px = sigma_from_median([part.distance_px for part in parts])
    if usual_px < _STRAIN_BLURS * max(1.0, found.blur_px):
        return None
    worst = max(parts, key=lambda part: part.distance_px)
    return RejectionReason(
        message(
            "edges-lie-off-average-where-certificate",
            usual=quantity(usual_px, "px", 1),
            edge=describe_edge(worst.name),
            distance=quantity(worst.distance_um, "µm"),
        ),
        True,
        (worst.edge,),
        off_px=worst.distance_px,
    )


def _find_displaced(parts: list[EdgePart], sigmas: float) -> list[EdgePart]:
    """The parts that are too far from their predicted position; all if most are."""
    # Texture along the edges moves each as a whole; an edge that moves more stands out.
    spread = max(1.0, sigma_from_median([part.ratio for part in parts] or [0.0]))
    if spread > _SPREAD:
        return parts
    return [part for part in parts if part.ratio > sigmas * spread]


def _others_agree(found: EdgeMeasurements, outlier: EdgePart, parts: list[EdgePart]) -> bool:
    """Whether other edges in both planes of a displaced edge are in place.

    A wrong dimension moves all edges of its plane. Only edges count that a shift of the plane would
    move at least half as far in the picture.
    """
    displaced = {part.number for part in _find_displaced(parts, _ODD)}
    frame = found.frame
    both = np.stack([frame.starts_mm, frame.ends_mm], axis=1)
    for axis in np.flatnonzero(both[outlier.edge, 0] == both[outlier.edge, 1]):
        shift = 1000.0 * _shift_px(found, outlier, int(axis))
        if shift < 1e-6:
            continue
        level = both[outlier.edge, 0, axis]
        if not any(
            part.number not in displaced
            and bool((both[part.edge, :, axis] == level).all())
            and 1000.0 * _shift_px(found, part, int(axis)) > 0.5 * shift
            for part in parts
        ):
            return False
    return True


def _shift_px(found: EdgeMeasurements, part: EdgePart, axis: int) -> float:
    """Motion of a part across itself, px, for a shift of its edge by 1 µm along an axis."""
    row = int(np.flatnonzero(found.at.part == part.number)[0])
    ahead = found.at.points_mm[row] + 1e-3 * np.eye(3)[axis]
    moved = project(found.camera, ahead[None])[0] - found.at.uv_px[row]
    return abs(float(moved @ found.at.normal[row]))
