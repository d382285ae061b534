"""The plan of a guided performance test, from what the operator chose."""

from typing import cast

from app.formats.datasheets.gauge import GaugeFile
from app.formats.performance.plan import LimitPart, PerformancePlan, SpherePart
from app.formats.performance.symbols import Quantity
from app.formats.results.decision_rule import RulePart
from app.guide.common.guided_session import Provenance
from app.guide.performance.state import PerformanceState
from app.metrology.decision import DecisionRule


def build_plan(
    state: PerformanceState, gauge: GaugeFile, provenance: Provenance, rule: DecisionRule
) -> PerformancePlan:
    """The plan of the one-sphere test; ``rule`` is the station's."""
    return PerformancePlan(
        id=state.session_id,
        kind="sphere",
        station=provenance.station,
        operator=provenance.operator(),
        simulated=provenance.is_simulated(),
        started_at=state.started_at,
        sphere=sphere_part(state.gauge, gauge),
        positions=state.positions,
        limits=limit_parts(state),
        rule=RulePart.of(rule),
    )


def sphere_part(name: str, gauge: GaugeFile) -> SpherePart:
    """The sphere as a plan has it; a gauge's file states radius and its uncertainty."""
    assert gauge.radius_mm is not None
    return SpherePart(
        name=gauge.name or name,
        serial_number=gauge.serial_number,
        certificate=gauge.certificate,
        valid_until=gauge.valid_until,
        diameter_mm=2 * gauge.radius_mm,
        diameter_sd_um=2 * gauge.standard_uncertainty_um,
        form_um=gauge.form_um,
        form_sd_um=gauge.form_sd_um,
        expansion_per_c=gauge.expansion_per_c,
    )


def limit_parts(state: PerformanceState) -> tuple[LimitPart, ...]:
    """The limits that were entered."""
    return tuple(
        LimitPart(quantity=cast(Quantity, name), a_um=a_um) for name, a_um in state.limits.items()
    )
