"""Dimensions of an inspection: values, uncertainties with their sources, and decisions."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from crenel.messages.limits import beside_limit
from crenel.messages.message import Text, message
from crenel.metrology.decision import Decision, DecisionRule
from crenel.metrology.transforms import Floats, inverse
from crenel.parts.document_program import FORMS, DimensionPart, Means, ProgramFile
from crenel.parts.document_results import DimensionResult, Outcome
from crenel.parts.evaluate_alignment import Aligner
from crenel.parts.evaluate_features import FeatureByMeans
from crenel.parts.evaluate_temperature import UNCOMPENSATED, Compensation
from crenel.parts.maths.dimensions import (
    ORIENTATIONS,
    Dimension,
    FeaturePlace,
    dimension_value,
    measure_dimension,
)
from crenel.parts.maths.form import FormDeviation, form_deviation
from crenel.parts.maths.knowledge import Knowledge
from crenel.parts.maths.limits import (
    decide_between,
    decide_by_probability,
    length_by_chance,
    probability_within,
)
from crenel.parts.maths.point_errors import ScanErrors
from crenel.parts.maths.shapes import Shape

FACTOR_STEP = 1e-6
NEAR_ZERO_SDS = 10.0
"""A length of fewer standard deviations is decided on as a vector."""
OUTCOMES: dict[Decision, Outcome] = {
    "pass": "pass",
    "fail": "fail",
    "uncertain": "undecided",
    "none": "none",
}


@dataclass(frozen=True)
class DimensionContext:
    """What dimensions are computed from."""

    program: ProgramFile
    wanted: Sequence[tuple[str, Means]]
    features: Sequence[FeatureByMeans]
    align: Aligner
    knowledge: Knowledge
    shared: Floats | None
    """None: only the scatter is known, and nothing is decided."""
    rule: DecisionRule
    compensation: Compensation = UNCOMPENSATED


@dataclass(frozen=True)
class MeasuredDimensions:
    results: tuple[DimensionResult, ...]
    correlation: Floats | None
    warnings: tuple[Text, ...]


def measure_dimensions(context: DimensionContext) -> MeasuredDimensions:
    """All dimensions of a program, with their correlation."""
    program, knowledge, compensation = context.program, context.knowledge, context.compensation
    given = [one for one in program.dimensions if one.kind not in FORMS]
    defined = [_define(context, one) for one in given]

    def measure_at(shapes: Sequence[Shape], factor: float) -> list[Floats]:
        T_part_arm = inverse(context.align(shapes))
        moved = [one.move(T_part_arm).scale(factor) for one in shapes]
        return [measure_dimension(one, moved) for one in defined]

    gradients = np.zeros((0, len(knowledge.total)))
    values: list[Floats] = []
    if defined:
        factor = compensation.factor
        values = measure_at(knowledge.shapes, factor)
        gradients = knowledge.gradients(lambda shapes: np.concatenate(measure_at(shapes, factor)))
    if compensation.is_made:
        knowledge = knowledge.with_quantity("temperature", compensation.sd)
        by_factor = np.zeros((len(gradients), 1))
        if defined:
            ahead = np.concatenate(measure_at(knowledge.shapes, compensation.factor + FACTOR_STEP))
            by_factor[:, 0] = (ahead - np.concatenate(values)) / FACTOR_STEP
        gradients = np.hstack([gradients, by_factor])
        context = replace(context, knowledge=knowledge)
    results: dict[str, DimensionResult] = {}
    rows: dict[str, Floats] = {}
    at = 0
    for part, one, value in zip(given, defined, values, strict=True):
        own = gradients[at : at + len(value)]
        at += len(value)
        results[part.id], rows[part.id] = _judge(context, part, one, value, own)
    warnings: list[Text] = []
    for part in program.dimensions:
        if part.kind in FORMS:
            results[part.id] = _form(context, part, warnings)
            rows[part.id] = np.zeros(gradients.shape[1])
    correlation = None
    if context.shared is not None and program.dimensions:
        correlation = _correlate(
            np.array([rows[one.id] for one in program.dimensions]), knowledge.total
        )
    ordered = tuple(results[one.id] for one in program.dimensions)
    return MeasuredDimensions(ordered, correlation, tuple(warnings))


def _define(context: DimensionContext, part: DimensionPart) -> Dimension:
    """A dimension with the numbers of its features."""
    program = context.program

    def place(name: str) -> FeaturePlace:
        number = list(context.wanted).index((name, program.means_of(name)))
        feature = program.feature(name)
        return FeaturePlace(number, feature.shape(), np.array(feature.extent_mm()))

    along: FeaturePlace | Floats | None = None
    if part.along is not None:
        names = [one.id for one in program.features]
        is_axis = part.along in ("x", "y", "z") and part.along not in names
        along = np.eye(3)["xyz".index(part.along)] if is_axis else place(part.along)
    alignment = program.alignment
    reference = part.reference or (None if alignment is None else alignment.primary)
    own = None
    if reference is not None and program.feature(reference).kind == "plane":
        means = program.means_of(reference)
        if part.reference is None:
            means = program.datum_means(reference)
        number = list(context.wanted).index((reference, means))
        own = FeaturePlace(number, program.feature(reference).shape())
    return Dimension(
        part.kind,  # type: ignore[arg-type]
        tuple(place(name) for name in part.features),
        part.nominal,
        along,
        None if part.axis is None else "xyz".index(part.axis),
        own,
        place(part.datums[0]) if part.kind in ORIENTATIONS else None,
    )


def _judge(
    context: DimensionContext,
    part: DimensionPart,
    dimension: Dimension,
    measured: Floats,
    gradients: Floats,
) -> tuple[DimensionResult, Floats]:
    """The result of a dimension, and the derivatives (M,) of its value, mm or degrees."""
    total, rule, scale = context.knowledge.total, context.rule, part.per_unit
    value = dimension_value(dimension, measured)
    direction: Floats = np.ones(1)
    if dimension.is_vector:
        length = float(np.linalg.norm(measured))
        towards = measured / length if length > 0 else np.eye(len(measured))[0]
        direction = np.asarray(dimension.factor * towards)
    gradient: Floats = np.asarray(direction @ gradients)
    u = float(np.sqrt(max(float(gradient @ total @ gradient), 0.0)))
    covariance = gradients @ total @ gradients.T
    lower, upper = (None if one is None else one / scale for one in (part.lower, part.upper))
    nominal = part.nominal / scale
    probability = chance = None
    if context.shared is None:
        decision: Decision = "none" if lower is None and upper is None else "uncertain"
    elif dimension.is_vector and value < NEAR_ZERO_SDS * dimension.factor * _largest_sd(covariance):
        decision, probability = _decide_length(
            dimension.factor, measured, covariance, nominal, (lower, upper), rule
        )
        chance = dimension.factor * length_by_chance(covariance)
    else:
        decision = decide_between(value - nominal, lower, upper, u, rule)
    only_scatter = context.shared is None
    contributions = context.knowledge.contributions(gradient)
    result = DimensionResult(
        id=part.id,
        kind=part.kind,
        features=part.features,
        value=value * scale,
        nominal=part.nominal,
        lower=part.lower,
        upper=part.upper,
        unit=part.unit,
        standard_uncertainty=None if only_scatter else u * scale,
        scatter=u * scale if only_scatter else None,
        decision=OUTCOMES[decision],
        probability=probability,
        vector=tuple(measured.tolist()) if dimension.is_vector else None,
        by_chance=None if chance is None else chance * scale,
        contributions={name: one * scale for name, one in contributions.items()},
    )
    return result, gradient


def _decide_length(
    factor: float,
    vector: Floats,
    covariance: Floats,
    nominal: float,
    limits: tuple[float | None, float | None],
    rule: DecisionRule,
) -> tuple[Decision, float | None]:
    """The decision on the length of a vector, times a factor, that is not far from zero."""
    lower, upper = limits
    if lower is None and upper is None:
        return "none", None
    value = factor * float(np.linalg.norm(vector))
    low = -1.0 if lower is None else (nominal + lower) / factor
    high = np.inf if upper is None else (nominal + upper) / factor
    if rule.guard_factor == 0:
        return ("pass" if low <= value / factor <= high else "fail"), None
    inside = 1.0 if np.isinf(high) else probability_within(high, vector, covariance)
    if low > 0:
        inside -= probability_within(low, vector, covariance)
    return decide_by_probability(inside, rule), inside


def _largest_sd(covariance: Floats) -> float:
    return float(np.sqrt(max(float(np.linalg.eigvalsh(covariance)[-1]), 0.0)))


def _form(context: DimensionContext, part: DimensionPart, warnings: list[Text]) -> DimensionResult:
    """A form deviation by the means of cells."""
    name = part.features[0]
    number = list(context.wanted).index((name, context.program.means_of(name)))
    feature, scale = context.features[number], part.per_unit
    errors = feature.points.errors.select(feature.fitted.used)
    if not isinstance(errors, ScanErrors) or context.shared is None:
        found = FormDeviation(float(np.ptp(feature.fitted.off_mm)), 0.0, 0.0)
        decision: Decision = "none" if part.upper is None else "uncertain"
        only_range = True
    else:
        found, only_range = form_deviation(feature.fitted, errors, context.shared), False
        decision = _decide_form(found, part, context.rule, warnings)
    return DimensionResult(
        id=part.id,
        kind=part.kind,
        features=part.features,
        value=found.zone_mm * scale,
        nominal=part.nominal,
        lower=part.lower,
        upper=part.upper,
        unit=part.unit,
        standard_uncertainty=None if only_range else found.sd_mm * scale,
        decision=OUTCOMES[decision],
        by_chance=None if only_range else found.expected_mm * scale,
        contributions={} if only_range else {"stripe": found.sd_mm * scale},
    )


def _decide_form(
    found: FormDeviation, part: DimensionPart, rule: DecisionRule, warnings: list[Text]
) -> Decision:
    """Noise only widens a zone: it conforms if it does with the noise, and fails without it."""
    if part.upper is None:
        return "none"
    limit = (part.nominal + part.upper) / part.per_unit
    if limit < found.expected_mm:
        noise, least = beside_limit(1e3 * found.expected_mm, 1e3 * limit, "µm", 1)
        warnings.append(
            message(
                "part-form-limit-below-noise",
                dimension=part.id,
                limit=least,
                noise=noise,
            )
        )
        return "uncertain"
    if decide_between(found.zone_mm, None, limit, found.sd_mm, rule) == "pass":
        return "pass"
    without_noise = found.zone_mm - found.expected_mm
    failed = decide_between(without_noise, None, limit, found.sd_mm, rule) == "fail"
    return "fail" if failed else "uncertain"


def _correlate(gradients: Floats, total: Floats) -> Floats:
    """Correlation (K, K) of values with gradients (K, M); the diagonal is 1."""
    C = gradients @ total @ gradients.T
    sd = np.sqrt(np.maximum(np.diag(C), 0.0))
    sd[sd == 0] = 1.0
    found = C / np.outer(sd, sd)
    np.fill_diagonal(found, 1.0)
    return np.asarray(np.clip((found + found.T) / 2, -1.0, 1.0))
