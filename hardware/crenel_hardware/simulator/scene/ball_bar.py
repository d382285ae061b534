"""The ball bar that the simulated operator sets up about the arm's reach; it is rendered while it
is scanned."""

from dataclasses import replace

import numpy as np

from crenel_hardware.simulator.devices.kinematics import Floats
from crenel_hardware.simulator.scene.world import Box, GaugeSphere, SceneObject, SimulatedScene

ROD_SHARE = 0.35
"""Half the width of the rod between the spheres, as a share of their radius."""
INTO_SHARE = 0.9
"""The rod begins so far from the middle of a sphere, as a share of its radius."""


def bar_ends(middle_mm: Floats, along: Floats, length_mm: float) -> Floats:
    """(2, 3) the spheres' centres of a bar about its middle along a direction (3,)."""
    direction = along / np.linalg.norm(along)
    return np.asarray(middle_mm + np.array([[-0.5], [0.5]]) * length_mm * direction)


def with_bar(scene: SimulatedScene, ends_mm: Floats, diameter_mm: float) -> SimulatedScene:
    """A scene in which a bar is set up, by its spheres' centres (2, 3), arm frame."""
    radius_mm = diameter_mm / 2
    turn = _frame_along(ends_mm[1] - ends_mm[0])
    poses = [turn.copy() for _ in ends_mm]
    for T, centre in zip(poses, ends_mm, strict=True):
        T[:3, 3] = centre
    half, start = ROD_SHARE * radius_mm, INTO_SHARE * radius_mm
    rod_mm = float(np.linalg.norm(ends_mm[1] - ends_mm[0])) - start
    ball = GaugeSphere(radius_mm)
    things = (
        SceneObject("bar sphere 1", ball, poses[0], 0.85),
        SceneObject("bar sphere 2", ball, poses[1], 0.85),
        SceneObject("bar rod", Box((-half, -half, start), (half, half, rod_mm)), poses[0], 0.3),
    )
    return replace(scene, objects=(*scene.objects, *things))


def _frame_along(direction: Floats) -> Floats:
    """A pose (4, 4) at the origin whose z axis has a direction (3,)."""
    z = direction / np.linalg.norm(direction)
    x = np.cross([0.0, 0.0, 1.0] if abs(z[2]) < 0.9 else [1.0, 0.0, 0.0], z)
    x /= np.linalg.norm(x)
    T = np.eye(4)
    T[:3, :3] = np.column_stack([x, np.cross(z, x), z])
    return T
