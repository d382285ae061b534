"""Why the markers of a board that is in the picture were not read, as far as the picture tells."""

import cv2
import numpy as np

from crenel.errors import OperationError
from crenel.messages.limits import beside_limit
from crenel.messages.message import Text, message
from crenel.metrology.chessboard.charuco_board.arrangement import (
    FEWEST_MARKERS,
    arrangement_of,
    fit_arrangement,
)
from crenel.metrology.chessboard.charuco_board.charuco_grid import marker_squares
from crenel.metrology.chessboard.charuco_board.marker_reading import BoardReading
from crenel.metrology.chessboard.failure_evidence import fail_with_marks
from crenel.metrology.chessboard.lattice import find_lattices
from crenel.metrology.chessboard.missing_corners import CornerGrid
from crenel.metrology.chessboard.perspective import map_places, perspective_steps_px
from crenel.metrology.chessboard.saddle_points import find_saddles
from crenel.metrology.chessboard.slanted_board import SLANTED, explain_slant
from crenel.metrology.detection.failure_evidence import DetectionError, Fault
from crenel.metrology.detection.image_quality import image_findings
from crenel.metrology.image import Image
from crenel.metrology.targets.chessboard import Chessboard, Markers
from crenel.metrology.transforms import Floats

# Cells of markers that are narrower than this are hardly read.
LEAST_CELL_PX = 3.0
FEWEST_OF_A_GRID = 9
SURELY_READ_PX = 5.0
"""Cells this wide in a sharp picture are read, if they are there."""


def explain_unread(
    image: Image, board: Chessboard, markers: Markers, reading: BoardReading, *, thorough: bool
) -> DetectionError:
    """The error: what was read, and the likely cause.

    Args:
        image: (H, W) grey, 8 to 16 bits.
        reading: what was read of the board's dictionary; nothing in it says another board.
        thorough: where too few markers say where the board is, look for its squares.
    """
    columns, rows = board.inner_corners
    count = (columns + 1) * (rows + 1) // 2
    ids = list(marker_squares(board, markers))
    own = int(np.isin(reading.markers, ids).sum())
    stated = arrangement_of(board, markers)
    _, H = fit_arrangement(reading, stated, markers.side_mm / board.square_mm)
    steps_px = None if H is None else perspective_steps_px(H, np.array([columns, rows]) / 2)
    if H is None and own:
        sides_px = np.diff(reading.outlines_px, axis=1)[:, :2]
        share = markers.side_mm / board.square_mm
        steps_px = np.median(np.linalg.svd(sides_px, compute_uv=False), axis=0) / share
    elif H is None and thorough:
        grid = _find_squares(image, board)
        steps_px = None if grid is None else grid.steps_px()
    what = (
        message("markers-of-board-read", found=own, count=count, name=board.name)
        if own
        else message("no-markers-found", dictionary=markers.dictionary, name=board.name)
    )
    code = "board-partly-seen" if own else "board-not-found"
    fault, why, remedy = _cause(image, board, markers, own, H, steps_px)
    if steps_px is not None and own == 0 and remedy is _LISTED[2]:
        cell_px = float(min(steps_px)) * _cell_share(board, markers)
        if cell_px > SURELY_READ_PX and not image_findings(image):
            why, remedy = message("squares-without-markers"), message("give-kind-chessboard")
    if fault == "framing" and steps_px is not None and max(steps_px) > SLANTED * min(steps_px):
        code = "board-slanted"
    return fail_with_marks(
        OperationError(code, what, why, remedy), fault, image, reading.annotations, guessed=True
    )


_LISTED: tuple[Fault, Text, Text] = (
    "framing",
    message("markers-covered-too-small-or-blurred"),
    message("bring-board-with-markers-into-picture"),
)


def _cause(
    image: Image,
    board: Chessboard,
    markers: Markers,
    own: int,
    H: Floats | None,
    steps_px: Floats | None,
) -> tuple[Fault, Text, Text]:
    if steps_px is not None:
        if max(steps_px) > SLANTED * min(steps_px):
            return ("framing", *explain_slant(steps_px))
        cell_px = float(min(steps_px)) * _cell_share(board, markers)
        if cell_px < LEAST_CELL_PX:
            width, least = beside_limit(cell_px, LEAST_CELL_PX, "px", 1)
            why = message("marker-cells-too-small", width=width, least=least)
            return "framing", why, message("bring-camera-nearer-to-board")
    if H is not None and _is_partly_outside(image, board, H):
        return (
            "framing",
            message("board-partly-out-of-picture"),
            message("bring-more-of-board-into-picture"),
        )
    if H is not None:
        return "framing", message("others-are-covered"), message("uncover-board-light-evenly")
    if own:
        why = message("so-few-markers-tell-nothing", fewest=FEWEST_MARKERS)
        return "framing", why, message("uncover-or-bring-more-of-board")
    return _LISTED


def _find_squares(image: Image, board: Chessboard) -> CornerGrid | None:
    """The largest grid of squares in the picture."""
    unblocked = np.zeros(image.shape, np.bool_)
    saddles = find_saddles(image, unblocked)
    for lattice in find_lattices(saddles, int(np.prod(board.inner_corners)))[:1]:
        grid = CornerGrid(
            image, unblocked, np.array(list(lattice)), saddles.uv_px[list(lattice.values())]
        )
        if len(lattice) >= FEWEST_OF_A_GRID and min(grid.extent) >= 2:
            return grid
    return None


def _cell_share(board: Chessboard, markers: Markers) -> float:
    """The width of a marker's cell, in squares."""
    dictionary = cv2.aruco.getPredefinedDictionary(getattr(cv2.aruco, markers.dictionary))
    return markers.side_mm / board.square_mm / (dictionary.markerSize + 2)


def _is_partly_outside(image: Image, board: Chessboard, H: Floats) -> bool:
    """Whether an outermost inner corner lies out of the picture."""
    columns, rows = board.inner_corners
    ends = np.array([[1, 1], [columns, 1], [columns, rows], [1, rows]])
    uv_px = map_places(H, ends)
    return bool((uv_px < 0).any() or (uv_px > np.array(image.shape[::-1]) - 1).any())
