"""The delay of a simulated station: found from a pass, and taken out of the cloud."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from crenel.formats.recording.decoders import JointRecord
from crenel.formats.settings.sync import Sync
from crenel.metrology.arm.kinematics import AnyArm, flange_poses
from crenel.metrology.fitting.plane_sphere import fit_plane
from crenel.workflows.estimate_delay import estimate_recording_delay
from crenel.workflows.reconstruct import reconstruct_points
from crenel_hardware.simulator.station import SimulatedStation
from tests.station.simulated import (
    USUAL,
    Station,
    end_scan,
    file_calibration,
    nominal_of,
    recorded,
    station,
)

pytestmark = pytest.mark.device
__all__ = ["station"]  # a fixture
DELAY_MS = 4.0
CONFIG = replace(USUAL, arm_delay_ms=DELAY_MS)


def plane_rms_um(points: np.ndarray, simulation: SimulatedStation) -> float:
    nominal = nominal_of(simulation, "plate")
    off = (points - nominal["point_mm"]) @ nominal["normal"]
    return 1e3 * fit_plane(points[np.abs(off) < 1.5]).rms_mm


def transport_ms(
    recording: Path, arm: AnyArm, T_flange_sensor: np.ndarray, simulation: SimulatedStation
) -> float:
    """By how much the arm's stamps are late of themselves: its line takes a while."""
    joints = recorded(recording.parent, JointRecord)[200:-200:20]
    reported = flange_poses(arm, np.array([record.q_rad for record in joints])) @ T_flange_sensor
    lags_ms = np.arange(-1.0, 3.0, 0.05)
    off = []
    for lag_ms in lags_ms:
        true = [simulation.sensor_pose(record.stamp_ns - round(1e6 * lag_ms)) for record in joints]
        off.append(np.median(np.linalg.norm((np.array(true) - reported)[:, :3, 3], axis=1)))
    return float(lags_ms[np.argmin(off)])


def test_a_late_arm_is_found_out_and_put_right(station: Station, tmp_path: Path) -> None:
    station.scanner.start("pass")
    assert station.simulation.operator.pass_over_plate()
    recording = end_scan(station.scanner).folder / "scan.mcap"
    use = station.calibration
    calibration = file_calibration(use)
    found = estimate_recording_delay(recording, calibration, use.arm)
    true_ms = DELAY_MS + transport_ms(recording, use.arm, use.T_flange_sensor, station.simulation)
    assert found.standard_uncertainty_ms < 0.3  # a busy machine draws fewer pictures
    assert abs(found.delay_ms - true_ms) < 3 * found.standard_uncertainty_ms + 0.05
    found.write(tmp_path / "sync.json")
    assert Sync.read(tmp_path / "sync.json") == found

    before, _ = reconstruct_points(recording, calibration, use.arm)
    after, _ = reconstruct_points(recording, calibration, use.arm, found.course)
    assert plane_rms_um(before, station.simulation) > 3 * plane_rms_um(after, station.simulation)
