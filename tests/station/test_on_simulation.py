"""The devices on the simulated station: real serial driver, rendered pictures, faults."""

import asyncio
import json
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from app.errors import OperationError
from app.formats.clouds.files import read_cloud
from app.formats.datasheets.arm import read_arm
from app.metrology.fitting.plane_sphere import fit_sphere
from app.metrology.sensor.camera import Camera
from app.metrology.sensor.laser_plane import LaserPlane
from app.metrology.stripe import extract_stripe
from app.station.bus import Bus
from app.station.devices.rig import Rig
from app.station.scan.points import ScanCalibration
from app.station.scan.scanner import Scanner
from app.station.view3d.scene import Scene
from hardware.interfaces import Button, ButtonEvent
from hardware.registry import arm_driver
from hardware.simulator.station import SimulatedStation, SimulationConfig
from tests.station.conftest import until

pytestmark = pytest.mark.device

CONFIG = SimulationConfig(
    imperfection_um=0.0, width_px=640, height_px=512, pace=1.5, frames_hz=20.0
)


def true_calibration(simulation: SimulatedStation, folder: Path) -> ScanCalibration:
    """What a perfect calibration of the simulation would find."""
    (folder / "arm.json").write_text(json.dumps(simulation.datasheets()["arm.json"]))
    arm = read_arm(folder / "arm.json")
    truth = json.loads(json.dumps(simulation.truth()))
    T_cam_sensor = np.array(truth["camera"]["T_cam_sensor"])
    camera = Camera(
        np.array(truth["camera"]["matrix"]),
        T_cam_sensor[:3, :3],
        T_cam_sensor[:3, 3],
        CONFIG.width_px,
        CONFIG.height_px,
        np.array(truth["camera"]["distortion"]),
    )
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


@pytest.fixture(scope="module")
def simulation() -> Iterator[SimulatedStation]:
    with SimulatedStation(CONFIG) as simulation:
        yield simulation


@pytest.fixture
def rig(simulation: SimulatedStation, bus: Bus, tmp_path: Path) -> Iterator[Rig]:
    options = {"url": simulation.arm_url}
    rig = Rig(bus, lambda: arm_driver("serial-encoder", options), simulation.sensor, tmp_path)
    rig.arm.set_model(true_calibration(simulation, tmp_path).arm)
    rig.start()
    until(lambda: rig.arm.fresh and rig.sensor.fresh)
    yield rig
    rig.stop()
    simulation.clear_faults()


def test_the_sphere_is_scanned_to_its_size(
    simulation: SimulatedStation, rig: Rig, bus: Bus, tmp_path: Path
) -> None:
    scene = Scene(point_budget=100_000)
    scanner = Scanner(bus, rig, scene, tmp_path / "scans")
    scanner.set_calibration(true_calibration(simulation, tmp_path))
    until(lambda: scanner.why_not() is None)
    scanner.start("sphere")
    assert simulation.operator.scan_part("sphere")
    result = scanner.stop()
    scanner.close()
    scene.close()
    assert result is not None
    assert scanner.state().frames_without_joints <= 0.05 * result.frames
    nominal = json.loads(json.dumps(simulation.datasheets()["sphere.nominal.json"]))
    points = read_cloud(result.folder / "cloud.ply").points_mm
    near = np.linalg.norm(points - nominal["centre_mm"], axis=1) < nominal["radius_mm"] + 0.5
    fit = fit_sphere(points[near])
    assert fit.radius_mm == pytest.approx(nominal["radius_mm"], abs=0.03)
    np.testing.assert_allclose(fit.centre_mm, nominal["centre_mm"], atol=0.06)


def test_a_touch_of_the_simulated_operator_is_received_and_averaged(
    simulation: SimulatedStation, rig: Rig, bus: Bus
) -> None:
    async def scenario() -> ButtonEvent:
        loop = asyncio.get_running_loop()
        bus.attach(loop)
        pressed: asyncio.Future[ButtonEvent] = loop.create_future()

        def note(event: ButtonEvent) -> None:
            if event.pressed:
                pressed.set_result(event)

        rig.arm.on_button = note
        assert await asyncio.to_thread(simulation.operator.touch, "crest", 0)
        return await asyncio.wait_for(pressed, 240)

    press = asyncio.run(scenario())
    assert press.button is Button.PRIMARY
    mean = rig.arm.average(0.15, until_ns=press.stamp_ns)
    assert mean.samples > 100
    assert mean.scatter.max() < 1e-4


def test_a_pair_is_captured_over_the_block_and_refused_on_the_way(
    simulation: SimulatedStation, rig: Rig
) -> None:
    assert simulation.operator.hold_over("block")
    until(lambda: rig.arm.stillness().still)
    taken = rig.capture_pair()
    assert taken.laser is not None
    assert taken.ambient.image.shape == (CONFIG.height_px, CONFIG.width_px)
    assert len(extract_stripe(taken.laser.image).u) > CONFIG.width_px / 2
    assert taken.laser.image.mean() < taken.ambient.image.mean() / 2


def test_garbage_and_lost_packets_are_counted_and_harmless(
    simulation: SimulatedStation, rig: Rig
) -> None:
    faults = simulation.arm_faults
    faults.corrupt_rate = faults.garbage_rate = faults.drop_rate = 0.02
    until(lambda: rig.arm.link().lost > 20 and rig.arm.link().corrupt > 20)
    assert rig.arm.link().state == "connected"
    until(lambda: rig.arm.stillness().still)
    assert rig.arm.average().samples > 100


def test_an_unplugged_arm_and_a_lost_camera_come_back(
    simulation: SimulatedStation, rig: Rig
) -> None:
    simulation.arm_faults.unplugged = simulation.camera_faults.lost = True
    until(lambda: rig.arm.link().state == rig.sensor.link().state == "lost")
    with pytest.raises(OperationError):
        rig.capture_pair()
    simulation.arm_faults.unplugged = simulation.camera_faults.lost = False
    until(lambda: rig.arm.link().state == rig.sensor.link().state == "connected")
    assert rig.arm.info is not None


def test_an_arm_that_stalls_is_lost_and_found(simulation: SimulatedStation, rig: Rig) -> None:
    simulation.arm_faults.stalled = True
    until(lambda: rig.arm.link().state == "lost")
    simulation.arm_faults.stalled = False
    until(lambda: rig.arm.link().state == "connected")
