"""Which of several peaks of a column is the stripe, and which of all peaks make a line."""

import numpy as np
from numpy.typing import NDArray

from app.metrology.compiled import kernel
from app.metrology.frames import Floats

# The rules by which one of several peaks of a column is chosen.
CONTINUITY, STRENGTH, FIRST, LAST = range(4)
# Columns that a track may skip, and rows by which it may climb from one column to the next;
# the rows of peaks are known to COARSE.
SKIP, STEEPEST, COARSE = 3, 4, 3
# A track counts by how high it is on average; in full if it has so many peaks, else by the
# square of its share of them. Lower than this share of a column's highest peak, none is
# in question.
LONG, RIVAL = 40, 0.2
# A piece that is as long as a round spot of its width shows is none of a line, in standard
# deviations of its width.
ROUND = 6.0

Places = NDArray[np.int32]


@kernel
def by_columns(columns: Places, width: int, begin: Places, order: Places) -> None:
    """Sorts peaks (n,) by columns.

    Args:
        begin: (width + 1,) filled with where each column's peaks begin in ``order``.
        order: (n,) filled with the peaks, in each column as they came.
    """
    begin[:] = 0
    for column in columns:
        begin[column + 1] += 1
    for i in range(width):
        begin[i + 1] += begin[i]
    for p in range(len(columns)):
        column = columns[p]
        order[begin[column]] = p
        begin[column] += 1
    for i in range(width, 0, -1):
        begin[i] = begin[i - 1]
    begin[0] = 0


@kernel
def highest_each(columns: Places, heights: Places, best: Places, share: float) -> bool:
    """The highest peak of each column, the first of equals; True where it has a rival.

    Args:
        best: (width,) filled with the peaks' numbers, -1 for none.
        share: of the highest, from which a column's second highest peak is its rival.
    """
    best[:] = -1
    second = np.full(len(best), -1, np.int32)
    for p in range(len(columns)):
        column = columns[p]
        before = best[column]
        if before < 0:
            best[column] = p
        elif heights[p] > heights[before]:
            best[column], second[column] = p, heights[before]
        else:
            second[column] = max(second[column], heights[p])
    rival = False
    for i in range(len(best)):
        rival |= second[i] >= 0 and second[i] >= share * heights[best[i]]
    return rival


@kernel
def link(
    rows: Places, begin: Places, order: Places, track: Places, reached: NDArray[np.int64]
) -> int:
    """Numbers the peaks so that those that follow one another share a track; their number.

    Each peak goes on with the nearest one before it that no nearer peak has gone on with.
    """
    tracks = 0
    width = len(begin) - 1
    reached[:] = -1
    for i in range(width):
        for place in range(begin[i], begin[i + 1]):
            p = order[place]
            nearest, best = 1 << 30, -1
            for back in range(1, min(SKIP, i) + 1):
                for earlier in range(begin[i - back], begin[i - back + 1]):
                    q = order[earlier]
                    climb = abs(rows[p] - rows[q])
                    free = reached[track[q]] != i
                    if climb <= STEEPEST * back + COARSE and climb < nearest and free:
                        nearest, best = climb, q
                if best >= 0:
                    break
            if best >= 0:
                track[p] = track[best]
            else:
                track[p] = tracks
                tracks += 1
            reached[track[p]] = i
    return tracks


@kernel
def choose(
    columns: Places,
    rows: Places,
    heights: Places,
    width: int,
    rule: int,
    shortest: int,
    chosen_columns: Places,
    chosen_rows: Places,
) -> int:
    """One peak a column, by a rule; returns how many.

    Args:
        columns, rows, heights: (n,) the peaks, from the top of the image down.
        rule: CONTINUITY takes the peak whose track is the highest on average (short ones
            count for less), STRENGTH the highest peak, FIRST and LAST
            the uppermost and the lowest that lies on a track of at least ``shortest``.
        chosen_columns, chosen_rows: (width,) filled, in ascending order of columns.
    """
    best = np.empty(width, np.int32)
    share = RIVAL if rule == CONTINUITY else 0.0
    if highest_each(columns, heights, best, share) and rule != STRENGTH:
        best_of_tracks(columns, rows, heights, rule, shortest, best)
    found = 0
    for i in range(width):
        if best[i] >= 0:
            chosen_columns[found], chosen_rows[found] = i, rows[best[i]]
            found += 1
    return found


@kernel
def best_of_tracks(
    columns: Places, rows: Places, heights: Places, rule: int, shortest: int, best: Places
) -> None:
    """Fills the best peak of each column by what tracks they lie on; see ``choose``."""
    n, width = len(columns), len(best)
    begin, order = np.empty(width + 1, np.int32), np.empty(n, np.int32)
    by_columns(columns, width, begin, order)
    track = np.empty(n, np.int32)
    tracks = link(rows, begin, order, track, np.empty(n, np.int64))
    total, count = np.zeros(tracks), np.zeros(tracks, np.int64)
    for p in range(n):
        total[track[p]] += heights[p]
        count[track[p]] += 1
    worth = np.empty(n, np.float64)
    for p in range(n):
        length = count[track[p]]
        worth[p] = total[track[p]] / length * min(length / LONG, 1.0) ** 2
        if rule != CONTINUITY:
            # a short track is taken where there is no other
            downwards = rows[p] if rule == LAST else -rows[p]
            worth[p] = downwards + (1e6 if length >= shortest else -1e6)
    for i in range(width):
        for place in range(begin[i], begin[i + 1]):
            p = order[place]
            if place == begin[i] or worth[p] > worth[best[i]]:
                best[i] = p


@kernel
def in_long_runs(
    along: Floats,
    across: Floats,
    sigma: Floats,
    largest_gap: float,
    steepest: float,
    shortest: int,
    kept: NDArray[np.bool_],
) -> None:
    """Marks the points (N,) that lie in a run of enough neighbours, and are no round spot.

    Args:
        sigma: (N,) the standard deviations of the peaks' widths.
    """
    n, begin = len(along), 0
    for i in range(1, n + 1):
        if i < n:
            gap = along[i] - along[i - 1]
            if gap <= largest_gap and abs(across[i] - across[i - 1]) <= steepest * gap:
                continue
        width = 0.0
        for j in range(begin, i):
            width += sigma[j]
        length = i - begin
        enough = length >= shortest and length >= ROUND * width / length
        for j in range(begin, i):
            kept[j] = enough
        begin = i
