"""What the commands of an inspection take, and why one is not possible now. Pure.

An empty reason means that it is possible.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated

from pydantic import Field

from crenel.gauges.session.acts import GaugeLive, redo_reason, touch_reason
from crenel.guide.common.arguments import Args, Arguments, IdArguments, OperatorArguments, ShortText
from crenel.guide.common.journal import error_from_payload
from crenel.guide.common.rules import Command, CommandRules, no_simulation_reason
from crenel.messages.message import Text, message
from crenel.parts.session.evaluate_found import FoundSoFar
from crenel.parts.session.programs import Programs
from crenel.parts.session.state import PartState

if TYPE_CHECKING:
    from crenel.parts.document_program import ProgramFile
    from crenel.parts.document_results import DimensionResult, InspectionFile
    from crenel.parts.session.evaluate_outline import Line

TOUCHING = ("align", "measure")
ALWAYS = ("stop_simulation", "abandon")


class PartArguments(Arguments):
    """The serial number of the part, and who measures it."""

    serial_number: ShortText
    operator: ShortText


class SkipArguments(Arguments):
    id: ShortText
    reason: Annotated[str, Field(min_length=1, max_length=200)]


@dataclass(frozen=True, eq=False, kw_only=True)
class PartLive(GaugeLive):
    """The station as the inspection sees it."""

    programs: Programs
    program: "ProgramFile | None"
    """The chosen one; from the set-up on the session's own copy."""
    outlines: "Mapping[str, tuple[Line, ...]]"
    set_up_reason: Text
    """Why the program cannot be measured with calibration and arm in use."""
    found: FoundSoFar
    by_feature: "Mapping[str, tuple[DimensionResult, ...]]"
    """What was stated of each feature."""
    tips_mm: Mapping[int, tuple[float, float, float]]
    """Tip centres in the part frame, by the number of the touch; empty without a frame."""
    result: "InspectionFile | None"


def _choose_program(state: PartState, live: PartLive, args: Args) -> Text:
    known = args.get("id") in live.programs.known
    return "" if known else message("inspection-has-no-such-program")


def _confirm_setup(state: PartState, live: PartLive, args: Args) -> Text:
    if live.program is None:
        return message("inspection-choose-program")
    return live.set_up_reason


def _touch(state: PartState, live: PartLive, args: Args) -> Text:
    return touch_reason(live) if state.target else message("inspection-all-skipped")


def _undo(state: PartState, live: PartLive, args: Args) -> Text:
    return "" if state.of_step else message("inspection-has-no-touch-yet")


def _of_step(state: PartState, live: PartLive, args: Args) -> Text:
    named = args.get("id")
    known = any(one.id == named for one in state.of_step_features)
    return "" if known else message("inspection-feature-of-other-step")


def _retake(state: PartState, live: PartLive, args: Args) -> Text:
    named = str(args.get("id", ""))
    if reason := _of_step(state, live, args):
        return reason
    return "" if state.count(named) else message("inspection-has-no-touch-yet")


def _skip(state: PartState, live: PartLive, args: Args) -> Text:
    if any(one.id == args.get("id") and one.is_datum for one in state.features):
        return message("inspection-datum-is-needed")
    return _of_step(state, live, args)


def _go_on(state: PartState, live: PartLive, args: Args) -> Text:
    planned = next((one for one in state.of_step_features if one.id == state.feature), None)
    if planned is None or state.count(planned.id) < planned.least:
        return message("inspection-touch-more-first")
    others = [name for name in state.unfinished if name != state.feature]
    return "" if others else message("inspection-nothing-is-left")


def confirm_reason(state: PartState, live: PartLive, args: Args | None = None) -> Text:
    """Why the step is not done yet."""
    if state.unfinished:
        return message("inspection-features-are-left", names=", ".join(state.unfinished))
    if state.step == "align" and live.found.frame is None:
        refusal = live.found.refusal
        return refusal.reason if refusal else message("inspection-frame-not-known")
    if state.step == "measure" and not any(
        state.count(one.id) >= one.least for one in state.of_step_features
    ):
        return message("inspection-all-skipped")
    return ""


def _back(state: PartState, live: PartLive, args: Args) -> Text:
    if state.steps.index(state.step) == 1 and state.counted:
        return message("inspection-program-stands")
    return ""


def _accept(state: PartState, live: PartLive, args: Args) -> Text:
    if state.failed is not None:
        return error_from_payload(state.failed).reason
    return "" if live.result is not None else message("inspection-is-evaluated")


def _arm_reason(state: PartState, live: PartLive, name: str) -> Text:
    if name in ALWAYS or state.step == "review":
        return ""
    if not live.active_id:
        return message("inspection-without-calibration")
    if live.active_id != state.calibration_id and state.step != "setup":
        return message("inspection-calibration-changed")
    return ""


RULES = CommandRules[PartState, PartLive](
    {
        "choose_program": Command(("setup",), _choose_program, IdArguments),
        "name_part": Command(("setup",), None, PartArguments),
        "confirm_setup": Command(("setup",), _confirm_setup),
        "touch": Command(TOUCHING, _touch),
        "undo": Command(TOUCHING, _undo),
        "redo": Command(TOUCHING, redo_reason),
        "choose_feature": Command(TOUCHING, _of_step, IdArguments),
        "next_feature": Command(TOUCHING, _go_on),
        "retake_feature": Command(TOUCHING, _retake, IdArguments),
        "skip_feature": Command(TOUCHING, _skip, SkipArguments),
        "confirm": Command(TOUCHING, confirm_reason),
        "back": Command((*TOUCHING, "review"), _back),
        "accept": Command(("review",), _accept),
        "run_simulation": Command(("setup", *TOUCHING), no_simulation_reason, OperatorArguments),
        "stop_simulation": Command(),
        "abandon": Command(),
    },
    closed=message("inspection-is-closed"),
    elsewhere=lambda step: message("inspection-another-step", step=step),
    precondition=_arm_reason,
)
