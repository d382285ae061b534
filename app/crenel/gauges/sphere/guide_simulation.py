"""The simulated operator in a one-sphere test: touches the sphere's places, and scans it."""

from collections.abc import Mapping

import numpy as np

from crenel.gauges.guide import PerformanceGuide
from crenel.gauges.plan.document import ARTICULATIONS
from crenel.gauges.session.simulation import SCAN_ATTEMPTS, confirm, scan_once
from crenel.gauges.sphere.guide_picture import missing_patches
from crenel.gauges.sphere.guide_places import POLE, directions_of_articulations
from crenel.gauges.sphere.guide_scans import part_places, sphere_centre_mm
from crenel.gauges.sphere.guide_state import SphereState
from crenel.gauges.sphere.maths_pattern import pattern_directions
from crenel.guide.common.simulated_operator import SimulatedOperator
from crenel.guide.common.simulation import ATTEMPTS, StepWork, touch_until_taken
from crenel.messages.message import message
from crenel.station.jobs import Progress


def _touch(guide: PerformanceGuide, operator: SimulatedOperator, progress: Progress) -> None:
    of = guide.state.wanted
    while (done := len(guide.state.of_step)) < of:
        text = message("performance-simulation-touches", done=done + 1, of=of, test="sphere")
        progress(text, done / of)
        if not guide.simulation_running or not _touch_next(guide, operator):
            return
    confirm(guide)


def _touch_next(guide: PerformanceGuide, operator: SimulatedOperator) -> bool:
    with guide.lock:
        state, part = guide.state_of(SphereState), part_places(guide)
        centre = sphere_centre_mm(guide)
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


def _scan(guide: PerformanceGuide, operator: SimulatedOperator, progress: Progress) -> None:
    attempts = 0
    while (articulation := guide.state_of(SphereState).articulation) and attempts < SCAN_ATTEMPTS:
        text = message("performance-simulation-scans", articulation=articulation)
        progress(text, (articulation - 1) / ARTICULATIONS)
        if not guide.simulation_running or not _scan_one(guide, operator, articulation, progress):
            return
        attempts = attempts + 1 if guide.state_of(SphereState).articulation == articulation else 0
    for repeat in range(ARTICULATIONS):
        missing = missing_patches(guide.state_of(SphereState))
        if not missing or guide.state_of(SphereState).articulation:
            break
        again = _sees_best(guide, missing[0])
        slowness = 2.0 + repeat  # a pass at the usual speed had too few pictures of the place
        if not guide.simulation_running or not _scan_one(
            guide, operator, again, progress, slowness
        ):
            return
    confirm(guide)


def _sees_best(guide: PerformanceGuide, patch: int) -> int:
    """The articulation that a patch is seen best from."""
    directions = directions_of_articulations(sphere_centre_mm(guide))
    return 1 + int(np.argmax(directions @ pattern_directions(POLE)[patch - 1]))


def _scan_one(
    guide: PerformanceGuide,
    operator: SimulatedOperator,
    articulation: int,
    progress: Progress,
    slowness: float = 1.0,
) -> bool:
    """One scan from its begin to its measure; False when it was stopped."""
    direction = directions_of_articulations(sphere_centre_mm(guide))[articulation - 1]
    return scan_once(
        guide,
        {"articulation": articulation},
        lambda: operator.scan_sphere(direction.tolist(), slowness),
        progress,
    )


SPHERE_WORK: Mapping[str, StepWork[PerformanceGuide]] = {
    **dict.fromkeys(SphereState.touching, _touch),
    "scan": _scan,
}
