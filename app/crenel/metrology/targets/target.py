"""Calibration targets: a crenellated block, or a flat chessboard."""

import numpy as np

from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.targets import chessboard as boards
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.targets.crenellated_block import Crenellated, edges
from crenel.metrology.transforms import Floats

CalibrationTarget = Crenellated | Chessboard

PixelSegment = tuple[tuple[float, float], tuple[float, float]]
"""A line of a drawing: the pixels of its two ends."""


def is_nominal(item: CalibrationTarget) -> bool:
    """Whether it is a block of which only the drawing is known."""
    return isinstance(item, Crenellated) and item.is_nominal


def target_centre(item: CalibrationTarget) -> Floats:
    """The point about which the sensor is held.

    Returns:
        (3,) mm in the object frame: midway between floors and crests for a block, the centre of
        the pattern for a board.
    """
    if isinstance(item, Chessboard):
        return boards.pattern_centre(item)
    x = item.edges_x_mm
    return np.array(
        [
            (x[0] + x[-1]) / 2,
            (item.front_y_mm + item.back_y_mm) / 2,
            (item.floor_z_mm + item.crest_z_mm) / 2,
        ]
    )


def width_mm(item: CalibrationTarget) -> float:
    """Extent of the target along X, mm.

    Returns:
        Across the merlons for a block, along the rows of the pattern for a board, including the
        outermost squares.
    """
    if isinstance(item, Chessboard):
        return float(item.square_mm * (item.inner_corners[0] + 1))
    return float(item.edges_x_mm[-1] - item.edges_x_mm[0])


def outline(camera: Camera, item: CalibrationTarget) -> tuple[PixelSegment, ...]:
    """Lines that draw the target in an image.

    Args:
        camera: with the object frame as its sensor frame.

    Returns:
        Pairs of pixels ((u0, v0), (u1, v1)): for a block, the edges of its crests and floors;
        for a board, the border of its pattern and two lines across.
    """
    if isinstance(item, Chessboard):
        ends_mm = board_lines(item)
    else:
        ends_mm = np.array(
            [
                (edge.start_mm, edge.end_mm)
                for edge in edges(item)
                if not edge.name.startswith("base")
            ]
        )
    return tuple(
        ((float(u0), float(v0)), (float(u1), float(v1)))
        for u0, v0, u1, v1 in project(camera, ends_mm.reshape(-1, 3)).reshape(-1, 4)
    )


def board_lines(board: Chessboard) -> Floats:
    """(6, 2, 3) ends of the pattern's border and of the lines through its middle, mm."""
    low = np.full(2, -board.square_mm)
    high = board.square_mm * np.array(board.inner_corners, dtype=np.float64)
    middle = boards.pattern_centre(board)[:2]
    (x0, y0), (x1, y1), (xm, ym) = low, high, middle
    lines = [
        ((x0, y0), (x1, y0)),
        ((x1, y0), (x1, y1)),
        ((x1, y1), (x0, y1)),
        ((x0, y1), (x0, y0)),
        ((x0, ym), (x1, ym)),
        ((xm, y0), (xm, y1)),
    ]
    return np.array([[(*a, 0.0), (*b, 0.0)] for a, b in lines])
