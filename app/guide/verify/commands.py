"""The operator's commands in a verification; each leaves a row in the journal."""

from collections.abc import Callable
from dataclasses import dataclass

from app.errors import OperationError
from app.guide.common.arguments import Args
from app.guide.common.buttons import Press
from app.guide.common.commands import AT_ANY_REV, start_job, start_simulation, stop_simulation
from app.guide.verify import tasks
from app.guide.verify.guide import VerifyGuide
from app.guide.verify.simulated_operator import simulation_job
from app.guide.verify.state import STEPS, VerificationCloud
from app.guide.verify.tasks import Temperatures
from app.guide.verify.view import VerifyView
from app.messages.message import message
from app.station.jobs import Progress


@dataclass(frozen=True)
class CommandContext:
    """A command, and who gives it."""

    args: Args
    key: str | None = None
    operator: str = ""
    temperatures: Temperatures | None = None


def command(
    guide: VerifyGuide,
    name: str,
    args: Args,
    rev: int,
    key: str,
    operator: str,
    temperatures: Temperatures,
) -> VerifyView:
    """Does a command of the browser, once for each ``key``.

    Raises:
        OperationError: the command is not possible now, or was given on an old view.
    """
    with guide.lock:
        if not guide.knows_key(key):
            rev_seen = None if name in AT_ANY_REV else rev
            typed = guide.check_allowed(name, args, rev_seen)
            ACTS[name](guide, CommandContext(typed, key, operator, temperatures))
        return guide.refresh()


def button_command(guide: VerifyGuide, button: str) -> str:
    """The command that a button of the arm gives now; empty for none."""
    if not guide.running:
        return ""
    if guide.state.step == "touch":
        return {"primary": "touch", "undo": "undo", "back": "back"}.get(button, "")
    if guide.state.step == "scan":
        scanning = guide.state.open_cloud is not None
        main = "finish_cloud" if scanning else "begin_cloud"
        return {"primary": main, "undo": "undo", "back": "back"}.get(button, "")
    return "back" if button == "back" and guide.state.step == "review" else ""


def press(guide: VerifyGuide, event: Press) -> bool:
    """The arm's buttons: primary takes a touch, begins and ends a cloud; undo takes back, and
    back goes a step back. False where the button means nothing now."""
    with guide.lock:
        name = button_command(guide, event.button)
        if not name:
            return False
        try:
            if name == "touch":
                # whether the arm was still is judged as of the press, not as of now
                if guide.simulation_running or guide.station.jobs.current is None:
                    guide.touch(event.stamp_ns, None)
            else:
                guide.check_allowed(name, {}, None)
                ACTS[name](guide, CommandContext({}))
        except OperationError as refusal:
            guide.decline(refusal)
        guide.refresh()
        return True


def measure_waiting(guide: VerifyGuide) -> None:
    """Measures a cloud that waits for it, as after a restart, unless something is at work."""
    if guide.station.jobs.current is not None:
        return
    cloud = guide.to_measure()
    if cloud is not None:
        _measure(guide, cloud)


def _undo(guide: VerifyGuide, context: CommandContext) -> None:
    if guide.state.step == "touch":
        index = guide.state.counted[-1].index
        guide.append("touch_voided", {"index": index}, context.key)
        guide.keep_touches()
    else:
        last = [cloud for cloud in guide.state.listed if not cloud.voided][-1]
        guide.append("cloud_voided", {"number": last.number, "voided": True}, context.key)


def _redo(guide: VerifyGuide, context: CommandContext) -> None:
    guide.append("touch_restored", {"index": guide.state.undone[-1]}, context.key)
    guide.keep_touches()


def _void_touch(guide: VerifyGuide, context: CommandContext) -> None:
    guide.append("touch_voided", {"index": context.args["index"]}, context.key)
    guide.keep_touches()


def _finish_cloud(guide: VerifyGuide, context: CommandContext) -> None:
    cloud = tasks.end_cloud(guide, "cloud_ended", context.key)
    _measure(guide, cloud)


def _measure(guide: VerifyGuide, cloud: VerificationCloud) -> None:
    def work(progress: Progress) -> None:
        progress(message("writing-cloud"), 0.1)
        tasks.measure(guide, cloud, tasks.end_scan(guide), progress)

    start_job(guide, message("measuring-cloud"), work)


def _drop_cloud(guide: VerifyGuide, context: CommandContext) -> None:
    tasks.end_cloud(guide, "cloud_voided", context.key)
    start_job(guide, message("dropping-cloud"), lambda _progress: tasks.drop_scan(guide))


def _with_number(kind: str, voided: bool) -> "Act":
    def act(guide: VerifyGuide, context: CommandContext) -> None:
        payload = {"number": context.args["number"], "voided": voided}
        guide.append(kind, payload, context.key)

    return act


def _just(kind: str) -> "Act":
    return lambda guide, context: guide.append(kind, {}, context.key)


def _back(guide: VerifyGuide, context: CommandContext) -> None:
    before = STEPS[STEPS.index(guide.state.step) - 1]
    guide.append("went_back", {"to": context.args.get("to", before)}, context.key)


def _accept(guide: VerifyGuide, context: CommandContext) -> None:
    assert context.temperatures is not None
    tasks.accept(guide, context.operator, context.temperatures, context.key)


def _again(guide: VerifyGuide, context: CommandContext) -> None:
    guide.append("abandoned", {})
    guide.begin(context.key)


def _start_simulation(guide: VerifyGuide, context: CommandContext) -> None:
    operator = guide.station.simulated_operator
    assert operator is not None
    whole = context.args.get("all") is True
    guide.append("simulation_started", {"all": whole}, context.key)
    start_simulation(guide, simulation_job(guide, operator, whole))


def _stop_simulation(guide: VerifyGuide, context: CommandContext) -> None:
    stop_simulation(guide)
    guide.append("simulation_stopped", {}, context.key)


Act = Callable[[VerifyGuide, CommandContext], None]
ACTS: dict[str, Act] = {
    "choose_gauge": lambda guide, context: guide.append(
        "gauge_chosen", {"id": context.args["id"]}, context.key
    ),
    "confirm_gauge": lambda guide, context: tasks.confirm_gauge(guide, context.key),
    "touch": lambda guide, context: guide.touch(None, context.key),
    "undo": _undo,
    "redo": _redo,
    "void_touch": _void_touch,
    "confirm_touch": _just("touch_confirmed"),
    "skip_touch": _just("touch_skipped"),
    "begin_cloud": lambda guide, context: tasks.begin_cloud(guide, context.key),
    "finish_cloud": _finish_cloud,
    "drop_cloud": _drop_cloud,
    "void_cloud": _with_number("cloud_voided", True),
    "restore_cloud": _with_number("cloud_restored", False),
    "confirm_clouds": _just("clouds_confirmed"),
    "more_clouds": lambda guide, context: guide.append("went_back", {"to": "scan"}, context.key),
    "accept": _accept,
    "back": _back,
    "run_simulation": _start_simulation,
    "stop_simulation": _stop_simulation,
    "abandon": _just("abandoned"),
    "again": _again,
}
