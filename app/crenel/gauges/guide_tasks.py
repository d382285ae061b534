"""What takes longer in a performance test: its plan, its scans, its evaluation."""

import shutil
from collections.abc import Mapping
from datetime import UTC, datetime

from crenel.errors import OperationError
from crenel.formats.io_errors import convert_io_errors
from crenel.gauges.evaluate import evaluate_performance
from crenel.gauges.guide import PerformanceGuide
from crenel.gauges.guide_flow import CANCELLED
from crenel.gauges.guide_picture import aside_notes
from crenel.gauges.guide_plan import limit_parts, measures_by_scan
from crenel.gauges.guide_state import kind_of
from crenel.gauges.judgement.evaluate_measured_data import ASIDE
from crenel.gauges.length.guide_measure import measure_bar_scan
from crenel.gauges.length.guide_scan_lines import pass_title
from crenel.gauges.length.guide_so_far import touches_on_end
from crenel.gauges.plan.document import RESULT, plane_scan, sphere_scan
from crenel.gauges.plan.document_station_limits import write_station_limits
from crenel.gauges.plan.document_temperatures import END_TEMPERATURES, EndTemperatures
from crenel.gauges.plan.maths_gate import gate_sphere
from crenel.gauges.plane.guide import measure_plate
from crenel.gauges.plane.guide_state import PlaneState
from crenel.gauges.session.entries import AnyScan, BarPass, BarScan, PlateScan, SphereScan
from crenel.gauges.sphere.evaluate_scans import LEAST_FRAMES, LEAST_PATCHES, LEAST_POINTS
from crenel.gauges.sphere.guide_places import POLE
from crenel.gauges.sphere.maths_pattern import PatchCoverage, pattern_directions, scan_patches
from crenel.guide.common.arguments import Args
from crenel.guide.common.flow import DECISION_QUALITY
from crenel.guide.common.journal import error_payload
from crenel.messages.message import Text, message
from crenel.station.jobs import Progress
from crenel.station.scan.points import Show


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
    standard = guide.standard() if guide.state.test == "lengths" else None
    payload: dict[str, object] = {}
    if standard is not None:
        payload = {
            "lengths": len(standard.lengths),
            "touches_each": touches_on_end(standard),
            "by_scan": measures_by_scan(guide.state, standard),
        }
    guide.append("step_confirmed", payload, key)


def begin_plate_scan(guide: PerformanceGuide, orientation: int, key: str | None) -> None:
    """Starts the scan of the plate in an orientation; an earlier one of it is kept aside. The first
    scan of the test freezes its plan.

    Raises:
        OperationError: it cannot start.
    """
    if not guide.state.frozen:
        guide.freeze()
    title = message("performance-plate-scan-name", number=orientation)
    _record(guide, plane_scan(orientation), title)
    guide.append("scan_begun", {"orientation": orientation}, key)


def confirm(guide: PerformanceGuide, key: str | None) -> None:
    """Ends a step; at the end of the test, the temperatures that are shown are those measured."""
    payload: dict[str, object] = {}
    if guide.state.step == "temperatures":
        found = guide.state.temperatures
        payload = {"artefact_c": found.artefact_c, "arm_c": found.arm_c}
        EndTemperatures.model_validate(payload).write(guide.folder / END_TEMPERATURES)
    guide.append("step_confirmed", payload, key)


def begin_scan(guide: PerformanceGuide, articulation: int, key: str | None) -> None:
    """Starts the scan of an articulation; an earlier one of it is kept aside.

    Raises:
        OperationError: it cannot start.
    """
    name = sphere_scan(guide.state.position, articulation)
    title = message("performance-scan-name", articulation=articulation)
    number = len(guide.state.scans) + 1
    _record(guide, name, title, guide.coverage.begin(number, _empty_coverage(guide)))
    guide.append("scan_begun", {"articulation": articulation}, key)


def _empty_coverage(guide: PerformanceGuide) -> PatchCoverage | None:
    """About the touched sphere; None if its centre is not known."""
    gauge, centre = guide.gauge(), guide.centre_mm()
    if gauge is None or gauge.radius_mm is None or centre is None:
        return None
    return PatchCoverage(centre, 2 * gauge.radius_mm, POLE, guide.plan().gate.gate)


def begin_bar_scan(guide: PerformanceGuide, of: BarPass, key: str | None) -> None:
    """Starts a scan of a ball bar in its present place; an earlier one of it is kept aside.

    Raises:
        OperationError: it cannot start.
    """
    title = message("performance-bar-scan-name", place=of.place, repeat=of.repeat)
    _record(guide, of.name, title)
    payload = {"place": of.place, "repeat": of.repeat, "length": of.length}
    guide.append("scan_begun", payload, key)


def _record(guide: PerformanceGuide, name: str, title: Text, watch: Show | None = None) -> None:
    folder = guide.folder / name
    if folder.exists():
        number = 1 + sum(1 for _ in guide.folder.glob(f"{name}{ASIDE}*"))
        with convert_io_errors(folder):
            shutil.move(folder, guide.folder / f"{name}{ASIDE}{number}")
    guide.station.scanner.start(str(title), folder, watch)


def end_scan(guide: PerformanceGuide, kind: str, key: str | None) -> AnyScan:
    """Ends the scan that runs, as ``scan_ended`` or ``scan_dropped``."""
    scan = guide.state.open_scan
    assert scan is not None
    guide.append(kind, {"number": scan.number}, key)
    return scan


def measuring_text(guide: PerformanceGuide, scan: AnyScan) -> Text:
    """Said while a scan is measured."""
    if isinstance(scan, BarScan):
        return message("performance-measuring-bar-scan", scan=pass_title(scan.of, guide.lengths()))
    if isinstance(scan, PlateScan):
        return message("performance-measuring-plate-scan", number=scan.orientation)
    return message("performance-measuring-scan", articulation=scan.articulation)


def measure_scan(guide: PerformanceGuide, scan: AnyScan, progress: Progress) -> None:
    """Rebuilds a scan from its recording and measures its patches or lengths; a refusal is kept,
    too."""
    progress(measuring_text(guide, scan), 0.5)
    folder = guide.folder / scan.name
    try:
        if isinstance(scan, BarScan):
            measured = measure_bar_scan(guide, scan)
        elif isinstance(scan, PlateScan):
            measured = _plate_in(guide, scan)
        else:
            measured = _patches_of(guide, scan)
    except OperationError as error:
        guide.append("scan_refused", {"number": scan.number, "refused": error_payload(error)})
        guide.station.bus.event("refused", error.text, "attention")
    else:
        guide.append("scan_measured", {"number": scan.number, **measured})
        guide.station.bus.event("step_done", kind_of(guide.state).scan_text(scan), "good")
    scan_id = f"{guide.folder.name}-{folder.name}"
    guide.station.scanner.forget(scan_id)
    guide.station.scene.close_scan(scan_id)


def _patches_of(guide: PerformanceGuide, scan: SphereScan) -> Mapping[str, object]:
    """Points of the sphere in a scan, and points and frames of each patch."""
    with guide.lock:
        arm, gauge, centre = guide.arm(), guide.gauge(), guide.centre_mm()
    if arm is None or gauge is None or gauge.radius_mm is None or centre is None:
        raise OperationError("datasheets-unreadable", message("sessions-gauge-arm-cannot-read-any"))
    cloud = guide.read_cloud(scan, arm)
    gate = guide.plan().gate.gate
    found = gate_sphere(cloud.points_mm, cloud.views, 2 * gauge.radius_mm, POLE, centre, gate)
    patches = scan_patches(
        cloud.points_mm[found.inside],
        cloud.frame[found.inside],
        found.centre_mm,
        pattern_directions(POLE),
    )
    covered = (patches.points >= LEAST_POINTS) & (patches.frames >= LEAST_FRAMES)
    if covered.sum() < LEAST_PATCHES:
        raise OperationError(
            "cloud-too-small",
            message("performance-scan-too-small", count=int(covered.sum())),
            remedy=message("performance-scan-again"),
        )
    counts = zip(patches.points.tolist(), patches.frames.tolist(), strict=True)
    patched = [list(count) for count in counts]
    return {"points": int(found.inside.sum()), "patches": patched}


def _plate_in(guide: PerformanceGuide, scan: PlateScan) -> Mapping[str, object]:
    """What a scan of the plate shows, beside the good scan of the other orientation."""
    with guide.lock:
        arm, scans = guide.arm(), guide.state_of(PlaneState).plate_scans
    if arm is None:
        raise OperationError("datasheets-unreadable", message("sessions-gauge-arm-cannot-read-any"))
    others = [one for one in scans if one.good and one.orientation != scan.orientation]
    other = guide.read_cloud(others[-1], arm).R_arm_sensor if others else None
    return measure_plate(guide.read_cloud(scan, arm), guide.plan().gate.shell_mm, other)


def evaluate(guide: PerformanceGuide, progress: Progress) -> None:
    """Computes the figures and writes them; a refusal is kept, too."""
    progress(message("performance-evaluating"), 0.2)
    state, provenance = guide.state, guide.provenance
    ended_at = datetime.now(UTC).isoformat(timespec="seconds").replace("+00:00", "Z")
    try:
        found = evaluate_performance(guide.folder, ended_at)
        notes = aside_notes(state)
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
