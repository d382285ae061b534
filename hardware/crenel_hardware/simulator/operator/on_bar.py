"""Where the spheres of a ball bar are touched, and from where they are scanned."""

from contextlib import suppress
from itertools import product

import numpy as np

from crenel_hardware.simulator.devices.kinematics import (
    ArmModel,
    Floats,
    UnreachableError,
    rotation_about,
)
from crenel_hardware.simulator.devices.motion import JointPath
from crenel_hardware.simulator.operator.on_face import LEANS, UP
from crenel_hardware.simulator.operator.on_sphere import path_onto_place

TOUCHES = 4
DIRECTIONS = 400
LOWEST = -0.1
"""Over a sphere's middle, as a share of its radius, that is touched."""
ROD_DEG = 40.0
"""Touches keep this far from the rod."""
TURNS_RAD = (0.0, 0.3, -0.3)
"""About the vertical, tried in turn where the arm does not get to a place."""
STYLI = (0.7, 2.0, 0.2)
"""How much of the stylus' direction is up; the rest is out of the sphere."""
GOLDEN_RAD = np.pi * (3.0 - np.sqrt(5.0))


def touch_directions(rod: Floats) -> Floats:
    """(4, 3) unit directions from the middle of a sphere to its touches: all around its upper
    half, away from the rod, which leaves it in a direction (3,)."""
    z = np.linspace(1.0, LOWEST, DIRECTIONS)
    turn, flat = GOLDEN_RAD * np.arange(DIRECTIONS), np.sqrt(1.0 - z**2)
    around = np.column_stack([flat * np.cos(turn), flat * np.sin(turn), z])
    free = around[around @ (rod / np.linalg.norm(rod)) < np.cos(np.radians(ROD_DEG))]
    chosen = [free[0]]
    while len(chosen) < TOUCHES:  # each as far from those before as can be
        nearest = np.min(np.linalg.norm(free[:, None] - np.array(chosen), axis=2), axis=1)
        chosen.append(free[int(np.argmax(nearest))])
    return np.array(chosen)


def path_onto_bar(
    arm: ArmModel,
    ends_mm: Floats,
    end: int,
    touch: int,
    gap_mm: float,
    q_rad: Floats,
    rng: np.random.Generator,
) -> JointPath:
    """From outside a sphere of the bar straight onto one of its four places, or one beside it.

    Args:
        ends_mm: (2, 3) the spheres' centres, arm frame.
        gap_mm: of the ball and the tip together, with the error of this contact.

    Raises:
        UnreachableError: the arm cannot do that with any posture tried.
    """
    place = touch_directions(ends_mm[1 - end] - ends_mm[end])[touch % TOUCHES]
    for turn, up in product(TURNS_RAD, STYLI):
        outward = rotation_about("z", turn)[:3, :3] @ place
        with suppress(UnreachableError):
            stylus = outward + up * UP
            return path_onto_place(arm, ends_mm[end], gap_mm, outward, stylus, q_rad, rng)
    raise UnreachableError("the arm cannot touch the sphere of the bar there")


def view_directions(centre_mm: Floats, along: Floats) -> list[Floats]:
    """Unit directions (3,) across a bar from which a sphere is seen, the handiest first.

    Args:
        centre_mm: (3,) of the sphere, arm frame.
        along: (3,) the bar's direction.
    """
    direction = along / np.linalg.norm(along)
    to_arm = -np.array([centre_mm[0], centre_mm[1], 0.0])
    to_arm /= max(float(np.linalg.norm(to_arm)), 1.0)
    found = []
    for up, towards in LEANS:
        view = up * UP + towards * to_arm
        view = view - (view @ direction) * direction
        if np.linalg.norm(view) > 0.2:
            found.append(view / np.linalg.norm(view))
    return found
