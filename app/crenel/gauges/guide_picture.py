"""What is drawn of a performance test: places, patches, articulations, figures. Pure."""

from crenel.gauges.contact.guide_picture import contact_picture
from crenel.gauges.guide_live import PerformanceLive, SeenPatches
from crenel.gauges.guide_plan import QUANTITIES, edition_of, quantities_of
from crenel.gauges.guide_rules import patch_totals
from crenel.gauges.guide_state import CONTACT_STEPS, PerformanceState
from crenel.gauges.guide_view import (
    ArticulationLine,
    ArticulationState,
    PatchMark,
    PerformanceFigureLine,
    PerformanceLimitLine,
    PerformancePicture,
    PerformanceResultView,
    PlaceMark,
)
from crenel.gauges.judgement.document import PerformanceFile
from crenel.gauges.length.guide_picture import lengths_picture
from crenel.gauges.plan.document import ARTICULATIONS, LOCATION_TOUCHES, sphere_feature
from crenel.gauges.plan.document_symbols import (
    TITLES,
    Quantity,
    symbol_of,
)
from crenel.gauges.plane.guide import plate_lines
from crenel.gauges.session.entries import AnyScan, BarScan, PlateScan, SphereScan
from crenel.gauges.sphere.evaluate_scans import LEAST_FRAMES, LEAST_POINTS
from crenel.guide.common.journal import error_from_payload
from crenel.messages.message import Text, message

RUN_REASONS = {
    "dropped": message("performance-run-dropped"),
    "repeated": message("performance-run-repeated"),
}


def build_picture(state: PerformanceState, live: PerformanceLive) -> PerformancePicture:
    """The picture."""
    places = live.places
    return PerformancePicture(
        limits=[_limit(state, one) for one in quantities_of(state, live.artefact)],
        artefact_c=state.temperatures.artefact_c,
        arm_c=state.temperatures.arm_c,
        expanded_c=state.expanded_c,
        places=_places(live),
        tip_deg=places.tip_flat_deg if places is not None else None,
        patches=_patches(state, live) if state.step == "scan" else [],
        articulations=_articulations(state, live),
        lengths=lengths_picture(state, live.lengths) if live.lengths is not None else None,
        contact=contact_picture(state, live.contact)
        if live.contact is not None and state.step in CONTACT_STEPS
        else None,
        result=result_view(live.result) if state.step == "review" and live.result else None,
    )


def _limit(state: PerformanceState, of: Quantity) -> PerformanceLimitLine:
    symbol = symbol_of(edition_of(state.test), of).symbol
    limit = state.limits.get(of)
    return PerformanceLimitLine(
        of,
        symbol,
        TITLES[of],
        limit.a_um if limit else None,
        limit.k if limit else None,
        limit.b_um if limit else None,
        grows=of in QUANTITIES["lengths"],
    )


def _places(live: PerformanceLive) -> list[PlaceMark]:
    places = live.places
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


def _patches(state: PerformanceState, live: PerformanceLive) -> list[PatchMark]:
    """The patches of the scans that count, and of the one that runs."""
    flat, totals = live.pattern_flat_deg.tolist(), patch_totals(state)
    if live.seen is not None:
        pairs = zip(totals, live.seen.patches, strict=True)
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


def _articulations(state: PerformanceState, live: PerformanceLive) -> list[ArticulationLine]:
    numbers = range(1, ARTICULATIONS + 1)
    if state.step == "plate":
        return plate_lines(state)
    if state.step == "location":
        return [_touch_line(state, number) for number in numbers]
    if state.step != "scan":
        return []
    return [_scan_line(state, live, number) for number in numbers]


def articulation_title(number: int) -> Text:
    """How the wrist or the sensor is held."""
    return message("performance-articulation", number=number)


def _touch_line(state: PerformanceState, number: int) -> ArticulationLine:
    done = len(state.of(sphere_feature(state.position, "location", number)))
    shown: ArticulationState = "todo"
    if done >= LOCATION_TOUCHES:
        shown = "done"
    elif number == state.articulation:
        shown = "now"
    text = message("touches", done=done, of=LOCATION_TOUCHES)
    return ArticulationLine(number, articulation_title(number), shown, text)


def _scan_line(state: PerformanceState, live: PerformanceLive, number: int) -> ArticulationLine:
    title = articulation_title(number)
    found = [one for one in state.here if one.articulation == number and not one.aside]
    last = found[-1] if found else None
    if last is None:
        shown: ArticulationState = "now" if number == state.articulation else "todo"
        return ArticulationLine(number, title, shown, "")
    if not last.ended:
        return ArticulationLine(number, title, "scanning", _coverage_text(live.seen))
    if last.refused is not None:
        return ArticulationLine(number, title, "refused", error_from_payload(last.refused).reason)
    if last.waiting:
        return ArticulationLine(number, title, "measuring", _coverage_text(live.seen))
    return ArticulationLine(number, title, "done", _coverage_text(last))


def _coverage_text(of: SphereScan | SeenPatches | None) -> Text:
    if of is None:
        return ""
    covered = sum(p >= LEAST_POINTS and f >= LEAST_FRAMES for p, f in of.patches)
    return message("performance-scan-shows", points=of.points, patches=covered)


def run_text(scan: AnyScan) -> Text:
    """A scan that was measured, in a sentence."""
    if isinstance(scan, BarScan):
        return message("performance-bar-scan-done", place=scan.of.place, repeat=scan.of.repeat)
    if isinstance(scan, PlateScan):
        return message("performance-plate-scan-done", number=scan.orientation)
    return message("performance-scan-done", articulation=scan.articulation)


def aside_notes(state: PerformanceState) -> list[Text]:
    """The scans that do not count, and why."""
    notes: list[Text] = []
    for scan in state.scans:
        if scan.aside:
            reason: Text = RUN_REASONS[scan.aside]
        elif scan.refused is not None:
            reason = error_from_payload(scan.refused).reason
        else:
            continue
        title = _run_title(scan)
        notes.append(message("performance-aside-note", title=title, reason=reason))
    return notes


def _run_title(scan: AnyScan) -> Text:
    if isinstance(scan, BarScan):
        return message("performance-bar-run", place=scan.of.place, repeat=scan.of.repeat)
    if isinstance(scan, PlateScan):
        return message("performance-plate-run", number=scan.orientation)
    return message("performance-run", position=scan.position, articulation=scan.articulation)


def result_view(found: PerformanceFile) -> PerformanceResultView:
    """What a test found."""
    figures = [
        PerformanceFigureLine(
            one.quantity,
            one.symbol,
            one.title,
            one.value,
            one.values,
            one.test_uncertainty,
            one.limit,
            one.decision,
            one.reason,
            one.problem,
        )
        for one in found.figures
    ]
    return PerformanceResultView(
        found.verdict.result,
        found.verdict.text,
        found.status,
        figures,
        found.offset.text if found.offset else "",
        found.problems,
        found.notes,
    )
