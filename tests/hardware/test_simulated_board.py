"""The chessboard on the simulated table: its picture, the laser's line on it, and the operator."""

from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np
import pytest

from crenel_hardware.arm.serial_encoder import from_options
from crenel_hardware.clock import now_ns
from crenel_hardware.simulator.devices.kinematics import (
    Floats,
    rotation_about,
    tip_centre,
    translation,
)
from crenel_hardware.simulator.operator.holding import VIEWPOINTS
from crenel_hardware.simulator.rendering.noise import Detector
from crenel_hardware.simulator.rendering.render import Renderer
from crenel_hardware.simulator.scene.camera import LightPlane, Optics, sight_lines, to_pixels
from crenel_hardware.simulator.scene.random_scenes import draw_sensor
from crenel_hardware.simulator.scene.world import (
    Board,
    CrenellatedBlock,
    Light,
    SceneObject,
    SimulatedScene,
)
from crenel_hardware.simulator.station import SimulatedStation
from tests.hardware.reading import LONG_S, button_edges, opened, read_until
from tests.hardware.test_simulated_station import SMALL

pytestmark = pytest.mark.device

PLAIN = Detector(blur_px=0.0, speckle_contrast=0.0)
OVERHEAD = Light(direction=(0.0, 0.0, 1.0), directed=1.0, ambient=0.0, texture=0.0)
FINE = 24
"""Rays a side of a pixel that a picture is checked with."""


@pytest.fixture(scope="module")
def simulation() -> Iterator[SimulatedStation]:
    with SimulatedStation(SMALL) as simulation:
        yield simulation


def board_of(simulation: SimulatedStation) -> tuple[Board, Floats]:
    """The board as it truly is, and where."""
    thing = simulation._scene.find_object("board")
    assert isinstance(thing.shape, Board)
    return thing.shape, thing.T_arm_obj


def rendered(board: Board, T_board_sensor: Floats) -> tuple[Renderer, Optics]:
    """A small sensor without noise and blur over a board under even light from afar."""
    optics, _ = draw_sensor(CrenellatedBlock(), width_px=160, height_px=128)
    document = LightPlane((0.0, 1.0, 0.0), 0.0, (0.0, 0.0, 128.0), sigma_mm=0.4)
    T = np.asarray(np.linalg.inv(T_board_sensor))
    scene = SimulatedScene((SceneObject("board", board, T),), OVERHEAD)
    return Renderer(scene, optics, document, PLAIN), optics


def black(board: Board, x: Floats, y: Floats) -> np.ndarray:
    """Where on the board's plane there is ink, square by square."""
    found = np.zeros(x.shape, dtype=bool)
    columns, rows = board.inner_corners
    for i in range(-1, columns):
        for j in range(-1, rows):
            if (i + j) % 2 == 0:
                low_x, low_y = i * board.square_x_mm, j * board.square_y_mm
                inside = (x >= low_x) & (x < low_x + board.square_x_mm)
                found |= inside & (y >= low_y) & (y < low_y + board.square_y_mm)
    return found


def test_every_pixel_shows_its_share_of_black_and_white() -> None:
    """Against many even rays a pixel, at a pose at which squares lie aslant."""
    board = Board(inner_corners=(4, 3), square_x_mm=5.1, square_y_mm=4.3)
    middle = translation(*board.middle_mm.tolist())
    T = middle @ rotation_about("z", 0.3) @ rotation_about("x", 0.2)
    renderer, optics = rendered(board, T)
    seen = renderer.room_light(np.eye(4))
    lines = sight_lines(replace(optics, distortion=(0.0,) * 5)).astype(np.float64)
    steps = (np.arange(FINE) + 0.5) / FINE - 0.5
    pitch = np.array([1 / optics.fx_px, 1 / optics.fy_px])
    T_board_cam = T @ np.linalg.inv(optics.T_cam_sensor)
    share = np.zeros(seen.shape)
    for a in steps:
        for b in steps:
            xy = lines[1:-1, 1:-1] + pitch * [a, b]
            way = np.concatenate([xy, np.ones((*seen.shape, 1))], axis=2) @ T_board_cam[:3, :3].T
            at = T_board_cam[:3, 3] - way * (T_board_cam[2, 3] / way[..., 2])[..., None]
            share += black(board, at[..., 0], at[..., 1]) / FINE**2
    facing = T[2, 2]
    expected = facing * (1 - (1 - board.ink) * share)
    edge = board.half_pattern_mm + board.rim_mm - 0.5
    on_board = np.all(np.abs(at[..., :2] - board.middle_mm[:2]) < edge, axis=2)
    mixed = on_board & (share > 0.02) & (share < 0.98)
    assert mixed.sum() > 400
    off = seen - expected
    assert np.abs(off[on_board]).max() < 0.05
    assert np.sqrt(np.mean(off[mixed] ** 2)) < 0.015
    assert abs(off[mixed].mean()) < 1e-3


def test_the_lasers_line_is_as_much_dimmer_on_black() -> None:
    board = Board()
    renderer, optics = rendered(board, translation(*board.middle_mm.tolist()))
    light = renderer.laser_light(np.eye(4))[0]
    x = (np.arange(-3, 3) + 0.5) * board.square_x_mm
    y = board.middle_mm[1] % board.square_y_mm
    assert y == pytest.approx(board.square_y_mm / 2)  # the line runs through squares' middles
    u, v = np.round(to_pixels(optics, np.column_stack([x, 0 * x, 0 * x]))).astype(int).T
    peak = np.array([light[r - 6 : r + 7, c].max() for r, c in zip(v, u, strict=True)])
    i = np.floor((x + board.middle_mm[0]) / board.square_x_mm).astype(int)
    j = int(board.middle_mm[1] // board.square_y_mm)
    dark = (i + j) % 2 == 0
    assert peak[dark] == pytest.approx(board.ink * peak[~dark].mean(), rel=0.1)


def test_pictures_of_the_block_do_not_trace_the_board() -> None:
    simulation = SimulatedStation(SMALL)
    kinds, _, _ = simulation._renderer()._visible_objects(simulation._rig.T_arm_obj)
    assert len(kinds) < len(simulation._scene.objects) - 2
    assert 4 not in kinds


def test_the_board_is_made_after_its_certificate() -> None:
    sizes = []
    for seed in range(40):
        simulation = SimulatedStation(replace(SMALL, seed=seed, certificate_sd_mm=0.005))
        board, _ = board_of(simulation)
        columns, rows = board.inner_corners
        datasheet = simulation.datasheets()["chessboard.json"]
        assert (datasheet["inner_corners"], datasheet["square_mm"]) == ([columns, rows], 4.5)
        sizes.append((board.square_x_mm - 4.5) * (columns - 1))
        sizes.append((board.square_y_mm - 4.5) * (rows - 1))
    assert np.std(sizes) == pytest.approx(0.005, rel=0.3)


def test_the_operator_touches_all_over_the_printed_side(simulation: SimulatedStation) -> None:
    board, T = board_of(simulation)
    with opened(from_options({"url": simulation.arm_url, "timeout_s": 5.0})) as driver:
        spots = []
        for index in range(5):
            with ThreadPoolExecutor() as pool:
                touched = pool.submit(simulation.operator.touch, "board", index)
                records = read_until(driver, lambda got: len(button_edges(got)) == 2)
                pressed_ns = next(r.stamp_ns for r in records if not hasattr(r, "joints_rad"))
                assert touched.result(LONG_S)
            tip = tip_centre(simulation._rig.arm, simulation._motion.at(pressed_ns))
            spots.append((tip - T[:3, 3]) @ T[:3, :3])
    places = np.array(spots)
    assert places[:, 2] == pytest.approx(simulation._rig.arm.tip_diameter_mm / 2, abs=0.03)
    assert np.all(np.abs(places[:, :2] - board.middle_mm[:2]) < board.half_pattern_mm)
    assert np.all(np.ptp(places[:, :2], axis=0) > board.half_pattern_mm / 2)
    assert simulation.operator.touch("crest", 0)


def test_every_view_has_the_whole_pattern_and_the_laser_on_it(simulation: SimulatedStation) -> None:
    board, T_arm_board = board_of(simulation)
    half = np.array([*board.half_pattern_mm, 0.0])
    ends = np.array([[x, y, 0] for x in (-1, 1) for y in (-1, 1)]) * half + board.middle_mm
    optics, document = simulation._rig.optics, simulation._rig.light_plane
    ways, turns, heights = [], [], []
    for view in range(len(VIEWPOINTS)):
        assert simulation.operator.hold_over("board", view)
        T = np.linalg.inv(simulation.sensor_pose(now_ns())) @ T_arm_board
        corners = ends @ T[:3, :3].T + T[:3, 3]
        uv = to_pixels(optics, corners)
        assert uv.min() > 5
        assert np.all(uv < [optics.width_px - 6, optics.height_px - 6])
        middle = T[:3, :3] @ board.middle_mm + T[:3, 3]
        off = np.array([*corners, middle]) @ document.normal - document.offset_mm
        assert off[:4].min() < -2
        assert off[:4].max() > 2
        assert abs(off[4]) < 6
        R = optics.T_cam_sensor[:3, :3] @ T[:3, :3]
        ways.append(R[:2, 2])
        turns.append(np.degrees(np.arctan2(R[1, 0], R[0, 0])))
        heights.append((optics.T_cam_sensor[:3, :3] @ middle + optics.T_cam_sensor[:3, 3])[2])
    tilts = np.degrees(np.arcsin(np.array(ways)))
    assert np.ptp(tilts, axis=0) == pytest.approx([44, 44], abs=8)
    assert np.ptp(turns) > 35
    assert np.ptp(heights) > 12
