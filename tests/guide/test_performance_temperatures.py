"""The temperatures in the journal of a performance test, also in those of earlier versions."""

import pytest

from app.guide.common.guided_session import NO_PROVENANCE
from app.guide.performance.entries import Temperatures
from app.guide.performance.plan import build_plan
from app.metrology.decision import SIMPLE
from app.metrology.performance.temperature import TemperatureLimits
from tests.guide.builders import Row
from tests.guide.performance_sessions import started, state_after
from tests.guide.test_performance_plan import SPHERE

TO_THE_END: tuple[Row, ...] = (
    started("lengths"),
    ("temperature_set", {"celsius": 20.4, "arm_c": 21.0, "expanded_c": 0.4}),
    ("step_confirmed", {"lengths": 1, "touches_each": 1}),
    ("step_confirmed", {}),
)
CONFIRMED = ("step_confirmed", {"artefact_c": 20.4, "arm_c": 21.0})
EVALUATED = ("evaluated", {"result": "pass"})


def test_at_the_end_the_first_temperatures_are_filled_in() -> None:
    state = state_after(*TO_THE_END)
    assert (state.step, state.at_end) == ("temperatures", None)
    assert state.temperatures == Temperatures(20.4, 21.0)
    changed = ("temperature_set", {"celsius": 21.0, "arm_c": 22.0, "expanded_c": 0.0})
    state = state_after(*TO_THE_END, changed)
    assert state.temperatures == Temperatures(21.0, 22.0)
    assert (state.at_begin, state.expanded_c) == (Temperatures(20.4, 21.0), 0.4)
    assert state.artefact is not None
    assert state.artefact.celsius == pytest.approx(20.7)


def test_temperatures_changed_after_the_result_have_it_computed_again() -> None:
    state = state_after(*TO_THE_END, CONFIRMED, EVALUATED)
    assert (state.step, state.result) == ("review", "pass")
    back = ("went_back", {"to": "temperatures"})
    state = state_after(*TO_THE_END, CONFIRMED, EVALUATED, back)
    assert (state.step, state.result, state.at_end) == (
        "temperatures", "", Temperatures(20.4, 21.0),
    )  # fmt: skip
    # an evaluation that was under way when it was left ends later
    late = state_after(*TO_THE_END, CONFIRMED, back, EVALUATED, CONFIRMED)
    assert (late.step, late.result) == ("review", "")


def test_rows_of_earlier_versions_have_no_temperature_of_the_arm() -> None:
    old = ("temperature_set", {"celsius": 20.4, "expanded_c": 0.4})
    assert state_after(started("lengths"), old).at_begin == Temperatures(20.4, None)


def test_the_plan_has_the_temperatures_and_the_limits_of_the_station() -> None:
    state = state_after(started("sphere", gauge="sphere"), TO_THE_END[1])
    plan = build_plan(state, SPHERE, NO_PROVENANCE, SIMPLE, TemperatureLimits(0.5, 3.0))
    assert (plan.artefact_c, plan.arm_c, plan.temperature_sd_c) == (20.4, 21.0, 0.2)
    assert plan.temperature_limits.limits == TemperatureLimits(0.5, 3.0)
