"""The journal and the plan of a guided performance test: positions, temperatures, artefact."""

import pytest

from crenel.gauges.guide_plan import build_plan
from crenel.gauges.length.guide_state import LengthState
from crenel.gauges.plan.document import sphere_features
from crenel.gauges.plan.document_gauge import GaugeFile
from crenel.gauges.plan.maths_temperature import TemperatureLimits
from crenel.gauges.session.entries import Temperatures
from crenel.gauges.sphere.guide_state import SphereState
from crenel.guide.common.guided_session import NO_PROVENANCE
from crenel.metrology.decision import EXPANDED_K2, GUARDED_95, SIMPLE, DecisionRule
from tests.gauges.session.sessions import started, state_after
from tests.guide.builders import Row
from tests.present import present

SPHERE = GaugeFile(shape="sphere", radius_mm=12.5, standard_uncertainty_um=0.4)
STATE = SphereState(session_id="1", started_at="2026-11-26T08:00:00Z", gauge="sphere")
TO_THE_END: tuple[Row, ...] = (
    started("lengths"),
    ("temperature_set", {"celsius": 20.4, "arm_c": 21.0, "expanded_c": 0.4}),
    ("step_confirmed", {"lengths": 1, "touches_each": 1}),
    ("step_confirmed", {}),
)
CONFIRMED = ("step_confirmed", {"artefact_c": 20.4, "arm_c": 21.0})
EVALUATED = ("evaluated", {"result": "pass"})


def test_at_the_end_the_first_temperatures_are_filled_in() -> None:
    state = state_after(LengthState, *TO_THE_END)
    assert (state.step, state.at_end) == ("temperatures", None)
    assert state.temperatures == Temperatures(20.4, 21.0)
    changed = ("temperature_set", {"celsius": 21.0, "arm_c": 22.0, "expanded_c": 0.0})
    state = state_after(LengthState, *TO_THE_END, changed)
    assert state.temperatures == Temperatures(21.0, 22.0)
    assert (state.at_begin, state.expanded_c) == (Temperatures(20.4, 21.0), 0.4)
    assert present(state.artefact).celsius == pytest.approx(20.7)


def test_temperatures_changed_after_the_result_have_it_computed_again() -> None:
    state = state_after(LengthState, *TO_THE_END, CONFIRMED, EVALUATED)
    assert (state.step, state.result) == ("review", "pass")
    back = ("went_back", {"to": "temperatures"})
    state = state_after(LengthState, *TO_THE_END, CONFIRMED, EVALUATED, back)
    assert (state.step, state.result, state.at_end) == (
        "temperatures", "", Temperatures(20.4, 21.0),
    )  # fmt: skip
    # an evaluation that was under way when it was left ends later
    late = state_after(LengthState, *TO_THE_END, CONFIRMED, back, EVALUATED, CONFIRMED)
    assert (late.step, late.result) == ("review", "")


def test_rows_of_earlier_versions_have_no_temperature_of_the_arm() -> None:
    old = ("temperature_set", {"celsius": 20.4, "expanded_c": 0.4})
    assert state_after(LengthState, started("lengths"), old).at_begin == Temperatures(20.4, None)


def test_the_plan_has_the_temperatures_and_the_limits_of_the_station() -> None:
    state = state_after(SphereState, started("sphere", gauge="sphere"), TO_THE_END[1])
    plan = build_plan(state, SPHERE, NO_PROVENANCE, SIMPLE, TemperatureLimits(0.5, 3.0))
    assert (plan.artefact_c, plan.arm_c, plan.temperature_sd_c) == (20.4, 21.0, 0.2)
    assert plan.temperature_limits.limits == TemperatureLimits(0.5, 3.0)


@pytest.mark.parametrize("rule", [GUARDED_95, EXPANDED_K2, SIMPLE])
def test_the_decision_rule_is_the_stations(rule: DecisionRule) -> None:
    assert build_plan(STATE, SPHERE, NO_PROVENANCE, rule).rule.rule == rule


def test_radius_and_its_uncertainty_become_those_of_the_diameter() -> None:
    sphere = present(build_plan(STATE, SPHERE, NO_PROVENANCE, SIMPLE).sphere)
    assert (sphere.name, sphere.diameter_mm, sphere.diameter_sd_um) == ("sphere", 25.0, 0.8)


ARTICULATIONS = 5
START = started("sphere", gauge="sphere")
CONFIRM: Row = ("step_confirmed", {})


def at_position(position: int) -> list[Row]:
    """The rows of all touches and scans at one position."""
    rows: list[Row] = []
    for feature in (name for name in sphere_features(2) if name.startswith(f"p{position}")):
        if feature.endswith("end"):
            for number in range(1, ARTICULATIONS + 1):
                rows += [
                    ("scan_begun", {"articulation": number, "at": "2026-05-01T06:00:00Z"}),
                    ("scan_ended", {"number": (position - 1) * ARTICULATIONS + number}),
                ]
            rows.append(CONFIRM)
        rows.append(("touched", {"feature": feature, "place": 0, "q_rad": [0.0] * 6}))
        if not feature.startswith(f"p{position}-location") or feature.endswith("5"):
            rows.append(CONFIRM)
    return rows


def test_the_second_position_follows_the_first() -> None:
    begin = (START, ("positions_set", {"number": 2}), CONFIRM)
    state = state_after(SphereState, *begin, *at_position(1))
    assert (state.step, state.position, state.feature) == ("pattern", 2, "p2-pattern")
    assert (state.of_step, state.here, len(state.scans)) == ((), (), ARTICULATIONS)
    assert state.articulation == 1
    state = state_after(SphereState, *begin, *at_position(1), *at_position(2))
    assert (state.step, state.position) == ("temperatures", 2)
    assert [touch.feature for touch in state.counted] == sphere_features(2)
    assert [scan.name for scan in state.scans] == [
        f"p{position}-a{number}" for position in (1, 2) for number in range(1, ARTICULATIONS + 1)
    ]


def test_one_position_is_enough_unless_two_are_asked_for() -> None:
    state = state_after(SphereState, START, CONFIRM, *at_position(1))
    assert (state.step, state.position) == ("temperatures", 1)
