"""The simulated operator in a performance test: touches the sphere's places, and scans it."""

import time

import numpy as np

from crenel.gauges import guide_tasks as tasks
from crenel.gauges.contact.guide_simulated_touches import touch_contact
from crenel.gauges.contact.guide_state import CONTACT_STEPS
from crenel.gauges.guide import PerformanceGuide
from crenel.gauges.length.guide_so_far import LengthsSoFar
from crenel.gauges.length.guide_state import LengthState
from crenel.gauges.plan.document import ARTICULATIONS, ORIENTATIONS
from crenel.gauges.session.entries import BarPass
from crenel.gauges.sphere.guide_picture import missing_patches
from crenel.gauges.sphere.guide_places import POLE, directions_of_articulations
from crenel.gauges.sphere.guide_state import SphereState
from crenel.gauges.sphere.maths_pattern import pattern_directions
from crenel.guide.common.simulated_operator import SimulatedOperator
from crenel.guide.common.simulation import (
    ATTEMPTS,
    TIMEOUT_S,
    StepWork,
    act_as_operator,
    touch_until_taken,
    work_on_steps,
)
from crenel.messages.message import message
from crenel.station.jobs import Progress

PAUSE_S = 0.1
SCAN_ATTEMPTS = 2


def simulate(
    guide: PerformanceGuide, operator: SimulatedOperator, whole: bool, progress: Progress
) -> None:
    """Does the present step, or goes on up to the result."""
    work_on_steps(STEPS, guide, operator, whole, progress)


def _confirm_artefact(
    guide: PerformanceGuide, operator: SimulatedOperator, progress: Progress
) -> None:
    act_as_operator(guide, "confirm_artefact", lambda: tasks.confirm_artefact(guide, None))


def _touch(guide: PerformanceGuide, operator: SimulatedOperator, progress: Progress) -> None:
    of = guide.state.wanted
    while (done := len(guide.state.of_step)) < of:
        text = message("performance-simulation-touches", done=done + 1, of=of, test="sphere")
        progress(text, done / of)
        if not guide.simulation_running or not _touch_next(guide, operator):
            return
    _confirm(guide)


def _touch_next(guide: PerformanceGuide, operator: SimulatedOperator) -> bool:
    with guide.lock:
        state, part, centre = guide.state, guide.part_places(), guide.centre_mm()
        taken = {touch.place for touch in state.of(state.feature)}
    assert part is not None
    place = next(i for i in range(len(part.directions)) if i not in taken)
    outward = part.directions[place]
    stylus = outward + POLE
    if state.step == "location":
        stylus = directions_of_articulations(centre)[state.articulation - 1]
    return touch_until_taken(
        guide,
        lambda attempt: operator.touch_sphere(outward.tolist(), stylus.tolist()),
        lambda: len(guide.state.touches),
        message("hands-touch-declined-times", index=place + 1, attempts=ATTEMPTS),
    )


def _measure_lengths(
    guide: PerformanceGuide, operator: SimulatedOperator, progress: Progress
) -> None:
    """Touches the lengths, and scans the bar in each place after its touches."""
    of, refused = guide.state.wanted, 0
    while (due := guide.state.due) is not None or len(guide.state.of_step) < of:
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
    _confirm(guide)


def _touch_next_end(guide: PerformanceGuide, operator: SimulatedOperator) -> bool:
    with guide.lock:
        state, so_far = guide.state_of(LengthState), guide.lengths()
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
    _await_scanner(guide)
    so_far = guide.lengths()
    assert so_far is not None
    middle, along = _pose_of_standard(so_far, due.place)
    if not act_as_operator(guide, "begin_scan", lambda: tasks.begin_bar_scan(guide, due, None)):
        return False
    whole = operator.scan_bar(middle, along, slowness)
    return _finish_scan(guide, whole, progress)


def _scan_plate(guide: PerformanceGuide, operator: SimulatedOperator, progress: Progress) -> None:
    refused = 0
    while (orientation := guide.state.orientation) and refused < SCAN_ATTEMPTS:
        text = message("performance-simulation-scans-plate", number=orientation)
        progress(text, (orientation - 1) / ORIENTATIONS)
        _await_scanner(guide)
        if not act_as_operator(
            guide, "begin_scan", lambda: tasks.begin_plate_scan(guide, orientation, None)
        ):
            return
        if not _finish_scan(guide, operator.scan_plate(orientation), progress):
            return
        refused = refused + 1 if guide.state.orientation == orientation else 0
    _confirm(guide)


def _scan(guide: PerformanceGuide, operator: SimulatedOperator, progress: Progress) -> None:
    attempts = 0
    while (articulation := guide.state.articulation) and attempts < SCAN_ATTEMPTS:
        text = message("performance-simulation-scans", articulation=articulation)
        progress(text, (articulation - 1) / ARTICULATIONS)
        if not guide.simulation_running or not _scan_one(guide, operator, articulation, progress):
            return
        attempts = attempts + 1 if guide.state.articulation == articulation else 0
    for repeat in range(ARTICULATIONS):
        missing = missing_patches(guide.state_of(SphereState))
        if not missing or guide.state.articulation:
            break
        again = _sees_best(guide, missing[0])
        slowness = 2.0 + repeat  # a pass at the usual speed had too few pictures of the place
        if not guide.simulation_running or not _scan_one(
            guide, operator, again, progress, slowness
        ):
            return
    _confirm(guide)


def _sees_best(guide: PerformanceGuide, patch: int) -> int:
    """The articulation that a patch is seen best from."""
    directions = directions_of_articulations(guide.centre_mm())
    return 1 + int(np.argmax(directions @ pattern_directions(POLE)[patch - 1]))


def _scan_one(
    guide: PerformanceGuide,
    operator: SimulatedOperator,
    articulation: int,
    progress: Progress,
    slowness: float = 1.0,
) -> bool:
    """One scan from its begin to its measure; False when it was stopped."""
    _await_scanner(guide)
    direction = directions_of_articulations(guide.centre_mm())[articulation - 1]
    if not act_as_operator(
        guide, "begin_scan", lambda: tasks.begin_scan(guide, articulation, None)
    ):
        return False
    whole = operator.scan_sphere(direction.tolist(), slowness)
    return _finish_scan(guide, whole, progress)


def _finish_scan(guide: PerformanceGuide, whole: bool, progress: Progress) -> bool:
    """Ends and measures the scan that was made, or drops one that is not whole; False when it was
    stopped."""
    with guide.lock:
        if guide.state.open_scan is None:
            return False
        scan = tasks.end_scan(guide, "scan_ended" if whole else "scan_dropped", None)
    guide.station.scanner.stop()
    if whole:
        tasks.measure_scan(guide, scan, progress)
    return whole


def _await_scanner(guide: PerformanceGuide) -> None:
    """A camera or an arm that was just connected takes a moment."""
    deadline_s = time.monotonic() + TIMEOUT_S
    while guide.station.scanner.why_not() is not None and time.monotonic() < deadline_s:
        time.sleep(PAUSE_S)


def _confirm_temperatures(
    guide: PerformanceGuide, operator: SimulatedOperator, progress: Progress
) -> None:
    _confirm(guide)
    if guide.state.step == "review":
        tasks.evaluate(guide, progress)


def _confirm(guide: PerformanceGuide) -> None:
    act_as_operator(guide, "confirm", lambda: tasks.confirm(guide, None))


STEPS: dict[str, StepWork[PerformanceGuide]] = {
    "artefact": _confirm_artefact,
    "pattern": _touch,
    "location": _touch,
    "scan": _scan,
    "end": _touch,
    "lengths": _measure_lengths,
    "plate": _scan_plate,
    **dict.fromkeys(CONTACT_STEPS, touch_contact),
    "temperatures": _confirm_temperatures,
}
