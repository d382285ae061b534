"""Whether a coloured line stands out of its picture: things have the colour of a laser, too.

A laser's light is the strongest of its colour in nearly every column that it crosses. A leaf, a
cable or a seam is one of many things of its colour, each about as strong.
"""

from collections.abc import Sequence

import numpy as np

from crenel.metrology.coloured_line.excess import Levels, Planes, excess_without, rises
from crenel.metrology.coloured_line.pieces import LinePiece
from crenel.metrology.robust import median

SMOOTH_WIDTHS, LEAST_SMOOTH_PX = 0.4, 1.0
"""Smoothing across the line, in shares of its width, and the least."""
BESIDE_WIDTHS, BESIDE_PX = 2.0, 4
"""What is nearer to the line than so many widths, and pixels, belongs to it."""
RIVAL = 0.5
"""What rises in the line's colour by this share of what the line usually does is its rival."""

MOST_RIVALLED, ACROSS, MOST_ACROSS = 0.2, 0.85, 0.4
"""The share of the picture's columns with a rival, at most; and that beside a line that crosses so
much of the picture, as hardly a thing does."""


def stands_out(
    planes: Planes, pieces: Sequence[LinePiece], width_px: float, allowed: Levels | None = None
) -> bool:
    """Whether hardly anything else of a picture has as much of a line's colour.

    Args:
        planes: of the picture, for the line's colour.
        pieces: the line.
        width_px: its width at half height.
        allowed: (H, W) 1 where the line may lie, otherwise 0; None: anywhere.
    """
    columns = np.concatenate([piece.columns for piece in pieces])
    rows = np.concatenate([piece.rows for piece in pieces])
    off = round(BESIDE_WIDTHS * width_px) + BESIDE_PX
    line = np.zeros(planes.own.shape, np.bool_)
    line[np.clip(rows + np.arange(-off, off + 1)[:, None], 0, len(line) - 1), columns] = True
    smooth = max(LEAST_SMOOTH_PX, SMOOTH_WIDTHS * width_px)
    rise = rises(excess_without(planes, line), smooth)
    of_line = median(rise[rows, columns])
    is_other = (rises(planes.own, smooth) > 0) & ~line
    if allowed is not None:
        is_other &= allowed > 0
    rivalled = float(((rise > RIVAL * of_line) & is_other).any(axis=0).mean())
    return rivalled <= (MOST_ACROSS if len(columns) >= ACROSS * rise.shape[1] else MOST_RIVALLED)
