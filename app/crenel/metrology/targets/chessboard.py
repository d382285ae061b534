"""The flat chessboard from its certificate.

Its frame lies at the first inner corner, X along the rows, Z out of the board towards the
camera. First is the corner whose outermost square is black; where the colours leave a
choice, every choice is as good as long as all pictures share it. Of a ChArUco board, first is
the corner at the lower left, where OpenCV has the first marker at the upper left.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.transforms import Floats

# Number of markers in each of OpenCV's dictionaries.
DICTIONARIES = {
    **{
        f"DICT_{bits}X{bits}_{count}": count
        for bits in (4, 5, 6, 7)
        for count in (50, 100, 250, 1000)
    },
    "DICT_ARUCO_ORIGINAL": 1024,
    "DICT_ARUCO_MIP_36h12": 250,
    "DICT_APRILTAG_16h5": 30,
    "DICT_APRILTAG_25h9": 35,
    "DICT_APRILTAG_36h10": 2320,
    "DICT_APRILTAG_36h11": 587,
}


@dataclass(frozen=True)
class Markers:
    """The markers in the white squares of a ChArUco board, by one of OpenCV's ``DICTIONARIES``.

    ``legacy`` is the arrangement of OpenCV before 4.6, which differs if the rows of squares are
    even in number. The ids count up from ``first_id``, as on the second board of a set.
    """

    dictionary: str
    side_mm: float
    legacy: bool = False
    first_id: int = 0


@dataclass(frozen=True)
class Chessboard:
    """A board whose inner corners (where four squares meet) form columns and rows.

    ``standard_uncertainty_mm`` is that of the pattern's width and of its height, between the
    outermost inner corners; ``flatness_mm`` is the typical bend of the board over the pattern.
    With ``markers`` it is a ChArUco board.
    """

    name: str
    serial_number: str
    inner_corners: tuple[int, int]  # columns, rows
    square_mm: float
    standard_uncertainty_mm: float
    flatness_mm: float = 0.3
    markers: Markers | None = None

    @property
    def first_is_black(self) -> bool:
        """Whether the outermost square at the first corner is black."""
        if self.markers is None:
            return True
        # the upper left square is black, but in a legacy pattern of an even number of rows
        rows = self.inner_corners[1] + 1
        return rows % 2 == 1 or self.markers.legacy

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
