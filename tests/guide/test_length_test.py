"""The guided length test without a station: its order, what a touch counts for, what is named."""

from dataclasses import replace

import numpy as np
import pytest

from app.formats.datasheets.length_standard import LengthPart
from app.formats.performance.plan import LimitPart
from app.guide.common.guided_session import NO_PROVENANCE
from app.guide.performance.entries import DatasheetLimit
from app.guide.performance.length.sequence import LengthEnd, LengthSequence
from app.guide.performance.length.so_far import check_touch, measure_so_far, touches_on_end
from app.guide.performance.plan import build_plan, choose_lengths
from app.guide.performance.state import PerformanceState
from app.metrology.decision import SIMPLE
from app.metrology.performance.pattern import pattern_directions
from app.workflows.performance.length_test import length_features
from tests.guide.performance_sessions import ROBOT, ball_bar, reading, started, state_after, touched
from tests.refusals import refused_as

BAR = ball_bar(300.0)
AROUND = pattern_directions(np.array([0.0, 0.0, 1.0]))[[0, 13, 15, 17]]


def begun(lengths: int, touches_each: int) -> PerformanceState:
    limits = {"length-touch": {"a_um": 40.0, "k": 10.0, "b_um": None}, "form-touch": 20.0}
    confirmed = ("step_confirmed", {"lengths": lengths, "touches_each": touches_each})
    return state_after(started("lengths", limits=limits), confirmed)


def test_the_order_has_every_end_that_the_evaluation_knows() -> None:
    five = BAR.model_copy(update={"lengths": BAR.lengths * 5})
    plan = build_plan(begun(5, 1), five, NO_PROVENANCE, SIMPLE)
    sequence = LengthSequence(5, 4)
    ends = [sequence.end_at(touch) for touch in range(sequence.touches)]
    assert sequence.measurements == 105
    assert list(dict.fromkeys(end.feature for end in ends if end)) == length_features(plan)
    assert all(ends.count(end) == 4 for end in set(ends))
    assert sequence.end_at(sequence.touches) is None


def test_the_plan_has_the_standard_and_the_limits_of_lengths_alone() -> None:
    state = begun(1, 4)
    assert state.limits["form-touch"] == DatasheetLimit(20.0)
    plan = build_plan(state, BAR, NO_PROVENANCE, SIMPLE)
    assert (plan.kind, plan.sphere, plan.length) == ("lengths", None, BAR)
    assert plan.limits == (LimitPart(quantity="length-touch", a_um=40.0, k=10.0),)


def test_five_lengths_are_spread_over_those_of_the_standard() -> None:
    parts = [LengthPart(length_mm=20.0 * n, standard_uncertainty_um=1.0) for n in range(1, 42)]
    chosen = choose_lengths(BAR.model_copy(update={"lengths": tuple(parts[::-1])}))
    assert [one.length_mm for one in chosen.lengths] == [20, 220, 420, 620, 820]
    assert choose_lengths(BAR) == BAR


def test_the_first_touch_of_the_next_length_confirms_the_one_before() -> None:
    state = begun(2, 1)
    for at in (0.0, 100.0):
        state = touched(state, reading(np.array([at, 0.0, 0.0])))
    assert state.confirmed == 0
    assert state.end == LengthEnd(1, 1, 2, 0)
    state = touched(state, reading(np.zeros(3)))
    assert state.confirmed == 2
    undone = state_after(("touch_voided", {"index": 2}), before=state)
    assert (len(undone.counted), undone.confirmed) == (2, 2)  # the length stays confirmed
    assert undone.feature == state.touches[2].feature


def test_a_ball_bar_takes_four_touches_all_around_each_sphere() -> None:
    state = begun(1, touches_on_end(BAR))
    centres = (np.array([400.0, 0.0, 200.0]), np.array([400.0, 300.05, 200.0]))
    for centre in centres:
        for n, outward in enumerate(AROUND):
            tip = centre + 12.0 * outward
            assert check_touch(state, BAR, ROBOT, reading(tip)) == n
            state = touched(state, reading(tip))
            if len(state.counted) % 4 > 0:
                with refused_as("same-place"):
                    check_touch(state, BAR, ROBOT, reading(tip + 1.0))
    (value,) = measure_so_far(state, BAR, ROBOT).values
    assert value.error_um == pytest.approx(50, abs=0.01)


def test_another_sphere_than_that_of_the_length_is_refused() -> None:
    state = begun(1, 4)
    for outward in AROUND:
        state = touched(state, reading(12.0 * outward))
    with refused_as("another-length"):
        check_touch(state, BAR, ROBOT, reading(np.array([0.0, 400.0, 0.0])))
    check_touch(state, BAR, ROBOT, reading(np.array([0.0, 300.0, 12.0])))


def test_a_standard_far_off_the_drawn_direction_is_named() -> None:
    gauge = BAR.model_copy(update={"sphere_diameter_mm": None, "kind": "step-gauge"})
    state = replace(begun(1, 1), gauge="gauge")
    first, last = measure_so_far(state, gauge, ROBOT).places_mm[0]
    first_touched = touched(state, reading(first))
    along = (last - first) / np.linalg.norm(last - first)
    lying = touched(first_touched, reading(first + 300.0 * along))
    assert measure_so_far(lying, gauge, ROBOT).off_deg is None
    across = np.cross(along, [0.0, 0.0, 1.0])
    turned = touched(first_touched, reading(first + 300.0 * across))
    assert measure_so_far(turned, gauge, ROBOT).off_deg == pytest.approx(90)
