"""What makes picked points err: by the readings beside their cloud and the calibration of it."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.formats.clouds.frame_readings import FrameReadings, read_frame_readings
from crenel.formats.datasheets.arm import read_any_arm
from crenel.messages.message import Text, message
from crenel.metrology.arm.kinematics import AnyArm, flange_poses
from crenel.metrology.transforms import Floats, inverse
from crenel.parts.evaluate_folder import StationKnowledge, read_station
from crenel.parts.evaluate_points import motion_at
from crenel.parts.maths.point_errors import ScanErrors

FRAMES_OF_SCAN = 1 << 32
"""Keys of frames count so many for each scan."""
SAME_PLACE_MM = 1e-4
"""A point of the calibration lies so near to the laser plane of its frame."""
REMEMBERED = 4


@dataclass(frozen=True)
class StationFiles:
    """The calibration of one sensor of a scan, and the arm on which it was made."""

    calibration: Path
    arm: Path


@dataclass(frozen=True)
class ScanFiles:
    """What is known of the scan of some points."""

    readings: Path | None
    """``readings.ply``; None of a scan without."""
    calibrations: tuple[StationFiles, ...] = ()
    """Of each of its sensors, in the order of their names; empty: not known."""
    why_unknown: Text = ""
    """Why its errors cannot be known; empty: they may be."""


@dataclass(frozen=True)
class PickedPoints:
    """Points of scans in the view."""

    points_mm: Floats
    """(N, 3) arm frame."""
    spread_mm: Floats
    """(N,) standard uncertainty by the fit of the stripe, as the cloud has it."""
    frame: NDArray[np.int64]
    """(N,) number of the frame in its scan."""
    scan: NDArray[np.int64]
    """(N,) number of the scan."""
    files: dict[int, ScanFiles]
    """What is known of each of the scans, by its number."""

    def select(self, kept: NDArray[np.int64]) -> "PickedPoints":
        """Some of the points."""
        return PickedPoints(
            self.points_mm[kept],
            self.spread_mm[kept],
            self.frame[kept],
            self.scan[kept],
            self.files,
        )

    @property
    def keys(self) -> NDArray[np.int64]:
        """(N,) of the frames of all scans."""
        return self.scan * FRAMES_OF_SCAN + self.frame


@dataclass(frozen=True)
class KnownPoints:
    """Points with their errors, where the estimated errors of links are put right."""

    errors: ScanErrors
    station: StationKnowledge
    keys: NDArray[np.int64]
    """(F,) of the frames of ``errors``."""


class UnknownErrors(Exception):  # noqa: N818 - no failure: points have no more than their scatter
    """Why only the scatter of points is known."""

    def __init__(self, why: Text) -> None:
        super().__init__(str(why))
        self.why = why


def find_errors(picked: PickedPoints) -> KnownPoints:
    """The errors of picked points.

    Raises:
        UnknownErrors: they are not known; it says why.
    """
    keys, frame = np.unique(picked.keys, return_inverse=True)
    rows, used = [], set()
    for number in np.unique(picked.scan):
        files = picked.files[int(number)]
        readings = _readings(files)
        own = keys[keys // FRAMES_OF_SCAN == number] % FRAMES_OF_SCAN
        at = readings.rows_of(own)
        if (at < 0).any():
            raise UnknownErrors(message("element-frames-without-readings"))
        sensors = np.unique(readings.sensor[at])
        if not files.calibrations or sensors.max() >= len(files.calibrations):
            raise UnknownErrors(message("element-calibration-not-there"))
        used |= {files.calibrations[int(one)] for one in sensors}
        rows.append(readings.readings[at])
    if len(used) > 1:
        raise UnknownErrors(message("element-points-of-several-calibrations"))
    (files_used,) = used
    station, arm = _read(files_used)
    if station.shared is None:
        raise UnknownErrors(next(iter(station.warnings), message("part-arm-errors-unknown")))
    errors = _errors(picked, frame.astype(np.int64), np.concatenate(rows), station, arm)
    return KnownPoints(errors, station, keys)


def _readings(files: ScanFiles) -> FrameReadings:
    if files.why_unknown:
        raise UnknownErrors(files.why_unknown)
    if files.readings is None or not files.readings.is_file():
        raise UnknownErrors(message("element-scan-without-readings"))
    try:
        return read_frame_readings(files.readings)
    except OperationError as error:
        raise UnknownErrors(error.text) from None


def _errors(
    picked: PickedPoints,
    frame: NDArray[np.int64],
    readings: Floats,
    station: StationKnowledge,
    arm: AnyArm,
) -> ScanErrors:
    """The errors of points of one calibration, moved to where its links say.

    Args:
        frame: (N,) rows of ``readings`` (F, k).
        arm: as the cloud was made with.
    """
    calibration = station.calibration
    mounted = calibration.T_flange_sensor
    motion = motion_at(station.arm, readings)
    T_sensor_arm = inverse(flange_poses(arm, readings) @ mounted)
    seen = _move(T_sensor_arm[frame], picked.points_mm)
    off = seen @ calibration.plane.normal - calibration.plane.offset_mm
    if np.abs(off).max() > SAME_PLACE_MM:
        raise UnknownErrors(message("element-cloud-of-other-calibration"))
    T_arm_sensor = motion.T_arm_flange @ mounted
    return ScanErrors(
        _move(T_arm_sensor[frame], seen),
        frame,
        picked.spread_mm,
        calibration.camera,
        calibration.plane,
        mounted,
        station.pivot_mm,
        calibration.stripe_axis,
        motion,
        station.reading_sd,
    )


def _move(T: Floats, points: Floats) -> Floats:
    """Points (N, 3), each by its own transform (N, 4, 4)."""
    return np.asarray(np.einsum("nij,nj->ni", T[:, :3, :3], points) + T[:, :3, 3])


def _read(files: StationFiles) -> tuple[StationKnowledge, AnyArm]:
    try:
        stamps = tuple(one.stat().st_mtime_ns for one in (files.calibration, files.arm))
        return _read_once(files, stamps)
    except (OperationError, OSError) as error:
        why = error.text if isinstance(error, OperationError) else str(error)
        raise UnknownErrors(why) from None


@lru_cache(maxsize=REMEMBERED)
def _read_once(files: StationFiles, stamps: Sequence[int]) -> tuple[StationKnowledge, AnyArm]:
    """Arm and sensor, and the arm as its file has it; files that did not change are read once."""
    return read_station(files.calibration, files.arm), read_any_arm(files.arm)
