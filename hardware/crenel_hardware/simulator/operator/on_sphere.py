"""The ways of a performance test on a sphere: onto a place from a direction, and over it so that
it is seen from one."""

from collections.abc import Sequence
from contextlib import suppress

import numpy as np

from crenel_hardware.simulator.devices.kinematics import (
    ArmModel,
    Floats,
    UnreachableError,
    flange_pose,
    rotation_about,
    solve_joints,
    translation,
)
from crenel_hardware.simulator.devices.motion import JointPath, plan_approach
from crenel_hardware.simulator.operator.sweeping import Sweep
from crenel_hardware.simulator.operator.swinging import CLEAR_MM, TOUCH_S

UP = np.array([0.0, 0.0, 1.0])
LEANS = ((1.0, 0.4), (0.3, 1.0), (1.0, -0.5), (0.0, 1.0), (-0.5, 1.0))
"""How much of a stylus' direction is up, and how much towards the arm."""
TRIES, NEAR = 60, 20
TWIST_RAD = 0.5
"""The twist of the stylus about itself, in the first tries."""
SWAY = 0.06
"""By how much an operator misses the direction of the stylus, as a share of its length."""
SHORTEST_WAYS = 4
"""How many short ways there are, of which the one that turns the arm least is taken."""
SWEEP_TURNS_RAD = (0.0, 0.2, -0.2, 0.35, -0.35)
LASER_SHARE = 0.6
"""By how much of the angle between them the laser is held higher than the view between both."""
OVER_SHARE, TOP_SHARE = 1.05, 0.75
"""How far a sweep goes beyond the middle and how high, in radii of the sphere."""
PASS_S = 3.2
"""The duration of one pass, at any pace: the camera's pictures decide how close its lines are."""


def unit_vector(direction: Sequence[float]) -> Floats:
    """The direction (3,) with length one."""
    found = np.asarray(direction, dtype=np.float64)
    return np.asarray(found / np.linalg.norm(found))


def path_onto_place(
    arm: ArmModel,
    ball_mm: Floats,
    radius_mm: float,
    outward: Floats,
    stylus_from: Floats,
    q_rad: Floats,
    rng: np.random.Generator,
) -> JointPath:
    """From outside a ball straight onto one of its places, with the stylus from a direction.

    Args:
        radius_mm: of the ball and the tip together, with the error of this contact.
        outward: (3,) unit direction of the place from the ball's centre, arm frame.
        stylus_from: (3,) direction from the tip to the stylus' other end, arm frame.

    Raises:
        UnreachableError: the arm cannot do that with any posture tried.
    """
    tip, still = np.array(arm.tip_mm), np.zeros(3)
    found: list[JointPath] = []
    now = flange_pose(arm, q_rad)[:3, :3]
    for attempt in range(TRIES):
        T = np.eye(4)
        T[:3, :3] = _turn_onto(now @ tip, -(stylus_from + rng.normal(0.0, SWAY, 3))) @ now
        # as the hand holds it now, or however it can
        T = T @ _turn_about(tip, float(rng.normal(0.0, TWIST_RAD if attempt < NEAR else np.pi)))
        T[:3, 3] = ball_mm + radius_mm * outward - T[:3, :3] @ tip
        with suppress(UnreachableError):
            goal = solve_joints(arm, T, q_rad, rng, attempts=2)
            onto = flange_pose(arm, goal)
            clear = translation(*(CLEAR_MM * outward).tolist()) @ onto
            outside = solve_joints(arm, clear, goal, rng, attempts=1)
            found.append(plan_approach(arm, outside, onto, tip, (still, still), TOUCH_S))
            if len(found) == SHORTEST_WAYS:
                break
    if not found:
        raise UnreachableError("the arm cannot touch the sphere there with its stylus like that")
    return min(found, key=lambda path: float(np.max(np.abs(path.q_rad[0] - q_rad))))


def plan_view(radius_mm: float, seen_from: Floats, camera: Floats) -> list[Sweep]:
    """The ways in which the sensor is passed over a sphere that it sees from a direction.

    Of camera and laser the camera is held lower, so that it sees the sphere down to its rim.

    Args:
        seen_from: (3,) direction to the sensor from the sphere's centre, in the sphere's frame.
        camera: (3,) direction to the camera in the sensor's frame.

    Returns:
        Sweeps from a little more or less to the side; any of them will do.
    """
    half, top = OVER_SHARE * radius_mm, TOP_SHARE * radius_mm
    sweeps = []
    for turn_rad in SWEEP_TURNS_RAD:
        towards = rotation_about("z", turn_rad)[:3, :3] @ seen_from
        side = np.cross([0.0, 0.0, 1.0], towards)
        if np.linalg.norm(side) < 1e-3:
            side = rotation_about("z", turn_rad)[:3, 0]
        x = side / np.linalg.norm(side)
        between = float(np.arccos(np.clip(camera[2] / np.linalg.norm(camera), -1.0, 1.0)))
        lean = LASER_SHARE * between
        away = np.cross(x, towards)
        z = np.cos(lean) * towards - np.sin(lean) * away
        held = np.eye(4)
        held[:3, :3] = np.column_stack([x, np.cross(z, x), z])
        ends = [held @ translation(0.0, y, top) for y in (-half, half)]
        sweeps.append(Sweep(ends[0], ends[1]))
    return sweeps


def _turn_onto(direction: Floats, wanted: Floats) -> Floats:
    """The rotation (3, 3) by the shortest way that turns one direction onto another."""
    a, b = (np.asarray(v) / np.linalg.norm(v) for v in (direction, wanted))
    axis, cosine = np.cross(a, b), float(a @ b)
    if cosine < -1 + 1e-12:
        across = np.cross(a, [1.0, 0.0, 0.0] if abs(a[0]) < 0.9 else [0.0, 1.0, 0.0])
        across /= np.linalg.norm(across)
        return np.asarray(2 * np.outer(across, across) - np.eye(3))
    K = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.asarray(np.eye(3) + K + K @ K / (1 + cosine))


def _turn_about(axis: Floats, angle_rad: float) -> Floats:
    """The rotation (4, 4) about an axis (3,) through the origin."""
    onto = np.eye(4)
    onto[:3, :3] = _turn_onto(np.array([0.0, 0.0, 1.0]), axis)
    return np.asarray(onto @ rotation_about("z", angle_rad) @ onto.T)
