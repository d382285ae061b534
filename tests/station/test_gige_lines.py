"""A scan whose lines a camera finds itself and sends over GigE Vision, read through Aravis."""

import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from app.formats.clouds.files import read_cloud
from app.formats.recording.decoders import ImageRecord, StripeRecord
from app.formats.recording.reader import open_recording
from app.formats.results.calibration import Calibration, SerialNumbers
from app.metrology.transforms import Floats
from app.station.bus import Bus
from app.station.devices.rig import Rig
from app.station.scan.scanner import Scanner
from app.station.view3d.scene import Scene
from app.workflows.reconstruct import reconstruct_points
from hardware.interfaces import Delivery, Frame
from hardware.simulator.station import SimulatedStation
from tests.hardware.fake_cameras import ADDRESS
from tests.hardware.test_genicam import require_aravis
from tests.station.conftest import until
from tests.station.test_lines import start_rig
from tests.station.test_on_simulation import CONFIG, true_calibration

pytestmark = [pytest.mark.device, pytest.mark.xdist_group("gige")]

BOTH: frozenset[Delivery] = frozenset({"picture", "line"})
LOST_PACKETS = 0.01


@pytest.fixture(scope="module")
def simulation() -> Iterator[SimulatedStation]:
    require_aravis()
    config = replace(CONFIG, delivers=BOTH, camera="gige", camera_address=ADDRESS)
    with SimulatedStation(config) as simulation:
        simulation.gige_camera.faults.packet_drop_rate = LOST_PACKETS
        yield simulation


@pytest.fixture
def rig(simulation: SimulatedStation, bus: Bus, tmp_path: Path) -> Iterator[Rig]:
    rig = start_rig(simulation, bus, tmp_path)
    yield rig
    rig.stop()


def plate_residuals_um(simulation: SimulatedStation, points_mm: Floats) -> Floats:
    """(N,) of points (N, 3): from the plane of the plate's certificate."""
    nominal = json.loads(json.dumps(simulation.datasheets()["plate.nominal.json"]))
    away_mm = points_mm - np.array(nominal["point_mm"])
    return np.asarray(1e3 * away_mm @ np.array(nominal["normal"]))


def test_a_scan_of_lines_lies_on_the_plate_within_its_uncertainty(
    simulation: SimulatedStation, rig: Rig, bus: Bus, tmp_path: Path
) -> None:
    assert rig.sensor.info is not None
    assert rig.sensor.info.delivers == BOTH
    use = true_calibration(simulation, tmp_path)
    scene = Scene(point_budget=100_000)
    scanner = Scanner(bus, rig, scene, tmp_path / "scans")
    try:
        scanner.set_calibration(use)
        until(lambda: scanner.why_not() is None)
        scanner.start("plate")
        assert simulation.operator.scan_part("plate")
        result = scanner.stop()
    finally:
        scanner.close()
        scene.close()
    assert result is not None
    records = list(open_recording(result.folder / "scan.mcap").records())
    stripes = [one for one in records if isinstance(one, StripeRecord)]
    assert len(stripes) == result.frames > 20
    assert not any(isinstance(one, ImageRecord) for one in records)

    cloud = read_cloud(result.folder / "cloud.ply")
    assert cloud.uncertainty_um is not None
    off_um = plate_residuals_um(simulation, cloud.points_mm)
    near = np.abs(off_um) < 200
    assert near.sum() > 1000
    stated_um = cloud.uncertainty_um[near]
    assert abs(np.median(off_um[near])) < np.median(stated_um)
    # of normal deviates 0.67; the arm's own noise comes on top
    assert np.median(np.abs(off_um[near]) / stated_um) < 1

    serials = SerialNumbers(arm=use.arm_serial, sensor=use.sensor_serial, object="B-1")
    again, _ = reconstruct_points(
        result.folder / "scan.mcap",
        Calibration(use.camera, use.plane, use.T_flange_sensor, "u", serials),
        use.arm,
    )
    np.testing.assert_allclose(again, cloud.points_mm, atol=1e-6)
    until(lambda: isinstance(rig.sensor.frames.newest, Frame))
    assert simulation.gige_camera.packets_lost > 0
