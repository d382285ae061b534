"""The flat chessboard from its certificate.

Its frame lies at the first inner corner, X along the rows, Z out of the board towards the
camera. First is the corner whose outermost square is black; where the colours leave a
choice, every choice is as good as long as all pictures share it.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.metrology.transforms import Floats


@dataclass(frozen=True)
class Chessboard:
    """A board whose inner corners (where four squares meet) form columns and rows.

    ``standard_uncertainty_mm`` is that of the pattern's width and of its height, between the
    outermost inner corners; ``flatness_mm`` is the typical bend of the board over the pattern.
    """

    name: str
    serial_number: str
    inner_corners: tuple[int, int]  # columns, rows
    square_mm: float
    standard_uncertainty_mm: float
    flatness_mm: float = 0.3

    @property
    def extent_mm(self) -> Floats:
        """(2,) between the outermost inner corners, along X and along Y."""
        return self.square_mm * (np.array(self.inner_corners, dtype=np.float64) - 1)

    @property
    def size_mm(self) -> float:
        """The pattern's diagonal between its outermost inner corners."""
        return float(np.linalg.norm(self.extent_mm))


def corner_grid(board: Chessboard) -> NDArray[np.int64]:
    """Column and row of every inner corner, row after row.

    Returns:
        (N, 2); the first corner has column 0 and row 0.
    """
    columns, rows = board.inner_corners
    row, column = np.divmod(np.arange(columns * rows), columns)
    return np.column_stack([column, row]).astype(np.int64)


def corner_points(board: Chessboard) -> Floats:
    """Nominal positions of the inner corners.

    Returns:
        (N, 3) mm in the frame of the board, in the order of ``corner_grid``.

    Example:
        >>> corner_points(Chessboard("C", "1", (3, 2), 10.0, 0.01)).tolist()[:4]
        [[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [20.0, 0.0, 0.0], [0.0, 10.0, 0.0]]
    """
    flat = corner_grid(board) * board.square_mm
    return np.column_stack([flat, np.zeros(len(flat))])


def pattern_centre(board: Chessboard) -> Floats:
    """The centre of the pattern.

    Returns:
        (3,) mm in the frame of the board.
    """
    return np.array([*(board.extent_mm / 2), 0.0])
