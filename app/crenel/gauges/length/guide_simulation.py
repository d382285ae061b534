"""The simulated operator in a length test: touches the lengths, and scans the bar."""

from collections.abc import Mapping

from crenel.gauges.guide import PerformanceGuide
from crenel.gauges.length.guide_sequence import BarPass
from crenel.gauges.length.guide_so_far import LengthsSoFar, lengths_so_far
from crenel.gauges.length.guide_state import LengthState
from crenel.gauges.session.simulation import SCAN_ATTEMPTS, confirm, scan_once
from crenel.guide.common.simulated_operator import SimulatedOperator
from crenel.guide.common.simulation import ATTEMPTS, StepWork, touch_until_taken
from crenel.messages.message import message
from crenel.station.jobs import Progress


def _measure_lengths(
    guide: PerformanceGuide, operator: SimulatedOperator, progress: Progress
) -> None:
    """Touches the lengths, and scans the bar in each place after its touches."""
    of, refused = guide.state.wanted, 0
    while (due := guide.state_of(LengthState).due) is not None or len(guide.state.of_step) < of:
        done = len(guide.state.of_step)
        if not guide.simulation_running or refused == SCAN_ATTEMPTS:
            return
        if due is None:
            text = message("performance-simulation-touches", done=done + 1, of=of, test="lengths")
            progress(text, done / of)
            if not _touch_next_end(guide, operator):
                return
            continue
        text = message("performance-simulation-scans-bar", place=due.place, repeat=due.repeat)
        progress(text, done / of)
        if not _scan_bar(guide, operator, due, progress, 1.0 + refused):
            return
        refused = refused + 1 if guide.state.due == due else 0
    confirm(guide)


def _touch_next_end(guide: PerformanceGuide, operator: SimulatedOperator) -> bool:
    with guide.lock:
        state, so_far = guide.state_of(LengthState), lengths_so_far(guide)
    end, number = state.end, len(state.of_step)
    assert end is not None
    assert so_far is not None
    middle, along = _pose_of_standard(so_far, end.place)
    standard, touch = so_far.standard, len(state.of(end.feature))
    length_mm = standard.lengths[end.length - 1].length_mm

    def touch_end(attempt: int) -> bool:
        if standard.sphere_diameter_mm is None:
            return operator.touch_length(middle, along, length_mm, end.end)
        return operator.touch_bar(middle, along, end.end, touch)

    return touch_until_taken(
        guide,
        touch_end,
        lambda: len(guide.state.touches),
        message("hands-touch-declined-times", index=number + 1, attempts=ATTEMPTS),
    )


def _pose_of_standard(so_far: LengthsSoFar, place: int) -> tuple[list[float], list[float]]:
    """Middle (3,) and direction (3,) of the standard in a place, as it is drawn."""
    first, last = so_far.places_mm[place - 1]
    return ((first + last) / 2).tolist(), (last - first).tolist()


def _scan_bar(
    guide: PerformanceGuide,
    operator: SimulatedOperator,
    due: BarPass,
    progress: Progress,
    slowness: float,
) -> bool:
    """One scan of the bar from its begin to its measure; False when it was stopped."""
    so_far = lengths_so_far(guide)
    assert so_far is not None
    middle, along = _pose_of_standard(so_far, due.place)
    return scan_once(guide, {}, lambda: operator.scan_bar(middle, along, slowness), progress)


LENGTH_WORK: Mapping[str, StepWork[PerformanceGuide]] = {"lengths": _measure_lengths}
