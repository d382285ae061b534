"""Devices and scans of simulated stations, what scans must be, and what is in their recordings."""

import json
import shutil
from collections.abc import Iterator
from contextlib import closing, contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
import pytest

from crenel.formats.clouds.files import read_cloud
from crenel.formats.clouds.frame_readings import READINGS, read_frame_readings
from crenel.formats.datasheets.arm import read_arm
from crenel.formats.recording.reader import open_recording
from crenel.formats.results.calibration import Calibration, SerialNumbers
from crenel.metrology.arm.kinematics import AnyArm
from crenel.metrology.fitting.plane_sphere import SphereFit, fit_sphere
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.transforms import Floats
from crenel.station.bus import Bus
from crenel.station.devices.rig import Rig
from crenel.station.scan.points import ScanCalibration
from crenel.station.scan.scanner import Scanner
from crenel.station.scan.state import ScanResult
from crenel.station.view3d.scene import Scene
from crenel.workflows.reconstruct import Reconstruction, reconstruct_cloud
from crenel.workflows.sensor_calibrations import SensorCalibrations
from crenel_hardware.registry import arm_driver
from crenel_hardware.simulator.station import (
    SECOND_SERIAL_NUMBER,
    SimulatedStation,
    SimulationConfig,
)
from tests.present import present
from tests.station.conftest import running, until

USUAL = SimulationConfig(imperfection_um=0.0, width_px=640, height_px=512, pace=1.5, frames_hz=20.0)
R = TypeVar("R")


def true_calibration(simulation: SimulatedStation, folder: Path) -> ScanCalibration:
    """What a perfect calibration of the simulation would find."""
    (folder / "arm.json").write_text(json.dumps(simulation.datasheets()["arm.json"]))
    arm = read_arm(folder / "arm.json")
    truth = json.loads(json.dumps(simulation.truth()))
    T, matrix, distortion = (
        np.array(truth["camera"][name]) for name in ("T_cam_sensor", "matrix", "distortion")
    )
    size_px = USUAL.width_px, USUAL.height_px
    camera = Camera(matrix, T[:3, :3], T[:3, 3], *size_px, distortion)
    document = truth["laser_plane"]
    return ScanCalibration(
        id="truth",
        name="truth",
        arm=arm,
        camera=camera,
        plane=LaserPlane(np.array(document["normal"]), document["offset_mm"]),
        T_flange_sensor=np.array(truth["T_flange_sensor"]),
        stripe_axis="u",
        arm_serial=arm.serial_number,
        sensor_serial="TWIN-S1",
        depth_range_mm=(60.0, 240.0),
    )


def true_calibrations(simulation: SimulatedStation, folder: Path) -> dict[str, ScanCalibration]:
    """Those of each sensor, by its name."""
    first = true_calibration(simulation, folder)
    if not simulation.config.second_sensor:
        return {"": first}
    T = np.array(simulation.truth()["T_flange_second_sensor"])
    second = replace(first, id="second", T_flange_sensor=T, sensor_serial=SECOND_SERIAL_NUMBER)
    return {"left": first, "right": second}


@dataclass
class Station:
    """A simulated station, connected, with perfect calibrations."""

    simulation: SimulatedStation
    rig: Rig
    scanner: Scanner
    calibrations: dict[str, ScanCalibration]
    """By the name of the sensor."""

    @property
    def calibration(self) -> ScanCalibration:
        """That of the only sensor."""
        return self.calibrations[""]

    def hold_over_block(self) -> None:
        assert self.simulation.operator.hold_over("block", 0)

    def scan(self, part: str) -> ScanResult:
        """Scans a part from its beginning to its end."""
        self.scanner.start(part)
        assert self.simulation.operator.scan_part(part)
        return end_scan(self.scanner)


@contextmanager
def running_station(simulation: SimulatedStation, bus: Bus, folder: Path) -> Iterator[Station]:
    """Ends with all faults."""
    options, sensors = {"url": simulation.arm_url}, {"": simulation.sensor}
    if simulation.config.second_sensor:
        sensors = {"left": simulation.sensor, "right": simulation.second_sensor}
    calibrations = true_calibrations(simulation, folder)
    rig = Rig(bus, lambda: arm_driver("serial-encoder", options), sensors, folder)
    rig.arm.set_model(next(iter(calibrations.values())).arm)
    with running(rig):
        until(lambda: rig.arm.fresh and all(one.fresh for one in rig.sensors.values()))
        with (
            closing(Scene(point_budget=100_000)) as scene,
            closing(Scanner(bus, rig, scene, folder / "scans")) as scanner,
        ):
            for name, calibration in calibrations.items():
                scanner.set_calibration(calibration, sensor=name)
            until(lambda: scanner.why_not() is None)
            yield Station(simulation, rig, scanner, calibrations)
        simulation.clear_faults()


@pytest.fixture
def station(simulation: SimulatedStation, bus: Bus, tmp_path: Path) -> Iterator[Station]:
    with running_station(simulation, bus, tmp_path) as connected:
        yield connected


def nominal_of(simulation: SimulatedStation, part: str) -> Any:
    """What the certificate of a part states."""
    return json.loads(json.dumps(simulation.datasheets()[f"{part}.nominal.json"]))


def check_sphere(
    simulation: SimulatedStation, cloud: Path, within_mm: float = 0.03
) -> tuple[SphereFit, Floats]:
    """The sphere has its radius, and its centre to twice as much: the fit, and its points (N,
    3)."""
    nominal = nominal_of(simulation, "sphere")
    points = read_cloud(cloud).points_mm
    near = np.linalg.norm(points - nominal["centre_mm"], axis=1) < nominal["radius_mm"] + 0.5
    fit = fit_sphere(points[near])
    assert fit.radius_mm == pytest.approx(nominal["radius_mm"], abs=within_mm)
    np.testing.assert_allclose(fit.centre_mm, nominal["centre_mm"], atol=2 * within_mm)
    return fit, points[near]


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
    """A scan's recording, rebuilt, gives the very points that were saved live, and readings of the
    arm at each of their frames."""
    again, live = folder / "again", folder / "cloud.ply"
    again.mkdir()
    shutil.copy(folder / "scan.mcap", again)
    rebuilt = reconstruct_cloud(again / "scan.mcap", calibration, arm, again / "cloud.ply")
    points = read_cloud(live)
    np.testing.assert_allclose(
        read_cloud(again / "cloud.ply").points_mm, points.points_mm, atol=1e-6
    )
    at_frames = []
    for one in (folder, again):
        readings = read_frame_readings(one / READINGS)
        rows = readings.rows_of(np.unique(present(points.frame)).astype(np.int64))
        assert rows.min() >= 0
        at_frames.append(np.column_stack([readings.sensor, readings.readings])[rows])
    np.testing.assert_allclose(at_frames[0], at_frames[1], atol=1e-9)
    return rebuilt
