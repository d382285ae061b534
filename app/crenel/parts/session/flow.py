"""The view of an inspection, from its state and the station as it is. Pure."""

from functools import partial
from typing import TYPE_CHECKING

from crenel.findings import Finding
from crenel.guide.common.flow import device_findings, list_steps, strain_findings
from crenel.guide.common.journal import error_from_payload
from crenel.guide.common.view import Action, ChoiceOption, StepProgress, progress_of
from crenel.messages.message import Text, join, message
from crenel.parts.session.picture import (
    KIND_WORDS,
    dimension_lines,
    feature_marks,
    frame_text,
    name_part,
    result_view,
    touch_marks,
)
from crenel.parts.session.rules import RULES, TOUCHING, PartLive, confirm_reason
from crenel.parts.session.state import PartState
from crenel.parts.session.view import DimensionLine, PartView

if TYPE_CHECKING:
    from crenel.parts.document_program import ProgramFile

TITLES = {
    "setup": message("inspection-step-setup"),
    "align": message("inspection-step-align"),
    "measure": message("inspection-step-measure"),
    "review": message("result"),
}


def build_view(state: PartState, live: PartLive) -> PartView:
    """The view."""
    running = bool(state.session_id) and not state.ended
    titles = {step: TITLES[step] for step in state.steps}
    return PartView(
        session_id=state.session_id,
        rev=state.rev,
        running=running,
        steps=list_steps(titles, state.step, state.reached),
        step=state.step,
        title=_title(state, live),
        instruction=_instruction(state, live),
        number=None,
        progress=_progress(state) if running else None,
        findings=_findings(state, live) if running else [],
        actions=_actions(state, live) if running else [],
        busy=live.busy,
        programs=[
            ChoiceOption(one.id, one.program.name or one.id, _describe(one.program))
            for one in live.programs.known.values()
        ],
        program=state.program,
        part=_part(state, live),
        serial_number=state.serial_number,
        operator=state.operator,
        calibration=live.active_name,
        feature=state.feature,
        features=feature_marks(state, live) if running else [],
        touches=touch_marks(state, live) if running else [],
        frame=_frame(live) if running else "",
        dimensions=_dimensions(state, live),
        result=result_view(live.result) if live.result and state.step == "review" else None,
    )


def _describe(program: "ProgramFile") -> Text:
    counts = message(
        "inspection-program-counts",
        features=len(program.features),
        dimensions=len(program.dimensions),
    )
    part = program.part
    return join([one for one in (part.name, part.drawing, counts) if one])


def _part(state: PartState, live: PartLive) -> Text:
    name = live.program.part.name or live.program.name if live.program else ""
    return name_part(name, state.serial_number)


def _title(state: PartState, live: PartLive) -> Text:
    if state.step not in TOUCHING or not state.feature or live.program is None:
        return TITLES[state.step]
    kind = KIND_WORDS[live.program.feature(state.feature).kind]
    if state.step == "align":
        return message("inspection-datum-title", feature=state.feature, kind=kind)
    return message("inspection-feature-title", feature=state.feature, kind=kind)


def _instruction(state: PartState, live: PartLive) -> Text:
    if state.step == "setup":
        return message("inspection-do-setup")
    if state.step == "review":
        return message("inspection-do-review")
    target = next((one for one in state.of_step_features if one.id == state.target), None)
    if target is None:
        return message("inspection-do-next-step")
    if not state.unfinished and state.count(target.id) >= target.advised:
        return message("inspection-do-next-step")
    if target.id != state.feature:
        return message("inspection-do-next-feature", feature=target.id)
    return message(
        "inspection-do-touch", feature=target.id, least=target.least, advised=target.advised
    )


def _progress(state: PartState) -> StepProgress | None:
    planned = next((one for one in state.of_step_features if one.id == state.feature), None)
    if planned is None:
        return None
    done, of = state.count(planned.id), planned.advised
    text = message("inspection-touches", done=done, of=of, least=planned.least)
    return progress_of(done, of, text, message("inspection-touches-enough", done=done))


def _frame(live: PartLive) -> Text:
    frame = live.found.frame
    if frame is None or live.program is None or live.program.alignment is None:
        return ""
    return frame_text(frame.datums_um, frame.far_um)


def _dimensions(state: PartState, live: PartLive) -> list[DimensionLine]:
    if live.program is None or state.step != "measure":
        return []
    return dimension_lines(live.by_feature.get(state.feature, ()))


def _findings(state: PartState, live: PartLive) -> list[Finding]:
    findings: list[Finding] = []
    if live.trouble:
        findings.append(live.trouble)
    findings += device_findings(live.arm_link)
    if state.step == "setup":
        findings += live.programs.findings
        if not live.programs.known:
            text = message("inspection-has-no-program")
            findings.append(Finding("attention", text, message("inspection-add-program")))
        if live.program is not None and live.set_up_reason:
            findings.append(Finding("bad", live.set_up_reason))
    if state.step in TOUCHING:
        findings += strain_findings(live.strain)
        if live.found.refusal is not None:
            findings.append(Finding("attention", live.found.refusal.reason))
        if live.found.frame is not None and not live.found.is_full:
            findings.append(Finding("attention", message("inspection-scatter-only")))
    if state.failed is not None:
        findings.append(error_from_payload(state.failed).finding("bad"))
    return findings


def _actions(state: PartState, live: PartLive) -> list[Action]:
    offer = partial(RULES.offer, state, live)
    question = message("inspection-leave-question") if state.counted else ""
    leave = offer("abandon", message("inspection-cancel"), confirm=question)
    simulation = RULES.offer_simulation(state, live, whole=state.step == "setup")
    if state.step == "setup":
        label = message("inspection-part-is-ready")
        return [offer("confirm_setup", label, primary=True), *simulation, leave]
    if state.step == "review":
        accept = offer("accept", message("inspection-finish"), primary=True)
        return [accept, offer("back", message("inspection-measure-more")), leave]
    done = not confirm_reason(state, live)
    go_on = offer("next_feature", message("inspection-next-feature"))
    retake = offer("retake_feature", message("inspection-retake"), {"id": state.feature})
    label = (
        message("inspection-to-features")
        if state.step == "align"
        else message("inspection-to-result")
    )
    return [
        offer("touch", message("inspection-take-touch"), primary=not done),
        offer("confirm", label, primary=done),
        *([go_on] if go_on.enabled and state.target == state.feature else []),
        offer("undo", message("inspection-undo")),
        *(offer("redo", message("inspection-put-back")) for _ in state.undone[-1:]),
        *([retake] if retake.enabled else []),
        *simulation,
        offer("back", message("back")),
        leave,
    ]
