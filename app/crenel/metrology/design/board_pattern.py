"""The pattern of a board to print: its squares and markers, and its true size once measured."""

from dataclasses import dataclass, replace

import cv2
import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import message, quantity
from crenel.metrology.targets.chessboard import Chessboard, Markers
from crenel.metrology.transforms import Floats

FARTHEST_SHARE = 0.1
"""A printer that is off by more than this share printed something else."""


@dataclass(frozen=True)
class BoardPattern:
    """Rectangles (N, 4) as left, bottom, right, top in mm, from the pattern's lower left corner.

    ``black`` are squares and markers, ``white`` (one array for each marker) the cells on them.
    """

    size_mm: tuple[float, float]
    black: Floats
    white: tuple[Floats, ...]


def board_pattern(board: Chessboard) -> BoardPattern:
    """What is printed of a board: of a ChArUco board, as OpenCV's ``CharucoBoard`` has it.

    Example:
        >>> pattern = board_pattern(Chessboard("C", "1", (3, 2), 10.0, 0.05))
        >>> pattern.size_mm, len(pattern.black), pattern.black[0].tolist()
        ((40.0, 30.0), 6, [0.0, 0.0, 10.0, 10.0])
    """
    columns, rows = (count + 1 for count in board.inner_corners)
    side = board.square_mm
    first = 0 if board.first_is_black else 1
    places = [(column, row) for row in range(rows) for column in range(columns)]
    squares = [place for place in places if sum(place) % 2 == first]
    black = [(x * side, y * side, (x + 1) * side, (y + 1) * side) for x, y in squares]
    white: list[Floats] = []
    if board.markers is not None:
        # OpenCV numbers the markers from the upper left, row by row
        others = [place for place in places if sum(place) % 2 != first]
        others.sort(key=lambda place: (-place[1], place[0]))
        for number, (column, row) in enumerate(others, board.markers.first_id):
            low = np.array([column + 0.5, row + 0.5]) * side - board.markers.side_mm / 2
            black.append((*low, *(low + board.markers.side_mm)))
            white.append(_white_cells(board.markers, number, low))
    return BoardPattern((columns * side, rows * side), np.array(black), tuple(white))


def _white_cells(markers: Markers, number: int, low_mm: Floats) -> Floats:
    """Rectangles (N, 4) of a marker's white cells, those beside each other in one."""
    dictionary = cv2.aruco.getPredefinedDictionary(getattr(cv2.aruco, markers.dictionary))
    cells = dictionary.markerSize + 2
    image = cv2.aruco.generateImageMarker(dictionary, number, cells) > 0
    cell_mm = markers.side_mm / cells
    found = []
    for down, row in enumerate(image):
        ends = np.flatnonzero(np.diff(np.pad(row.astype(np.int8), 1)))
        for begin, end in ends.reshape(-1, 2):
            top = cells - down
            found.append((begin, top - 1, end, top))
    return np.array(found, dtype=np.float64).reshape(-1, 4) * cell_mm + np.tile(low_mm, 2)


def scale_board(
    board: Chessboard, measured_mm: tuple[float, float], measured_sd_mm: float
) -> Chessboard:
    """The board as printed, by the measured width and height of its whole pattern.

    Its squares are as wide as the mean of both scales; what width and height differ from that,
    and the uncertainty of the measurement, become the uncertainty of the pattern's size.

    Args:
        measured_mm: width and height over all squares.
        measured_sd_mm: standard uncertainty of each.

    Raises:
        OperationError: ``board-scale``, where they cannot belong to this board.
    """
    nominal = np.array(board_pattern(board).size_mm)
    scales = np.array(measured_mm) / nominal
    for measured, expected, scale in zip(measured_mm, nominal, scales, strict=True):
        if abs(scale - 1) > FARTHEST_SHARE:
            raise OperationError(
                "board-scale",
                message(
                    "board-measures-otherwise",
                    measured=quantity(measured, "mm", 1),
                    expected=quantity(float(expected), "mm", 1),
                ),
                "",
                message("board-measure-whole-pattern"),
            )
    scale = float(scales.mean())
    differs_mm = float(np.ptp(scales)) / 2 * float(board.extent_mm.max())
    markers = board.markers
    return replace(
        board,
        square_mm=scale * board.square_mm,
        markers=None if markers is None else replace(markers, side_mm=scale * markers.side_mm),
        standard_uncertainty_mm=float(np.hypot(measured_sd_mm, differs_mm)),
    )
