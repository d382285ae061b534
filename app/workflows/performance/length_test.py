"""Errors of length by touch or scan: ball bars and step gauges in seven places."""

from collections.abc import Mapping, Sequence

import numpy as np

from app.errors import OperationError
from app.formats.datasheets.length_standard import LengthStandardFile
from app.formats.performance.plan import PerformancePlan, length_feature
from app.formats.performance.symbols import Quantity
from app.messages.message import Text, message, quantity
from app.metrology.arm.kinematics import tip_of
from app.metrology.performance.length_scatter import (
    find_rocking_places,
    sphere_touch_scatter_um,
)
from app.metrology.performance.lengths import (
    PLACES,
    REPEATS,
    CalibratedLength,
    MeasuredLength,
    length_of_bar_mm,
    summarise_lengths,
)
from app.metrology.performance.sphere import sphere_centre
from app.metrology.transforms import Floats
from app.workflows.performance.judge import K, Measured
from app.workflows.performance.measured_data import MeasuredData

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


def measure_lengths(
    data: MeasuredData,
) -> tuple[list[Measured], list[dict[str, object]], list[Text]]:
    """The worst error of length by touch, every single one, and why none is stated."""
    standard = data.plan.length
    assert standard is not None, "a plan of this kind has lengths"
    tip_mm = tip_of(data.arm).diameter_mm
    values, names = lengths_by_touch(
        standard, data.tips_mm, tip_mm, data.plan.artefact_c, data.plan.temperature_sd_c
    )
    of: Quantity = "length-touch"
    if not values:
        return [Measured(of, None, problem=message("no-lengths-measured"))], [], []
    permissible = data.plan.limit(of)
    limits = [
        np.inf if permissible is None else permissible.at(one.nominal.length_mm) for one in values
    ]
    summary = summarise_lengths(values, limits)
    measured = Measured(
        of,
        summary.worst.error_um,
        tuple(one.error_um for one in values),
        summary.worst.test_uncertainty_um,
        data=tuple(names),
        length_mm=summary.worst.nominal.length_mm,
    )
    points: list[dict[str, object]] = [
        {
            "place": one.place,
            "repeat": one.repeat,
            "length_mm": one.nominal.length_mm,
            "measured_mm": one.measured_mm,
            "error_um": one.error_um,
            "test_uncertainty_um": K * one.test_uncertainty_um,
            "limit_um": None if not np.isfinite(limit) else limit,
        }
        for one, limit in zip(values, limits, strict=True)
    ]
    return [measured], points, rocking_problems(standard, values, data.tips_mm, tip_mm)


def lengths_by_touch(
    standard: LengthStandardFile,
    tips_mm: Mapping[str, Floats],
    tip_diameter_mm: float,
    artefact_c: float | None = None,
    temperature_sd_c: float = 0.0,
) -> tuple[list[MeasuredLength], list[str]]:
    """The lengths both of whose ends were touched, and the groups of these touches.

    Args:
        tips_mm: tip centres (N, 3) by the feature of the touches.
        artefact_c: temperature of the standard; None: taken as 20 °C.

    Raises:
        OperationError: a sphere has too few touches.
    """
    values: list[MeasuredLength] = []
    names: list[str] = []
    for place in range(1, PLACES + 1):
        for repeat in range(1, REPEATS + 1):
            for number, part in enumerate(standard.lengths, 1):
                ends = [length_feature(place, repeat, number, end) for end in (0, 1)]
                if not all(name in tips_mm for name in ends):
                    continue
                a, b = (end_mm(standard, tips_mm[name], tip_diameter_mm) for name in ends)
                nominal = CalibratedLength(
                    part.length_mm,
                    part.standard_uncertainty_um,
                    standard.expansion_per_c,
                    standard.expansion_sd_per_c,
                )
                length_mm = length_of_bar_mm(a, b)
                values.append(
                    MeasuredLength(place, repeat, nominal, length_mm, artefact_c, temperature_sd_c)
                )
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
    tips_mm: Mapping[str, Floats],
    tip_diameter_mm: float,
) -> list[Text]:
    """Each place in which the repeats scatter far more than the touches: the standard rocks."""
    touches_um: float | None = None
    if standard.sphere_diameter_mm is not None:
        reach_mm = (standard.sphere_diameter_mm + tip_diameter_mm) / 2
        touches_um = sphere_touch_scatter_um(tips_mm, reach_mm)
    return [
        message(
            "length-standard-rocks",
            place=one.place,
            scatter=quantity(one.scatter_um, "µm"),
            touches=quantity(one.expected_um, "µm", 1),
        )
        for one in find_rocking_places(values, touches_um)
    ]
