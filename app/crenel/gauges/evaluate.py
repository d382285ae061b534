"""Evaluates the folder of a performance test and writes ``performance.json``."""

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

import numpy as np

from crenel.errors import OperationError, sentence
from crenel.formats.json_document import SOFTWARE
from crenel.formats.results.calibration import SerialNumbers
from crenel.gauges.contact.evaluate import (
    contact_features,
    contact_notes,
    measure_contact_test,
)
from crenel.gauges.judgement.document import (
    ImpliedOffsetPart,
    LengthPoint,
    PerformanceFile,
    SphereMeasurement,
    read_performance,
)
from crenel.gauges.judgement.evaluate import (
    K,
    Measured,
    find_unused_limits,
    judge_all,
    judge_figure,
    plan_notes,
    refuse,
)
from crenel.gauges.judgement.evaluate_measured_data import (
    MeasuredData,
    filter_note,
    find_changed_settings,
    last_measured_at,
    read_measured_data,
    read_scan_settings,
)
from crenel.gauges.judgement.evaluate_temperatures import (
    arm_span,
    artefact_span,
    find_unsteady,
    temperature_notes,
    temperatures_part,
    unknown_expansions,
)
from crenel.gauges.judgement.maths_value_uncertainty import (
    SphereCertificate,
    form_uncertainty_um,
    size_uncertainty_um,
)
from crenel.gauges.length.evaluate import length_features, measure_lengths
from crenel.gauges.plan.document import (
    RESULT,
    PerformancePlan,
    read_plan,
    sphere_features,
)
from crenel.gauges.plan.document_symbols import SPHERE_QUANTITIES, editions
from crenel.gauges.plan.evaluate_artefacts import artefact_problems, unknown_forms
from crenel.gauges.plan.maths_lengths import LENGTHS
from crenel.gauges.plane.evaluate import measure_plane
from crenel.gauges.sphere.evaluate import find_loose, find_unfinished, measure_position
from crenel.gauges.sphere.evaluate_position import (
    PositionResult,
    bring_sizes_to_20,
    largest_form_effect,
    name_causes,
    problems_of,
    sphere_certificate,
    sphere_uncertainty_um,
    worst,
)
from crenel.gauges.sphere.maths_location import ImpliedOffset, estimate_offset
from crenel.messages.limits import beside_limit
from crenel.messages.message import Message, Text, message, quantity

STATION_NOTES = ("performance-aside-note", "performance-touches-taken-back")
"""Notes that the files of a test do not tell."""
MOVED_BY_SCATTER = 3.8
"""How many standard deviations of a touch the centres by 25 and by 5 touches are apart at most in
997 of 1000 spheres that stand still: simulated."""


@dataclass(frozen=True)
class _Parts:
    """What only some kinds of test have."""

    spheres: tuple[SphereMeasurement, ...] = ()
    offset: ImpliedOffsetPart | None = None
    lengths: tuple[LengthPoint, ...] = ()
    notes: tuple[Text, ...] = ()
    undecided: tuple[Text, ...] = ()
    """Why values that are stated are not decided."""


def evaluate_performance(folder: Path, ended_at: str = "") -> PerformanceFile:
    """Computes every figure of a test from its touches and recordings.

    Args:
        ended_at: ISO 8601; empty: when the last touch or scan was made, or now if the folder does
            not tell.

    Raises:
        OperationError: the plan, the arm or the calibration cannot be read, or a recording is
            damaged. What keeps single figures from being stated is in the result.
    """
    plan = read_plan(folder)
    _check_artefact(plan)
    data = read_measured_data(folder, _features(plan))
    settings = read_scan_settings(data)
    problems = artefact_problems(plan, data.calibration, data.arm)
    problems += find_changed_settings(settings)
    measured, parts = _measure(data, problems)
    artefact, arm = artefact_span(plan, data.end), arm_span(plan, data.end)
    unsteady = find_unsteady(artefact, arm, plan.temperature_limits.limits)
    undecided = (*unsteady, *parts.undecided)
    why = undecided[0] if undecided else ""
    unknown = {**unknown_expansions(plan, artefact), **unknown_forms(plan)}
    still_open = dict.fromkeys(unknown.values())
    figures = tuple(
        judge_figure(plan, one, why or unknown.get(one.quantity, "")) for one in measured
    )
    serials = SerialNumbers(arm=data.arm.serial_number)
    if data.calibration is not None:
        serials = data.calibration.serial_numbers
    status = "" if plan.standards_at_hand else message("performance-status-no-conformity-claimed")
    return PerformanceFile(
        id=plan.id,
        kind=plan.kind,
        station=plan.station,
        operator=plan.operator,
        simulated=plan.simulated,
        started_at=plan.started_at,
        ended_at=ended_at or last_measured_at(folder) or _now(),
        edition=plan.edition,
        standards=editions()[plan.edition].standards,
        status=status,
        sphere=plan.sphere,
        length=plan.length,
        plate=plan.plate,
        serial_numbers=serials,
        gate=plan.gate,
        rule=plan.rule,
        figures=figures,
        verdict=judge_all(figures),
        problems=tuple(sentence(text) for text in (*problems, *undecided, *still_open)),
        notes=(
            *plan_notes(plan, filter_note(settings)),
            *find_unused_limits(plan, measured),
            *parts.notes,
            *temperature_notes(plan, data.end),
        ),
        temperatures=temperatures_part(plan, data.end),
        inputs=data.inputs,
        software=SOFTWARE,
        spheres=parts.spheres,
        offset=parts.offset,
        lengths=parts.lengths,
    )


def write_performance(folder: Path) -> PerformanceFile:
    """Evaluates and writes the result; raises ``OperationError``.

    What only the station knew, and an earlier result has, is kept: when the test ended, the
    temperatures of the station, and which scans and touches do not count.
    """
    if not (folder / RESULT).is_file():
        result = evaluate_performance(folder)
    else:
        before = read_performance(folder)
        result = evaluate_performance(folder, before.ended_at)
        notes = [note for note in before.notes if _is_from_station(note)]
        kept = {"notes": (*result.notes, *notes), "temperature_c": before.temperature_c}
        result = result.model_copy(update=kept)
    result.write(folder / RESULT)
    return result


def _now() -> str:
    return datetime.now(UTC).isoformat(timespec="seconds").replace("+00:00", "Z")


def _is_from_station(note: Text) -> bool:
    return isinstance(note, Message) and note.message_id in STATION_NOTES


def _check_artefact(plan: PerformancePlan) -> None:
    """A contact test may be done without one."""
    artefacts = {"sphere": plan.sphere, "lengths": plan.length, "plane": plan.plate}
    if plan.kind in artefacts and artefacts[plan.kind] is None:
        raise OperationError(
            "plan-without-artefact", message("plan-without-artefact", which=plan.kind)
        )


def _features(plan: PerformancePlan) -> list[str]:
    if plan.kind == "sphere":
        return sphere_features(plan.positions)
    if plan.kind == "lengths":
        return length_features(plan)
    return contact_features() if plan.kind == "contact" else []


def _measure(data: MeasuredData, problems: list[Text]) -> tuple[list[Measured], _Parts]:
    """The quantities, and further fields of the result. ``problems`` may grow."""
    plan, parts = data.plan, _Parts()
    if plan.kind == "sphere":
        measured, parts = _measure_sphere(data, problems)
    elif plan.kind == "lengths":
        found = measure_lengths(data)
        measured = list(found.measured)
        parts = _Parts(lengths=found.points, notes=found.notes, undecided=_fewer_lengths(plan))
        problems += found.problems
    elif plan.kind == "plane":
        plane = measure_plane(data)
        measured, parts = list(plane.measured), _Parts(notes=plane.notes, undecided=plane.undecided)
    else:  # of several artefacts, each refuses its own figures
        measured, of_artefacts = measure_contact_test(data)
        problems += of_artefacts
        return measured, _Parts(notes=contact_notes(data))
    return [refuse(one, problems) for one in measured], parts


def _measure_sphere(data: MeasuredData, problems: list[Text]) -> tuple[list[Measured], _Parts]:
    plan = data.plan
    assert plan.sphere is not None, "a plan of this kind has a sphere"
    certificate = sphere_certificate(plan.sphere)
    off_c, sd_c = data.off_20_c
    results = [measure_position(data, plan.sphere, i + 1) for i in range(plan.positions)]
    for result in results:
        bring_sizes_to_20(result, plan.sphere, off_c)
    moved_um = max(result.moved_um for result in results)
    problems += _find_moved(results, certificate)
    problems += [text for result in results for text in find_loose(data, result)]
    problems += find_unfinished(data, results)
    of_unknown_form = unknown_forms(plan)
    measured = [
        Measured(
            of,
            worst(results, of),
            tuple(None if of not in one.values_mm else 1e3 * one.values_mm[of] for one in results),
            None
            if of in of_unknown_form
            else sphere_uncertainty_um(
                of, certificate, moved_um, largest_form_effect(results, of), sd_c, off_c
            ),
            problems_of(results, of),
            tuple(name for one in results for name in one.data.get(of, ())),
        )
        for of in SPHERE_QUANTITIES
    ]
    spheres = tuple(result.measurement(stated=not problems) for result in results)
    # where no location is stated, nothing follows from it either
    is_located = not problems and worst(results, "location-scan") is not None
    offset = _find_offset(results) if is_located else None
    notes = [note for result in results for note in result.notes]
    if not problems:
        size_um = size_uncertainty_um(certificate, sd_c, off_c)
        for result in results:
            causes = name_causes(result, size_um)
            notes += [_at_position(text, result, len(results)) for text in causes]
    part = None if offset is None else _offset_part(offset)
    return measured, _Parts(spheres, part, notes=tuple(notes))


def _fewer_lengths(plan: PerformancePlan) -> tuple[Text, ...]:
    """A standard with fewer lengths than the procedure takes."""
    count = 0 if plan.length is None else len(plan.length.lengths)
    return (message("performance-fewer-lengths", count=count),) if count < LENGTHS else ()


def _find_moved(results: Sequence[PositionResult], certificate: SphereCertificate) -> list[Text]:
    """Where the sphere moved by more than its certificate and the arm's own scatter make of two
    centres, hardly ever more."""
    still_um = K * max(form_uncertainty_um(certificate), size_uncertainty_um(certificate)) / 2
    found: list[Text] = []
    for result in results:
        limit_um = max(still_um, MOVED_BY_SCATTER * 1e3 * result.touch_sd_mm)
        if result.moved_um <= limit_um:
            continue
        moved, limit = beside_limit(result.moved_um, limit_um, "µm", 1)
        text = message("sphere-or-arm-moved", moved=moved, limit=limit)
        found.append(_at_position(text, result, len(results)))
    return found


def _at_position(text: Text, result: PositionResult, count: int) -> Text:
    """What is said of one of so many positions of the sphere."""
    if count == 1:
        return text
    return message("at-position", position=result.position, text=text)


def _find_offset(results: Sequence[PositionResult]) -> ImpliedOffset | None:
    """The probe matrix's error that the location error implies, of the position that counts."""
    result = max(results, key=lambda one: one.values_mm["location-scan"])
    if result.centres_mm is None or result.R_arm_sensor is None:
        return None
    try:
        return estimate_offset(result.centres_mm, result.R_arm_sensor, result.tactile_sd_mm)
    except OperationError:
        return None


def _offset_part(found: ImpliedOffset) -> ImpliedOffsetPart:
    x, y, z = (float(value) for value in found.offset_mm)
    sx, sy, sz = (float(value) for value in np.sqrt(np.diag(found.covariance)))
    known = {
        "size": quantity(1e3 * found.size_mm, "µm"),
        "left": quantity(1e3 * found.left_mm, "µm"),
    }
    return ImpliedOffsetPart(
        offset_mm=(x, y, z),
        standard_uncertainty_mm=(sx, sy, sz),
        significant=found.is_significant,
        left_um=1e3 * found.left_mm,
        text=message("offset-worth-calibrating", **known)
        if found.is_significant
        else message("offset-not-significant", **known),
    )
