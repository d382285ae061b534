"""Robots as their makers state them, with small errors, measured by a laser tracker."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import islice

import numpy as np
from scipy.spatial.transform import Rotation

from crenel.metrology.arm.identification.observations import TIP, Bar, Coordinates, Seat
from crenel.metrology.arm.identification.parameter_selection import candidates
from crenel.metrology.arm.identification.parameters import (
    parameter_names,
    parameter_values,
    with_parameters,
)
from crenel.metrology.arm.kinematics import (
    Arm,
    Joint,
    Tip,
    flange_poses,
    geometric_jacobian,
    tip_centres,
)
from crenel.metrology.transforms import Floats, apply, rigid

RIGHT = np.pi / 2
SMALL_ROBOT = (  # a, alpha, d, theta of six axes: a wrist of 580 mm reach
    (0.0, -RIGHT, 290.0, 0.0),
    (270.0, 0.0, 0.0, -RIGHT),
    (70.0, -RIGHT, 0.0, 0.0),
    (0.0, RIGHT, 302.0, 0.0),
    (0.0, -RIGHT, 0.0, 0.0),
    (0.0, 0.0, 72.0, 0.0),
)
SEVEN_AXES = (  # shoulder, elbow and wrist are spherical: 800 mm reach
    (0.0, -RIGHT, 340.0, 0.0),
    (0.0, RIGHT, 0.0, 0.0),
    (0.0, RIGHT, 400.0, 0.0),
    (0.0, -RIGHT, 0.0, 0.0),
    (0.0, -RIGHT, 400.0, 0.0),
    (0.0, RIGHT, 0.0, 0.0),
    (0.0, 0.0, 126.0, 0.0),
)
LINKS = {6: SMALL_ROBOT, 7: SEVEN_AXES}
LIMIT_RAD = 2.0


def robot(axes: int, tip_mm: Sequence[float] = (35.0, -20.0, 90.0)) -> Arm:
    """The robot of its datasheet; the marker is its tip."""
    joints = tuple(
        Joint(f"J{i + 1}", *link, limits_rad=(-LIMIT_RAD, LIMIT_RAD))
        for i, link in enumerate(LINKS[axes])
    )
    return Arm("robot", "R-1", joints, Tip(tip_mm[0], tip_mm[1], tip_mm[2], 12.7))


def built(arm: Arm, rng: np.random.Generator, mm: float = 0.3, rad: float = 6e-4) -> Arm:
    """The robot as it is: all parameters that a chain has differ from the datasheet."""
    values = parameter_values(arm)
    names = parameter_names(arm)
    for i in candidates(arm, with_lengths=True).order:
        values[i] += rng.normal(0, rad if names[i].endswith("_rad") else mm)
    return with_parameters(arm, values)


@dataclass(frozen=True)
class Tracker:
    """Where the tracker stands, and how well it measures."""

    T_tracker_arm: Floats
    sd_mm: float = 0.05
    sd_rad: float = 2e-4

    @staticmethod
    def somewhere(rng: np.random.Generator, sd_mm: float = 0.05) -> "Tracker":
        R = Rotation.random(random_state=rng.integers(2**31)).as_matrix()
        return Tracker(rigid(R, rng.uniform(-3000, 3000, 3)), sd_mm)


def postures(arm: Arm, count: int, rng: np.random.Generator) -> Floats:
    """Joint angles all over the range."""
    return rng.uniform(-0.9 * LIMIT_RAD, 0.9 * LIMIT_RAD, (count, arm.joint_count))


def measure(
    true: Arm,
    q_rad: Floats,
    tracker: Tracker,
    rng: np.random.Generator,
    full: bool = False,
    outliers: int = 0,
    frame: str = "tracker",
    marker: str = TIP,
) -> Coordinates:
    """What the tracker sees; ``outliers`` of the points are wrong by millimetres."""
    count = len(q_rad)
    points = apply(tracker.T_tracker_arm, tip_centres(true, q_rad))
    points = points + rng.normal(0, tracker.sd_mm, points.shape)
    wrong = rng.choice(count, outliers, replace=False)
    points[wrong] += rng.uniform(3, 20, (outliers, 1)) * rng.normal(0, 1, (outliers, 3))
    rotations = None
    if full:
        turned = Rotation.from_rotvec([0.3, -0.2, 0.9]).as_matrix()
        noise = Rotation.from_rotvec(rng.normal(0, tracker.sd_rad, (count, 3))).as_matrix()
        rotations = (
            noise @ tracker.T_tracker_arm[:3, :3] @ flange_poses(true, q_rad)[:, :3, :3] @ turned
        )
    return Coordinates(
        frame,
        marker,
        q_rad,
        points,
        np.full(count, tracker.sd_mm),
        rotations,
        np.full(count, tracker.sd_rad) if full else None,
        lines=tuple(range(2, count + 2)),
    )


def swing(true: Arm, name: str, rng: np.random.Generator, count: int = 12) -> Seat:
    """The tip held in one place somewhere, the arm swung about it in all its postures."""
    centre = tip_centres(true, postures(true, 1, rng))[0]
    taken: list[Floats] = []
    while len(taken) < count:
        q = reach(true, centre, postures(true, 1, rng)[0])
        if q is not None:
            taken.append(q)
    return Seat(name, np.array(taken))


def ball_bar(
    true: Arm, name: str, position: str, length_mm: float, rng: np.random.Generator
) -> Bar:
    """Six touches of each end of a bar of this true length, which lies somewhere."""
    while True:
        q = postures(true, 1, rng)[0]
        away = rng.normal(0, 1, 3)
        first = tip_centres(true, q[None])[0]
        ends: list[Floats] = []
        for place in (first, first + length_mm * away / np.linalg.norm(away)):
            near = q + rng.normal(0, 0.4, (10, true.joint_count))
            touches = (one for start in near if (one := reach(true, place, start)) is not None)
            ends.append(np.array(list(islice(touches, 6))))
        if all(len(end) == 6 for end in ends):
            return Bar(name, position, length_mm, 0.0, ("A", "B"), (ends[0], ends[1]))


def reach(true: Arm, place_mm: Floats, q_rad: Floats) -> Floats | None:
    """Joint angles near the given ones with the tip at a place; None where the search ends."""
    for _ in range(60):
        left = place_mm - tip_centres(true, q_rad[None])[0]
        if np.linalg.norm(left) < 1e-6:
            return q_rad
        by_joints = geometric_jacobian(true, q_rad, true.tip.centre_mm)[:3]
        damping = np.eye(3) * min(100.0, float(left @ left))
        turn = by_joints.T @ np.linalg.solve(by_joints @ by_joints.T + damping, left)
        q_rad = np.clip(q_rad + np.clip(turn, -0.3, 0.3), -LIMIT_RAD, LIMIT_RAD)
    return None
