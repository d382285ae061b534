"""The view of an arm session, from its state and the station as it is. Pure."""

from collections.abc import Mapping

from app.errors import sentence
from app.findings import Finding, Quality
from app.guide.arm.picture import build_picture
from app.guide.arm.rules import (
    SEATS_WANTED,
    WANTED,
    places_taken,
    rejection_reason,
    swing_deg,
    touches_wanted,
)
from app.guide.arm.state import ArmLive, ArmState, Kind, SeatSamples
from app.guide.arm.tip import QUALITY as TIP_QUALITY
from app.guide.arm.tip import tip_check_finding as tip_finding
from app.guide.arm.view import ArmPicture, ArmView
from app.guide.common.recorded_error import error_from_payload
from app.guide.common.view import (
    Action,
    ChoiceOption,
    LiveNumber,
    Step,
    StepProgress,
    Vec3,
)
from app.messages.message import Text, message, quantity, rounded, text_from_json
from app.metrology.transforms import Floats

WHERE = (
    message("near-base"),
    message("far-out"),
    message("left"),
    message("right"),
    message("high-up"),
    message("low-down"),
)
STEPS = (
    ("seat", message("seat-tip")),
    ("swing", message("swing-arm")),
    ("result", message("result")),
)


BEGIN: dict[Kind, Text] = {
    "seat": message("tip-seat"),
    "bar": message("tip-bars-end"),
    "sphere": message("sphere-clamped"),
}
ON_SPHERE = {"seat": message("clamp-sphere"), "swing": message("touch")}
WITH_SPHERE = ("identify", "tip")


def build_view(state: ArmState, live: ArmLive) -> ArmView:
    """The view."""
    running = bool(state.session_id) and not state.ended
    step = state.step
    seat = state.seats[-1] if state.seats else None
    picture = build_picture(state, live, seat)
    title, instruction = _words(state, seat)
    return ArmView(
        session_id=state.session_id,
        rev=state.rev,
        running=running,
        purpose=state.purpose,
        arms=[
            ChoiceOption(
                entry.id,
                entry.datasheet.name,
                message("serial-number", serial_number=entry.datasheet.serial_number),
            )
            for entry in live.library.arms.values()
        ],
        arm=state.arm,
        artefact=state.artefact,
        steps=_steps(state),
        step=step,
        title=title,
        instruction=instruction,
        picture=picture,
        number=_number(state, picture) if running else None,
        progress=_progress(state, seat),
        findings=_findings(state, live, picture) if running else [],
        actions=_actions(state, live) if running else [],
        busy=live.busy,
    )


TIP_WORDS = {
    "seat": (
        message("clean-tip-clamp-sphere"),
        message("sphere-known-diameter-clamped-firmly-within"),
    ),
    "swing": (
        message("touch-sphere"),
        message("top-all-around-side-wrist-turned"),
    ),
    "result": (message("checked"), message("tips-diameter-how-well-touches-agree")),
}


def _words(state: ArmState, seat: SeatSamples | None) -> tuple[Text, Text]:
    if state.purpose == "tip":
        return TIP_WORDS[state.step]
    if state.step == "swing":
        assert seat is not None
        if state.touching:
            return (
                message("touch-2", place=seat.place),
                message("touch-all-over-upper-half-every"),
            )
        return (
            message("swing-arm-about", place=seat.place),
            message("keep-tip-seat-swing-elbow-one"),
        )
    if state.step == "result":
        if state.purpose == "check":
            return message("checked"), message("what-tip-moved-while-held-one")
        if state.saved:
            return (
                message("use"),
                message("calibrate-sensors-again-their-place-belongs"),
            )
        return (
            message("before-after"),
            message("places-were-held-out-fit-over"),
        )
    if state.purpose == "check":
        return (
            message("put-tip-into-seat"),
            message("clamp-cone-ball-seat-about-two"),
        )
    done = len(state.seats)
    where = WHERE[done % len(WHERE)]
    if state.half_bar:
        return message("put-tip-into-bars-other-end"), message("leave-bar-where")
    if state.artefact.kind == "bar":
        return (
            message("put-tip-into-end-ball-bar"),
            message("clamp-bar-firmly-reach-put-tip", where=where),
        )
    if state.artefact.kind == "sphere":
        return message("clamp-sphere"), message("clamp-firmly-reach", where=where)
    if places_taken(state) >= SEATS_WANTED:
        return message("enough-places"), message("identify-arm-take-more-know-better")
    return (
        message("put-tip-into-seat-2", done=done + 1),
        message("clamp-seat-firmly-reach-put-tip", where=where),
    )


def _steps(state: ArmState) -> list[Step]:
    at = [name for name, _ in STEPS].index(state.step)
    sphere = state.purpose in WITH_SPHERE and state.artefact.kind == "sphere"
    return [
        Step(
            name,
            ON_SPHERE.get(name, title) if sphere else title,
            "done" if i < at else "current" if i == at else "todo",
        )
        for i, (name, title) in enumerate(STEPS)
    ]


def limit_quality(half_range_um: Vec3 | Floats, limit_um: float | None) -> Quality:
    """good within the limit, bad beyond, neutral without one."""
    if limit_um is None:
        return "neutral"
    return "good" if max(half_range_um) <= limit_um else "bad"


def _number(state: ArmState, picture: ArmPicture) -> LiveNumber | None:
    result = picture.result
    if result is not None:
        note = message(
            "tip-uncertainty-before",
            before=quantity(result.volume_before_um, "µm"),
            size_known="yes" if result.size_known else "no",
        )
        return LiveNumber(message("tip-known"), result.volume_after_um, "µm", 1, "neutral", note)
    if state.step == "seat":
        return None
    tip = picture.tip
    if tip is not None:
        note = message(
            "expected-by-datasheet-and-expanded-uncertainty",
            expected=quantity(tip.expected_mm, "mm", 3),
            expanded_uncertainty=quantity(tip.expanded_uncertainty_um, "µm"),
        )
        quality = TIP_QUALITY[tip.decision]
        return LiveNumber(message("tips-diameter"), tip.diameter_mm, "mm", 3, quality, note)
    half_range_um = picture.half_range_um
    note = (
        message("no-limit-set")
        if state.limit_um is None
        else message("limit-2", limit=rounded(state.limit_um, "µm"))
    )
    quality = limit_quality(half_range_um, state.limit_um) if half_range_um else "neutral"
    value = None if half_range_um is None else max(half_range_um)
    if state.touching:
        note = message("tip-sphere-diameter-arm")
        return LiveNumber(message("largest-distance"), value, "µm", 0, "neutral", note)
    return LiveNumber(message("largest-max-min-2"), value, "µm", 0, quality, note)


def _progress(state: ArmState, seat: SeatSamples | None) -> StepProgress | None:
    if state.step == "swing" and seat is not None:
        taken = len(seat.q_rad)
        if state.touching:
            of = touches_wanted(state)
            return StepProgress(min(taken, of), of, message("points-of", taken=taken, wanted=of))
        swing = swing_deg(seat.q_rad)
        points = (
            message("points-of", taken=taken, wanted=WANTED)
            if taken < WANTED
            else message("points-3", taken=taken)
        )
        text = message("largest-swing", points=points, swing=quantity(swing, "°"))
        return StepProgress(min(taken, WANTED), WANTED, text)
    if state.purpose == "identify" and state.step == "seat":
        done = places_taken(state)
        text = (
            message("places", done=done, seats_wanted=SEATS_WANTED)
            if done <= SEATS_WANTED
            else message("places-2", done=done)
        )
        return StepProgress(min(done, SEATS_WANTED), SEATS_WANTED, text)
    return None


def _findings(state: ArmState, live: ArmLive, picture: ArmPicture) -> list[Finding]:
    findings: list[Finding] = []
    if live.trouble:
        findings.append(live.trouble)
    if live.link.state != "connected":
        findings.append(
            Finding(
                "bad", message("arm", text=live.link.text), message("wait-check-what-taken-kept")
            )
        )
    if state.step == "swing" and live.left_mm is not None:
        findings.append(
            Finding(
                "attention",
                message("tip-seat-no-points-taken-there", left=quantity(live.left_mm, "mm")),
                message("put-back-end-swing"),
            )
        )
    if state.refused is not None:
        findings.append(error_from_payload(state.refused).finding("bad"))
    bar = state.bar_ends > 0 or state.artefact.kind == "bar"
    if state.purpose == "identify" and state.step == "seat" and state.seats and not bar:
        findings.append(
            Finding(
                "neutral",
                message("without-ball-bar-arm-keeps-size"),
                message("take-one-place-two-if-there"),
            )
        )
    if state.purpose == "tip" and state.checked is not None:
        findings.append(tip_finding(state.checked))
    if state.step == "result" and state.purpose == "check":
        findings += _check_findings(state, picture)
    if state.solved is not None:
        warnings = [text_from_json(text) for text in state.solved["warnings"]]
        findings += [Finding("attention", sentence(text)) for text in warnings]
    return findings


def _check_findings(state: ArmState, picture: ArmPicture) -> list[Finding]:
    half_range, two_sigma = picture.half_range_um, picture.two_sigma_um
    encoders = picture.encoders_two_sigma_um
    if half_range is None or two_sigma is None or encoders is None:
        return []
    text = message(
        "n-2-worst-axis",
        two_sigma=quantity(max(two_sigma), "µm"),
        encoders=quantity(max(encoders), "µm"),
    )
    findings = [Finding("neutral", text)]
    if state.limit_um is None:
        text = message("no-limit-set-so-check-neither")
        findings.insert(
            0,
            Finding(
                "attention",
                text,
                message("set-arms-specification-limit-where-next"),
            ),
        )
    elif limit_quality(half_range, state.limit_um) == "bad":
        text = message(
            "exceed-limit-m",
            half_range=quantity(max(half_range), "µm"),
            limit=rounded(state.limit_um, "µm"),
        )
        remedy = message("clean-tip-seat-check-clamps-repeat")
        findings.insert(0, Finding("bad", text, remedy))
    else:
        text = message(
            "within-limit-m",
            half_range=quantity(max(half_range), "µm"),
            limit=rounded(state.limit_um, "µm"),
        )
        findings.insert(0, Finding("good", text))
    return findings


def _actions(state: ArmState, live: ArmLive) -> list[Action]:
    def offer(
        name: str,
        label: Text,
        primary: bool = False,
        confirm: Text = "",
        args: Mapping[str, object] | None = None,
    ) -> Action:
        reason = rejection_reason(state, live, name, args or {})
        return Action(name, label, args or {}, primary, not reason, reason, confirm)

    operator_actions = (
        [offer("run_simulation", message("let-simulation-do"))] if live.has_simulation else []
    )
    if live.simulation_running:
        operator_actions = [offer("stop_simulation", message("stop-simulation"), primary=True)]
    leave = offer("end", message("leave"), confirm=message("leave-session-points-yet-used-kept"))
    if state.touching:
        enough = len(state.seats[-1].q_rad) >= touches_wanted(state)
        return [
            offer("touch", message("take-point"), primary=not enough),
            offer("finish", message("finish-sphere"), primary=enough),
            offer("drop_swing", message("take-again")),
            *operator_actions,
        ]
    if state.step == "swing":
        drop = offer("drop_swing", message("take-again"))
        return [offer("finish", message("finish-swing"), primary=True), drop, *operator_actions]
    if state.step == "seat":
        main = offer("begin", BEGIN[state.artefact.kind], primary=True)
        if state.purpose != "identify":
            return [main, *operator_actions, leave]
        enough = places_taken(state) >= SEATS_WANTED and not state.half_bar
        main = offer("begin", main.label, primary=not enough)
        fit = offer("fit", message("identify-arm"), primary=enough)
        undo = [offer("drop_seat", message("drop-last-place"))] if state.seats else []
        return [main, fit, *undo, *operator_actions, leave]
    if state.purpose != "identify":
        return [
            offer("end", message("done"), primary=True),
            offer("again", message("check-again")),
        ]
    if state.saved:
        restore = offer(
            "restore",
            message("put-arm-back"),
            confirm=message("use-arm-before-what-identified-kept"),
        )
        return [offer("end", message("done"), primary=True), restore]
    save = offer(
        "save",
        message("use-arm-now"),
        primary=True,
    )
    return [save, offer("reopen", message("back-places")), leave]
