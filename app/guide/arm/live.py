"""What the view of an arm session depends on beside its journal. Pure."""

from dataclasses import dataclass

from app.findings import Finding
from app.guide.arm.state import Angles
from app.guide.common.datasheet_library import DatasheetLibrary
from app.guide.common.view import Busy
from app.metrology.arm.kinematics import Arm
from app.station.devices.link_state import DeviceState


@dataclass(frozen=True)
class ArmLive:
    """The station as the arm session sees it."""

    library: DatasheetLibrary
    arm: Arm | None
    """The chosen one's model."""
    link: DeviceState
    connected_joints: int | None
    q_rad: Angles | None
    """The newest sample."""
    left_mm: float | None
    """How far the tip is from its seat, where it has left it."""
    has_simulation: bool
    simulation_running: bool
    busy: Busy | None
    trouble: Finding | None
