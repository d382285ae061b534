"""Where the simulated operator holds the sensor for a picture: over block or chessboard."""

from dataclasses import dataclass

import numpy as np

from crenel_hardware.simulator.devices.kinematics import Floats, rotation_about, translation
from crenel_hardware.simulator.scene.camera import LightPlane, Optics
from crenel_hardware.simulator.scene.world import Board, CrenellatedBlock

PLACE_SD_MM, TURN_SD_RAD = 0.4, 0.015
"""An operator's usual variation."""


@dataclass(frozen=True)
class SensorMount:
    """What the sensor sees and lights, and where the arm carries it."""

    optics: Optics
    light_plane: LightPlane
    T_flange_sensor: Floats  # (4, 4)


@dataclass(frozen=True)
class BoardViewpoint:
    """How the camera looks at the board's middle."""

    about_x_deg: float
    about_y_deg: float
    """The board's tilt out of square to the view, about its own axes."""
    turn_deg: float = 0.0
    """The sensor's turn about the view."""
    away_mm: float = 0.0
    """Farther than where the laser crosses the view, or nearer."""


VIEWPOINTS = (
    BoardViewpoint(3, -2),
    BoardViewpoint(2, -21, 2, 4),
    BoardViewpoint(21, 3, -20, -6),
    BoardViewpoint(-3, 21, 1, 6),
    BoardViewpoint(-21, -3, 20, -5),
    BoardViewpoint(16, 15, 24, 7),
    BoardViewpoint(-16, 16, -24, 4),
    BoardViewpoint(-15, -16, 22, 8),
    BoardViewpoint(16, -15, -22, 6),
    BoardViewpoint(20, 3, 0, -6),
)
"""What a calibration on a chessboard wants: tilts to every side, turns and heights; the first
five as the guide asks, from straight above to the right, back, left and front."""


def sensor_over_block(block: CrenellatedBlock, rng: np.random.Generator) -> Floats:
    """``T_block_sensor`` (4, 4) with the block framed, as an operator would hold it."""
    middle = (block.crest_z_mm + block.floor_z_mm) / 2
    return np.asarray(translation(0.0, 0.0, middle) @ _draw_pose_error(rng))


def sensor_over_board(
    board: Board, sight: SensorMount, view: int, rng: np.random.Generator
) -> Floats:
    """``T_board_sensor`` (4, 4) with the pattern's middle looked at in the ``view``-th way.

    Begins again after the last of ``VIEWPOINTS``.
    """
    wanted = VIEWPOINTS[view % len(VIEWPOINTS)]
    T = _view_at_laser(sight.optics, sight.light_plane) @ translation(0.0, 0.0, -wanted.away_mm)
    T = T @ rotation_about("z", np.radians(wanted.turn_deg))
    T = T @ rotation_about("x", np.radians(wanted.about_x_deg))
    T = T @ rotation_about("y", np.radians(wanted.about_y_deg))
    middle = translation(*board.middle_mm.tolist())
    return np.asarray(middle @ _draw_pose_error(rng) @ np.linalg.inv(T))


def _view_at_laser(optics: Optics, light_plane: LightPlane) -> Floats:
    """``T_sensor_view`` (4, 4): where the camera's axis meets the laser, z towards the camera,
    x along the sensor's."""
    eye, along = optics.centre_mm, optics.T_cam_sensor[2, :3]
    normal = np.array(light_plane.normal)
    away_mm = (light_plane.offset_mm - normal @ eye) / (normal @ along)
    x = np.array([1.0, 0.0, 0.0]) - along[0] * along
    x /= np.linalg.norm(x)
    T = np.eye(4)
    T[:3, :3] = np.column_stack([x, np.cross(-along, x), -along])
    T[:3, 3] = eye + away_mm * along
    return T


def _draw_pose_error(rng: np.random.Generator) -> Floats:
    """(4, 4) by how much an operator misses the intended pose."""
    T = translation(*rng.normal(0.0, PLACE_SD_MM, 3).tolist())
    for axis in "xyz":
        T = T @ rotation_about(axis, float(rng.normal(0.0, TURN_SD_RAD)))
    return np.asarray(T)
