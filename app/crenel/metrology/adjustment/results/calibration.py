"""What a calibration by an adjustment gives, on whichever target."""

from dataclasses import dataclass

from crenel.metrology.adjustment.core.gauss_newton import AdjustmentResult
from crenel.metrology.adjustment.core.uncertainty import CalibrationUncertainty
from crenel.metrology.adjustment.results.poses import PoseResult
from crenel.metrology.calibration.findings import CalibrationFinding, WorstResidual
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.transforms import Floats, inverse


@dataclass(frozen=True, kw_only=True)
class AdjustedCalibration:
    """A calibration and what it rests on.

    The sensor frame is the target's frame as the first used pose saw it (Eq. 6): a choice,
    which lets one pose give what the article gives.
    """

    adjustment: AdjustmentResult
    camera: Camera
    plane: LaserPlane | None
    """None where no picture shows the laser's line."""
    T_flange_sensor: Floats
    """The probe matrix (Eq. 8)."""
    T_arm_obj: Floats
    """Where the target stands."""
    poses: tuple[PoseResult, ...]
    uncertainty: CalibrationUncertainty
    stripe_rms_um: float | None
    """The rms of the stripe's points from the laser plane, where there are any."""
    depth_range_mm: tuple[float, float]
    findings: tuple[CalibrationFinding, ...]
    worst: tuple[WorstResidual, ...]


def first_view(found: AdjustmentResult) -> Floats:
    """``T_cam_obj`` (4, 4) of the first used pose, which is chosen as ``T_cam_sensor``."""
    T_arm_flange = found.problem.motion.T_arm_flange[0]
    return inverse(T_arm_flange @ found.state.T_flange_cam) @ found.state.T_arm_obj
