"""What a verification sees of the station, what its commands take, and why one is not possible
now. Pure.

An empty reason means that it is possible.
"""

from collections.abc import Mapping
from dataclasses import dataclass

from crenel.errors import OperationError
from crenel.gauges.plan.document_gauge import GaugeFile, VerificationLimits
from crenel.gauges.quick.document import FigurePart, VerificationVerdict
from crenel.gauges.quick.evaluate import CloudErrors
from crenel.gauges.quick.evaluate_gauge import GaugeFit
from crenel.gauges.quick.guide.state import STEPS, VerifyState
from crenel.gauges.quick.maths.probed_gauge import PLANE_LEAST, SPHERE_LEAST, ProbedGauge
from crenel.gauges.session.acts import GaugeLive, redo_reason, touch_reason
from crenel.guide.common.arguments import (
    Args,
    BackArguments,
    IdArguments,
    IndexArguments,
    NumberArguments,
    OperatorArguments,
)
from crenel.guide.common.datasheet_library import Gauges
from crenel.guide.common.rules import Command, CommandRules, no_simulation_reason
from crenel.messages.message import Text, message
from crenel.metrology.decision import DecisionRule
from crenel.metrology.fitting.touched_shape import doubt_error

CLOUDS_WANTED = 3
"""A spread is known to a factor of two; the article took ten."""
CLOUDS_MOST = 30
PLANE_WANTED, SPHERE_WANTED = 6, 7
"""Touches beyond the least, so that their scatter shows how well they fix the gauge."""
OTHER_SIZE_MM, OTHER_SIZE_SDS = 0.3, 3.0
"""The touched radius may differ from the nominal by so much, and so many of its own sd."""

WHATEVER_IS_IN_USE = ("stop_simulation", "abandon", "again", "finish_cloud", "drop_cloud")
"""What can be done although another calibration is in use by now."""


@dataclass(frozen=True)
class CloudResults:
    """What the clouds that count show."""

    fits: Mapping[int, GaugeFit]
    """The fits of every cloud that was measured, by its number."""
    errors: Mapping[int, CloudErrors]
    figures: tuple[FigurePart, ...]
    verdict: VerificationVerdict | None


@dataclass(frozen=True, eq=False, kw_only=True)
class VerifyLive(GaugeLive):
    """The station as the verification sees it."""

    gauges: Gauges[GaugeFile]
    gauge: GaugeFile | None
    """The chosen one; from the touches on the session's own copy."""
    limits: VerificationLimits
    touched: ProbedGauge | OperationError | None
    """The gauge by the touches, or why they do not fix it; None without touches."""
    judged: CloudResults
    rule: DecisionRule


def change_reason(state: VerifyState, live: VerifyLive) -> Text:
    """Said where another calibration came into use since the session began."""
    if not live.active_id:
        return message("there-no-calibration-use-calibrate-first")
    if live.active_id != state.calibration_id:
        return message("another-calibration-came-into-use-meanwhile")
    return ""


def touches_needed(live: VerifyLive) -> int:
    """Touches that fix the chosen gauge."""
    plane = live.gauge is not None and live.gauge.shape == "plane"
    return PLANE_LEAST if plane else SPHERE_LEAST


def touches_wanted(live: VerifyLive) -> int:
    """Touches that are asked for."""
    plane = live.gauge is not None and live.gauge.shape == "plane"
    return PLANE_WANTED if plane else SPHERE_WANTED


def _choose(state: VerifyState, live: VerifyLive, args: Args) -> Text:
    chosen = args.get("id")
    known = isinstance(chosen, str) and chosen in live.gauges.known
    return "" if known else message("there-no-such-gauge")


def _confirm_gauge(state: VerifyState, live: VerifyLive, args: Args) -> Text:
    if live.gauge is None:
        if not live.gauges.known:
            return message("there-no-gauge-data-folder-yet")
        return message("choose-gauge-first")
    return ""


def _touch(state: VerifyState, live: VerifyLive, args: Args) -> Text:
    return touch_reason(live)


def _undo(state: VerifyState, live: VerifyLive, args: Args) -> Text:
    if state.step == "touch":
        return "" if state.counted else message("no-touch-taken-yet")
    if state.open_cloud is not None:
        return message("finish-cloud-drop")
    left = any(not cloud.voided for cloud in state.listed)
    return "" if left else message("no-cloud-taken-yet")


def _void_touch(state: VerifyState, live: VerifyLive, args: Args) -> Text:
    index = args.get("index")
    known = type(index) is int and any(touch.index == index for touch in state.counted)
    return "" if known else message("there-no-such-touch")


def _confirm_touch(state: VerifyState, live: VerifyLive, args: Args) -> Text:
    taken = len(state.counted)
    if taken < touches_needed(live):
        return message("touch-more-least-places", taken=taken, touches_needed=touches_needed(live))
    if isinstance(live.touched, OperationError):
        return live.touched.text
    doubt = None if live.touched is None else doubt_error(live.touched.doubtful)
    return "" if doubt is None else doubt.text


def _begin(state: VerifyState, live: VerifyLive, args: Args) -> Text:
    if state.open_cloud is not None:
        return message("cloud-being-scanned-already")
    if any(cloud.waiting for cloud in state.clouds):
        return message("last-cloud-not-evaluated-yet")
    if len(state.clouds) >= CLOUDS_MOST:
        return message("clouds-enough", clouds_most=CLOUDS_MOST)
    return live.scan_why_not


def _scanning(state: VerifyState, live: VerifyLive, args: Args) -> Text:
    return "" if state.open_cloud is not None else message("no-cloud-being-scanned")


def _cloud(state: VerifyState, live: VerifyLive, args: Args) -> Text:
    if state.open_cloud is not None:
        return message("finish-cloud-drop")
    number = args.get("number")
    known = type(number) is int and any(cloud.number == number for cloud in state.listed)
    return "" if known else message("there-no-such-cloud")


def _enough(state: VerifyState, live: VerifyLive, args: Args) -> Text:
    if state.open_cloud is not None:
        return message("finish-cloud-first")
    if any(cloud.waiting for cloud in state.clouds):
        return message("last-cloud-not-evaluated-yet")
    return "" if state.good else message("no-cloud-shows-gauge-yet-scan")


def _back(state: VerifyState, live: VerifyLive, args: Args) -> Text:
    if state.open_cloud is not None:
        return message("finish-cloud-drop")
    to = args.get("to")
    if to is None:
        return ""
    if to not in STEPS or STEPS.index(str(to)) >= STEPS.index(state.step):
        return message("step-before-one")
    return ""


def _simulation(state: VerifyState, live: VerifyLive, args: Args) -> Text:
    return no_simulation_reason(state, live, args) or _leave(state, live, args)


def _leave(state: VerifyState, live: VerifyLive, args: Args) -> Text:
    return message("finish-cloud-drop") if state.open_cloud is not None else ""


def _check_calibration(state: VerifyState, live: VerifyLive, name: str) -> Text:
    return "" if name in WHATEVER_IS_IN_USE else change_reason(state, live)


RULES = CommandRules[VerifyState, VerifyLive](
    {
        "choose_gauge": Command(("gauge",), _choose, IdArguments),
        "confirm_gauge": Command(("gauge",), _confirm_gauge),
        "touch": Command(("touch",), _touch),
        "undo": Command(("touch", "scan"), _undo),
        "redo": Command(("touch",), redo_reason),
        "void_touch": Command(("touch",), _void_touch, IndexArguments),
        "confirm_touch": Command(("touch",), _confirm_touch),
        "skip_touch": Command(("touch",)),
        "begin_cloud": Command(("scan",), _begin),
        "finish_cloud": Command(("scan",), _scanning),
        "drop_cloud": Command(("scan",), _scanning),
        "void_cloud": Command(("scan", "review"), _cloud, NumberArguments),
        "restore_cloud": Command(("scan", "review"), _cloud, NumberArguments),
        "confirm_clouds": Command(("scan",), _enough),
        "more_clouds": Command(("review",)),
        "accept": Command(("review",), _enough),
        "back": Command(STEPS[1:], _back, BackArguments),
        "run_simulation": Command(STEPS[:-1], _simulation, OperatorArguments),
        "stop_simulation": Command(),
        "abandon": Command(rule=_leave),
        "again": Command(rule=_leave),
    },
    closed=message("verification-closed-start-new-one"),
    elsewhere=lambda step: message("belongs-another-step-verification-stands", step=step),
    precondition=_check_calibration,
)
