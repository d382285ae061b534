"""The operator's commands in a performance test; each leaves a row in the journal."""

from crenel.gauges import guide_tasks as tasks
from crenel.gauges.guide import PerformanceGuide
from crenel.gauges.session.acts import restore_touch, touch_at, void_touch
from crenel.gauges.session.entries import TestScan
from crenel.gauges.session.simulation import confirm
from crenel.guide.common.arguments import Args
from crenel.guide.common.buttons import ButtonName
from crenel.guide.common.commands import Act, Commands, record, simulation_acts
from crenel.guide.common.simulated_operator import SimulatedOperator
from crenel.guide.common.simulation import act_as_operator, work_on_steps
from crenel.messages.message import message
from crenel.station.jobs import Progress


def button_command(guide: PerformanceGuide, button: ButtonName) -> str:
    """The arm's buttons: primary takes a touch, begins and ends a scan; undo takes back."""
    state = guide.state
    if state.in_scan and button == "primary":
        return "begin_scan" if state.open_scan is None else "finish_scan"
    if state.step in state.touching:
        return {"primary": "touch", "undo": "undo"}.get(button, "")
    return ""


def measure_waiting(guide: PerformanceGuide) -> None:
    """Measures a scan or evaluates a test that waits for it, as after a restart, unless
    something is at work."""
    guide.end_lost_scan()
    state = guide.state
    if not guide.running or guide.station.jobs.current is not None:
        return
    waiting = next((scan for scan in state.scans if scan.waiting), None)
    if waiting is not None:
        _measure(guide, waiting)
    elif state.step == "review" and guide.result() is None and state.failed is None:
        guide.start_job(
            message("performance-evaluating"), lambda progress: tasks.evaluate(guide, progress)
        )


def _finish_scan(guide: PerformanceGuide, args: Args, key: str | None) -> None:
    _measure(guide, tasks.end_scan(guide, "scan_ended", key))


def _measure(guide: PerformanceGuide, scan: TestScan) -> None:
    def work(progress: Progress) -> None:
        guide.station.scanner.stop()
        tasks.measure_scan(guide, scan, progress)

    guide.start_job(guide.kind.measuring_text(guide, scan), work)


def _drop_scan(guide: PerformanceGuide, args: Args, key: str | None) -> None:
    tasks.end_scan(guide, "scan_dropped", key)

    def work(progress: Progress) -> None:
        guide.station.scanner.stop()

    guide.start_job(message("performance-dropping-scan"), work)


def _go_back(guide: PerformanceGuide, args: Args, key: str | None) -> None:
    to = "temperatures" if guide.state.step == "review" else "artefact"
    guide.append("went_back", {"to": to}, key)


def _again(guide: PerformanceGuide, args: Args, key: str | None) -> None:
    tasks.abandon(guide, str(args.get("reason", "other")), None)
    guide.begin(key)


def _simulate(
    guide: PerformanceGuide, operator: SimulatedOperator, whole: bool, progress: Progress
) -> None:
    """Does the present step, or goes on up to the result."""
    steps = {
        "artefact": _simulate_artefact,
        **guide.kind.work,
        "temperatures": _simulate_temperatures,
    }
    work_on_steps(steps, guide, operator, whole, progress)


def _simulate_artefact(
    guide: PerformanceGuide, operator: SimulatedOperator, progress: Progress
) -> None:
    act_as_operator(guide, "confirm_artefact", lambda: tasks.confirm_artefact(guide, None))


def _simulate_temperatures(
    guide: PerformanceGuide, operator: SimulatedOperator, progress: Progress
) -> None:
    confirm(guide)
    if guide.state.step == "review":
        tasks.evaluate(guide, progress)


ACTS: dict[str, Act[PerformanceGuide]] = {
    "choose_gauge": record("gauge_chosen", "id"),
    "choose_bar": record("bar_chosen", "id"),
    "set_positions": record("positions_set", "number"),
    "set_by_scan": record("by_scan_set", "by_scan"),
    "set_limit": tasks.set_limit,
    "set_temperature": tasks.set_temperature,
    "confirm_artefact": lambda guide, args, key: tasks.confirm_artefact(guide, key),
    "touch": lambda guide, args, key: guide.touch(None, key),
    "undo": lambda guide, args, key: void_touch(guide, guide.state.of_step[-1].index, key),
    "redo": lambda guide, args, key: restore_touch(guide, key),
    "begin_scan": lambda guide, args, key: guide.kind.begin_scan(guide, args, key),
    "finish_scan": _finish_scan,
    "drop_scan": _drop_scan,
    "confirm": lambda guide, args, key: tasks.confirm(guide, key),
    "back": _go_back,
    "accept": lambda guide, args, key: tasks.accept(guide, key),
    **simulation_acts(_simulate),
    "abandon": lambda guide, args, key: tasks.abandon(guide, str(args.get("reason", "other")), key),
    "again": _again,
}
COMMANDS = Commands(ACTS, button_command, {"touch": touch_at})
