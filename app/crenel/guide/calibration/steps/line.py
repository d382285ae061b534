"""What can be set of the laser's line where a picture does not show it. Pure."""

from collections.abc import Sequence

from crenel.guide.calibration.live import CalibrationLive
from crenel.guide.calibration.rules import offer
from crenel.guide.calibration.state import CalibrationState, PoseCapture
from crenel.guide.common.view import LineForm
from crenel.messages.message import message


def line_form(state: CalibrationState, live: CalibrationLive) -> LineForm | None:
    """The settings, where a line was refused, or where some are set; None otherwise."""
    refused = _without_line(state.pictures, live)
    if not refused and not state.line:
        return None
    return LineForm(
        threshold=state.line.get("threshold"),
        min_width_px=state.line.get("min_width_px"),
        max_width_px=state.line.get("max_width_px"),
        choice=state.line.get("choice", "continuity"),
        refused=refused,
        action=offer(state, live, "set_line", message("look-for-line-again")),
    )


def _without_line(pictures: Sequence[PoseCapture], live: CalibrationLive) -> tuple[int, ...]:
    """Numbers of the poses with the laser on in whose pictures no line is found."""
    return tuple(
        picture.number
        for picture in pictures
        if picture.lighting != "ambient" and not live.capture_outcomes[picture.number].stripe
    )
