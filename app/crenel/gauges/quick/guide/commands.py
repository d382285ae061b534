"""The operator's commands in a verification; each leaves a row in the journal."""

from crenel.gauges.quick.guide import tasks
from crenel.gauges.quick.guide.guide import VerifyGuide
from crenel.gauges.quick.guide.simulated_operator import simulate
from crenel.gauges.quick.guide.state import STEPS, VerificationCloud
from crenel.gauges.session.acts import restore_touch, touch_at, void_touch
from crenel.guide.common.arguments import Args
from crenel.guide.common.buttons import ButtonName
from crenel.guide.common.commands import Act, Commands, go_back, record, simulation_acts
from crenel.messages.message import message
from crenel.station.jobs import Progress

BUTTONS: dict[tuple[str, str], str] = {
    ("touch", "primary"): "touch",
    ("touch", "undo"): "undo",
    ("touch", "back"): "back",
    ("scan", "primary"): "begin_cloud",
    ("scan", "undo"): "undo",
    ("scan", "back"): "back",
    ("review", "back"): "back",
}


def button_command(guide: VerifyGuide, button: ButtonName) -> str:
    """The arm's buttons: primary takes a touch, begins and ends a cloud; undo takes back, and
    back goes a step back."""
    name = BUTTONS.get((guide.state.step, button), "")
    scanning = guide.state.open_cloud is not None
    return "finish_cloud" if name == "begin_cloud" and scanning else name


def measure_waiting(guide: VerifyGuide) -> None:
    """Measures a cloud that waits for it, as after a restart, unless something is at work."""
    if guide.station.jobs.current is not None:
        return
    cloud = guide.to_measure()
    if cloud is not None:
        _measure(guide, cloud)


def _undo(guide: VerifyGuide, args: Args, key: str | None) -> None:
    if guide.state.step == "touch":
        void_touch(guide, guide.state.counted[-1].index, key)
    else:
        last = [cloud for cloud in guide.state.listed if not cloud.voided][-1]
        guide.append("cloud_voided", {"number": last.number, "voided": True}, key)


def _finish_cloud(guide: VerifyGuide, args: Args, key: str | None) -> None:
    _measure(guide, tasks.end_cloud(guide, "cloud_ended", key))


def _measure(guide: VerifyGuide, cloud: VerificationCloud) -> None:
    def work(progress: Progress) -> None:
        progress(message("writing-cloud"), 0.1)
        tasks.measure(guide, cloud, tasks.end_scan(guide), progress)

    guide.start_job(message("measuring-cloud"), work)


def _drop_cloud(guide: VerifyGuide, args: Args, key: str | None) -> None:
    tasks.end_cloud(guide, "cloud_voided", key)

    def work(progress: Progress) -> None:
        tasks.end_scan(guide)

    guide.start_job(message("dropping-cloud"), work)


def _again(guide: VerifyGuide, args: Args, key: str | None) -> None:
    guide.append("abandoned", {})
    guide.begin(key)


ACTS: dict[str, Act[VerifyGuide]] = {
    "choose_gauge": record("gauge_chosen", "id"),
    "confirm_gauge": lambda guide, args, key: tasks.confirm_gauge(guide, key),
    "touch": lambda guide, args, key: guide.touch(None, key),
    "undo": _undo,
    "redo": lambda guide, args, key: restore_touch(guide, key),
    "void_touch": lambda guide, args, key: void_touch(guide, args["index"], key),
    "confirm_touch": record("touch_confirmed"),
    "skip_touch": record("touch_skipped"),
    "begin_cloud": lambda guide, args, key: tasks.begin_cloud(guide, key),
    "finish_cloud": _finish_cloud,
    "drop_cloud": _drop_cloud,
    "void_cloud": record("cloud_voided", "number", voided=True),
    "restore_cloud": record("cloud_restored", "number", voided=False),
    "confirm_clouds": record("clouds_confirmed"),
    "more_clouds": record("went_back", to="scan"),
    "accept": lambda guide, args, key: tasks.accept(guide, key),
    "back": go_back(STEPS),
    **simulation_acts(simulate),
    "abandon": record("abandoned"),
    "again": _again,
}
COMMANDS = Commands(ACTS, button_command, {"touch": touch_at})
