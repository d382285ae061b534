"""Where methods agree on a line: columns in which their points are close, in long runs."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.transforms import Floats

APART_PX, APART_SHARE = 3.0, 0.2
LEAST_RUN, LEAST_WIDTHS = 20, 3.0
CONFIRMED = 0.5
"""Share of a run that must be near another method's points, to be the line's."""
WIDEST_GAP = 3
STEEPEST_PX = 4.0
"""Rows by which a line may rise from one column to the next."""


def split_runs(rows: Floats) -> list[NDArray[np.int64]]:
    """The columns of each run in which a line goes on.

    Args:
        rows: (W,) of the line, NaN where there is none. Gaps of up to three columns belong to
            a run, but their columns do not count.
    """
    columns = np.flatnonzero(np.isfinite(rows))
    gaps = np.diff(columns)
    breaks = (gaps > WIDEST_GAP + 1) | (np.abs(np.diff(rows[columns])) > STEEPEST_PX * gaps)
    return np.split(columns, np.flatnonzero(breaks) + 1)


def find_runs(rows: Floats, least: int) -> NDArray[np.bool_]:
    """The columns (W,) that belong to a run of at least ``least`` columns."""
    kept = np.zeros(len(rows), np.bool_)
    for run in split_runs(rows):
        kept[run] = len(run) >= least
    return kept


def agree(rows: Sequence[Floats], apart_px: float) -> NDArray[np.bool_]:
    """The columns (W,) in which all methods have a point, and none is far from another."""
    return np.asarray(np.ptp(np.stack(rows), axis=0) <= apart_px)  # NaN where one has none


def apart_px(width_px: float) -> float:
    """How far apart two methods' points of the same line may be."""
    return max(APART_PX, APART_SHARE * width_px)


def find_agreed(rows: Sequence[Floats], width_px: float) -> NDArray[np.bool_]:
    """The columns (W,) in which all methods agree on a line."""
    middle = np.median(np.stack(rows), axis=0)
    together = np.where(agree(rows, apart_px(width_px)), middle, np.nan)
    return find_runs(together, round(max(LEAST_RUN, LEAST_WIDTHS * width_px)))


def find_false(rows: dict[str, Floats], method: str, width_px: float) -> NDArray[np.bool_]:
    """The columns (W,) in which a method's point is far from those of all others.

    Where the others disagree or take something short, a point on a run that is mostly
    confirmed lies on the line, and is not false.
    """
    others = [rows[other] for other in rows if other != method]
    off = np.abs(np.stack(others) - rows[method])
    beside = np.asarray(np.isfinite(off).any(axis=0))
    near = np.asarray((off <= apart_px(width_px)).any(axis=0))
    excused = np.zeros(len(near), np.bool_)
    for run in split_runs(rows[method]):
        excused[run] = near[run].sum() >= CONFIRMED * beside[run].sum()
    return np.asarray(beside & ~near & ~(excused & ~find_agreed(others, width_px)))
