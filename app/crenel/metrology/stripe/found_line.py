"""A stripe that was found in an image, and how much of a line it is."""

import math
from dataclasses import dataclass

from crenel.metrology.stripe.line_evidence import LineEvidence
from crenel.metrology.stripe.points import Stripe
from crenel.metrology.stripe.scales import FULL, Scale
from crenel.metrology.stripe.workspace import PER_FULL_WIDTH

CERTAIN_LENGTH, CERTAIN_LENGTH_CLIPPED = 0.35, 0.6
"""A line so long, in shares of the image's width, is looked for at no other scale; the latter if
its core is clipped, unless its flanks show that it is narrow."""
THIN_SIGMA_ROWS, THIN_SIGMA_ROWS_BROKEN = 0.8, 1.2
CERTAIN_SIGMA_ROWS, CERTAIN_CORE_ROWS = 5.0, 24.0
"""A thinner line, or a thinner one that is not long, is looked for between the rows, too; one at
least so wide at coarser scales."""


@dataclass(slots=True)
class FoundLine:
    """A stripe, and how much of a line it is.

    ``evidence``: length of the line, in shares of the image's width, times its height in grey
    levels; 0 if it does not stand out of the image. ``length``: that of one piece which shows as
    much. ``scale``: how many rows of the image were made one. ``sigma_rows``: the usual width
    there, as a standard deviation; 0 if the line is clipped. ``core_rows``: that of its clipped
    core; 0 without one. ``fall_rows``: rows over which the core's flanks fall to half; 0 without
    any. ``saturated``: the grey level from which on the line counts as clipped.
    ``why``: what decided about it, where that was asked for.
    """

    stripe: Stripe
    evidence: float = 0.0
    length: float = 0.0
    scale: Scale = FULL
    sigma_rows: float = 0.0
    core_rows: float = 0.0
    fall_rows: float = 0.0
    saturated: float = math.inf
    why: LineEvidence | None = None

    @property
    def factor(self) -> float:
        """Rows of the image that were made one."""
        return self.scale.factor

    @property
    def width_px(self) -> float:
        """Its usual width at half height in pixels of the image; 0 if it is clipped."""
        return self.sigma_rows * self.factor / PER_FULL_WIDTH

    @property
    def broadest_px(self) -> float:
        """Its usual width, or that of its clipped core, in pixels of the image."""
        return max(self.width_px, self.core_px)

    @property
    def core_px(self) -> float:
        """The usual width of its clipped core in pixels of the image; 0 without one."""
        return self.core_rows * self.factor

    @property
    def clipped_sigma_rows(self) -> float:
        """The standard deviation of the Gaussian whose clipped core and flanks are so wide; 0 if
        there are no flanks."""
        return math.sqrt(self.fall_rows * (self.fall_rows + self.core_rows) / (2 * math.log(2)))

    @property
    def is_long(self) -> bool:
        """Whether it is one long line."""
        is_narrow = 0 < self.clipped_sigma_rows < CERTAIN_SIGMA_ROWS
        long = CERTAIN_LENGTH if self.sigma_rows or is_narrow else CERTAIN_LENGTH_CLIPPED
        return self.evidence > 0 and self.length >= long

    @property
    def is_certain(self) -> bool:
        """Whether it is one long line, of a width that no other scale would show better."""
        wide = self.sigma_rows >= CERTAIN_SIGMA_ROWS or self.core_rows >= CERTAIN_CORE_ROWS
        return self.is_long and not self.is_thin and not wide

    @property
    def is_thin(self) -> bool:
        """Whether rows between the rows would show more of it."""
        thin = THIN_SIGMA_ROWS if self.is_long else THIN_SIGMA_ROWS_BROKEN
        return self.factor == 1 and 0 < self.sigma_rows < thin
