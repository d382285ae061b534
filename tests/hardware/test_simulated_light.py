"""The simulated lamp: its shadows, its fading and its highlights against plain geometry."""

from dataclasses import replace

import numpy as np
import pytest

from crenel_hardware.simulator.devices.kinematics import Floats
from crenel_hardware.simulator.rendering.degradations import NUISANCES, USABLE, draw_degraded_image
from crenel_hardware.simulator.rendering.noise import Detector
from crenel_hardware.simulator.rendering.render import Renderer
from crenel_hardware.simulator.scene.camera import (
    Optics,
    camera_looking_at,
    light_plane_through,
    to_pixels,
)
from crenel_hardware.simulator.scene.world import (
    Box,
    Light,
    SceneObject,
    SimulatedScene,
    SurfaceFinish,
)

T_CAM_SENSOR = camera_looking_at(
    np.array([0.0, -60.0, 120.0]), np.zeros(3), np.array([1.0, 0.0, 0.0]), 0.0
)
OPTICS = Optics(320, 256, 400.0, 400.0, 159.5, 127.5, (0.0,) * 5, T_CAM_SENSOR)
NOISELESS = Detector(read_dn=0.0, shot_dn=0.0, speckle_contrast=0.0)
SLAB = Box((-200.0, -200.0, -10.0), (200.0, 200.0, 0.0))
LAMP = (80.0, 0.0, 100.0)
LIT = Light(directed=0.8, ambient=0.1, texture=0.0, lamp_mm=LAMP)
TABLE = SceneObject("table", SLAB, np.eye(4))
POST = SceneObject("post", Box((-5.0, -5.0, 0.0), (5.0, 5.0, 20.0)), np.eye(4))
SHADOW_ENDS_MM = -5.0 - (80.0 + 5.0) / (100.0 - 20.0) * 20.0
"""The top's far edge, x = -5 at z = 20, throws its shadow 21.25 mm further."""


def light_of(things: tuple[SceneObject, ...], light: Light) -> Floats:
    over = np.array([0.0, 0.0, 100.0])
    light_plane = light_plane_through(np.array([0.0, 1.0, 0.0]), np.zeros(3), over)
    renderer = Renderer(SimulatedScene(things, light), OPTICS, light_plane, NOISELESS)
    return np.asarray(renderer.room_light(np.eye(4)))


def at(light: Floats, point: tuple[float, float, float]) -> float:
    u, v = to_pixels(OPTICS, np.array([point]))[0]
    return float(light[round(v), round(u)])


def test_a_lamp_fades_with_the_distance_and_the_slant() -> None:
    image = light_of((TABLE,), LIT)
    origin = np.linalg.norm(LAMP)
    for point in ((0.0, 0.0, 0.0), (25.0, 10.0, 0.0), (-30.0, -5.0, 0.0)):
        way = np.array(LAMP) - point
        far = np.linalg.norm(way)
        expected = 0.1 + 0.8 * (way[2] / far) * (origin / far) ** 2
        assert at(image, point) == pytest.approx(expected, rel=0.01)


def test_a_shadow_falls_where_the_lamp_does_not_reach() -> None:
    image = light_of((TABLE, POST), LIT)
    assert at(image, (SHADOW_ENDS_MM + 1.0, 0.0, 0.0)) == pytest.approx(0.1, abs=0.01)
    assert at(image, (SHADOW_ENDS_MM - 1.0, 0.0, 0.0)) > 0.3
    assert at(image, (-10.0, 8.0, 0.0)) > 0.3


def test_a_wide_lamp_softens_the_shadow() -> None:
    spread = []
    for radius in (0.0, 20.0):
        image = light_of((TABLE, POST), replace(LIT, lamp_radius_mm=radius))
        spread.append([at(image, (SHADOW_ENDS_MM + x, 0.0, 0.0)) for x in (-2.0, 2.0)])
    hard, soft = spread
    assert hard[0] - hard[1] > 0.25
    assert 0.03 < soft[0] - soft[1] < 0.7 * (hard[0] - hard[1])


def test_a_highlight_lies_where_the_lamp_is_mirrored() -> None:
    glossy = SceneObject("table", SLAB, np.eye(4), 0.2, SurfaceFinish(gloss=1.0, sharpness=400.0))
    dull = SceneObject("table", SLAB, np.eye(4), 0.2)
    image = light_of((glossy,), LIT) - light_of((dull,), LIT)
    eye = OPTICS.centre_mm
    share = eye[2] / (eye[2] + LAMP[2])
    mirror = tuple((1 - share) * eye + share * (np.array(LAMP) * [1, 1, -1]) + [0, 0, 0])
    v, u = np.unravel_index(int(np.argmax(image)), image.shape)
    assert np.hypot(*(to_pixels(OPTICS, np.array([mirror]))[0] - [u, v])) < 4.0


def test_tool_marks_run_along_a_face() -> None:
    light = Light((0.0, 0.0, 1.0), texture=0.0)
    marked = SceneObject("table", SLAB, np.eye(4), 1.0, SurfaceFinish(marks=0.1, mark_mm=1.0))
    image = light_of((marked,), light)
    assert 0.05 < image.std() / image.mean() < 0.15
    assert np.abs(np.diff(image, axis=0)).mean() > 5 * np.abs(np.diff(image, axis=1)).mean()


def test_a_spoilt_picture_is_of_one_piece() -> None:
    shot = draw_degraded_image(3)
    assert shot.nuisances <= set(NUISANCES)
    assert shot.visible_share >= USABLE
    assert shot.image.shape == (shot.optics.height_px, shot.optics.width_px)
    assert np.array_equal(shot.image, draw_degraded_image(3).image)
