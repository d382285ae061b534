"""What is drawn of a one-sphere test: places, patches, articulations. Pure."""

from crenel.gauges.guide_view import ArticulationLine, ArticulationState, PatchMark, PlaceMark
from crenel.gauges.plan.document import LOCATION_TOUCHES, PATTERN_TOUCHES, sphere_feature
from crenel.gauges.sphere.evaluate_scans import LEAST_FRAMES, LEAST_POINTS
from crenel.gauges.sphere.guide_scans import SeenPatches, SphereKnown
from crenel.gauges.sphere.guide_state import SphereScan, SphereState
from crenel.guide.common.journal import error_from_payload
from crenel.messages.message import Text, message


def missing_patches(state: SphereState) -> list[int]:
    """Numbers of the patches that the scans of this position do not cover, from 1."""
    totals = patch_totals(state)
    return [
        number
        for number, (points, frames) in enumerate(totals, start=1)
        if points < LEAST_POINTS or frames < LEAST_FRAMES
    ]


def patch_totals(state: SphereState) -> list[tuple[int, int]]:
    """Points and frames of each patch over the scans of this position that count."""
    good = [scan.patches for scan in state.here if scan.good]
    if not good:
        return [(0, 0)] * PATTERN_TOUCHES
    return [
        (sum(points for points, _ in patch), sum(frames for _, frames in patch))
        for patch in zip(*good, strict=True)
    ]


def place_marks(known: SphereKnown) -> list[PlaceMark]:
    """The places of the part that is touched now."""
    places = known.places
    if places is None:
        return []
    return [
        PlaceMark(
            i + 1,
            round(right, 1),
            round(away, 1),
            "done" if i in places.taken else "next" if i == places.next else "free",
        )
        for i, (right, away) in enumerate(places.flat_deg.tolist())
    ]


def patch_marks(state: SphereState, known: SphereKnown) -> list[PatchMark]:
    """The patches of the scans that count, and of the one that runs."""
    flat, totals = known.pattern_flat_deg.tolist(), patch_totals(state)
    if known.seen is not None:
        pairs = zip(totals, known.seen.patches, strict=True)
        totals = [(known[0] + new[0], known[1] + new[1]) for known, new in pairs]
    return [
        PatchMark(
            i + 1,
            round(right, 1),
            round(away, 1),
            points,
            frames,
            round(min(points / LEAST_POINTS, frames / LEAST_FRAMES, 1.0), 2),
            points >= LEAST_POINTS and frames >= LEAST_FRAMES,
        )
        for i, ((right, away), (points, frames)) in enumerate(zip(flat, totals, strict=True))
    ]


def articulation_title(number: int) -> Text:
    """How the wrist or the sensor is held."""
    return message("performance-articulation", number=number)


def touch_line(state: SphereState, number: int) -> ArticulationLine:
    """What is touched in an articulation."""
    done = len(state.of(sphere_feature(state.position, "location", number)))
    shown: ArticulationState = "todo"
    if done >= LOCATION_TOUCHES:
        shown = "done"
    elif number == state.articulation:
        shown = "now"
    text = message("touches", done=done, of=LOCATION_TOUCHES)
    return ArticulationLine(number, articulation_title(number), shown, text)


def scan_line(state: SphereState, known: SphereKnown, number: int) -> ArticulationLine:
    """What the scan of an articulation has shown."""
    title = articulation_title(number)
    found = [one for one in state.here if one.articulation == number and not one.aside]
    last = found[-1] if found else None
    if last is None:
        shown: ArticulationState = "now" if number == state.articulation else "todo"
        return ArticulationLine(number, title, shown, "")
    if not last.ended:
        return ArticulationLine(number, title, "scanning", _coverage_text(known.seen))
    if last.refused is not None:
        return ArticulationLine(number, title, "refused", error_from_payload(last.refused).reason)
    if last.waiting:
        return ArticulationLine(number, title, "measuring", _coverage_text(known.seen))
    return ArticulationLine(number, title, "done", _coverage_text(last))


def _coverage_text(of: SphereScan | SeenPatches | None) -> Text:
    if of is None:
        return ""
    covered = sum(p >= LEAST_POINTS and f >= LEAST_FRAMES for p, f in of.patches)
    return message("performance-scan-shows", points=of.points, patches=covered)
