"""What is said of a line, and of its place, before it is looked for."""

from dataclasses import dataclass
from typing import cast

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.image import Image
from crenel.metrology.stripe.extraction import find_stripe, orient_image, orient_mask
from crenel.metrology.stripe.found_line import FoundLine
from crenel.metrology.stripe.laser_alone import LaserAlone
from crenel.metrology.stripe.line_bounds import LineBounds
from crenel.metrology.stripe.one_scale import extract_parts, whole_image
from crenel.metrology.stripe.points import Stripe
from crenel.metrology.stripe.scales import reduce_mask, scale_of
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

    def explain(self, picture: Image | LaserAlone, axis: str, found: FoundLine) -> FoundLine:
        """A line that ``find`` gave, at its scale alone, with what decided about it."""
        image, settings = picture, self.settings
        if isinstance(picture, LaserAlone):
            image, settings = picture.image, picture.in_steps(self.settings)
        grey, factor = orient_image(cast(Image, image), axis), found.factor
        bounds = self.bounds
        has_bounds = bounds is not None and bounds.fits(grey.shape, axis)
        parts = bounds.parts(factor) if bounds and has_bounds else whole_image(grey, factor)
        where = reduce_mask(orient_mask(self.where, grey, axis), factor)
        scale = scale_of(grey, factor)
        return extract_parts(grey, axis, parts, where, settings, scale=scale, explains=True)

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
