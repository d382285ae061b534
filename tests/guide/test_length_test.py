"""The guided length test without a station: its order, what a touch counts for, what is named."""

from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
import pytest

from app.errors import OperationError
from app.formats.datasheets.length_standard import LengthPart, LengthStandardFile
from app.formats.performance.plan import LimitPart
from app.guide.common.guided_session import NO_PROVENANCE
from app.guide.performance.entries import DatasheetLimit
from app.guide.performance.length.sequence import LengthEnd, LengthSequence
from app.guide.performance.length.so_far import check_touch, measure_so_far, touches_on_end
from app.guide.performance.plan import build_plan, choose_lengths
from app.guide.performance.state import PerformanceState, apply_row
from app.metrology.arm.kinematics import RobotArm, Tip
from app.metrology.decision import SIMPLE
from app.metrology.performance.pattern import pattern_directions
from app.workflows.performance.length_test import length_features

ARM = RobotArm("Robot", "R-1", Tip(0.0, 0.0, 0.0, 4.0))
BAR = LengthStandardFile(
    name="Bar",
    sphere_diameter_mm=20.0,
    lengths=(LengthPart(length_mm=300.0, standard_uncertainty_um=0.5),),
)
AROUND = pattern_directions(np.array([0.0, 0.0, 1.0]))[[0, 13, 15, 17]]


@dataclass(frozen=True)
class Row:
    kind: str
    payload: dict[str, Any] = field(default_factory=dict)
    number: int = 1
    session_id: str = "t"
    at: str = "2026-11-26T10:00:00Z"


def begun(lengths: int, touches_each: int) -> PerformanceState:
    started = {
        "test": "lengths",
        "calibration_id": "c",
        "gauge": "bar",
        "positions": 1,
        "limits": {"length-touch": {"a_um": 40.0, "k": 10.0, "b_um": None}, "form-touch": 20.0},
    }
    confirmed = {"lengths": lengths, "touches_each": touches_each}
    state = apply_row(PerformanceState(), Row("started", started))
    return apply_row(state, Row("step_confirmed", confirmed))


def reading(tip_mm: np.ndarray) -> np.ndarray:
    return np.array([*tip_mm, 0.0, 0.0, 0.0, 1.0])


def touched(state: PerformanceState, tip_mm: np.ndarray) -> PerformanceState:
    row = {"feature": state.feature, "place": 0, "reading": reading(tip_mm).tolist()}
    return apply_row(state, Row("touched", row))


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
        state = touched(state, np.array([at, 0.0, 0.0]))
    assert state.confirmed == 0
    assert state.end == LengthEnd(1, 1, 2, 0)
    state = touched(state, np.zeros(3))
    assert state.confirmed == 2
    undone = apply_row(state, Row("touch_voided", {"index": 2}))
    assert (len(undone.counted), undone.confirmed) == (2, 2)  # the length stays confirmed
    assert undone.feature == state.touches[2].feature


def test_a_ball_bar_takes_four_touches_all_around_each_sphere() -> None:
    state = begun(1, touches_on_end(BAR))
    centres = (np.array([400.0, 0.0, 200.0]), np.array([400.0, 300.05, 200.0]))
    for centre in centres:
        for n, outward in enumerate(AROUND):
            tip = centre + 12.0 * outward
            assert check_touch(state, BAR, ARM, reading(tip)) == n
            state = touched(state, tip)
            if len(state.counted) % 4 > 0:
                with pytest.raises(OperationError) as refused:
                    check_touch(state, BAR, ARM, reading(tip + 1.0))
                assert refused.value.code == "same-place"
    (value,) = measure_so_far(state, BAR, ARM).values
    assert value.error_um == pytest.approx(50, abs=0.01)


def test_another_sphere_than_that_of_the_length_is_refused() -> None:
    state = begun(1, 4)
    for outward in AROUND:
        state = touched(state, 12.0 * outward)
    with pytest.raises(OperationError) as refused:
        check_touch(state, BAR, ARM, reading(np.array([0.0, 400.0, 0.0])))
    assert refused.value.code == "another-length"
    check_touch(state, BAR, ARM, reading(np.array([0.0, 300.0, 12.0])))


def test_a_standard_far_off_the_drawn_direction_is_named() -> None:
    gauge = BAR.model_copy(update={"sphere_diameter_mm": None, "kind": "step-gauge"})
    state = replace(begun(1, 1), gauge="gauge")
    first, last = measure_so_far(state, gauge, ARM).places_mm[0]
    along = (last - first) / np.linalg.norm(last - first)
    lying = touched(touched(state, first), first + 300.0 * along)
    assert measure_so_far(lying, gauge, ARM).off_deg is None
    across = np.cross(along, [0.0, 0.0, 1.0])
    turned = touched(touched(state, first), first + 300.0 * across)
    assert measure_so_far(turned, gauge, ARM).off_deg == pytest.approx(90)
