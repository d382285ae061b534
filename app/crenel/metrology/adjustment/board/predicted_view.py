"""Prediction, without noise, of what a picture of the chessboard would show from a new pose."""

from dataclasses import replace

import numpy as np

from crenel.metrology.adjustment.block.predicted_view import (
    STRIPE_STEP_PX,
    ObservationNoise,
    inside,
)
from crenel.metrology.adjustment.board.observations import BoardView
from crenel.metrology.chessboard.board_detection import BoardDetection
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.stripe import Stripe
from crenel.metrology.targets.chessboard import Chessboard, corner_points
from crenel.metrology.targets.target import board_lines
from crenel.metrology.transforms import Floats

# Margin of the pattern from the border of the picture: detection needs all corners.
BORDER_PX = 4.0
# Number of places along each side of the pattern where the line is searched.
PLACES = 400


def is_fully_visible(camera: Camera, board: Chessboard) -> bool:
    """Whether the complete pattern is in the picture, seen from its printed side."""
    uv = project(camera, board_lines(board).reshape(-1, 3))
    in_front = float(camera.centre_mm[2]) > 0
    return in_front and bool(inside(camera, uv, BORDER_PX).all())


def predict_board_view(
    camera: Camera, plane: LaserPlane, like: BoardView, seeing: ObservationNoise
) -> BoardView:
    """Corners and laser line as a camera would measure them.

    Args:
        camera, plane: with the board's frame as sensor frame.
        like: an existing picture whose corners and line have the same noise.
    """
    board = like.board
    uv = project(camera, corner_points(board))
    number = np.flatnonzero(inside(camera, uv, BORDER_PX))
    covariance = np.tile(seeing.corner_px**2 * np.eye(2), (len(number), 1, 1))
    line = _predict_line(camera, plane, board, seeing)
    sigma = np.full(len(line), seeing.stripe_px * seeing.sd_factor)
    return replace(
        like,
        detection=BoardDetection(uv[number], covariance, number),
        stripe=Stripe(line[:, 0], line[:, 1], np.full(len(line), 150.0), sigma, seeing.axis),
        used=np.ones(len(line), dtype=np.bool_),
    )


def _predict_line(
    camera: Camera, plane: LaserPlane, board: Chessboard, seeing: ObservationNoise
) -> Floats:
    """(N, 2) pixels in which the laser plane intersects the pattern."""
    n = plane.normal
    side = int(np.argmax(np.abs(n[:2])))  # the coordinate that the plane cuts steeply
    low = -board.square_mm
    high = board.square_mm * np.array(board.inner_corners, dtype=np.float64)
    along = np.linspace(low, high[1 - side], PLACES)
    across = (plane.offset_mm - n[1 - side] * along) / n[side]
    on = (across > low) & (across < high[side])
    points = np.zeros((int(on.sum()), 3))
    points[:, 1 - side], points[:, side] = along[on], across[on]
    if len(points) < 2:
        return np.zeros((0, 2))
    uv = project(camera, points)
    step = float(np.linalg.norm(uv[-1] - uv[0])) / (len(uv) - 1)
    uv = uv[:: max(1, round(STRIPE_STEP_PX * seeing.bin_size / max(step, 1e-6)))]
    return np.asarray(uv[inside(camera, uv, BORDER_PX)])
