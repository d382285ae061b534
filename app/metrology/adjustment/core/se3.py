"""Small motions of frames: twists ``(rx, ry, rz, tx, ty, tz)`` in rad and mm.

A left twist of ``T_ab`` moves it to ``moved(twist) @ T_ab``: it turns about the origin of
frame a, and then shifts.
"""

import numpy as np

from app.metrology.transforms import Floats, inverse, rigid, rotation_from_vector, skew


def se3_exp(twist: Floats) -> Floats:
    """The (4, 4) transform of a twist (6,)."""
    return rigid(rotation_from_vector(twist[:3]), twist[3:])


def adjoint(T_ab: Floats) -> Floats:
    """(6, 6): a small twist given in frame b, as seen in frame a (the adjoint of ``T_ab``)."""
    R = T_ab[:3, :3]
    matrix = np.zeros((6, 6))
    matrix[:3, :3] = matrix[3:, 3:] = R
    matrix[3:, :3] = skew(T_ab[:3, 3]) @ R
    return matrix


def adjoint_inverse(T_ab: Floats) -> Floats:
    """(6, 6): a small twist given in frame a, as seen in frame b."""
    return adjoint(inverse(T_ab))


def pivot_adjoint(pivot_mm: Floats) -> Floats:
    """(6, 6): a twist that turns about a pivot (3,), as one that turns about the origin."""
    matrix = np.eye(6)
    matrix[3:, :3] = skew(pivot_mm)
    return matrix
