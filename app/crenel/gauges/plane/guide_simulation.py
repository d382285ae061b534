"""The simulated operator in a test on a plate: scans it in both orientations."""

from collections.abc import Mapping

from crenel.gauges.guide import PerformanceGuide
from crenel.gauges.plan.document import ORIENTATIONS
from crenel.gauges.session.simulation import (
    SCAN_ATTEMPTS,
    await_scanner,
    begin_scan,
    confirm,
    finish_scan,
)
from crenel.guide.common.simulated_operator import SimulatedOperator
from crenel.guide.common.simulation import StepWork
from crenel.messages.message import message
from crenel.station.jobs import Progress


def _scan_plate(guide: PerformanceGuide, operator: SimulatedOperator, progress: Progress) -> None:
    refused = 0
    while (orientation := guide.state.orientation) and refused < SCAN_ATTEMPTS:
        text = message("performance-simulation-scans-plate", number=orientation)
        progress(text, (orientation - 1) / ORIENTATIONS)
        await_scanner(guide)
        if not begin_scan(guide, {"orientation": orientation}):
            return
        if not finish_scan(guide, operator.scan_plate(orientation), progress):
            return
        refused = refused + 1 if guide.state.orientation == orientation else 0
    confirm(guide)


PLANE_WORK: Mapping[str, StepWork[PerformanceGuide]] = {"plate": _scan_plate}
