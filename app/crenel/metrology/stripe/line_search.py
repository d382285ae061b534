"""What is said of a line, and of its place, before it is looked for."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.image import Image
from crenel.metrology.stripe.extraction import find_stripe
from crenel.metrology.stripe.found_line import FoundLine
from crenel.metrology.stripe.laser_alone import LaserAlone
from crenel.metrology.stripe.line_bounds import LineBounds
from crenel.metrology.stripe.points import Stripe
from crenel.metrology.stripe.settings import AUTOMATIC, StripeSettings


@dataclass(frozen=True)
class LineSearch:
    """How a line is looked for in pictures of one size.

    ``where``: (H, W) pixels in which it may lie; None: anywhere. ``bounds``: where it can be, by
    the sensor's calibration.
    """

    settings: StripeSettings = AUTOMATIC
    where: NDArray[np.bool_] | None = None
    bounds: LineBounds | None = None

    def find(
        self, picture: Image | LaserAlone, axis: str, within: NDArray[np.bool_] | None = None
    ) -> FoundLine:
        """The line in a picture, with heights in the levels of the image that is measured.

        Args:
            picture: (H, W) grey, or the laser's light alone, whose steps the threshold is made.
            axis: as in ``find_stripe``.
            within: (H, W) pixels in which it may lie, too; None: anywhere.

        Raises:
            OperationError: as ``find_stripe``.
        """
        where = self.where if within is None else self.restrict(within)
        if not isinstance(picture, LaserAlone):
            return find_stripe(picture, axis, where, self.settings, self.bounds)
        settings = picture.in_steps(self.settings)
        return find_stripe(picture.image, axis, where, settings, self.bounds)

    def extract(
        self, picture: Image | LaserAlone, axis: str, within: NDArray[np.bool_] | None = None
    ) -> Stripe:
        """The points of the line; arguments and errors are those of ``find``."""
        return self.find(picture, axis, within).stripe

    def usable_pixels(self, axis: str) -> NDArray[np.bool_] | None:
        """(H, W) pixels in which a line along an axis may lie, and can; None: all."""
        if self.bounds is None or self.bounds.axis != axis:
            return self.where
        return self.restrict(self.bounds.where())

    def restrict(self, within: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """(H, W) pixels of ``within`` in which the line may lie."""
        return within if self.where is None else within & self.where


ANYWHERE = LineSearch()
"""Nothing is said of the line."""
