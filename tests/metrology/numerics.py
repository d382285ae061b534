"""Directions, lengths and slopes as the tests work them out."""

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from crenel.metrology.arm.kinematics import Arm, flange_pose
from crenel.metrology.transforms import Floats, vector_from_rotation


def unit(vectors: ArrayLike) -> Floats:
    """Vectors (..., 3) scaled to a length of one."""
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))


def on_sphere(height: Floats, turn_rad: ArrayLike) -> Floats:
    """Unit vectors (N, 3) by their heights and their turns about the z axis."""
    flat, turn = np.sqrt(1 - height**2), np.asarray(turn_rad)
    return np.column_stack([flat * np.cos(turn), flat * np.sin(turn), height])


def rms_length(vectors: Floats) -> float:
    return float(np.sqrt(np.mean(np.sum(vectors**2, axis=1))))


def differences(function: Callable[[Floats], Floats], steps: ArrayLike) -> Floats:
    """(..., n) slopes of a function of n parameters where all are 0, by a step to either side."""
    slopes = [(function(step) - function(-step)) / (2 * step.sum()) for step in np.diag(steps)]
    return np.stack(slopes, axis=-1)


def flange_slopes(arm: Arm, q: Floats, point: Floats) -> Floats:
    """(6, n) derivatives of a point on the flange and of its rotation by the encoders."""
    h, columns = 1e-6, []
    for step in h * np.eye(arm.joint_count):
        before, after = flange_pose(arm, q - step), flange_pose(arm, q + step)
        turn = vector_from_rotation(after[:3, :3] @ before[:3, :3].T)
        columns.append([*((after - before) @ [*point, 1.0])[:3], *turn])
    return np.array(columns).T / (2 * h)
