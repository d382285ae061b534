"""Selection of the parameters that the observations determine; the others are held, with a
reason."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from crenel.messages.message import Text, message
from crenel.metrology.arm.identification.observations import BASE, TIP, ArmObservations
from crenel.metrology.arm.identification.parameters import (
    ALPHA,
    ERROR_RY,
    TERMS,
    THETA,
    A,
    D,
    parameter_index,
    parameter_values,
    tip_index,
)
from crenel.metrology.arm.kinematics import Arm
from crenel.metrology.arm.near_frames import PARALLEL
from crenel.metrology.transforms import Floats

FixedReason = Literal[
    "base frame",
    "flange frame",
    "marker",
    "tip",
    "error term",
    "redundant",
    "scale",
    "unobserved",
]

REASONS: dict[FixedReason, Text] = {
    "base frame": message("moving-only-moves-whole-arm-space"),
    "flange frame": message("tips-coordinates-moved-instead"),
    "marker": message("markers-place-is-estimated-instead"),
    "tip": message("tip-itself-was-not-measured"),
    "error term": message("denavit-hartenberg-parameters-do-same"),
    "redundant": message("parameters-moved-do-same-together"),
    "scale": message("without-ball-bar-arms-size-observable"),
    "unobserved": message("points-do-not-tell-better-than-tolerance"),
}

# Typical accuracy of a workshop-made arm: a parameter moves only if the points determine it better.
LENGTH_MM, ANGLE_RAD = 0.1, 2e-4
TIP_MM = 1.0
"""The prior of the tip, which is exchangeable and may be unknown."""
LARGEST_SCALE = 30.0
INDEPENDENT = 0.02
"""Share of a parameter's effect that others do not explain; with less, it is redundant."""


@dataclass(frozen=True)
class Candidates:
    """Parameters that could move, the most important first, and those that never move."""

    order: NDArray[np.intp]
    fixed: dict[int, FixedReason]


def candidates_of(arm: Arm, observations: ArmObservations) -> Candidates:
    """The parameters that may move, by what was measured."""
    coordinates = observations.coordinates
    return candidates(
        arm,
        observations.knows_lengths,
        base_known=any(one.frame == BASE for one in coordinates),
        flange_known=any(one.offset_mm is not None for one in coordinates),
        tip_measured=observations.groups_count > 0 or any(one.marker == TIP for one in coordinates),
    )


def candidates(
    arm: Arm,
    with_lengths: bool,
    base_known: bool = False,
    flange_known: bool = False,
    tip_measured: bool = True,
) -> Candidates:
    """The parameters that may move, for the layout of the arm.

    The base frame is that of joint 1 and the flange frame follows the last joint, so their own
    terms are held, and of the last link only the tip moves. D-H parameters are complete if adjacent
    axes are not parallel; otherwise the angle about y between them (an error term, Eq. 3) replaces
    d. Without a calibrated length, the longest link fixes the scale.

    Args:
        with_lengths: lengths were measured: ball bars or coordinates.
        base_known: coordinates in the base frame were measured.
        flange_known: coordinates of a marker were measured whose place on the flange is given.
        tip_measured: something was touched, or the tip's coordinates were measured.
    """
    last = arm.joint_count - 1
    links = range(last)
    tip = [tip_index(arm) + k for k in range(3)]
    order = tip if tip_measured else []
    order += [parameter_index(i, THETA) for i in links if i > 0]
    order += [parameter_index(i, ALPHA) for i in links]
    order += [
        parameter_index(i, ERROR_RY)
        for i in links
        if abs(np.sin(arm.joints[i].alpha_rad)) < PARALLEL
    ]
    order += [parameter_index(i, A) for i in links]
    order += [parameter_index(i, D) for i in links if i > 0]
    if base_known:
        order += [parameter_index(0, THETA), parameter_index(0, D)]
    if flange_known:
        order += [parameter_index(last, term) for term in (D, A, THETA, ALPHA)]
    held: dict[int, FixedReason] = {
        parameter_index(i, term): "error term" for i in range(last) for term in range(4, TERMS)
    }
    instead: FixedReason = "flange frame" if tip_measured else "marker"
    held |= {parameter_index(last, term): instead for term in range(TERMS)}
    held |= dict.fromkeys(tip, "tip")
    held |= {parameter_index(0, D): "base frame", parameter_index(0, THETA): "base frame"}
    if not with_lengths:
        lengths = [parameter_index(i, term) for i in links for term in (A, D)]
        lengths = [index for index in lengths if index in order]
        longest = max(lengths, key=lambda index: abs(float(parameter_values(arm)[index])))
        order.remove(longest)
        held[longest] = "scale"
    for index in order:
        held.pop(index, None)
    return Candidates(np.array(order, dtype=np.intp), held)


def parameter_limits(arm: Arm, indices: NDArray[np.intp], scale: float = 1.0) -> Floats:
    """(p,) standard uncertainty (mm or rad) above which a parameter is not moved.

    Args:
        scale: of the errors of the links of this arm, from ``error_scale``.
    """
    term = indices % TERMS
    angles = np.isin(term, (ALPHA, THETA, ERROR_RY))
    found = scale * np.where(angles, ANGLE_RAD, LENGTH_MM)
    return np.asarray(np.where(indices >= tip_index(arm), TIP_MM, found))


def error_scale(changes: Floats, covariance: Floats, limits: Floats) -> float:
    """How much larger the errors of this arm are than those of a typical one, at least 1.

    The maximum of the likelihood of the changes (p,), which are errors of the arm (``limits`` times
    the scale) and of the estimate (``covariance``).
    """
    if not len(changes):
        return 1.0
    scaled = changes / limits
    # in the directions in which the estimates are independent of each other
    variances, directions = np.linalg.eigh(covariance / np.outer(limits, limits))
    squares = (directions.T @ scaled) ** 2
    scales = np.geomspace(1.0, LARGEST_SCALE, 100)
    spread = scales[:, None] ** 2 + np.maximum(variances, 0.0)
    likelihood = -np.sum(np.log(spread) + squares / spread, axis=1)
    return float(scales[int(np.argmax(likelihood))])


def select_parameters(
    rows: Floats, others: int, order: NDArray[np.intp], worth: Floats
) -> tuple[NDArray[np.intp], dict[int, FixedReason]]:
    """The parameters to move, of those in ``order``, and the reasons to hold the others.

    A parameter is added if the part of its effect that the previous ones do not explain determines
    it better than ``worth`` (a rank decision relative to the noise). Then the least certain
    parameter is removed until all are known better than that.

    Args:
        rows: (r, others + p) the reduced system, in standard deviations.
        others: columns of unknowns that always move.
        order: (p,) parameters of the remaining columns.
        worth: (p,) as returned by ``parameter_limits``.
    """
    scale = np.concatenate([np.ones(others), worth])
    columns = rows * scale
    basis: list[Floats] = []
    for k in range(others):
        left = _orthogonal_part(columns[:, k], basis)
        if (norm := float(np.linalg.norm(left))) > 0:
            basis.append(left / norm)
    moved: list[int] = []
    held: dict[int, FixedReason] = {}
    for k in range(len(order)):
        column = columns[:, others + k]
        left = _orthogonal_part(column, basis)
        norm, whole = float(np.linalg.norm(left)), float(np.linalg.norm(column))
        if norm > 1.0:
            basis.append(left / norm)
            moved.append(k)
        else:
            redundant = norm < INDEPENDENT * whole
            held[int(order[k])] = "redundant" if redundant else "unobserved"
    while moved:
        columns_kept = [*range(others), *(others + k for k in moved)]
        sds = np.sqrt(np.diag(_covariance(columns[:, columns_kept]))[others:])
        worst = int(np.argmax(sds))
        if sds[worst] <= 1.0:
            break
        held[int(order[moved.pop(worst)])] = "unobserved"
    return order[np.array(moved, dtype=np.intp)], held


def system_covariance(rows: Floats) -> Floats:
    """Covariance of all columns of a reduced system, in mm and rad."""
    norms = np.maximum(np.linalg.norm(rows, axis=0), 1e-300)
    return np.asarray(_covariance(rows / norms) / np.outer(norms, norms))


def _covariance(columns: Floats) -> Floats:
    _, s, Vt = np.linalg.svd(columns, full_matrices=False)
    s = np.maximum(s, 1e-12 * s[0])
    return np.asarray((Vt.T / s**2) @ Vt)


def _orthogonal_part(column: Floats, basis: list[Floats]) -> Floats:
    """The part of a column that is orthogonal to a basis; computed twice, against rounding."""
    left = column
    for _ in range(2):
        for direction in basis:
            left = left - (direction @ left) * direction
    return left
