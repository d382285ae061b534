"""What one step contributes to the view. Pure."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from app.findings import Finding
from app.guide.calibration.live import CalibrationLive
from app.guide.calibration.rules import rejection_reason
from app.guide.calibration.state import CalibrationState
from app.guide.common.view import (
    Action,
    BlockGeometry,
    BoardGeometry,
    LiveNumber,
    ObjectGeometry,
    Picture,
    StepProgress,
)
from app.messages.message import Text, join, message
from app.metrology.targets.chessboard import Chessboard
from app.metrology.targets.target import CalibrationTarget


@dataclass(frozen=True)
class StepView:
    """A step's own part of the view; actions of its own come first."""

    instruction: Text
    picture: Picture
    actions: Sequence[Action]
    number: LiveNumber | None = None
    progress: StepProgress | None = None
    findings: Sequence[Finding] = ()


def offer(
    state: CalibrationState,
    live: CalibrationLive,
    name: str,
    label: Text,
    args: Mapping[str, object] | None = None,
    primary: bool = False,
    confirm: Text = "",
) -> Action:
    """The action, enabled or with the reason why not."""
    reason = rejection_reason(state, live, name, args or {})
    return Action(name, label, args or {}, primary, not reason, reason, confirm)


def geometry(item: CalibrationTarget) -> ObjectGeometry:
    """The object for drawing."""
    if isinstance(item, Chessboard):
        return BoardGeometry(item.inner_corners, item.square_mm)
    return BlockGeometry(
        edges_x_mm=item.edges_x_mm,
        front_y_mm=item.front_y_mm,
        back_y_mm=item.back_y_mm,
        crest_z_mm=item.crest_z_mm,
        floor_z_mm=item.floor_z_mm,
        base_z_mm=item.base_z_mm,
    )


def device_findings(live: CalibrationLive) -> list[Finding]:
    """A device that went away while the operator is at work; nothing is lost by it."""
    return [
        Finding(
            "bad",
            join([link.title, link.text], ": "),
            message("wait-check-what-taken-kept"),
        )
        for link in (live.arm_link, live.sensor_link)
        if link.state != "connected"
    ]
