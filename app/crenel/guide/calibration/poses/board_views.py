"""Which pictures of a chessboard to take before there is a calibration to plan with. Pure."""

from collections.abc import Sequence

from crenel.guide.calibration.state import PoseCapture
from crenel.messages.message import Text, message
from crenel.metrology.adjustment.board.initial_guess import FEWEST_POSES
from crenel.metrology.adjustment.planning.next_pose import PoseDelta

# From straight above, then tilted to every side: a flat board fixes the focal length only where
# it is tilted, and where the sensor sits only where the arm turns about more than one axis.
VIEWS = (
    PoseDelta(0.0, 0.0, 0.0, 0.0),
    PoseDelta(20.0, 0.0, 0.0, 0.0),
    PoseDelta(0.0, 20.0, 20.0, 0.0),
    PoseDelta(-20.0, 0.0, 0.0, 0.0),
    PoseDelta(0.0, -20.0, -20.0, 0.0),
)
"""Each against a hold straight above the board."""


def next_view(listed: Sequence[PoseCapture]) -> int | None:
    """Which of ``VIEWS`` to take after the pictures taken, those set aside among them: the next,
    or in the end one that was set aside; None once the calibration shows which helps most."""
    aside = [view for view, picture in enumerate(listed[: len(VIEWS)]) if picture.gone]
    if sum(not picture.gone for picture in listed) >= len(VIEWS):
        return None
    if len(listed) < len(VIEWS):
        return len(listed)
    again = len(listed) - len(VIEWS)  # pictures taken since, for the first of those set aside
    return aside[min(again, len(aside) - 1)]


def plan_view(listed: Sequence[PoseCapture]) -> PoseDelta | None:
    """How to hold the sensor for the ``next_view``."""
    view = next_view(listed)
    return None if view is None else VIEWS[view]


def view_instruction(view: PoseDelta) -> Text:
    """How to hold the sensor, as one sentence."""
    if view == VIEWS[0]:
        return message("hold-sensor-straight-above-chessboard-longer")
    return message("straight-above-chessboard-follow-dashed-outline", words=view.words)


def still_missing(usable: int) -> Text:
    """Why there is no calibration yet from so many pictures; empty where there may be one."""
    more = FEWEST_POSES - usable
    if more <= 0:
        return ""
    if more == 1:
        return message("chessboard-seen-several-sides-take-one")
    return message("chessboard-seen-several-sides-take-more", more=more)
