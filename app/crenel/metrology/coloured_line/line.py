"""The laser line of a colour picture: its colour, its place and its points."""

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.metrology.colour import Colours, LaserColour
from crenel.metrology.coloured_line.excess import Levels, Planes, find_ridges, split_planes
from crenel.metrology.coloured_line.measure import CentrePoints, measure_line
from crenel.metrology.coloured_line.path import best_path
from crenel.metrology.coloured_line.pieces import (
    LinePiece,
    anchor_score,
    select_line,
    split_path,
)
from crenel.metrology.image import saturation_level
from crenel.metrology.stripe.found_line import FoundLine
from crenel.metrology.stripe.points import stripe_from_points
from crenel.metrology.stripe.scales import FULL
from crenel.metrology.stripe.workspace import PER_FULL_WIDTH

SMALL_PX = 700
"""Larger pictures are halved to look for the colour."""
LEAST_SIDE_PX = 48
FULL_LEVEL = 255.0
FINE, COARSE, LEAST_FINE, LEAST_COARSE = 0.25, 0.4, 0.8, 1.0
"""Smoothing for a line whose width is known, in shares of it, and the least."""
MOST_PATHS, BESIDE = 2, 3.0
"""How many paths are tried, and what is left out beside one that is no line, in smoothings."""
BEYOND, QUIETER = "beyond", 0.6
"""The usual combination; the share of its scatter from which on another one is taken."""
PROFILE_PX, BASE_PX = 60, 40
"""Rows on both sides of a line over which its width is looked for, and its surroundings."""


@dataclass(frozen=True)
class ColouredLine:
    """A line that was found by its colour.

    ``combination``: what of the picture was measured: the channel of the ``colour`` alone, what it
    shows beyond the others, or the mean of all.
    """

    colour: LaserColour
    found: FoundLine
    combination: str


def find_coloured_line(
    picture: Colours,
    axis: str,
    colours: Sequence[LaserColour],
    where: NDArray[np.bool_] | None = None,
) -> ColouredLine | None:
    """The line of the colour that shows most of one; None without a line.

    Args:
        picture: (H, W, 3 or more), blue first.
        axis: as in ``find_stripe``.
        colours: those that the laser may have.
        where: (H, W) pixels in which the line may lie; None: anywhere.
    """
    levels = _orient(picture, axis)
    if min(levels.shape[1:]) < LEAST_SIDE_PX:
        return None
    allowed = None
    if where is not None:
        allowed = np.asarray(where if axis == "u" else where.T, np.float32)
    first = [(*_rough_line(levels, colour, allowed), colour) for colour in colours]
    score, width_px, colour = max(first)
    if not score:
        return None
    planes = split_planes(levels, colour)
    smooth_px = max(LEAST_FINE, FINE * width_px), max(LEAST_COARSE, COARSE * width_px)
    pieces = select_line(_pieces(planes, smooth_px, allowed))
    if not pieces:
        return None
    rows = np.full(levels.shape[2], -1)
    for piece in pieces:
        rows[piece.columns] = piece.rows
    width_px = _width_px(planes, pieces)
    combination, points = _measure(levels, planes, rows, width_px)
    if not len(points.columns):
        return None
    return ColouredLine(
        colour, _line_of_points(points, axis, width_px, levels.shape[2]), combination
    )


def _orient(picture: Colours, axis: str) -> Levels:
    """(3, H, W) with the line across the columns, of full scale 255."""
    planes = picture[..., :3].transpose((2, 0, 1) if axis == "u" else (2, 1, 0))
    full = max(saturation_level(picture[..., plane]) for plane in range(3))
    return np.ascontiguousarray(planes, dtype=np.float32) * np.float32(FULL_LEVEL / full)


def _rough_line(levels: Levels, colour: LaserColour, allowed: Levels | None) -> tuple[float, float]:
    """How much of a line of a colour a picture shows, and its width in pixels."""
    factor = 2 if max(levels.shape) > SMALL_PX else 1
    if factor > 1:
        size = (levels.shape[2] // factor, levels.shape[1] // factor)
        levels = np.stack([cv2.resize(one, size, interpolation=cv2.INTER_AREA) for one in levels])
        if allowed is not None:
            small = cv2.resize(allowed, size, interpolation=cv2.INTER_NEAREST)
            allowed = np.asarray(small, np.float32)
    planes = split_planes(levels, colour)
    pieces = _pieces(planes, None, allowed)
    anchors = [piece for piece in pieces if piece.is_anchor]
    if not anchors:
        return 0.0, 0.0
    return anchor_score(pieces), factor * _width_px(planes, anchors)


def _pieces(
    planes: Planes, smooth_px: tuple[float, ...] | None, allowed: Levels | None
) -> list[LinePiece]:
    """The pieces of the best path; of the next one, if that shows more without other things."""
    ridges = find_ridges(planes) if smooth_px is None else find_ridges(planes, smooth_px)
    score = ridges.score if allowed is None else ridges.score * allowed
    best: list[LinePiece] = []
    for _ in range(MOST_PATHS):
        pieces = split_path(best_path(score), ridges, planes)
        if anchor_score(pieces) > anchor_score(best) or not best:
            best = pieces
        others = [piece for piece in pieces if piece.is_other]
        if not others:
            break
        score = score.copy()
        for piece in others:
            off = round(BESIDE * float(ridges.smooth_px[piece.rows, piece.columns].max())) + 2
            at = piece.rows + np.arange(-off, off + 1)[:, None]
            score[np.clip(at, 0, score.shape[0] - 1), piece.columns] = 0
    return best


def _width_px(planes: Planes, pieces: Sequence[LinePiece]) -> float:
    """The width at half height of the excess of pieces, by its median profile."""
    columns = np.concatenate([piece.columns for piece in pieces])
    rows = np.concatenate([piece.rows for piece in pieces])
    offsets = np.arange(-PROFILE_PX, PROFILE_PX + 1)[:, None]
    at = np.clip(rows + offsets, 0, planes.own.shape[0] - 1)
    profile = np.median(planes.excess[at, columns], axis=1)
    top = float(profile[PROFILE_PX - 2 : PROFILE_PX + 3].max())
    width_px = 0.0
    for side in (profile[PROFILE_PX:], profile[PROFILE_PX::-1]):
        base = float(side[:BASE_PX].min())
        below = np.flatnonzero(side < (top + base) / 2)
        width_px += float(below[0]) - 0.5 if len(below) else float(PROFILE_PX)
    return max(width_px, 1.0)


def _measure(
    levels: Levels, planes: Planes, rows: NDArray[np.int64], width_px: float
) -> tuple[str, CentrePoints]:
    """The points on the combination of channels on which they scatter least, and its name.

    What the channel shows beyond the others does not depend on how bright the surface is, whose
    edges pull a line aside: another combination has to be clearly quieter.
    """
    combinations = {
        "own": planes.own,
        BEYOND: planes.excess,
        "all": np.asarray(levels.mean(axis=0), np.float32),
    }
    measured = {name: measure_line(image, rows, width_px) for name, image in combinations.items()}
    name = min(measured, key=lambda one: measured[one].scatter_px)
    if measured[name].scatter_px > QUIETER * measured[BEYOND].scatter_px:
        name = BEYOND
    return name, measured[name]


def _line_of_points(points: CentrePoints, axis: str, width_px: float, columns: int) -> FoundLine:
    table = np.stack([points.columns, points.rows, points.height, points.sigma_px])
    share = len(points.columns) / columns
    evidence = share * float(np.median(points.height))
    stripe = stripe_from_points(table.astype(np.float64), axis)
    return FoundLine(stripe, evidence, share, FULL, width_px * PER_FULL_WIDTH)
