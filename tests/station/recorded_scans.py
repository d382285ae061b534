"""What is in a scan's recording, and what is rebuilt from it."""

from pathlib import Path
from typing import TypeVar

import numpy as np

from app.formats.clouds.files import read_cloud
from app.formats.recording.reader import open_recording
from app.formats.results.calibration import Calibration, SerialNumbers
from app.metrology.arm.kinematics import AnyArm
from app.station.scan.points import ScanCalibration
from app.station.scan.scanner import Scanner
from app.station.scan.state import ScanResult
from app.workflows.reconstruct import Reconstruction, reconstruct_cloud
from app.workflows.sensor_calibrations import SensorCalibrations

R = TypeVar("R")


def end_scan(scanner: Scanner) -> ScanResult:
    """Stops a scan that is under way."""
    result = scanner.stop()
    assert result is not None
    return result


def recorded(folder: Path, kind: type[R]) -> list[R]:
    """The records of a kind in a scan's recording."""
    records = open_recording(folder / "scan.mcap").records()
    return [one for one in records if isinstance(one, kind)]


def file_calibration(use: ScanCalibration) -> Calibration:
    """The calibration of a scan, as a file has it."""
    serials = SerialNumbers(arm=use.arm_serial, sensor=use.sensor_serial, object="B-1")
    return Calibration(use.camera, use.plane, use.T_flange_sensor, "u", serials)


def check_rebuilt(folder: Path, calibration: SensorCalibrations, arm: AnyArm) -> Reconstruction:
    """A scan's recording, rebuilt, gives the very points that were saved live."""
    again, live = folder / "again.ply", folder / "cloud.ply"
    rebuilt = reconstruct_cloud(folder / "scan.mcap", calibration, arm, again)
    points = read_cloud(again).points_mm
    np.testing.assert_allclose(points, read_cloud(live).points_mm, atol=1e-6)
    return rebuilt
