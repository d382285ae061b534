"""The measures of the chessboard's bench on pictures whose truth is known."""

from dataclasses import replace

import numpy as np
import pytest

from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.targets.chessboard import Chessboard, corner_points
from crenel.metrology.transforms import Floats, inverse, rigid, rotation_from_vector
from tests.bench.board_measures import (
    BoardFrame,
    PeerCalibration,
    common_plane_rms_mm,
    corner_rms_px,
    laser_plane_rms_mm,
    move_camera,
    origin_scatter_mm,
    pattern_scatter_mm,
)

BOARD = Chessboard("board", "", (7, 6), 10.0, 0.01)
K = np.array([[2400.0, 0, 640], [0, 2400.0, 512], [0, 0, 1]])
CAMERA = Camera(K, np.eye(3), np.zeros(3), 1280, 1024, np.array([-0.05, 0, 0, 0, 0]))
PLANE = LaserPlane(np.array([0.8, 0.1, np.sqrt(0.35)]), 200.0)
T_FLANGE_CAM = rigid(rotation_from_vector(np.array([0.1, -0.2, 1.0])), np.array([30.0, 5, 80]))
T_ARM_OBJ = rigid(rotation_from_vector(np.array([0.02, 0.1, 0.5])), np.array([900.0, 100, 40]))
EXACT = PeerCalibration("exact", CAMERA, T_FLANGE_CAM, corner_points(BOARD), PLANE)


def seen_from(T_cam_obj: Floats, number: int) -> BoardFrame:
    """All corners, and the line where the laser's plane meets the board."""
    R, t = T_cam_obj[:3, :3], T_cam_obj[:3, 3]
    normal, offset = R.T @ PLANE.normal, PLANE.offset_mm - PLANE.normal @ t
    y = np.linspace(-5, 55, 200)
    line = np.column_stack([(offset - normal[1] * y) / normal[0], y, 0 * y])
    camera = move_camera(CAMERA, T_cam_obj)
    return BoardFrame(
        number,
        T_ARM_OBJ @ inverse(T_FLANGE_CAM @ T_cam_obj),
        np.arange(42),
        project(camera, corner_points(BOARD)),
        project(camera, line),
    )


def frames() -> list[BoardFrame]:
    rng = np.random.default_rng(5)
    made = []
    for number in range(6):
        tilt = np.array([np.pi, 0, 0]) + rng.uniform(-0.3, 0.3, 3)
        shift = np.array([-30, 25, 300]) + rng.uniform(-8, 8, 3)
        made.append(seen_from(rigid(rotation_from_vector(tilt), shift), number))
    return made


def test_an_exact_calibration_leaves_nothing() -> None:
    made = frames()
    assert sum(frame.near_pattern().sum() for frame in made) > 600
    assert corner_rms_px(EXACT, made) < 1e-5
    assert origin_scatter_mm(EXACT, made) < 1e-4
    assert pattern_scatter_mm(EXACT, made) < 1e-4
    assert laser_plane_rms_mm(EXACT, made) < 1e-4
    assert common_plane_rms_mm(EXACT, made) < 1e-4


def test_the_choice_of_the_sensors_frame_changes_nothing() -> None:
    T = rigid(rotation_from_vector(np.array([0.3, 0.1, -0.4])), np.array([5.0, -20, 60]))
    n = T[:3, :3].T @ PLANE.normal
    shifted = PeerCalibration(
        "another frame",
        move_camera(CAMERA, T),
        T_FLANGE_CAM @ T,
        corner_points(BOARD),
        LaserPlane(n, float(PLANE.offset_mm - PLANE.normal @ T[:3, 3])),
    )
    made = [
        replace(
            frame,
            uv_px=frame.uv_px + 0.2 * (frame.corner % 2)[:, None],
            stripe_px=frame.stripe_px + 0.3 * (frame.number % 2),
        )
        for frame in frames()
    ]
    for measure in (origin_scatter_mm, laser_plane_rms_mm, common_plane_rms_mm, corner_rms_px):
        assert measure(shifted, made) == pytest.approx(measure(EXACT, made), rel=1e-4)
        assert measure(EXACT, made) > 1e-3


def test_a_plane_that_is_off_is_off_by_as_much() -> None:
    off = replace(EXACT, plane=LaserPlane(PLANE.normal, PLANE.offset_mm + 0.25))
    assert laser_plane_rms_mm(off, frames()) == pytest.approx(0.25, abs=1e-3)


def test_an_arm_that_is_off_once_scatters_the_board_by_that() -> None:
    made = frames()
    one = made[2]
    pushed = rigid(np.eye(3), np.array([0.6, 0, 0])) @ one.T_arm_flange
    made[2] = replace(one, T_arm_flange=pushed)
    # one of six off by 0.6 mm: rms from the mean is 0.6 sqrt(5) / 6
    assert origin_scatter_mm(EXACT, made) == pytest.approx(0.6 * np.sqrt(5) / 6, rel=1e-3)
