"""The view of a performance test, from its state and the station as it is. Pure."""

from collections.abc import Mapping
from functools import partial

from crenel.errors import sentence
from crenel.gauges.guide_findings import list_findings
from crenel.gauges.guide_picture import build_picture
from crenel.gauges.guide_plan import measures_by_scan, why_no_scans
from crenel.gauges.guide_rules import RULES, change_reason
from crenel.gauges.guide_view import ArtefactOption, PerformanceView
from crenel.gauges.plan.document_gauge import GaugeFile
from crenel.gauges.session.kind import AnyLive
from crenel.gauges.session.state import PerformanceState
from crenel.guide.common.datasheet_library import AnyGauge, Gauges
from crenel.guide.common.flow import list_steps
from crenel.guide.common.view import Action, LiveNumber, StepProgress
from crenel.messages.message import Text, join, message, quantity

TITLES = {
    "artefact": message("performance-step-artefact"),
    "temperatures": message("performance-step-temperatures"),
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


def build_view(state: PerformanceState, live: AnyLive) -> PerformanceView:
    """The view."""
    running = bool(state.session_id) and not state.ended
    titles = {**TITLES, **live.kind.titles}
    return PerformanceView(
        session_id=state.session_id,
        rev=state.rev,
        running=running,
        test=state.test,
        calibration_id=state.calibration_id,
        calibration=live.active_name if state.calibration_id == live.active_id else "",
        gauges=gauge_options(live.gauges, live.obstacles),
        gauge=state.gauge,
        bars=gauge_options(live.bars, live.obstacles),
        bar=state.bar,
        positions=state.positions,
        by_scan=measures_by_scan(state, live.artefact),
        why_no_scans=sentence(why_no_scans(state, live.artefact)),
        position=state.position,
        frozen=state.frozen,
        steps=list_steps({step: titles[step] for step in state.steps}, state.step, state.reached),
        step=state.step,
        title=_title(state, live),
        instruction=_instruction(state, live),
        picture=build_picture(state, live),
        number=_number(state, live) if running else None,
        progress=_progress(state, live) if running else None,
        findings=list_findings(state, live) if running else [],
        actions=_actions(state, live) if running else [],
        busy=live.busy,
    )


def gauge_options(gauges: Gauges[AnyGauge], obstacles: Mapping[str, Text]) -> list[ArtefactOption]:
    """The spheres, plates or length standards, then the certificates that describe none."""
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
    if isinstance(gauge, GaugeFile) and gauge.shape == "plane":
        return message("plate-by-certificate", flatness=quantity(gauge.form_um, "µm", 1))
    if isinstance(gauge, GaugeFile):
        return message(
            "sphere-of-diameter", diameter=quantity(2 * (gauge.radius_mm or 0.0), "mm", 3)
        )
    lengths = [one.length_mm for one in gauge.lengths]
    return message(
        "performance-standard-lengths",
        kind=gauge.kind,
        count=len(lengths),
        shortest=quantity(min(lengths), "mm"),
        longest=quantity(max(lengths), "mm"),
    )


def _title(state: PerformanceState, live: AnyLive) -> Text:
    if state.step not in state.between:
        return TITLES[state.step]
    return live.kind.title(state) or live.kind.titles[state.step]


def _instruction(state: PerformanceState, live: AnyLive) -> Text:
    if state.step == "temperatures":
        return message("performance-do-temperatures")
    if state.step == "review":
        return message("performance-do-review", test=state.test)
    if state.step == "artefact":
        return message("performance-do-artefact-and-limits", test=state.test)
    return live.kind.instruction(state, live)


# -- the card ------------------------------------------------------------------


def _number(state: PerformanceState, live: AnyLive) -> LiveNumber | None:
    if state.open_scan is not None:
        return LiveNumber(message("points"), float(live.scan_points), "", 0)
    return live.kind.number(state, live)


def _progress(state: PerformanceState, live: AnyLive) -> StepProgress | None:
    return live.kind.progress(state) if state.step in state.between else None


def _actions(state: PerformanceState, live: AnyLive) -> list[Action]:
    offer = partial(RULES.offer, state, live)
    leave = offer("abandon", message("cancel-test"), confirm=message("performance-leave-question"))
    if change_reason(state, live) and state.open_scan is None:
        again = offer("again", message("begin-again"), {"reason": "plan"}, primary=True)
        return [again, leave]
    simulation = RULES.offer_simulation(state, live, whole=state.step == "artefact")
    if state.due is not None:
        return [*_bar_scan_actions(state, live), *simulation, leave]
    if state.step == "artefact":
        label = message("performance-artefact-is-ready", test=state.test)
        return [offer("confirm_artefact", label, primary=True), *simulation, leave]
    if state.step in state.touching:
        enough = len(state.of_step) >= state.wanted
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
    if state.step in state.scanning:
        back = [offer("back", message("back"))] if not state.frozen else []
        return [*_scan_actions(state, live), *simulation, *back, leave]
    if state.step == "temperatures":
        label = message("performance-confirm-temperatures")
        return [offer("confirm", label, primary=True), *simulation, leave]
    again = offer(
        "again",
        message("performance-repeat"),
        {"reason": "operating"},
        confirm=message("performance-repeat-question"),
    )
    change = offer("back", message("performance-change-temperatures"))
    return [offer("accept", message("performance-accept"), primary=True), change, again, leave]


def _bar_scan_actions(state: PerformanceState, live: AnyLive) -> list[Action]:
    """The touches before the first scan of a place can still be taken back."""
    offer = partial(RULES.offer, state, live)
    if state.open_scan is not None:
        return _scan_actions(state, live)
    begin = offer("begin_scan", message("performance-begin-scan"), primary=True)
    undone = len(state.counted) > state.confirmed
    return [begin, *([offer("undo", message("undo"))] if undone else [])]


def _scan_actions(state: PerformanceState, live: AnyLive) -> list[Action]:
    offer = partial(RULES.offer, state, live)
    if state.open_scan is not None:
        return [
            offer("finish_scan", message("performance-end-scan"), primary=True),
            offer("drop_scan", message("performance-drop-scan")),
        ]
    kind = live.kind
    if kind.is_scan_left(state):
        begin = offer("begin_scan", message("performance-begin-scan"), primary=True)
        return [begin, offer("confirm", message("performance-go-on"))]
    go_on = offer("confirm", message("performance-go-on"), primary=True)
    again = [offer("begin_scan", label, args) for label, args in kind.scans_again(state)]
    return [go_on, *again]
