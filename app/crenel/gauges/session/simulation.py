"""What the simulated operator does alike in the steps of all performance tests."""

import time
from collections.abc import Callable

from crenel.gauges import guide_tasks as tasks
from crenel.gauges.guide import PerformanceGuide
from crenel.gauges.session.acts import AnySession
from crenel.guide.common.arguments import Args
from crenel.guide.common.simulation import TIMEOUT_S, act_as_operator
from crenel.station.jobs import Progress

PAUSE_S = 0.1
SCAN_ATTEMPTS = 2


def scan_once(
    guide: PerformanceGuide, args: Args, sweep: Callable[[], bool], progress: Progress
) -> bool:
    """Begins a scan, and measures it, or drops one that is not whole; False when it was stopped.

    Args:
        args: of the command that begins it.
        sweep: passes the sensor over the gauge; False when it was stopped.
    """
    await_scanner(guide)
    if not act_as_operator(guide, "begin_scan", lambda: guide.kind.begin_scan(guide, args, None)):
        return False
    whole = sweep()
    with guide.lock:
        if guide.state.open_scan is None:
            return False
        scan = tasks.end_scan(guide, "scan_ended" if whole else "scan_dropped", None)
    guide.station.scanner.stop()
    if whole:
        tasks.measure_scan(guide, scan, progress)
    return whole


def await_scanner(guide: AnySession) -> None:
    """A camera or an arm that was just connected takes a moment."""
    deadline_s = time.monotonic() + TIMEOUT_S
    while guide.station.scanner.why_not() is not None and time.monotonic() < deadline_s:
        time.sleep(PAUSE_S)


def confirm(guide: PerformanceGuide) -> None:
    """Confirms the step."""
    act_as_operator(guide, "confirm", lambda: tasks.confirm(guide, None))
