"""Bright bands that are no laser line: windows, lamps, the edges of paper, polished metal.

A beam of light fades towards its sides, and a lens and the surface spread it further: where it is
clipped, its flanks still take a good share of its width. The edges of a thing that shines, or is
lit, are as sharp as the lens draws them, however wide it is.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.image import Image
from crenel.metrology.stripe.found_line import FoundLine
from crenel.metrology.transforms import Floats

WIDE_PX = 14.0
"""The width from which on a line is wide: of a narrower one, pixels hardly resolve the edges."""
BAND_FALL = 0.15
"""A piece is like a band if its brightness falls from 80 to 20 % over less than this share of its
width at half height, on average of both sides: a Gaussian beam that is clipped at a fifth of its
height does so over 0.15, real saturated lines over 0.19 and more."""
NO_BEAM_FALL, NO_BEAM_PX = 0.045, 32.0
"""No beam so wide falls so fast: that is a Gaussian clipped at a thousandth of its height."""
LIKE_BAND, BESIDE_BAND = 0.5, 0.5
"""A line beside a band has at least this share of its height, or is at most this share as wide:
it is no reflection of it."""
SOFTER = 1.2
"""Its fall is so many times that of the band, at least."""
LONG_BESIDE, IN_BAND_COLUMNS = 0.3, 0.5
"""Its length, in shares of the image's width; the share of the bands' columns that it crosses."""
LEAST_COLUMNS, SAMPLED_COLUMNS = 20, 48
"""The fewest columns of a piece whose edges are measured, and the columns that its profile is the
mean of."""
LARGEST_GAP, STEEPEST_PX = 3, 4.0
BESIDE_PX = 12
"""Rows beyond a width on both sides that show a piece's surroundings."""
AS_BRIGHT = 0.7
"""A band goes on where it has this share of its piece's brightness over the surroundings."""


@dataclass(frozen=True, slots=True)
class Piece:
    """Points of a line that go on from column to column, and their mean profile.

    ``columns``, ``rows``: (N,). ``width_px``: at half height. ``fall_px``: rows over which the
    profile falls from 80 to 20 %, mean of both sides. ``height``: grey levels over the
    surroundings.
    """

    columns: NDArray[np.int64]
    rows: Floats
    width_px: float
    fall_px: float
    height: float

    @property
    def fall(self) -> float:
        """The fall in shares of the width."""
        return self.fall_px / self.width_px if self.width_px else 1.0

    @property
    def is_band(self) -> bool:
        """Whether its edges are those of a band, so that a beam beside it is the line."""
        return self.width_px >= WIDE_PX and self.fall < BAND_FALL

    @property
    def is_no_beam(self) -> bool:
        """Whether its edges are none of a beam."""
        return self.width_px >= NO_BEAM_PX and self.fall < NO_BEAM_FALL


def is_wide(found: FoundLine) -> bool:
    """Whether the line is wide enough to tell a band by its edges."""
    return found.broadest_px >= WIDE_PX


def measure_pieces(grey: Image, found: FoundLine) -> list[Piece]:
    """The pieces of a line with their profiles, those of fewer than ``LEAST_COLUMNS`` left out.

    Args:
        grey: (H, W) with the stripe across its columns.
    """
    along, across = found.stripe.along_across
    if not len(along):
        return []
    gaps = np.diff(along)
    climb = STEEPEST_PX * max(found.factor, 1.0)
    breaks = (gaps > LARGEST_GAP) | (np.abs(np.diff(across)) > climb * gaps)
    usual_px = found.broadest_px
    pieces = []
    for part in np.split(np.arange(len(along)), np.flatnonzero(breaks) + 1):
        if len(part) >= LEAST_COLUMNS:
            pieces.append(
                _measure_piece(grey, along[part].astype(np.int64), across[part], usual_px)
            )
    return pieces


def _measure_piece(grey: Image, columns: NDArray[np.int64], rows: Floats, usual_px: float) -> Piece:
    some = np.linspace(0, len(columns) - 1, SAMPLED_COLUMNS).astype(np.int64)
    reach = round(usual_px) + BESIDE_PX
    offsets = np.arange(-reach, reach + 1)[:, None]
    at = np.clip(np.rint(rows[some]).astype(np.int64) + offsets, 0, grey.shape[0] - 1)
    profile = grey[at, columns[some]].mean(axis=1)
    middle = float(np.median(profile[reach - reach // 8 : reach + reach // 8 + 1]))
    down = _falls(profile[reach:], middle)
    up = _falls(profile[reach::-1], middle)
    width_px = up[1] + down[1]
    fall_px = (up[2] - up[0] + down[2] - down[0]) / 2
    around = max(float(np.median(side[-(reach // 3) :])) for side in (profile, profile[::-1]))
    return Piece(columns, rows, width_px, fall_px, middle - around)


def _falls(side: Floats, middle: float) -> tuple[float, float, float]:
    """How far from the first value a profile falls to 80, 50 and 20 % of its height."""
    around = float(np.median(side[-(len(side) // 3) :]))
    return (
        _reach_px(side, around + 0.8 * (middle - around)),
        _reach_px(side, around + 0.5 * (middle - around)),
        _reach_px(side, around + 0.2 * (middle - around)),
    )


def _reach_px(side: Floats, level: float) -> float:
    """How far from the first value a profile falls below a level, between pixels."""
    below = np.flatnonzero(side < level)
    if not len(below) or below[0] == 0:
        return float(len(side) if not len(below) else 0)
    at = int(below[0])
    return at - 1 + float((side[at - 1] - level) / (side[at - 1] - side[at]))


def is_beam_beside(grey: Image, other: FoundLine, bands: Sequence[Piece]) -> bool:
    """Whether a line is long, more like a beam than the bands are, and no reflection of them."""
    if not other.evidence or other.length < LONG_BESIDE:
        return False
    columns = np.concatenate([piece.columns for piece in bands])
    if np.isin(columns, other.stripe.along_across[0]).mean() < IN_BAND_COLUMNS:
        return False  # what is left of the same line, not another one
    band = _most_of(bands)
    height = float(np.median(other.stripe.intensity))
    if height < LIKE_BAND * band.height and other.broadest_px >= BESIDE_BAND * band.width_px:
        return False
    pieces = measure_pieces(grey, other) if is_wide(other) else []
    beam = _most_of(pieces) if pieces else None
    return beam is None or (not beam.is_band and beam.fall > SOFTER * band.fall)


def _most_of(pieces: Sequence[Piece]) -> Piece:
    return max(pieces, key=lambda piece: len(piece.columns))


def paint_over(grey: Image, pieces: Sequence[Piece]) -> Image:
    """A copy of the image in which bands are filled from their surroundings, column by column.

    A band goes on straight beyond its piece, as long as it is about as bright there.
    """
    painted = grey.copy()
    for piece in pieces:
        _paint_piece(grey, piece, painted)
    return painted


def _paint_piece(grey: Image, piece: Piece, painted: Image) -> None:
    columns = np.arange(grey.shape[1])
    slope, offset = np.polyfit(piece.columns, piece.rows, 1)
    inside = (columns >= piece.columns[0]) & (columns <= piece.columns[-1])
    rows = np.interp(columns, piece.columns, piece.rows)
    rows = np.where(inside, rows, slope * columns + offset)
    reach = piece.width_px / 2 + 2 * piece.fall_px + 2
    top = np.rint(rows - reach).astype(np.int64)
    behind = np.rint(rows + reach).astype(np.int64)
    last = grey.shape[0] - 1
    centre = np.clip(np.rint(rows).astype(np.int64), 0, last)
    first, end = np.clip(top, 0, last), np.clip(behind, 0, last)
    level = np.maximum(grey[first, columns], grey[end, columns]).astype(np.float64)
    bright = grey[centre, columns] - level >= AS_BRIGHT * piece.height
    for column in columns[(inside | bright) & (behind > 0) & (top < last)]:
        a, b = first[column], end[column]
        painted[a : b + 1, column] = np.linspace(grey[a, column], grey[b, column], b - a + 1)
