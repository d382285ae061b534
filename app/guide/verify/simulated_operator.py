"""The simulated operator in a verification: touches the gauge, and passes over it."""

import time
from collections.abc import Callable

from app.errors import OperationError
from app.guide.common.simulated_operator import SimulatedOperator
from app.guide.verify import tasks
from app.guide.verify.guide import VerifyGuide
from app.guide.verify.rules import CLOUDS_WANTED, touches_wanted
from app.messages.message import message, word
from app.station.jobs import Progress

GAUGES = {"plane": "plate", "sphere": "sphere"}
"""What the simulated operator calls the gauge of a shape on its table."""
TIMEOUT_S = 4.0
ATTEMPTS = 3
PAUSE_S = 0.1


def simulation_job(
    guide: VerifyGuide, operator: SimulatedOperator, whole: bool
) -> Callable[[Progress], None]:
    """The job that does the present step, or goes on up to the result."""

    def work(progress: Progress) -> None:
        try:
            while guide.simulation_running and guide.state.step in STEP_JOBS:
                step = guide.state.step
                STEP_JOBS[step](guide, operator, progress)
                if not whole or guide.state.step == step:
                    break
        finally:
            guide.simulation_running = False

    return work


def _confirm(guide: VerifyGuide, name: str, kind: str) -> None:
    """Goes on as a person would, by the same rules; not once the job was stopped."""
    with guide.lock:
        if guide.simulation_running:
            guide.check_allowed(name, {}, None, by_simulation=True)
            guide.append(kind, {})


def _gauge(guide: VerifyGuide, operator: SimulatedOperator, progress: Progress) -> None:
    with guide.lock:
        guide.check_allowed("confirm_gauge", {}, None, by_simulation=True)
        tasks.confirm_gauge(guide, None)


def _name(guide: VerifyGuide) -> str:
    gauge = guide.live().gauge
    assert gauge is not None
    return GAUGES[gauge.shape]


def _touch(guide: VerifyGuide, operator: SimulatedOperator, progress: Progress) -> None:
    name, of = _name(guide), touches_wanted(guide.live())
    for index in range(len(guide.state.counted), of):
        progress(message("simulation-touches-2", name=word(name)), index / of)
        if not guide.simulation_running or not _touch_one(guide, operator, name, index):
            return
    _confirm(guide, "confirm_touch", "touch_confirmed")


def _touch_one(guide: VerifyGuide, operator: SimulatedOperator, name: str, index: int) -> bool:
    """One place, again where it was declined; False when it was stopped."""
    for attempt in range(ATTEMPTS):
        with guide.lock:
            before, declined = len(guide.state.touches), guide.declined
        if not operator.touch_gauge(name, index + 50 * attempt):
            return False
        with guide.changed:
            guide.changed.wait_for(
                lambda: len(guide.state.touches) > before or guide.declined > declined,  # noqa: B023
                TIMEOUT_S,
            )
            if len(guide.state.touches) > before:
                return True
    raise OperationError(
        "simulation-declined",
        message("hands-touch-declined-times", index=index + 1, attempts=ATTEMPTS),
        remedy=message("look-last-message-let-simulation-try"),
    )


def _scan(guide: VerifyGuide, operator: SimulatedOperator, progress: Progress) -> None:
    name = _name(guide)
    at_least_one = max(CLOUDS_WANTED, len(guide.state.good) + 1)
    for done in range(len(guide.state.good), at_least_one):
        text = message("simulation-scans-cloud", name=word(name), done=done + 1)
        progress(text, done / at_least_one)
        if not guide.simulation_running or not _scan_one(guide, operator, name, progress):
            return
    _confirm(guide, "confirm_clouds", "clouds_confirmed")


def _scan_one(
    guide: VerifyGuide, operator: SimulatedOperator, name: str, progress: Progress
) -> bool:
    """One cloud from its begin to its measure; False when it was stopped or is of no use."""
    _await_scanner(guide)
    with guide.lock:
        if not guide.simulation_running:
            return False
        guide.check_allowed("begin_cloud", {}, None, by_simulation=True)
        tasks.begin_cloud(guide, None)
    whole = operator.scan_part(name)
    with guide.lock:
        if guide.state.open_cloud is None:
            return False
        cloud = tasks.end_cloud(guide, "cloud_ended" if whole else "cloud_voided", None)
    seconds = tasks.end_scan(guide)
    if not whole:
        return False
    tasks.measure(guide, cloud, seconds, progress)
    return any(good.number == cloud.number for good in guide.state.good)


def _await_scanner(guide: VerifyGuide) -> None:
    """A camera or an arm that was just connected takes a moment."""
    deadline_s = time.monotonic() + TIMEOUT_S
    while guide.station.scanner.why_not() is not None and time.monotonic() < deadline_s:
        time.sleep(PAUSE_S)


STEP_JOBS: dict[str, Callable[[VerifyGuide, SimulatedOperator, Progress], None]] = {
    "gauge": _gauge,
    "touch": _touch,
    "scan": _scan,
}
