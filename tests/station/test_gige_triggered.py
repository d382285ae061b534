"""Cameras over GigE Vision, read through Aravis: triggered by the arm, and sending lines."""

import threading
from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from crenel.formats.clouds.files import read_cloud
from crenel.formats.recording.decoders import ImageRecord, StripeRecord
from crenel.station.bus import Bus
from crenel.station.devices.rig import Rig
from crenel.station.pulses.pulse_trigger import TriggerSettings
from crenel.workflows.reconstruct import reconstruct_points
from crenel_hardware.interfaces import Frame, Line, SensorDriver, SensorReading
from crenel_hardware.simulator.station import SimulatedStation
from tests.hardware.fake_cameras import ADDRESS
from tests.hardware.test_genicam import require_aravis
from tests.station.conftest import collect_readings, running, until, until_paired
from tests.station.simulated import USUAL, Station, file_calibration, nominal_of, recorded, station
from tests.station.test_lines import BOTH
from tests.station.test_triggered import half_ns, noting_arm

pytestmark = [pytest.mark.device, pytest.mark.xdist_group("gige")]

RATE_HZ = 20.0
__all__ = ["station"]  # a fixture
LOST_PACKETS = 0.01


def test_each_change_is_paired(bus: Bus, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The camera misses pulses while it is stopped for the change, and does not count them."""
    require_aravis()
    pulses: dict[int, int] = {}
    camera_times_ns: dict[int, int] = {}
    """By the camera's own clock, which is good to a few ms: by sequence."""

    def make_sensor() -> SensorDriver:
        driver = simulated.sensor()
        read = driver.read

        def read_and_note(timeout_s: float) -> SensorReading | None:
            reading = read(timeout_s)
            if reading is not None:
                camera_times_ns[reading.sequence] = reading.mid_exposure_ns
            return reading

        monkeypatch.setattr(driver, "read", read_and_note)
        return driver

    config = replace(
        USUAL, delivers=BOTH, camera="gige", camera_address=ADDRESS, triggered=True, rate_hz=200.0
    )
    with SimulatedStation(config) as simulated:
        arm = partial(noting_arm, simulated.arm_url, pulses)
        rig = Rig(bus, arm, make_sensor, tmp_path, TriggerSettings(RATE_HZ))
        with running(rig):
            until_paired(rig.sensor)
            for lines, kind in ((True, Line), (False, Frame)):
                rig.sensor.want_lines(lines)
                until(lambda kind=kind: isinstance(rig.sensor.frames.newest, kind))  # type: ignore[misc]
                mover = threading.Thread(target=simulated.operator.hold_over, args=("board", 1))
                mover.start()
                readings = collect_readings(rig, 40)
                simulated.operator.cancel()
                mover.join()
                assert all(isinstance(one, kind) for one in readings)
                stamps = np.array([one.mid_exposure_ns for one in readings])
                begins = {one.mid_exposure_ns - half_ns(one): one.pulse or 0 for one in readings}
                offsets = [begins[at] - number for at, number in pulses.items() if at in begins]
                assert len(offsets) == len(readings)
                assert len(set(offsets)) == 1, "the counts of arm and camera go together"
                late_ns = stamps - np.array([camera_times_ns[one.sequence] for one in readings])
                assert abs(np.median(late_ns)) < 0.5e9 / RATE_HZ, "and by the right offset"


@pytest.fixture(scope="module")
def simulation() -> Iterator[SimulatedStation]:
    require_aravis()
    config = replace(USUAL, delivers=BOTH, camera="gige", camera_address=ADDRESS)
    with SimulatedStation(config) as simulation:
        simulation.gige_camera.faults.packet_drop_rate = LOST_PACKETS
        yield simulation


def test_a_scan_of_lines_lies_on_the_plate_within_its_uncertainty(station: Station) -> None:
    assert station.rig.sensor.info is not None
    assert station.rig.sensor.info.delivers == BOTH
    result = station.scan("plate")
    assert len(recorded(result.folder, StripeRecord)) == result.frames > 5
    assert not recorded(result.folder, ImageRecord)

    cloud = read_cloud(result.folder / "cloud.ply")
    assert cloud.uncertainty_um is not None
    nominal = nominal_of(station.simulation, "plate")
    off_um = 1e3 * (cloud.points_mm - nominal["point_mm"]) @ nominal["normal"]
    near = np.abs(off_um) < 200
    assert near.sum() > 1000
    stated_um = cloud.uncertainty_um[near]
    assert abs(np.median(off_um[near])) < np.median(stated_um)
    # of normal deviates 0.67; the arm's own noise comes on top
    assert np.median(np.abs(off_um[near]) / stated_um) < 1

    use = station.calibration
    again, _ = reconstruct_points(result.folder / "scan.mcap", file_calibration(use), use.arm)
    np.testing.assert_allclose(again, cloud.points_mm, atol=1e-6)
    until(lambda: isinstance(station.rig.sensor.frames.newest, Frame))
    assert station.simulation.gige_camera.packets_lost > 0
