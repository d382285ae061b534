"""Evaluates the folder of a performance test."""

from datetime import UTC, datetime
from pathlib import Path

from crenel.errors import sentence
from crenel.formats.json_document import SOFTWARE
from crenel.formats.results.calibration import SerialNumbers
from crenel.gauges.judgement.document import PerformanceFile
from crenel.gauges.judgement.evaluate import find_unused_limits, judge_all, judge_figure
from crenel.gauges.judgement.evaluate_kind import Evaluation
from crenel.gauges.judgement.evaluate_measured_data import (
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
from crenel.gauges.plan.document import read_plan
from crenel.gauges.plan.document_symbols import editions
from crenel.messages.message import message


def evaluate_test(folder: Path, evaluation: Evaluation, ended_at: str = "") -> PerformanceFile:
    """Computes every figure of a test from its touches and recordings.

    Args:
        evaluation: of the kind of test that the plan names.
        ended_at: ISO 8601; empty: when the last touch or scan was made, or now if the folder does
            not tell.

    Raises:
        OperationError: the plan, the arm or the calibration cannot be read, or a recording is
            damaged. What keeps single figures from being stated is in the result.
    """
    plan = read_plan(folder)
    evaluation.check(plan)
    data = read_measured_data(folder, evaluation.features(plan))
    settings = read_scan_settings(data)
    problems = evaluation.list_problems(plan, data.calibration, data.arm)
    problems += find_changed_settings(settings)
    found = evaluation.measure(data, problems)
    artefact, arm = artefact_span(plan, data.end), arm_span(plan, data.end)
    unsteady = find_unsteady(artefact, arm, plan.temperature_limits.limits)
    undecided = (*unsteady, *found.undecided)
    why = undecided[0] if undecided else ""
    unknown = {**unknown_expansions(plan, artefact), **evaluation.unknown(plan)}
    still_open = dict.fromkeys(unknown.values())
    figures = tuple(
        judge_figure(plan, one, why or unknown.get(one.quantity, "")) for one in found.measured
    )
    serials = SerialNumbers(arm=data.arm.serial_number)
    if data.calibration is not None:
        serials = data.calibration.serial_numbers
    filtered = filter_note(settings)
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
            *([filtered] if filtered else []),
            *evaluation.notes(plan, bool(filtered)),
            *find_unused_limits(plan, found.measured),
            *found.notes,
            *temperature_notes(plan, data.end, evaluation.has_size),
        ),
        temperatures=temperatures_part(plan, data.end),
        inputs=data.inputs,
        software=SOFTWARE,
        spheres=found.spheres,
        offset=found.offset,
        lengths=found.lengths,
    )


def _now() -> str:
    return datetime.now(UTC).isoformat(timespec="seconds").replace("+00:00", "Z")
