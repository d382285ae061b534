"""The detection of the object in a picture, for drawing: its corners and its outline. Pure."""

from dataclasses import dataclass

import numpy as np

from crenel.metrology.chessboard.board_detection import BoardDetection
from crenel.metrology.chessboard.detect_board import detect_board
from crenel.metrology.chessboard.laser_light import drop_faint_stripe
from crenel.metrology.chessboard.perspective import fit_perspective, map_places
from crenel.metrology.detection.detect_block import ObjectDetection, detect_object
from crenel.metrology.detection.image_quality import Image
from crenel.metrology.detection.visibility import visible_parts
from crenel.metrology.sensor.camera import project
from crenel.metrology.stripe import Stripe
from crenel.metrology.targets.chessboard import Chessboard, corner_grid
from crenel.metrology.targets.crenellated_block import Crenellated, corners
from crenel.metrology.targets.target import CalibrationTarget, board_lines

Segment = tuple[float, float, float, float]
"""A line in the picture: u0, v0, u1, v1."""


@dataclass(frozen=True)
class DetectedCorner:
    """A corner detected in a picture; as ``ImageCorner`` of the browser's types."""

    name: str
    u: float
    v: float
    residual_px: float | None


@dataclass(frozen=True)
class TargetOverlay:
    """The object in a picture: each corner with its distance from the position that fits all of
    them."""

    corners: tuple[DetectedCorner, ...] = ()
    outline: tuple[Segment, ...] = ()


def detect_target(image: Image, item: CalibrationTarget, stripe: Stripe | None) -> TargetOverlay:
    """The object detected in a picture; raises ``OperationError`` if it is not detected.

    Args:
        stripe: of the same picture, if the laser was on.
    """
    if isinstance(item, Chessboard):
        line = stripe and drop_faint_stripe(image, stripe)
        return board_overlay(detect_board(image, item, line, thorough=False), item)
    return block_overlay(detect_object(image, item, stripe), item)


def block_overlay(found: ObjectDetection, block: Crenellated) -> TargetOverlay:
    """A block by the camera that was fitted to it, without hidden edges."""
    points = corners(block)
    at = project(found.camera, np.array([points[corner.name] for corner in found.corners]))
    parts = visible_parts(block, found.camera.centre_mm)
    ends = project(
        found.camera, np.array([(part.start_mm, part.end_mm) for part in parts]).reshape(-1, 3)
    )
    return TargetOverlay(
        tuple(
            DetectedCorner(c.name, c.u, c.v, float(np.hypot(c.u - u, c.v - v)))
            for c, (u, v) in zip(found.corners, at, strict=True)
        ),
        tuple((float(a), float(b), float(c), float(d)) for a, b, c, d in ends.reshape(-1, 4)),
    )


def board_overlay(found: BoardDetection, board: Chessboard) -> TargetOverlay:
    """A board by one perspective of all its corners."""
    places = corner_grid(board)[found.number]
    to_picture = fit_perspective(places, found.uv_px)
    off = np.linalg.norm(found.uv_px - map_places(to_picture, places), axis=1)
    border = board_lines(board)[:4, :, :2].reshape(-1, 2) / board.square_mm
    ends = map_places(to_picture, border)
    return TargetOverlay(
        tuple(
            DetectedCorner(f"{column},{row}", float(u), float(v), float(px))
            for (column, row), (u, v), px in zip(places.tolist(), found.uv_px, off, strict=True)
        ),
        tuple((float(a), float(b), float(c), float(d)) for a, b, c, d in ends.reshape(-1, 4)),
    )
