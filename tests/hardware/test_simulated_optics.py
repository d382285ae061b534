"""The simulated lens and pictures against OpenCV's projection and plain geometry."""

import cv2
import numpy as np
import pytest

from crenel_hardware.simulator.devices.kinematics import Floats, rotation_about, translation
from crenel_hardware.simulator.rendering.noise import Detector, speckle_tile
from crenel_hardware.simulator.rendering.render import SMEARED, Renderer
from crenel_hardware.simulator.scene.camera import LightPlane, Optics, sight_lines, to_pixels
from crenel_hardware.simulator.scene.random_scenes import draw_sensor
from crenel_hardware.simulator.scene.world import (
    Box,
    CrenellatedBlock,
    FreeformPart,
    GaugeSphere,
    Light,
    SceneObject,
    SimulatedScene,
    make_table,
    relief_height_mm,
)

pytestmark = pytest.mark.slow

BLOCK = CrenellatedBlock()
PLAIN = Light(texture=0.0)
NOISELESS = Detector(read_dn=0.0, shot_dn=0.0, speckle_contrast=0.0)
EXACT = Detector(
    read_dn=0.0, shot_dn=0.0, speckle_contrast=0.0, bits=16, stripe_dn=120.0, crest_dn=100.0
)
Lens = tuple[float, float, float, float, float]
LENSES: list[Lens] = [(0.0,) * 5, (-0.09, 0.08, 4e-4, -3e-4, 0.02)]


def opencv_pixels(optics: Optics, points: Floats) -> Floats:
    T = optics.T_cam_sensor
    found, _ = cv2.projectPoints(
        points, cv2.Rodrigues(T[:3, :3])[0], T[:3, 3], optics.matrix, np.array(optics.distortion)
    )
    return np.asarray(found.reshape(-1, 2))


@pytest.mark.parametrize("distortion", LENSES)
@pytest.mark.parametrize("roll", [0.0, 1.6, -2.9])
def test_projection_is_opencvs(distortion: Lens, roll: float) -> None:
    rng = np.random.default_rng(1)
    optics, _ = draw_sensor(BLOCK, rng, roll_rad=roll, distortion=distortion)
    points = rng.uniform([-22, -12, -15], [22, 12, 10], (200, 3))
    assert np.allclose(to_pixels(optics, points), opencv_pixels(optics, points), atol=1e-9)


@pytest.mark.parametrize("distortion", LENSES)
def test_a_sight_line_leads_back_to_its_pixel(distortion: Lens) -> None:
    optics, _ = draw_sensor(BLOCK, np.random.default_rng(2), distortion=distortion)
    lines = sight_lines(optics).astype(np.float64)
    v, u = np.indices(lines.shape[:2]) - 1
    rays = np.dstack([lines, np.ones(lines.shape[:2])]).reshape(-1, 3)[::997].copy()
    lens = np.array(optics.distortion)
    in_cam, _ = cv2.projectPoints(rays, np.zeros(3), np.zeros(3), optics.matrix, lens)
    wanted = np.column_stack([u.ravel(), v.ravel()])[::997]
    assert np.abs(in_cam.reshape(-1, 2) - wanted).max() < 2e-3


def block_scene(light: Light = PLAIN) -> SimulatedScene:
    place = translation(300.0, 40.0, 12.0) @ rotation_about("z", 0.4)
    return SimulatedScene((make_table(), SceneObject("block", BLOCK, place)), light)


def over_block(scene: SimulatedScene) -> Floats:
    tilt = rotation_about("z", 0.03) @ rotation_about("x", 0.02) @ rotation_about("y", -0.03)
    return scene.find_object("block").T_arm_obj @ translation(0.3, -0.2, 7.5) @ tilt


def sensor_over_block(
    detector: Detector, rng: np.random.Generator | None = None, distortion: Lens = LENSES[0]
) -> tuple[Renderer, Floats]:
    """A renderer of the block, and the pose of the sensor over it."""
    optics, light_plane = draw_sensor(BLOCK, rng, distortion=distortion)
    scene = block_scene()
    return Renderer(scene, optics, light_plane, detector), over_block(scene)


def in_sensor(scene: SimulatedScene, T_arm_sensor: Floats, points_obj: Floats) -> Floats:
    T = np.linalg.inv(T_arm_sensor) @ scene.find_object("block").T_arm_obj
    return points_obj @ T[:3, :3].T + T[:3, 3]


def plane_in_block(
    scene: SimulatedScene, T_arm_sensor: Floats, light_plane: LightPlane
) -> tuple[Floats, float]:
    """The laser's plane: its normal, and its offset in mm, in the block's frame."""
    into = np.linalg.inv(T_arm_sensor) @ scene.find_object("block").T_arm_obj
    normal = np.array(light_plane.normal)
    return into[:3, :3].T @ normal, float(light_plane.offset_mm - normal @ into[:3, 3])


EDGES = {
    "crest front": ([-22, -12, 15], [-14, -12, 15]),
    "second crest back": ([-7, 12, 15], [-2, 12, 15]),
    "floor front": ([5, -12, 0], [-2, -12, 0]),
    "base front": ([-22, -12, -12], [22, -12, -12]),
    "left end": ([-22, -12, 15], [-22, 12, 15]),
    "right end": ([22, -12, 15], [22, 12, 15]),
}


def step_places(image: Floats, line: Floats, reach: int = 7) -> Floats:
    """How far each crossing of an edge is off ``line``, along rows or columns, in px: the light
    between two plateaus, summed, says where the step is."""
    upright = abs(line[-1, 1] - line[0, 1]) > abs(line[-1, 0] - line[0, 0])
    if upright:
        image, line = image.T, line[:, ::-1]
    line = line[np.argsort(line[:, 0])]
    columns = np.arange(int(line[0, 0]) + 12, int(line[-1, 0]) - 12)
    expected = np.interp(columns, line[:, 0], line[:, 1])
    off = []
    for c, v in zip(columns, expected, strict=True):
        low = round(float(v)) - reach
        window = image[low : low + 2 * reach + 1, c]
        first, last = window[0], window[-1]
        share = np.sum((window - last) / (first - last))
        off.append(low - 0.5 + share - v)
    return np.array(off)


@pytest.mark.parametrize("distortion", LENSES)
@pytest.mark.parametrize("name", EDGES)
def test_edges_are_where_geometry_puts_them(name: str, distortion: Lens) -> None:
    renderer, T = sensor_over_block(EXACT, distortion=distortion)
    image = renderer.render(T).astype(np.float64)
    ends = np.array(EDGES[name], dtype=np.float64)
    points = ends[0] + np.linspace(0, 1, 400)[:, None] * (ends[1] - ends[0])
    off = step_places(image, opencv_pixels(renderer.optics, in_sensor(renderer.scene, T, points)))
    assert len(off) > 50
    assert abs(off.mean()) < 0.003
    assert np.sqrt(np.mean(off**2)) < 0.01


@pytest.mark.parametrize("distortion", LENSES)
@pytest.mark.parametrize("patch", [(-22, -14, 15), (5, 10, 15), (-2, 5, 0)])
def test_the_stripe_lies_by_geometry(patch: tuple[float, float, float], distortion: Lens) -> None:
    optics, light_plane = draw_sensor(BLOCK, np.random.default_rng(4), distortion=distortion)
    scene = block_scene()
    T = over_block(scene)
    image = Renderer(scene, optics, light_plane, EXACT).render(T, room=0.0, laser=1.0)
    light = image.astype(np.float64) - image[5, 5]
    normal, offset = plane_in_block(scene, T, light_plane)
    x = np.linspace(patch[0] + 0.4, patch[1] - 0.4, 300)
    y = (offset - normal[0] * x - normal[2] * patch[2]) / normal[1]
    line = opencv_pixels(
        optics, in_sensor(scene, T, np.column_stack([x, y, np.full(300, patch[2])]))
    )
    line = line[np.argsort(line[:, 0])]
    columns = np.arange(int(line[0, 0]) + 1, int(line[-1, 0]))
    expected = np.interp(columns, line[:, 0], line[:, 1])
    off = []
    for c, v in zip(columns, expected, strict=True):
        rows = np.arange(round(float(v)) - 9, round(float(v)) + 10)
        weight = light[rows, c]
        if weight.max() > 0.3 * light.max():
            off.append(np.sum(rows * weight) / weight.sum() - v)
    assert len(off) > 60
    trimmed = np.array(off)[4:-4]
    assert abs(np.mean(trimmed)) < 0.01
    assert np.sqrt(np.mean(trimmed**2)) < 0.015


def test_a_merlon_hides_the_floor_behind_it_from_camera_and_laser() -> None:
    optics, light_plane = draw_sensor(BLOCK)
    scene = block_scene()
    light, _, _ = Renderer(scene, optics, light_plane, NOISELESS).laser_light(over_block(scene))
    T = over_block(scene)
    normal, offset = plane_in_block(scene, T, light_plane)

    def brightness(x: float, z: float) -> float:
        y = (offset - normal[0] * x - normal[2] * z) / normal[1]
        u, v = opencv_pixels(optics, in_sensor(scene, T, np.array([[x, y, z]])))[0]
        return float(light[round(float(v)), round(float(u))])

    assert brightness(-18.0, 15.0) > 0.8
    assert brightness(1.0, 0.0) > 0.8
    assert brightness(-18.0, 0.0) == 0.0
    assert brightness(-7.15, 0.0) < 0.05  # seen past the edge of the second merlon: not at all


def test_a_smeared_picture_is_the_same_picture_less_sharp() -> None:
    renderer, T = sensor_over_block(NOISELESS)
    smeared = renderer.room_light(T, SMEARED)
    sharp = renderer.room_light(T)
    assert sharp.shape == smeared.shape
    apart = np.abs(cv2.GaussianBlur(sharp, (0, 0), 2.0) - cv2.GaussianBlur(smeared, (0, 0), 2.0))
    assert apart.mean() < 0.005
    assert np.percentile(apart, 99.5) < 0.1
    assert np.abs(np.diff(sharp, axis=0)).max() > np.abs(np.diff(smeared, axis=0)).max()


def test_noise_is_as_the_detector_says() -> None:
    detector = Detector()
    renderer, T = sensor_over_block(detector)
    frames = np.stack([renderer.render(T).astype(np.float64) for _ in range(24)])
    flat = frames[:, 20:60, 20:200]
    light = flat.mean() - detector.dark_dn
    expected = np.sqrt(detector.read_dn**2 + detector.shot_dn * light + 1 / 12)
    assert flat.std(axis=0).mean() == pytest.approx(expected, rel=0.05)
    dark = np.stack([renderer.render(T, room=0.0).astype(np.float64) for _ in range(8)])
    assert dark.mean() == pytest.approx(detector.dark_dn, abs=0.05)


@pytest.mark.parametrize("contrast", [0.1, 0.17, 0.5])
def test_speckle_has_its_contrast_and_no_seam(contrast: float) -> None:
    detector = Detector(speckle_contrast=contrast)
    tile = speckle_tile(detector, 0).astype(np.float64)
    assert tile.mean() == pytest.approx(1.0, abs=1e-5)
    assert tile.std() == pytest.approx(contrast, rel=0.04)
    steps = np.diff(tile, axis=0, append=tile[:1])
    assert np.std(steps[-1]) == pytest.approx(np.std(steps[:-1]), rel=0.2)
    correlation = np.mean((tile - 1) * (np.roll(tile, 1, axis=1) - 1)) / tile.var()
    assert correlation == pytest.approx(np.exp(-0.5 / detector.speckle_px**2), abs=0.03)


def test_speckle_stays_while_the_sensor_stays_and_changes_as_it_moves() -> None:
    renderer, T = sensor_over_block(Detector(read_dn=0.0, shot_dn=0.0))
    first = renderer.render(T, room=0.0, laser=0.5).astype(np.int64)
    again = renderer.render(T, room=0.0, laser=0.5).astype(np.int64)
    assert np.array_equal(first, again)
    moved = renderer.render(T @ translation(0.5, 0.0, 0.0), room=0.0, laser=0.5)
    lit = first > 60
    assert np.mean(np.abs(first - moved.astype(np.int64))[lit]) > 8


def test_too_much_light_saturates() -> None:
    image, deep = (
        renderer.render(T, room=4.0)
        for renderer, T in (sensor_over_block(Detector()), sensor_over_block(Detector(bits=12)))
    )
    assert image.max() == 255
    assert np.mean(image == 255) > 0.2
    assert deep.dtype == np.uint16
    assert deep.max() == 4095


@pytest.mark.parametrize(
    "shape", [GaugeSphere(12.7), FreeformPart(), Box((-20, -15, -5), (20, 15, 0))]
)
def test_stripes_lie_on_shape_and_light_plane(shape: GaugeSphere | FreeformPart | Box) -> None:
    optics, light_plane = draw_sensor(BLOCK)
    T_arm_sensor = translation(0.0, 0.0, 9.0 if isinstance(shape, GaugeSphere) else 3.0)
    scene = SimulatedScene((SceneObject("part", shape, np.eye(4)),), PLAIN)
    light, _, _ = Renderer(scene, optics, light_plane, NOISELESS).laser_light(T_arm_sensor)
    columns = np.flatnonzero(light.max(axis=0) > 0.35)[10:-10:9]
    assert len(columns) > 20
    rows = np.arange(light.shape[0])
    centres = (light * rows[:, None]).sum(axis=0)[columns] / light.sum(axis=0)[columns]
    pixels = np.column_stack([columns, centres]).reshape(-1, 1, 2)
    directions = cv2.undistortPoints(pixels, optics.matrix, np.array(optics.distortion))
    R, t = optics.T_cam_sensor[:3, :3], optics.T_cam_sensor[:3, 3]
    rays = np.column_stack([directions.reshape(-1, 2), np.ones(len(columns))]) @ R
    eye = -R.T @ t
    n = np.array(light_plane.normal)
    at = eye + rays * ((light_plane.offset_mm - n @ eye) / (rays @ n))[:, None]
    at = at + T_arm_sensor[:3, 3]
    if isinstance(shape, GaugeSphere):
        off = np.linalg.norm(at, axis=1) - shape.radius_mm
        off = off[np.abs(at[:, 0]) < 8]
    elif isinstance(shape, FreeformPart):
        off = at[:, 2] - relief_height_mm(shape, at[:, 0], at[:, 1])
        off = off[np.abs(at[:, 0]) < 20]
    else:
        off = at[:, 2]
    assert np.abs(off).max() < 0.003
    assert abs(off.mean()) < 0.001


def test_a_ray_that_grazes_a_steep_relief_comes_to_an_end() -> None:
    """Seen from low beside it, steps by secants lead back and forth."""
    steep = FreeformPart(8.0, 8.0, 6.0)
    light = Light(texture=0.0, lamp_mm=(80.0, 20.0, 30.0), lamp_radius_mm=15.0)
    optics, light_plane = draw_sensor(BLOCK, width_px=160, height_px=128)
    scene = SimulatedScene((SceneObject("part", steep, np.eye(4)),), light)
    renderer = Renderer(scene, optics, light_plane, NOISELESS)
    assert renderer.room_light(translation(0.0, 0.0, 3.0)).max() > 0.2
