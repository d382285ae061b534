"""The view of an arm session, from its state and the station as it is. Pure."""

from functools import partial

from crenel.errors import sentence
from crenel.findings import Finding, Quality
from crenel.guide.arm.instructions import instruct
from crenel.guide.arm.picture import build_picture
from crenel.guide.arm.rules import (
    RULES,
    SEATS_WANTED,
    WANTED,
    places_taken,
    swing_deg,
    touches_wanted,
)
from crenel.guide.arm.state import ArmLive, ArmState, Kind, SeatSamples
from crenel.guide.arm.tip import tip_check_finding
from crenel.guide.arm.view import ArmPicture, ArmView
from crenel.guide.common.flow import DECISION_QUALITY, device_findings, list_steps
from crenel.guide.common.journal import error_from_payload
from crenel.guide.common.view import (
    Action,
    ChoiceOption,
    LiveNumber,
    StepProgress,
    Vec3,
    progress_of,
)
from crenel.messages.limits import beside_limit
from crenel.messages.message import Text, message, quantity, rounded, text_from_json
from crenel.messages.uncertainty import uncertainty_quantity
from crenel.metrology.transforms import Floats

STEPS: dict[str, Text] = {
    "seat": message("seat-tip"),
    "swing": message("swing-arm"),
    "result": message("result"),
}


BEGIN: dict[Kind, Text] = {
    "seat": message("tip-seat"),
    "bar": message("tip-bars-end"),
    "sphere": message("sphere-clamped"),
}
ON_SPHERE: dict[str, Text] = {"seat": message("clamp-sphere"), "swing": message("touch")}
WITH_SPHERE = ("identify", "tip")


def build_view(state: ArmState, live: ArmLive) -> ArmView:
    """The view."""
    running = bool(state.session_id) and not state.ended
    step = state.step
    seat = state.seats[-1] if state.seats else None
    picture = build_picture(state, live, seat)
    title, instruction = instruct(state, seat)
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
        coordinates=state.coordinates,
        steps=list_steps(_titles(state), step, step),
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


def _titles(state: ArmState) -> dict[str, Text]:
    """The titles of the steps; a sphere is touched, a seat is swung in."""
    sphere = state.purpose in WITH_SPHERE and state.artefact.kind == "sphere"
    return STEPS | ON_SPHERE if sphere else STEPS


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
            expanded_uncertainty=uncertainty_quantity(tip.expanded_uncertainty_um, "µm"),
        )
        quality = DECISION_QUALITY[tip.decision]
        return LiveNumber(message("tips-diameter"), tip.diameter_mm, "mm", 3, quality, note)
    half_range_um = picture.half_range_um
    note = (
        message("no-limit-set")
        if state.limit_um is None
        else message("limit-of-figure", limit=rounded(state.limit_um, "µm"))
    )
    quality = limit_quality(half_range_um, state.limit_um) if half_range_um else "neutral"
    value = None if half_range_um is None else max(half_range_um)
    if state.touching:
        note = message("tip-sphere-diameter-arm")
        return LiveNumber(message("largest-distance"), value, "µm", 0, "neutral", note)
    return LiveNumber(message("largest-half-range"), value, "µm", 0, quality, note)


def _progress(state: ArmState, seat: SeatSamples | None) -> StepProgress | None:
    if state.step == "swing" and seat is not None:
        taken = len(seat.q_rad)
        if state.touching:
            of = touches_wanted(state)
            text = message("points-of", taken=taken, wanted=of)
            return progress_of(taken, of, text, message("points-taken", taken=taken))
        swing = swing_deg(seat.q_rad)
        points = (
            message("points-of", taken=taken, wanted=WANTED)
            if taken < WANTED
            else message("points-taken", taken=taken)
        )
        text = message("largest-swing", points=points, swing=quantity(swing, "°"))
        return StepProgress(min(taken, WANTED), WANTED, text)
    if state.purpose == "identify" and state.step == "seat":
        done = places_taken(state)
        text = message("places", done=done, seats_wanted=SEATS_WANTED)
        return progress_of(done, SEATS_WANTED, text, message("places-done", done=done))
    return None


def _findings(state: ArmState, live: ArmLive, picture: ArmPicture) -> list[Finding]:
    findings: list[Finding] = []
    if live.trouble:
        findings.append(live.trouble)
    findings += device_findings(live.link)
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
    bar = bar or state.coordinates > 0
    if state.purpose == "identify" and state.step == "seat" and state.seats and not bar:
        findings.append(
            Finding(
                "neutral",
                message("without-ball-bar-arm-keeps-size"),
                message("take-one-place-two-if-there"),
            )
        )
    if state.purpose == "tip" and state.checked is not None:
        findings.append(tip_check_finding(state.checked))
    if state.step == "result" and state.purpose == "check":
        findings += _check_findings(state, picture)
    if state.solved is not None:
        warnings = [text_from_json(text) for text in state.solved["warnings"]]
        findings += [Finding("attention", sentence(text)) for text in warnings]
        left_out = [text_from_json(text) for text in state.solved.get("outliers", ())]
        findings += [Finding("attention", text) for text in left_out]
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
    if picture.largest_um is not None and picture.two_s_um is not None:
        in_space = message(
            "in-space-largest-and-two-s",
            largest=quantity(picture.largest_um, "µm"),
            two_s=quantity(picture.two_s_um, "µm"),
        )
        findings.append(Finding("neutral", in_space))
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
        worst, limit = beside_limit(max(half_range), state.limit_um, "µm")
        text = message("exceed-limit-m", half_range=worst, limit=limit)
        remedy = message("clean-tip-seat-check-clamps-repeat")
        findings.insert(0, Finding("bad", text, remedy))
    else:
        worst, limit = beside_limit(max(half_range), state.limit_um, "µm")
        text = message("within-limit-m", half_range=worst, limit=limit)
        findings.insert(0, Finding("good", text))
    return findings


def _actions(state: ArmState, live: ArmLive) -> list[Action]:
    offer = partial(RULES.offer, state, live)
    operator_actions = RULES.offer_simulation(state, live)
    leave = offer(
        "end", message("cancel-session"), confirm=message("leave-session-unused-points-kept")
    )
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
        enough = places_taken(state) >= SEATS_WANTED or state.coordinates > 0
        enough = enough and not state.half_bar
        main = offer("begin", main.label, primary=not enough)
        fit = offer("fit", message("identify-arm"), primary=enough)
        undo = [offer("drop_seat", message("drop-last-place"))] if state.seats else []
        if state.coordinates:
            undo.append(offer("drop_coordinates", message("drop-coordinates")))
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
