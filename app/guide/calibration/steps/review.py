"""The step 'review': how good the calibration is, and the decision. Pure."""

from app.findings import Finding
from app.guide.calibration.live import CalibrationLive
from app.guide.calibration.outcome import CalibrationOutcome
from app.guide.calibration.state import CalibrationState
from app.guide.calibration.steps.body import StepView, geometry, offer
from app.guide.calibration.steps.capture import solve_step
from app.guide.calibration.steps.poses import pose_pictures
from app.guide.common.result_view import CalibrationResult
from app.guide.common.view import Action, LiveNumber, ResultPicture


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
            "Uncertainty of a scanned point (k = 1)",
            result.total_um,
            "µm",
            0,
            "neutral" if stale else result.verdict,
            "Of before: the poses were changed since." if stale else result.verdict_text,
        ),
        findings=[*_changes(state, result), *_other_findings(seen)] if stale else seen.findings,
        actions=_actions(state, live, result, stale),
    )


def _other_findings(seen: CalibrationOutcome) -> list[Finding]:
    """Those that are not about the number, which is of before."""
    text = seen.result.verdict_text if seen.result else ""
    return [finding for finding in seen.findings if not text.startswith(finding.text)]


def _instruction(state: CalibrationState, result: CalibrationResult, stale: bool) -> str:
    if stale:
        return "The poses were changed. Solve again, or undo the change."
    if state.ended == "accepted":
        return "It is kept under Records. Scan with it, or calibrate anew."
    if result.verdict == "bad":
        return "This calibration should not be used. The findings say what to do."
    return "Look at the numbers, then accept the calibration or repeat it."


def _changes(state: CalibrationState, result: CalibrationResult) -> list[Finding]:
    """Which poses were set aside or taken back since the result was solved."""
    before = {row.number for row in result.poses}
    now = {picture.number for picture in state.pictures}
    told = [f"Pose {n} is set aside" for n in sorted(before - now)]
    told += [f"Pose {n} is taken back" for n in sorted(now - before)]
    return [
        Finding("attention", f"{text}: the figures are of before.", "Solve again.") for text in told
    ]


def _actions(
    state: CalibrationState, live: CalibrationLive, result: CalibrationResult, stale: bool
) -> list[Action]:
    if state.ended:
        return [offer(state, live, "repeat", "Start a new calibration", primary=True)]
    good = result.verdict != "bad" or stale
    return [
        offer(state, live, "solve", "Solve again", primary=True)
        if stale
        else offer(state, live, "accept", "Accept this calibration", primary=good),
        offer(
            state,
            live,
            "repeat",
            "Repeat from the start" if live.chosen.board else "Repeat from the first point",
            primary=not good,
            confirm="Set this calibration aside and start again from the beginning?",
        ),
        offer(state, live, "another_pose", "Take another pose"),
        offer(state, live, "back", "Back to the points", {"to": "touch"}),
    ]
