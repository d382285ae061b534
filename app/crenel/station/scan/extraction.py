"""How the live station extracts stripes: by the operator's settings, outside the zones."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.formats.settings.scan_settings import ScanSettings
from crenel.messages.message import message
from crenel.metrology.image import Image
from crenel.metrology.stripe import (
    AUTOMATIC,
    ONE_OF_TWO,
    LineBounds,
    Stripe,
    StripeSettings,
    StripeTracker,
    extract_stripe,
    find_stripe,
    has_second_line,
)
from crenel.metrology.transforms import Floats
from crenel_hardware.interfaces import Line


@dataclass(frozen=True)
class Extraction:
    """For frames of one sensor."""

    axis: Literal["u", "v"] = "u"
    settings: StripeSettings = AUTOMATIC
    where: NDArray[np.bool_] | None = None
    """(height, width) pixels in which the stripe may lie; frames of another size are taken
    whole."""
    bounds: LineBounds | None = None
    """Where the line can be, by the sensor's calibration."""

    def stripe(self, image: Image) -> Stripe:
        """The stripe of one frame; raises as ``extract_stripe``."""
        return extract_stripe(image, self.axis, self._where(image), self.settings, self.bounds)

    def sees_two_lines(self, image: Image) -> bool:
        """Whether a second laser's line is in a frame, so that points may jump between the two;
        raises as ``extract_stripe``."""
        if self.settings.choice in ONE_OF_TWO:
            return False
        where = self._where(image)
        return has_second_line(image, find_stripe(image, self.axis, where, self.settings), where)

    def band(self, image: Image) -> StripeTracker:
        """For frames of this size that follow one another."""
        return StripeTracker(self.axis, self._where(image), self.settings, bounds=self.bounds)

    def line_stripe(self, line: Line) -> Stripe:
        """The stripe that the sensor found itself, without its points in the zones.

        Points that are not numbers, or lie outside the picture, are left out.

        Raises:
            OperationError: the lists are not of one length.
        """
        lists = [
            np.asarray(numbers, dtype=np.float64)
            for numbers in (line.u, line.v, line.intensity, line.sigma_px)
        ]
        if {numbers.shape for numbers in lists} != {(len(lists[0]),)}:
            raise OperationError(
                "odd-line",
                message("sensors-line-lists-differ"),
                remedy=message("start-again-within-sentence"),
            )
        u, v, intensity, sigma_px = (numbers[self._is_usable(line, *lists)] for numbers in lists)
        return Stripe(u, v, intensity, sigma_px, self.axis)

    def _is_usable(
        self, line: Line, u: Floats, v: Floats, intensity: Floats, sigma_px: Floats
    ) -> NDArray[np.bool_]:
        """(N,) which points of a line have a place in the picture, outside the zones."""
        with np.errstate(invalid="ignore"):
            column, row = np.floor(u + 0.5), np.floor(v + 0.5)
            usable = (column >= 0) & (column < line.width_px) & (row >= 0) & (row < line.height_px)
            usable &= np.isfinite(intensity) & np.isfinite(sigma_px) & (sigma_px > 0)
        if self.where is not None and self.where.shape == (line.height_px, line.width_px):
            rows, columns = row[usable].astype(int), column[usable].astype(int)
            usable[usable] = self.where[rows, columns]
        return usable

    def _where(self, image: Image) -> NDArray[np.bool_] | None:
        return self.where if self.where is not None and self.where.shape == image.shape else None


def extraction_by(
    settings: ScanSettings, axis: Literal["u", "v"], bounds: LineBounds | None = None
) -> Extraction:
    """As the settings have it, within the bounds of a calibration."""
    mask = settings.mask
    where = mask.where() if mask is not None and mask.zones else None
    return Extraction(axis, settings.stripe, where, bounds)
