"""What is drawn of a performance test: places, patches, articulations, figures. Pure."""

from crenel.gauges.guide_plan import quantities_of
from crenel.gauges.guide_view import (
    PerformanceFigureLine,
    PerformanceLimitLine,
    PerformancePicture,
    PerformanceResultView,
)
from crenel.gauges.judgement.document import PerformanceFile
from crenel.gauges.plan.document_symbols import (
    TITLES,
    Quantity,
    symbol_of,
)
from crenel.gauges.session.kind import AnyKind, AnyLive
from crenel.gauges.session.state import PerformanceState
from crenel.guide.common.journal import error_from_payload
from crenel.messages.message import Text, message

RUN_REASONS = {
    "dropped": message("performance-run-dropped"),
    "repeated": message("performance-run-repeated"),
}


def build_picture(state: PerformanceState, live: AnyLive) -> PerformancePicture:
    """The picture."""
    kind = live.kind
    picture = PerformancePicture(
        limits=[_limit(state, one) for one in quantities_of(state, live.artefact)],
        artefact_c=state.temperatures.artefact_c,
        arm_c=state.temperatures.arm_c,
        expanded_c=state.expanded_c,
        places=[],
        tip_deg=None,
        patches=[],
        articulations=kind.lines(state, live),
        lengths=None,
        contact=None,
        result=result_view(live.result) if state.step == "review" and live.result else None,
    )
    return kind.draw(picture, state, live)


def _limit(state: PerformanceState, of: Quantity) -> PerformanceLimitLine:
    symbol = symbol_of(state.edition, of).symbol
    limit = state.limits.get(of)
    return PerformanceLimitLine(
        of,
        symbol,
        TITLES[of],
        limit.a_um if limit else None,
        limit.k if limit else None,
        limit.b_um if limit else None,
        grows=state.limits_grow,
    )


def aside_notes(state: PerformanceState, kind: AnyKind) -> list[Text]:
    """The scans that do not count, and why."""
    notes: list[Text] = []
    for scan in state.scans:
        if scan.aside:
            reason: Text = RUN_REASONS[scan.aside]
        elif scan.refused is not None:
            reason = error_from_payload(scan.refused).reason
        else:
            continue
        title = kind.scan_title(scan)
        notes.append(message("performance-aside-note", title=title, reason=reason))
    return notes


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
