"""What the commands of a performance test take, and why one is not possible now. Pure.

An empty reason means that it is possible.
"""

from collections.abc import Sequence
from typing import Annotated, Literal

from pydantic import Field

from crenel.errors import sentence
from crenel.gauges.guide_plan import why_no_scans
from crenel.gauges.plan.document import ARTICULATIONS, ORIENTATIONS
from crenel.gauges.plan.document_symbols import Quantity
from crenel.gauges.plan.maths_lengths import REPEATS
from crenel.gauges.session.acts import redo_reason, touch_reason
from crenel.gauges.session.kind import AnyLive, open_scan_reason
from crenel.gauges.session.state import PerformanceState
from crenel.guide.common.arguments import Args, Arguments, IdArguments, OperatorArguments
from crenel.guide.common.datasheet_library import AnyGauge, Gauges
from crenel.guide.common.journal import error_from_payload
from crenel.guide.common.rules import Command, CommandRules, no_simulation_reason
from crenel.messages.message import Text, message

Reason = Literal["moved", "operating", "device", "plan", "other"]
MOST_UM = 100_000
ALWAYS = ("stop_simulation", "abandon", "again", "finish_scan", "drop_scan")
"""What can be done although the plan stands no more."""


class PositionsArguments(Arguments):
    number: Annotated[int, Field(ge=1, le=2)]


class LimitArguments(Arguments):
    """``a_um``: the maximum permissible error by the datasheet; missing: none. Of a length, it may
    grow by L/``k`` up to ``b_um``."""

    quantity: Quantity
    a_um: Annotated[float, Field(gt=0, le=MOST_UM)] | None = None
    k: Annotated[float, Field(gt=0, le=1e6)] | None = None
    b_um: Annotated[float, Field(gt=0, le=MOST_UM)] | None = None


class TemperatureArguments(Arguments):
    """``celsius`` of the artefact and ``arm_c`` of the arm, at the beginning or at the end, by the
    step; missing: not measured. ``expanded_c`` is the uncertainty of the artefact's, k = 2; it is
    given at the beginning."""

    celsius: Annotated[float, Field(ge=-20, le=60)] | None = None
    arm_c: Annotated[float, Field(ge=-20, le=60)] | None = None
    expanded_c: Annotated[float, Field(ge=0, le=10)] = 0.0


class ByScanArguments(Arguments):
    """``by_scan``: whether the lengths of a ball bar are measured by scan, too."""

    by_scan: bool


class ScanArguments(Arguments):
    """Which scan is repeated, by the ``articulation`` of the sensor over a sphere, its
    ``orientation`` over a plate or the ``repeat`` of a ball bar's present place; missing: the next
    one."""

    articulation: Annotated[int, Field(ge=1, le=ARTICULATIONS)] | None = None
    orientation: Annotated[int, Field(ge=1, le=ORIENTATIONS)] | None = None
    repeat: Annotated[int, Field(ge=1, le=REPEATS)] | None = None


class ReasonArguments(Arguments):
    reason: Reason = "other"


def change_reason(state: PerformanceState, live: AnyLive) -> Text:
    """Said where what was fixed at the first touch is no longer so."""
    if state.calibration_id or not state.by_touch:
        if not live.active_id:
            return message("there-no-calibration-use-calibrate-first")
        if live.active_id != state.calibration_id:
            return message("performance-other-calibration")
    if live.plan_changed:
        return message("performance-plan-changed")
    wanted = bool(state.gauge) + bool(state.bar)
    if len(live.artefacts) < wanted and state.step not in ("artefact", "review"):
        return message("sessions-gauge-arm-cannot-read-any")
    if state.frozen and state.setup != live.setup_now:
        return message("performance-settings-changed")
    return ""


def _frozen(state: PerformanceState, live: AnyLive, args: Args) -> Text:
    return message("performance-plan-is-frozen") if state.frozen else ""


def _set_limit(state: PerformanceState, live: AnyLive, args: Args) -> Text:
    a_um, b_um = args.get("a_um"), args.get("b_um")
    if isinstance(a_um, float) and isinstance(b_um, float) and b_um < a_um:
        return message("performance-cap-not-below-a")
    return _frozen(state, live, args)


def _set_by_scan(state: PerformanceState, live: AnyLive, args: Args) -> Text:
    if not state.touched_and_scanned:
        return message("performance-only-lengths-have-choice")
    why_not = why_no_scans(state, live.artefact) if args.get("by_scan") else ""
    return _frozen(state, live, args) or sentence(why_not)


def _choose(state: PerformanceState, live: AnyLive, args: Args) -> Text:
    return _frozen(state, live, args) or _choice_reason(state, live, live.gauges, args)


def _choose_bar(state: PerformanceState, live: AnyLive, args: Args) -> Text:
    if not state.with_bar:
        return message("performance-bar-of-contact-test")
    return _frozen(state, live, args) or _choice_reason(state, live, live.bars, args)


def _choice_reason(
    state: PerformanceState, live: AnyLive, gauges: Gauges[AnyGauge], args: Args
) -> Text:
    """Why a gauge cannot be chosen; a contact test may be done without one."""
    chosen = args.get("id")
    if chosen == "" and state.with_bar:
        return ""
    if not isinstance(chosen, str) or chosen not in gauges.known:
        return message("there-no-such-gauge")
    return live.obstacles.get(chosen, "")


def _confirm_artefact(state: PerformanceState, live: AnyLive, args: Args) -> Text:
    if live.artefact is None:
        return message("performance-choose-artefact", test=state.test)
    return live.artefact_problems[0] if live.artefact_problems else ""


def _touch(state: PerformanceState, live: AnyLive, args: Args) -> Text:
    if state.due is not None:
        return message("performance-scan-bar-first")
    if len(state.of_step) >= state.wanted:
        return message("performance-all-touched")
    return touch_reason(live)


def _undo(state: PerformanceState, live: AnyLive, args: Args) -> Text:
    if not state.of_step:
        return message("no-touch-taken-yet")
    if len(state.of_step) <= state.confirmed:
        return message("performance-length-is-confirmed")
    return ""


def _confirm(state: PerformanceState, live: AnyLive, args: Args) -> Text:
    return "" if state.step == "temperatures" else live.kind.confirm_reason(state)


def _begin_scan(state: PerformanceState, live: AnyLive, args: Args) -> Text:
    if reason := open_scan_reason(state):
        return reason
    if len(state.scans) >= state.scans_most:
        return message("clouds-enough", clouds_most=state.scans_most)
    return live.kind.begin_scan_reason(state, args) or live.scan_why_not


def _scanning(state: PerformanceState, live: AnyLive, args: Args) -> Text:
    return "" if state.open_scan is not None else message("performance-no-scan-runs")


def _back(state: PerformanceState, live: AnyLive, args: Args) -> Text:
    going_back = state.frozen and state.step != "review"
    return message("performance-no-way-back") if going_back else ""


def _set_temperature(state: PerformanceState, live: AnyLive, args: Args) -> Text:
    return "" if state.step == "temperatures" else _frozen(state, live, args)


def _accept(state: PerformanceState, live: AnyLive, args: Args) -> Text:
    if state.failed is not None:
        return error_from_payload(state.failed).reason
    return "" if live.result is not None else message("performance-is-evaluated")


def _leave(state: PerformanceState, live: AnyLive, args: Args) -> Text:
    return message("performance-finish-scan-first") if state.open_scan is not None else ""


def _simulation(state: PerformanceState, live: AnyLive, args: Args) -> Text:
    return no_simulation_reason(state, live, args) or _leave(state, live, args)


def _check_plan(state: PerformanceState, live: AnyLive, name: str) -> Text:
    return "" if name in ALWAYS else change_reason(state, live)


def _before_freezing(state: PerformanceState) -> Sequence[str]:
    return ("artefact", *state.first)


def _of_scans(state: PerformanceState) -> Sequence[str]:
    return (*state.scanning, *state.touched_and_scanned)


RULES = CommandRules[PerformanceState, AnyLive](
    {
        "choose_gauge": Command(("artefact",), _choose, IdArguments),
        "choose_bar": Command(("artefact",), _choose_bar, IdArguments),
        "set_positions": Command(("artefact",), _frozen, PositionsArguments),
        "set_by_scan": Command(("artefact",), _set_by_scan, ByScanArguments),
        "set_limit": Command(_before_freezing, _set_limit, LimitArguments),
        "set_temperature": Command(
            lambda state: (*_before_freezing(state), "temperatures"),
            _set_temperature,
            TemperatureArguments,
        ),
        "confirm_artefact": Command(("artefact",), _confirm_artefact),
        "touch": Command(lambda state: state.touching, _touch),
        "undo": Command(lambda state: state.touching, _undo),
        "redo": Command(lambda state: state.touching, redo_reason),
        "begin_scan": Command(_of_scans, _begin_scan, ScanArguments),
        "finish_scan": Command(_of_scans, _scanning),
        "drop_scan": Command(_of_scans, _scanning),
        "confirm": Command(lambda state: (*state.between, "temperatures"), _confirm),
        "back": Command(lambda state: (*state.first, "review"), _back),
        "accept": Command(("review",), _accept),
        "run_simulation": Command(
            lambda state: state.all_steps[:-1], _simulation, OperatorArguments
        ),
        "stop_simulation": Command(),
        "abandon": Command(rule=_leave, arguments=ReasonArguments),
        "again": Command(rule=_leave, arguments=ReasonArguments),
    },
    closed=message("performance-is-closed"),
    elsewhere=lambda step: message("performance-another-step", step=step),
    precondition=_check_plan,
)
