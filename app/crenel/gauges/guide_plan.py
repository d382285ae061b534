"""The plan of a guided performance test, from what the operator chose."""

from collections.abc import Mapping
from typing import Any, cast

from crenel.formats.results.decision_rule import RulePart
from crenel.gauges.plan.document import (
    LimitPart,
    PerformancePlan,
    PlatePart,
    SpherePart,
    TemperatureLimitsPart,
)
from crenel.gauges.plan.document_gauge import GaugeFile
from crenel.gauges.plan.document_length_standard import LengthStandardFile
from crenel.gauges.plan.document_symbols import Quantity
from crenel.gauges.plan.maths_lengths import LENGTHS
from crenel.gauges.plan.maths_temperature import TEMPERATURE_LIMITS, TemperatureLimits
from crenel.gauges.session.state import PerformanceState
from crenel.guide.common.datasheet_library import AnyGauge
from crenel.guide.common.guided_session import Provenance
from crenel.messages.message import Text, message
from crenel.metrology.decision import DecisionRule


def quantities_of(state: PerformanceState, artefact: AnyGauge | None) -> tuple[Quantity, ...]:
    """What a test measures, with its artefact."""
    return state.list_quantities(measures_by_scan(state, artefact))


def measures_by_scan(state: PerformanceState, artefact: AnyGauge | None) -> bool:
    """Whether lengths are measured by scan, too: as it was chosen, of a standard with spheres."""
    return state.by_scan and not why_no_scans(state, artefact)


def why_no_scans(state: PerformanceState, artefact: AnyGauge | None) -> Text:
    """Why the lengths of a standard cannot be scanned; empty if they can."""
    if not state.calibration_id:
        return message("there-no-calibration-use-yet")
    if isinstance(artefact, LengthStandardFile) and artefact.sphere_diameter_mm is None:
        return message("only-ball-bars-are-scanned")
    return ""


def build_plan(
    state: PerformanceState,
    artefact: AnyGauge | None,
    provenance: Provenance,
    rule: DecisionRule,
    limits: TemperatureLimits = TEMPERATURE_LIMITS,
    bar: LengthStandardFile | None = None,
) -> PerformancePlan:
    """The plan of the test; ``rule`` and the ``limits`` of temperatures are the station's.

    Args:
        artefact: None only in a contact test that is done without a sphere.
        bar: of a contact test; None if it is done without one.
    """
    gauge = artefact if isinstance(artefact, GaugeFile) else None
    measured = quantities_of(state, artefact)
    fields: Mapping[str, Any] = state.plan_fields(measures_by_scan(state, artefact))
    return PerformancePlan(
        **fields,
        id=state.session_id,
        kind=state.test,
        station=provenance.station,
        operator=provenance.operator(),
        simulated=provenance.is_simulated(),
        started_at=state.started_at,
        edition=state.edition,
        sphere=sphere_part(state.gauge, gauge) if gauge and gauge.shape == "sphere" else None,
        plate=plate_part(state.gauge, gauge) if gauge and gauge.shape == "plane" else None,
        length=artefact if isinstance(artefact, LengthStandardFile) else bar,
        limits=tuple(one for one in limit_parts(state) if one.quantity in measured),
        rule=RulePart.of(rule),
        artefact_c=state.at_begin.artefact_c,
        temperature_sd_c=state.expanded_c / 2,
        arm_c=state.at_begin.arm_c,
        temperature_limits=TemperatureLimitsPart(
            change_c=limits.change_c, from_20_c=limits.from_20_c
        ),
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
        expansion_sd_per_c=gauge.expansion_sd_per_c,
    )


def plate_part(name: str, gauge: GaugeFile) -> PlatePart:
    """The plate as a plan has it."""
    return PlatePart(
        name=gauge.name or name,
        serial_number=gauge.serial_number,
        certificate=gauge.certificate,
        valid_until=gauge.valid_until,
        width_mm=gauge.width_mm,
        flatness_um=gauge.form_um,
        flatness_sd_um=gauge.standard_uncertainty_um or gauge.form_sd_um,
    )


def limit_parts(state: PerformanceState) -> tuple[LimitPart, ...]:
    """The limits that were entered."""
    return tuple(
        LimitPart(quantity=cast(Quantity, name), a_um=limit.a_um, k=limit.k, b_um=limit.b_um)
        for name, limit in state.limits.items()
    )


def choose_lengths(standard: LengthStandardFile) -> LengthStandardFile:
    """A standard with the lengths that are measured: five spread over those that it has, from the
    shortest to the longest; all, if there are no more."""
    known = sorted(standard.lengths, key=lambda one: one.length_mm)
    steps = range(LENGTHS)
    chosen = [known[round(i * (len(known) - 1) / (LENGTHS - 1))] for i in steps]
    return standard.model_copy(update={"lengths": tuple(chosen if len(known) > LENGTHS else known)})
