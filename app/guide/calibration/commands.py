"""The operator's commands in a calibration; each leaves a row in the journal."""

from collections.abc import Callable

from app.errors import OperationError
from app.guide.calibration import tasks
from app.guide.calibration.guide import CalibrationGuide
from app.guide.calibration.simulated_operator import simulation_job
from app.guide.calibration.state import STEPS
from app.guide.calibration.tasks import CONFIRMATIONS, confirm
from app.guide.calibration.touch import points as taking
from app.guide.common.arguments import Args
from app.guide.common.buttons import ButtonName, Press
from app.guide.common.commands import AT_ANY_REV, start_job, start_simulation, stop_simulation
from app.guide.common.view import FlowView
from app.messages.message import message


def command(guide: CalibrationGuide, name: str, args: Args, rev: int, key: str) -> FlowView:
    """Does a command of the browser, once for each ``key``.

    Raises:
        StaleCommand: ``rev`` is not that of the present view, which it carries.
        OperationError: the command is not possible now.
    """
    with guide.lock:
        if guide.knows_key(key):
            return guide.refresh()
        rev_seen = None if name in AT_ANY_REV else rev
        _act(guide, name, guide.check_allowed(name, args, rev_seen), key)
        return guide.refresh()


BY_MAIN_BUTTON = ("place", "capture", "solve")
"""Steps whose main action the arm's main button does too. Devices, set-up and the result are
looked at, and confirmed on the screen."""


def button_command(guide: CalibrationGuide, button: ButtonName) -> tuple[str, Args]:
    """The command that a button of the arm gives now; its name is empty for none."""
    step = guide.state.step
    if not guide.running:
        return "", {}
    if button == "back":
        return ("back" if step != STEPS[0] else ""), {}
    if step == "touch":
        return ("take_point" if button == "primary" else "undo"), {}
    if button == "primary" and step in BY_MAIN_BUTTON and not guide.simulation_running:
        for action in guide.view().actions:
            if action.primary:
                return action.name, action.args
    return "", {}


def press(guide: CalibrationGuide, event: Press) -> bool:
    """The arm's buttons: primary takes a point or does the step's main action, undo takes a
    point back, and back goes a step back. False where the button means nothing now."""
    with guide.lock:
        name, args = button_command(guide, event.button)
        if not name:
            return False
        by_simulation = guide.simulation_running and guide.state.step == "touch"
        try:
            if name == "take_point":
                # whether the arm was still is judged as of the press, not as of now
                source = "simulation" if by_simulation else "button"
                taking.take_point(guide, source, event.stamp_ns, None)
            else:
                undoing = by_simulation and name == "undo"
                _act(guide, name, guide.check_allowed(name, args, None, undoing), None)
        except OperationError as refusal:
            guide.decline(refusal)
        guide.refresh()
        return True


def _act(guide: CalibrationGuide, name: str, args: Args, key: str | None) -> None:
    if name in CONFIRMATIONS:
        confirm(guide, name, key)
    else:
        ACTS[name](guide, args, key)


def _choose(guide: CalibrationGuide, args: Args, key: str | None) -> None:
    guide.append("chosen", {"field": args["field"], "id": args["id"]}, key)


def _select_face(guide: CalibrationGuide, args: Args, key: str | None) -> None:
    guide.append("face_selected", {"face": args["face"]}, key)


def _take_point(guide: CalibrationGuide, args: Args, key: str | None) -> None:
    taking.take_point(guide, "click", None, key)


def _undo(guide: CalibrationGuide, args: Args, key: str | None) -> None:
    taking.undo(guide, key)


def _redo(guide: CalibrationGuide, args: Args, key: str | None) -> None:
    taking.redo(guide, key)


def _void_point(guide: CalibrationGuide, args: Args, key: str | None) -> None:
    index = args["index"]
    assert isinstance(index, int)
    taking.void_point(guide, index, key)


def _back(guide: CalibrationGuide, args: Args, key: str | None) -> None:
    before = STEPS[STEPS.index(guide.state.step) - 1]
    guide.append("went_back", {"to": args.get("to", before)}, key)


def _retake(guide: CalibrationGuide, args: Args, key: str | None) -> None:
    guide.append("retaken", {}, key)


def _another_pose(guide: CalibrationGuide, args: Args, key: str | None) -> None:
    guide.append("another_pose", {}, key)


def _void_pose(guide: CalibrationGuide, args: Args, key: str | None) -> None:
    guide.append("pose_voided", {"number": args["number"]}, key)
    _poses_changed(guide)


def _restore_pose(guide: CalibrationGuide, args: Args, key: str | None) -> None:
    guide.append("pose_restored", {"number": args["number"]}, key)
    _poses_changed(guide)


def _poses_changed(guide: CalibrationGuide) -> None:
    """The folder follows; while poses are still taken, the next one is advised again."""
    guide.folder.keep_images(guide.state.pictures)
    if guide.state.step == "solve" and guide.state.advice is None:
        title = message("working-out-which-pose-would-help")
        start_job(guide, title, lambda _progress: tasks.keep_advice(guide))


def _capture(guide: CalibrationGuide, args: Args, key: str | None) -> None:
    guide.append("capture_started", {}, key)
    start_job(guide, message("taking-picture"), lambda progress: tasks.capture(guide, progress))


def _solve(guide: CalibrationGuide, args: Args, key: str | None) -> None:
    guide.append("solve_started", {}, key)
    start_job(guide, message("calibrating"), lambda progress: tasks.calibrate(guide, progress))


def _start_simulation(guide: CalibrationGuide, args: Args, key: str | None) -> None:
    operator = guide.station.simulated_operator
    assert operator is not None
    whole = args.get("all") is True
    guide.append("simulation_started", {"all": whole}, key)
    start_simulation(guide, simulation_job(guide, operator, whole))


def _stop_simulation(guide: CalibrationGuide, args: Args, key: str | None) -> None:
    stop_simulation(guide)
    guide.append("simulation_stopped", {}, key)


def _accept(guide: CalibrationGuide, args: Args, key: str | None) -> None:
    seen = guide.live().latest_outcome
    assert seen is not None
    assert seen.result is not None
    guide.accept(seen.result, key)


def _repeat(guide: CalibrationGuide, args: Args, key: str | None) -> None:
    guide.repeat(key)


def _abandon(guide: CalibrationGuide, args: Args, key: str | None) -> None:
    guide.append("abandoned", {}, key)


ACTS: dict[str, Callable[[CalibrationGuide, Args, str | None], None]] = {
    "choose": _choose,
    "select_face": _select_face,
    "take_point": _take_point,
    "undo": _undo,
    "redo": _redo,
    "void_point": _void_point,
    "back": _back,
    "retake": _retake,
    "another_pose": _another_pose,
    "void_pose": _void_pose,
    "restore_pose": _restore_pose,
    "capture": _capture,
    "solve": _solve,
    "run_simulation": _start_simulation,
    "stop_simulation": _stop_simulation,
    "accept": _accept,
    "repeat": _repeat,
    "abandon": _abandon,
}
