"""The view of a verification, from its state and the station as it is. Pure."""

from collections.abc import Mapping

import numpy as np

from app.errors import OperationError
from app.findings import Finding, Quality
from app.formats.datasheets.gauge import GaugeFile
from app.guide.common.view import Action, LiveNumber, Step, StepProgress, sentence
from app.guide.verify.live import VerifyLive
from app.guide.verify.picture import build_picture, touch_rms_um
from app.guide.verify.rules import (
    CLOUDS_WANTED,
    OTHER_SIZE_MM,
    OTHER_SIZE_SDS,
    change_reason,
    rejection_reason,
    touches_wanted,
)
from app.guide.verify.state import STEPS, VerifyState
from app.guide.verify.view import (
    GaugeOption,
    VerifyView,
)
from app.metrology.gauges.probed_gauge import ProbedPlane, ProbedSphere

TITLES = {
    "gauge": "Choose the gauge",
    "touch": "Touch the gauge",
    "scan": "Scan the gauge",
    "review": "Result",
}
LEFT_OUT_SHARE = 0.2
QUALITY: dict[str, Quality] = {
    "pass": "good",
    "fail": "bad",
    "uncertain": "attention",
    "none": "neutral",
}


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
            GaugeOption(name, gauge.shape, gauge.name or name, _detail(gauge))
            for name, gauge in live.gauges.known.items()
        ],
        gauge=state.gauge,
        steps=_steps(state),
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


def _detail(gauge: GaugeFile) -> str:
    size = "plane" if gauge.radius_mm is None else f"sphere, {2 * gauge.radius_mm:.3f} mm"
    serial = f", serial number {gauge.serial_number}" if gauge.serial_number else ""
    return f"{size}{serial}"


def _words(state: VerifyState, live: VerifyLive) -> tuple[str, str]:
    plane = live.gauge is not None and live.gauge.shape == "plane"
    if state.step == "gauge":
        return TITLES["gauge"], (
            "Clamp it firmly within the arm's reach. A sphere shows the most; a plane is quicker."
        )
    if state.step == "touch":
        where = (
            "near its corners and in its middle" if plane else "on its top and all around its side"
        )
        return TITLES["touch"], (
            f"Touch it with the probe {where}, and press the arm's button at each place."
        )
    if state.step == "scan":
        if state.open_cloud is not None:
            return f"Scanning cloud {state.open_cloud.number}", (
                "Pass the stripe slowly over the whole gauge, then end the cloud."
            )
        how = "over the whole gauge" if plane else "over the sphere from three sides"
        return TITLES["scan"], f"Pass the stripe slowly {how}. Each pass is a cloud of its own."
    return TITLES["review"], "What the clouds show against the gauge's paper and the probe."


def _steps(state: VerifyState) -> list[Step]:
    at, reached = STEPS.index(state.step), STEPS.index(state.reached)
    return [
        Step(
            name,
            TITLES[name],
            "done" if i < at else "current" if i == at else "stale" if i <= reached else "todo",
        )
        for i, name in enumerate(STEPS)
    ]


# -- the card ------------------------------------------------------------------


def _number(state: VerifyState, live: VerifyLive) -> LiveNumber | None:
    touched = live.touched
    if state.step == "touch":
        note = _uncertainty_note(touched)
        return LiveNumber("Touches agree to", touch_rms_um(live), "µm", 0, "neutral", note)
    if state.step == "scan" and state.open_cloud is not None:
        return LiveNumber("Points", float(live.scan_points), "", 0)
    figures = {figure.name: figure for figure in live.judged.figures}
    if state.step == "gauge" or not figures:
        return None
    main = next(
        figures[name]
        for name in ("centre_error", "offset", "radius_error", "form")
        if name in figures
    )
    note = f"U = {main.expanded_uncertainty:.0f} µm, k = 2"
    if main.limit is not None:
        note = f"limit {main.limit:g} µm; {note}"
    return LiveNumber(main.title, abs(main.value), "µm", 0, QUALITY[main.decision], note)


def _uncertainty_note(touched: object) -> str:
    if isinstance(touched, ProbedPlane):
        arcsec = touched.angle_sd_rad * 180 / np.pi * 3600
        at = touched.height_sd_mm(touched.nominal.point_mm)
        return f"so the plane is known to {1e3 * at:.0f} µm and {arcsec:.0f}″, k = 1"
    if isinstance(touched, ProbedSphere):
        return f"so its centre is known to {1e3 * touched.centre_sd_mm:.0f} µm, k = 1"
    return "after a few more touches"


def _progress(state: VerifyState, live: VerifyLive) -> StepProgress | None:
    if state.step == "touch":
        done, of = len(state.counted), touches_wanted(live)
        return StepProgress(min(done, of), of, f"{done} of {of} touches")
    if state.step == "scan":
        done = len(state.good)
        return StepProgress(
            min(done, CLOUDS_WANTED), CLOUDS_WANTED, f"{done} of {CLOUDS_WANTED} clouds"
        )
    return None


def _findings(state: VerifyState, live: VerifyLive) -> list[Finding]:
    found: list[Finding] = []
    if live.trouble:
        found.append(live.trouble)
    if reason := change_reason(state, live):
        found.append(Finding("bad", reason, "What was taken is kept in its folder."))
    for link in (live.arm_link, live.sensor_link):
        if link.state != "connected":
            text = f"{link.title}: {link.text}"
            found.append(Finding("bad", text, "Wait, or check it. What was taken is kept."))
    if state.step == "gauge":
        found += live.gauges.findings
        if not live.gauges.known:
            text = "There is no gauge in the data folder yet."
            found.append(Finding("attention", text, "Put its paper into the folder gauges."))
    if state.step == "touch":
        told = found[0].text if live.trouble else ""
        found += [finding for finding in _about_touches(live) if finding.text not in told]
    if state.step == "scan":
        found += _about_clouds(state, live)
    if state.step == "review":
        verdict = live.judged.verdict
        if verdict is not None:
            found.append(Finding(QUALITY[verdict.result], verdict.text, _remedy(verdict.result)))
        found += [
            Finding(QUALITY[figure.decision], figure.reason)
            for figure in live.judged.figures
            if figure.decision in ("fail", "uncertain")
        ]
    return found


def _remedy(result: str) -> str:
    if result == "fail":
        return "Clean gauge and tip, check the clamps, and verify again; then calibrate again."
    return "Touch the gauge in more places, and scan it more slowly." if result != "pass" else ""


def _about_touches(live: VerifyLive) -> list[Finding]:
    touched = live.touched
    if isinstance(touched, OperationError) and touched.code != "too-few-touches":
        why = f": {touched.why}" if touched.why else ""
        text = sentence(f"{touched.what}{why}")
        return [Finding("attention", text, sentence(touched.remedy))]
    if not isinstance(touched, ProbedSphere):
        return []
    off_mm = touched.radius_mm - touched.nominal.radius_mm
    if abs(off_mm) < max(OTHER_SIZE_MM, OTHER_SIZE_SDS * touched.radius_sd_mm):
        return []
    return [
        Finding(
            "bad",
            f"The touched sphere seems to have a diameter of {2 * touched.radius_mm:.2f} mm; by "
            f"its paper it has {2 * touched.nominal.radius_mm:.2f} mm.",
            "Check that this is the chosen gauge, and that the tip is the arm's own.",
        )
    ]


def _about_clouds(state: VerifyState, live: VerifyLive) -> list[Finding]:
    found: list[Finding] = []
    last = next((cloud for cloud in reversed(state.listed) if not cloud.voided), None)
    if last is None:
        return found
    if last.refused is not None:
        why = f": {last.refused['why']}" if last.refused["why"] else ""
        text = sentence(f"Cloud {last.number} is of no use. {last.refused['what']}{why}")
        found.append(Finding("attention", text, sentence(str(last.refused["remedy"]))))
    fit = live.judged.fits.get(last.number)
    if fit is None:
        return found
    found += [Finding("attention", sentence(text)) for text in fit.warnings]
    plane = live.gauge is not None and live.gauge.shape == "plane"
    left_out = 1 - fit.used / max(fit.points, 1)
    if plane and left_out > LEFT_OUT_SHARE:
        text = f"{100 * left_out:.0f} % of cloud {last.number} are not of the plane."
        found.append(Finding("attention", text, "Scan the gauge, and nothing beside it."))
    return found


def _actions(state: VerifyState, live: VerifyLive) -> list[Action]:
    def offer(
        name: str,
        label: str,
        primary: bool = False,
        confirm: str = "",
        args: Mapping[str, object] | None = None,
    ) -> Action:
        reason = rejection_reason(state, live, name, args or {})
        return Action(name, label, args or {}, primary, not reason, reason, confirm)

    leave = offer(
        "abandon", "Leave", confirm="Leave this verification? Its clouds are kept in its folder."
    )
    if change_reason(state, live) and state.open_cloud is None:
        return [offer("again", "Begin again", primary=True), leave]
    hand = [offer("let_hand", "Let the hand do it")] if live.has_hand else []
    if live.hand_running:
        hand = [offer("stop_hand", "Stop the hand", primary=True)]
    back = offer("back", "Back")
    if state.step == "gauge":
        if live.has_hand and not live.hand_running:
            whole = {"all": True}
            hand.append(offer("let_hand", "Let the hand do everything", args=whole))
        return [offer("confirm_gauge", "This gauge is clamped", primary=True), *hand, leave]
    if state.step == "touch":
        enough = len(state.counted) >= touches_wanted(live)
        return [
            offer("touch", "Take the touch", primary=not enough),
            offer("confirm_touch", "Go on to scanning", primary=enough),
            offer("undo", "Undo"),
            *(offer("redo", f"Put touch {i + 1} back") for i in state.undone[-1:]),
            *hand,
            offer("skip_touch", "Go on without the probe"),
            back,
        ]
    if state.step == "scan":
        if state.open_cloud is not None:
            return [
                offer("finish_cloud", "End the cloud", primary=True),
                offer("drop_cloud", "Drop this cloud"),
                *hand,
            ]
        enough = len(state.good) >= CLOUDS_WANTED
        return [
            offer("begin_cloud", f"Scan cloud {len(state.clouds) + 1}", primary=not enough),
            offer("confirm_clouds", "See the result", primary=enough),
            offer("undo", "Undo"),
            *hand,
            back,
        ]
    return [
        offer("accept", "Accept this verification", primary=True),
        offer("more_clouds", "Scan more clouds"),
        back,
        leave,
    ]
