"""Errors of length by touch or scan: ball bars and step gauges in seven places."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import inf, isfinite
from typing import Literal

import numpy as np

from crenel.errors import OperationError
from crenel.gauges.judgement.document import LengthPoint
from crenel.gauges.judgement.evaluate import K, Measured, refuse
from crenel.gauges.judgement.evaluate_kind import Evaluated, Evaluation
from crenel.gauges.judgement.evaluate_loose_artefacts import loose_bar_problems
from crenel.gauges.judgement.evaluate_measured_data import MeasuredData
from crenel.gauges.judgement.maths_length_scatter import (
    find_rocking_places,
    sphere_touch_scatter_um,
)
from crenel.gauges.length.evaluate_scans import has_length_scans, measure_scanned_lengths
from crenel.gauges.length.maths_bar_spheres import BAR_CONE_DEG
from crenel.gauges.plan.document import PerformancePlan, length_feature
from crenel.gauges.plan.document_length_standard import LengthStandardFile
from crenel.gauges.plan.maths_lengths import (
    LENGTHS,
    PLACES,
    REPEATS,
    MeasuredLength,
    length_of_bar_mm,
    summarise_lengths,
)
from crenel.gauges.plan.maths_temperature import MeanTemperature
from crenel.messages.message import Text, message, quantity
from crenel.metrology.arm.kinematics import tip_of
from crenel.metrology.fitting.reference_sphere import sphere_centre
from crenel.metrology.transforms import Floats

LEAST_TOUCHES = 4
"""On a sphere of a bar."""


def length_features(plan: PerformancePlan) -> list[str]:
    """All groups of touches of a length test."""
    lengths = 0 if plan.length is None else len(plan.length.lengths)
    return [
        length_feature(place, repeat, length, end)
        for place in range(1, PLACES + 1)
        for repeat in range(1, REPEATS + 1)
        for length in range(1, lengths + 1)
        for end in (0, 1)
    ]


class LengthEvaluation(Evaluation):
    """The evaluation of the length test."""

    def artefact(self, plan: PerformancePlan) -> LengthStandardFile | None:
        return plan.length

    def features(self, plan: PerformancePlan) -> list[str]:
        return length_features(plan)

    def measure(self, data: MeasuredData, problems: list[Text]) -> Evaluated:
        found = measure_lengths(data, problems)
        return replace(found, measured=tuple(refuse(one, problems) for one in found.measured))


def measure_lengths(data: MeasuredData, problems: list[Text]) -> Evaluated:
    """The errors of length by touch and by scan, as far as a folder has them. ``problems``
    for which no figure is stated may grow.

    Raises:
        OperationError: a sphere has too few touches, or a scan cannot be rebuilt.
    """
    standard = data.plan.length
    assert standard is not None, "a plan of this kind has lengths"
    tip_mm = tip_of(data.arm).diameter_mm if data.tips_mm else 0.0
    touched, names = lengths_by_touch(standard, data.tips_mm, tip_mm, data.artefact)
    by_scan = data.plan.by_scan or has_length_scans(data)
    scanned = measure_scanned_lengths(data) if by_scan else None
    measured: list[Measured] = []
    if touched or scanned is None or data.plan.limit("length-touch") is not None:
        missing = _find_missing(standard, touched)
        measured.append(_worst(data, "length-touch", touched, names, missing))
        if touched and missing:  # the test was stopped
            problems.append(missing)
        steady_um = inf if scanned is None else scanned.scatter_um
        problems += rocking_problems(standard, touched, data.tips_mm, tip_mm, steady_um)
    values = list(touched)
    if scanned is not None:
        missing = _find_missing(standard, scanned.values)
        problem = scanned.problems[0] if scanned.problems else missing
        if scanned.values and missing and not scanned.problems:
            problems.append(missing)
        measured.append(_worst(data, "length-scan", scanned.values, scanned.scans, problem))
        problems += rocking_problems(standard, scanned.values)
        values += scanned.values
    points = tuple(_point(data, one) for one in values)
    notes = () if scanned is None else (_gate_note(data),)
    undecided: tuple[Text, ...] = ()
    if len(standard.lengths) < LENGTHS:
        undecided = (message("performance-fewer-lengths", count=len(standard.lengths)),)
    return Evaluated(tuple(measured), lengths=points, notes=notes, undecided=undecided)


def _worst(
    data: MeasuredData,
    of: Literal["length-touch", "length-scan"],
    values: Sequence[MeasuredLength],
    names: Sequence[str],
    problem: Text,
) -> Measured:
    """The error that is worst against its limit; a problem keeps it from being stated."""
    if not values:
        return Measured(of, None, problem=problem, data=tuple(names))
    summary = summarise_lengths(values, [_limit_um(data, one) for one in values])
    return Measured(
        of,
        summary.worst.error_um,
        tuple(one.error_um for one in values),
        summary.worst.test_uncertainty_um,
        problem,
        tuple(names),
        summary.worst.nominal.length_mm,
    )


def _find_missing(standard: LengthStandardFile, values: Sequence[MeasuredLength]) -> Text:
    """Why there are too few lengths for a figure; empty if all were measured."""
    if not values:
        return message("no-lengths-measured")
    wanted = PLACES * REPEATS * len(standard.lengths)
    if len(values) >= wanted:
        return ""
    return message(
        "lengths-are-missing", count=len(values), wanted=wanted, places=PLACES, repeats=REPEATS
    )


def _gate_note(data: MeasuredData) -> Text:
    """Which points of a scan take part."""
    return message(
        "performance-length-gate",
        shell=quantity(data.plan.gate.shell_mm, "mm", 1),
        incidence=quantity(data.plan.gate.incidence_deg, "°"),
        cone=quantity(BAR_CONE_DEG, "°"),
    )


def _limit_um(data: MeasuredData, one: MeasuredLength) -> float:
    """The maximum permissible error of a length; infinite without one."""
    permissible = data.plan.limit("length-scan" if one.by == "scan" else "length-touch")
    return float("inf") if permissible is None else permissible.at(one.nominal.length_mm)


def _point(data: MeasuredData, one: MeasuredLength) -> LengthPoint:
    limit_um = _limit_um(data, one)
    return LengthPoint(
        by=one.by,
        place=one.place,
        repeat=one.repeat,
        length_mm=one.nominal.length_mm,
        measured_mm=one.measured_mm,
        error_um=one.error_um,
        test_uncertainty_um=K * one.test_uncertainty_um,
        limit_um=limit_um if isfinite(limit_um) else None,
    )


def lengths_by_touch(
    standard: LengthStandardFile,
    tips_mm: Mapping[str, Floats],
    tip_diameter_mm: float,
    artefact: MeanTemperature | None = None,
) -> tuple[list[MeasuredLength], list[str]]:
    """The lengths both of whose ends were touched, and the groups of these touches.

    Args:
        tips_mm: tip centres (N, 3) by the feature of the touches.
        artefact: temperature of the standard; None: taken as 20 °C.

    Raises:
        OperationError: a sphere has too few touches.
    """
    values: list[MeasuredLength] = []
    names: list[str] = []
    for place in range(1, PLACES + 1):
        for repeat in range(1, REPEATS + 1):
            for number in range(1, len(standard.lengths) + 1):
                ends = [length_feature(place, repeat, number, end) for end in (0, 1)]
                if not all(name in tips_mm for name in ends):
                    continue
                a, b = (end_mm(standard, tips_mm[name], tip_diameter_mm) for name in ends)
                length_mm, nominal = length_of_bar_mm(a, b), standard.nominal(number)
                values.append(MeasuredLength(place, repeat, nominal, length_mm, artefact))
                names += ends
    return values, names


def end_mm(standard: LengthStandardFile, tips_mm: Floats, tip_diameter_mm: float) -> Floats:
    """One end (3,): a sphere's centre, or the mean of touches on a face in the same direction.

    Raises:
        OperationError: a sphere has too few touches.
    """
    diameter = standard.sphere_diameter_mm
    if diameter is None or len(tips_mm) == 1:
        return np.asarray(tips_mm.mean(axis=0))
    if len(tips_mm) < LEAST_TOUCHES:
        raise OperationError(
            "too-few-touches",
            message("has-touches", shape="sphere", count=len(tips_mm)),
            message("least-needed", least=LEAST_TOUCHES),
            message("touch-more-places"),
        )
    return sphere_centre(tips_mm, diameter + tip_diameter_mm)


def rocking_problems(
    standard: LengthStandardFile,
    values: Sequence[MeasuredLength],
    tips_mm: Mapping[str, Floats] | None = None,
    tip_diameter_mm: float = 0.0,
    steady_um: float = inf,
) -> list[Text]:
    """Each place in which the repeats scatter far more than the touches, or without these than in
    steady places, or in which the touches do: the standard rocks.

    Args:
        steady_um: scatter of the points of the scanned spheres, which scans do not move; infinite
            without scans.
    """
    touches_um: float | None = None
    reach_mm = ((standard.sphere_diameter_mm or 0.0) + tip_diameter_mm) / 2
    if standard.sphere_diameter_mm is not None and tips_mm is not None:
        touches_um = sphere_touch_scatter_um(tips_mm, reach_mm)
    rocking: list[Text] = [
        message(
            "length-standard-rocks",
            place=one.place,
            scatter=quantity(one.scatter_um, "µm"),
            expected=quantity(one.expected_um, "µm", 1),
            of="places" if touches_um is None else "touches",
        )
        for one in find_rocking_places(values, touches_um)
    ]
    if touches_um is None or tips_mm is None:
        return rocking
    spheres = _spheres_by_place(standard, tips_mm)
    return rocking + loose_bar_problems(spheres, reach_mm, "lengths", steady_um)


def _spheres_by_place(
    standard: LengthStandardFile, tips_mm: Mapping[str, Floats]
) -> dict[int, list[Floats]]:
    """The touches (N, 3) of each sphere of a bar, by the place."""
    found: dict[int, list[Floats]] = {}
    for place in range(1, PLACES + 1):
        features = (
            length_feature(place, repeat, length, end)
            for repeat in range(1, REPEATS + 1)
            for length in range(1, len(standard.lengths) + 1)
            for end in (0, 1)
        )
        found[place] = [tips_mm[name] for name in features if name in tips_mm]
    return found
