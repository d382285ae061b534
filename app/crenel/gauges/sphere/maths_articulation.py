"""The articulations of the location test, and which place of a sphere a touch belongs to."""

from collections.abc import Sequence
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.arm.kinematics import AnyArm, flange_poses, tip_of
from crenel.metrology.transforms import Floats

TILT_DEG = 45.0
"""The tilt of the four tilted articulations from the pole, for an arm that cannot go down to
90°."""
AROUND_DEG = 60.0
"""The angle of the four places around that of the articulation's direction."""
LOCATION_CATCH_DEG = 30.0
"""A touch of the location test belongs to the nearest free place within this."""
HELD_DEG = 25.0
"""An articulation is met if the stylus, or the view of the camera, is within this of its direction:
a hand holds it so without a fixture."""
LEAST_APART_DEG = 20.0
"""Two articulations of one location test whose directions differ by less are the same."""
ROUNDS = 30


def frame_about(pole: Floats, towards: Floats) -> Floats:
    """Axes (3, 3) as columns, about a pole: to the right, away from ``towards``, along the pole.

    Args:
        pole: (3,) direction away from the holder.
        towards: (3,) direction to where the operator stands, such as the arm's base.

    Example:
        >>> frame_about(np.array([0.0, 0.0, 2.0]), np.array([0.0, -1.0, 5.0])).tolist()
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    """
    up = np.asarray(pole) / np.linalg.norm(pole)
    away = -(np.asarray(towards) - (towards @ up) * up)
    if np.linalg.norm(away) < 1e-6:
        away = np.array([0.0, 1.0, 0.0]) - up[1] * up
    away /= np.linalg.norm(away)
    return np.column_stack([np.cross(away, up), away, up]) + 0.0


def articulation_directions(pole: Floats, towards: Floats) -> Floats:
    """The directions (5, 3) from the sphere to wrist or sensor: along the pole, then tilted away,
    to the right, towards the operator and to the left.

    Args:
        pole: (3,); ``towards``: (3,), as of ``frame_about``.

    Source:
        ISO 10360-12, location test with five articulations; the tilts are a choice of this
        program.
    """
    right, away, up = frame_about(pole, towards).T
    tilt = np.radians(TILT_DEG)
    tilted = [np.cos(tilt) * up + np.sin(tilt) * side for side in (away, right, -away, -right)]
    return np.array([up, *tilted])


def stylus_directions(arm: AnyArm, readings: Floats) -> Floats:
    """Unit directions (N, 3) from the tip to the wrist, arm frame.

    Args:
        readings: (N, k) of the arm.

    Raises:
        OperationError: a robot without a tip.
    """
    stylus = tip_of(arm).centre_mm
    length_mm = max(float(np.linalg.norm(stylus)), 1e-9)
    return np.asarray(-flange_poses(arm, readings)[:, :3, :3] @ stylus / length_mm)


def mean_direction(directions: Floats) -> Floats:
    """The unit direction (3,) of the mean of unit directions (N, 3)."""
    mean = directions.mean(axis=0)
    return np.asarray(mean / max(float(np.linalg.norm(mean)), 1e-9))


def angle_deg(a: Floats, b: Floats) -> float:
    """The angle between two unit directions (3,).

    Example:
        >>> round(angle_deg(np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, 1.0])))
        90
    """
    return float(np.degrees(np.arccos(np.clip(a @ b, -1.0, 1.0))))


def nearest_pair(directions: Floats) -> tuple[int, int, float]:
    """The two of unit directions (N, 3), N >= 2, that differ least, and by how much in degrees."""
    pairs = combinations(range(len(directions)), 2)
    return min(
        ((i, j, angle_deg(directions[i], directions[j])) for i, j in pairs), key=lambda one: one[2]
    )


def location_places(direction: Floats, pole: Floats, towards: Floats) -> Floats:
    """The five places (5, 3) to touch in one articulation: its direction, and four around it."""
    across = frame_about(direction, towards if abs(direction @ pole) > 0.999 else -pole)
    angle = np.radians(AROUND_DEG)
    around = [
        np.cos(angle) * across[:, 2] + np.sin(angle) * side
        for side in (across[:, 1], across[:, 0], -across[:, 1], -across[:, 0])
    ]
    return np.array([across[:, 2], *around])


def find_centre(touches_mm: Floats, radius_mm: float, pole: Floats) -> Floats:
    """The centre (3,) of a sphere of known radius by its touches, the first of which is at its
    pole; by few touches, that one of all possible centres that is nearest to the first guess.

    Args:
        touches_mm: (N, 3) tip centres, N >= 1.
        radius_mm: of sphere and tip together.
        pole: (3,).
    """
    centre = touches_mm[0] - radius_mm * np.asarray(pole) / np.linalg.norm(pole)
    for _ in range(ROUNDS):
        away = touches_mm - centre
        distance = np.linalg.norm(away, axis=1)
        change = np.linalg.lstsq(away / distance[:, None], distance - radius_mm, rcond=1e-3)[0]
        centre = centre + change
        if np.max(np.abs(change)) < 1e-9:
            break
    return np.asarray(centre)


def assign_places(
    touches_mm: Floats, centre_mm: Floats, directions: Floats, catch_deg: float
) -> NDArray[np.int64]:
    """Which place each touch belongs to: (N,) indices of ``directions``, -1 of none.

    Touches are taken in order; each gets the nearest place that is still free, if it lies within
    ``catch_deg``.
    """
    away = touches_mm - centre_mm
    outward = away / np.linalg.norm(away, axis=1, keepdims=True)
    angles_deg = np.degrees(np.arccos(np.clip(outward @ directions.T, -1, 1)))
    free = np.ones(len(directions), dtype=np.bool_)
    found = np.full(len(touches_mm), -1, dtype=np.int64)
    for i, row in enumerate(angles_deg):
        open_deg = np.where(free, row, np.inf)
        nearest = int(np.argmin(open_deg))
        if open_deg[nearest] <= catch_deg:
            found[i], free[nearest] = nearest, False
    return found


def nearest_free(
    tip_mm: Floats, centre_mm: Floats, directions: Floats, taken: Sequence[int]
) -> int:
    """The place still to be touched that is nearest to the tip; -1 if there is none."""
    away = (tip_mm - centre_mm) / max(float(np.linalg.norm(tip_mm - centre_mm)), 1e-9)
    nearness = directions @ away
    nearness[list(taken)] = -np.inf
    nearest = int(np.argmax(nearness))
    return nearest if np.isfinite(nearness[nearest]) else -1


def flat_deg(directions: Floats, pole: Floats, towards: Floats) -> Floats:
    """Directions (N, 3) as seen along the pole, (N, 2) in degrees from it: right and away."""
    across = directions @ frame_about(pole, towards)
    angle = np.degrees(np.arccos(np.clip(across[:, 2], -1, 1)))
    flat = across[:, :2]
    size = np.linalg.norm(flat, axis=1)
    return np.asarray(flat * np.where(size > 1e-9, angle / np.maximum(size, 1e-9), 0.0)[:, None])
