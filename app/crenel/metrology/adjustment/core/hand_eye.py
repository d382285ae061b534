"""The mounting of the sensor on the flange from poses alone: start values, and poses that
contradict."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.messages.message import message, quantity, signed
from crenel.metrology.robust import median
from crenel.metrology.transforms import (
    Floats,
    inverse,
    nearest_rotation,
    rigid,
    vector_from_rotation,
)

Thing = Literal["object", "board"]
"""The target that the pictures of a calibration show."""

# A pose contradicts the others beyond this, and beyond this multiple of their usual scatter.
CONTRADICTS_MM, CONTRADICTS_TIMES = 1.5, 6.0
# Poses that scatter by more than this have no common object position.
HOPELESS_MM = 5.0
# Rotations between poses smaller than this do not determine the mounting.
LEAST_TURN_RAD = np.deg2rad(3.0)
# Ratio of the second to the first direction of rotation below which rotations are about one axis.
LEAST_SECOND_AXIS = 0.05
# Poses in each draw, and draws.
FEW, DRAWS = 4, 60
EPSILON = float(np.finfo(np.float64).eps)


@dataclass(frozen=True)
class Mounting:
    """``T_flange_cam`` and ``T_arm_obj`` (4, 4), and the distance of each of P poses from them.

    ``off_mm`` (P,) is the distance of the object seen in that pose from its position;
    ``contradicts`` (P,) marks poses that cannot belong with the others.
    """

    T_flange_cam: Floats
    T_arm_obj: Floats
    T_arm_flange: Floats  # (P, 4, 4), as given
    T_cam_obj: Floats  # (P, 4, 4), as given
    off_mm: Floats
    contradicts: NDArray[np.bool_]


def mounting_by_contacts(
    T_arm_flange: Floats, T_cam_obj: Floats, T_arm_obj: Floats, reach_mm: float
) -> Mounting:
    """The mounting that most poses agree on, where contact points give the pose of the target.

    Args:
        T_arm_flange, T_cam_obj: (P, 4, 4).
        T_arm_obj: (4, 4) from the contact points.
        reach_mm: the size of the target; converts angles into lengths.

    Returns:
        ``T_flange_cam``, and which poses contradict it.

    Source:
        Eq. 8 of the article, for each pose.
    """
    each = inverse(T_arm_flange) @ T_arm_obj @ inverse(T_cam_obj)
    off = np.array([pose_offsets_mm(T_arm_flange, T_cam_obj, X, T_arm_obj, reach_mm) for X in each])
    best = each[int(np.argmin(np.median(off, axis=1)))]
    off_mm = pose_offsets_mm(T_arm_flange, T_cam_obj, best, T_arm_obj, reach_mm)
    contradicts = find_contradictions(off_mm)
    X = mean_transform(each[~contradicts])
    off_mm = pose_offsets_mm(T_arm_flange, T_cam_obj, X, T_arm_obj, reach_mm)
    return Mounting(X, T_arm_obj, T_arm_flange, T_cam_obj, off_mm, contradicts)


def mounting_by_motion(T_arm_flange: Floats, T_cam_obj: Floats, reach_mm: float) -> Mounting:
    """The mounting from how the target's image moves with the flange (hand-eye, AX = ZB).

    The rotations first, as the null vector of a linear system, then the translations; from many
    draws of few poses if some might contradict the others.

    Args:
        T_arm_flange, T_cam_obj: (P, 4, 4), P >= 3.
        reach_mm: the size of the target; converts angles into lengths.

    Returns:
        ``T_flange_cam``, ``T_arm_obj``, and which poses contradict them.

    Raises:
        OperationError: ``too-few-poses``, ``poses-alike`` or ``poses-about-one-axis``.
    """
    count = len(T_arm_flange)
    refuse_alike(T_arm_flange)
    best = _mounting_by(np.arange(count), T_arm_flange, T_cam_obj, reach_mm)
    if count > FEW:
        rng = np.random.default_rng(0)
        draws = np.array([rng.permutation(count)[:FEW] for _ in range(DRAWS)])
        X, Z = _hand_eye(T_arm_flange[draws], T_cam_obj[draws])
        off_mm = pose_offsets_mm(T_arm_flange, T_cam_obj, X[:, None], Z[:, None], reach_mm)
        closest = int(np.argmin(np.median(off_mm, axis=1)))
        if median(off_mm[closest]) < median(best.off_mm):
            best = _mounting_by(draws[closest], T_arm_flange, T_cam_obj, reach_mm)
    kept = np.flatnonzero(~best.contradicts)
    if len(kept) >= 3:
        best = _mounting_by(kept, T_arm_flange, T_cam_obj, reach_mm)
    return best


def _mounting_by(
    poses: NDArray[np.int64], T_arm_flange: Floats, T_cam_obj: Floats, reach_mm: float
) -> Mounting:
    """The mounting by some poses, to which all are compared."""
    X, Z = _hand_eye(T_arm_flange[poses], T_cam_obj[poses])
    off_mm = pose_offsets_mm(T_arm_flange, T_cam_obj, X, Z, reach_mm)
    return Mounting(X, Z, T_arm_flange, T_cam_obj, off_mm, find_contradictions(off_mm))


def refuse_alike(T_arm_flange: Floats) -> None:
    """Refuses poses that turn too little to determine the mounting.

    Args:
        T_arm_flange: (P, 4, 4).

    Raises:
        OperationError: ``too-few-poses``, ``poses-alike``, or ``poses-about-one-axis``, which
            names the axis.
    """
    count = len(T_arm_flange)
    if count < 3:
        raise OperationError(
            "too-few-poses",
            message("poses-without-contact-points", count=count),
            message("how-sensor-sits-flange-shows-only"),
            message("take-more-pictures-each-turned-against"),
        )
    R = T_arm_flange[:, :3, :3]
    one, other = np.triu_indices(count, 1)
    turns = vector_from_rotation(R[one].mT @ R[other])
    _, size, axes = np.linalg.svd(turns, full_matrices=False)
    largest = float(np.max(np.linalg.norm(turns, axis=1)))
    if largest < LEAST_TURN_RAD:
        raise OperationError(
            "poses-alike",
            message(
                "flange-turned-most-between-poses",
                turn=quantity(np.degrees(largest), "°", 1),
                count=count,
            ),
            message("poses-all-alike-do-not-tell-mounting"),
            message("take-pictures-turned-20-more-about"),
        )
    if size[1] < LEAST_SECOND_AXIS * size[0]:
        x, y, z = axes[0]
        raise OperationError(
            "poses-about-one-axis",
            message(
                "all-poses-turn-flange-about-one",
                count=count,
                x=signed(x, "", 2),
                y=signed(y, "", 2),
                z=signed(z, "", 2),
            ),
            message("where-sensor-sits-along-axis-cannot"),
            message("add-pictures-turned-about-another-axis"),
        )


def refuse_contradictions(mounting: Mounting, numbers: Sequence[int], thing: Thing) -> None:
    """Refuses the poses if those that agree are not the majority.

    Args:
        numbers: pose numbers.
        thing: the target that the pictures show.

    Raises:
        OperationError: states how far apart the poses place the target.
    """
    out = mounting.contradicts
    some = out.sum() * 2 < len(out) and median(mounting.off_mm) < HOPELESS_MM
    if some or len(out) < 2:
        return
    raise OperationError(
        "poses-contradict",
        message(
            "poses-put-up-apart",
            poses=", ".join(map(str, numbers)),
            thing=thing,
            apart=quantity(mounting.off_mm.max(), "mm", 1),
        ),
        message("half-them-more-contradicting-others-none"),
        message("check-not-moved-every-picture-has-readings", thing=thing),
    )


def mean_transform(T: Floats) -> Floats:
    """The mean (4, 4) of similar transforms (P, 4, 4)."""
    return rigid(nearest_rotation(T[:, :3, :3].mean(axis=0)), T[:, :3, 3].mean(axis=0))


def find_contradictions(off_mm: Floats) -> NDArray[np.bool_]:
    """Mask (P,) of the poses that are further off than the scatter of the better half explains."""
    usual = median(off_mm)
    return np.asarray(off_mm > max(CONTRADICTS_MM, CONTRADICTS_TIMES * usual))


def pose_offsets_mm(
    T_arm_flange: Floats, T_cam_obj: Floats, X: Floats, Z: Floats, reach_mm: float
) -> Floats:
    """(..., P) distance in mm of the object as seen in each pose from its position ``Z``; of one
    mounting (4, 4), or of a stack (..., 1, 4, 4)."""
    off = inverse(Z) @ T_arm_flange @ X @ T_cam_obj
    turn = np.linalg.norm(vector_from_rotation(off[..., :3, :3]), axis=-1)
    return np.asarray(np.hypot(np.linalg.norm(off[..., :3, 3], axis=-1), turn * reach_mm / 2))


def _hand_eye(A: Floats, B: Floats) -> tuple[Floats, Floats]:
    """``X``, ``Z`` (..., 4, 4) with ``A X B = Z`` for poses (..., P, 4, 4), in the least-squares
    sense: both rotations together, then both translations linearly.

    Source:
        Shah (2013), "Solving the robot-world/hand-eye calibration problem using the Kronecker
        product": the rotations are the first singular vectors of a sum of Kronecker products.
    """
    RA, RB, draws = A[..., :3, :3], B[..., :3, :3], A.shape[:-3]
    count = A.shape[-3]
    # the sum of RA kron RB', which takes vec(X) to vec(Z), rows one after another
    pairs = RA.reshape(*draws, count, 9).mT @ RB.reshape(*draws, count, 9)
    products = pairs.reshape(*draws, 3, 3, 3, 3)  # i, k of RA, l, j of RB
    system = np.moveaxis(products, -1, -3).reshape(*draws, 9, 9)
    U, _, Vt = np.linalg.svd(system)
    X, Z = Vt[..., 0, :].reshape(*draws, 3, 3), U[..., :, 0].reshape(*draws, 3, 3)
    sign = np.where(np.linalg.det(X) < 0, -1.0, 1.0)[..., None, None]
    RX, RZ = nearest_rotation(sign * X), nearest_rotation(sign * Z)
    rows = np.concatenate([RA, np.broadcast_to(-np.eye(3), RA.shape)], axis=-1)
    right = -(RA @ RX[..., None, :, :] @ B[..., :3, 3:] + A[..., :3, 3:])
    fit = np.linalg.pinv(rows.reshape(*draws, 3 * count, 6), rcond=3 * count * EPSILON)
    shifts = (fit @ right.reshape(*draws, 3 * count, 1))[..., 0]
    return _rigids(RX, shifts[..., :3]), _rigids(RZ, shifts[..., 3:])


def _rigids(rotations: Floats, translations_mm: Floats) -> Floats:
    """Transforms (..., 4, 4) of rotations (..., 3, 3) and translations (..., 3)."""
    T = np.zeros((*rotations.shape[:-2], 4, 4))
    T[..., :3, :3], T[..., :3, 3], T[..., 3, 3] = rotations, translations_mm, 1.0
    return T
