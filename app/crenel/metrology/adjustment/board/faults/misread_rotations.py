"""Poses whose positions are right, and whose rotations were made of their numbers in another way.

A program that converts poses takes the numbers of a controller for another controller's: angles in
another order, a rotation vector for angles. The numbers are found back from the rotations as each
convention would have made them, and read as each other one.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import permutations
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.adjustment.board.faults.pairing import angles_between
from crenel.metrology.transforms import Floats
from crenel.rotations import CONVENTIONS, VECTOR

if TYPE_CHECKING:
    from scipy.spatial.transform import Rotation

LARGEST_RAD = np.deg2rad(3.0)
"""By which flange and board may turn differently, in a right reading."""
IN_ORDER, REVERSED = (0, 1, 2), (2, 1, 0)
Way = tuple[str, tuple[int, int, int]]
"""Form and order of a ``RotationConvention``."""


def _by_axis(form: str) -> Way:
    """Angles in the order about x, about y, about z."""
    first, second, third = ("XYZ".index(axis) for axis in form)
    return form, (first, second, third)


WAYS: tuple[Way, ...] = (
    *(_by_axis(form) for form in ("ZYX", "XYZ", "XZY", "YXZ", "YZX", "ZXY")),
    (VECTOR, IN_ORDER),
    ("ZYZ", IN_ORDER),
    ("ZXZ", IN_ORDER),
    ("ZYX", IN_ORDER),
    ("XYZ", REVERSED),
)
"""In which controllers make a rotation of three numbers, the commonest first."""


@dataclass(frozen=True)
class MisreadRotations:
    """What was made of the numbers, and what is right: ``vector``, or the axes of a product."""

    given: str
    right: str

    @property
    def controllers(self) -> tuple[str, ...]:
        """Conventions of the right form: names of ``CONVENTIONS``."""
        return tuple(name for name, one in CONVENTIONS.items() if one.form == self.right)


def list_rereadings(
    T_arm_flange: Floats, R_cam_obj: Floats | None = None
) -> Iterator[tuple[MisreadRotations, Floats]]:
    """All poses with their rotations made of the same numbers in another way.

    Args:
        T_arm_flange: (P, 4, 4) as given.
        R_cam_obj: (P, 3, 3) how the pictures show the board, where that is known: ways by which the
            flange does not turn between poses as the board turns before the camera are left out.

    Returns:
        Of each way, what was mistaken for what, and the poses (P, 4, 4).
    """
    from scipy.spatial.transform import Rotation  # slow to import; needed after a refusal only

    turned = Rotation.from_matrix(T_arm_flange[:, :3, :3])
    seen: list[Floats] = []
    for given, right in permutations(WAYS, 2):
        numbers = _numbers_of(turned, given)
        both = np.array([_rotation_of(one, right).as_matrix() for one in numbers])
        if R_cam_obj is None:
            chosen = np.argmin(_excess(numbers, right), axis=0)
        else:
            chosen, off_rad = _choose_by_turns(both, R_cam_obj)
            if off_rad > LARGEST_RAD:
                continue
        poses = T_arm_flange.copy()
        poses[:, :3, :3] = both[chosen, np.arange(len(poses))]
        if any(np.allclose(poses, other, atol=1e-6) for other in seen):
            continue
        seen.append(poses)
        yield MisreadRotations(given[0], right[0]), poses


def _choose_by_turns(both: Floats, R_cam_obj: Floats) -> tuple[NDArray[np.intp], float]:
    """Which of two rotations of the flange (2, P, 3, 3) each pose has, by the angles between poses;
    and by how much these differ from those of the board, in rad, by the median."""
    count = len(R_cam_obj)
    own = angles_between(both.reshape(2 * count, 9)).reshape(2, count, 2, count)
    off = np.abs(own - angles_between(R_cam_obj.reshape(count, 9))[None, :, None, :])
    from_one = off.min(axis=2).sum(axis=-1)  # (2, P): from each rotation of each pose
    way, pose = np.unravel_index(int(np.argmin(from_one)), from_one.shape)
    chosen = np.asarray(off[way, pose].argmin(axis=0))
    poses = np.arange(count)
    for _ in range(2):
        chosen = np.asarray(off[:, :, chosen, poses].sum(axis=-1).argmin(axis=0))
    left = off[chosen, poses][:, chosen, poses]
    return chosen, float(np.median(left[~np.eye(count, dtype=bool)]))


def _numbers_of(turned: "Rotation", way: Way) -> Floats:
    """(2, P, 3) the two triples of numbers of which a rotation is made in this way, rad."""
    form, order = way
    if form == VECTOR:
        vectors = turned.as_rotvec()
        length = np.maximum(np.linalg.norm(vectors, axis=1, keepdims=True), 1e-12)
        return np.array([vectors, vectors * (1 - 2 * np.pi / length)])
    first, middle, last = turned.as_euler(form).T
    other = -middle if form[0] == form[2] else np.pi - middle
    both = [(first, middle, last), (first + np.pi, other, last + np.pi)]
    numbers = np.empty((2, len(first), 3))
    for k, angles in enumerate(both):
        numbers[k][:, list(order)] = np.transpose(angles)
    return np.asarray((numbers + np.pi) % (2 * np.pi) - np.pi)


def _excess(numbers: Floats, way: Way) -> Floats:
    """(2, P) how far numbers lie outside what a controller of this way states, rad."""
    form, order = way
    if form == VECTOR:
        return np.asarray(np.linalg.norm(numbers, axis=-1))
    middle, others = numbers[..., order[1]], numbers[..., [order[0], order[2]]]
    beyond = -middle if form[0] == form[2] else np.abs(middle) - np.pi / 2
    return np.asarray(
        np.maximum(beyond, 0.0) + np.maximum(np.abs(others) - np.pi - 1e-9, 0.0).sum(axis=-1)
    )


def _rotation_of(numbers: Floats, way: Way) -> "Rotation":
    from scipy.spatial.transform import Rotation

    form, order = way
    if form == VECTOR:
        return Rotation.from_rotvec(numbers)
    return Rotation.from_euler(form, numbers[:, list(order)])
