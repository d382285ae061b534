"""What the touches of a length test say so far, and whether a touch can be of its length."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from crenel.errors import OperationError
from crenel.gauges.guide import PerformanceGuide
from crenel.gauges.length.evaluate import (
    LEAST_TOUCHES,
    end_mm,
    lengths_by_touch,
    rocking_problems,
)
from crenel.gauges.length.guide_sequence import BarPass, LengthEnd
from crenel.gauges.length.guide_state import LengthState
from crenel.gauges.plan.document_length_standard import LengthStandardFile
from crenel.gauges.plan.maths_length_places import ArmReach, arm_reach, propose_places
from crenel.gauges.plan.maths_lengths import MeasuredLength
from crenel.gauges.session.entries import another_length_error, same_place_error
from crenel.messages.message import Text, message
from crenel.metrology.arm.kinematics import AnyArm, tip_centres, tip_of
from crenel.metrology.transforms import Floats

OTHER_LENGTH_MM = 2.0
"""A touch that makes a length wrong by more is on another face or sphere."""
APART = 0.5
"""Touches on a sphere are so many of its radii apart."""
DIRECTION_DEG = 30.0
"""A standard that lies farther off its drawn direction is named."""


@dataclass(frozen=True, eq=False)
class LengthsSoFar:
    """A length test under way."""

    standard: LengthStandardFile
    """With the lengths that are measured."""
    reach: ArmReach
    places_mm: Floats
    """(7, 2, 3) proposed places of the standard's ends, arm frame."""
    values: tuple[MeasuredLength, ...]
    """The lengths both of whose ends are touched."""
    scanned: tuple[MeasuredLength, ...]
    """The lengths of the scans that count."""
    rocking: tuple[Text, ...]
    """The places in which the standard rocks."""
    off_deg: float | None
    """By how much the standard in the present place is off the drawn direction; None if it is not
    far off, or not known yet."""


def lengths_so_far(guide: PerformanceGuide) -> LengthsSoFar | None:
    """What is known of the test of a session; None before its standard was confirmed."""
    state, standard, arm = guide.state_of(LengthState), guide.standard(), guide.arm()
    if standard is None or arm is None:
        return None
    return guide.once(lambda: measure_so_far(state, standard, arm))


def touches_on_end(standard: LengthStandardFile) -> int:
    """How many touches an end of a length takes."""
    return 1 if standard.sphere_diameter_mm is None else LEAST_TOUCHES


def measure_so_far(state: LengthState, standard: LengthStandardFile, arm: AnyArm) -> LengthsSoFar:
    """What is known of a length test; the arm needs a tip for more than the places."""
    reach = arm_reach(arm)
    places_mm = propose_places(reach, max(one.length_mm for one in standard.lengths))
    tips_mm = whole_ends(state, arm)
    if not tips_mm:
        return LengthsSoFar(standard, reach, places_mm, (), (), (), None)
    tip_mm = tip_of(arm).diameter_mm
    values, _ = lengths_by_touch(standard, tips_mm, tip_mm, state.artefact)
    scanned = _lengths_by_scan(state, standard)
    rocking = rocking_problems(standard, values, tips_mm, tip_mm)
    rocking += [one for one in rocking_problems(standard, scanned) if one not in rocking]
    off_deg = _off_direction_deg(state, tips_mm, places_mm)
    return LengthsSoFar(
        standard, reach, places_mm, tuple(values), tuple(scanned), tuple(rocking), off_deg
    )


def _lengths_by_scan(state: LengthState, standard: LengthStandardFile) -> list[MeasuredLength]:
    """The lengths of each place and repeat; the scan of a single length stands for it, as in the
    evaluation."""
    good = [scan for scan in state.bar_scans if scan.good]
    alone = {scan.of for scan in good if scan.of.length}
    return [
        MeasuredLength(
            scan.of.place, scan.of.repeat, standard.nominal(number), mm, state.artefact, "scan"
        )
        for scan in good
        for number, mm in scan.lengths_mm
        if scan.of.length or BarPass(scan.of.place, scan.of.repeat, number) not in alone
    ]


def whole_ends(state: LengthState, arm: AnyArm) -> Mapping[str, Floats]:
    """Tip centres (N, 3) by feature, of the ends that have all their touches."""
    if state.sequence is None or not state.counted or arm.tip is None:
        return {}
    each = state.sequence.touches_each
    tips = tip_centres(arm, np.array([touch.reading for touch in state.counted]))
    features = [touch.feature for touch in state.counted]
    return {features[i]: tips[i : i + each] for i in range(0, each * (len(features) // each), each)}


def check_touch(
    state: LengthState, standard: LengthStandardFile, arm: AnyArm, reading: Floats
) -> int:
    """Which touch on its end this is, from 0.

    Raises:
        OperationError: all are taken, it is too near another one on its sphere, or the length would
            be another one than that of the standard.
    """
    end = state.end
    if end is None:
        raise OperationError("not-now", message("performance-all-touched"))
    here = [touch.reading for touch in state.of(end.feature)]
    tips_mm = tip_centres(arm, np.array([*here, reading]))
    reach_mm = 0.0
    if standard.sphere_diameter_mm is not None:
        reach_mm = (standard.sphere_diameter_mm + tip_of(arm).diameter_mm) / 2
        apart_mm = np.linalg.norm(tips_mm[:-1] - tips_mm[-1], axis=1)
        if len(apart_mm) and np.min(apart_mm) < APART * reach_mm:
            raise same_place_error()
    if end.end == 1:
        _check_length(state, standard, arm, end, tips_mm[-1], OTHER_LENGTH_MM + reach_mm)
    return len(here)


def _check_length(
    state: LengthState,
    standard: LengthStandardFile,
    arm: AnyArm,
    end: LengthEnd,
    tip_mm: Floats,
    within_mm: float,
) -> None:
    other = LengthEnd(end.place, end.repeat, end.length, 0).feature
    tips_mm = tip_centres(arm, np.array([touch.reading for touch in state.of(other)]))
    first_mm = end_mm(standard, tips_mm, tip_of(arm).diameter_mm)
    found_mm = float(np.linalg.norm(tip_mm - first_mm))
    wanted_mm = standard.lengths[end.length - 1].length_mm
    if abs(found_mm - wanted_mm) > within_mm:
        raise another_length_error(found_mm, wanted_mm)


def _off_direction_deg(
    state: LengthState, tips_mm: Mapping[str, Floats], places_mm: Floats
) -> float | None:
    place = state.place
    if not place:
        return None
    ends = [LengthEnd(place, 1, 1, which).feature for which in (0, 1)]
    if not all(name in tips_mm for name in ends):
        return None
    first, second = (tips_mm[name].mean(axis=0) for name in ends)
    found, drawn = second - first, places_mm[place - 1, 1] - places_mm[place - 1, 0]
    cosine = abs(float(found @ drawn)) / float(np.linalg.norm(found) * np.linalg.norm(drawn))
    off_deg = float(np.degrees(np.arccos(min(cosine, 1.0))))
    return off_deg if off_deg > DIRECTION_DEG else None
