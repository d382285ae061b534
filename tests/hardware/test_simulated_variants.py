"""The simulator renders the same picture on every processor."""

import numpy as np
import pytest

from hardware.simulator.devices.kinematics import Floats, rotation_about, translation
from hardware.simulator.native import SIMULATOR
from hardware.simulator.rendering.noise import Detector, RawImage
from hardware.simulator.rendering.render import FINE, SMEARED, Renderer
from hardware.simulator.scene.random_scenes import draw_sensor
from hardware.simulator.scene.world import (
    Board,
    CrenellatedBlock,
    FreeformPart,
    GaugeSphere,
    Light,
    SceneObject,
    SimulatedScene,
    SurfaceFinish,
    make_table,
)

pytestmark = pytest.mark.slow

AT = translation(300.0, 40.0, 12.0) @ rotation_about("z", 0.4)
LAMP = Light(groove_shade=0.5, lamp_mm=(80.0, 20.0, 150.0), lamp_radius_mm=15.0)
SEED = 3


def placed(x: float, y: float, z: float) -> Floats:
    return AT @ translation(x, y, z) @ rotation_about("x", 0.1)


EVERY_KIND = (
    make_table(),
    SceneObject("block", CrenellatedBlock(), AT, 1.0, SurfaceFinish(0.3, 40.0, 0.05, 0.2)),
    SceneObject("ball", GaugeSphere(5.0), placed(20.0, -4.0, 6.0), 0.8),
    SceneObject("relief", FreeformPart(8.0, 8.0, 6.0), placed(-16.0, 0.0, 14.0), 0.9),
    SceneObject("board", Board((4, 3), 2.0, 2.0, 2.0), placed(0.0, 14.0, 4.0)),
)


def pictures(light: Light, bits: int) -> list[RawImage]:
    """With the room's light, the laser's, and both, with noise."""
    optics, light_plane = draw_sensor(CrenellatedBlock(), width_px=320, height_px=256)
    scene = SimulatedScene(EVERY_KIND, light)
    renderer = Renderer(scene, optics, light_plane, Detector(bits=bits), SEED)
    T = AT @ translation(0.3, -0.2, 7.5)
    return [
        renderer.render(T, 1.0, 0.0, FINE),
        renderer.render(T, 0.0, 1.0),
        renderer.render(T @ translation(0.1, 0.0, 0.0), 1.0, 1.0, SMEARED),
    ]


@pytest.mark.parametrize("light", [Light(), LAMP])
@pytest.mark.parametrize("bits", [8, 12])
def test_every_variant_renders_the_same_picture(light: Light, bits: int) -> None:
    expected = pictures(light, bits)
    for variant in SIMULATOR.variants[:-1]:
        with SIMULATOR.using(variant):
            for picture, other in zip(pictures(light, bits), expected, strict=True):
                assert np.std(other) > 1
                assert np.array_equal(picture, other)


def test_every_shape_is_in_the_picture() -> None:
    whole = pictures(Light(), 8)[0]
    optics, light_plane = draw_sensor(CrenellatedBlock(), width_px=320, height_px=256)
    for thing in EVERY_KIND:
        others = tuple(other for other in EVERY_KIND if other is not thing)
        renderer = Renderer(SimulatedScene(others), optics, light_plane, Detector(), SEED)
        without = renderer.render(AT @ translation(0.3, -0.2, 7.5), 1.0, 0.0, FINE)
        assert np.mean(np.abs(whole.astype(np.int64) - without) > 5) > 0.001, thing.name
