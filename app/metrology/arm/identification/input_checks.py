"""Checks of the points: too few, too similar, of another arm, or a place that moved."""

from collections.abc import Sequence

import numpy as np

from app.errors import OperationError
from app.messages.message import Text, message, quantity, rounded, signed
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
"""Minimum range of the joint that turns most in a seat."""
OUTLIER_SHARE = 0.25
"""A place with a larger share of excluded points is not trusted."""
MOVED_SIGMAS = 4.0
"""Distance of first and later points of a seat relative to the scatter of single points."""
LEAST_HEAP = 4
LARGEST_SCATTER_MM = 1.0
DIFFERENT = 0.8
"""Minimum share of the points with distinct angles."""
NO_SEAT_MM = 50.0
ODD_MM = 5.0
"""If the tip typically moves this far in a seat, it is not a seated tip of this arm."""
MIXED_MM = 100.0
"""The tip of a reasonable arm.json is not off by this much."""
FAR_LIMITS = 20.0
"""A parameter that moves by this multiple of the usual workshop error is reported."""


def check_enough(arm: Arm, observations: ArmObservations) -> None:
    """Refuses too few places or points, and places at which the arm hardly moved."""
    if observations.groups_count < LEAST_PLACES:
        raise OperationError(
            "too-few-places",
            message("too-few-places-were-touched", count=observations.groups_count),
            message("least-seats-spheres-bar-positions-needed", least_places=LEAST_PLACES),
            message("take-more-places-all-over-arms"),
        )
    for seat in observations.seats:
        if len(seat.q_rad) < LEAST_SEAT:
            raise _too_few(message("seat-named", name=seat.name), len(seat.q_rad), LEAST_SEAT)
        check_swing(message("seat-named", name=seat.name), arm, seat.q_rad)
    for sphere in observations.spheres:
        if len(sphere.q_rad) < LEAST_SPHERE:
            raise _too_few(
                message("sphere-named", name=sphere.name), len(sphere.q_rad), LEAST_SPHERE
            )


def _too_few(label: Text, points: int, least: int) -> OperationError:
    return OperationError(
        "too-few-points",
        message("has-points", label=label, count=points),
        message("least-needed-tell-arms-errors-own", least=least),
        message("take-more-there-delete-rows"),
    )


def check_swing(label: Text, arm: Arm, q_rad: Floats) -> None:
    """Refuses a seat at which the arm hardly moved; angles (m, n)."""
    swings = np.ptp(q_rad, axis=0)
    most = int(np.argmax(swings))
    if swings[most] < LEAST_SWING_RAD:
        raise OperationError(
            "arm-hardly-moved",
            message(
                "no-joint-turned-more-than",
                label=label,
                swing=quantity(np.rad2deg(swings[most]), "°", 1),
                joint=arm.joints[most].name,
            ),
            message("arm-stays-shows-nothing-errors"),
            message("swing-elbow-one-side-other-while"),
        )


def check_arm_fits(arm: Arm, observations: ArmObservations) -> None:
    """Refuses an arm far from the given one, a joint that never moved, and seats with points of two
    places."""
    data = observations.stacked
    still = np.ptp(data.q_rad, axis=0) < LEAST_TURN_RAD
    if still.any():
        joint = arm.joints[int(np.argmax(still))].name
        raise OperationError(
            "joint-still",
            message("joint-reads-same-all-points", joint=joint),
            message("moved-encoder-read"),
            message("check-encoder-swing-arm-so-every"),
        )
    if len(np.unique(data.q_rad, axis=0)) < DIFFERENT * len(data.q_rad):
        raise OperationError(
            "points-twice",
            message("many-points-have-very-same-angles"),
            message("rows-were-copied-arm-held-still"),
            message("delete-what-stands-there-twice"),
        )
    tips = {seat.name: tip_jacobian(arm, seat.q_rad)[0] for seat in observations.seats}
    far_mm = {name: _typical_distance(points) for name, points in tips.items()}
    if len(far_mm) > 1 and float(np.median(list(far_mm.values()))) > NO_SEAT_MM:
        name = max(far_mm, key=lambda seat: far_mm[seat])
        raise OperationError(
            "arm-does-not-fit",
            message("arm-json-tip-goes-far-while", far=quantity(far_mm[name], "mm"), name=name),
            message("points-were-taken-another-arm-file"),
            message("check-signs-lengths-joints-order"),
        )
    for name, points in tips.items():
        split, gap_mm = _find_split(points)
        if gap_mm > MIXED_MM:
            raise OperationError(
                "seat-moved",
                message(
                    "seat-points-1-lie-apart",
                    name=name,
                    split=split,
                    next=split + 1,
                    points=len(points),
                    gap=quantity(gap_mm, "mm"),
                ),
                _split_reason([off for other, off in far_mm.items() if other != name]),
                message("give-each-seat-name-own"),
            )
    _check_bars_kind(arm, observations.bars)


def _split_reason(far_mm: list[float]) -> Text:
    """Why the points of a seat are apart; the arm is the cause if the tip moves far in other seats
    too."""
    if not far_mm or float(np.median(far_mm)) < ODD_MM:
        return message("two-seats-or-seat-carried")
    return message("two-seats-or-seat-carried-or-arm", far=quantity(max(far_mm), "mm"))


def _check_bars_kind(arm: Arm, bars: Sequence[Bar]) -> None:
    """Refuses a length in another unit, or of a different bar."""
    for bar in bars:
        a, b = (np.median(tip_jacobian(arm, q)[0], axis=0) for q in bar.q_rad)
        measured_mm = float(np.linalg.norm(a - b))
        if abs(measured_mm - bar.length_mm) > MIXED_MM:
            raise OperationError(
                "bar-length",
                message(
                    "bar-position-arm-json-ends-lie",
                    name=bar.name,
                    position=bar.position,
                    measured=quantity(measured_mm, "mm"),
                    length=rounded(bar.length_mm, "mm"),
                ),
                message("length-another-bar-another-unit-ends"),
                message("give-length-mm-bar-millimetres-check", name=bar.name),
            )


def _typical_distance(points: Floats) -> float:
    """Median distance of the points from their middle, mm."""
    return float(np.median(np.linalg.norm(points - np.median(points, axis=0), axis=1)))


def check_places_fixed(data: StackedObservations, fit: ArmFit) -> None:
    """Refuses a place whose points disagree; reports if it moved in between."""
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
                message(
                    "points-1-lie-apart-while-single",
                    label=place.label,
                    split=split,
                    next=split + 1,
                    points=len(points),
                    gap=quantity(1e3 * gap_mm, "µm"),
                    sd=quantity(1e3 * sd, "µm"),
                ),
                message("seat-moved-between"),
                message("clamp-seat-take-place-again-delete"),
            )
        if untrusted:
            raise OperationError(
                "place-disagrees",
                message("points-disagree-rest", label=place.label, out=out, points=len(points)),
                message("tip-seated-seat-loose-points-another"),
                message("take-place-again-delete-rows"),
            )


def check_disjoint(observations: ArmObservations, check: ArmObservations) -> None:
    """Refuses to check a fit with points that were in the fit."""
    fitted = {row.tobytes() for row in observations.stacked.q_rad}
    shared = sum(row.tobytes() in fitted for row in check.stacked.q_rad)
    if shared:
        raise OperationError(
            "check-seen",
            message("points-check-among-those-fit", shared=shared, count=len(check.stacked.q_rad)),
            message("they-cannot-show-whether-arm-better"),
            message("name-folder-other-places-none-some"),
        )


def check_scatter(fit: ArmFit) -> None:
    """Refuses a fit that explains almost nothing."""
    if fit.scatter_mm > LARGEST_SCATTER_MM:
        raise OperationError(
            "identification-explains-nothing",
            message(
                "even-best-arm-points-still-scatter", scatter=quantity(fit.scatter_mm, "mm", 1)
            ),
            message("they-do-come-arm-kind-tip"),
            message("check-encoders-arm-json-how-points"),
        )


def identification_warnings(
    arm: Arm, observations: ArmObservations, fit: ArmFit
) -> tuple[Text, ...]:
    """Findings for the user in addition to the result."""
    return *size_warnings(arm, observations, fit), *_far_moves(arm, fit)


def _far_moves(arm: Arm, fit: ArmFit) -> list[Text]:
    before, after = parameter_values(arm), parameter_values(fit.at.arm)
    names = parameter_names(arm)
    far: list[Text] = []
    for i, limit in zip(fit.moved, parameter_limits(arm, fit.moved), strict=True):
        change = float(after[i] - before[i])
        if abs(change) > FAR_LIMITS * limit:
            angle = names[i].endswith("_rad")
            by = signed(np.rad2deg(change), "°", 3) if angle else signed(change, "mm", 2)
            far.append(message("moves-check-arm-json-bars-lengths", name=names[i], change=by))
    return far


def _typical_sd(data: StackedObservations, fit: ArmFit, vectors: Floats) -> float:
    """Typical distance of a point in a seat from the centre, per coordinate, mm."""
    seated = fit.inliers & ~data.on_sphere
    if not seated.any():
        return fit.scatter_mm
    return float(np.sqrt(np.median(np.sum(vectors[seated] ** 2, axis=1))) / 1.5382)


def _find_split(points: Floats) -> tuple[int, float]:
    """The index at which points (m, 3) split in time into two clusters, and the distance of these
    (mm).

    (0, 0) if they do not split: most points of each part must be close to their own cluster.
    Medians are used, so that a few bad points do not form a cluster.
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
    # the split that assigns most points to their own cluster
    right = np.cumsum(np.where(nearer_first, 1, -1))
    return int(np.argmax(right)) + 1, float(np.linalg.norm(a - b))


def _heap(points: Floats, middle: Floats, apart_mm: float) -> bool:
    """Whether three quarters of the points are closer to their middle than to the other cluster."""
    off = np.linalg.norm(points - middle, axis=1)
    return float(np.mean(off < 0.5 * apart_mm)) >= 0.75
