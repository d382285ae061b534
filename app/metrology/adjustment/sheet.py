"""The sheet that carries a chessboard: its corners' true places, and how it bends.

Its coordinates are the pattern's width and height, the heights (mm) by which a smooth
bend lifts it half a diagonal off the middle, and what each corner is misprinted by.
"""

from dataclasses import dataclass

import numpy as np

from app.metrology.adjustment.evidence import Papers
from app.metrology.chessboard.board import Chessboard, grid
from app.metrology.frames import Floats

# Powers of x and y in the bend; a board's place takes up what is constant or linear.
BENDS = ((2, 0), (1, 1), (0, 2), (3, 0), (2, 1), (1, 2), (0, 3))
EXTENT = slice(0, 2)
BEND = slice(2, 2 + len(BENDS))
LEAST_MM = 1e-6


@dataclass(frozen=True)
class Surface:
    """The sheet at N places: heights (N,), and slopes (N, 2) along x and y."""

    height_mm: Floats
    slope: Floats
    by_bend: Floats  # (N, 7) derivatives of the height


def board_papers(board: Chessboard) -> Papers:
    """The certificate: extents and corners to its standard uncertainty, flat to its flatness."""
    count = len(grid(board))
    names = ("extent_x", "extent_y", *(f"bend:x{i}y{j}" for i, j in BENDS))
    names += tuple(f"print_x:{k}" for k in range(count))
    names += tuple(f"print_y:{k}" for k in range(count))
    values = np.zeros(len(names))
    values[EXTENT] = board.extent_mm
    sd = np.full(len(names), max(board.standard_uncertainty_mm, LEAST_MM))
    sd[BEND] = max(board.flatness_mm, LEAST_MM)
    return Papers(names, values, sd)


def surface(board: Chessboard, coordinates: Floats, xy_mm: Floats) -> Surface:
    """The bent sheet at places (N, 2) of the board's frame."""
    half = board.size_mm / 2
    x, y = ((xy_mm - board.extent_mm / 2) / half).T
    by_bend = np.column_stack([x**i * y**j for i, j in BENDS])
    along_x = np.column_stack([i * x ** max(i - 1, 0) * y**j for i, j in BENDS]) / half
    along_y = np.column_stack([j * x**i * y ** max(j - 1, 0) for i, j in BENDS]) / half
    bend = coordinates[BEND]
    return Surface(by_bend @ bend, np.column_stack([along_x @ bend, along_y @ bend]), by_bend)


def corners_at(board: Chessboard, coordinates: Floats) -> Floats:
    """(N, 3) where every corner truly is, in the board's frame."""
    share = grid(board) / (np.array(board.inner_corners) - 1)
    count = len(share)
    print_mm = coordinates[BEND.stop :].reshape(2, count).T
    xy = share * coordinates[EXTENT] + print_mm
    return np.column_stack([xy, surface(board, coordinates, xy).height_mm])
