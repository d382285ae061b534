"""Two sensors on one arm: one scan, one recording, one cloud."""

import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from app.errors import OperationError
from app.formats.clouds.files import read_cloud
from app.formats.recording.decoders import ImageRecord, StripeRecord
from app.formats.recording.reader import open_recording
from app.formats.results.calibration import Calibration, SerialNumbers
from app.formats.settings.mask import Mask
from app.formats.settings.scan_settings import ScanSettings
from app.metrology.fitting.plane_sphere import fit_sphere
from app.station.bus import Bus
from app.station.devices.rig import Rig
from app.station.scan.points import ScanCalibration
from app.station.scan.scanner import Scanner
from app.station.view3d.scene import Scene
from app.workflows.reconstruct import reconstruct_cloud
from hardware.registry import arm_driver
from hardware.simulator.station import SECOND_SERIAL_NUMBER, SimulatedStation
from tests.station.conftest import until
from tests.station.test_on_simulation import CONFIG, true_calibration

pytestmark = pytest.mark.device


@pytest.fixture(scope="module")
def simulation() -> Iterator[SimulatedStation]:
    with SimulatedStation(replace(CONFIG, second_sensor=True, frames_hz=12.0)) as simulation:
        yield simulation


@pytest.fixture
def rig(simulation: SimulatedStation, bus: Bus, tmp_path: Path) -> Iterator[Rig]:
    options = {"url": simulation.arm_url}
    sensors = {"left": simulation.sensor, "right": simulation.second_sensor}
    rig = Rig(bus, lambda: arm_driver("serial-encoder", options), sensors, tmp_path)
    rig.arm.set_model(true_calibration(simulation, tmp_path).arm)
    rig.start()
    until(lambda: rig.arm.fresh and all(one.fresh for one in rig.sensors.values()))
    yield rig
    rig.stop()
    simulation.clear_faults()


def calibrations(simulation: SimulatedStation, folder: Path) -> dict[str, ScanCalibration]:
    """What perfect calibrations of both would find."""
    left = true_calibration(simulation, folder)
    T = np.array(simulation.truth()["T_flange_second_sensor"])
    serial = SECOND_SERIAL_NUMBER
    right = replace(left, id="second", T_flange_sensor=T, sensor_serial=serial)
    return {"left": left, "right": right}


@pytest.fixture
def scanner(simulation: SimulatedStation, rig: Rig, bus: Bus, tmp_path: Path) -> Iterator[Scanner]:
    scene = Scene(point_budget=100_000)
    scanner = Scanner(bus, rig, scene, tmp_path / "scans")
    for name, calibration in calibrations(simulation, tmp_path).items():
        scanner.set_calibration(calibration, sensor=name)
    until(lambda: scanner.why_not() is None)
    yield scanner
    scanner.close()
    scene.close()


def file_calibration(use: ScanCalibration) -> Calibration:
    serials = SerialNumbers(arm=use.arm_serial, sensor=use.sensor_serial, object="B-1")
    return Calibration(use.camera, use.plane, use.T_flange_sensor, "u", serials)


def test_both_sensors_scan_the_sphere_where_it_is(
    simulation: SimulatedStation, scanner: Scanner, tmp_path: Path
) -> None:
    """And the recording, rebuilt with both calibrations, gives the very points of the scan."""
    nominal = json.loads(json.dumps(simulation.datasheets()["sphere.nominal.json"]))
    scan_id = scanner.start("both")
    assert simulation.operator.scan_part("sphere")
    result = scanner.stop()
    assert result is not None
    folder = tmp_path / "scans" / scan_id
    live = read_cloud(folder / "cloud.ply")
    assert len(live.points_mm) == result.points

    records = list(open_recording(folder / "scan.mcap").records())
    stripes = [one for one in records if isinstance(one, StripeRecord)]
    assert len(stripes) == result.frames
    assert {one.sensor for one in stripes} == {"left", "right"}
    assert not any(isinstance(one, ImageRecord) for one in records)

    known = {
        name: file_calibration(use) for name, use in calibrations(simulation, tmp_path).items()
    }
    arm = true_calibration(simulation, tmp_path).arm
    rebuilt = reconstruct_cloud(folder / "scan.mcap", known, arm, tmp_path / "again.ply")
    assert rebuilt.all_frames == result.frames
    again = read_cloud(tmp_path / "again.ply")
    np.testing.assert_allclose(again.points_mm, live.points_mm, atol=1e-6)

    counts = []
    for name, calibration in known.items():
        only = {name: calibration}
        reconstruct_cloud(folder / "scan.mcap", only, arm, tmp_path / f"{name}.ply")
        points = read_cloud(tmp_path / f"{name}.ply").points_mm
        counts.append(len(points))
        near = np.linalg.norm(points - nominal["centre_mm"], axis=1) < nominal["radius_mm"] + 0.5
        fit = fit_sphere(points[near])
        assert fit.radius_mm == pytest.approx(nominal["radius_mm"], abs=0.04)
        np.testing.assert_allclose(fit.centre_mm, nominal["centre_mm"], atol=0.08)
    assert sum(counts) == result.points
    assert min(counts) > 0.2 * max(counts)


def test_a_sensor_that_is_lost_names_itself_and_the_other_goes_on(
    simulation: SimulatedStation, rig: Rig, scanner: Scanner
) -> None:
    assert simulation.operator.hold_over("block", 0)
    scanner.start("one lost")
    assert all(sensor.laser_on for sensor in rig.sensors.values())
    simulation.second_camera_faults.lost = True
    until(lambda: any("right" in str(one.text) for one in scanner.state().findings))
    frames = scanner.state().frames
    until(lambda: scanner.state().frames > frames + 3)
    assert scanner.stop() is not None
    assert not any(sensor.laser_on for sensor in rig.sensors.values())
    error = scanner.why_not()
    assert error is not None
    assert error.code == "sensor-lost"
    assert str(error.what).startswith("right: ")


def test_a_scan_needs_the_calibration_of_each(
    simulation: SimulatedStation, scanner: Scanner
) -> None:
    scanner.set_calibration(None, sensor="right")
    with pytest.raises(OperationError, match="right") as caught:
        scanner.start("half")
    assert caught.value.code == "no-calibration"


def test_each_scans_with_its_own_stored_exposure(
    simulation: SimulatedStation, rig: Rig, scanner: Scanner
) -> None:
    assert simulation.operator.hold_over("block", 0)
    known = ScanSettings(exposure_us=300.0).with_exposure_us("left", 700.0)
    scanner.set_settings(known.with_exposure_us("right", 900.0))
    scanner.start("exposures")
    until(lambda: [one.exposure_us for one in rig.sensors.values()] == [700.0, 900.0])
    scanner.stop()


def test_zones_belong_to_the_sensor_in_whose_picture_they_were_drawn(
    simulation: SimulatedStation, scanner: Scanner, tmp_path: Path
) -> None:
    assert simulation.operator.hold_over("block", 0)
    corners = ((0.0, 0.0), (640.0, 0.0), (640.0, 512.0), (0.0, 512.0))
    everything = Mask(
        width_px=640, height_px=512, sensor_serial=SECOND_SERIAL_NUMBER, zones=(corners,)
    )
    scanner.set_settings(ScanSettings(mask=everything))
    scan_id = scanner.start("zones")
    until(lambda: scanner.state().points > 1000)
    scanner.stop()
    records = open_recording(tmp_path / "scans" / scan_id / "scan.mcap").records()
    points = {"left": 0, "right": 0}
    for one in records:
        if isinstance(one, StripeRecord):
            points[one.sensor] += len(one.stripe.u)
    assert points["left"] > 0
    assert points["right"] == 0


def test_a_verification_scans_with_the_selected_sensor_alone(
    simulation: SimulatedStation, rig: Rig, scanner: Scanner, tmp_path: Path
) -> None:
    """Recorded as the only one, so that its calibration alone rebuilds it."""
    assert simulation.operator.hold_over("block", 0)
    rig.select("right")
    folder = tmp_path / "verification" / "cloud-1"
    scanner.start("verification", into=folder)
    until(lambda: scanner.state().points > 1000)
    assert not rig.sensors["left"].laser_on
    assert scanner.stop() is not None
    use = calibrations(simulation, tmp_path)["right"]
    rebuilt = reconstruct_cloud(
        folder / "scan.mcap", file_calibration(use), use.arm, tmp_path / "again.ply"
    )
    live = read_cloud(folder / "cloud.ply").points_mm
    np.testing.assert_allclose(read_cloud(tmp_path / "again.ply").points_mm, live, atol=1e-6)
    assert rebuilt.points == len(live)


def test_the_selected_sensor_is_seen_switched_and_exposed(
    simulation: SimulatedStation, rig: Rig
) -> None:
    assert rig.selected == "left"
    rig.sensor.set_laser(True)
    rig.select("right")
    assert rig.sensor is rig.sensors["right"]
    assert not rig.sensors["left"].laser_on
    before_us = rig.sensors["left"].exposure_us
    rig.sensor.set_exposure_us(700.0)
    until(lambda: rig.sensors["right"].exposure_us == 700.0)
    assert rig.sensors["left"].exposure_us == before_us
    with pytest.raises(OperationError, match="named top"):
        rig.select("top")
