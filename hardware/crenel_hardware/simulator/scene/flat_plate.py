"""The flat plate that the simulated operator sets up for a performance test; it is rendered while
it is scanned."""

from dataclasses import replace

import numpy as np

from crenel_hardware.simulator.devices.kinematics import Floats, rotation_about, translation
from crenel_hardware.simulator.scene.world import Box, SceneObject, SimulatedScene

SIDE_MM, THICK_MM = 100.0, 15.0
MIDDLE_MM, TURN_RAD = (690.0, -10.0, 120.0), 0.3
"""Where it lies, over all that stands on the table, arm frame."""
LEAN_RAD = 0.01
"""Nobody levels it."""


def plate_pose() -> Floats:
    """``T_arm_plate`` (4, 4): the middle of its top."""
    lies = rotation_about("z", TURN_RAD) @ rotation_about("x", LEAN_RAD)
    return np.asarray(translation(*MIDDLE_MM) @ lies)


def with_flat_plate(scene: SimulatedScene) -> SimulatedScene:
    """A scene in which the plate is set up."""
    half = SIDE_MM / 2
    plate = Box((-half, -half, -THICK_MM), (half, half, 0.0))
    thing = SceneObject("flat plate", plate, plate_pose(), 0.8)
    return replace(scene, objects=(*scene.objects, thing))
