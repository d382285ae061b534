"""The daily arm check: the tip is held in a seat while the arm swings (single-point articulation).

In space, the figures of ASME B89.4.22: the largest distance from the mean, and 2 s of the
distances. Along each axis, (max - min)/2 and 2 sigma, as the dialogs of arm makers show them; these
are not figures of the standard.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import Text, message, quantity
from crenel.metrology.arm.identification.checks.points import NO_SEAT_MM, check_swing
from crenel.metrology.arm.kinematics import Arm, tips_with_covariances
from crenel.metrology.probing.seat_articulation import seat_articulation
from crenel.metrology.transforms import Floats

LEAST_POINTS = 10

ArticulationVerdict = Literal["pass", "fail", "none"]

THE_SEAT = message("the-seat")


@dataclass(frozen=True)
class ArticulationLimits:
    """The largest values that the operator accepts for each axis; None: no limit."""

    half_range_um: float | None = None
    two_sigma_um: float | None = None


@dataclass(frozen=True)
class Articulation:
    """The result of one seat."""

    points: int
    centre_mm: Floats
    """(3,) mean of the tip centres, arm frame."""
    half_range_um: Floats
    """(3,) (max - min)/2 along x, y, z of the arm frame."""
    two_sigma_um: Floats
    """(3,) twice the standard deviation along x, y, z."""
    encoders_two_sigma_um: Floats
    """(3,) the value that the encoders' noise alone would cause."""
    largest_um: float
    """Largest distance of a tip centre from their mean."""
    two_s_um: float
    """Twice the standard deviation of these distances."""
    swing_rad: Floats
    """(n,) range of each joint angle."""
    verdict: ArticulationVerdict


def check_articulation(
    arm: Arm,
    q_rad: Floats,
    limits: ArticulationLimits | None = None,
    label: Text = THE_SEAT,
) -> Articulation:
    """Single-point articulation: the apparent motion of the tip while a seat holds it.

    Args:
        arm: the arm by its datasheet.
        q_rad: (m, n) encoder angles with the tip in the seat, the arm swung about it.
        limits: the limits of each axis, in µm; None: no verdict.
        label: the name of the seat, for messages.

    Returns:
        The figures in space, (max - min)/2 and 2σ along each axis of the arm frame, all in µm,
        and the verdict, which goes by the axes.

    Raises:
        OperationError: ``too-few-points``, ``arm-hardly-moved`` or ``not-seated``.

    Source:
        ASME B89.4.22-2004 for the figures in space; its test takes three seats of ten points
        each, this check takes one seat.
    """
    q = np.asarray(q_rad, dtype=np.float64)
    if len(q) < LEAST_POINTS:
        raise OperationError(
            "too-few-points",
            message("has-points", label=label, count=len(q)),
            message("least-needed", least=LEAST_POINTS),
            message("take-more-while-arm-swings"),
        )
    check_swing(label, arm, q)
    tips, covariances = tips_with_covariances(arm, q)
    half_range, two_sigma = tip_spread_um(tips)
    if half_range.max() > 1e3 * NO_SEAT_MM:
        raise OperationError(
            "not-seated",
            message(
                "arm-json-tip-goes-fro",
                label=label,
                distance=quantity(half_range.max() / 500, "mm"),
            ),
            message("no-seated-tip-does-points-another"),
            message("give-seat-own-name-check-arm-json"),
        )
    seat = seat_articulation(tips)
    encoders = np.sqrt(np.mean(np.diagonal(covariances, axis1=1, axis2=2), axis=0))
    return Articulation(
        points=len(q),
        centre_mm=seat.centre_mm,
        half_range_um=half_range,
        two_sigma_um=two_sigma,
        encoders_two_sigma_um=2e3 * encoders,
        largest_um=seat.largest_um,
        two_s_um=seat.two_s_um,
        swing_rad=np.ptp(q, axis=0),
        verdict=articulation_verdict(half_range, two_sigma, limits or ArticulationLimits()),
    )


def tip_spread_um(tips_mm: Floats) -> tuple[Floats, Floats]:
    """(max - min)/2 and 2σ of tip centres, along each axis.

    Args:
        tips_mm: (m, 3).

    Returns:
        (3,) and (3,) µm; σ with m - 1, zero for a single point.

    Example:
        >>> tips = np.array([[0.0, 0.0, 0.0], [0.002, 0.0, 0.0], [0.004, 0.0, 0.0]])
        >>> [spread.round(9).tolist() for spread in tip_spread_um(tips)]
        [[2.0, 0.0, 0.0], [4.0, 0.0, 0.0]]
    """
    half_range = np.ptp(tips_mm, axis=0) / 2 * 1e3
    if len(tips_mm) < 2:
        return half_range, np.zeros(3)
    return half_range, 2e3 * np.std(tips_mm, axis=0, ddof=1)


def articulation_verdict(
    half_range: Floats, two_sigma: Floats, limits: ArticulationLimits
) -> ArticulationVerdict:
    """Whether every axis is within the limits that are set."""
    found = [
        bool(np.all(values <= limit))
        for values, limit in (
            (half_range, limits.half_range_um),
            (two_sigma, limits.two_sigma_um),
        )
        if limit is not None
    ]
    if not found:
        return "none"
    return "pass" if all(found) else "fail"
