"""The guided contact test without a station: its order, what a touch counts for, what is named."""

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.gauges.contact.evaluate import FEATURES
from crenel.gauges.contact.guide_picture import contact_findings, contact_lines, placement_words
from crenel.gauges.contact.guide_state import (
    TOUCHES_EACH,
    ContactState,
    measure_contact_so_far,
    next_feature,
    touches_of,
)
from crenel.gauges.contact.guide_touches import check_contact, least_turn_deg
from crenel.gauges.contact.maths import PLACEMENTS
from crenel.gauges.guide_plan import build_plan, quantities_of
from crenel.gauges.plan.document_gauge import GaugeFile
from crenel.gauges.plan.maths_length_places import TWENTY, ArmReach, propose_places
from crenel.gauges.sphere.maths_pattern import pattern_directions
from crenel.guide.common.guided_session import NO_PROVENANCE
from crenel.metrology.decision import SIMPLE
from crenel.metrology.transforms import Floats
from tests.gauges.session.sessions import ROBOT, ball_bar, reading, started, state_after, touched
from tests.guide.builders import ARM

SPHERE = GaugeFile(shape="sphere", radius_mm=12.5, standard_uncertainty_um=0.4)
BAR = ball_bar(300.0)
PLACES = pattern_directions(np.array([0.0, 0.0, 1.0]))[[0, 5, 7, 9, 11, 18, 20, 22, 24]]
CENTRE = np.array([500.0, 0.0, 200.0])


def begun(gauge: str = "sphere", bar: str = "bar") -> ContactState:
    return state_after(
        ContactState, started("contact", gauge=gauge, bar=bar), ("step_confirmed", {})
    )


def confirmed(state: ContactState) -> ContactState:
    return state_after(ContactState, ("step_confirmed", {}), before=state)


def on_sphere(state: ContactState, count: int) -> ContactState:
    for place in PLACES[:count]:
        state = touched(state, reading(CENTRE + 14.5 * place))
    return state


def refusal(state: ContactState, of_arm: Floats) -> str:
    with pytest.raises(OperationError) as refused:
        check_contact(state, SPHERE, BAR, ROBOT, of_arm)
    return refused.value.code


def test_the_order_has_every_group_that_the_evaluation_knows() -> None:
    assert [touches_of(step) for step in FEATURES] == [27, 30, 160]
    assert next_feature("seats", 30) == ""
    assert next_feature("bar", 159) == "b20-1"


def test_a_step_ends_only_with_all_its_touches() -> None:
    state = on_sphere(begun(), 9)
    assert state.feature == "d2"
    assert len(state.of_step) == 9
    assert [state.step, confirmed(state).step] == ["diameter", "seats"]


@pytest.mark.parametrize(
    ("gauge", "bar", "steps"),
    [
        ("sphere", "bar", ["diameter", "seats", "bar"]),
        ("", "bar", ["seats", "bar"]),
        ("sphere", "", ["diameter", "seats"]),
    ],
)
def test_what_an_artefact_is_for_is_left_out_without_it(
    gauge: str, bar: str, steps: list[str]
) -> None:
    state, found = begun(gauge, bar), []
    while state.step != "temperatures":
        found.append(state.step)
        state = confirmed(state)
    assert found == steps
    measured = quantities_of(state, None)
    assert ("effective-diameter" in measured) == bool(gauge)
    assert ("volumetric-two-rms" in measured) == bool(bar)


def test_the_plan_is_one_of_the_standard_with_both_artefacts() -> None:
    plan = build_plan(begun(), SPHERE, NO_PROVENANCE, SIMPLE, bar=BAR)
    assert (plan.kind, plan.edition, plan.length) == ("contact", "B89.4.22", BAR)
    assert plan.sphere is not None
    assert plan.sphere.diameter_mm == 25.0
    without = build_plan(begun(gauge=""), None, NO_PROVENANCE, SIMPLE, bar=BAR)
    assert without.sphere is None


def test_touches_on_the_sphere_are_apart_and_on_it() -> None:
    state = on_sphere(begun(), 5)
    assert check_contact(state, SPHERE, BAR, ROBOT, reading(CENTRE + 14.5 * PLACES[5])) == 5
    assert refusal(state, reading(CENTRE + 14.5 * PLACES[1])) == "same-place"
    six = on_sphere(begun(), 6)
    assert refusal(six, reading(CENTRE + 20.0 * PLACES[6])) == "off-the-sphere"
    two = on_sphere(begun(), 2)
    assert refusal(two, reading(CENTRE + np.array([60.0, 0, 0]))) == "off-the-sphere"


def test_the_arm_is_articulated_in_a_seat_and_the_tip_stays_in_it() -> None:
    state = touched(begun(gauge=""), reading(CENTRE))
    assert check_contact(state, None, BAR, ROBOT, reading(CENTRE + 0.05, 20.0)) == 1
    assert refusal(state, reading(CENTRE + 0.05, 4.0)) == "same-posture"
    assert refusal(state, reading(CENTRE + 5.0, 20.0)) == "off-the-seat"


def test_the_next_seat_is_another_one() -> None:
    state = begun(gauge="")
    for number in range(10):
        state = touched(state, reading(CENTRE, 20.0 * number))
    assert state.feature == "s2"
    assert refusal(state, reading(CENTRE + 1.0, 5.0)) == "same-seat"
    assert check_contact(state, None, BAR, ROBOT, reading(CENTRE + 100.0)) == 0


def test_joints_tell_how_much_an_arm_was_turned() -> None:
    earlier, now = np.zeros((2, ARM.joint_count)), np.zeros(ARM.joint_count)
    earlier[1, 2], now[2] = 0.5, 0.4
    assert least_turn_deg(ARM, earlier, now) == pytest.approx(np.degrees(0.1))


def on_bar(state: ContactState, length_mm: float) -> ContactState:
    for end in (0.0, length_mm):
        for place in PLACES[[0, 5, 6, 7]]:
            state = touched(state, reading(CENTRE + [end, 0, 0] + 12.0 * place))
    return state


def test_a_placement_is_compared_with_the_nearest_length() -> None:
    state = confirmed(begun(gauge=""))
    first = on_bar(state, 300.02)
    so_far = measure_contact_so_far(first, None, BAR, ROBOT)
    (found,) = so_far.lengths
    assert found.error_um == pytest.approx(20.0, abs=0.5)
    lines = contact_lines(first, so_far)
    assert [line.state for line in lines[:3]] == ["done", "now", "todo"]
    assert "300.020 mm" in str(lines[0].text)


def test_another_length_is_refused() -> None:
    state = confirmed(begun(gauge=""))
    for place in PLACES[[0, 5, 6, 7]]:
        state = touched(state, reading(CENTRE + 12.0 * place))
    assert state.feature == "b1-1"
    far = CENTRE + [330.0, 0, 0] + 12.0 * PLACES[0]
    assert refusal(state, reading(far)) == "another-length"


def test_seats_that_are_not_near_and_far_enough_are_named() -> None:
    state = begun(gauge="")
    rows = np.random.default_rng(1).normal(0, 0.2, (TOUCHES_EACH["seats"], ARM.joint_count))
    for row in rows:
        state = touched(state, row)
    so_far = measure_contact_so_far(state, None, BAR, ARM)
    assert so_far.seats[0].share > 0.3
    (finding,) = contact_findings(state, so_far)
    assert "asks for at most 20 %" in str(finding.text)


def test_every_placement_is_described_as_it_is_drawn() -> None:
    reach = ArmReach(np.array([0.0, 0.0, 300.0]), 1200.0, known=True)
    places_mm = propose_places(reach, 500.0, TWENTY)
    described = [str(placement_words(number)) for number in range(1, PLACEMENTS + 1)]
    assert len(set(described)) == PLACEMENTS
    for words, (first, last) in zip(described, places_mm, strict=True):
        y_mm = (first + last)[1] / 2
        assert ("° to the left" in words) == (y_mm > 1)
        assert ("° to the right" in words) == (y_mm < -1)
        rise_mm = last[2] - first[2]
        assert ("vertical" in words) == (rise_mm > 499)
        assert ("horizontal" in words) == (abs(rise_mm) < 1)
