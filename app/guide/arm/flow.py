"""The view of an arm session, from its state and the station as it is. Pure."""

from collections.abc import Mapping

from app.findings import Finding, Quality
from app.guide.arm.live import ArmLive
from app.guide.arm.picture import build_picture
from app.guide.arm.rules import (
    SEATS_WANTED,
    WANTED,
    places_taken,
    rejection_reason,
    swing_deg,
    touches_wanted,
)
from app.guide.arm.state import ArmState, Kind, SeatSamples
from app.guide.arm.tip import QUALITY as TIP_QUALITY
from app.guide.arm.tip import tip_check_finding as tip_finding
from app.guide.arm.view import ArmPicture, ArmView
from app.guide.common.view import (
    Action,
    ChoiceOption,
    LiveNumber,
    Step,
    StepProgress,
    Vec3,
    sentence,
)
from app.metrology.transforms import Floats

WHERE = ("near the base", "far out", "to the left", "to the right", "high up", "low down")
STEPS = (("seat", "Seat the tip"), ("swing", "Swing the arm"), ("result", "Result"))


BEGIN: dict[Kind, str] = {
    "seat": "The tip is in the seat",
    "bar": "The tip is in the bar's end",
    "sphere": "The sphere is clamped",
}
ON_SPHERE = {"seat": "Clamp the sphere", "swing": "Touch it"}
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
                entry.id, entry.datasheet.name, f"serial number {entry.datasheet.serial_number}"
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
        "Clean the tip, and clamp the sphere",
        "A sphere of known diameter, clamped firmly within easy reach.",
    ),
    "swing": (
        "Touch the sphere",
        "Its top and all around its side, the wrist turned another way each time. Hold still and "
        "press the arm's button at each place.",
    ),
    "result": ("Checked", "The tip's diameter, and how well its touches agree."),
}


def _words(state: ArmState, seat: SeatSamples | None) -> tuple[str, str]:
    if state.purpose == "tip":
        return TIP_WORDS[state.step]
    if state.step == "swing":
        assert seat is not None
        # the ends of a bar keep their capitals
        lower = f"{seat.name[0].lower()}{seat.name[1:]}"
        if state.touching:
            return (
                f"Touch {lower}",
                "Touch it all over its upper half, from every side, with the arm in many "
                "postures. Hold still and press the arm's button at each point.",
            )
        return (
            f"Swing the arm about {lower}",
            "Keep the tip in the seat. Swing the elbow from one side to the other and back, and "
            "lean the wrist every way.",
        )
    if state.step == "result":
        if state.purpose == "check":
            return "Checked", "What the tip moved by while it was held in one place."
        if state.saved:
            return (
                "In use",
                "Calibrate the sensors again: their place belongs to the arm as it was.",
            )
        return (
            "Before and after",
            "On places that were held out of the fit, and over the arm's whole reach.",
        )
    if state.purpose == "check":
        return (
            "Put the tip into the seat",
            "Clamp the cone or ball seat at about two thirds of the reach and put the tip into it.",
        )
    done = len(state.seats)
    where = WHERE[done % len(WHERE)]
    if state.half_bar:
        return "Put the tip into the bar's other end", "Leave the bar where it is."
    if state.artefact.kind == "bar":
        return (
            "Put the tip into an end of the ball bar",
            f"Clamp the bar firmly in the reach, {where}, and put the tip into one end.",
        )
    if state.artefact.kind == "sphere":
        return "Clamp the sphere", f"Clamp it firmly in the reach, {where}."
    if places_taken(state) >= SEATS_WANTED:
        return "Enough places", "Identify the arm, or take more to know it better."
    return (
        f"Put the tip into seat {done + 1}",
        f"Clamp the seat firmly in the reach, {where}, and put the tip into it.",
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
        size = "" if result.size_known else "; apart from the arm's size"
        note = f"was {result.volume_before_um:.0f} µm; k = 1, rms over the reach{size}"
        return LiveNumber("Tip known to", result.volume_after_um, "µm", 1, "neutral", note)
    if state.step == "seat":
        return None
    tip = picture.tip
    if tip is not None:
        note = f"{tip.expected_mm:.3f} mm by its papers; U = {tip.expanded_uncertainty_um:.0f} µm"
        quality = TIP_QUALITY[tip.decision]
        return LiveNumber("The tip's diameter", tip.diameter_mm, "mm", 3, quality, f"{note}, k = 2")
    found = picture.half_range_um
    note = "no limit is set" if state.limit_um is None else f"limit {state.limit_um:g} µm"
    quality = limit_quality(found, state.limit_um) if found else "neutral"
    value = None if found is None else max(found)
    if state.touching:
        note = "of the tip from a sphere of that diameter, by the arm as it is"
        return LiveNumber("Largest distance", value, "µm", 0, "neutral", note)
    return LiveNumber("Largest (max − min)/2", value, "µm", 0, quality, note)


def _progress(state: ArmState, seat: SeatSamples | None) -> StepProgress | None:
    if state.step == "swing" and seat is not None:
        taken = len(seat.q_rad)
        if state.touching:
            of = touches_wanted(state)
            return StepProgress(min(taken, of), of, f"{taken} of {of} points")
        swing = swing_deg(seat.q_rad)
        points = f"{taken} of {WANTED} points" if taken < WANTED else f"{taken} points"
        text = f"{points}, largest swing {swing:.0f}°"
        return StepProgress(min(taken, WANTED), WANTED, text)
    if state.purpose == "identify" and state.step == "seat":
        done = places_taken(state)
        text = f"{done} of {SEATS_WANTED} places" if done <= SEATS_WANTED else f"{done} places"
        return StepProgress(min(done, SEATS_WANTED), SEATS_WANTED, text)
    return None


def _findings(state: ArmState, live: ArmLive, picture: ArmPicture) -> list[Finding]:
    found: list[Finding] = []
    if live.trouble:
        found.append(live.trouble)
    if live.link.state != "connected":
        found.append(
            Finding("bad", f"Arm: {live.link.text}", "Wait, or check it. What was taken is kept.")
        )
    if state.step == "swing" and live.left_mm is not None:
        found.append(
            Finding(
                "attention",
                f"The tip is {live.left_mm:.0f} mm from the seat; no points are taken there.",
                "Put it back, or end the swing.",
            )
        )
    if state.refused is not None:
        why = f": {state.refused['why']}" if state.refused["why"] else ""
        text = sentence(f"{state.refused['what']}{why}")
        found.append(Finding("bad", text, sentence(str(state.refused["remedy"]))))
    bar = state.bar_ends > 0 or state.artefact.kind == "bar"
    if state.purpose == "identify" and state.step == "seat" and state.seats and not bar:
        found.append(
            Finding(
                "neutral",
                "Without a ball bar the arm keeps the size of its papers.",
                "Take one in a place or two, if there is one.",
            )
        )
    if state.purpose == "tip" and state.checked is not None:
        found.append(tip_finding(state.checked))
    if state.step == "result" and state.purpose == "check":
        found += _check_findings(state, picture)
    if state.solved is not None:
        found += [Finding("attention", sentence(text)) for text in state.solved["warnings"]]
    return found


def _check_findings(state: ArmState, picture: ArmPicture) -> list[Finding]:
    half_range, two_sigma = picture.half_range_um, picture.two_sigma_um
    encoders = picture.encoders_two_sigma_um
    if half_range is None or two_sigma is None or encoders is None:
        return []
    by_noise = f"the encoders' noise alone gives {max(encoders):.0f} µm"
    text = f"2σ is {max(two_sigma):.0f} µm on the worst axis; {by_noise}."
    found = [Finding("neutral", text)]
    if state.limit_um is None:
        text = "No limit is set, so this check neither passes nor fails."
        found.insert(
            0,
            Finding(
                "attention",
                text,
                "Set the arm's specification as the limit where the next check begins.",
            ),
        )
    elif limit_quality(half_range, state.limit_um) == "bad":
        text = f"{max(half_range):.0f} µm exceed the limit of {state.limit_um:g} µm."
        remedy = "Clean tip and seat, check the clamps, and repeat. If it stays, identify the arm."
        found.insert(0, Finding("bad", text, remedy))
    else:
        text = f"{max(half_range):.0f} µm, within the limit of {state.limit_um:g} µm."
        found.insert(0, Finding("good", text))
    return found


def _actions(state: ArmState, live: ArmLive) -> list[Action]:
    def offer(
        name: str,
        label: str,
        primary: bool = False,
        confirm: str = "",
        args: Mapping[str, object] | None = None,
    ) -> Action:
        reason = rejection_reason(state, live, name, args or {})
        return Action(name, label, args or {}, primary, not reason, reason, confirm)

    hand = [offer("let_hand", "Let the hand do it")] if live.has_hand else []
    if live.hand_running:
        hand = [offer("stop_hand", "Stop the hand", primary=True)]
    leave = offer("end", "Leave", confirm="Leave this session? Points not yet used are kept aside.")
    if state.touching:
        enough = len(state.seats[-1].q_rad) >= touches_wanted(state)
        return [
            offer("touch", "Take the point", primary=not enough),
            offer("finish", "Finish the sphere", primary=enough),
            offer("drop_swing", "Take it again"),
            *hand,
        ]
    if state.step == "swing":
        drop = offer("drop_swing", "Take it again")
        return [offer("finish", "Finish the swing", primary=True), drop, *hand]
    if state.step == "seat":
        main = offer("begin", BEGIN[state.artefact.kind], primary=True)
        if state.purpose != "identify":
            return [main, *hand, leave]
        enough = places_taken(state) >= SEATS_WANTED and not state.half_bar
        main = offer("begin", main.label, primary=not enough)
        fit = offer("fit", "Identify the arm", primary=enough)
        undo = [offer("drop_seat", "Drop the last place")] if state.seats else []
        return [main, fit, *undo, *hand, leave]
    if state.purpose != "identify":
        return [
            offer("end", "Done", primary=True),
            offer("again", "Check again"),
        ]
    if state.saved:
        restore = offer(
            "restore",
            "Put the arm back as it was",
            confirm="Use the arm as it was before? What was identified is kept in this session.",
        )
        return [offer("end", "Done", primary=True), restore]
    save = offer(
        "save",
        "Use this arm from now on",
        primary=True,
    )
    return [save, offer("reopen", "Back to the places"), leave]
