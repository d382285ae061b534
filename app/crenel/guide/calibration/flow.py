"""The guided calibration: the journal's state and the live station, as one view. Pure."""

from collections.abc import Callable

from crenel.guide.calibration.live import CalibrationLive
from crenel.guide.calibration.rules import RULES, offer
from crenel.guide.calibration.state import CalibrationState
from crenel.guide.calibration.steps.body import StepView
from crenel.guide.calibration.steps.capture import capture_step, place_step, solve_step
from crenel.guide.calibration.steps.review import review_step
from crenel.guide.calibration.steps.setup import devices_step, setup_step
from crenel.guide.calibration.steps.touch import touch_step
from crenel.guide.common.flow import list_steps
from crenel.guide.common.view import Action, FlowView
from crenel.messages.message import message

TITLES = {
    "devices": message("devices"),
    "setup": message("set-up"),
    "touch": message("touch-heading"),
    "place": message("hold"),
    "capture": message("capture"),
    "solve": message("calibrate"),
    "review": message("review"),
}
HEADINGS = {
    "devices": message("check-devices"),
    "setup": message("choose-what-use"),
    "touch": message("touch-object"),
    "place": message("hold-sensor-over-object"),
    "capture": message("take-picture"),
    "solve": message("calibrate"),
    "review": message("review-calibration"),
}
BODIES: dict[str, Callable[[CalibrationState, CalibrationLive], StepView]] = {
    "devices": devices_step,
    "setup": setup_step,
    "touch": touch_step,
    "place": place_step,
    "capture": capture_step,
    "solve": solve_step,
    "review": review_step,
}


def build_view(state: CalibrationState, live: CalibrationLive) -> FlowView:
    """Everything that the browser shows of the calibration, for any state."""
    if state.ended in ("abandoned", "repeated"):
        state = CalibrationState(choices=state.choices)
    body = BODIES[state.step](state, live)
    running, accepted = bool(state.session_id) and not state.ended, state.ended == "accepted"
    common = _common_actions(state, live) if running else []
    return FlowView(
        session_id=state.session_id,
        rev=live.rev,
        running=running,
        steps=list_steps(TITLES, state.step, state.reached, over=accepted),
        step=state.step,
        title=message("calibration-use") if accepted else HEADINGS[state.step],
        instruction=body.instruction,
        picture=body.picture,
        number=body.number,
        progress=body.progress,
        findings=[*([live.trouble] if live.trouble else []), *body.findings],
        actions=[*(body.actions if running or accepted else ()), *common],
        busy=live.busy,
    )


def _common_actions(state: CalibrationState, live: CalibrationLive) -> list[Action]:
    """What every step offers: the simulated operator, the way back, the way out."""
    actions = []
    if live.taking_poses:
        label = message("end-pictures-by-themselves")
        actions.append(offer(state, live, "stop_poses", label, primary=True))
    elif live.simulation_running or state.step != "review":
        actions = RULES.offer_simulation(state, live, whole=state.step == "devices")
    if state.step not in ("devices", "review"):
        actions.append(offer(state, live, "back", message("back")))
    confirm = message("abandon-calibration-calibration-use-stays")
    return [*actions, offer(state, live, "abandon", message("cancel-calibration"), confirm=confirm)]
