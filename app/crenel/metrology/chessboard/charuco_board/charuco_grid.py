"""Where the corners and the markers of a ChArUco board lie in a picture, by the corners known."""

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.metrology.chessboard.perspective import predict_corner
from crenel.metrology.targets.chessboard import Chessboard, Markers, corner_grid
from crenel.metrology.transforms import Floats

# A marker's blurred outline reaches so far, px.
OUTLINE_PX = 2


def charuco_board(board: Chessboard, markers: Markers) -> cv2.aruco.CharucoBoard:
    """The board as OpenCV has it, in mm."""
    columns, rows = board.inner_corners
    dictionary = cv2.aruco.getPredefinedDictionary(getattr(cv2.aruco, markers.dictionary))
    count = (columns + 1) * (rows + 1) // 2
    made = cv2.aruco.CharucoBoard(
        (columns + 1, rows + 1),
        board.square_mm,
        markers.side_mm,
        dictionary,
        np.arange(markers.first_id, markers.first_id + count),
    )
    made.setLegacyPattern(markers.legacy)
    return made


def marker_squares(board: Chessboard, markers: Markers) -> dict[int, tuple[int, int]]:
    """The square of each marker by its id: column and row of the corner at its lower left."""
    made = charuco_board(board, markers)
    rows = board.inner_corners[1]
    squares = {}
    for marker, ends in zip(np.ravel(made.getIds()).tolist(), made.getObjPoints(), strict=True):
        right, down = (int(x) for x in np.mean(ends, axis=0)[:2] // board.square_mm)
        squares[marker] = right - 1, rows - 1 - down
    return squares


@dataclass(frozen=True)
class CornerStart:
    """Where a corner is to be measured."""

    uv_px: Floats
    phase: float
    spacing_px: float


class CharucoGrid:
    """Where the places of a board lie in a picture, by the corners known."""

    def __init__(self, board: Chessboard, known: dict[int, Floats]) -> None:
        self._board = board
        self._places = corner_grid(board)[list(known)]
        self._uv_px = np.array(list(known.values()))
        self._known = known
        self._squares: dict[tuple[int, int], Floats | None] = {}

    def __contains__(self, number: int) -> bool:
        i, j = corner_grid(self._board)[number].tolist()
        return all(self._at(*place) is not None for place in ((i, j), (i + 1, j), (i, j + 1)))

    def at(self, number: int) -> CornerStart:
        i, j = corner_grid(self._board)[number].tolist()
        here, right, up = self._at(i, j), self._at(i + 1, j), self._at(i, j + 1)
        assert here is not None
        assert right is not None
        assert up is not None
        white = right + up - 2 * here if self._is_white(i, j) else up - right
        phase = -2 * float(np.arctan2(white[1], white[0]))
        spacing = min(float(np.linalg.norm(right - here)), float(np.linalg.norm(up - here)))
        return CornerStart(here, phase, spacing)

    def _is_white(self, i: int, j: int) -> bool:
        """Whether the square to the upper right of a corner is white, and has a marker."""
        return (i + j) % 2 == (1 if self._board.first_is_black else 0)

    def _at(self, i: int, j: int) -> Floats | None:
        """The pixel of a place, which may lie a square beyond the corners."""
        if (i, j) not in self._squares:
            columns, rows = self._board.inner_corners
            inside = 0 <= i < columns and 0 <= j < rows
            uv = self._known.get(j * columns + i) if inside else None
            if uv is None:
                place = np.array([i, j])
                predicted = predict_corner(self._places, self._uv_px, place, certain=True)
                uv = None if predicted is None else predicted[0]
            self._squares[i, j] = uv
        return self._squares[i, j]

    def square_px(self, i: int, j: int) -> Floats | None:
        """(4, 2) the pixels of a square's corners, around it; None where they are not known."""
        ends = [self._at(i + a, j + b) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
        known = [end for end in ends if end is not None]
        return np.array(known) if len(known) == len(ends) else None

    def mask_markers(self, shape: tuple[int, ...], markers: Markers) -> NDArray[np.bool_]:
        """(H, W) the pixels of all markers, with their blurred outlines."""
        columns, rows = self._board.inner_corners
        rim = (1 - markers.side_mm / self._board.square_mm) / 2
        shares = np.array([(rim, rim), (1 - rim, rim), (1 - rim, 1 - rim), (rim, 1 - rim)])
        mask = np.zeros(shape, np.uint8)
        for i in range(-1, columns):
            for j in range(-1, rows):
                square = self.square_px(i, j)
                if square is None or not self._is_white(i, j):
                    continue
                a, b = shares.T
                weights = np.column_stack([(1 - a) * (1 - b), a * (1 - b), a * b, (1 - a) * b])
                quad = np.clip(weights @ square, -1e4, 1e4)
                cv2.fillConvexPoly(mask, np.round(quad).astype(np.int32), 1)
        size = 2 * OUTLINE_PX + 1
        return np.asarray(cv2.dilate(mask, np.ones((size, size), np.uint8)) > 0)
