"""What takes longer in a performance test: its plan, its scans, its evaluation."""

from collections.abc import Mapping
from datetime import UTC, datetime

from crenel.errors import OperationError
from crenel.gauges.evaluate import evaluate_test
from crenel.gauges.guide import PerformanceGuide
from crenel.gauges.guide_flow import CANCELLED
from crenel.gauges.guide_picture import aside_notes
from crenel.gauges.guide_plan import limit_parts
from crenel.gauges.plan.document import RESULT, write_station_limits
from crenel.gauges.plan.document_temperatures import END_TEMPERATURES, EndTemperatures
from crenel.gauges.session.acts import keep_measured
from crenel.gauges.session.entries import TestScan
from crenel.guide.common.arguments import Args
from crenel.guide.common.flow import DECISION_QUALITY
from crenel.guide.common.journal import error_payload
from crenel.messages.message import message
from crenel.station.jobs import Progress


def set_limit(guide: PerformanceGuide, args: Args, key: str | None) -> None:
    """A limit by the datasheet, kept for the next tests, too."""
    payload = {name: args.get(name) for name in ("quantity", "a_um", "k", "b_um")}
    guide.append("limit_set", payload, key)
    write_station_limits(guide.data_folder, limit_parts(guide.state))


def set_temperature(guide: PerformanceGuide, args: Args, key: str | None) -> None:
    """Temperatures of artefact and arm: before the first touch, or at the end."""
    payload = {
        "celsius": args.get("celsius"),
        "arm_c": args.get("arm_c"),
        "expanded_c": args.get("expanded_c", 0.0),
    }
    guide.append("temperature_set", payload, key)


def confirm_artefact(guide: PerformanceGuide, key: str | None) -> None:
    """From here on the test uses its own copies of artefact, arm and calibration."""
    guide.keep_datasheets()
    guide.append("step_confirmed", guide.kind.begin_payload(guide), key)


def confirm(guide: PerformanceGuide, key: str | None) -> None:
    """Ends a step; at the end of the test, the temperatures that are shown are those measured."""
    payload: dict[str, object] = {}
    if guide.state.step == "temperatures":
        found = guide.state.temperatures
        payload = {"artefact_c": found.artefact_c, "arm_c": found.arm_c}
        EndTemperatures.model_validate(payload).write(guide.folder / END_TEMPERATURES)
    guide.append("step_confirmed", payload, key)


def end_scan(guide: PerformanceGuide, kind: str, key: str | None) -> TestScan:
    """Ends the scan that runs, as ``scan_ended`` or ``scan_dropped``."""
    scan = guide.state.open_scan
    assert scan is not None
    guide.append(kind, {"number": scan.number}, key)
    return scan


def measure_scan(guide: PerformanceGuide, scan: TestScan, progress: Progress) -> None:
    """Rebuilds a scan from its recording and measures its patches or lengths; a refusal is kept,
    too."""
    kind = guide.kind
    progress(kind.measuring_text(guide, scan), 0.5)
    keep_measured(
        guide,
        scan.name,
        scan.number,
        ("scan_measured", "scan_refused"),
        lambda: (kind.measure_scan(guide, scan), kind.scan_text(scan)),
    )


def evaluate(guide: PerformanceGuide, progress: Progress) -> None:
    """Computes the figures and writes them; a refusal is kept, too."""
    progress(message("performance-evaluating"), 0.2)
    state, provenance = guide.state, guide.provenance
    ended_at = datetime.now(UTC).isoformat(timespec="seconds").replace("+00:00", "Z")
    try:
        found = evaluate_test(guide.folder, guide.kind.evaluation, ended_at)
        notes = aside_notes(state, guide.kind)
        if voided := sum(touch.voided for touch in state.touches):
            notes.append(message("performance-touches-taken-back", count=voided))
        temperatures = (
            provenance.celsius_near(state.started_at),
            provenance.celsius_near(ended_at),
        )
        result = found.model_copy(
            update={"notes": (*found.notes, *notes), "temperature_c": temperatures}
        )
        result.write(guide.folder / RESULT)
    except OperationError as error:
        guide.append("evaluation_failed", {"refused": error_payload(error)})
        guide.station.bus.event("refused", error.text, "attention")
        return
    guide.append("evaluated", {"result": result.verdict.result})


def accept(guide: PerformanceGuide, key: str | None) -> None:
    """Lists the finished test; raises ``OperationError``, and nothing is kept then."""
    found = guide.result()
    assert found is not None
    verdict = found.verdict
    _close(guide, "accepted", {"result": verdict.result}, verdict.result, verdict.text, key)
    quality = DECISION_QUALITY[verdict.result]
    guide.station.bus.event("accepted", verdict.text, quality)


def abandon(guide: PerformanceGuide, reason: str, key: str | None) -> None:
    """Ends the test without a result; one in which a point was taken is listed with the reason."""
    if guide.state.frozen:
        payload = {"reason": reason}
        _close(guide, "abandoned", payload, "cancelled", CANCELLED[reason], key)
    else:
        guide.append("abandoned", {"reason": reason}, key)


def _close(
    guide: PerformanceGuide,
    kind: str,
    payload: Mapping[str, object],
    result: str,
    text: object,
    key: str | None,
) -> None:
    state, artefacts = guide.state, guide.artefacts()
    figures = {
        "kind": state.test,
        "result": result,
        "text": text,
        "artefact": ", ".join(one.name or name for name, one in artefacts.items()) or state.gauge,
        "operator": guide.provenance.operator(),
    }
    guide.keep(
        lambda check: guide.performances.close(
            state.session_id,
            kind,
            payload,
            state.calibration_id,
            guide.folder,
            figures,
            key,
            check,
        )
    )
