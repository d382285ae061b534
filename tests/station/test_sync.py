"""The delay of a simulated station: found from a pass, and taken out of the cloud."""

import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from app.formats.recording.decoders import JointRecord
from app.formats.recording.reader import open_recording
from app.formats.results.calibration import Calibration, SerialNumbers
from app.formats.settings.scan_settings import Sync
from app.metrology.arm.kinematics import AnyArm, flange_poses
from app.metrology.fitting.plane_sphere import fit_plane
from app.station.bus import Bus
from app.station.devices.rig import Rig
from app.station.scan.scanner import Scanner
from app.station.view3d.scene import Scene
from app.workflows.estimate_delay import estimate_recording_delay
from app.workflows.reconstruct import reconstruct_points
from hardware.registry import arm_driver
from hardware.simulator.station import SimulatedStation
from tests.station.conftest import until
from tests.station.test_on_simulation import CONFIG, true_calibration

pytestmark = pytest.mark.device

DELAY_MS = 4.0


@pytest.fixture(scope="module")
def late() -> Iterator[SimulatedStation]:
    with SimulatedStation(replace(CONFIG, arm_delay_ms=DELAY_MS)) as simulation:
        yield simulation


def plane_rms_um(points: np.ndarray, simulation: SimulatedStation) -> float:
    nominal = json.loads(json.dumps(simulation.datasheets()["plate.nominal.json"]))
    off = (points - nominal["point_mm"]) @ nominal["normal"]
    return 1e3 * fit_plane(points[np.abs(off) < 1.5]).rms_mm


def transport_ms(
    recording: Path, arm: AnyArm, T_flange_sensor: np.ndarray, simulation: SimulatedStation
) -> float:
    """By how much the arm's stamps are late of themselves: its line takes a while."""
    records = open_recording(recording).records()
    joints = [record for record in records if isinstance(record, JointRecord)][200:-200:20]
    reported = flange_poses(arm, np.array([record.q_rad for record in joints])) @ T_flange_sensor
    lags_ms = np.arange(-1.0, 3.0, 0.05)
    off = []
    for lag_ms in lags_ms:
        true = [simulation.sensor_pose(record.stamp_ns - round(1e6 * lag_ms)) for record in joints]
        off.append(np.median(np.linalg.norm((np.array(true) - reported)[:, :3, 3], axis=1)))
    return float(lags_ms[np.argmin(off)])


def test_a_late_arm_is_found_out_and_put_right(
    late: SimulatedStation, bus: Bus, tmp_path: Path
) -> None:
    rig = Rig(
        bus, lambda: arm_driver("serial-encoder", {"url": late.arm_url}), late.sensor, tmp_path
    )
    use = true_calibration(late, tmp_path)
    rig.arm.set_model(use.arm)
    rig.start()
    scene = Scene(point_budget=100_000)
    scanner = Scanner(bus, rig, scene, tmp_path / "scans")
    until(lambda: rig.arm.fresh and rig.sensor.fresh)
    scanner.set_calibration(use)
    until(lambda: scanner.why_not() is None)
    scanner.start("pass")
    assert late.operator.pass_over_plate()
    result = scanner.stop()
    scanner.close()
    scene.close()
    rig.stop()
    assert result is not None
    serials = SerialNumbers(arm=use.arm_serial, sensor=use.sensor_serial)
    calibration = Calibration(use.camera, use.plane, use.T_flange_sensor, "u", serials)

    recording = result.folder / "scan.mcap"
    found = estimate_recording_delay(recording, calibration, use.arm)
    true_ms = DELAY_MS + transport_ms(recording, use.arm, use.T_flange_sensor, late)
    assert found.standard_uncertainty_ms < 0.1
    assert abs(found.delay_ms - true_ms) < 3 * found.standard_uncertainty_ms + 0.05
    found.write(tmp_path / "sync.json")
    assert Sync.read(tmp_path / "sync.json") == found

    before, _ = reconstruct_points(recording, calibration, use.arm)
    after, _ = reconstruct_points(recording, calibration, use.arm, found.delay_ns)
    assert plane_rms_um(before, late) > 3 * plane_rms_um(after, late)
