"""Boards that are seen at a slant too steep to measure them."""

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.messages.message import Text, message, quantity
from crenel.metrology.chessboard.lattice import find_lattices
from crenel.metrology.chessboard.missing_corners import CornerGrid
from crenel.metrology.chessboard.saddle_points import find_saddles
from crenel.metrology.chessboard.window import find_window
from crenel.metrology.image import Image
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.transforms import Floats

# Squares smaller than this show no regular grid of saddles.
LEAST_SPACING_PX = 5.0
# Squares that appear so many times as wide as high are seen at a slant of 70 degrees.
SLANTED = 2.9
# The picture is stretched so many times, in so many directions, to so many pixels at most.
STRETCHES, DIRECTIONS, MOST_PX = (4.0, 7.0), 8, 2.0e6
# Share of the board's corners that show it in a stretched picture.
LEAST_SEEN = 0.5


def explain_slant(steps_px: Floats) -> tuple[Text, Text]:
    """Why squares that appear so wide and so high (2,) are not measured, and what to do."""
    share = float(np.clip(steps_px[1] / max(steps_px[0], 1e-3), 1e-3, 1.0))
    slant = quantity(float(np.degrees(np.arccos(share))), "°", 0)
    times = quantity(1 / share, "", 1)
    return message("board-seen-at-a-slant", slant=slant, times=times), message("tilt-board-less")


def is_slanted(grid: CornerGrid) -> bool:
    """Whether a grid is seen at a slant of 70 degrees or more."""
    if min(grid.extent) < 2:
        return False
    wide_px, high_px = grid.steps_px()
    return bool(wide_px > max(SLANTED * high_px, LEAST_SPACING_PX))


def find_slanted_board(
    image: Image, blocked: NDArray[np.bool_], board: Chessboard
) -> CornerGrid | None:
    """The board's corners, roughly, if it is seen at a slant; None if it is not, or not there.

    Its corners are joined along diagonals, if at all, as these are shorter than its rows: it is
    looked for in the picture stretched across the slant.
    """
    least = LEAST_SEEN * board.inner_corners[0] * board.inner_corners[1]
    for stretch in STRETCHES:
        for step in range(DIRECTIONS):
            A = _stretch(image, np.pi * step / DIRECTIONS, stretch)
            size = _size_px(image, A)
            turned = cv2.warpAffine(
                image.astype(np.float32), A, size, borderMode=cv2.BORDER_REPLICATE
            )
            hidden = np.zeros(turned.shape, np.bool_)
            if blocked.any():
                hidden = cv2.warpAffine(blocked.astype(np.uint8), A, size) > 0
            saddles = find_saddles(np.asarray(turned, np.float32), hidden)
            back = cv2.invertAffineTransform(A)
            for lattice in find_lattices(saddles, int(np.prod(board.inner_corners)))[:1]:
                places = np.array(list(lattice), dtype=np.int64)
                within = find_window(places, board.inner_corners)
                if within is None or within.sum() < least:
                    continue
                uv_px = saddles.uv_px[list(lattice.values())] @ back[:, :2].T + back[:, 2]
                grid = CornerGrid(image, blocked, places[within], uv_px[within])
                if is_slanted(grid):
                    return grid
    return None


def _stretch(image: Image, along_rad: float, stretch: float) -> Floats:
    """(2, 3) the picture turned and stretched along a direction, with its corner at the origin."""
    scale = min(1.0, float(np.sqrt(MOST_PX / (stretch * image.size))))
    c, s = np.cos(along_rad), np.sin(along_rad)
    turn = np.array([[scale, 0.0], [0.0, scale * stretch]]) @ [[c, s], [-s, c]]
    return np.column_stack([turn, -(_corners_px(image) @ turn.T).min(axis=0)])


def _size_px(image: Image, A: Floats) -> tuple[int, int]:
    width, height = np.ceil((_corners_px(image) @ A[:, :2].T + A[:, 2]).max(axis=0)) + 1
    return int(width), int(height)


def _corners_px(image: Image) -> Floats:
    height, width = image.shape
    return np.array([[0.0, 0.0], [width, 0.0], [0.0, height], [width, height]])
