"""The simulated operator in a verification: touches the gauge, and passes over it."""

from crenel.gauges.quick.guide import tasks
from crenel.gauges.quick.guide.guide import VerifyGuide
from crenel.gauges.quick.guide.rules import CLOUDS_WANTED, touches_wanted
from crenel.gauges.session.simulation import await_scanner
from crenel.guide.common.simulated_operator import SimulatedOperator
from crenel.guide.common.simulation import (
    ATTEMPTS,
    StepWork,
    act_as_operator,
    touch_until_taken,
    work_on_steps,
)
from crenel.messages.message import message, word
from crenel.station.jobs import Progress

GAUGES = {"plane": "plate", "sphere": "sphere"}
"""What the simulated operator calls the gauge of a shape on its table."""


def simulate(
    guide: VerifyGuide, operator: SimulatedOperator, whole: bool, progress: Progress
) -> None:
    """Does the present step, or goes on up to the result."""
    work_on_steps(STEPS, guide, operator, whole, progress)


def _confirm_gauge(guide: VerifyGuide, operator: SimulatedOperator, progress: Progress) -> None:
    act_as_operator(guide, "confirm_gauge", lambda: tasks.confirm_gauge(guide, None))


def _name(guide: VerifyGuide) -> str:
    gauge = guide.live().gauge
    assert gauge is not None
    return GAUGES[gauge.shape]


def _touch(guide: VerifyGuide, operator: SimulatedOperator, progress: Progress) -> None:
    name, of = _name(guide), touches_wanted(guide.live())
    for index in range(len(guide.state.counted), of):
        progress(message("simulation-touches-gauge", name=word(name)), index / of)
        if not guide.simulation_running or not _touch_one(guide, operator, name, index):
            return
    act_as_operator(guide, "confirm_touch", lambda: guide.append("touch_confirmed", {}))


def _touch_one(guide: VerifyGuide, operator: SimulatedOperator, name: str, index: int) -> bool:
    return touch_until_taken(
        guide,
        lambda attempt: operator.touch_gauge(name, index + 50 * attempt),
        lambda: len(guide.state.touches),
        message("hands-touch-declined-times", index=index + 1, attempts=ATTEMPTS),
    )


def _scan(guide: VerifyGuide, operator: SimulatedOperator, progress: Progress) -> None:
    name = _name(guide)
    at_least_one = max(CLOUDS_WANTED, len(guide.state.good) + 1)
    for done in range(len(guide.state.good), at_least_one):
        text = message("simulation-scans-cloud", name=word(name), done=done + 1)
        progress(text, done / at_least_one)
        if not guide.simulation_running or not _scan_one(guide, operator, name, progress):
            return
    act_as_operator(guide, "confirm_clouds", lambda: guide.append("clouds_confirmed", {}))


def _scan_one(
    guide: VerifyGuide, operator: SimulatedOperator, name: str, progress: Progress
) -> bool:
    """One cloud from its begin to its measure; False when it was stopped or is of no use."""
    await_scanner(guide)
    if not act_as_operator(guide, "begin_cloud", lambda: tasks.begin_cloud(guide, None)):
        return False
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


STEPS: dict[str, StepWork[VerifyGuide]] = {
    "gauge": _confirm_gauge,
    "touch": _touch,
    "scan": _scan,
}
