"""Two sensors on one arm: one scan, one recording, one cloud."""

from dataclasses import replace
from pathlib import Path

import pytest

from crenel.errors import OperationError
from crenel.formats.clouds.files import read_cloud
from crenel.formats.recording.decoders import ImageRecord, StripeRecord
from crenel.formats.settings.mask import Mask
from crenel.formats.settings.scan_settings import ScanSettings
from crenel.station.devices.sensor_device import LaserBelief
from crenel.workflows.reconstruct import reconstruct_cloud
from crenel_hardware.simulator.station import SECOND_SERIAL_NUMBER
from tests.station.conftest import until
from tests.station.simulated import (
    USUAL,
    Station,
    check_rebuilt,
    check_sphere,
    end_scan,
    file_calibration,
    recorded,
    station,
)

pytestmark = pytest.mark.device
__all__ = ["station"]  # a fixture
CONFIG = replace(USUAL, second_sensor=True, frames_hz=12.0)


def test_both_sensors_scan_the_sphere_where_it_is(station: Station, tmp_path: Path) -> None:
    """And the recording, rebuilt with both calibrations, gives the very points of the scan."""
    result = station.scan("sphere")
    folder = result.folder
    assert len(read_cloud(folder / "cloud.ply").points_mm) == result.points
    stripes = recorded(folder, StripeRecord)
    assert len(stripes) == result.frames
    assert {one.sensor for one in stripes} == {"left", "right"}
    assert not recorded(folder, ImageRecord)

    known = {name: file_calibration(use) for name, use in station.calibrations.items()}
    arm = station.calibrations["left"].arm
    assert check_rebuilt(folder, known, arm).all_frames == result.frames

    counts = []
    for name, calibration in known.items():
        only = {name: calibration}
        reconstruct_cloud(folder / "scan.mcap", only, arm, tmp_path / f"{name}.ply")
        counts.append(len(read_cloud(tmp_path / f"{name}.ply").points_mm))
        check_sphere(station.simulation, tmp_path / f"{name}.ply", within_mm=0.04)
    assert sum(counts) == result.points
    assert min(counts) > 0.2 * max(counts)


def test_a_sensor_that_is_lost_names_itself_and_the_other_goes_on(station: Station) -> None:
    station.hold_over_block()
    station.scanner.start("one lost")
    assert station.rig.laser == LaserBelief("on", "switch")
    station.simulation.second_camera_faults.lost = True
    until(lambda: any("right" in str(one.text) for one in station.scanner.state().findings))
    frames = station.scanner.state().frames
    until(lambda: station.scanner.state().frames > frames + 3)
    assert station.scanner.stop() is not None
    assert station.rig.sensors["left"].laser == LaserBelief("off", "switch")
    assert station.rig.laser == LaserBelief("unknown", "lost")
    error = station.scanner.why_not()
    assert error is not None
    assert error.code == "sensor-lost"
    assert str(error.what).startswith("right: ")


def test_a_scan_needs_the_calibration_of_each(station: Station) -> None:
    station.scanner.set_calibration(None, sensor="right")
    with pytest.raises(OperationError, match="right") as caught:
        station.scanner.start("half")
    assert caught.value.code == "no-calibration"


def test_each_scans_with_its_own_stored_exposure(station: Station) -> None:
    station.hold_over_block()
    known = ScanSettings(exposure_us=300.0).with_exposure_us("left", 700.0)
    station.scanner.set_settings(known.with_exposure_us("right", 900.0))
    station.scanner.start("exposures")
    until(lambda: [one.exposure_us for one in station.rig.sensors.values()] == [700.0, 900.0])
    station.scanner.stop()


def test_zones_belong_to_the_sensor_in_whose_picture_they_were_drawn(station: Station) -> None:
    station.hold_over_block()
    corners = ((0.0, 0.0), (640.0, 0.0), (640.0, 512.0), (0.0, 512.0))
    everything = Mask(
        width_px=640, height_px=512, sensor_serial=SECOND_SERIAL_NUMBER, zones=(corners,)
    )
    station.scanner.set_settings(ScanSettings(mask=everything))
    station.scanner.start("zones")
    until(lambda: station.scanner.state().points > 1000)
    points = {"left": 0, "right": 0}
    for one in recorded(end_scan(station.scanner).folder, StripeRecord):
        points[one.sensor] += len(one.stripe.u)
    assert points["left"] > 0
    assert points["right"] == 0


def test_a_verification_scans_with_one_sensor_alone(station: Station, tmp_path: Path) -> None:
    """Recorded as the only one, so that its calibration alone rebuilds it."""
    station.hold_over_block()
    station.rig.select("right")
    folder = tmp_path / "verification" / "cloud-1"
    station.scanner.start("verification", into=folder)
    until(lambda: station.scanner.state().points > 1000)
    assert station.rig.sensors["left"].laser.state == "off"
    assert station.scanner.stop() is not None
    use = station.calibrations["right"]
    rebuilt = check_rebuilt(folder, file_calibration(use), use.arm)
    assert rebuilt.points == len(read_cloud(folder / "cloud.ply").points_mm)


def test_the_selected_sensor_is_seen_switched_and_exposed(station: Station) -> None:
    assert station.rig.selected == "left"
    station.rig.sensor.set_laser(True)
    station.rig.select("right")
    assert station.rig.sensor is station.rig.sensors["right"]
    assert station.rig.sensors["left"].laser.state == "off"
    before_us = station.rig.sensors["left"].exposure_us
    station.rig.sensor.set_exposure_us(700.0)
    until(lambda: station.rig.sensors["right"].exposure_us == 700.0)
    assert station.rig.sensors["left"].exposure_us == before_us
    with pytest.raises(OperationError, match="named top"):
        station.rig.select("top")
