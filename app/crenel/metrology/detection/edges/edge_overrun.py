"""Edges of the block that continue beyond their end in the certificate."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from crenel.messages.message import message
from crenel.metrology.detection.edges.dimension_test import lines_along_x
from crenel.metrology.detection.edges.measure_all import EdgeMeasurements, stations_along_x
from crenel.metrology.detection.edges.stations import EdgeStations
from crenel.metrology.detection.edges.step_fit import measure_steps, select_stations
from crenel.metrology.detection.rejection import RejectionReason, describe_edge
from crenel.metrology.robust import median
from crenel.metrology.sensor.camera import project
from crenel.metrology.transforms import Floats

# The step of an edge is estimated from at least this many of its points.
_ENOUGH = 6
# Maximum distance between a line and an edge, in px, for the line to belong to the edge.
_STRAIGHT_PX = 1.5
# How far beyond the block's ends its lines are followed, relative to its length; the number of
# consecutive stations, every two pixels, that must show a continuation, and the share of the path:
# most of it if tool marks run beside it, which are searched at this distance in px.
_BEYOND = 0.3
_IN_A_ROW, _OF_THE_WAY, _MOST_OF_THE_WAY = 8, 0.3, 0.6
# If noise leaves none of them certain, this many must, with few exceptions.
_IN_NOISE, _NEARLY_ALL = 24, 0.9
_ADJACENT_PX = (*range(-24, -5, 3), *range(6, 25, 3))


def find_overrun(grey: Floats, found: EdgeMeasurements) -> RejectionReason | None:
    """An edge that continues beyond its end in the certificate, if any.

    Along X, an edge must end at its corners, and beyond the two ends of the block nothing may
    continue in the same line.

    Args:
        grey: (H, W) the picture, NaN at pixels that must not count.
        found: the measured edges.
    """
    at, frame = found.at, found.frame
    for edges in lines_along_x(frame, ("crest", "floor", "base")):
        own = found.used & np.isin(at.edge, edges)
        if own.sum() < _ENOUGH:
            continue
        step = median(found.step[own])
        row = int(np.flatnonzero(own)[0])
        begin, end = frame.starts_mm[edges], frame.ends_mm[edges]
        # Halfway to the next edge in the line; far beyond the last one.
        after = np.append((begin[1:, 0] - end[:-1, 0]) / 2, _BEYOND * (end[-1, 0] - begin[0, 0]))
        before = np.append(after[-1], after[:-1])
        for k, edge in enumerate(edges):
            ways = ((end[k], after[k], "right"), (begin[k], -before[k], "left"))
            for corner, reach_mm, side in ways:
                beyond = _stations_beyond(found, corner, reach_mm, row)
                if _runs_on(grey, found, beyond, step):
                    what = describe_edge(frame.names[edge])
                    return RejectionReason(
                        message("goes-beyond-end", edge=what, side=side), True, (edge,)
                    )
    return None


def _runs_on(grey: Floats, found: EdgeMeasurements, beyond: EdgeStations, step: float) -> bool:
    """Whether enough consecutive stations (every 2 px) show a step like that of an edge."""
    seen = measure_steps(grey, beyond, found.blur_px)
    straight = np.abs(seen.offset_px) < _STRAIGHT_PX / 2
    apart = np.abs(seen.step - step)
    clear = straight & (apart < np.minimum(0.4 * abs(step), abs(step) - 6 * seen.step_sigma))
    if _in_a_row(clear, _OF_THE_WAY):
        return _in_a_row(clear, _MOST_OF_THE_WAY) or not _has_tool_marks(grey, found, beyond, step)
    # Not so different that nothing at all would be similar.
    noisy = np.clip(2 * seen.step_sigma, 0.4 * abs(step), 0.6 * abs(step))
    faint = straight & (apart < noisy) & (3 * seen.step_sigma < abs(step))
    long = _in_a_row(faint, _OF_THE_WAY, _IN_NOISE, _NEARLY_ALL)
    return long and not _has_tool_marks(grey, found, beyond, step)


def _in_a_row(
    like: NDArray[np.bool_], share: float, least: int = _IN_A_ROW, of_them: float = 1.0
) -> bool:
    """Whether adjacent stations are similar, for this share of the path and at least ``least``.

    ``of_them``: the share of these that must be similar.
    """
    row = max(least, int(share * len(like)))
    if len(like) < row:
        return False
    streak = np.convolve(like.astype(np.int64), np.ones(row, dtype=np.int64), "valid")
    return bool(streak.max() >= of_them * row)


def _has_tool_marks(
    grey: Floats, found: EdgeMeasurements, beyond: EdgeStations, step: float
) -> bool:
    """Whether lines as strong as the one at some stations also run beside it: tool marks."""
    for away in _ADJACENT_PX:
        beside = replace(beyond, uv_px=beyond.uv_px + away * beyond.normal)
        seen = measure_steps(grey, beside, found.blur_px)
        there = np.abs(seen.offset_px) < _STRAIGHT_PX / 2
        there &= np.abs(seen.step) > np.maximum(0.6 * abs(step), 2 * seen.step_sigma)
        if _in_a_row(there, _OF_THE_WAY):
            return True
    return False


def _stations_beyond(
    found: EdgeMeasurements, corner: Floats, reach_mm: float, row: int
) -> EdgeStations:
    """Stations every 2 px along X from beyond a corner (3,) up to ``reach_mm``."""
    ends = project(found.camera, np.array([corner, corner + [reach_mm, 0.0, 0.0]]))
    length = float(np.hypot(*(ends[1] - ends[0])))
    clear = found.at.half_length_px + 3 * found.blur_px + 2
    if length < clear + 2 * _IN_A_ROW:
        return select_stations(found.at, np.zeros(len(found.at.edge), dtype=bool))
    share = np.arange(clear, length, 2.0)[:, None] / length
    points = corner + share * np.array([reach_mm, 0.0, 0.0])
    return stations_along_x(found, points, row)
