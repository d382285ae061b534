"""What is wrong in a performance test, or should be known by its operator. Pure."""

from crenel.errors import sentence
from crenel.findings import Finding
from crenel.gauges.guide_rules import change_reason
from crenel.gauges.judgement.evaluate_temperatures import find_unsteady, unknown_expansion
from crenel.gauges.plan.maths_temperature import TemperatureSpan
from crenel.gauges.session.entries import Temperatures
from crenel.gauges.session.kind import AnyLive
from crenel.gauges.session.state import PerformanceState
from crenel.guide.common.flow import DECISION_QUALITY, device_findings, strain_findings
from crenel.guide.common.journal import error_from_payload
from crenel.messages.message import message


def list_findings(state: PerformanceState, live: AnyLive) -> list[Finding]:
    """Everything of a running test, the worst trouble first."""
    findings: list[Finding] = []
    if live.trouble:
        findings.append(live.trouble)
    if reason := change_reason(state, live):
        remedy = message("performance-set-is-invalid") if state.frozen else ""
        findings.append(Finding("bad", reason, remedy))
    findings += device_findings(live.arm_link, live.sensor_link)
    if state.step == "artefact":
        findings += _about_artefact(state, live)
    if state.step in state.touching:
        findings += strain_findings(live.strain)
    if state.step in ("artefact", "temperatures"):
        findings += _about_temperatures(state, live)
    findings += live.kind.findings(state, live)
    if state.step == "review":
        findings += _about_result(state, live)
    return findings


def _about_artefact(state: PerformanceState, live: AnyLive) -> list[Finding]:
    findings = list(live.gauges.findings)
    if not live.gauges.known and not live.bars.known:
        text = message("performance-no-artefact", test=state.test)
        findings.append(Finding("attention", text, message("put-certificate-into-folder-gauges")))
    findings += live.kind.artefact_findings(state, live)
    remedy = message("performance-correct-gauge")
    return findings + [Finding("bad", sentence(one), remedy) for one in live.artefact_problems]


def _about_temperatures(state: PerformanceState, live: AnyLive) -> list[Finding]:
    """Why nothing will be decided; at the beginning the test can still wait."""
    begin, end, when = state.at_begin, Temperatures(), "begin"
    if state.step == "temperatures":
        end, when = state.temperatures, "end"
    unsteady = find_unsteady(
        TemperatureSpan(begin.artefact_c, end.artefact_c),
        TemperatureSpan(begin.arm_c, end.arm_c),
        live.temperature_limits,
    )
    remedy = message("performance-let-temperatures-settle", when=when)
    findings = [Finding("attention", sentence(one), remedy) for one in unsteady]
    for artefact in live.artefacts if live.kind.evaluation.has_size else ():
        span = TemperatureSpan(begin.artefact_c, end.artefact_c)
        if unknown := unknown_expansion(artefact, artefact.name or state.gauge, span):
            findings.append(Finding("attention", sentence(unknown)))
    return findings


def _about_result(state: PerformanceState, live: AnyLive) -> list[Finding]:
    if state.failed is not None:
        error = error_from_payload(state.failed)
        return [error.finding("bad")]
    if live.result is None:
        return []
    findings = [
        Finding(DECISION_QUALITY[figure.decision], sentence(figure.reason))
        for figure in live.result.figures
        if figure.decision in ("fail", "uncertain") and figure.value is not None
    ]
    findings += [Finding("bad", sentence(text)) for text in live.result.problems]
    return findings
