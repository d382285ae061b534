"""Points of recordings and touches, with what makes them err."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from crenel.formats.clouds.points import Points, positions_of
from crenel.formats.session.calibration_session import ContactReadings
from crenel.messages.message import Text
from crenel.metrology.adjustment.core.arm_errors import FlangeMotion, arm_motion, robot_motion
from crenel.metrology.arm.kinematics import AnyArm, RobotArm, flange_poses, tip_centres
from crenel.metrology.transforms import Floats
from crenel.parts.evaluate_folder import StationKnowledge
from crenel.parts.maths.point_errors import ScanErrors, TouchErrors
from crenel.progress import Progress
from crenel.workflows.reconstruct import reconstruct_into


@dataclass(frozen=True)
class ScanData:
    """The points of one recording."""

    path: Path
    errors: ScanErrors
    sights: Floats
    """(N, 3) unit vectors from each point to the camera, arm frame."""
    warnings: tuple[Text, ...]


def read_scan(path: Path, station: StationKnowledge, progress: Progress) -> ScanData:
    """The points of a recording, with the arm at each of its frames.

    Raises:
        OperationError: as ``reconstruct_into``.
    """
    pieces: list[Points] = []
    readings: list[Floats] = []
    rebuilt = reconstruct_into(
        path,
        station.calibration,
        station.arm,
        lambda points, _: pieces.append(points),
        progress,
        take_frames=lambda first, sensor, poses, block: readings.append(block),
    )
    points = np.concatenate(pieces)
    return ScanData(
        path, *_scan_errors(points, np.concatenate(readings), station), rebuilt.warnings
    )


def _scan_errors(
    points: Points, readings: Floats, station: StationKnowledge
) -> tuple[ScanErrors, Floats]:
    used, frame = np.unique(points["frame"], return_inverse=True)
    calibration = station.calibration
    errors = ScanErrors(
        positions_of(points),
        frame.astype(np.int64),
        points["uncertainty_um"].astype(np.float64) / 1e3,
        calibration.camera,
        calibration.plane,
        calibration.T_flange_sensor,
        station.pivot_mm,
        calibration.stripe_axis,
        motion_at(station.arm, readings[used]),
        station.reading_sd,
    )
    T = errors.sensor_poses
    cameras = T[:, :3, :3] @ calibration.camera.centre_mm + T[:, :3, 3]
    sights = cameras[errors.frame] - errors.points_mm
    sights /= np.linalg.norm(sights, axis=1)[:, None]
    return errors, sights


def motion_at(arm: AnyArm, readings: Floats) -> FlangeMotion:
    """The flange at readings (N, k), and what moves it."""
    if isinstance(arm, RobotArm):
        return robot_motion(flange_poses(arm, readings))
    return arm_motion(arm, readings)


def select_touches(
    contacts: ContactReadings, name: str, station: StationKnowledge, side: float
) -> tuple[TouchErrors, NDArray[np.int64]]:
    """The touches of a feature, and their numbers in the file, from 0.

    Args:
        side: +1 where the tip is on the side to which the feature's normal points, else -1.
    """
    rows = np.array([k for k, one in enumerate(contacts.features) if one == name], dtype=np.int64)
    readings = contacts.arm_readings[rows]
    arm = station.arm
    errors = TouchErrors(
        tip_centres(arm, readings),
        np.full(len(rows), side),
        motion_at(arm, readings),
        station.reading_sd,
        station.touch_sd_mm,
    )
    return errors, rows


def merge_scans(scans: list[ScanData]) -> tuple[ScanErrors, Floats]:
    """All recordings as one, with their frames one after the other; and the lines of sight."""
    if len(scans) == 1:
        return scans[0].errors, scans[0].sights
    each = [one.errors for one in scans]
    frames = np.cumsum([0, *(len(one.motion.T_arm_flange) for one in each)])
    motion = FlangeMotion(
        np.concatenate([one.motion.T_arm_flange for one in each]),
        np.concatenate([one.motion.by_links for one in each]),
        np.concatenate([one.motion.by_noise for one in each]),
        each[0].motion.noise_sd,
    )
    first = each[0]
    errors = ScanErrors(
        np.concatenate([one.points_mm for one in each]),
        np.concatenate([one.frame + start for one, start in zip(each, frames[:-1], strict=True)]),
        np.concatenate([one.spread_mm for one in each]),
        first.camera,
        first.plane,
        first.T_flange_sensor,
        first.pivot_mm,
        first.axis,
        motion,
        first.reading_sd,
    )
    return errors, np.concatenate([one.sights for one in scans])
