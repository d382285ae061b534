"""What the view of a verification depends on beside its journal. Pure."""

from collections.abc import Mapping
from dataclasses import dataclass

from app.errors import OperationError
from app.formats.datasheets.gauge import GaugeFile, VerificationLimits
from app.formats.results.verification import FigurePart, VerificationVerdict
from app.guide.common.datasheet_library import Gauges
from app.guide.common.rules import SessionLive
from app.messages.message import Text
from app.metrology.arm.kinematics import AnyArm
from app.metrology.arm.strained_pose import Strain
from app.metrology.decision import DecisionRule
from app.metrology.gauges.probed_gauge import ProbedGauge
from app.station.devices.link_state import DeviceState
from app.workflows.measure_gauge import GaugeFit
from app.workflows.verification_metrics import CloudErrors


@dataclass(frozen=True)
class CloudResults:
    """What the clouds that count show."""

    fits: Mapping[int, GaugeFit]
    """Of every cloud that was measured, by its number."""
    errors: Mapping[int, CloudErrors]
    figures: tuple[FigurePart, ...]
    verdict: VerificationVerdict | None


@dataclass(frozen=True)
class VerifyLive(SessionLive):
    """The station as the verification sees it."""

    active_id: str
    """The calibration in use; empty without one."""
    active_name: str
    gauges: Gauges[GaugeFile]
    gauge: GaugeFile | None
    """The chosen one; from the touches on the session's own copy."""
    limits: VerificationLimits
    arm: AnyArm | None
    touched: ProbedGauge | OperationError | None
    """The gauge by the touches, or why they do not fix it; None without touches."""
    judged: CloudResults
    rule: DecisionRule
    arm_link: DeviceState
    sensor_link: DeviceState
    still: bool
    strain: Strain | None
    """Why the pose strains the arm."""
    scan_why_not: Text
    scan_points: int
