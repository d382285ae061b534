"""What is wrong in a performance test, or should be known by its operator. Pure."""

from crenel.errors import sentence
from crenel.findings import Finding
from crenel.gauges.contact.guide_picture import contact_findings
from crenel.gauges.guide_live import PerformanceLive
from crenel.gauges.guide_rules import change_reason, missing_patches
from crenel.gauges.guide_state import TOUCHING, PerformanceState
from crenel.gauges.judgement.evaluate_temperatures import find_unsteady, unknown_expansion
from crenel.gauges.length.guide_picture import length_findings
from crenel.gauges.length.guide_scan_lines import bar_scan_findings
from crenel.gauges.plan.document_gauge import GaugeFile
from crenel.gauges.plan.document_length_standard import LengthStandardFile
from crenel.gauges.plan.evaluate_artefacts import unknown_form
from crenel.gauges.plan.maths_lengths import LENGTHS
from crenel.gauges.plan.maths_temperature import TemperatureSpan
from crenel.gauges.plane.guide import plate_findings
from crenel.gauges.session.entries import Temperatures
from crenel.gauges.sphere.maths_articulation import HELD_DEG
from crenel.guide.common.flow import DECISION_QUALITY, device_findings, strain_findings
from crenel.guide.common.journal import error_from_payload
from crenel.messages.message import message, quantity


def list_findings(state: PerformanceState, live: PerformanceLive) -> list[Finding]:
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
    if state.step in TOUCHING:
        findings += strain_findings(live.strain)
    if state.step in ("artefact", "temperatures"):
        findings += _about_temperatures(state, live)
    if state.step == "lengths":
        findings += length_findings(live.lengths)
        findings += bar_scan_findings(state)
    findings += contact_findings(state, live.contact)
    if state.step == "plate":
        findings += plate_findings(state)
    if live.off_deg is not None and live.off_deg > HELD_DEG:
        findings.append(_about_articulation(live.off_deg, state.step))
    if state.step == "scan":
        findings += _about_scans(state)
    if state.step == "review":
        findings += _about_result(state, live)
    return findings


def _about_artefact(state: PerformanceState, live: PerformanceLive) -> list[Finding]:
    findings = list(live.gauges.findings)
    if not live.gauges.known and not live.bars.known:
        text = message("performance-no-artefact", test=state.test)
        findings.append(Finding("attention", text, message("put-certificate-into-folder-gauges")))
    standard = live.artefact if state.test == "lengths" else None
    if isinstance(standard, LengthStandardFile) and len(standard.lengths) < LENGTHS:
        text = message("performance-fewer-lengths", count=len(standard.lengths))
        findings.append(Finding("attention", sentence(text)))
    sphere = live.artefact if state.test == "sphere" else None
    if isinstance(sphere, GaugeFile):
        unknown = unknown_form(sphere, sphere.name or state.gauge)
        findings += [Finding("attention", sentence(unknown))] if unknown else []
    remedy = message("performance-correct-gauge")
    return findings + [Finding("bad", sentence(one), remedy) for one in live.artefact_problems]


def _about_temperatures(state: PerformanceState, live: PerformanceLive) -> list[Finding]:
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
    for artefact in live.artefacts if state.test != "plane" else ():
        span = TemperatureSpan(begin.artefact_c, end.artefact_c)
        if unknown := unknown_expansion(artefact, artefact.name or state.gauge, span):
            findings.append(Finding("attention", sentence(unknown)))
    return findings


def _about_articulation(off_deg: float, step: str) -> Finding:
    off, most = quantity(off_deg, "°"), quantity(HELD_DEG, "°")
    if step == "location":
        text = message("performance-stylus-off-articulation", off=off, most=most)
    else:
        text = message("performance-camera-off-articulation", off=off, most=most)
    return Finding("attention", text, message("performance-turn-towards-articulation"))


def _about_scans(state: PerformanceState) -> list[Finding]:
    findings: list[Finding] = []
    last = state.here[-1] if state.here else None
    if last is not None and last.refused is not None and not last.aside:
        error = error_from_payload(last.refused)
        findings.append(Finding("attention", error.reason, sentence(error.remedy)))
    missing = missing_patches(state)
    if missing and any(scan.good for scan in state.here) and not state.articulation:
        text = message("patches-not-covered", patches=", ".join(map(str, missing)))
        remedy = message("performance-scan-missing")
        findings.append(Finding("attention", sentence(text), remedy))
    return findings


def _about_result(state: PerformanceState, live: PerformanceLive) -> list[Finding]:
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
