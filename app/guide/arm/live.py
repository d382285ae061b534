"""What the view of an arm session depends on beside its journal. Pure."""

from dataclasses import dataclass

from app.guide.arm.state import Angles
from app.guide.library import Library
from app.guide.view import Busy
from app.metrology.arm import Arm
from app.station.device_state import DeviceState
from app.station.findings import Finding


@dataclass(frozen=True)
class ArmLive:
    """The station as the arm session sees it."""

    library: Library
    arm: Arm | None
    """The chosen one's model."""
    link: DeviceState
    connected_joints: int | None
    q_rad: Angles | None
    """The newest sample."""
    left_mm: float | None
    """How far the tip is from its seat, where it has left it."""
    has_hand: bool
    hand_running: bool
    busy: Busy | None
    trouble: Finding | None
