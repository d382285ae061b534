"""The operator's commands in an arm session; each leaves a row in the journal."""

from crenel.formats.session.coordinates_table import COORDINATES
from crenel.guide.arm import tasks
from crenel.guide.arm.evaluate import finish_seat
from crenel.guide.arm.guide import ArmGuide
from crenel.guide.arm.simulated_operator import simulate
from crenel.guide.common.arguments import Args
from crenel.guide.common.buttons import ButtonName
from crenel.guide.common.commands import Act, Commands, record, simulation_acts
from crenel.messages.message import message

BUTTONS = {("seat", "primary"): "begin", ("swing", "primary"): "finish"}


def button_command(guide: ArmGuide, button: ButtonName) -> str:
    """The arm's primary button begins and ends a swing, and takes the points of a sphere."""
    name = BUTTONS.get((guide.state.step, button), "")
    return "touch" if name and guide.state.touching else name


def _touch_at(guide: ArmGuide, stamp_ns: int) -> None:
    guide.check_allowed("touch", {}, None, guide.simulation_running)
    guide.touch(stamp_ns, None)


def _fit(guide: ArmGuide, args: Args, key: str | None) -> None:
    guide.start_job(message("identifying-arm"), lambda progress: tasks.fit(guide, progress))


def _drop(guide: ArmGuide, args: Args, key: str | None) -> None:
    guide.append("seat_dropped", {"name": guide.state.seats[-1].name}, key)
    guide.keep_seats()


def _again(guide: ArmGuide, args: Args, key: str | None) -> None:
    purpose = guide.state.purpose
    guide.append("ended", {})
    guide.begin(purpose, key)


ACTS: dict[str, Act[ArmGuide]] = {
    "choose_arm": record("arm_chosen", "id"),
    "set_limit": record("limit_set", "limit_um"),
    "choose_artefact": lambda guide, args, key: guide.choose_artefact(args, key),
    "begin": lambda guide, args, key: guide.begin_seat(key),
    "touch": lambda guide, args, key: guide.touch(None, key),
    "finish": lambda guide, args, key: finish_seat(guide, key),
    "drop_swing": _drop,
    "drop_seat": _drop,
    "take_coordinates": lambda guide, args, key: guide.take_coordinates(
        str(args["text"]), str(args.get("file_name", COORDINATES)), key
    ),
    "drop_coordinates": lambda guide, args, key: guide.drop_coordinates(key),
    "fit": _fit,
    "save": lambda guide, args, key: tasks.save(guide, key),
    "restore": lambda guide, args, key: tasks.restore(guide, key),
    "reopen": record("reopened"),
    "again": _again,
    **simulation_acts(simulate, has_whole=False),
    "end": record("ended"),
}
COMMANDS = Commands(ACTS, button_command, {"touch": _touch_at}, has_buttons=True)
