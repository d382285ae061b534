"""What stands on the simulated table, and where."""

import numpy as np

from crenel_hardware.simulator.devices.kinematics import Floats, rotation_about, translation
from crenel_hardware.simulator.scene.world import (
    Board,
    Box,
    CrenellatedBlock,
    FreeformPart,
    GaugeSphere,
    Light,
    SceneObject,
    SimulatedScene,
    make_table,
)

PARTS_MM = {
    "block": (740.0, 70.0, 0.20),
    "plate": (750.0, -75.0, -0.15),
    "sphere": (855.0, -10.0, 0.0),
    "shell": (640.0, -10.0, 0.10),
    "board": (610.0, -115.0, -0.10),
}
"""x, y and turn (rad) of everything on the table; of the chessboard its middle's."""

SUPPORT_MM = 16.0
"""Height of what the chessboard lies on."""


def part_pose(name: str, z_mm: float) -> Floats:
    """``T_arm_part`` (4, 4) of one of ``PARTS_MM``, its frame so high over the table."""
    x, y, turn = PARTS_MM[name]
    return np.asarray(translation(x, y, z_mm) @ rotation_about("z", turn))


def build_table_scene(
    block: CrenellatedBlock, T_arm_block: Floats, board: Board, correction: Floats, light: Light
) -> SimulatedScene:
    """Block, chessboard and parts as they truly are.

    Args:
        correction: (4, 4) from the frame in which gauges are certified to the arm's.
    """
    ball, plate = GaugeSphere(12.7), Box((-30.0, -20.0, -12.0), (30.0, 20.0, 0.0))
    foot = Box((-4.0, -4.0, -34.0), (4.0, 4.0, -11.0))
    stand = Box((-20.0, -16.0, 0.0), (20.0, 16.0, SUPPORT_MM))
    sphere_at = correction @ part_pose("sphere", 34.0)
    plate_at = correction @ part_pose("plate", 12.3) @ rotation_about("x", 0.012)
    printed_at = part_pose("board", SUPPORT_MM + board.thickness_mm)
    things = (
        make_table(),
        SceneObject("block", block, T_arm_block),
        SceneObject("plate", plate, plate_at, 0.8),
        SceneObject("sphere", ball, sphere_at, 0.85),
        SceneObject("foot", foot, sphere_at, 0.3),
        SceneObject("shell", FreeformPart(), part_pose("shell", 0.0), 0.9),
        SceneObject("board", board, printed_at @ translation(*(-board.middle_mm).tolist()), 0.9),
        SceneObject("stand", stand, part_pose("board", 0.0), 0.2),
    )
    return SimulatedScene(things, light)
