"""The whole simulated station: sensor driver, operator, datasheets, and that all agree."""

import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from typing import Any

import cv2
import numpy as np
import pytest

from crenel_hardware.arm.serial_encoder import from_options
from crenel_hardware.clock import now_ns
from crenel_hardware.interfaces import Button, Delivery, Frame, SensorDriver
from crenel_hardware.simulator.devices.kinematics import ArmLink, ArmModel, Floats, flange_pose
from crenel_hardware.simulator.rendering.line_sensor import find_line
from crenel_hardware.simulator.rendering.noise import Detector
from crenel_hardware.simulator.station import SimulatedStation, SimulationConfig
from tests.hardware.conformance import SensorBench, SensorConformance
from tests.hardware.reading import (
    LONG_S,
    button_edges,
    next_frame,
    opened,
    read_until,
    select_samples,
    wait_until,
)

pytestmark = pytest.mark.device

SMALL = SimulationConfig(width_px=640, height_px=512, pace=2.0, rate_hz=500.0)


class SimulatedSensorBench(SensorBench):
    def __init__(self, simulation: SimulatedStation) -> None:
        self._simulation = simulation

    def driver(self) -> SensorDriver:
        return self._simulation.sensor()

    def unplug(self) -> None:
        self._simulation.camera_faults.lost = True

    def plug_in(self) -> None:
        self._simulation.camera_faults.lost = False


@pytest.fixture(scope="module")
def station() -> Iterator[SimulatedStation]:
    with SimulatedStation(SMALL) as simulation:
        yield simulation


@pytest.fixture
def simulation(station: SimulatedStation) -> SimulatedStation:
    station.clear_faults()
    station.lighting.room, station.lighting.room_with_laser = 1.0, False
    return station


@pytest.fixture
def driver(simulation: SimulatedStation) -> Iterator[SensorDriver]:
    with opened(simulation.sensor()) as driver:
        yield driver


@pytest.fixture
def bench(simulation: SimulatedStation) -> SimulatedSensorBench:
    return SimulatedSensorBench(simulation)


class TestSimulatedSensor(SensorConformance):
    """The simulated sensor is a sensor."""


@pytest.mark.parametrize("delivers", [{"line"}, {"picture", "line"}], ids=["lines", "both"])
class TestSimulatedLineSensor(SensorConformance):
    """So it is when its camera finds the line."""

    @pytest.fixture
    def bench(self, delivers: set[Delivery]) -> Iterator[SimulatedSensorBench]:
        with SimulatedStation(replace(SMALL, delivers=frozenset(delivers))) as simulation:
            yield SimulatedSensorBench(simulation)


def test_the_line_that_the_camera_finds_is_where_the_light_is() -> None:
    """Against a line of light without noise, the scatter is as stated, and the mean is right."""
    sharp = Detector(read_dn=0.0, shot_dn=0.0, speckle_contrast=0.0)
    rows = 100.3 + 0.05 * np.arange(300)
    profile = np.exp(-(((np.arange(256)[:, None] - rows) / 1.8) ** 2) / 2)
    random = np.random.default_rng(6)
    for detector in (sharp, Detector()):
        light = detector.dark_dn + detector.stripe_dn * profile
        errors: list[Floats] = []
        sigmas: list[Floats] = []
        for _ in range(20):
            sd = np.sqrt(detector.read_dn**2 + detector.shot_dn * detector.stripe_dn * profile)
            image = np.clip(np.round(light + sd * random.normal(size=light.shape)), 0, 255)
            frame = Frame(1, 2, image.astype(np.uint8), 3.0, True)
            line = find_line(frame, replace(detector, speckle_contrast=0.0))
            np.testing.assert_array_equal(line.u, np.arange(300))
            errors.append(line.v - rows)
            sigmas.append(line.sigma_px)
        assert abs(np.mean(errors)) < 0.005
    assert np.std(errors) == pytest.approx(np.mean(sigmas), rel=0.3)


def model_of(datasheet: object) -> ArmModel:
    """The arm as its datasheet has it, to see what an operator's program would compute."""
    assert isinstance(datasheet, dict)
    links = []
    for j in datasheet["joints"]:
        alpha_rad, theta_rad = np.radians([j["alpha_deg"], j["theta_deg"]])
        links.append(ArmLink(j["a_mm"], alpha_rad, j["d_mm"], theta_rad, j["sign"]))
    tip = datasheet["tip"]
    return ArmModel(tuple(links), (tip["x_mm"], tip["y_mm"], tip["z_mm"]), tip["diameter_mm"])


def test_a_touch_is_a_contact_with_a_press(simulation: SimulatedStation) -> None:
    datasheets = simulation.datasheets()
    model = model_of(datasheets["arm.json"])
    block: dict[str, Any] = datasheets["object.json"]
    T_obj_arm = np.linalg.inv(np.array(simulation.truth()["T_arm_obj"]))
    driver = from_options({"url": simulation.arm_url, "timeout_s": 5.0})
    driver.open()
    heights = []
    for index in range(3):
        with ThreadPoolExecutor() as pool:
            touched = pool.submit(simulation.operator.touch, "crest", index)
            records = read_until(driver, lambda got: len(button_edges(got)) == 2)
            assert touched.result(LONG_S)
        assert button_edges(records) == [(Button.PRIMARY, True), (Button.PRIMARY, False)]
        at = next(r.stamp_ns for r in records if not hasattr(r, "joints_rad"))
        near = [s.joints_rad for s in select_samples(records) if 0 <= at - s.stamp_ns < 80_000_000]
        q = np.mean(near, axis=0)
        assert np.ptp(np.array(near), axis=0).max() < 2e-4  # held still
        T = flange_pose(model, q)
        tip = T_obj_arm @ T @ [*model.tip_mm, 1.0]
        heights.append(float(tip[2]) - model.tip_diameter_mm / 2)
        assert block["edges_x_mm"][0] < tip[0] < block["edges_x_mm"][-1]
    driver.close()
    assert np.array(heights) == pytest.approx(np.full(3, block["crest_z_mm"]), abs=0.3)
    assert np.ptp(heights) < 0.1


@pytest.mark.parametrize("face", ["floor", "front", "back", "left", "right"])
def test_the_simulated_operator_reaches_every_face(simulation: SimulatedStation, face: str) -> None:
    assert face in simulation.operator.faces
    assert simulation.operator.touch(face, 0)
    assert not simulation.operator.state.busy


def test_an_unknown_face_or_part_is_refused(simulation: SimulatedStation) -> None:
    with pytest.raises(KeyError, match=r"can touch crest.* board"):
        simulation.operator.touch("roof", 0)
    with pytest.raises(KeyError, match="plate"):
        simulation.operator.scan_part("teapot")
    for name in ("shell", "teapot"):  # held over block and board only
        with pytest.raises(KeyError, match=name):
            simulation.operator.hold_over(name)


def test_a_sensor_is_held_over_a_block(simulation: SimulatedStation, driver: SensorDriver) -> None:
    assert simulation.operator.hold_over("block")
    ambient = [next_frame(driver) for _ in range(3)][-1].image
    driver.set_laser(True)
    laser = next_frame(driver)
    assert laser.laser_on
    bright = ambient > 90
    assert 0.15 < bright.mean() < 0.8
    border = np.concatenate([bright[0], bright[-1], bright[:, 0], bright[:, -1]])
    assert not border.any()
    columns = (laser.image.max(axis=0) > 80).mean()
    assert columns > 0.5
    assert np.median(laser.image) < 10


def test_exposure_and_lamps_make_light(simulation: SimulatedStation, driver: SensorDriver) -> None:
    assert simulation.operator.hold_over("block")

    def level() -> float:
        [next_frame(driver) for _ in range(2)]
        return float(np.percentile(next_frame(driver).image, 90)) - Detector().dark_dn

    nominal = level()
    driver.set_exposure_us(Detector().nominal_exposure_us / 2)
    assert level() == pytest.approx(nominal / 2, rel=0.1)
    simulation.lighting.room = 0.0
    assert level() < 5
    simulation.lighting.room, simulation.lighting.room_with_laser = 1.0, True
    driver.set_laser(True)
    both = [next_frame(driver) for _ in range(3)][-1].image
    assert np.percentile(both, 90) > 50
    assert both.max() > 100


def test_a_frame_shows_its_own_moment(simulation: SimulatedStation, driver: SensorDriver) -> None:
    """The laser's line on the plate, from frame and true pose, lies in the plate's plane."""
    driver.set_laser(True)
    places = points_on_plate(simulation, driver, lambda: simulation.operator.scan_part("plate"), 8)
    assert np.ptp(places[:, 1]) > 3
    assert np.abs(places[:, 2]).max() < 0.02


def points_on_plate(
    simulation: SimulatedStation, driver: SensorDriver, sweep: Callable[[], object], count: int
) -> Floats:
    """(N, 3) where lines on the plate are in its frame in mm, N >= ``count``, after sweeps."""
    plate = simulation._scene.find_object("plate").T_arm_obj
    on_plate: list[Floats] = []
    deadline = time.monotonic() + 6 * LONG_S
    while len(on_plate) < count:
        assert time.monotonic() < deadline, f"{len(on_plate)} frames of the plate"
        with ThreadPoolExecutor() as pool:
            sweeping = pool.submit(sweep)
            while not sweeping.done():
                points = stripe_in_arm_frame(simulation, next_frame(driver))
                points = (points - plate[:3, 3]) @ plate[:3, :3]
                if len(points) and np.all(np.abs(points[:, :2]) < [29.0, 19.0]):
                    on_plate.append(np.median(points, axis=0))
    return np.array(on_plate)


def stripe_in_arm_frame(simulation: SimulatedStation, frame: Frame) -> Floats:
    """(N, 3) where the bright part of a frame's stripe truly was; N may be 0."""
    T_arm_sensor = simulation.sensor_pose(frame.mid_exposure_ns)
    light = frame.image.astype(np.float64) - Detector().dark_dn
    columns = np.flatnonzero(light.max(axis=0) > 90)[::11]
    if len(columns) == 0:
        return np.zeros((0, 3))
    rows = np.clip(light.argmax(axis=0)[columns], 4, len(light) - 5)
    window = np.stack([light[rows + k, columns] for k in range(-4, 5)])
    centre = rows + (np.arange(-4, 5)[:, None] * window).sum(axis=0) / window.sum(axis=0)
    truth = simulation.truth()
    camera = truth["camera"]
    assert isinstance(camera, dict)
    points = lit_points(camera, truth["laser_plane"], np.column_stack([columns, centre]))
    return np.asarray(points @ T_arm_sensor[:3, :3].T + T_arm_sensor[:3, 3])


def lit_points(camera: dict[str, Any], light_plane: object, uv: Floats) -> Floats:
    """Where the light at pixels came from, in the sensor frame, by OpenCV and a plane."""
    T = np.array(camera["T_cam_sensor"])
    pixels = uv.reshape(-1, 1, 2)
    xy = cv2.undistortPoints(pixels, np.array(camera["matrix"]), np.array(camera["distortion"]))
    rays = np.column_stack([xy.reshape(-1, 2), np.ones(len(uv))]) @ T[:3, :3]
    eye = -T[:3, :3].T @ T[:3, 3]
    assert isinstance(light_plane, dict)
    n = np.array(light_plane["normal"])
    return np.asarray(eye + rays * ((light_plane["offset_mm"] - n @ eye) / (rays @ n))[:, None])


def test_a_cancelled_move_ends_soon_and_the_next_one_works(simulation: SimulatedStation) -> None:
    with ThreadPoolExecutor() as pool:
        move = pool.submit(simulation.operator.scan_part, "shell")
        wait_until(lambda: simulation.operator.state.progress >= 0.1)
        assert simulation.operator.state.activity == "scanning the shell"
        simulation.operator.cancel()
        assert not move.result(LONG_S)
    rest = simulation.sensor_pose(now_ns())
    time.sleep(0.05)
    assert np.array_equal(simulation.sensor_pose(now_ns()), rest)
    assert simulation.operator.touch("crest", 1)


def test_lost_frames_leave_a_known_gap(simulation: SimulatedStation, driver: SensorDriver) -> None:
    simulation.camera_faults.drop_rate = 0.5
    sequence = [next_frame(driver).sequence for _ in range(12)]
    assert driver.health.lost == sequence[-1] - len(sequence) + 1 > 0


def test_datasheets_are_whole_and_do_not_know_the_truth(simulation: SimulatedStation) -> None:
    datasheets = simulation.datasheets()
    parts = ("plate.nominal", "sphere.nominal", "surface-plate.nominal")
    others = ("arm", "object", "chessboard", "sensor", "ball-bar", "step-gauge", "example-plate")
    assert set(datasheets) == {f"{name}.json" for name in (*parts, *others)}
    assert all(datasheet["version"] == 1 for datasheet in datasheets.values())
    true_block = simulation.truth()["block"]
    assert isinstance(true_block, dict)
    certificate = datasheets["object.json"]
    off = np.array(true_block["edges_x_mm"]) - np.array(certificate["edges_x_mm"])
    assert 0 < np.abs(off).max() < 0.012
    assert "error" not in str(datasheets["arm.json"])
    model, q = model_of(datasheets["arm.json"]), simulation._home
    gap = flange_pose(model, q)[:3, 3] - flange_pose(simulation._rig.arm, q)[:3, 3]
    assert 0.005 < np.linalg.norm(gap) < 1.0


def test_a_stopped_station_frees_its_port() -> None:
    first = SimulatedStation(SMALL).start()
    port = int(first.arm_url.rsplit(":", 1)[1])
    first.stop()
    first.stop()
    with SimulatedStation(replace(SMALL, port=port)) as second:
        assert second.arm_url.endswith(str(port))
        with pytest.raises(OSError, match="in use"):
            SimulatedStation(replace(SMALL, port=port)).start()
