"""Whether a touch of the contact test can be one of its group. Pure."""

import numpy as np

from crenel.errors import OperationError
from crenel.gauges.contact.guide_state import ContactState, features_of, group_tips
from crenel.gauges.plan.document_gauge import GaugeFile
from crenel.gauges.plan.document_length_standard import LengthStandardFile
from crenel.gauges.plan.maths_lengths import length_of_bar_mm
from crenel.gauges.session.entries import another_length_error, same_place_error
from crenel.gauges.session.off_gauge import refuse_off_sphere
from crenel.messages.limits import beside_limit
from crenel.messages.message import message, quantity
from crenel.metrology.arm.kinematics import AnyArm, Arm, flange_poses, tip_centres, tip_of
from crenel.metrology.fitting.reference_sphere import sphere_centre
from crenel.metrology.probing.reachable import OFF_SPHERE_MM
from crenel.metrology.transforms import Floats, vector_from_rotation

APART = 0.3
"""Touches on a sphere are so many of its radii apart."""
IN_SEAT_MM = 2.0
"""A touch farther from those before is not in their seat."""
OTHER_SEAT_MM = 50.0
"""Two seats are farther apart."""
ARTICULATED_DEG = 10.0
"""From one touch in a seat to any other a joint, or the wrist of an arm that reports poses, turns
by so much at least."""


def check_contact(
    state: ContactState,
    sphere: GaugeFile | None,
    bar: LengthStandardFile | None,
    arm: AnyArm,
    reading: Floats,
) -> int:
    """Which touch of its group this is, from 0.

    Raises:
        OperationError: all are taken, or it cannot be one of the group: too near another one, off
            the sphere, out of the seat, with the arm held as before, or of another length.
    """
    feature = state.feature
    if not feature:
        raise OperationError("not-now", message("performance-all-touched"))
    tip_mm = tip_centres(arm, reading[None])[0]
    groups = group_tips(state, arm)
    before_mm = groups.get(feature, np.zeros((0, 3)))
    if state.step == "seats":
        _check_seat(state, arm, reading, tip_mm, before_mm)
        return len(before_mm)
    if state.step == "diameter":
        assert sphere is not None
        assert sphere.radius_mm is not None
        reach_mm = sphere.radius_mm + tip_of(arm).diameter_mm / 2
        _check_on_sphere(before_mm, tip_mm, reach_mm)
        return len(before_mm)
    assert bar is not None
    assert bar.sphere_diameter_mm is not None
    reach_mm = (bar.sphere_diameter_mm + tip_of(arm).diameter_mm) / 2
    _check_on_sphere(before_mm, tip_mm, reach_mm)
    if feature.endswith("-1"):
        _check_length(bar, groups[feature[:-1] + "0"], tip_mm, reach_mm)
    return len(before_mm)


def _check_on_sphere(before_mm: Floats, tip_mm: Floats, reach_mm: float) -> None:
    if not len(before_mm):
        return
    if np.min(np.linalg.norm(before_mm - tip_mm, axis=1)) < APART * reach_mm:
        raise same_place_error()
    refuse_off_sphere(before_mm, tip_mm, reach_mm)


def _check_seat(
    state: ContactState, arm: AnyArm, reading: Floats, tip_mm: Floats, before_mm: Floats
) -> None:
    if not len(before_mm):
        _check_new_seat(state, arm, tip_mm)
        return
    off_mm = float(np.linalg.norm(tip_mm - before_mm.mean(axis=0)))
    if off_mm > IN_SEAT_MM:
        raise OperationError(
            "off-the-seat",
            message("performance-touch-off-seat", off=quantity(off_mm, "mm", 1)),
            remedy=message("performance-touch-same-seat"),
        )
    earlier = np.array([touch.reading for touch in state.of(state.feature)])
    turned_deg = least_turn_deg(arm, earlier, reading)
    if turned_deg < ARTICULATED_DEG:
        turned, least = beside_limit(turned_deg, ARTICULATED_DEG, "°")
        raise OperationError(
            "same-posture",
            message("performance-arm-not-turned-enough", turned=turned, least=least),
            remedy=message("performance-articulate-arm"),
        )


def _check_new_seat(state: ContactState, arm: AnyArm, tip_mm: Floats) -> None:
    groups = group_tips(state, arm)
    for name in features_of("seats"):
        if name in groups:
            away_mm = float(np.linalg.norm(groups[name].mean(axis=0) - tip_mm))
            if away_mm < OTHER_SEAT_MM:
                raise OperationError(
                    "same-seat",
                    message("performance-seat-not-another", away=quantity(away_mm, "mm")),
                    remedy=message("performance-move-seat"),
                )


def least_turn_deg(arm: AnyArm, earlier: Floats, reading: Floats) -> float:
    """By how much the arm is turned from the nearest of earlier readings (N, k): the largest change
    of a joint, or the turn of the flange if the arm reports poses."""
    if isinstance(arm, Arm):
        return float(np.degrees(np.min(np.max(np.abs(earlier - reading), axis=1))))
    now, before = flange_poses(arm, reading[None])[0, :3, :3], flange_poses(arm, earlier)
    turns = np.linalg.norm(vector_from_rotation(before[:, :3, :3].swapaxes(1, 2) @ now), axis=1)
    return float(np.degrees(np.min(turns)))


def _check_length(
    bar: LengthStandardFile, first_mm: Floats, tip_mm: Floats, reach_mm: float
) -> None:
    found_mm = length_of_bar_mm(sphere_centre(first_mm, 2 * reach_mm), tip_mm)
    wanted_mm = min((one.length_mm for one in bar.lengths), key=lambda mm: abs(mm - found_mm))
    if abs(found_mm - wanted_mm) > OFF_SPHERE_MM + reach_mm:
        raise another_length_error(found_mm, wanted_mm)
