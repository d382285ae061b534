"""How the live station extracts stripes: by the operator's settings, outside the zones."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from app.formats.settings.scan_settings import ScanSettings
from app.metrology.image import Image
from app.metrology.stripe import AUTOMATIC, Stripe, StripeSettings, StripeTracker, extract_stripe


@dataclass(frozen=True)
class Extraction:
    """For frames of one sensor."""

    axis: Literal["u", "v"] = "u"
    settings: StripeSettings = AUTOMATIC
    where: NDArray[np.bool_] | None = None
    """(height, width) pixels in which the stripe may lie; frames of another size are taken
    whole."""

    def stripe(self, image: Image) -> Stripe:
        """The stripe of one frame; raises as ``extract_stripe``."""
        return extract_stripe(image, self.axis, self._where(image), self.settings)

    def band(self, image: Image) -> StripeTracker:
        """For frames of this size that follow one another."""
        return StripeTracker(self.axis, self._where(image), self.settings)

    def _where(self, image: Image) -> NDArray[np.bool_] | None:
        return self.where if self.where is not None and self.where.shape == image.shape else None


def extraction_by(settings: ScanSettings, axis: Literal["u", "v"]) -> Extraction:
    """As the settings have it."""
    mask = settings.mask
    where = mask.where() if mask is not None and mask.zones else None
    return Extraction(axis, settings.stripe, where)
