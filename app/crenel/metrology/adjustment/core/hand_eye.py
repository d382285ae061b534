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
    rng = np.random.default_rng(0)
    draws = [np.arange(count)]
    if count > 4:
        draws += [rng.permutation(count)[:4] for _ in range(60)]
    best: Mounting | None = None
    for draw in draws:
        X, Z = _hand_eye(T_arm_flange[draw], T_cam_obj[draw])
        off_mm = pose_offsets_mm(T_arm_flange, T_cam_obj, X, Z, reach_mm)
        if best is None or median(off_mm) < median(best.off_mm):
            best = Mounting(X, Z, T_arm_flange, T_cam_obj, off_mm, find_contradictions(off_mm))
    assert best is not None
    kept = ~best.contradicts
    if kept.sum() >= 3:
        X, Z = _hand_eye(T_arm_flange[kept], T_cam_obj[kept])
        off_mm = pose_offsets_mm(T_arm_flange, T_cam_obj, X, Z, reach_mm)
        best = Mounting(X, Z, T_arm_flange, T_cam_obj, off_mm, find_contradictions(off_mm))
    return best


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
    turns = np.array(
        [
            vector_from_rotation(inverse(A)[:3, :3] @ B[:3, :3])
            for i, A in enumerate(T_arm_flange)
            for B in T_arm_flange[i + 1 :]
        ]
    )
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
    """(P,) distance in mm of the object as seen in each pose from its position ``Z``."""
    off = inverse(Z) @ T_arm_flange @ X @ T_cam_obj
    turn = np.linalg.norm(vector_from_rotation(off[:, :3, :3]), axis=1)
    return np.asarray(np.hypot(np.linalg.norm(off[:, :3, 3], axis=1), turn * reach_mm / 2))


def _hand_eye(A: Floats, B: Floats) -> tuple[Floats, Floats]:
    """``X``, ``Z`` (4, 4) with ``A X B = Z`` in the least-squares sense: both rotations together as
    the smallest singular vector, then both translations linearly."""
    system = []
    for one, other in zip(A, B, strict=True):
        # vec(Ra X Rb) = (Rb' kron Ra) vec(X), columns stacked
        system.append(np.hstack([np.kron(other[:3, :3].T, one[:3, :3]), -np.eye(9)]))
    smallest = np.linalg.svd(np.concatenate(system))[2][-1]
    X, Z = smallest[:9].reshape(3, 3, order="F"), smallest[9:].reshape(3, 3, order="F")
    sign = np.sign(np.linalg.det(X)) or 1.0
    RX, RZ = nearest_rotation(sign * X), nearest_rotation(sign * Z)
    rows = np.concatenate([np.hstack([one[:3, :3], -np.eye(3)]) for one in A])
    right = np.concatenate(
        [-(one[:3, :3] @ RX @ other[:3, 3] + one[:3, 3]) for one, other in zip(A, B, strict=True)]
    )
    shifts = np.linalg.lstsq(rows, right, rcond=None)[0]
    return rigid(RX, shifts[:3]), rigid(RZ, shifts[3:])
