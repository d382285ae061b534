"""How the simulated operator passes over the plate to show a delay between arm and camera."""

import numpy as np

from hardware.simulator.devices.kinematics import Floats, rotation_about, translation

WAVES = 5.0
WAVE_MM = 6.0
PASS_S = 6.0
POSES = 121


def passing_poses(T_arm_plate: Floats, half_y_mm: float) -> Floats:
    """Sensor poses (K, 4, 4), arm frame, even in time: over the plate and back again, in waves
    nearer and away, as evenly as an operator does it."""
    poses = []
    for s in np.linspace(0.0, 1.0, POSES):
        y = -half_y_mm * np.cos(2 * np.pi * s)
        z = WAVE_MM * np.sin(2 * np.pi * WAVES * s) * np.sin(np.pi * s) ** 0.5
        lean = rotation_about("x", 0.05 * np.sin(6.0 * s)) @ rotation_about("y", 0.04 * s)
        poses.append(T_arm_plate @ translation(0.0, float(y), float(z)) @ lean)
    return np.stack(poses)
