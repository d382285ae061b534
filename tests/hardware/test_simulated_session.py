"""Rendered session folders: complete, true, and the same again and on every processor."""

import json
from dataclasses import replace
from itertools import product
from pathlib import Path

import numpy as np
import pytest

from crenel_hardware.simulator.devices.kinematics import (
    Floats,
    rotation_about,
    tip_centre,
    translation,
)
from crenel_hardware.simulator.native import SIMULATOR
from crenel_hardware.simulator.operator.contact import (
    choose_contact_point,
    outward_normal,
    reachable_faces,
)
from crenel_hardware.simulator.rendering.noise import Detector, RawImage
from crenel_hardware.simulator.rendering.render import FINE, SMEARED, Renderer
from crenel_hardware.simulator.scene.random_scenes import draw_sensor, random_block
from crenel_hardware.simulator.scene.world import (
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
from crenel_hardware.simulator.session import SessionPlan, draw_rig, render_scan, render_session
from tests.pictures import read_picture
from tests.running.usual import usual

pytestmark = pytest.mark.slow

AT = translation(300.0, 40.0, 12.0) @ rotation_about("z", 0.4)
LAMP = Light(groove_shade=0.5, lamp_mm=(80.0, 20.0, 150.0), lamp_radius_mm=15.0)
SEED = 3


def read_rows(path: Path) -> list[dict[str, str]]:
    header, *lines = path.read_text().splitlines()
    return [dict(zip(header.split(","), line.split(","), strict=True)) for line in lines]


@pytest.mark.parametrize(
    ("seed", "plan"),
    [
        (0, SessionPlan()),
        (1, SessionPlan(joints=7, imperfection_um=100, poses=2, roll_rad=1.6)),
        (2, SessionPlan(lighting="both", faces=("crest", "floor", "front", "right"), merlons=3)),
    ],
)
def test_a_session_holds_all_that_is_brought(tmp_path: Path, seed: int, plan: SessionPlan) -> None:
    truth = render_session(tmp_path, seed, plan)
    assert json.loads((tmp_path / "truth.json").read_text()) == truth
    images = read_rows(tmp_path / "images.csv")
    assert len(images) == plan.poses * (2 if plan.lighting == "pair" else 1)
    for row in images:
        image = read_picture(tmp_path / row["file"])
        assert image.shape == (plan.height_px, plan.width_px)
    rows = read_rows(tmp_path / "probing.csv")
    assert len(rows) == len(plan.faces) * plan.contacts_per_face
    rig = draw_rig(seed, plan)
    for row in rows:
        q = np.radians([float(row[f"q{i + 1}_deg"]) for i in range(plan.joints)])
        on_block = np.linalg.inv(rig.T_arm_obj) @ [*tip_centre(rig.arm, q), 1.0]
        face = row["feature"]
        spot = choose_contact_point(
            rig.block, face, 0, rig.arm.tip_diameter_mm / 2, np.random.default_rng()
        )
        height = outward_normal(face) @ (on_block[:3] - spot)
        assert height == pytest.approx(rig.arm.tip_diameter_mm / 2, abs=0.06)
    axis = json.loads((tmp_path / "sensor.json").read_text())["stripe_axis"]
    assert axis == ("v" if plan.roll_rad else "u")


def test_a_seed_gives_the_same_session_again(tmp_path: Path) -> None:
    plan = SessionPlan(width_px=640, height_px=512)
    render_session(tmp_path / "a", 5, plan)
    render_session(tmp_path / "b", 5, plan)
    for path in sorted((tmp_path / "a").rglob("*.*")):
        assert path.read_bytes() == (tmp_path / "b" / path.relative_to(tmp_path / "a")).read_bytes()


def test_no_drawn_block_looks_like_its_mirror_image() -> None:
    for seed in range(30):
        edges = np.array(random_block(np.random.default_rng(seed)).edges_x_mm)
        widths = np.diff(edges)
        assert len(edges) % 2 == 0
        assert widths.min() > 2
        assert np.abs(widths - widths[::-1]).max() >= 2.0


def test_the_floor_is_offered_only_to_a_ball_that_fits() -> None:
    assert "floor" in reachable_faces(CrenellatedBlock(), 1.5)
    assert "floor" not in reachable_faces(CrenellatedBlock(), 3.5)
    with pytest.raises(KeyError, match="cannot be touched"):
        choose_contact_point(CrenellatedBlock(), "floor", 0, 3.5, np.random.default_rng(0))


def test_contacts_spread_over_a_face() -> None:
    block = CrenellatedBlock()
    rng = np.random.default_rng(0)
    for face in ("crest", "front", "left"):
        spots = np.array([choose_contact_point(block, face, i, 1.5, rng) for i in range(9)])
        spread = np.ptp(spots, axis=0)
        assert np.sum(spread > 8) == 2
        assert np.min([np.linalg.norm(a - b) for i, a in enumerate(spots) for b in spots[:i]]) > 1


def test_a_scan_yields_frames_and_joints() -> None:
    plan = replace(SessionPlan(), width_px=640, height_px=512, encoder_noise=False)
    rig = draw_rig(3, plan)
    T = rig.T_arm_obj
    path = [T @ translation(0.0, 0.5 * i, 9.0) for i in range(3)]
    frames = list(render_scan(rig, GaugeSphere(), T, path, plan))
    assert len(frames) == 3
    assert all(frame.image.max() > 150 for frame in frames)
    assert all(frame.joints_rad.shape == (6,) for frame in frames)
    assert not np.allclose(frames[0].joints_rad, frames[2].joints_rad)


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


@pytest.mark.parametrize(
    ("light", "bits"), usual(product((Light(), LAMP), (8, 12)), {0, 3}, pytest.mark.soak)
)
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
