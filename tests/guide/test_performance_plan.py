"""The plan of a guided performance test, from the session, the sphere's file and the station."""

import pytest

from app.formats.datasheets.gauge import GaugeFile
from app.guide.common.guided_session import NO_PROVENANCE
from app.guide.performance.plan import build_plan
from app.guide.performance.state import PerformanceState
from app.metrology.decision import EXPANDED_K2, GUARDED_95, SIMPLE, DecisionRule

SPHERE = GaugeFile(shape="sphere", radius_mm=12.5, standard_uncertainty_um=0.4)
STATE = PerformanceState(session_id="1", started_at="2026-11-26T08:00:00Z", gauge="sphere")


@pytest.mark.parametrize("rule", [GUARDED_95, EXPANDED_K2, SIMPLE])
def test_the_decision_rule_is_the_stations(rule: DecisionRule) -> None:
    assert build_plan(STATE, SPHERE, NO_PROVENANCE, rule).rule.rule == rule


def test_radius_and_its_uncertainty_become_those_of_the_diameter() -> None:
    sphere = build_plan(STATE, SPHERE, NO_PROVENANCE, SIMPLE).sphere
    assert sphere is not None
    assert (sphere.name, sphere.diameter_mm, sphere.diameter_sd_um) == ("sphere", 25.0, 0.8)
