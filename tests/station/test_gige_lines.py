"""A scan whose lines a camera finds itself and sends over GigE Vision, read through Aravis."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest

from app.formats.clouds.files import read_cloud
from app.formats.recording.decoders import ImageRecord, StripeRecord
from app.workflows.reconstruct import reconstruct_points
from hardware.interfaces import Frame
from hardware.simulator.station import SimulatedStation
from tests.hardware.fake_cameras import ADDRESS
from tests.hardware.test_genicam import require_aravis
from tests.station.conftest import until
from tests.station.recorded_scans import file_calibration, recorded
from tests.station.simulated import USUAL, Station, nominal_of, station
from tests.station.test_lines import BOTH

pytestmark = [pytest.mark.device, pytest.mark.xdist_group("gige")]
__all__ = ["station"]  # a fixture
LOST_PACKETS = 0.01


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
    assert len(recorded(result.folder, StripeRecord)) == result.frames > 20
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
