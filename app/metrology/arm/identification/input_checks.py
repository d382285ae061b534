"""What is wrong with the points: too few, too alike, another arm's, a place that moved."""

from collections.abc import Sequence

import numpy as np

from app.errors import OperationError
from app.metrology.arm.identification.artefact_checks import size_warnings
from app.metrology.arm.identification.least_squares import residuals
from app.metrology.arm.identification.observations import ArmObservations, Bar, StackedObservations
from app.metrology.arm.identification.parameter_selection import parameter_limits
from app.metrology.arm.identification.parameters import (
    parameter_names,
    parameter_values,
    tip_jacobian,
)
from app.metrology.arm.identification.robust_solve import ArmFit
from app.metrology.arm.kinematics import Arm
from app.metrology.transforms import Floats

LEAST_TURN_RAD = np.deg2rad(1.0)
LEAST_SEAT, LEAST_SPHERE, LEAST_PLACES = 6, 6, 4
LEAST_SWING_RAD = np.deg2rad(15.0)
"""The joint that turns most in a seat must turn at least so far."""
OUTLIER_SHARE = 0.25
"""A place with more of its points left out is not to be trusted at all."""
MOVED_SIGMAS = 4.0
"""First and later points of a seat lie so much further apart than single points scatter."""
LEAST_HEAP = 4
LARGEST_SCATTER_MM = 1.0
DIFFERENT = 0.8
"""Share of the points that must have angles of their own."""
NO_SEAT_MM = 50.0
ODD_MM = 5.0
"""A tip that typically goes so far in a seat is no seated tip of this arm."""
MIXED_MM = 100.0
"""No tip of a reasonable arm.json is off by so much."""
FAR_LIMITS = 20.0
"""A parameter that moves by so many times what a workshop gets wrong is worth a look."""


def check_enough(arm: Arm, observations: ArmObservations) -> None:
    """Refuses too few places or points, and places about which the arm hardly moved."""
    if observations.groups_count < LEAST_PLACES:
        raise OperationError(
            "too-few-places",
            f"too few places were touched: {observations.groups_count}",
            f"at least {LEAST_PLACES} seats, spheres and bar positions are needed, so that some "
            "can be held out",
            "Take more places, all over the arm's reach",
        )
    for seat in observations.seats:
        if len(seat.q_rad) < LEAST_SEAT:
            raise _too_few(f"seat {seat.name}", len(seat.q_rad), LEAST_SEAT)
        check_swing(f"seat {seat.name}", arm, seat.q_rad)
    for sphere in observations.spheres:
        if len(sphere.q_rad) < LEAST_SPHERE:
            raise _too_few(f"sphere {sphere.name}", len(sphere.q_rad), LEAST_SPHERE)


def _too_few(label: str, points: int, least: int) -> OperationError:
    return OperationError(
        "too-few-points",
        f"{label} has {points} points",
        f"at least {least} are needed to tell the arm's errors from its own centre",
        "Take more there, or delete its rows",
    )


def check_swing(label: str, arm: Arm, q_rad: Floats) -> None:
    """Refuses a seat about which the arm hardly moved; angles (m, n)."""
    swings = np.ptp(q_rad, axis=0)
    most = int(np.argmax(swings))
    if swings[most] < LEAST_SWING_RAD:
        raise OperationError(
            "arm-hardly-moved",
            f"{label}: no joint turned more than {np.rad2deg(swings[most]):.1f}° "
            f"({arm.joints[most].name})",
            "an arm that stays as it is shows nothing of its errors",
            "Swing the elbow from one side to the other while the tip stays in the seat",
        )


def check_arm_fits(arm: Arm, observations: ArmObservations) -> None:
    """Refuses an arm far from the given one, a joint that never moved, seats of two places."""
    data = observations.stacked
    still = np.ptp(data.q_rad, axis=0) < LEAST_TURN_RAD
    if still.any():
        joint = arm.joints[int(np.argmax(still))].name
        raise OperationError(
            "joint-still",
            f"joint {joint} reads the same in all points",
            "it was not moved, or its encoder is not read",
            "Check the encoder; swing the arm so that every joint turns",
        )
    if len(np.unique(data.q_rad, axis=0)) < DIFFERENT * len(data.q_rad):
        raise OperationError(
            "points-twice",
            "many points have the very same angles",
            "rows were copied, or the arm was held still: the same point twice tells nothing more",
            "Delete what stands there twice",
        )
    tips = {seat.name: tip_jacobian(arm, seat.q_rad)[0] for seat in observations.seats}
    far_mm = {name: _typical_distance(points) for name, points in tips.items()}
    if len(far_mm) > 1 and float(np.median(list(far_mm.values()))) > NO_SEAT_MM:
        name = max(far_mm, key=lambda seat: far_mm[seat])
        raise OperationError(
            "arm-does-not-fit",
            f"by this arm.json the tip goes far while it is in a seat: {far_mm[name]:.0f} mm from "
            f"the middle of seat {name}",
            "the points were taken with another arm, or the file is wrong",
            "Check signs, lengths and the order of the joints in arm.json",
        )
    for name, points in tips.items():
        split, gap_mm = _find_split(points)
        if gap_mm > MIXED_MM:
            raise OperationError(
                "seat-moved",
                f"seat {name}: its points 1 to {split} and {split + 1} to {len(points)} lie "
                f"{gap_mm:.0f} mm apart",
                "they are of two seats, or the seat was carried elsewhere in between"
                + _arm_doubt(arm, [off for other, off in far_mm.items() if other != name]),
                "Give each seat a name of its own",
            )
    _check_bars_kind(arm, observations.bars)


def _arm_doubt(arm: Arm, far_mm: list[float]) -> str:
    """Said where the tip goes far in the other seats, too."""
    if not far_mm or float(np.median(far_mm)) < ODD_MM:
        return ""
    return (
        f", or arm.json is not this arm's: in other seats, too, its tip goes {max(far_mm):.0f} mm"
    )


def _check_bars_kind(arm: Arm, bars: Sequence[Bar]) -> None:
    """Refuses a length in another unit, or of quite another bar."""
    for bar in bars:
        a, b = (np.median(tip_jacobian(arm, q)[0], axis=0) for q in bar.q_rad)
        seen_mm = float(np.linalg.norm(a - b))
        if abs(seen_mm - bar.length_mm) > MIXED_MM:
            raise OperationError(
                "bar-length",
                f"bar {bar.name}, position {bar.position}: by arm.json its ends lie "
                f"{seen_mm:.0f} mm apart, {bar.length_mm:g} mm are given",
                "the length is of another bar or in another unit, or the ends are not this bar's",
                f"Give length_mm of bar {bar.name} in millimetres, and check its rows",
            )


def _typical_distance(points: Floats) -> float:
    """How far half of the points are from their middle, mm."""
    return float(np.median(np.linalg.norm(points - np.median(points, axis=0), axis=1)))


def check_places_fixed(data: StackedObservations, fit: ArmFit) -> None:
    """Refuses a place whose points disagree; says so if it moved in between."""
    vectors = residuals(data, fit.at, fit.scatter_mm).vectors_mm
    sd = _typical_sd(data, fit, vectors)
    for number, place in enumerate(data.places):
        own = data.place_of == number
        points = vectors[own]
        out = int(np.sum(~fit.inliers[own]))
        untrusted = out >= 3 and out > OUTLIER_SHARE * len(points)
        split, gap_mm = _find_split(points) if place.diameter_mm is None else (0, 0.0)
        if gap_mm > max(MOVED_SIGMAS * sd, 1e-2):
            raise OperationError(
                "seat-moved",
                f"{place.label}: its points 1 to {split} and {split + 1} to {len(points)} lie "
                f"{gap_mm * 1e3:.0f} µm apart, while single points scatter by {sd * 1e3:.0f} µm",
                "the seat moved in between",
                "Clamp the seat, and take this place again or delete its rows",
            )
        if untrusted:
            raise OperationError(
                "place-disagrees",
                f"{place.label}: {out} of its {len(points)} points disagree with the rest",
                "the tip was not seated, or the seat was loose, or points of another place are "
                "among them",
                "Take this place again, or delete its rows",
            )


def check_disjoint(observations: ArmObservations, check: ArmObservations) -> None:
    """Refuses to check a fit by points that it saw."""
    fitted = {row.tobytes() for row in observations.stacked.q_rad}
    seen = sum(row.tobytes() in fitted for row in check.stacked.q_rad)
    if seen:
        raise OperationError(
            "check-seen",
            f"{seen} of the {len(check.stacked.q_rad)} points to check by are among those of "
            "the fit",
            "they cannot show whether the arm is better elsewhere",
            "Name a folder of other places, or none: some are then held out in turn",
        )


def check_scatter(fit: ArmFit) -> None:
    """Refuses a fit that explains next to nothing."""
    if fit.scatter_mm > LARGEST_SCATTER_MM:
        raise OperationError(
            "identification-explains-nothing",
            f"even by the best arm the points still scatter by {fit.scatter_mm:.1f} mm",
            "they do not come from an arm of this kind, or the tip was not seated",
            "Check the encoders, arm.json, and how the points were taken",
        )


def identification_warnings(
    arm: Arm, observations: ArmObservations, fit: ArmFit
) -> tuple[str, ...]:
    """What whoever identifies an arm should know beside the result."""
    return *size_warnings(arm, observations, fit), *_far_moves(arm, fit)


def _far_moves(arm: Arm, fit: ArmFit) -> list[str]:
    before, after = parameter_values(arm), parameter_values(fit.at.arm)
    names = parameter_names(arm)
    far: list[str] = []
    for i, limit in zip(fit.moved, parameter_limits(arm, fit.moved), strict=True):
        change = float(after[i] - before[i])
        if abs(change) > FAR_LIMITS * limit:
            angle = names[i].endswith("_rad")
            told = f"{np.rad2deg(change):+.3f}°" if angle else f"{change:+.2f} mm"
            far.append(f"{names[i]} moves by {told}: check arm.json and the bars' lengths")
    return far


def _typical_sd(data: StackedObservations, fit: ArmFit, vectors: Floats) -> float:
    """Per coordinate, how far a point in a seat typically lies from the centre, mm."""
    seated = fit.inliers & ~data.on_sphere
    if not seated.any():
        return fit.scatter_mm
    return float(np.sqrt(np.median(np.sum(vectors[seated] ** 2, axis=1))) / 1.5382)


def _find_split(points: Floats) -> tuple[int, float]:
    """Where a set of points (m, 3) falls apart in time into two heaps, and by how far (mm).

    (0, 0) where it does not: most points of each part must lie by their own heap.
    Medians, so that a few bad points make no heap.
    """
    heaps: tuple[Floats, Floats] | None = None
    strongest = 0.0
    for k in range(LEAST_HEAP, len(points) - LEAST_HEAP + 1):
        first, later = points[:k], points[k:]
        a, b = np.median(first, axis=0), np.median(later, axis=0)
        apart = float(np.linalg.norm(a - b))
        strength = apart * np.sqrt(k * (len(points) - k))
        if strength > strongest and _heap(first, a, apart) and _heap(later, b, apart):
            strongest, heaps = strength, (a, b)
    if heaps is None:
        return 0, 0.0
    a, b = heaps
    nearer_first = np.linalg.norm(points - a, axis=1) < np.linalg.norm(points - b, axis=1)
    # the split that puts most points to their own heap
    right = np.cumsum(np.where(nearer_first, 1, -1))
    return int(np.argmax(right)) + 1, float(np.linalg.norm(a - b))


def _heap(points: Floats, middle: Floats, apart_mm: float) -> bool:
    """Whether three quarters of the points lie nearer to their middle than to the other heap."""
    off = np.linalg.norm(points - middle, axis=1)
    return float(np.mean(off < 0.5 * apart_mm)) >= 0.75
