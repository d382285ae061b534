"""How markers are arranged on a board, and of which board's numbers what a picture shows is.

Markers that lie beside each other tell by how many squares, without a lens or a whole board;
their ids tell by how many they should.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.metrology.chessboard.charuco_board.marker_reading import MarkerReading
from crenel.metrology.chessboard.perspective import map_places
from crenel.metrology.targets.chessboard import Chessboard, Markers
from crenel.metrology.transforms import Floats

# Markers no further than so many squares from each other are beside each other, and lie this
# near to a whole number of squares.
BESIDE_SQUARES, WHOLE_SQUARES = 2.4, 0.35
# Share of the steps between markers that an arrangement explains, of which one leads to another
# row, and how many markers say it.
LEAST_EXPLAINED, FEWEST_MARKERS = 0.75, 3
# A marker lies where one perspective of all has it if no corner is further off than this.
NEAR_SQUARES = 0.35
# Share of the markers that lie so on a board of this arrangement; a lens bends its lines.
LEAST_ON_BOARD = 0.6
# Columns and rows of squares that are tried.
COUNTS = range(4, 61)


@dataclass(frozen=True)
class Arrangement:
    """The markers of a board: ids from ``first_id`` on, row by row from the upper left.

    ``first_is_white``: the upper left square is white, as of a legacy pattern of an even number of
    rows.
    """

    squares_x: int
    first_is_white: bool
    first_id: int

    def places(self, ids: NDArray[np.int64]) -> NDArray[np.int64]:
        """(M, 2) column and row of the square of each marker (M,), from the upper left."""
        in_even = (self.squares_x + self.first_is_white) // 2
        pair, rest = np.divmod(ids - self.first_id, self.squares_x)
        is_odd = (rest >= in_even).astype(np.int64)
        first = is_odd if self.first_is_white else 1 - is_odd
        return np.column_stack([2 * (rest - in_even * is_odd) + first, 2 * pair + is_odd])

    def has_steps(self, seen: "MarkerSteps") -> NDArray[np.bool_]:
        """Which steps (P,) from marker to marker it has."""
        places = self.places(seen.ids)
        one, other = seen.pairs.T
        return np.asarray((places[other] - places[one] == seen.squares).all(axis=1))

    def fits(self, seen: "MarkerSteps") -> bool:
        """Whether the markers lie so."""
        right = self.has_steps(seen)
        if not len(right) or right.mean() < LEAST_EXPLAINED:
            return False
        several = len(np.unique(seen.pairs[right])) >= FEWEST_MARKERS
        return bool(several and seen.squares[right, 1].any())


@dataclass(frozen=True)
class MarkerSteps:
    """M markers by id, and P steps between those beside each other.

    ``squares`` is by how many squares to the right and down a step leads, in the direction in
    which the markers are printed.
    """

    ids: NDArray[np.int64]  # (M,)
    pairs: NDArray[np.int64]  # (P, 2) indices of markers
    squares: NDArray[np.int64]  # (P, 2)


def measure_steps(reading: MarkerReading, marker_share: float) -> MarkerSteps:
    """The steps between markers, each by the outline of the one from which it leads.

    Args:
        marker_share: the side of a marker in squares.
    """
    half = marker_share / 2
    printed = np.array([[-half, -half], [half, -half], [half, half], [-half, half]])
    centres = reading.outlines_px.mean(axis=1)
    pairs: list[tuple[int, int]] = []
    squares: list[Floats] = []
    for k, outline in enumerate(reading.outlines_px):
        H = cv2.getPerspectiveTransform(outline.astype(np.float32), printed.astype(np.float32))
        at = np.column_stack([centres, np.ones(len(centres))]) @ np.asarray(H).T
        away = at[:, :2] / np.where(at[:, 2:] > 0, at[:, 2:], np.nan)
        near = np.abs(away).max(axis=1) < BESIDE_SQUARES
        near &= np.abs(away - np.round(away)).max(axis=1) < WHOLE_SQUARES
        near[k] = False
        for other in np.flatnonzero(near).tolist():
            pairs.append((k, other))
            squares.append(np.round(away[other]))
    return MarkerSteps(
        reading.markers,
        np.array(pairs, np.int64).reshape(-1, 2),
        np.array(squares).reshape(-1, 2).astype(np.int64),
    )


def arrangement_of(board: Chessboard, markers: Markers) -> Arrangement:
    """The arrangement by the certificate."""
    columns, rows = (count + 1 for count in board.inner_corners)
    return Arrangement(columns, markers.legacy and rows % 2 == 0, markers.first_id)


def find_arrangement(
    reading: MarkerReading, board: Chessboard, markers: Markers
) -> Arrangement | None:
    """How the markers in a picture are arranged: by the certificate, or by the least that differs.

    None where fewer than three say it, or no arrangement explains most of them.
    """
    if len(reading.markers) < FEWEST_MARKERS:
        return None
    share = markers.side_mm / board.square_mm
    stated = arrangement_of(board, markers)
    best, most = stated, _share_on_board(reading, stated, share)
    seen = measure_steps(reading, share)
    for one in _others(seen.ids, stated, board):
        if most == 1.0:
            break
        explained = _share_on_board(reading, one, share) if one.fits(seen) else 0.0
        if explained > most:
            best, most = one, explained
    return best if most >= LEAST_ON_BOARD or best.fits(seen) else None


def _share_on_board(reading: MarkerReading, arrangement: Arrangement, marker_share: float) -> float:
    """The share of the markers that one perspective explains; 0 if it is fewer than three."""
    on_board, H = fit_arrangement(reading, arrangement, marker_share)
    return 0.0 if H is None else float(on_board.mean())


def fit_arrangement(
    reading: MarkerReading, arrangement: Arrangement, marker_share: float
) -> tuple[NDArray[np.bool_], Floats | None]:
    """Which markers (M,) one perspective explains, and the homography from squares to pixels.

    Squares are counted from the upper left, as printed; None where fewer than three agree.
    """
    none = np.zeros(len(reading.markers), np.bool_)
    if len(none) < FEWEST_MARKERS:
        return none, None
    half = marker_share / 2
    around = np.array([[-half, -half], [half, -half], [half, half], [-half, half]])
    places = arrangement.places(reading.markers)[:, None] + 0.5 + around
    outlines_px = reading.outlines_px
    side_px = float(np.median(np.linalg.norm(np.diff(outlines_px, axis=1), axis=2)))
    near_px = NEAR_SQUARES * side_px / marker_share
    places, corners_px = places.reshape(-1, 2), outlines_px.reshape(-1, 2)
    H, _ = cv2.findHomography(places, corners_px, cv2.RANSAC, near_px)
    if H is None:
        return none, None
    off_px = np.linalg.norm(map_places(np.asarray(H), places) - corners_px, axis=1)
    near = (off_px.reshape(-1, 4) < near_px).all(axis=1)
    return near, np.asarray(H) if near.sum() >= FEWEST_MARKERS else None


def _others(
    ids: NDArray[np.int64], stated: Arrangement, board: Chessboard
) -> Iterator[Arrangement]:
    """Other arrangements, those that differ least first."""
    columns, rows = (count + 1 for count in board.inner_corners)
    low, high = int(ids.min()), int(ids.max())
    count = columns * rows // 2
    ours = range(max(0, high - count + 1), low + 1)
    # boards of a set follow each other
    firsts = sorted(ours, key=lambda first: (first % count > 0, -first))
    for first in firsts:
        yield replace(stated, first_id=first)
    if rows % 2 == 0:
        yield replace(stated, first_is_white=not stated.first_is_white)
    sizes = sorted(COUNTS, key=lambda size: (size != rows, abs(size - columns)))
    ways = [Arrangement(size, white, stated.first_id) for size in sizes for white in (False, True)]
    yield from ways
    for way in ways:
        for first in range(low, max(-1, low - way.squares_x), -1):
            yield replace(way, first_id=first)
