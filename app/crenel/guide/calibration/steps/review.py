"""The step 'review': how good the calibration is, and the decision. Pure."""

from crenel.findings import Finding
from crenel.guide.calibration.live import CalibrationLive
from crenel.guide.calibration.outcome import CalibrationOutcome
from crenel.guide.calibration.rules import offer
from crenel.guide.calibration.state import CalibrationState
from crenel.guide.calibration.steps.body import StepView, geometry
from crenel.guide.calibration.steps.capture import solve_step
from crenel.guide.calibration.steps.poses import pose_pictures
from crenel.guide.common.result_view import CalibrationResult
from crenel.guide.common.view import Action, LiveNumber, ResultPicture
from crenel.messages.message import Text, mentions, message
from crenel.messages.uncertainty import POINT_DECIMALS


def review_step(state: CalibrationState, live: CalibrationLive) -> StepView:
    """The numbers, the verdict with its reasons, and accept or repeat."""
    seen, item = live.latest_outcome, live.chosen.object
    if seen is None or seen.result is None or item is None:
        return solve_step(state, live)
    result, stale = seen.result, state.outcome is None
    return StepView(
        instruction=_instruction(state, result, stale),
        picture=ResultPicture(
            result=result,
            stale=stale,
            object=geometry(item),
            points=seen.points or (live.touch.points if live.touch else ()),
            poses=pose_pictures(state, live, seen),
        ),
        number=LiveNumber(
            message("uncertainty-seen-point-k-1")
            if _lacks_laser(result)
            else message("uncertainty-scanned-point-k-1"),
            result.total_um,
            "µm",
            POINT_DECIMALS,
            "neutral" if stale else result.verdict,
            message("before-poses-were-changed-since") if stale else result.verdict_text,
        ),
        findings=[*_changes(state, result), *_other_findings(seen)] if stale else seen.findings,
        actions=_actions(state, live, result, stale),
    )


def _other_findings(seen: CalibrationOutcome) -> list[Finding]:
    """Those that are not about the number, which is of before."""
    verdict = seen.result.verdict_text if seen.result else ""
    return [finding for finding in seen.findings if not mentions(verdict, finding.text)]


def _instruction(state: CalibrationState, result: CalibrationResult, stale: bool) -> Text:
    if stale:
        return message("poses-were-changed-solve-again-undo")
    if state.ended == "accepted" and _lacks_laser(result):
        return message("camera-and-mounting-are-stored")
    if state.ended == "accepted":
        return message("stored-under-records-scan-or-calibrate-again")
    if result.verdict == "bad":
        return message("calibration-not-to-be-used-findings-say-what")
    return message("look-numbers-then-accept-calibration-repeat")


def _lacks_laser(result: CalibrationResult) -> bool:
    """Whether camera and mounting alone were calibrated."""
    return result.laser_plane_rms_um is None


def _changes(state: CalibrationState, result: CalibrationResult) -> list[Finding]:
    """Which poses were set aside or taken back since the result was solved."""
    before = {row.number for row in result.poses}
    now = {picture.number for picture in state.pictures}
    changes = [message("pose-excluded", n=n) for n in sorted(before - now)]
    changes += [message("pose-taken-back", n=n) for n in sorted(now - before)]
    return [
        Finding("attention", message("figures-before", text=text), message("solve-again"))
        for text in changes
    ]


def _actions(
    state: CalibrationState, live: CalibrationLive, result: CalibrationResult, stale: bool
) -> list[Action]:
    if state.ended:
        more = _lacks_laser(result)
        again = offer(state, live, "repeat", message("start-new-calibration"), primary=not more)
        laser = offer(state, live, "add_laser", message("add-the-laser"), primary=True)
        return [laser, again] if more else [again]
    good = result.verdict != "bad" or stale
    return [
        offer(state, live, "solve", message("compute-again"), primary=True)
        if stale
        else offer(state, live, "accept", message("accept-calibration"), primary=good),
        offer(
            state,
            live,
            "repeat",
            message("repeat-start") if live.chosen.board else message("repeat-first-point"),
            primary=not good,
            confirm=message("set-calibration-aside-start-again-beginning"),
        ),
        offer(state, live, "another_pose", message("take-another-pose")),
        offer(state, live, "back", message("back-points"), {"to": "touch"}),
    ]
