"""Scales at which a stripe is looked for: several rows made one, so that a wide line is narrow, or
one made two for a line of hardly a pixel."""

import math
from dataclasses import dataclass
from typing import cast

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.image import Image, full_scale_shown, saturation_level
from crenel.metrology.stripe.settings import StripeSettings
from crenel.native.arguments import I64, U8, U16, Array, Function, Integer
from crenel.native.library import CRENEL

WIDE_FACTORS = (3.0, 9.0)
"""Rows that are made one for wide lines: at each, lines of about 2 to 25 rows are found."""
THIN_FACTOR = 0.5
"""Rows that are made one for lines thinner than two pixels."""
LEAST_ROWS = 64
"""No factor leaves fewer rows."""
STEEPEST_PX = 4.0
"""Pixels by which a line may climb from one column to the next."""
FULL_SCALE_16 = 65535
FIT_SIGMAS, FIT_MORE, WIDEST_FIT_ROWS = 3.6, 4, 40
"""Rows about a peak that its fit reads: of its width, more, and at most, as in ``pipeline.c``."""
SEARCHED_BEYOND = 22
"""Rows by which a part reaches beyond the line at its place in the image before: the surroundings
that the search needs, as in ``tracking.c``, and those by which the line may move."""
FLANK_ROWS = 88
"""Rows that a clipped line's flanks and background reach beyond a part: core, flank, background."""

_reduce = {
    kind: Function(
        CRENEL,
        f"reduce_rows_{bits}",
        Array(kind, "height", "width"),
        Array(I64, "part_count", 4),
        Integer(),
        Integer(),
        Integer(),
        Array(U16, "reduced", "width", written=True),
    )
    for kind, bits in ((U8, 8), (U16, 16))
}

_double = {
    kind: Function(
        CRENEL,
        f"double_rows_{bits}",
        Array(kind, "height", "width"),
        Integer(),
        Integer(),
        Array(U16, "doubled", "width", written=True),
    )
    for kind, bits in ((U8, 8), (U16, 16))
}


_highest_in_parts = Function(
    CRENEL,
    "highest_in_parts",
    Array(U16, "height", "width"),
    Array(I64, "part_count", 4),
    returns=int,
)


@dataclass(frozen=True)
class Scale:
    """How pixels of the reduced image follow from those of an image.

    ``factor``: rows made one. ``gain``: levels of the reduced image per level of the image.
    ``saturated``: the level of the image at which pixels are clipped.
    """

    factor: float = 1.0
    gain: int = 1
    saturated: int = FULL_SCALE_16

    def across_px(self, reduced_rows: NDArray[np.float64]) -> NDArray[np.float64]:
        """Rows (N,) of the image, from rows of the reduced one."""
        return reduced_rows * self.factor + (self.factor - 1) / 2

    @property
    def climb_rows(self) -> float:
        """Rows of the reduced image by which a line may climb from one column to the next."""
        return STEEPEST_PX / min(self.factor, 1.0)

    def settings(self, settings: StripeSettings) -> StripeSettings:
        """The same settings for the reduced image."""
        return StripeSettings(
            threshold=_multiply(settings.threshold, self.gain),
            min_width_px=_multiply(settings.min_width_px, 1 / self.factor),
            max_width_px=_multiply(settings.max_width_px, 1 / self.factor),
            min_run=settings.min_run,
            choice=settings.choice,
        )


FULL = Scale()


def wide_factors(rows: int) -> tuple[float, ...]:
    """The factors that leave an image of so many rows enough of them."""
    return tuple(factor for factor in WIDE_FACTORS if rows / factor >= LEAST_ROWS)


def scale_of(grey: Image, factor: float) -> Scale:
    """The scale that makes ``factor`` rows of such an image one."""
    return _scale_for(grey, factor, int(saturation_level(grey)))


def follow_scale(before: Scale, grey: Image, parts: NDArray[np.int64]) -> Scale:
    """The scale for the next image of the same sensor, of which only parts are read.

    The full scale that earlier images showed is that of the sensor, unless a pixel is above it.

    Args:
        before: the scale for the images before.
        parts: (n, 4) of the reduced image, see ``reduce_rows``.
    """
    if before.factor == 1 or grey.dtype == U8:
        return before
    rows = parts.copy()
    rows[:, 0] = np.floor(parts[:, 0] * before.factor)
    rows[:, 1] = np.ceil(parts[:, 1] * before.factor)
    highest = _highest_in_parts(grey, rows)
    is_known = before.saturated < FULL_SCALE_16
    if highest <= before.saturated and is_known:
        return before
    return _scale_for(grey, before.factor, full_scale_shown(highest))


def _scale_for(grey: Image, factor: float, saturated: int) -> Scale:
    if factor == 1:
        return FULL
    if grey.dtype == U8:
        return Scale(factor, FULL_SCALE_16 // 255, 255)
    gain = 1
    while saturated * gain * 2 <= FULL_SCALE_16:
        gain *= 2
    return Scale(factor, gain, saturated)


def rows_at(across_px: NDArray[np.float64], factor: float) -> NDArray[np.float64]:
    """Rows (N,) of the image with ``factor`` rows made one: the inverse of ``Scale.across_px``."""
    return across_px if factor == 1 else (across_px - (factor - 1) / 2) / factor


def height_at(rows: int, factor: float) -> int:
    """How many rows an image of so many has with ``factor`` of them made one."""
    return int(rows / factor)


def rows_to_fill(
    parts: NDArray[np.int64], rows: int, sigma_rows: float, *, clipped: bool
) -> NDArray[np.int64]:
    """Parts (n, 4) of a reduced image of so many rows with what the fits read beyond them.

    Args:
        sigma_rows: the line's usual width as a standard deviation; 0 if it is not known.
        clipped: whether the flanks of a clipped core are read.
    """
    fit = math.ceil(FIT_SIGMAS * sigma_rows + FIT_MORE) if sigma_rows else WIDEST_FIT_ROWS
    beyond = FLANK_ROWS if clipped else max(min(fit, WIDEST_FIT_ROWS) - SEARCHED_BEYOND, 0)
    filled = parts.copy()
    filled[:, 0] = np.maximum(parts[:, 0] - beyond, 0)
    filled[:, 1] = np.minimum(parts[:, 1] + beyond, rows)
    return filled


def reduce_rows(
    grey: Image, scale: Scale, parts: NDArray[np.int64], out: NDArray[np.uint16]
) -> Image:
    """Fills ``out``, the image (H / factor, W) with ``factor`` rows made one by their mean.

    If rows are made one, a pixel is clipped where one of its rows is, and only ``parts`` (n, 4) of
    the reduced image are filled: first row and the one after the last, first column and the one
    after the last.
    """
    if scale.factor < 1:
        _double[grey.dtype](grey, scale.gain, scale.saturated, out)
    else:
        _reduce[grey.dtype](grey, parts, int(scale.factor), scale.gain, scale.saturated, out)
    return cast(Image, out)


def reduce_mask(where: NDArray[np.bool_] | None, factor: float) -> NDArray[np.bool_] | None:
    """The mask of the reduced image: pixels of which every row is in the mask."""
    if where is None or factor == 1:
        return where
    if factor < 1:
        return np.repeat(where, round(1 / factor), axis=0)
    made_one = int(factor)
    rows = where.shape[0] // made_one
    by_rows = where[: rows * made_one].reshape(rows, made_one, where.shape[1])
    return np.ascontiguousarray(by_rows.all(axis=1))


def _multiply(value: float | None, factor: float) -> float | None:
    return None if value is None else value * factor
