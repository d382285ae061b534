"""Whether the focal length differs between pictures, as autofocus and zoom make it: the arm's poses
tell, because a longer focal length makes the target look nearer."""

from collections.abc import Sequence

import numpy as np
from scipy.optimize import least_squares

from crenel.errors import OperationError
from crenel.messages.message import message, quantity
from crenel.metrology.adjustment.core.hand_eye import CONTRADICTS_MM, Mounting
from crenel.metrology.transforms import Floats, apply, inverse, rotations_from_vectors

# Each pose has six readings; the mounting, the target's place and its size have thirteen unknowns.
READINGS, UNKNOWNS, FEWEST_POSES = 6, 13, 6
# Focal lengths of their own are believed if chance explains the gain less often than this, if they
# at least halve the scatter of the target's place, and if they span so much: focusing changes them
# by some percent, and poses of other pictures look like more.
CHANCE, HALVED, LEAST_SPAN, MOST_SPAN = 1e-6, 0.5, 0.0015, 0.06
# A fit is done in twenty steps. One that is not creeps, in a thousand, to a target without a size.
MOST_STEPS = 50
STEP = float(np.sqrt(np.finfo(np.float64).eps))
"""Of a difference, relative to an unknown of 1 or more."""


def refuse_focal_differences(mounting: Mounting, points_mm: Floats, numbers: Sequence[int]) -> None:
    """Refuses pictures whose focal length differs, by a fit with one for each picture (F test).

    Args:
        mounting: of P poses, with the target's poses by one common camera.
        points_mm: (N, 3) of the target, some.
        numbers: of the poses.

    Raises:
        OperationError: ``focal-length-differs``.
    """
    from scipy.special import fdtrc  # slow to import

    count = len(numbers)
    free = (READINGS - 1) * count - UNKNOWNS + 1
    if count < FEWEST_POSES or mounting.contradicts.sum() > count / 2:
        return
    common, _, _ = _fit(mounting, points_mm, with_focal=False)
    own, shares, most_mm = _fit(mounting, points_mm, with_focal=True)
    gain = (common - own) / (count - 1) / max(own / free, 1e-12)
    span = float(np.ptp(shares))
    if (
        not LEAST_SPAN <= span <= MOST_SPAN
        or most_mm > CONTRADICTS_MM  # no focal length explains a pose of another picture
        or own > HALVED**2 * common
        or float(fdtrc(count - 1, free, gain)) > CHANCE
    ):
        return
    middle = (shares.min() + shares.max()) / 2
    longer = [number for number, share in zip(numbers, shares, strict=True) if share > middle]
    raise OperationError(
        "focal-length-differs",
        message(
            "focal-length-differs-between-pictures",
            span=quantity(100 * span, "%", 1),
            poses=", ".join(map(str, longer)),
        ),
        message("autofocus-or-zoom-changed-it"),
        message("fix-focus-and-zoom-and-take-all-pictures-again"),
    )


def _fit(mounting: Mounting, points_mm: Floats, with_focal: bool) -> tuple[float, Floats, float]:
    """The sum of squares (mm^2) that mounting, place and size leave of the points, as of
    ``READINGS`` independent readings a pose; each picture's focal length over the common one,
    less 1 (P,); and how far (mm) a point is off at most.

    The factor multiplies the distance along the camera's axis at which the target was placed.
    """
    A, B = mounting.T_arm_flange, mounting.T_cam_obj
    count, weight = len(A), np.sqrt(READINGS / (3 * len(points_mm)))
    seen = np.array([apply(T, points_mm) for T in B])  # (P, N, 3)
    turn_back, from_arm = mounting.T_flange_cam, inverse(mounting.T_arm_obj)
    middle_mm = points_mm.mean(axis=0)

    def off_mm(p: Floats) -> Floats:
        """(..., 3 P N) of unknowns (..., U)."""
        size = 1 + p[..., 12]  # another size is seen at another distance by all pictures
        at = size[..., None, None, None] * seen
        if with_focal:
            # one focal length for all is that of the common camera
            own = p[..., UNKNOWNS:]
            shares = np.concatenate([own, -own.sum(axis=-1, keepdims=True)], axis=-1)
            at[..., 2] += shares[..., None] * B[:, None, 2, 3]
        turn_sensor, turn_target = (
            rotations_from_vectors(p[..., :3]),
            rotations_from_vectors(p[..., 6:9]),
        )
        in_flange = at @ turn_sensor[..., None, :, :].mT + p[..., None, None, 3:6]
        in_flange = in_flange @ turn_back[:3, :3].T + turn_back[:3, 3]
        in_arm = in_flange @ A[:, :3, :3].mT + A[:, None, :3, 3]
        in_obj = in_arm @ from_arm[:3, :3].T + from_arm[:3, 3] - middle_mm
        placed = in_obj @ turn_target[..., None, :, :].mT + p[..., None, None, 9:12]
        off = placed - size[..., None, None, None] * (points_mm - middle_mm)
        return np.asarray(weight * off.reshape(*p.shape[:-1], -1))

    def slopes(p: Floats) -> Floats:
        """(3 P N, U) by differences, all in one evaluation."""
        steps = STEP * np.maximum(1.0, np.abs(p))
        ahead = off_mm(p + np.diag(steps))
        return np.asarray(((ahead - off_mm(p)) / steps[:, None]).T)

    start = np.zeros(UNKNOWNS + (count - 1 if with_focal else 0))
    found = least_squares(off_mm, start, slopes, x_scale="jac", max_nfev=MOST_STEPS)
    own = found.x[UNKNOWNS:]
    apart_mm = np.linalg.norm(found.fun.reshape(seen.shape) / weight, axis=2)
    return 2 * float(found.cost), np.append(own, -own.sum()), float(apart_mm.max())
