"""The state of a contact test, and what its touches say so far. Pure."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from crenel.gauges.contact.evaluate import (
    FEATURES,
    LEAST_BAR_TOUCHES,
    bar_lengths,
)
from crenel.gauges.contact.maths import (
    SEAT_POINTS,
    SEATS,
    SPHERE_POINTS,
    effective_diameter,
)
from crenel.gauges.plan.document import Kind
from crenel.gauges.plan.document_gauge import GaugeFile
from crenel.gauges.plan.document_length_standard import LengthStandardFile
from crenel.gauges.plan.document_symbols import CONTACT_EDITION, Quantity
from crenel.gauges.plan.maths_length_places import (
    TWENTY,
    ArmReach,
    arm_reach,
    propose_places,
    propose_seats,
    reach_share,
)
from crenel.gauges.plan.maths_lengths import MeasuredLength
from crenel.gauges.session.entries import SphereContact
from crenel.gauges.session.state import ArtefactShape, PerformanceState
from crenel.metrology.arm.kinematics import AnyArm, tip_centres, tip_of
from crenel.metrology.probing.seat_articulation import SeatArticulation, seat_articulation
from crenel.metrology.transforms import Floats

TOUCHES_EACH: Mapping[str, int] = {
    "diameter": SPHERE_POINTS,
    "seats": SEAT_POINTS,
    "bar": LEAST_BAR_TOUCHES,
}
"""Touches of a group."""


def features_of(step: str) -> tuple[str, ...]:
    """The groups of touches of a step."""
    return FEATURES[step]


def touches_of(step: str) -> int:
    """How many touches a step takes.

    Example:
        >>> touches_of("seats")
        30
    """
    return len(FEATURES[step]) * TOUCHES_EACH[step]


def next_feature(step: str, done: int) -> str:
    """The group that a touch (from 0) of a step belongs to; empty once all are done.

    Example:
        >>> next_feature("bar", 4)
        'b1-1'
    """
    group = done // TOUCHES_EACH[step]
    return FEATURES[step][group] if group < len(FEATURES[step]) else ""


def group_of(step: str, done: int) -> int:
    """The group (from 0) that is touched next; of the ball bar both ends are one placement.

    Example:
        >>> group_of("bar", 9), group_of("seats", 9), group_of("seats", 10)
        (1, 0, 1)
    """
    each = TOUCHES_EACH[step] * (2 if step == "bar" else 1)
    return done // each


CONTACT_STEPS = ("diameter", "seats", "bar")


@dataclass(frozen=True)
class ContactState(PerformanceState):
    """Where a contact test stands."""

    test: ClassVar[Kind] = "contact"
    shape: ClassVar[ArtefactShape] = "sphere"
    quantities: ClassVar[tuple[Quantity, ...]] = (
        "effective-diameter",
        "articulation-largest",
        "articulation-two-s",
        "volumetric-largest",
        "volumetric-two-rms",
    )
    edition: ClassVar[str] = CONTACT_EDITION
    between: ClassVar[tuple[str, ...]] = CONTACT_STEPS
    first: ClassVar[tuple[str, ...]] = CONTACT_STEPS
    touching: ClassVar[tuple[str, ...]] = CONTACT_STEPS
    by_touch: ClassVar[bool] = True
    with_bar: ClassVar[bool] = True

    @property
    def steps(self) -> tuple[str, ...]:
        """There is none for an artefact that the test is done without."""
        left_out = {"diameter": not self.gauge, "bar": not self.bar}
        return tuple(step for step in super().steps if not left_out.get(step, False))

    def plan_fields(self, by_scan: bool) -> Mapping[str, object]:
        return {"seats": SEATS}

    def list_quantities(self, by_scan: bool) -> tuple[Quantity, ...]:
        left_out = {"effective": not self.gauge, "volumetric": not self.bar}
        found = self.quantities
        return tuple(one for one in found if not left_out.get(one.partition("-")[0], False))

    @property
    def feature(self) -> str:
        return next_feature(self.step, len(self.of_step)) if self.step in self.touching else ""

    @property
    def of_step(self) -> tuple[SphereContact, ...]:
        if self.step not in self.touching:
            return ()
        parts = set(features_of(self.step))
        return tuple(touch for touch in self.counted if touch.feature in parts)

    @property
    def wanted(self) -> int:
        return touches_of(self.step)


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
