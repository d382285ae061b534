"""Seats about the arm's reach, and the swing of the arm about a tip that stays in one."""

from contextlib import suppress

import numpy as np

from crenel_hardware.simulator.devices.kinematics import (
    ArmModel,
    Floats,
    UnreachableError,
    flange_pose,
    rotation_about,
    solve_joints,
    tip_centre,
    translation,
)
from crenel_hardware.simulator.devices.motion import (
    JointPath,
    min_jerk_progress,
    plan_approach,
    plan_path,
)
from crenel_hardware.simulator.operator.contact import contact_pose

SEATS = (
    (-0.42, 0.62, -0.32),
    (0.55, 0.45, -0.10),
    (0.15, 0.78, -0.22),
    (-0.95, 0.55, 0.05),
    (0.85, 0.68, 0.18),
    (-0.20, 0.42, 0.25),
    (0.30, 0.60, 0.35),
    (-0.60, 0.75, -0.12),
)
"""Bearing in rad, share of the reach, and rise in rad from the shoulder, of each seat."""
BARS = ((1, 1.5, 0.1), (2, 0.2, 0.5), (0, -0.9, 0.2), (4, 1.2, -0.3))
"""At which of the seats the bar's middle lies, its turn from there and its rise, in rad."""
BAR_MM = 300.0
SPHERE_MM = 25.0
"""The simulated ball bar's length and the sphere's diameter, as their certificates have them."""
CLEAR_MM, TOUCH_S, TOUCH_STEP = 8.0, 0.4, 0.618
PLATE_POINTS = (
    (-1, -1),
    (1, 1),
    (-1, 1),
    (1, -1),
    (0, 0),
    (-0.5, 0.1),
    (0.5, -0.1),
    (0, 0.7),
    (0, -0.7),
)
"""Places on a plate, from its middle, in shares of what may be touched."""
PLATE_SHARE, SWAY_RAD = 0.8, 0.12
SWING_RAD, LEAN_RAD, TWIST_RAD = 0.75, 0.55, 1.5
SWING_S = 11.0
KNOTS = 300
LIFT_MM, LIFT_S = 25.0, 0.5
PATH_TRIES = 8
TRIES, ENOUGH = 60, 8
EVEN_RAD = 0.02
"""Between neighbours of a path a joint's speed changes by no more."""


def seat_centre(arm: ArmModel, seat: int) -> Floats:
    """(3,) where the ``seat``-th seat holds the tip's centre, arm frame."""
    bearing, share, rise = SEATS[seat % len(SEATS)]
    tip = float(np.linalg.norm(arm.tip_mm))
    span = tip + sum(float(np.hypot(link.a_mm, link.d_mm)) for link in arm.links[1:])
    flat = span * share * np.cos(rise)
    return np.array(
        [
            flat * np.cos(bearing),
            flat * np.sin(bearing),
            arm.links[0].d_mm + span * share * np.sin(rise),
        ]
    )


def bar_end(arm: ArmModel, position: int, end: int) -> Floats:
    """(3,) where an end of the ball bar holds the tip's centre, for its ``position``-th place."""
    place, turn, rise = BARS[position % len(BARS)]
    middle = seat_centre(arm, place)
    bearing = float(np.arctan2(middle[1], middle[0])) + turn
    along = np.array([np.cos(rise) * np.cos(bearing), np.cos(rise) * np.sin(bearing), np.sin(rise)])
    return np.asarray(middle + (end - 0.5) * BAR_MM * along)


def path_into_seat(
    arm: ArmModel, centre_mm: Floats, q_rad: Floats, rng: np.random.Generator, pace: float
) -> JointPath:
    """From above a seat straight down into it, where the arm can swing.

    Raises:
        UnreachableError: the arm cannot do that with any posture tried.
    """
    tip, still = np.array(arm.tip_mm), np.zeros(3)
    for _ in range(PATH_TRIES):
        with suppress(UnreachableError):
            goal = joints_in_seat(arm, centre_mm, q_rad, rng)
            target = flange_pose(arm, goal)
            above = solve_joints(
                arm, translation(0.0, 0.0, LIFT_MM) @ target, goal, rng, attempts=1
            )
            path = plan_approach(arm, above, target, tip, (still, still), LIFT_S / pace)
            swing_path(arm, path.q_rad[-1], rng)
            return path
        q_rad = rng.uniform(0.8 * arm.limits_rad[:, 0], 0.8 * arm.limits_rad[:, 1])
    raise UnreachableError(f"the arm cannot swing at {np.round(centre_mm).tolist()} mm")


def path_onto_sphere(
    arm: ArmModel,
    ball_mm: Floats,
    radius_mm: float,
    index: float,
    q_rad: Floats,
    rng: np.random.Generator,
    lowest: float = -0.1,
    ways: int = 1,
) -> JointPath:
    """From outside a ball straight onto it, at the ``index``-th of places all over its top.

    Args:
        radius_mm: of the ball and the tip together, with the error of this contact.
        index: between whole numbers, a place between.
        lowest: of the places, over the ball's middle as a share of its radius.
        ways: of so many ways the one that turns the arm least from ``q_rad``.

    Raises:
        UnreachableError: the arm cannot do that with any posture tried.
    """
    height = 1.0 - (1.0 - lowest) * ((index * TOUCH_STEP) % 1.0)
    round_z = 2.4 * index
    flat = np.sqrt(1.0 - height**2)
    outward = np.array([flat * np.cos(round_z), flat * np.sin(round_z), height])
    still = np.zeros(3)
    tip = np.array(arm.tip_mm)
    found: list[JointPath] = []
    for _ in range(TRIES):
        T = rotation_about("z", float(rng.uniform(-np.pi, np.pi)))
        T = T @ rotation_about("y", float(rng.uniform(1.6, np.pi)))
        T = T @ rotation_about("z", float(rng.uniform(-np.pi, np.pi)))
        stylus = T[:3, :3] @ tip
        if float(stylus @ outward) > -0.4 * float(np.linalg.norm(tip)):
            continue  # it would come through the ball
        T[:3, 3] = ball_mm + radius_mm * outward - stylus
        with suppress(UnreachableError):
            goal = solve_joints(arm, T, q_rad, rng, attempts=2)
            clear = translation(*(CLEAR_MM * outward).tolist()) @ flange_pose(arm, goal)
            outside = solve_joints(arm, clear, goal, rng, attempts=1)
            onto = flange_pose(arm, goal)
            found.append(plan_approach(arm, outside, onto, tip, (still, still), TOUCH_S))
            if len(found) == ways:
                break
    if not found:
        raise UnreachableError("the arm cannot touch the ball there")
    return min(found, key=lambda path: _joint_travel_rad(path, q_rad))


def choose_plate_point(
    low_mm: Floats, high_mm: Floats, index: int, rng: np.random.Generator
) -> Floats:
    """(3,) the ``index``-th place to touch on the top of a plate between two corners: corners
    first, then its middle and between."""
    across, along = PLATE_POINTS[index % len(PLATE_POINTS)]
    half = PLATE_SHARE * (high_mm - low_mm) / 2
    middle = (low_mm + high_mm) / 2
    shift = rng.uniform(-1.0, 1.0, 2)
    return np.array(
        [
            middle[0] + across * half[0] + shift[0],
            middle[1] + along * half[1] + shift[1],
            high_mm[2],
        ]
    )


def path_onto_plate(
    arm: ArmModel,
    T_arm_plate: Floats,
    spot_mm: Floats,
    gap_mm: float,
    q_rad: Floats,
    rng: np.random.Generator,
) -> JointPath:
    """From above a place (3,) of a plate straight down onto it; of several ways the nearest.

    Raises:
        UnreachableError: the arm cannot do that with any posture tried.
    """
    tip, still = np.array(arm.tip_mm), np.zeros(3)
    flange_x = flange_pose(arm, q_rad)[:3, 0]
    best: JointPath | None = None
    for _ in range(PATH_TRIES):
        T = contact_pose(arm, T_arm_plate, "crest", spot_mm, gap_mm, rng, flange_x, SWAY_RAD)
        with suppress(UnreachableError):
            goal = solve_joints(arm, T, q_rad, rng, attempts=2)
            clear = translation(*(CLEAR_MM * T_arm_plate[:3, 2]).tolist()) @ T
            above = solve_joints(arm, clear, goal, rng, attempts=1)
            path = plan_approach(arm, above, T, tip, (still, still), TOUCH_S)
            if best is None or _joint_travel_rad(path, q_rad) < _joint_travel_rad(best, q_rad):
                best = path
    if best is None:
        raise UnreachableError("the arm cannot touch the plate there")
    return best


def _joint_travel_rad(path: JointPath, q_rad: Floats) -> float:
    return float(np.max(np.abs(path.q_rad[0] - q_rad)))


def joints_in_seat(
    arm: ArmModel, centre_mm: Floats, q_rad: Floats, rng: np.random.Generator
) -> Floats:
    """Joint angles (n,) with the tip in a seat, from which the arm swings freely.

    Raises:
        UnreachableError: the arm cannot get its tip there.
    """
    bearing = float(np.arctan2(centre_mm[1], centre_mm[0]))
    best: tuple[float, Floats] | None = None
    for attempt in range(TRIES):
        T = rotation_about("z", bearing + float(rng.uniform(-0.6, 0.6)))
        T = T @ rotation_about("y", float(rng.uniform(1.7, 2.7)))
        T = T @ rotation_about("z", float(rng.uniform(-np.pi, np.pi)))
        T[:3, 3] = centre_mm - T[:3, :3] @ np.array(arm.tip_mm)
        with suppress(UnreachableError):
            q = solve_joints(arm, T, q_rad, rng, attempts=2)
            path = swing_path(arm, q, rng)
            freedom = float(np.mean(np.ptp(path.q_rad, axis=0))) / path.duration_s
            if best is None or freedom > best[0]:
                best = freedom, q
            if attempt >= ENOUGH:
                break
    if best is None:
        raise UnreachableError(f"the tip does not reach {np.round(centre_mm, 1).tolist()} mm")
    return best[1]


def swing_path(
    arm: ArmModel, q_rad: Floats, rng: np.random.Generator, play_mm: float = 0.0
) -> JointPath:
    """The arm swung from side to side, leaned and twisted about the tip, and back again.

    As far as it goes from here. ``play_mm``: how much the tip moves in its seat.

    Raises:
        UnreachableError: it goes nowhere without flipping over.
    """
    start = flange_pose(arm, q_rad)
    tip = tip_centre(arm, q_rad)
    turn = 2 * np.pi * np.linspace(0.0, 1.0, KNOTS)
    # sets out and comes back at rest
    gently = min_jerk_progress(np.minimum(1.0, np.minimum(turn, turn[::-1]) / (np.pi / 3)))
    play = rng.normal(0.0, play_mm, (KNOTS, 3)) * gently[:, None]
    for share in (1.0, 0.75, 0.55, 0.4):
        angles = (
            share
            * gently[:, None]
            * np.column_stack(
                [
                    SWING_RAD * np.sin(turn),
                    LEAN_RAD * np.sin(2 * turn),
                    TWIST_RAD * np.sin(turn + 0.6),
                ]
            )
        )
        poses = np.tile(np.eye(4), (KNOTS, 1, 1))
        for pose, (swing, lean, twist), off in zip(poses, angles.tolist(), play, strict=True):
            R = start @ rotation_about("x", swing) @ rotation_about("y", lean)
            pose[:3, :3] = (R @ rotation_about("z", twist))[:3, :3]
            pose[:3, 3] = tip + off - pose[:3, :3] @ np.array(arm.tip_mm)
        with suppress(UnreachableError):
            path = plan_path(arm, poses, q_rad, SWING_S)
            # past a wrist stretched out straight the joints race, and the tip with them
            if float(np.max(np.abs(np.diff(path.q_rad, 2, axis=0)))) < EVEN_RAD:
                return path
    raise UnreachableError("the arm cannot swing about its tip here")
