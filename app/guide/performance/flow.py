"""The view of a performance test, from its state and the station as it is. Pure."""

from collections.abc import Mapping
from functools import partial

from app.errors import sentence
from app.findings import Finding
from app.formats.datasheets.gauge import GaugeFile
from app.formats.datasheets.length_standard import LengthStandardFile
from app.formats.performance.plan import ARTICULATIONS
from app.guide.common.datasheet_library import AnyGauge, Gauges
from app.guide.common.flow import DECISION_QUALITY, device_findings, list_steps, strain_findings
from app.guide.common.journal import error_from_payload
from app.guide.common.view import Action, LiveNumber, StepProgress
from app.guide.performance.length.picture import (
    last_error,
    length_findings,
    length_instruction,
)
from app.guide.performance.live import PerformanceLive
from app.guide.performance.picture import articulation_title, build_picture
from app.guide.performance.rules import (
    RULES,
    change_reason,
    count_wanted,
    missing_patches,
)
from app.guide.performance.state import TEST_STEPS, TOUCHING, PerformanceState
from app.guide.performance.view import ArtefactOption, PerformanceView
from app.messages.message import Text, join, message, quantity
from app.metrology.performance.articulation import HELD_DEG
from app.metrology.performance.lengths import LENGTHS

TITLES = {
    "artefact": message("performance-step-artefact"),
    "pattern": message("performance-step-pattern"),
    "location": message("performance-step-location"),
    "scan": message("performance-step-scan"),
    "end": message("performance-step-end"),
    "lengths": message("performance-step-lengths"),
    "review": message("result"),
}
CANCELLED = {
    "moved": message("performance-cancelled-moved"),
    "operating": message("performance-cancelled-operating"),
    "device": message("performance-cancelled-device"),
    "plan": message("performance-cancelled-plan"),
    "other": message("performance-cancelled-other"),
}
"""Why a test was cancelled, by the reasons of ``abandon``."""


def build_view(state: PerformanceState, live: PerformanceLive) -> PerformanceView:
    """The view."""
    running = bool(state.session_id) and not state.ended
    return PerformanceView(
        session_id=state.session_id,
        rev=state.rev,
        running=running,
        test=state.test,
        calibration_id=state.calibration_id,
        calibration=live.active_name if state.calibration_id == live.active_id else "",
        gauges=gauge_options(live.gauges, live.obstacles),
        gauge=state.gauge,
        positions=state.positions,
        position=state.position,
        frozen=state.frozen,
        steps=list_steps(
            {step: TITLES[step] for step in TEST_STEPS[state.test]}, state.step, state.reached
        ),
        step=state.step,
        title=_title(state),
        instruction=_instruction(state, live),
        picture=build_picture(state, live),
        number=_number(state, live) if running else None,
        progress=_progress(state) if running else None,
        findings=_findings(state, live) if running else [],
        actions=_actions(state, live) if running else [],
        busy=live.busy,
    )


def gauge_options(gauges: Gauges[AnyGauge], obstacles: Mapping[str, Text]) -> list[ArtefactOption]:
    """The spheres or length standards, then the certificates that describe none."""
    known = [
        ArtefactOption(
            entry.id,
            entry.datasheet.name or entry.id,
            _detail(entry.datasheet),
            sentence(obstacles.get(entry.id, "")),
        )
        for entry in gauges.known.values()
    ]
    return known + [ArtefactOption(one.id, one.id, "", one.reason) for one in gauges.refused]


def _detail(gauge: AnyGauge) -> Text:
    parts: list[Text] = [_size(gauge)]
    if gauge.serial_number:
        parts.append(message("serial-number", serial_number=gauge.serial_number))
    if gauge.certificate:
        parts.append(gauge.certificate)
    if gauge.valid_until:
        parts.append(message("performance-valid-until", until=gauge.valid_until))
    return join(parts)


def _size(gauge: AnyGauge) -> Text:
    if isinstance(gauge, GaugeFile):
        return message("sphere-2", diameter=quantity(2 * (gauge.radius_mm or 0.0), "mm", 3))
    lengths = [one.length_mm for one in gauge.lengths]
    return message(
        "performance-standard-lengths",
        kind=gauge.kind,
        count=len(lengths),
        shortest=quantity(min(lengths), "mm"),
        longest=quantity(max(lengths), "mm"),
    )


def _title(state: PerformanceState) -> Text:
    if state.step in ("location", "scan") and state.articulation:
        return articulation_title(state.articulation)
    if state.end is not None:
        return message("performance-place-title", number=state.end.place)
    return TITLES[state.step]


def _instruction(state: PerformanceState, live: PerformanceLive) -> Text:
    if state.step == "lengths":
        return length_instruction(state, live.lengths)
    if state.step == "pattern":
        if not state.of_step:
            if state.position > 1:
                return message("performance-move-sphere")
            return message("performance-touch-top-first")
        return message("performance-touch-pattern")
    if state.step == "location":
        return message("performance-touch-location", number=state.articulation)
    if state.step == "scan":
        if state.open_scan is not None:
            return message("performance-pass-slowly")
        if not state.articulation:
            return message("performance-all-scanned")
        return message("performance-hold-sensor", number=state.articulation)
    if state.step == "end":
        return message("performance-do-end")
    if state.step == "review":
        return message("performance-do-review", test=state.test)
    return message("performance-do-artefact", test=state.test)


# -- the card ------------------------------------------------------------------


def _number(state: PerformanceState, live: PerformanceLive) -> LiveNumber | None:
    if state.step == "scan" and state.open_scan is not None:
        return LiveNumber(message("points-5"), float(live.scan_points), "", 0)
    if state.step == "lengths":
        return last_error(live.lengths)
    return None


def _progress(state: PerformanceState) -> StepProgress | None:
    if state.step == "lengths" and state.sequence is not None:
        done = len(state.of_step) // state.sequence.of_measurement
        of = state.sequence.measurements
        return StepProgress(done, of, message("performance-lengths-measured", done=done, of=of))
    if state.step in TOUCHING:
        done, of = len(state.of_step), count_wanted(state)
        return StepProgress(done, of, message("touches", done=done, of=of))
    if state.step == "scan":
        done = sum(state.scan_of(number + 1) is not None for number in range(ARTICULATIONS))
        text = message("performance-scans-done", done=done, of=ARTICULATIONS)
        return StepProgress(done, ARTICULATIONS, text)
    return None


def _findings(state: PerformanceState, live: PerformanceLive) -> list[Finding]:
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
    if state.step == "lengths":
        findings += length_findings(live.lengths)
    if live.off_deg is not None and live.off_deg > HELD_DEG:
        findings.append(_about_articulation(live.off_deg, state.step))
    if state.step == "scan":
        findings += _about_scans(state)
    if state.step == "review":
        findings += _about_result(state, live)
    return findings


def _about_artefact(state: PerformanceState, live: PerformanceLive) -> list[Finding]:
    findings = list(live.gauges.findings)
    if not live.gauges.known:
        text = message("performance-no-artefact", test=state.test)
        findings.append(Finding("attention", text, message("put-certificate-into-folder-gauges")))
    if isinstance(live.artefact, LengthStandardFile) and len(live.artefact.lengths) < LENGTHS:
        text = message("performance-fewer-lengths", count=len(live.artefact.lengths))
        findings.append(Finding("attention", text))
    remedy = message("performance-correct-gauge")
    return findings + [Finding("bad", sentence(one), remedy) for one in live.artefact_problems]


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


def _actions(state: PerformanceState, live: PerformanceLive) -> list[Action]:
    offer = partial(RULES.offer, state, live)
    leave = offer("abandon", message("leave"), confirm=message("performance-leave-question"))
    if change_reason(state, live) and state.open_scan is None:
        again = offer("again", message("begin-again"), {"reason": "plan"}, primary=True)
        return [again, leave]
    simulation = RULES.offer_simulation(state, live, whole=state.step == "artefact")
    if state.step == "artefact":
        label = message("performance-artefact-is-ready", test=state.test)
        return [offer("confirm_artefact", label, primary=True), *simulation, leave]
    if state.step in TOUCHING:
        enough = len(state.of_step) >= count_wanted(state)
        back = [offer("back", message("back"))] if not state.frozen else []
        return [
            offer("touch", message("take-touch"), primary=not enough),
            offer("confirm", message("performance-go-on"), primary=enough),
            offer("undo", message("undo")),
            *(offer("redo", message("performance-put-back")) for _ in state.undone[-1:]),
            *simulation,
            *back,
            leave,
        ]
    if state.step == "scan":
        return [*_scan_actions(state, live), *simulation, leave]
    again = offer(
        "again",
        message("performance-repeat"),
        {"reason": "operating"},
        confirm=message("performance-repeat-question"),
    )
    return [offer("accept", message("performance-accept"), primary=True), again, leave]


def _scan_actions(state: PerformanceState, live: PerformanceLive) -> list[Action]:
    offer = partial(RULES.offer, state, live)
    if state.open_scan is not None:
        return [
            offer("finish_scan", message("performance-end-scan"), primary=True),
            offer("drop_scan", message("performance-drop-scan")),
        ]
    if state.articulation:
        begin = offer("begin_scan", message("performance-begin-scan"), primary=True)
        return [begin, offer("confirm", message("performance-go-on"))]
    repeats = [
        offer(
            "begin_scan",
            message("performance-repeat-scan", number=number),
            {"articulation": number},
        )
        for number in range(1, ARTICULATIONS + 1)
    ]
    return [offer("confirm", message("performance-go-on"), primary=True), *repeats]
