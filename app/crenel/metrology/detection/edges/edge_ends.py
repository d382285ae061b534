"""Tests whether the block's edges along X end at the corners of the certificate.

An edge that ends elsewhere reveals a wrong dimension if the edges of the shifted plane itself are
hidden: by faces of equal brightness, or among the borders of shadows.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from crenel.metrology.detection.edges.dimension_test import (
    FURTHEST_MM,
    count_in_place,
    lines_along_x,
    planes,
)
from crenel.metrology.detection.edges.measure_all import EdgeMeasurements, stations_along_x
from crenel.metrology.detection.edges.other_edges import lines_lie_at
from crenel.metrology.detection.edges.stations import EdgeStations, sample_profiles
from crenel.metrology.detection.edges.step_fit import select_stations
from crenel.metrology.detection.rejection import RejectionReason, size_mismatch
from crenel.metrology.detection.visibility import find_visible_edges
from crenel.metrology.robust import MEDIAN_OF_NORMAL, median
from crenel.metrology.sensor.camera import project
from crenel.metrology.transforms import Floats

# The step of an edge is estimated from at least this length, px.
_ENOUGH_PX = 16.0
# Shifts smaller than this are not reported as a different dimension, px; an edge is followed by
# this many px more than a dimension may be wrong, to either side.
_NEAREST_PX, _FURTHER_PX = 5.0, 14.0
# An edge is present if its step is at least this share of the usual one, and absent if it is less
# than that; the usual step must exceed its surroundings by this factor.
_THERE, _GONE, _OVER_SURROUNDINGS = 0.6, 0.3, 4.0
# Tolerated share of contradicting pixels on the edge's side of its end and beyond; minimum number
# of known px on either side, with the light gathered along this many.
_LESS, _MORE, _KNOWN_PX, _ALONG_PX = 0.1, 0.15, 6, 5
# An end that is hidden, and therefore uncertain by more than this beyond the blur, does not count.
_UNCLEAR_PX = 3.0
# Where an edge ends, its light mixes with its surroundings for this many px and blurs.
_CLEAR_PX, _CLEAR_BLURS = 3.0, 1.5
# Ends are moved alike if they agree to this many px, or to this share.
_ALIKE_PX, _ALIKE = 4.0, 0.15
# Share of an edge that is rounded.
_ROUNDING = 1e-6
# Share of the way to the next edge in the line that belongs to the edge.
_SHARE_OF_GAP = 0.6


@dataclass(frozen=True)
class EdgeEnd:
    """The measured end of an edge: ``by_mm`` ``outward`` (1 or -1 along X) of its plane at
    ``at_mm``, with the uncertainty ``unclear_px`` of the picture."""

    at_mm: float
    outward: float
    by_mm: float
    px_per_mm: float
    unclear_px: float

    @property
    def by_px(self) -> float:
        return abs(self.by_mm) * self.px_per_mm

    @property
    def moved(self) -> bool:
        return self.by_px > self.unclear_px


def measure_ends(grey: Floats, found: EdgeMeasurements) -> list[EdgeEnd]:
    """The ends of the edges of crests and base along X, as far as the picture shows them.

    Broken edges shorten all of them alike, so each is compared with the others of the block.

    Args:
        grey: (H, W) the picture, NaN at pixels that must not count.
        found: the measured edges.
    """
    ends = [end for way in _ways(found) if (end := _measure_end(grey, found, way)) is not None]
    usual_mm = median([end.by_mm for end in ends]) if ends else 0.0
    return [replace(end, by_mm=end.by_mm - usual_mm) for end in ends]


def ends_in_place(ends: Sequence[EdgeEnd], at_mm: float, by_mm: float) -> bool:
    """Whether edges end as expected at a plane along X, rather than ``by_mm`` further."""
    own = [end for end in ends if end.at_mm == at_mm]
    away = [abs(end.outward * by_mm - end.by_mm) * end.px_per_mm for end in own]
    stand = [not end.moved and px > end.unclear_px for end, px in zip(own, away, strict=True)]
    return bool(own) and all(stand)


def find_misplaced_ends(
    grey: Floats, found: EdgeMeasurements, everywhere: Sequence[EdgeEnd]
) -> RejectionReason | None:
    """A dimension along X that differs in the picture, because edges end elsewhere, if any.

    Anything in front of the block may shorten one edge. A plane is considered shifted if two edges
    of crests and base end at the same other position, or if one does and lines run where the
    plane's own edges would then be; if no edge ends as expected; and if no edge in the plane that
    ends them is seen in its place. If the edges continue beyond their expected ends, which nothing
    else causes for two edges, fewer edges may be in place than there are displaced ends.

    Args:
        grey: (H, W) the picture, NaN at pixels that must not count.
        found: the measured edges.
        everywhere: the ends of its edges.
    """
    for axis, at_mm, edges in planes(found.frame):
        ends = [end for end in everywhere if axis == 0 and end.at_mm == at_mm]
        moved = [end for end in ends if end.moved]
        together = max((_alike(end, moved) for end in moved), key=len, default=[])
        if not together or len(moved) < len(ends):
            continue
        by_mm = float(np.mean([end.by_mm for end in together]))
        # Another edge of the block may happen to lie where one of the plane's is predicted.
        by_chance = len(together) - 1 if by_mm > 0 else 0
        if count_in_place(found, edges, axis) > by_chance:
            continue
        if len(together) > 1 or _lines_confirm(grey, found, edges, together[0]):
            by_px = max(end.by_px for end in together)
            # An occlusion of two ends shortens both alike; nothing makes an edge longer.
            alone = by_mm < 0 and len(together) < 3
            return size_mismatch(found.frame.names[edges[0]], abs(by_mm), by_px, edges, alone)
    return None


def _lines_confirm(
    grey: Floats, found: EdgeMeasurements, edges: tuple[int, ...], end: EdgeEnd
) -> bool:
    """Whether lines run where the edges of an end's plane would be if the plane were there."""
    return lines_lie_at(grey, found, edges, 0, end.outward * end.by_mm, _ALIKE_PX)


def _alike(end: EdgeEnd, others: list[EdgeEnd]) -> list[EdgeEnd]:
    """The ends that are moved by the same amount as one of them."""
    near_mm = max(_ALIKE_PX, _ALIKE * end.by_px) / end.px_per_mm
    return [one for one in others if abs(one.by_mm - end.by_mm) < near_mm]


@dataclass(frozen=True)
class _Way:
    """The path along an edge through its corner (3,), which is ``outward`` (1 or -1) along X.

    ``within_mm``: as far as the edge is visible; ``beyond_mm``: as far as there is no other edge.
    """

    edge: int
    corner_mm: Floats
    outward: float
    within_mm: float
    beyond_mm: float


def _ways(found: EdgeMeasurements) -> Iterator[_Way]:
    """Paths through every visible corner of the edges of crests and base along X."""
    frame = found.frame
    parts = find_visible_edges(frame, found.camera.centre_mm)
    for line in lines_along_x(frame, ("crest", "base")):
        for k, edge in enumerate(line):
            begin, end = frame.starts_mm[edge], frame.ends_mm[edge]
            length = end[0] - begin[0]
            before = begin[0] - frame.ends_mm[line[k - 1]][0] if k > 0 else np.inf
            after = frame.starts_mm[line[k + 1]][0] - end[0] if k + 1 < len(line) else np.inf
            for one in np.flatnonzero(parts.edge == edge):
                shown = (parts.end[one] - parts.start[one]) * length
                if parts.start[one] < _ROUNDING:
                    yield _Way(edge, begin, -1.0, shown, _SHARE_OF_GAP * before)
                if parts.end[one] > 1.0 - _ROUNDING:
                    yield _Way(edge, end, 1.0, shown, _SHARE_OF_GAP * after)


def _measure_end(grey: Floats, found: EdgeMeasurements, way: _Way) -> EdgeEnd | None:
    """The end of an edge on its path; None if the picture does not show it."""
    out = np.array([way.outward, 0.0, 0.0])
    ends = project(found.camera, way.corner_mm + np.array([[-0.05], [0.05]]) * out)
    px_per_mm = 10.0 * float(np.hypot(*(ends[1] - ends[0])))
    furthest_px = FURTHEST_MM * px_per_mm
    own = np.flatnonzero(found.used & (found.at.edge == way.edge))
    enough = found.at.length_px[own].sum() > _ENOUGH_PX
    if not enough or furthest_px < 2 * _NEAREST_PX:
        return None
    at = _along(found, way, px_per_mm, int(own[0]))
    if len(at.edge) < 2 * _KNOWN_PX:
        return None
    on_edge, _ = _contrast(grey, select_stations(found.at, own), found.blur_px)
    step, beside = _contrast(grey, at, found.blur_px)
    usual, noise = (
        _median(on_edge),
        _median(np.abs([_moving_average(one) for one in beside])) / MEDIAN_OF_NORMAL,
    )
    if not abs(usual) > _OVER_SURROUNDINGS * noise:
        return None
    along_px = (at.points_mm - way.corner_mm) @ out * px_per_mm
    clear_px = _CLEAR_PX + _CLEAR_BLURS * max(1.0, found.blur_px)
    by_px = _find_end(along_px, _moving_average(step) / usual, clear_px, furthest_px)
    if by_px is None:
        return None
    unclear_px = max(_NEAREST_PX, clear_px)
    return EdgeEnd(float(way.corner_mm[0]), way.outward, by_px / px_per_mm, px_per_mm, unclear_px)


def _along(found: EdgeMeasurements, way: _Way, px_per_mm: float, row: int) -> EdgeStations:
    """Stations every px along a path, as far as it is followed and in the picture.

    ``row``: the row of a station on the edge itself.
    """
    most_px = FURTHEST_MM * px_per_mm + _FURTHER_PX
    first = -min(way.within_mm * px_per_mm, most_px)
    last = min(way.beyond_mm * px_per_mm, most_px)
    offset_mm = np.zeros((int(np.ceil(last - np.ceil(first))), 3))
    offset_mm[:, 0] = way.outward * (np.ceil(first) + np.arange(len(offset_mm))) / px_per_mm
    return stations_along_x(found, way.corner_mm + offset_mm, row)


def _median(values: Floats) -> float:
    """Median of the known values; NaN if there is none."""
    known = values[np.isfinite(values)]
    return median(known) if len(known) else np.nan


def _contrast(grey: Floats, at: EdgeStations, blur_px: float) -> tuple[Floats, Floats]:
    """Difference in brightness (grey levels) between the two sides of stations (N,), and the same
    (2, N) at places to either side where no edge is expected."""
    far = int(np.ceil(1.0 + blur_px))
    levels = sample_profiles(grey, at.uv_px, at.normal, 3 * far)[:, :: 2 * far].T
    steps = np.diff(levels, axis=0)
    return steps[1], steps[[0, 2]]


def _moving_average(step: Floats) -> Floats:
    """Means (N,) over neighbours; NaN if too few are known."""
    known = np.isfinite(step)
    near = np.ones(_ALONG_PX)
    total = np.convolve(np.where(known, step, 0.0), near, "same")
    count = np.convolve(known.astype(np.float64), near, "same")
    return np.where(count > _ALONG_PX / 2, total / np.maximum(count, 1.0), np.nan)


def _find_end(along_px: Floats, share: Floats, clear_px: float, furthest_px: float) -> float | None:
    """The position along its path at which an edge ends, from its strength (N,) at every px.

    The position that leaves least of it beyond and least missing before. None if neither side is
    known, if much contradicts every position, or if many positions are equally good.
    """
    there = np.where(share > _THERE, 1.0, np.where(share < _GONE, 0.0, 0.5))
    known = np.isfinite(share)
    best: list[float] = []
    least = np.inf
    for at_px in np.arange(-np.floor(furthest_px), furthest_px):
        off = along_px - at_px
        within = known & (off < -clear_px) & (off > -clear_px - furthest_px)
        beyond = known & (off > clear_px) & (off < clear_px + furthest_px)
        if min(within.sum(), beyond.sum()) < _KNOWN_PX:
            continue
        wanting, left = 1.0 - there[within], there[beyond]
        wrong = float(wanting.sum() + left.sum())
        if wrong > least:
            continue
        if wrong < least:
            least, best = wrong, []
        if wanting.mean() < _LESS and left.mean() < _MORE:
            best.append(float(at_px))
    if not best or best[-1] - best[0] > 2 * clear_px + _UNCLEAR_PX:
        return None
    return float(np.mean(best))
