"""The step 'review': how good the calibration is, and the decision. Pure."""

from app.guide.body import Body, geometry, offer
from app.guide.live import Live
from app.guide.outcome import Outcome
from app.guide.state import CalibrationState, Capture
from app.guide.steps_picture import image_url, solve_step
from app.guide.view import Action, CalibrationResult, LiveNumber, ResultPicture
from app.metrology.crenellated import Crenellated


def review_step(state: CalibrationState, live: Live) -> Body:
    """The numbers, the verdict with its reasons, and accept or repeat."""
    seen, picture, block = live.seen, state.picture, live.chosen.block
    if seen is None or seen.result is None or picture is None or block is None:
        return solve_step(state, live)
    result = seen.result
    return Body(
        instruction=_instruction(state, result),
        picture=_picture(state, live, seen, result, _shown(state, result, picture), block),
        number=LiveNumber(
            "Uncertainty of a scanned point (k = 1)",
            result.total_um,
            "µm",
            0,
            result.verdict,
            result.verdict_text,
        ),
        findings=seen.findings,
        actions=_actions(state, live, result),
    )


def _instruction(state: CalibrationState, result: CalibrationResult) -> str:
    if state.ended == "accepted":
        return "It is kept under Records. Scan with it, or calibrate anew."
    if result.verdict == "bad":
        return "This calibration should not be used. The findings say what to do."
    return "Look at the numbers, then accept the calibration or repeat it."


def _shown(state: CalibrationState, result: CalibrationResult, newest: Capture) -> Capture:
    """The picture that the result's corners were found in."""
    return next((one for one in state.pictures if one.number == result.shown_pose), newest)


def _picture(
    state: CalibrationState,
    live: Live,
    seen: Outcome,
    result: CalibrationResult,
    picture: Capture,
    block: Crenellated,
) -> ResultPicture:
    return ResultPicture(
        result=result,
        block=geometry(block),
        points=live.touch.points if live.touch else (),
        image_url=image_url(state.session_id, picture),
        width_px=picture.width_px,
        height_px=picture.height_px,
        corners=seen.corners,
        outline=seen.outline,
        stripe=seen.stripe,
    )


def _actions(state: CalibrationState, live: Live, result: CalibrationResult) -> list[Action]:
    if state.ended:
        return [offer(state, live, "repeat", "Start a new calibration", primary=True)]
    good = result.verdict != "bad"
    return [
        offer(state, live, "accept", "Accept this calibration", primary=good),
        offer(
            state,
            live,
            "repeat",
            "Repeat from the first point",
            primary=not good,
            confirm="Set this calibration aside and start again with the first point?",
        ),
        offer(state, live, "another_pose", "Take another pose"),
        offer(state, live, "back", "Back to the points", {"to": "touch"}),
    ]
