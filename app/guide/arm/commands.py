"""The operator's commands in an arm session; each leaves a row in the journal."""

from collections.abc import Callable

from app.errors import OperationError
from app.guide.arm import tasks
from app.guide.arm.evaluate import finish_seat
from app.guide.arm.guide import ArmGuide
from app.guide.arm.simulated_operator import simulation_job
from app.guide.arm.view import ArmView
from app.guide.common.arguments import Args
from app.guide.common.buttons import Press
from app.guide.common.commands import AT_ANY_REV, start_job, start_simulation, stop_simulation
from app.messages.message import message


def command(guide: ArmGuide, name: str, args: Args, rev: int, key: str) -> ArmView:
    """Does a command of the browser, once for each ``key``.

    Raises:
        OperationError: the command is not possible now, or was given on an old view.
    """
    with guide.lock:
        if not guide.knows_key(key):
            rev_seen = None if name in AT_ANY_REV else rev
            typed = guide.check_allowed(name, args, rev_seen)
            ACTS[name](guide, typed, key)
        return guide.refresh()


BUTTONS = {("seat", "primary"): "begin", ("swing", "primary"): "finish"}


def press(guide: ArmGuide, event: Press) -> bool:
    """The arm's primary button begins and ends a swing, and takes the points of a sphere.

    False where no session is open; one that is has the arm, whatever the button means to it.
    """
    with guide.lock:
        name = BUTTONS.get((guide.state.step, event.button))
        if name is None or not guide.running:
            return guide.running
        try:
            if guide.state.touching:
                # whether the arm was still is judged as of the press, not as of now
                guide.check_allowed("touch", {}, None, guide.simulation_running)
                guide.touch(event.stamp_ns, None)
            else:
                guide.check_allowed(name, {}, None)
                ACTS[name](guide, {}, None)
        except OperationError as refusal:
            guide.decline(refusal)
        guide.refresh()
        return True


def _fit(guide: ArmGuide, args: Args, key: str | None) -> None:
    start_job(guide, message("identifying-arm"), lambda progress: tasks.fit(guide, progress))


def _start_simulation(guide: ArmGuide, args: Args, key: str | None) -> None:
    operator = guide.station.simulated_operator
    assert operator is not None
    guide.append("simulation_started", {}, key)
    start_simulation(guide, simulation_job(guide, operator))


def _drop(guide: ArmGuide, args: Args, key: str | None) -> None:
    guide.append("seat_dropped", {"name": guide.state.seats[-1].name}, key)
    guide.keep_seats()


def _stop_simulation(guide: ArmGuide, args: Args, key: str | None) -> None:
    stop_simulation(guide)
    guide.append("simulation_stopped", {}, key)


ACTS: dict[str, Callable[[ArmGuide, Args, str | None], None]] = {
    "choose_arm": lambda guide, args, key: guide.append("arm_chosen", {"id": args["id"]}, key),
    "set_limit": lambda guide, args, key: guide.append(
        "limit_set", {"limit_um": args.get("limit_um")}, key
    ),
    "choose_artefact": lambda guide, args, key: guide.choose_artefact(args, key),
    "begin": lambda guide, args, key: guide.begin_seat(key),
    "touch": lambda guide, args, key: guide.touch(None, key),
    "finish": lambda guide, args, key: finish_seat(guide, key),
    "drop_swing": _drop,
    "drop_seat": _drop,
    "fit": _fit,
    "save": lambda guide, args, key: tasks.save(guide, key),
    "restore": lambda guide, args, key: tasks.restore(guide, key),
    "reopen": lambda guide, args, key: guide.append("reopened", {}, key),
    "again": lambda guide, args, key: _again(guide, key),
    "run_simulation": _start_simulation,
    "stop_simulation": _stop_simulation,
    "end": lambda guide, args, key: guide.append("ended", {}, key),
}


def _again(guide: ArmGuide, key: str | None) -> None:
    purpose = guide.state.purpose
    guide.append("ended", {})
    guide.begin(purpose, key)
