"""Where an operator touches a block, and how the stylus is held there."""

from collections.abc import Sequence

import numpy as np

from crenel.metrology.arm.kinematics import Arm
from crenel.metrology.targets.crenellated_block import Crenellated, probing_face
from crenel.metrology.transforms import Floats, rigid, rotation_from_vector

FACES = ("crest", "front", "left")
"""The faces to touch."""
ON_EACH_FACE = 15
MARGIN_MM = 1.5
"""Contacts keep this distance from the edges of a face, where it is wide enough."""
SWAY_RAD = 0.18
"""The stylus is held differently each time, by so much."""
_SPREAD = np.array([0.7548776662466927, 0.5698402909980532])
"""Steps along both sides of a rectangle that fill it evenly: powers of the inverse of the real
root of x³ = x + 1."""


def contact_places(block: Crenellated, tip_radius_mm: float) -> tuple[list[str], Floats]:
    """The face and the place (N, 3) of each contact, object frame, spread over the faces."""
    features, spots = [], []
    for face in FACES:
        rectangles = _rectangles(block, face, tip_radius_mm)
        for i in range(ON_EACH_FACE):
            low, high = rectangles[i % len(rectangles)]
            share = (0.5 + _SPREAD * (i + 1)) % 1.0
            free = np.flatnonzero(probing_face(block, face)[0] == 0.0)
            spot = low.copy()
            spot[free] += share * (high - low)[free]
            features.append(face)
            spots.append(spot)
    return features, np.array(spots)


def _rectangles(
    block: Crenellated, face: str, tip_radius_mm: float
) -> Sequence[tuple[Floats, Floats]]:
    """Opposite corners of the parts of a face that a tip touches."""
    x = block.edges_x_mm
    normal, offset_mm = probing_face(block, face)
    low = np.array([x[0], block.front_y_mm, block.base_z_mm + tip_radius_mm])
    high = np.array([x[-1], block.back_y_mm, block.crest_z_mm])
    across = int(np.flatnonzero(normal)[0])
    parts = []
    for left, right in zip(x[0::2], x[1::2], strict=True) if across else ((x[0], x[-1]),):
        a, b = low.copy(), high.copy()
        a[0], b[0] = left, right
        margin = np.minimum(MARGIN_MM, 0.3 * (b - a))
        a, b = a + margin, b - margin
        a[across] = b[across] = offset_mm * normal[across]
        parts.append((a, b))
    return parts


def contact_flanges(
    arm: Arm, T_arm_obj: Floats, block: Crenellated, features: Sequence[str], spots_mm: Floats
) -> Floats:
    """Poses (N, 4, 4) of the flange with the tip on each place, from above and from outside."""
    rng = np.random.default_rng(2)
    flanges = []
    for face, spot in zip(features, spots_mm, strict=True):
        normal, _ = probing_face(block, face)
        away = np.array([0.0, 0.0, 1.0]) + 0.4 * (1.0 - normal[2]) * normal
        away = T_arm_obj[:3, :3] @ (away + rng.normal(0.0, SWAY_RAD, 3))
        z = -away / np.linalg.norm(away)
        x = T_arm_obj[:3, 0] - (T_arm_obj[:3, 0] @ z) * z
        x /= np.linalg.norm(x)
        turn = rotation_from_vector(rng.normal(0.0, 2 * SWAY_RAD) * z)
        R = turn @ np.column_stack([x, np.cross(z, x), z])
        centre = spot + arm.tip.radius_mm * normal
        centre = T_arm_obj[:3, :3] @ centre + T_arm_obj[:3, 3]
        flanges.append(rigid(R, centre - R @ arm.tip.centre_mm))
    return np.array(flanges)
