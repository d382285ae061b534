"""Edges that the picture shows beside where the certificate puts them."""

from dataclasses import replace

import cv2
import numpy as np
from numpy.typing import NDArray

from app.metrology.camera import project
from app.metrology.detection.edge_points import Stations, profiles
from app.metrology.detection.edge_step import chosen, measure
from app.metrology.detection.edge_survey import Survey
from app.metrology.frames import Floats

# Edges are judged by at least so many points of their kind; one with at least so few
# points, at most this share of which show, is missing;
_ENOUGH = 6
_FEW = 4
_MISSING = 0.2
# one of which at least this share shows is there.
_PRESENT = 0.6
# How far a stray is looked for, over the picture's longer side, and how far its points
# may lie from a straight line.
_FAR = 0.1
_STRAIGHT_PX = 1.5
# Of the missing edge's stations, how many must see the stray, and its step over the usual.
_SEEN = 0.7
_STEP = 0.5
# How far beyond the block's ends its lines are followed, over its length, and how many
# stations in a row, every two pixels, must see one go on.
_BEYOND = 0.3
_IN_A_ROW = 8


def stray_edge(grey: Floats, found: Survey) -> str:
    """A missing edge whose like is seen elsewhere, in words; empty where there is none.

    Faces of equal brightness hide the edge between them, which is no fault. But
    where all others between the same kinds of face show, and a straight step of
    their height runs beside the missing one where nothing should be, the block
    has other measures.

    Args:
        grey: (H, W) the picture, NaN where it must not count.
        found: the edges measured in it.
    """
    hidden = np.isnan(grey)
    smooth: Floats = np.asarray(
        cv2.GaussianBlur(np.nan_to_num(grey), (0, 0), max(1.0, found.blur_px)), dtype=np.float64
    )
    smooth[hidden] = np.nan
    for part, step in _missing(found, _uncovered(hidden, found)):
        rows = np.flatnonzero(found.at.part == part)
        away_px = _stray(smooth, found, rows, step)
        if away_px is not None:
            at = found.at.points_mm[rows] @ found.camera.rotation.T
            depth = float(np.median((at + found.camera.translation_mm)[:, 2]))
            away_mm = abs(away_px) * depth / found.camera.matrix[0, 0]
            name = found.frame.names[found.at.edge[rows[0]]]
            return (
                f"its edge {name} seems to lie {away_mm:.2f} mm from where the certificate puts it"
            )
    return ""


def overrun(grey: Floats, found: Survey) -> str:
    """An edge that goes on beyond its certificate's end, in words; empty where none does.

    Along X an edge must end at its corners, and beyond the block's two ends nothing
    may run on in the same line.

    Args:
        grey: (H, W) the picture, NaN where it must not count.
        found: the edges measured in it.
    """
    at, frame = found.at, found.frame
    names = np.array(frame.names)
    lines: dict[tuple[str, str], list[int]] = {}
    for edge, name in enumerate(frame.names):
        words = name.split(":")
        if words[0] in ("crest", "floor", "base") and words[-1] in ("front", "back"):
            lines.setdefault((words[0], words[-1]), []).append(edge)
    for (level, _), edges in lines.items():
        own = found.used & np.isin(at.edge, edges)
        if own.sum() < _ENOUGH:
            continue
        step = float(np.median(found.step[own]))
        row = int(np.flatnonzero(own)[0])
        begin, end = frame.starts_mm[edges], frame.ends_mm[edges]
        # Halfway to the next edge in the line; a good way beyond the last.
        after = np.append((begin[1:, 0] - end[:-1, 0]) / 2, _BEYOND * (end[-1, 0] - begin[0, 0]))
        before = np.append(after[-1], after[:-1])
        for k, edge in enumerate(edges):
            ways = ((end[k], after[k], "right"), (begin[k], -before[k], "left"))
            for corner, reach_mm, side in ways:
                beyond = _beyond(found, corner, reach_mm, row)
                if _runs_on(grey, found, beyond, step):
                    what = "it" if level == "base" else f"its edge {names[edge]}"
                    return f"{what} goes on beyond its {side} end"
    return ""


def _runs_on(grey: Floats, found: Survey, beyond: Stations, step: float) -> bool:
    """Whether a step like an edge's own is seen at enough stations (every 2 px) in a row."""
    if len(beyond.edge) < _IN_A_ROW:
        return False
    seen = measure(grey, beyond, found.blur_px)
    like = np.abs(seen.offset_px) < _STRAIGHT_PX / 2
    like &= np.abs(seen.step - step) < np.minimum(0.4 * abs(step), abs(step) - 6 * seen.step_sigma)
    streak = np.convolve(like.astype(np.int64), np.ones(_IN_A_ROW, dtype=np.int64), "valid")
    return bool(streak.max() == _IN_A_ROW)


def _beyond(found: Survey, corner: Floats, reach_mm: float, row: int) -> Stations:
    """Stations every 2 px along X from beyond a corner (3,) as far as ``reach_mm``."""
    ends = project(found.camera, np.array([corner, corner + [reach_mm, 0.0, 0.0]]))
    length = float(np.hypot(*(ends[1] - ends[0])))
    clear = found.at.half_length_px + 3 * found.blur_px + 2
    if length < clear + 2 * _IN_A_ROW:
        return chosen(found.at, np.zeros(len(found.at.edge), dtype=bool))
    share = np.arange(clear, length, 2.0)[:, None] / length
    points = corner + share * np.array([reach_mm, 0.0, 0.0])
    return _stations_at(found, points, np.array([1.0, 0.0, 0.0]), row)


def _stations_at(found: Survey, points_mm: Floats, along_mm: Floats, row: int) -> Stations:
    """Stations at points (N, 3) on the line of an edge, as far as they are in the picture."""
    camera = found.camera
    uv = project(camera, points_mm)
    step = project(camera, points_mm + 1e-3 * along_mm) - uv
    tangent = step / np.linalg.norm(step, axis=1, keepdims=True)
    normal = np.column_stack([-tangent[:, 1], tangent[:, 0]])
    limit = np.array([camera.width_px, camera.height_px]) - 1
    count = len(points_mm)
    at = replace(
        found.at,
        edge=np.full(count, found.at.edge[row]),
        part=np.full(count, found.at.part[row]),
        points_mm=points_mm,
        uv_px=uv,
        normal=normal,
        room_px=np.full((count, 2), np.inf),
        length_px=np.ones(count),
    )
    return chosen(at, np.all((uv > 0) & (uv < limit), axis=1))


def _uncovered(hidden: NDArray[np.bool_], found: Survey) -> NDArray[np.bool_]:
    """Which stations (N,) have all of their surroundings in sight."""
    reach = 2 * int(np.ceil(3 + 2.5 * found.blur_px + found.at.half_length_px)) + 1
    wide = cv2.dilate(hidden.astype(np.uint8), np.ones((reach, reach), np.uint8)) > 0
    at = np.rint(found.at.uv_px).astype(np.int64)
    return np.asarray(~wide[at[:, 1], at[:, 0]])


def _missing(found: Survey, uncovered: NDArray[np.bool_]) -> list[tuple[int, float]]:
    """Missing parts and the step, from second to first region, that their likes show."""
    at = found.at
    kinds = [_kind(name) for name in found.frame.regions]
    alike: dict[tuple[str, str], list[tuple[int, int, int, float, float]]] = {}
    for part in np.unique(at.part):
        rows = (at.part == part) & uncovered
        one, other = (kinds[region] for region in at.regions[part])
        sense = 1.0 if one <= other else -1.0
        shown = rows & found.used
        step = sense * float(np.median(found.step[shown])) if shown.any() else 0.0
        key = (min(one, other), max(one, other))
        alike.setdefault(key, []).append(
            (int(part), int(rows.sum()), int(shown.sum()), step, sense)
        )
    missing = []
    for group in alike.values():
        there = [one for one in group if one[2] >= _PRESENT * one[1]]
        steps = np.array([one[3] for one in there])
        if sum(one[2] for one in there) < _ENOUGH or steps.min() * steps.max() <= 0:
            continue
        for part, count, shown_count, _, sense in group:
            if count >= _FEW and shown_count <= _MISSING * count:
                missing.append((part, sense * float(np.median(steps))))
    return missing


def _kind(region: str) -> str:
    """What a region is, without its number: ``wall:2:L`` is a ``wall:L``."""
    words = region.split(":")
    return f"wall:{words[2]}" if words[0] == "wall" else words[0]


def _stray(smooth: Floats, found: Survey, rows: NDArray[np.int64], step: float) -> float | None:
    """Mean distance in px, along the normals, of a straight step beside some stations."""
    at = found.at
    reach = int(_FAR * max(smooth.shape))
    blur = float(np.hypot(found.blur_px, max(1.0, found.blur_px)))
    slope = np.gradient(profiles(smooth, at.uv_px[rows], at.normal[rows], reach), axis=1)
    least = _STEP * abs(step) / (2.5066 * blur)
    size = slope * np.sign(step)
    offset = np.arange(-reach, reach + 1)
    # Near other drawn edges a step is theirs.
    own = (offset < at.room_px[rows, :1] - 3 * blur - 2) & (
        offset > -(at.room_px[rows, 1:] - 3 * blur - 2)
    )
    peak = (size >= least) & own
    peak[:, 1:-1] &= (size[:, 1:-1] >= size[:, :-2]) & (size[:, 1:-1] >= size[:, 2:])
    peak[:, [0, -1]] = False
    station, column = np.nonzero(peak)
    if len(np.unique(station)) < _SEEN * len(rows):
        return None
    away = offset[column].astype(np.float64)
    third = len(rows) / 3
    for a in np.flatnonzero(station < third)[:60]:
        for b in np.flatnonzero(station > 2 * third)[:60]:
            incline = (away[b] - away[a]) / (station[b] - station[a])
            near = np.abs(away - away[a] - incline * (station - station[a])) < _STRAIGHT_PX
            seen = len(np.unique(station[near])) >= _SEEN * len(rows)
            # What runs along the drawn edge itself is that edge, only too faint to measure.
            if seen and abs(np.mean(away[near])) > _STRAIGHT_PX:
                return float(np.mean(away[near]))
    return None
