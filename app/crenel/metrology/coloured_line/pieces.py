"""Pieces of a path that are a laser line, by their colour, their shape and their surroundings."""

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.metrology.coloured_line.excess import CLIPPED, CORE, SIDES, Levels, Planes, Ridges
from crenel.metrology.coloured_line.path import STEEPEST_PX
from crenel.metrology.robust import median

SCORE, SCORE_COLUMNS, LEAST_COLUMNS = 0.5, 9, 8
"""The least score of a piece, as a mean of so many columns, and the fewest columns."""
ANCHOR_COLUMNS, ANCHOR_SCORE = 30, 100.0
"""A piece so long and strong is a line without the support of others."""
RISE, HUE = 6.0, 0.12
"""The least excess of a piece in grey levels, and in shares of what its channel rises."""
OTHERS_DARKER, UNEVEN = 0.12, 0.35
"""The most by which its other channels fall, in shares of what its own rises; and by which its
sides differ, in shares of the excess."""
ROUGH_PX, LAG, STRAIGHT = 1.6, 5, 0.85
"""The most by which it bends, as the mean second difference over so many columns, in this share of
them."""
EVEN_COLUMNS, LEAST_RISE = 15, 1e-6
"""Columns over which noise is left out of that, and what keeps the share finite."""
MOST_LEAK, AROUND = 0.6, 3
"""Beside a clipped core, the others rise by so much of what its own channel does at most, above
what is so many times further away than its sides: a white thing on a coloured one shows all."""
COLOURED, UNEVEN_LIGHT, ROUGH_LIGHT_PX = 0.7, 0.6, 3.0
"""A piece beside an anchor has this score by colour alone, as a mean, and at most such sides and
bends."""
NEAR_COLUMNS, NEAR_PX, DRIFT = 16, 3.0, 0.3
"""How far from the end of a line a piece without colour goes on with it, along and across, and by
how much more across for each column between."""


@dataclass(frozen=True)
class LinePiece:
    """Columns (N,) and rows (N,) of a path that go on.

    ``score``: the sum over its columns. ``is_light``: whether its colour and shape are those of a
    laser's light. ``is_anchor``: whether it is a line by itself; ``is_other``: whether it
    would be, but for its colour.
    """

    columns: NDArray[np.int64]
    rows: NDArray[np.int64]
    score: float
    is_light: bool
    is_other: bool
    is_anchor: bool


def split_path(path: NDArray[np.int64], ridges: Ridges, planes: Planes) -> list[LinePiece]:
    """The pieces of a path (W,) that stand out."""
    columns = np.arange(len(path))
    score = ridges.score[path, columns]
    shows = cv2.blur(score[None], (SCORE_COLUMNS, 1))[0] >= SCORE
    breaks = (np.abs(np.diff(path)) > STEEPEST_PX) | (shows[1:] != shows[:-1])
    return [
        _judge(part, path[part], ridges, planes)
        for part in np.split(columns, np.flatnonzero(breaks) + 1)
        if shows[part[0]] and len(part) >= LEAST_COLUMNS
    ]


def anchor_score(pieces: list[LinePiece]) -> float:
    """How much of a line pieces show."""
    return sum(piece.score for piece in pieces if piece.is_anchor)


def select_line(pieces: list[LinePiece]) -> list[LinePiece]:
    """The pieces that are the line: those of its light, and what goes on between and beside them.

    Empty without an anchor.
    """
    if not any(piece.is_anchor for piece in pieces):
        return []
    taken = [piece.is_light or piece.is_anchor for piece in pieces]
    for order in (range(1, len(pieces)), range(len(pieces) - 2, -1, -1)):
        for at in order:
            before = at - order.step
            if not taken[at] and taken[before]:
                taken[at] = _goes_on(pieces[min(at, before)], pieces[max(at, before)])
    return [piece for piece, is_line in zip(pieces, taken, strict=True) if is_line]


def _goes_on(left: LinePiece, right: LinePiece) -> bool:
    along = int(right.columns[0] - left.columns[-1])
    across = abs(int(right.rows[0] - left.rows[-1]))
    return along <= NEAR_COLUMNS and across <= NEAR_PX + DRIFT * along


def _judge(
    columns: NDArray[np.int64], rows: NDArray[np.int64], ridges: Ridges, planes: Planes
) -> LinePiece:
    bend = np.sort(np.abs(rows[2 * LAG :] - 2 * rows[LAG:-LAG] + rows[: -2 * LAG]))
    bend = bend[: round(STRAIGHT * len(bend))]  # without the corners of objects
    rough = float(bend.mean()) if len(bend) else 0.0
    off = max(2, round(SIDES * median(ridges.smooth_px[rows, columns])))
    place = _Place(columns, rows, off)
    centre, above, below = place.levels(planes.excess)
    rise = median(centre - np.maximum(above, below))
    own, others = place.rise(planes.own), place.rise(planes.others)
    around = _Place(columns, rows, AROUND * off)
    flanks = [_flank_rows(planes.own, columns, rows, step) for step in (-1, 1)]
    own_beside, others_beside = (
        sum(around.rise(plane, beside) for beside in flanks)
        for plane in (planes.own, planes.others)
    )
    adds = others >= -OTHERS_DARKER * own
    is_pure = others_beside <= MOST_LEAK * own_beside and own_beside >= RISE
    uneven = _evenness(above - below) / max(rise, LEAST_RISE)
    score = float(ridges.score[rows, columns].sum())
    is_sure = is_pure and rise >= max(RISE, HUE * own) and uneven <= UNEVEN and rough <= ROUGH_PX
    coloured = float(ridges.coloured[rows, columns].mean())
    is_light = coloured >= COLOURED and uneven <= UNEVEN_LIGHT and rough <= ROUGH_LIGHT_PX
    is_strong = score >= ANCHOR_SCORE and len(columns) >= ANCHOR_COLUMNS
    return LinePiece(
        columns, rows, score, adds and is_light, is_strong, adds and is_sure and is_strong
    )


class _Place:
    """The pixels (N,) of a piece, and those so many rows above and below."""

    def __init__(self, columns: NDArray[np.int64], rows: NDArray[np.int64], off: int) -> None:
        self._columns = columns
        self._rows = rows
        self._off = off

    def levels(self, plane: Levels) -> tuple[Levels, Levels, Levels]:
        """(N,) at the middle, above and below."""
        up = np.maximum(self._rows - self._off, 0)
        down = np.minimum(self._rows + self._off, plane.shape[0] - 1)
        middle, above, below = (plane[rows, self._columns] for rows in (self._rows, up, down))
        return middle, above, below

    def rise(self, plane: Levels, middle_rows: NDArray[np.int64] | None = None) -> float:
        """By how much the middle, or what is in other rows (N,), usually exceeds the mean of both
        sides."""
        middle, above, below = self.levels(plane)
        if middle_rows is not None:
            middle = plane[middle_rows, self._columns]
        return median(middle - (above + below) / 2)


def _flank_rows(
    own: Levels, columns: NDArray[np.int64], rows: NDArray[np.int64], step: int
) -> NDArray[np.int64]:
    """The rows (N,) nearest to a piece, on one side of its core, that are not clipped."""
    last = own.shape[0] - 1
    reach = round(CORE * own.shape[0])
    at = np.clip(rows + step * np.arange(reach + 1)[:, None], 0, last)
    is_free = own[at, columns] < CLIPPED
    first = np.where(is_free.any(axis=0), is_free.argmax(axis=0), reach)
    beyond = np.where(first > 0, first + 1, 0)  # the pixel at the edge of the core is in between
    return np.asarray(np.clip(rows + step * beyond, 0, last), np.int64)


def _evenness(difference: NDArray[np.float32]) -> float:
    """The usual magnitude of a difference along a line, without its noise."""
    smooth = cv2.blur(difference[None], (EVEN_COLUMNS, 1))[0]
    return median(np.abs(smooth))
