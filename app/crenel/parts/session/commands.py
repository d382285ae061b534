"""The operator's commands in an inspection; each leaves a row in the journal."""

from crenel.guide.common.arguments import Args
from crenel.guide.common.buttons import ButtonName
from crenel.guide.common.commands import Act, Commands, record, simulation_acts
from crenel.guide.common.simulated_operator import SimulatedOperator
from crenel.guide.common.simulation import act_as_operator, touch_until_taken, work_on_steps
from crenel.messages.message import message
from crenel.parts.session import tasks
from crenel.parts.session.guide import PartGuide
from crenel.parts.session.rules import TOUCHING, confirm_reason
from crenel.station.jobs import Progress


def button_command(guide: PartGuide, button: ButtonName) -> str:
    """The arm's buttons: primary takes a touch, and once all is touched goes on; undo takes a touch
    back, and back goes a step back."""
    if guide.state.step not in TOUCHING:
        return "back" if button == "back" and guide.state.step == "review" else ""
    if button != "primary":
        return button
    done = is_step_full(guide) and not confirm_reason(guide.state, guide.live())
    return "confirm" if done and not guide.simulation_running else "touch"


def is_step_full(guide: PartGuide) -> bool:
    """Whether the next touch would be one more of a feature that has the advised ones."""
    state = guide.state
    target = next((one for one in state.of_step_features if one.id == state.target), None)
    if target is None or state.unfinished:
        return not state.unfinished
    return not state.more and state.count(target.id) >= target.advised


def evaluate_waiting(guide: PartGuide) -> None:
    """Evaluates an inspection that waits for it, as after a restart, unless something is at
    work."""
    if not guide.running or guide.station.jobs.current is not None:
        return
    state = guide.state
    if state.step == "review" and guide.result() is None and state.failed is None:
        guide.start_job(
            message("inspection-evaluating"), lambda progress: tasks.evaluate(guide, progress)
        )


def _touch_at(guide: PartGuide, stamp_ns: int) -> None:
    """Takes a touch at the press of a button, unless something is at work."""
    if guide.simulation_running or guide.station.jobs.current is None:
        guide.touch(stamp_ns, None)


def _go_back(guide: PartGuide, args: Args, key: str | None) -> None:
    steps = guide.state.steps
    guide.append("went_back", {"to": steps[steps.index(guide.state.step) - 1]}, key)


def _undo(guide: PartGuide, args: Args, key: str | None) -> None:
    guide.append("touch_voided", {"index": guide.state.of_step[-1].index}, key)
    guide.keep_touches()


def _redo(guide: PartGuide, args: Args, key: str | None) -> None:
    guide.append("touch_restored", {"index": guide.state.undone[-1]}, key)
    guide.keep_touches()


def _retake(guide: PartGuide, args: Args, key: str | None) -> None:
    guide.append("feature_retaken", {"id": args["id"]}, key)
    guide.keep_touches()


def _simulate(
    guide: PartGuide, operator: SimulatedOperator, whole: bool, progress: Progress
) -> None:
    """Does the present step, or goes on up to the result."""
    steps = {"setup": _simulate_setup, "align": _simulate_touches, "measure": _simulate_touches}
    work_on_steps(steps, guide, operator, whole, progress)


def _simulate_setup(guide: PartGuide, operator: SimulatedOperator, progress: Progress) -> None:
    act_as_operator(guide, "confirm_setup", lambda: guide.confirm_setup(None))


def _simulate_touches(guide: PartGuide, operator: SimulatedOperator, progress: Progress) -> None:
    """Touches each feature of the step as often as is advised."""
    features = guide.state.of_step_features
    for number, planned in enumerate(features):
        while guide.state.count(planned.id) < planned.advised:
            done = guide.state.count(planned.id)
            progress(
                message("inspection-simulation-touches", feature=planned.id, number=done + 1),
                (number + done / planned.advised) / len(features),
            )
            with guide.lock:
                if not guide.simulation_running or planned.id in guide.state.skipped:
                    break
                if guide.state.target != planned.id:
                    guide.append("feature_chosen", {"id": planned.id})

            def touch(attempt: int, name: str = planned.id, index: int = done) -> bool:
                return operator.touch_part(name, index + attempt)

            taken = touch_until_taken(
                guide,
                touch,
                lambda: len(guide.state.counted),
                message("inspection-simulation-declined", feature=planned.id),
            )
            if not taken:
                return
    if guide.simulation_running:
        act_as_operator(guide, "confirm", lambda: guide.append("step_confirmed", {}))


ACTS: dict[str, Act[PartGuide]] = {
    "choose_program": record("program_chosen", "id"),
    "name_part": record("part_named", "serial_number", "operator"),
    "confirm_setup": lambda guide, args, key: guide.confirm_setup(key),
    "touch": lambda guide, args, key: guide.touch(None, key),
    "undo": _undo,
    "redo": _redo,
    "choose_feature": record("feature_chosen", "id"),
    "next_feature": record("went_on"),
    "retake_feature": _retake,
    "skip_feature": record("feature_skipped", "id", "reason"),
    "confirm": record("step_confirmed"),
    "back": _go_back,
    "accept": lambda guide, args, key: tasks.accept(guide, key),
    **simulation_acts(_simulate),
    "abandon": record("abandoned"),
}
COMMANDS = Commands(ACTS, button_command, {"touch": _touch_at})
