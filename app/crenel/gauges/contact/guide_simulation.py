"""The simulated operator in a contact test: touches the sphere, the seats and the ball bar."""

from collections.abc import Mapping

import numpy as np

from crenel.gauges.contact.evaluate import LEAST_BAR_TOUCHES
from crenel.gauges.contact.guide_sequence import group_of, touches_of
from crenel.gauges.contact.guide_state import ContactState
from crenel.gauges.contact.maths import SEAT_POINTS, SPHERE_POINTS
from crenel.gauges.guide import PerformanceGuide
from crenel.gauges.session.simulation import confirm
from crenel.gauges.sphere.guide_places import POLE
from crenel.gauges.sphere.maths_pattern import pattern_directions
from crenel.guide.common.simulated_operator import SimulatedOperator
from crenel.guide.common.simulation import ATTEMPTS, StepWork, touch_until_taken
from crenel.messages.message import message
from crenel.station.jobs import Progress

RIM_DEG = 85.0
SPHERE_PLACES = (0, 5, 7, 9, 11, 18, 20, 22, 24)
"""The places of a sphere among the pattern of 25: the pole, four at 45° and four at the rim."""
BESIDE = 3
"""A posture that was declined is followed by one so many further on."""


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
        step, so_far = guide.state.step, guide.contact()
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


CONTACT_WORK: Mapping[str, StepWork[PerformanceGuide]] = dict.fromkeys(
    ContactState.touching, _touch
)
