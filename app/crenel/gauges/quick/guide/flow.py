"""The view of a verification, from its state and the station as it is. Pure."""

from functools import partial

import numpy as np

from crenel.errors import OperationError, sentence
from crenel.findings import Finding
from crenel.gauges.plan.document_gauge import GaugeFile
from crenel.gauges.quick.guide.picture import build_picture, touch_rms_um
from crenel.gauges.quick.guide.rules import (
    CLOUDS_WANTED,
    OTHER_SIZE_MM,
    OTHER_SIZE_SDS,
    RULES,
    VerifyLive,
    change_reason,
    touches_wanted,
)
from crenel.gauges.quick.guide.state import VerifyState
from crenel.gauges.quick.guide.view import (
    GaugeOption,
    VerifyView,
)
from crenel.gauges.quick.maths.probed_gauge import ProbedPlane, ProbedSphere
from crenel.guide.common.flow import DECISION_QUALITY, device_findings, list_steps, strain_findings
from crenel.guide.common.journal import error_from_payload
from crenel.guide.common.view import Action, LiveNumber, StepProgress, progress_of
from crenel.messages.limits import beside_limit
from crenel.messages.message import Quantity, Text, join, mentions, message, quantity, word
from crenel.messages.uncertainty import uncertainty_quantity
from crenel.metrology.fitting.touched_shape import doubt_error

TITLES = {
    "gauge": message("choose-gauge"),
    "touch": message("touch-gauge"),
    "scan": message("scan-gauge"),
    "review": message("result"),
}
LEFT_OUT_SHARE = 0.2


def build_view(state: VerifyState, live: VerifyLive) -> VerifyView:
    """The view."""
    running = bool(state.session_id) and not state.ended
    title, instruction = _words(state, live)
    return VerifyView(
        session_id=state.session_id,
        rev=state.rev,
        running=running,
        calibration_id=state.calibration_id,
        calibration=live.active_name if state.calibration_id == live.active_id else "",
        gauges=[
            GaugeOption(entry.id, gauge.shape, gauge.name or entry.id, _detail(gauge))
            for entry in live.gauges.known.values()
            for gauge in (entry.datasheet,)
        ],
        gauge=state.gauge,
        steps=list_steps(TITLES, state.step, state.reached),
        step=state.step,
        title=title,
        instruction=instruction,
        picture=build_picture(state, live),
        number=_number(state, live) if running else None,
        progress=_progress(state, live) if running else None,
        findings=_findings(state, live) if running else [],
        actions=_actions(state, live) if running else [],
        busy=live.busy,
    )


def _detail(gauge: GaugeFile) -> Text:
    size = (
        word("plane")
        if gauge.radius_mm is None
        else message("sphere-of-diameter", diameter=quantity(2 * gauge.radius_mm, "mm", 3))
    )
    if not gauge.serial_number:
        return size
    return join([size, message("serial-number", serial_number=gauge.serial_number)])


def _words(state: VerifyState, live: VerifyLive) -> tuple[Text, Text]:
    shape = live.gauge.shape if live.gauge is not None else "sphere"
    if state.step == "gauge":
        return TITLES["gauge"], message("clamp-firmly-within-arms-reach-sphere")
    if state.step == "touch":
        return TITLES["touch"], message("touch-probe-press-arms-button-each", shape=shape)
    if state.step == "scan":
        if state.open_cloud is not None:
            title = message("scanning-cloud", number=state.open_cloud.number)
            return title, message("pass-stripe-slowly-over-whole-gauge")
        return TITLES["scan"], message("pass-stripe-slowly-each-pass-cloud", shape=shape)
    return TITLES["review"], message("what-clouds-show-against-certificate")


# -- the card ------------------------------------------------------------------


def _number(state: VerifyState, live: VerifyLive) -> LiveNumber | None:
    touched = live.touched
    if state.step == "touch":
        note = _uncertainty_note(touched)
        return LiveNumber(message("touches-agree"), touch_rms_um(live), "µm", 0, "neutral", note)
    if state.step == "scan" and state.open_cloud is not None:
        return LiveNumber(message("points"), float(live.scan_points), "", 0)
    figures = {figure.name: figure for figure in live.judged.figures}
    if state.step == "gauge" or not figures:
        return None
    main = next(
        figures[name]
        for name in ("centre_error", "offset", "radius_error", "form")
        if name in figures
    )
    expanded = uncertainty_quantity(main.judging_uncertainty, main.unit)
    note = message("expanded-uncertainty-note", expanded_uncertainty=expanded)
    shown = quantity(abs(main.value), "µm")
    if main.limit is not None:
        shown, limit = beside_limit(shown.value, main.limit, "µm")
        note = message(
            "limit-with-expanded-uncertainty", limit=limit, expanded_uncertainty=expanded
        )
    quality = DECISION_QUALITY[main.decision]
    return LiveNumber(main.title, shown.value, "µm", shown.decimals, quality, note)


def _uncertainty_note(touched: object) -> Text:
    if isinstance(touched, ProbedPlane):
        arcsec = touched.angle_sd_rad * 180 / np.pi * 3600
        at = touched.height_sd_mm(touched.nominal.point_mm)
        return message(
            "so-plane-known-k-1", at=quantity(1000.0 * at, "µm"), arcsec=quantity(arcsec, "″")
        )
    if isinstance(touched, ProbedSphere):
        return message(
            "so-centre-known-k-1", centre_sd=quantity(1000.0 * touched.centre_sd_mm, "µm")
        )
    return message("after-few-more-touches")


def _progress(state: VerifyState, live: VerifyLive) -> StepProgress | None:
    if state.step == "touch":
        done, of = len(state.counted), touches_wanted(live)
        text = message("touches", done=done, of=of)
        return progress_of(done, of, text, message("touches-enough", done=done))
    if state.step == "scan":
        done = len(state.good)
        text = message("clouds", done=done, clouds_wanted=CLOUDS_WANTED)
        return progress_of(done, CLOUDS_WANTED, text, message("clouds-taken-enough", done=done))
    return None


def _findings(state: VerifyState, live: VerifyLive) -> list[Finding]:
    findings: list[Finding] = []
    if live.trouble:
        findings.append(live.trouble)
    if reason := change_reason(state, live):
        findings.append(Finding("bad", reason, message("what-taken-kept-folder")))
    findings += device_findings(live.arm_link, live.sensor_link)
    if state.step == "touch":
        findings += strain_findings(live.strain)
    if state.step == "gauge":
        findings += live.gauges.findings
        findings += [
            Finding("attention", join([one.id, one.reason], ": "), message("correct-remove-file"))
            for one in live.gauges.refused
        ]
        if not live.gauges.known:
            text = message("there-no-gauge-data-folder-yet")
            findings.append(
                Finding("attention", text, message("put-certificate-into-folder-gauges"))
            )
    if state.step == "touch":
        shown = live.trouble.text if live.trouble else ""
        about = _about_touches(state, live)
        findings += [one for one in about if not mentions(shown, one.text)]
    if state.step == "scan":
        findings += _about_clouds(state, live)
    if state.step == "review":
        verdict = live.judged.verdict
        if verdict is not None:
            findings.append(
                Finding(DECISION_QUALITY[verdict.result], verdict.text, _remedy(verdict.result))
            )
        findings += [
            Finding(DECISION_QUALITY[figure.decision], figure.reason)
            for figure in live.judged.figures
            if figure.decision in ("fail", "uncertain")
        ]
    return findings


def _remedy(result: str) -> Text:
    if result == "fail":
        return message("clean-gauge-tip-check-clamps-verify")
    return message("touch-gauge-more-places-scan-more") if result != "pass" else ""


def _about_touches(state: VerifyState, live: VerifyLive) -> list[Finding]:
    touched = live.touched
    if isinstance(touched, OperationError):
        known = touched.code == "too-few-touches"
        return [] if known else [Finding("attention", touched.reason, sentence(touched.remedy))]
    if touched is None:
        return []
    outliers = [
        Finding(
            "attention",
            message(
                "point-off-surface-left-out",
                index=i + 1,
                off=_distance(abs(float(touched.residuals_mm[i]))),
            ),
            message("remove-touch-there-again-rest"),
        )
        for i in map(int, np.flatnonzero(touched.outliers))
    ]
    if (doubt := doubt_error(touched.doubtful)) is not None:
        outliers.append(Finding("attention", doubt.reason, sentence(doubt.remedy)))
    return outliers + (_about_size(touched) if isinstance(touched, ProbedSphere) else [])


def _distance(mm: float) -> Quantity:
    return quantity(mm, "mm", 1) if mm >= 1.0 else quantity(1e3 * mm, "µm")


def _about_size(touched: ProbedSphere) -> list[Finding]:
    off_mm = touched.radius_mm - touched.nominal.radius_mm
    if abs(off_mm) < max(OTHER_SIZE_MM, OTHER_SIZE_SDS * touched.radius_sd_mm):
        return []
    return [
        Finding(
            "bad",
            message(
                "touched-sphere-seems-to-have-diameter",
                radius=quantity(2 * touched.radius_mm, "mm", 2),
                radius2=quantity(2 * touched.nominal.radius_mm, "mm", 2),
            ),
            message("check-chosen-gauge-tip-arms-own"),
        )
    ]


def _about_clouds(state: VerifyState, live: VerifyLive) -> list[Finding]:
    findings: list[Finding] = []
    last = next((cloud for cloud in reversed(state.listed) if not cloud.voided), None)
    if last is None:
        return findings
    if last.refused is not None:
        error = error_from_payload(last.refused)
        reason = join([message("cloud-no-use", number=last.number), error.reason], " ")
        findings.append(Finding("attention", reason, sentence(error.remedy)))
    fit = live.judged.fits.get(last.number)
    if fit is None:
        return findings
    findings += [Finding("attention", sentence(text)) for text in fit.warnings]
    plane = live.gauge is not None and live.gauge.shape == "plane"
    left_out = 1 - fit.used / max(fit.points, 1)
    if plane and left_out > LEFT_OUT_SHARE:
        text = message(
            "cloud-points-not-of-plane", left_out=quantity(100 * left_out, "%"), number=last.number
        )
        findings.append(Finding("attention", text, message("scan-gauge-nothing-beside")))
    return findings


def _outliers(state: VerifyState, live: VerifyLive) -> list[tuple[int, int]]:
    """Places among the counted touches, from 0, and indices of those that are left out."""
    if live.touched is None or isinstance(live.touched, OperationError):
        return []
    return [(int(i), state.counted[i].index) for i in np.flatnonzero(live.touched.outliers)]


def _actions(state: VerifyState, live: VerifyLive) -> list[Action]:
    offer = partial(RULES.offer, state, live)
    leave = offer(
        "abandon",
        message("cancel-verification"),
        confirm=message("leave-verification-clouds-kept-folder"),
    )
    if change_reason(state, live) and state.open_cloud is None:
        return [offer("again", message("begin-again"), primary=True), leave]
    operator_actions = RULES.offer_simulation(state, live, whole=state.step == "gauge")
    back = offer("back", message("back"))
    if state.step == "gauge":
        return [
            offer("confirm_gauge", message("gauge-clamped"), primary=True),
            *operator_actions,
            leave,
        ]
    if state.step == "touch":
        enough = len(state.counted) >= touches_wanted(live)
        return [
            offer("touch", message("take-touch"), primary=not enough),
            offer("confirm_touch", message("go-scanning"), primary=enough),
            offer("undo", message("undo")),
            *(offer("redo", message("put-touch-back", i=i + 1)) for i in state.undone[-1:]),
            *(
                offer("void_touch", message("remove-point", index=i + 1), {"index": index})
                for i, index in _outliers(state, live)
            ),
            *operator_actions,
            offer("skip_touch", message("go-without-probe")),
            back,
        ]
    if state.step == "scan":
        if state.open_cloud is not None:
            return [
                offer("finish_cloud", message("end-cloud"), primary=True),
                offer("drop_cloud", message("drop-cloud")),
                *operator_actions,
            ]
        enough = len(state.good) >= CLOUDS_WANTED
        return [
            offer(
                "begin_cloud",
                message("scan-cloud", clouds=len(state.clouds) + 1),
                primary=not enough,
            ),
            offer("confirm_clouds", message("see-result"), primary=enough),
            offer("undo", message("undo")),
            *operator_actions,
            back,
        ]
    return [
        offer("accept", message("accept-verification"), primary=True),
        offer("more_clouds", message("scan-more-clouds")),
        back,
        leave,
    ]
