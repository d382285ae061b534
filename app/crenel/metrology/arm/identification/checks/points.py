"""Checks of the points: too few, too similar, or of another arm."""

from collections.abc import Sequence

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import Text, join, message, quantity, rounded, signed
from crenel.metrology.arm.identification.checks.artefacts import size_warnings
from crenel.metrology.arm.identification.checks.places import find_split
from crenel.metrology.arm.identification.observations import (
    ArmObservations,
    Bar,
    StackedObservations,
)
from crenel.metrology.arm.identification.parameter_selection import parameter_limits
from crenel.metrology.arm.identification.parameters import (
    parameter_names,
    parameter_values,
)
from crenel.metrology.arm.identification.robust_solve import ArmFit
from crenel.metrology.arm.kinematics import Arm, tip_centres
from crenel.metrology.robust import median
from crenel.metrology.transforms import Floats

LEAST_TURN_RAD = np.deg2rad(1.0)
LEAST_SEAT, LEAST_SPHERE, LEAST_PLACES = 6, 6, 4
LEAST_SWING_RAD = np.deg2rad(15.0)
"""Minimum range of the joint that turns most in a seat."""
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
    if observations.places_count < LEAST_PLACES:
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
    q_rad = data.all_q_rad
    still = np.ptp(q_rad, axis=0) < LEAST_TURN_RAD
    if still.any():
        joint = arm.joints[int(np.argmax(still))].name
        raise OperationError(
            "joint-still",
            message("joint-reads-same-all-points", joint=joint),
            message("not-moved-or-encoder-not-read"),
            message("check-encoder-swing-arm-so-every"),
        )
    if _different_rows(data) < DIFFERENT * len(q_rad):
        raise OperationError(
            "points-twice",
            message("many-points-have-very-same-angles"),
            message("rows-copied-or-arm-not-moved"),
            message("delete-what-stands-there-twice"),
        )
    tips = {seat.name: tip_centres(arm, seat.q_rad) for seat in observations.seats}
    far_mm = {name: _typical_distance(points) for name, points in tips.items()}
    if len(far_mm) > 1 and median(list(far_mm.values())) > NO_SEAT_MM:
        name = max(far_mm, key=lambda seat: far_mm[seat])
        raise OperationError(
            "arm-does-not-fit",
            message("arm-json-tip-goes-far-while", far=quantity(far_mm[name], "mm"), name=name),
            message("points-were-taken-another-arm-file"),
            message("check-signs-lengths-joints-order"),
        )
    for name, points in tips.items():
        split, gap_mm = find_split(points)
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


def _different_rows(data: StackedObservations) -> int:
    """Number of points with angles of their own; two markers may be measured in one posture."""
    found = data.coordinates
    measured = np.column_stack([found.q_rad, found.marker_of, found.frame_of])
    return len(np.unique(data.q_rad, axis=0)) + len(np.unique(measured, axis=0))


def _split_reason(far_mm: list[float]) -> Text:
    """Why the points of a seat are apart; the arm is the cause if the tip moves far in other seats
    too."""
    if not far_mm or median(far_mm) < ODD_MM:
        return message("two-seats-or-seat-carried")
    return message("two-seats-or-seat-carried-or-arm", far=quantity(max(far_mm), "mm"))


def _check_bars_kind(arm: Arm, bars: Sequence[Bar]) -> None:
    """Refuses a length in another unit, or of a different bar."""
    for bar in bars:
        a, b = (np.median(tip_centres(arm, q), axis=0) for q in bar.q_rad)
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
    return median(np.linalg.norm(points - np.median(points, axis=0), axis=1))


def check_disjoint(observations: ArmObservations, check: ArmObservations) -> None:
    """Refuses to check a fit with points that were in the fit."""
    fitted = {row.tobytes() for row in observations.stacked.all_q_rad}
    checking = check.stacked.all_q_rad
    shared = sum(row.tobytes() in fitted for row in checking)
    if shared:
        raise OperationError(
            "check-seen",
            message("points-check-among-those-fit", shared=shared, count=len(checking)),
            message("they-cannot-show-whether-arm-better"),
            message("name-folder-other-places-none-some"),
        )


def check_scatter(fit: ArmFit) -> None:
    """Refuses a fit that explains almost nothing."""
    scatter_mm = fit.scatter.touch_mm
    if scatter_mm > LARGEST_SCATTER_MM:
        raise OperationError(
            "identification-explains-nothing",
            message("even-best-arm-points-still-scatter", scatter=quantity(scatter_mm, "mm", 1)),
            message("not-of-such-an-arm-or-tip-not-seated"),
            message("check-encoders-arm-json-how-points"),
        )


def identification_warnings(
    arm: Arm, observations: ArmObservations, fit: ArmFit
) -> tuple[Text, ...]:
    """Findings for the user in addition to the result."""
    far_m = quantity(arm.frames_moved_mm / 1000, "m", 0)
    return (
        *([message("frames-moved-near-the-arm", far=far_m)] if arm.frames_moved_mm else []),
        *size_warnings(arm, observations, fit),
        *_far_moves(arm, observations, fit),
        *(_doubt(observations.stacked, touches) for touches in fit.doubtful),
    )


def _doubt(data: StackedObservations, touches: Sequence[int]) -> Text:
    """That one of these is off while nothing tells which."""
    places = [data.places[data.place_of[i]] for i in touches]
    named = [
        message("point-at-place", place=place.label, number=i - place.rows.start + 1)
        for i, place in zip(touches, places, strict=True)
    ]
    return message("one-of-touches-off", points=join(named, "; "))


def _far_moves(arm: Arm, observations: ArmObservations, fit: ArmFit) -> list[Text]:
    before, after = parameter_values(arm), parameter_values(fit.at.arm)
    names = parameter_names(arm)
    far: list[Text] = []
    beside = "bars" if observations.bars else "marker" if observations.coordinates else "arm"
    for i, limit in zip(fit.moved, parameter_limits(arm, fit.moved), strict=True):
        change = float(after[i] - before[i])
        if abs(change) > FAR_LIMITS * limit:
            angle = names[i].endswith("_rad")
            by = signed(np.rad2deg(change), "°", 3) if angle else signed(change, "mm", 2)
            far.append(message("moves-check-arm-json", name=names[i], change=by, beside=beside))
    return far
