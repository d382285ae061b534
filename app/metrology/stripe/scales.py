"""Scales at which a stripe is looked for: several rows made one, so that a wide line is narrow, or
one made two for a line of hardly a pixel."""

from dataclasses import dataclass
from typing import cast

import numpy as np
from numpy.typing import NDArray

from app.metrology.image import Image, saturation_level
from app.metrology.stripe.settings import StripeSettings
from app.native.arguments import I64, U8, U16, Array, Function, Integer
from app.native.library import CRENEL

WIDE_FACTORS = (3.0, 9.0)
"""Rows that are made one for wide lines: at each, lines of about 2 to 25 rows are found."""
THIN_FACTOR = 0.5
"""Rows that are made one for lines thinner than two pixels."""
LEAST_ROWS = 64
"""No factor leaves fewer rows."""
STEEPEST_PX = 4.0
"""Pixels by which a line may climb from one column to the next."""
FULL_SCALE_16 = 65535

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
    if grey.dtype == U8:
        return Scale(factor, FULL_SCALE_16 // 255, 255)
    saturated = int(saturation_level(grey))
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
