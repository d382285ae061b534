"""What the touches of a contact test say so far. Pure."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from crenel.gauges.contact.evaluate import bar_lengths
from crenel.gauges.contact.guide_sequence import TOUCHES_EACH, features_of
from crenel.gauges.contact.guide_state import ContactState
from crenel.gauges.contact.maths import effective_diameter
from crenel.gauges.plan.document_gauge import GaugeFile
from crenel.gauges.plan.document_length_standard import LengthStandardFile
from crenel.gauges.plan.maths_length_places import (
    TWENTY,
    ArmReach,
    arm_reach,
    propose_places,
    propose_seats,
    reach_share,
)
from crenel.gauges.plan.maths_lengths import MeasuredLength
from crenel.metrology.arm.kinematics import AnyArm, tip_centres, tip_of
from crenel.metrology.probing.seat_articulation import SeatArticulation, seat_articulation
from crenel.metrology.transforms import Floats


@dataclass(frozen=True)
class TouchedSeat:
    """A seat with all its touches."""

    articulation: SeatArticulation
    share: float
    """Its distance from the shoulder as a share of the arm's reach."""


@dataclass(frozen=True, eq=False)
class ContactSoFar:
    """A contact test under way."""

    reach: ArmReach
    seats_mm: Floats
    """(3, 3) proposed places of the seats."""
    placements_mm: Floats
    """(20, 2, 3) proposed places of the bar's ends; (0, 2, 3) without a bar."""
    diameters_um: tuple[float, ...]
    """Errors of the measurements of the master sphere that are complete."""
    seats: tuple[TouchedSeat, ...]
    lengths: tuple[MeasuredLength, ...]
    """The lengths of the placements that are complete."""


def measure_contact_so_far(
    state: ContactState,
    sphere: GaugeFile | None,
    bar: LengthStandardFile | None,
    arm: AnyArm,
) -> ContactSoFar:
    """What is known of a contact test; the arm needs a tip for more than the places."""
    reach = arm_reach(arm)
    tips_mm = group_tips(state, arm)
    placements_mm = np.zeros((0, 2, 3))
    lengths: Sequence[MeasuredLength] = ()
    if bar is not None:
        longest_mm = max(one.length_mm for one in bar.lengths)
        placements_mm = propose_places(reach, longest_mm, TWENTY)
        if tips_mm:
            lengths, _ = bar_lengths(tips_mm, bar, tip_of(arm).diameter_mm, state.artefact)
    return ContactSoFar(
        reach,
        propose_seats(reach),
        placements_mm,
        _diameters_um(tips_mm, sphere, arm),
        tuple(
            TouchedSeat(found, reach_share(reach, found.centre_mm))
            for found in map(seat_articulation, _whole_groups(tips_mm, "seats"))
        ),
        tuple(lengths),
    )


def group_tips(state: ContactState, arm: AnyArm) -> Mapping[str, Floats]:
    """Tip centres (N, 3) by feature, of all touches that count."""
    if not state.counted or arm.tip is None:
        return {}
    tips = tip_centres(arm, np.array([touch.reading for touch in state.counted]))
    features = np.array([touch.feature for touch in state.counted])
    return {name: tips[features == name] for name in dict.fromkeys(features.tolist())}


def _whole_groups(tips_mm: Mapping[str, Floats], step: str) -> list[Floats]:
    found = (tips_mm.get(name, np.zeros((0, 3))) for name in features_of(step))
    return [tips for tips in found if len(tips) >= TOUCHES_EACH[step]]


def _diameters_um(
    tips_mm: Mapping[str, Floats], sphere: GaugeFile | None, arm: AnyArm
) -> tuple[float, ...]:
    groups = _whole_groups(tips_mm, "diameter")
    if sphere is None or sphere.radius_mm is None or not groups:
        return ()
    return effective_diameter(groups, tip_of(arm).diameter_mm, 2 * sphere.radius_mm).errors_um
