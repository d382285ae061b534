"""The contact test: what its steps say, show and ask, and what the simulated operator does."""

from collections.abc import Mapping
from dataclasses import replace
from typing import ClassVar, TypeAlias

import numpy as np

from crenel.findings import Finding
from crenel.gauges.contact.evaluate import LEAST_BAR_TOUCHES, ContactEvaluation
from crenel.gauges.contact.guide_picture import (
    contact_findings,
    contact_instruction,
    contact_number,
    contact_picture,
    contact_title,
)
from crenel.gauges.contact.guide_state import (
    ContactSoFar,
    ContactState,
    group_of,
    measure_contact_so_far,
    touches_of,
)
from crenel.gauges.contact.guide_touches import check_contact
from crenel.gauges.contact.maths import SEAT_POINTS, SPHERE_POINTS
from crenel.gauges.guide import PerformanceGuide
from crenel.gauges.guide_view import PerformancePicture
from crenel.gauges.session.entries import TestScan
from crenel.gauges.session.kind import PerformanceKind, PerformanceLive
from crenel.gauges.session.simulation import confirm
from crenel.gauges.sphere.guide_places import POLE
from crenel.gauges.sphere.maths_pattern import pattern_directions
from crenel.guide.common.simulated_operator import SimulatedOperator
from crenel.guide.common.simulation import ATTEMPTS, StepWork, touch_until_taken
from crenel.guide.common.view import LiveNumber
from crenel.messages.message import Text, message
from crenel.metrology.arm.kinematics import AnyArm
from crenel.metrology.transforms import Floats
from crenel.station.jobs import Progress

Live: TypeAlias = PerformanceLive[ContactSoFar | None]
RIM_DEG = 85.0
SPHERE_PLACES = (0, 5, 7, 9, 11, 18, 20, 22, 24)
"""The places of a sphere among the pattern of 25: the pole, four at 45° and four at the rim."""
BESIDE = 3
"""A posture that was declined is followed by one so many further on."""


def contact_so_far(guide: PerformanceGuide) -> ContactSoFar | None:
    """What the touches say; None before the artefacts were confirmed."""
    state, arm = guide.state_of(ContactState), guide.arm()
    if arm is None:
        return None
    return guide.once(lambda: measure_contact_so_far(state, guide.gauge(), guide.bar(), arm))


def _touch(guide: PerformanceGuide, operator: SimulatedOperator, progress: Progress) -> None:
    """Takes all touches of the present step."""
    of = touches_of(guide.state.step)
    while (done := len(guide.state.of_step)) < of:
        text = message("performance-simulation-contacts", done=done + 1, of=of)
        progress(text, done / of)
        if not guide.simulation_running or not _touch_next(guide, operator, done):
            return
    confirm(guide)


def _touch_next(guide: PerformanceGuide, operator: SimulatedOperator, done: int) -> bool:
    with guide.lock:
        step, so_far = guide.state.step, contact_so_far(guide)
    assert so_far is not None
    number = group_of(step, done)

    def touch(attempt: int) -> bool:
        if step == "diameter":
            place = pattern_directions(POLE, RIM_DEG)[SPHERE_PLACES[done % SPHERE_POINTS]]
            return operator.touch_sphere(place.tolist(), (place + POLE).tolist())
        if step == "seats":
            way = done % SEAT_POINTS + BESIDE * attempt
            return operator.touch_seat(so_far.seats_mm[number].tolist(), way)
        ends = so_far.placements_mm[number]
        end, nth = divmod(done % (2 * LEAST_BAR_TOUCHES), LEAST_BAR_TOUCHES)
        along = ends[1] - ends[0]
        return operator.touch_bar(np.mean(ends, axis=0).tolist(), along.tolist(), end, nth)

    return touch_until_taken(
        guide,
        touch,
        lambda: len(guide.state.touches),
        message("hands-touch-declined-times", index=done + 1, attempts=ATTEMPTS),
    )


class ContactKind(PerformanceKind[PerformanceGuide, ContactState, TestScan, ContactSoFar | None]):
    """The contact test."""

    state = ContactState
    evaluation = ContactEvaluation()
    titles: ClassVar[Mapping[str, Text]] = {
        "diameter": message("performance-step-diameter"),
        "seats": message("performance-step-seats"),
        "bar": message("performance-step-bar"),
    }
    work: ClassVar[Mapping[str, StepWork[PerformanceGuide]]] = dict.fromkeys(
        ContactState.touching, _touch
    )

    def know(self, guide: PerformanceGuide) -> ContactSoFar | None:
        return contact_so_far(guide)

    def title(self, state: ContactState) -> Text:
        if not state.feature:
            return ""
        return contact_title(state.step, group_of(state.step, len(state.of_step)) + 1)

    def instruction(self, state: ContactState, live: Live) -> Text:
        return contact_instruction(state)

    def number(self, state: ContactState, live: Live) -> LiveNumber | None:
        return contact_number(state, live.known)

    def draw(
        self, picture: PerformancePicture, state: ContactState, live: Live
    ) -> PerformancePicture:
        if live.known is None or state.step not in state.between:
            return picture
        return replace(picture, contact=contact_picture(state, live.known))

    def findings(self, state: ContactState, live: Live) -> list[Finding]:
        return contact_findings(state, live.known)

    def place_of(self, guide: PerformanceGuide, arm: AnyArm, reading: Floats) -> int:
        state = guide.state_of(ContactState)
        return check_contact(state, guide.gauge(), guide.bar(), arm, reading)
