"""How the simulated operator sweeps the sensor over a part that is scanned."""

from dataclasses import dataclass

import numpy as np

from crenel_hardware.simulator.devices.kinematics import Floats, rotation_about, translation
from crenel_hardware.simulator.scene.world import Box, FreeformPart, GaugeSphere, SceneObject

SPEED_MM_S = 16.0


@dataclass(frozen=True)
class Sweep:
    """One pass of the sensor over a part: sensor poses in the part's frame, from and to."""

    start: Floats
    end: Floats

    @property
    def duration_s(self) -> float:
        """How long an operator takes."""
        return float(np.linalg.norm(self.end[:3, 3] - self.start[:3, 3])) / SPEED_MM_S


def sweep_poses(T_arm_part: Floats, sweep: Sweep) -> Floats:
    """Sensor poses (K, 4, 4), arm frame: at even speed, with a short run-up and run-out."""
    speed = np.minimum(1.0, np.minimum(np.arange(1, 61), np.arange(60, 0, -1)) / 6.0)
    share = np.concatenate([[0.0], np.cumsum(speed)]) / speed.sum()
    poses = []
    for s in share:
        T = sweep.start.copy()
        T[:3, 3] = (1 - s) * sweep.start[:3, 3] + s * sweep.end[:3, 3]
        poses.append(T_arm_part @ T)
    return np.stack(poses)


def plan_sweeps(thing: SceneObject) -> list[Sweep]:
    """How a part is scanned; empty for what is no part."""
    shape = thing.shape

    def across(half_y: float, z: float, tilt_rad: float = 0.0, x: float = 0.0) -> Sweep:
        turn = rotation_about("x", tilt_rad)
        ends = [translation(x, y, z) @ turn for y in (-half_y, half_y)]
        return Sweep(*ends)

    def back(sweep: Sweep) -> Sweep:
        return Sweep(sweep.end, sweep.start)

    if isinstance(shape, GaugeSphere):
        top, r = 0.75 * shape.radius_mm, 1.05 * shape.radius_mm
        return [across(r, top), back(across(r, top, 0.3)), across(r, top, -0.3)]
    if isinstance(shape, FreeformPart):
        z, half = 0.6 * shape.height_mm, 1.02 * shape.half_depth_mm
        return [across(half, z), back(across(half, z, 0.2)), across(half, z, -0.2)]
    if isinstance(shape, Box) and thing.name == "plate":
        half = 0.9 * shape.high_mm[1]
        return [across(half, 0.0), back(across(half, 4.0))]
    return []
