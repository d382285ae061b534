"""Settings of stripe extraction that an operator can change."""

from dataclasses import dataclass
from typing import Literal

from crenel.errors import OperationError
from crenel.messages.message import Text, message, rounded

PeakChoice = Literal["continuity", "strength", "first", "last"]
CHOICES: tuple[PeakChoice, ...] = ("continuity", "strength", "first", "last")
SHORTEST_RUN = 6
"""A point belongs to a run of at least this many adjacent points."""
MOST_SMOOTHING_PX = 50.0


@dataclass(frozen=True)
class StripeSettings:
    """Settings that an operator can change; None means automatic, from the image.

    ``threshold``: grey levels by which the stripe exceeds its surroundings (otherwise four standard
    deviations of the noise). ``min_width_px``, ``max_width_px``: its width at half height
    (otherwise 0.45 and 2.2 times the usual one; 0.3 and 3.3 times where the line goes on on both
    sides, over at most 48 columns). ``min_run``: number of points of a piece, which is always more
    than a round spot of its width would show. ``choice``: which of several peaks of a column is the
    stripe. ``continuity``: the one whose piece of line is the brightest on average, where pieces of
    less than 40 points count by the square of their length; ``strength``: the brightest; ``first``
    and ``last``: the uppermost and the lowest (axis v: leftmost and rightmost) that belongs to a
    piece. ``smoothing_px``: standard deviation of the Gaussian by which points are smoothed along
    the line; structures of period λ keep exp(-2 (π smoothing_px / λ)²) of their height.
    """

    threshold: float | None = None
    min_width_px: float | None = None
    max_width_px: float | None = None
    min_run: int = SHORTEST_RUN
    choice: PeakChoice = "continuity"
    smoothing_px: float = 0.0

    @property
    def is_automatic(self) -> bool:
        """Whether nothing is said of what the line is like, but for pieces and smoothing."""
        return self == StripeSettings(min_run=self.min_run, smoothing_px=self.smoothing_px)


AUTOMATIC = StripeSettings()


def check_settings(settings: StripeSettings) -> None:
    """Checks that the settings make sense.

    Raises:
        OperationError: a value is negative or not finite, widths do not ascend, the choice is
            unknown, or the smoothing exceeds ``MOST_SMOOTHING_PX``.
    """
    least, most = settings.min_width_px, settings.max_width_px
    wrong: Text = ""
    if settings.threshold is not None and not settings.threshold >= 0:
        wrong = message("stripe-threshold-is", threshold=rounded(settings.threshold))
    elif least is not None and not least >= 0:
        wrong = message("stripe-minimum-width-is", width=rounded(least, "px"))
    elif most is not None and not most > (least or 0):
        wrong = message("stripe-maximum-width-is", width=rounded(most, "px"))
    elif settings.min_run < 1:
        wrong = message("stripe-pieces-of", points=settings.min_run)
    elif settings.choice not in CHOICES:
        wrong = message("stripe-choice-is", choice=str(settings.choice))
    elif not 0 <= settings.smoothing_px <= MOST_SMOOTHING_PX:
        wrong = message("stripe-smoothing-is", smoothing=rounded(settings.smoothing_px, "px"))
    if wrong:
        raise OperationError(
            "stripe-settings",
            wrong,
            message(
                "widths-positive-ascend-choice-one",
                choices=", ".join(CHOICES),
                smoothing=rounded(MOST_SMOOTHING_PX, "px"),
            ),
        )
