"""The operator's commands in a calibration; each leaves a row in the journal."""

from functools import partial

from crenel.guide.calibration import tasks
from crenel.guide.calibration.automatic.resting_poses import start_taking
from crenel.guide.calibration.automatic.simulated_operator import simulate
from crenel.guide.calibration.guide import CalibrationGuide
from crenel.guide.calibration.poses.look_again import look_again, set_line
from crenel.guide.calibration.state import STEPS
from crenel.guide.calibration.tasks import CONFIRMATIONS, confirm
from crenel.guide.calibration.touch import points as taking
from crenel.guide.common.arguments import Args
from crenel.guide.common.buttons import ButtonName
from crenel.guide.common.commands import Act, Commands, go_back, record, simulation_acts
from crenel.messages.message import message
from crenel.station.jobs import Progress
from crenel.workflows.calibrate import LaserUse

BY_MAIN_BUTTON = ("place", "capture", "solve")
"""Steps whose main action the arm's main button does too. Devices, set-up and the result are
looked at, and confirmed on the screen."""


def button_command(guide: CalibrationGuide, button: ButtonName) -> str:
    """The arm's buttons: primary takes a point or does the step's main action, undo takes a
    point back, and back goes a step back."""
    step = guide.state.step
    if button == "back":
        return "back" if step != STEPS[0] else ""
    if step == "touch":
        return "take_point" if button == "primary" else "undo"
    if button == "primary" and step in BY_MAIN_BUTTON and not guide.simulation_running:
        return next((action.name for action in guide.view().actions if action.primary), "")
    return ""


def _take_point_at(guide: CalibrationGuide, stamp_ns: int) -> None:
    source = "simulation" if guide.simulation_running else "button"
    taking.take_point(guide, source, stamp_ns, None)


def _undo_at(guide: CalibrationGuide, stamp_ns: int) -> None:
    guide.check_allowed("undo", {}, None, guide.simulation_running)
    taking.undo(guide, None)


def _confirm(name: str, guide: CalibrationGuide, args: Args, key: str | None) -> None:
    confirm(guide, name, key)


def _void_point(guide: CalibrationGuide, args: Args, key: str | None) -> None:
    index = args["index"]
    assert isinstance(index, int)
    taking.void_point(guide, index, key)


def _change_pose(kind: str, guide: CalibrationGuide, args: Args, key: str | None) -> None:
    """The folder follows; while poses are still taken, the next one is advised again."""
    guide.append(kind, {"number": args["number"]}, key)
    guide.folder.keep_images(guide.state.pictures)
    if guide.state.step == "solve" and guide.state.advice is None:
        title = message("working-out-which-pose-would-help")
        guide.start_job(title, lambda _progress: tasks.keep_advice(guide))


def _capture(guide: CalibrationGuide, args: Args, key: str | None) -> None:
    guide.append("capture_started", {}, key)
    guide.start_job(message("taking-picture"), lambda progress: tasks.capture(guide, progress))


def _take_poses(guide: CalibrationGuide, args: Args, key: str | None) -> None:
    guide.append("poses_started", {}, key)
    start_taking(guide)


def _setup_and_poses(guide: CalibrationGuide, args: Args, key: str | None) -> None:
    confirm(guide, "confirm_setup", key)
    _take_poses(guide, {}, None)


def _stop_poses(guide: CalibrationGuide, args: Args, key: str | None) -> None:
    guide.stop_work()
    guide.append("poses_stopped", {}, key)
    if guide.state.step in ("place", "capture") and guide.state.pictures:
        guide.append("capture_kept", {})


def _set_line(guide: CalibrationGuide, args: Args, key: str | None) -> None:
    set_line(guide, args, key)

    def work(progress: Progress) -> None:
        look_again(guide, progress)
        tasks.keep_advice(guide)

    guide.start_job(message("looks-for-line-again"), work)


def _solve(laser: LaserUse, guide: CalibrationGuide, args: Args, key: str | None) -> None:
    guide.append("solve_started", {}, key)
    guide.start_job(
        message("calibrating"), lambda progress: tasks.calibrate(guide, progress, laser)
    )


def _accept(guide: CalibrationGuide, args: Args, key: str | None) -> None:
    seen = guide.live().latest_outcome
    assert seen is not None
    assert seen.result is not None
    guide.accept(seen.result, key)


ACTS: dict[str, Act[CalibrationGuide]] = {
    **{name: partial(_confirm, name) for name in CONFIRMATIONS},
    "choose": record("chosen", "field", "id"),
    "select_face": record("face_selected", "face"),
    "take_point": lambda guide, args, key: taking.take_point(guide, "click", None, key),
    "undo": lambda guide, args, key: taking.undo(guide, key),
    "redo": lambda guide, args, key: taking.redo(guide, key),
    "void_point": _void_point,
    "back": go_back(STEPS),
    "retake": record("retaken"),
    "another_pose": record("another_pose"),
    "void_pose": partial(_change_pose, "pose_voided"),
    "restore_pose": partial(_change_pose, "pose_restored"),
    "capture": _capture,
    "setup_and_poses": _setup_and_poses,
    "take_poses": _take_poses,
    "stop_poses": _stop_poses,
    "set_line": _set_line,
    "solve": partial(_solve, "auto"),
    "solve_without_laser": partial(_solve, "none"),
    **simulation_acts(simulate),
    "accept": _accept,
    "repeat": lambda guide, args, key: guide.repeat(key),
    "add_laser": lambda guide, args, key: guide.begin_laser(key),
    "abandon": record("abandoned"),
}
COMMANDS = Commands(ACTS, button_command, {"take_point": _take_point_at, "undo": _undo_at})
