"""What one step contributes to the view. Pure."""

from collections.abc import Sequence
from dataclasses import dataclass

from crenel.findings import Finding
from crenel.guide.common.view import (
    Action,
    BlockGeometry,
    BoardGeometry,
    LiveNumber,
    ObjectGeometry,
    Picture,
    StepProgress,
)
from crenel.messages.message import Text
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.targets.target import CalibrationTarget


@dataclass(frozen=True)
class StepView:
    """A step's own part of the view; actions of its own come first."""

    instruction: Text
    picture: Picture
    actions: Sequence[Action]
    number: LiveNumber | None = None
    progress: StepProgress | None = None
    findings: Sequence[Finding] = ()


def geometry(item: CalibrationTarget) -> ObjectGeometry:
    """The object for drawing."""
    if isinstance(item, Chessboard):
        return BoardGeometry(item.inner_corners, item.square_mm, item.first_is_black)
    return BlockGeometry(
        edges_x_mm=item.edges_x_mm,
        front_y_mm=item.front_y_mm,
        back_y_mm=item.back_y_mm,
        crest_z_mm=item.crest_z_mm,
        floor_z_mm=item.floor_z_mm,
        base_z_mm=item.base_z_mm,
    )
