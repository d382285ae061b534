"""The ways onto the faces of a step gauge, wherever it is set up."""

from contextlib import suppress

import numpy as np

from crenel_hardware.simulator.devices.kinematics import ArmModel, Floats, UnreachableError
from crenel_hardware.simulator.devices.motion import JointPath
from crenel_hardware.simulator.operator.on_sphere import path_onto_place

UP = np.array([0.0, 0.0, 1.0])
LEANS = ((1.0, 0.4), (0.3, 1.0), (1.0, -0.5), (0.0, 1.0), (-0.5, 1.0))
"""How much of the stylus' direction is up, and how much towards the arm."""


def path_onto_face(
    arm: ArmModel,
    face_mm: Floats,
    gap_mm: float,
    normal: Floats,
    q_rad: Floats,
    rng: np.random.Generator,
) -> JointPath:
    """From before a face straight onto it, with the stylus across the gauge.

    Args:
        face_mm: (3,) the place on the face, arm frame.
        gap_mm: from there to the tip's centre, with the error of this contact.
        normal: (3,) out of the face.

    Raises:
        UnreachableError: the arm cannot do that with any posture tried.
    """
    to_arm = -np.array([face_mm[0], face_mm[1], 0.0])
    to_arm /= max(float(np.linalg.norm(to_arm)), 1.0)
    for up, towards in LEANS:
        stylus = up * UP + towards * to_arm
        stylus = stylus - (stylus @ normal) * normal
        if np.linalg.norm(stylus) < 0.2:
            continue  # the stylus would come out of the face
        with suppress(UnreachableError):
            return path_onto_place(arm, face_mm, gap_mm, normal, stylus, q_rad, rng)
    raise UnreachableError("the arm cannot touch the face there")
