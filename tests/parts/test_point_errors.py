"""Derivatives of points by everything that errs, against central differences."""

from dataclasses import replace

import numpy as np
import pytest

from crenel.metrology.adjustment.core.arm_errors import arm_motion
from crenel.metrology.arm.kinematics import Arm, flange_poses
from crenel.metrology.arm.link_error import error_from_transform, error_transform
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.projection import step_camera
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.transforms import (
    Floats,
    apply,
    pivot_adjoint,
    rigid,
    rotation_from_vector,
    se3_exp,
)
from crenel.parts.maths.point_errors import (
    LINKS_FROM,
    PROBE,
    ScanErrors,
    TouchErrors,
    name_shared_errors,
)
from crenel.parts.maths.sensor_errors import SENSOR_COUNT
from tests.metrology.builders import random_arm

COUNT, FRAMES, GAINS = 60, 7, 3


class Setup:
    """An arm, a sensor, and points in several frames, all at random."""

    def __init__(self, seed: int, shear: float = 0.0) -> None:
        rng = np.random.default_rng(seed)
        self.rng = rng
        self.arm = random_arm(rng, 7, with_errors=True)
        matrix = np.array([[1810.0, shear, 655.0], [0.0, 1795.0, 498.0], [0.0, 0.0, 1.0]])
        turn = rotation_from_vector(rng.normal(0.0, 0.4, 3))
        lens = np.array([-0.12, 0.06, 4e-4, -3e-4, 0.01])
        self.camera = Camera(matrix, turn, np.array([3.0, -8.0, 150.0]), 1280, 1024, lens)
        normal = turn.T @ np.array([0.1, -0.8, 0.6])
        self.plane = LaserPlane(normal / np.linalg.norm(normal), 0.0)
        centre = self.camera.centre_mm + 150.0 * turn[2]
        self.plane = replace(self.plane, offset_mm=float(self.plane.normal @ centre))
        self.T_flange_sensor = rigid(
            rotation_from_vector(rng.normal(0.0, 0.8, 3)), rng.normal(0.0, 60.0, 3)
        )
        self.pivot = rng.normal(0.0, 100.0, 3)
        self.q = rng.uniform(-1.5, 1.5, (FRAMES, 7))
        self.frame = np.sort(rng.integers(0, FRAMES, COUNT))
        self.uv = rng.uniform([200, 200], [1080, 820], (COUNT, 2))
        normals = rng.normal(size=(COUNT, 3))
        self.normals = normals / np.linalg.norm(normals, axis=1)[:, None]
        self.gains = rng.normal(size=(COUNT, GAINS))

    def points(self, shared: Floats, readings: Floats) -> Floats:
        """The points after a step of the shared parameters (P,) and of each reading (F, 7)."""
        camera = step_camera(self.camera, shared[:14])
        plane = self.plane.apply_step(shared[14:SENSOR_COUNT])
        about = pivot_adjoint(self.pivot) @ shared[PROBE]
        mount = se3_exp(about) @ self.T_flange_sensor
        T = flange_poses(self.moved_arm(shared), self.q + readings)[self.frame]
        return apply(T @ mount, sensor_points(camera, plane, self.uv))

    def tips(self, shared: Floats, readings: Floats) -> Floats:
        T = flange_poses(self.moved_arm(shared), self.q + readings)
        return apply(T, np.tile(self.arm.tip.centre_mm + shared[-4:-1], (FRAMES, 1)))

    def moved_arm(self, shared: Floats) -> Arm:
        twists = shared[LINKS_FROM:-4].reshape(-1, 6)
        joints = (
            replace(one, error=error_from_transform(error_transform(one.error) @ se3_exp(twist)))
            for one, twist in zip(self.arm.joints, twists, strict=True)
        )
        return replace(self.arm, joints=tuple(joints))

    def scan_errors(self) -> ScanErrors:
        still = np.zeros(len(name_shared_errors(7)))
        return ScanErrors(
            self.points(still, np.zeros((FRAMES, 7))),
            self.frame,
            self.rng.uniform(0.005, 0.02, COUNT),
            self.camera,
            self.plane,
            self.T_flange_sensor,
            self.pivot,
            "u",
            arm_motion(self.arm, self.q),
            np.full(7, 2e-5),
        )


def central(moved: Floats, behind: Floats, step: float) -> Floats:
    return (moved - behind) / (2 * step)


@pytest.mark.parametrize(("seed", "shear"), [(1, 0.0), (2, 0.0), (3, 1.7)])
def test_points_of_a_scan_follow_sensor_and_arm(seed: int, shear: float) -> None:
    setup = Setup(seed, shear)
    errors = setup.scan_errors()
    found = errors.sums(setup.gains, setup.normals)
    names = name_shared_errors(7)
    expected = np.zeros((GAINS, len(names)))
    for k, name in enumerate(names):
        step = 1e-3 if name in ("fx", "fy", "u0", "v0") or "_t" in name else 1e-6
        change = np.zeros(len(names))
        change[k] = step
        still = np.zeros((FRAMES, 7))
        moved = central(setup.points(change, still), setup.points(-change, still), step)
        expected[:, k] = setup.gains.T @ np.sum(moved * setup.normals, axis=1)
    scale = np.abs(expected).max(axis=0) + 1e-3
    assert found.shared.shape == expected.shape
    assert (np.abs(found.shared - expected) < 1e-5 * scale).all()


def test_points_of_a_frame_share_the_error_of_its_reading() -> None:
    setup = Setup(4)
    errors = setup.scan_errors()
    found = errors.sums(setup.gains, setup.normals)
    assert found.frames.tolist() == np.unique(setup.frame).tolist()
    still = np.zeros(len(name_shared_errors(7)))
    for place, frame in enumerate(found.frames):
        for joint in range(7):
            turn = np.zeros((FRAMES, 7))
            turn[frame, joint] = 1e-6
            moved = central(setup.points(still, turn), setup.points(still, -turn), 1e-6)
            taken = setup.gains.T @ np.sum(moved * setup.normals, axis=1) * 2e-5
            assert np.allclose(found.by_readings[place, :, joint], taken, rtol=1e-4, atol=1e-8)


@pytest.mark.parametrize("axis", ["u", "v"])
def test_own_noise_lies_in_the_laser_plane_across_the_stripe(axis: str) -> None:
    setup = Setup(5)
    errors = replace(setup.scan_errors(), axis=axis)
    step = np.array([0.0, 1e-3] if axis == "u" else [1e-3, 0.0])
    ahead, behind = (
        sensor_points(setup.camera, setup.plane, setup.uv + way * step) for way in (1, -1)
    )
    off = ahead - behind
    R = errors.sensor_poses[setup.frame, :3, :3]
    off = np.einsum("nij,nj->ni", R, off) / np.linalg.norm(off, axis=1)[:, None]
    expected = errors.spread_mm * np.abs(np.sum(off * setup.normals, axis=1))
    assert np.allclose(errors.own_sd_mm(setup.normals), expected, rtol=1e-4, atol=1e-9)


def test_the_pixels_of_points_are_those_of_their_frames() -> None:
    setup = Setup(6)
    pixels = project(setup.camera, setup.scan_errors().points_sensor_mm())
    assert np.allclose(pixels, setup.uv, atol=1e-6)


def test_a_part_of_the_points_has_its_part_of_the_sums() -> None:
    setup = Setup(7)
    errors = setup.scan_errors()
    whole = errors.sums(setup.gains, setup.normals).shared
    halves = [np.arange(0, COUNT, 2), np.arange(1, COUNT, 2)]
    parts = [errors.select(k).sums(setup.gains[k], setup.normals[k]).shared for k in halves]
    assert np.allclose(sum(parts), whole)


def test_touches_follow_arm_and_tip() -> None:
    setup = Setup(8)
    still, names = np.zeros((FRAMES, 7)), name_shared_errors(7)
    centres = setup.tips(np.zeros(len(names)), still)
    side = np.where(np.arange(FRAMES) % 2, 1.0, -1.0)
    errors = TouchErrors(centres, side, arm_motion(setup.arm, setup.q), np.full(7, 1e-5), 0.004)
    normals, gains = setup.normals[:FRAMES], setup.gains[:FRAMES]
    found = errors.sums(gains, normals)
    for k in range(LINKS_FROM, len(names) - 1):
        step = 1e-6 if "_r" in names[k] else 1e-3
        change = np.zeros(len(names))
        change[k] = step
        moved = central(setup.tips(change, still), setup.tips(-change, still), step)
        expected = gains.T @ np.sum(moved * normals, axis=1)
        assert np.allclose(found.shared[:, k], expected, rtol=1e-4, atol=1e-4)
    assert np.allclose(found.shared[:, -1], -gains.T @ side)
    assert not found.shared[:, :LINKS_FROM].any()
    assert errors.own_sd_mm(normals).tolist() == [0.004] * FRAMES
