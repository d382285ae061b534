"""Inspection of a part: from a folder to results, with what each figure is known to."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from crenel.formats.json_document import SOFTWARE
from crenel.formats.results.decision_rule import RulePart
from crenel.messages.message import Text, message, quantity
from crenel.metrology.decision import GUARDED_95, DecisionRule
from crenel.metrology.transforms import Floats, inverse
from crenel.parts.document_program import Means
from crenel.parts.document_results import (
    AlignmentFile,
    DimensionResult,
    FeatureResult,
    InspectionFile,
)
from crenel.parts.evaluate_alignment import (
    Aligner,
    aligner,
    alignment_result,
    find_part,
    tip_radius,
)
from crenel.parts.evaluate_dimensions import (
    DimensionContext,
    MeasuredDimensions,
    measure_dimensions,
)
from crenel.parts.evaluate_features import (
    FeatureByMeans,
    MeasuredPoints,
    gather_points,
    measure_features,
)
from crenel.parts.evaluate_folder import FolderFiles, Inspection, read_inspection
from crenel.parts.evaluate_overlap import find_slips
from crenel.parts.evaluate_points import ScanData, read_scan
from crenel.parts.evaluate_temperature import (
    UNCOMPENSATED,
    Compensation,
    PartTemperature,
    find_compensation,
)
from crenel.parts.maths.knowledge import Knowledge, MeasuredFeature, join_features
from crenel.parts.maths.shapes import Shape
from crenel.progress import Progress, no_progress

MEANS_SDS = 2.58
"""Tip and stripe disagree if they are further apart, in standard uncertainties: 1 of 100."""


@dataclass(frozen=True)
class MeasuredPart:
    """The features of a part, and where it lies."""

    inspection: Inspection
    data: MeasuredPoints
    wanted: tuple[tuple[str, Means], ...]
    features: list[FeatureByMeans]
    T_arm_part: Floats
    align: Aligner
    knowledge: Knowledge
    slips: tuple[Text, ...] = ()
    """What shows that the part moved while it was measured: then nothing is decided."""

    @property
    def is_full(self) -> bool:
        """Whether uncertainties are known, and not only scatter."""
        return self.inspection.station.shared is not None

    @property
    def warnings(self) -> tuple[Text, ...]:
        own = [text for one in self.features for text in one.warnings]
        return (*self.slips, *self.inspection.station.warnings, *self.data.warnings, *own)


def inspect_part(
    files: FolderFiles,
    rule: DecisionRule = GUARDED_95,
    progress: Progress = no_progress,
    temperature: PartTemperature | None = None,
) -> InspectionFile:
    """Measures and judges a part.

    Raises:
        OperationError: a file is missing or wrong, or a feature cannot be measured.
    """
    return judge_part(measure_part(files, progress), rule, temperature)


def judge_part(
    found: MeasuredPart,
    rule: DecisionRule = GUARDED_95,
    temperature: PartTemperature | None = None,
) -> InspectionFile:
    """Dimensions and decisions of a part whose features were measured.

    Args:
        temperature: of the part; None: lengths are those at the temperature that it had.

    Raises:
        OperationError: the temperature is impossible, or the program states no expansion.
    """
    program, station = found.inspection.program, found.inspection.station
    files = found.inspection.files
    compensation = find_compensation(program, temperature)
    dimensions = decide_dimensions(found, rule, compensation)
    whole = found.inspection.whole or program
    skipped = [
        message("part-feature-skipped", feature=one.feature, reason=one.reason)
        for one in whole.skipped
    ]
    warnings = [*skipped, *found.warnings, *dimensions.warnings, *_means_disagree(found)]
    if compensation.text:
        warnings.append(compensation.text)
    return InspectionFile(
        program=program.name,
        part=program.part.name,
        drawing=program.part.drawing,
        serial_number=program.part.serial_number,
        measured_at=files.start_moment(),
        temperature_c=None if temperature is None else temperature.value_c,
        inputs=files.inputs(),
        uncertainty="full" if found.is_full else "scatter",
        correlation_unknown=station.correlation_unknown,
        alignment=None
        if program.alignment is None
        else alignment_result(
            program, found.T_arm_part, found.align, found.knowledge, found.is_full
        ),
        features=tuple(
            _feature_result(found, number, one) for number, one in enumerate(found.features)
        ),
        dimensions=_without_decisions(dimensions.results) if found.slips else dimensions.results,
        not_measured=whole.not_measured,
        correlation=None
        if dimensions.correlation is None
        else tuple(map(tuple, dimensions.correlation.round(9).tolist())),
        rule=RulePart.of(rule),
        warnings=tuple(warnings),
        software=SOFTWARE,
    )


def _without_decisions(results: tuple[DimensionResult, ...]) -> tuple[DimensionResult, ...]:
    """Dimensions of a part that moved: what has limits stays undecided."""
    return tuple(
        one
        if one.decision == "none"
        else one.model_copy(update={"decision": "undecided", "probability": None})
        for one in results
    )


def decide_dimensions(
    found: MeasuredPart, rule: DecisionRule, compensation: Compensation = UNCOMPENSATED
) -> MeasuredDimensions:
    """The dimensions of a part whose features were measured."""
    return measure_dimensions(
        DimensionContext(
            found.inspection.program,
            found.wanted,
            found.features,
            found.align,
            found.knowledge,
            found.inspection.station.shared,
            rule,
            compensation,
        )
    )


def align_part(files: FolderFiles, progress: Progress = no_progress) -> AlignmentFile:
    """The part frame alone, with what it is known to at each feature."""
    found = measure_part(files, progress, only_datums=True)
    program = found.inspection.program
    return AlignmentFile(
        program=program.name,
        inputs=files.inputs(),
        alignment=alignment_result(
            program, found.T_arm_part, found.align, found.knowledge, found.is_full
        ),
        warnings=found.warnings,
        software=SOFTWARE,
    )


def measure_part(
    files: FolderFiles, progress: Progress = no_progress, only_datums: bool = False
) -> MeasuredPart:
    """Finds a part by its files, and fits its features."""
    inspection = read_inspection(files)
    station = inspection.station
    scans: list[ScanData] = []
    for number, path in enumerate(files.scans):

        def report(share: float, text: Text, done: int = number) -> None:
            progress((done + share) / (len(files.scans) + 1), text)

        scans.append(read_scan(path, station, report))
    return measure_inspection(inspection, scans, only_datums)


def measure_inspection(
    inspection: Inspection, scans: list[ScanData], only_datums: bool = False
) -> MeasuredPart:
    """Finds a part by what was read of it, and fits its features."""
    program, station = inspection.program, inspection.station
    wanted = program.list_wanted()
    if only_datums and program.alignment is not None:
        names = program.alignment.used
        wanted = tuple(dict.fromkeys((name, program.datum_means(name)) for name in names))
    data = gather_points(inspection, scans)
    T = find_part(data, station)
    features = measure_features(data, wanted, T, tip_radius(station, data))
    align = aligner(program, wanted, T)
    T = align([one.fitted.shape for one in features])
    knowledge = _join(features, station.shared)
    slips: list[Text] = []
    if station.shared is not None:
        frames = [len(one.errors.motion.T_arm_flange) for one in scans]
        radius = tip_radius(station, data)
        slips = find_slips(data, features, frames, T, radius, station.shared)
    return MeasuredPart(inspection, data, wanted, features, T, align, knowledge, tuple(slips))


def _join(features: Sequence[FeatureByMeans], shared: Floats | None) -> Knowledge:
    if shared is not None:
        measured = [
            MeasuredFeature(one.fitted, one.source, one.means == "touch") for one in features
        ]
        return join_features(measured, shared)
    counts = [one.fitted.shape.freedom.count for one in features]
    ends = np.cumsum([0, *counts])
    total = np.zeros((ends[-1], ends[-1]))
    for one, start, end in zip(features, ends[:-1], ends[1:], strict=True):
        scatter = one.fitted.scatter
        total[start:end, start:end] = one.fitted.own if scatter is None else scatter
    return Knowledge(tuple(one.fitted.shape for one in features), {"scatter": total})


def _feature_result(found: MeasuredPart, number: int, one: FeatureByMeans) -> FeatureResult:
    fitted = one.fitted
    shape = fitted.shape.move(inverse(found.T_arm_part))
    covariance = found.knowledge.block(number)
    return FeatureResult(
        id=one.part.id,
        kind=one.part.kind,
        source=one.means,
        parameters=_parameters(shape, one.part.shape()),
        nominal=_parameters(one.part.shape(), one.part.shape()),
        internal=one.part.is_internal,
        free=shape.freedom.names,
        covariance=tuple(map(tuple, ((covariance + covariance.T) / 2).tolist()))
        if found.is_full
        else None,
        points=fitted.points,
        used=len(fitted.used),
        frames=len(fitted.sums.frames),
        cells=int(fitted.cell.max()) + 1,
        rms_um=1e3 * fitted.rms_mm,
        form_um=1e3 * fitted.form_mm,
        excluded=one.excluded,
    )


def _parameters(shape: Shape, nominal: Shape) -> dict[str, float | tuple[float, float, float]]:
    """A feature in the words of a program's nominals."""

    def vector(values: Floats) -> tuple[float, float, float]:
        x, y, z = values.tolist()
        return x, y, z

    facing = 1.0 if float(shape.direction @ nominal.direction) >= 0 else -1.0
    found: dict[str, float | tuple[float, float, float]] = {"point_mm": vector(shape.origin_mm)}
    direction = vector(facing * shape.direction)
    if shape.kind == "plane":
        found["normal"] = direction
    elif shape.kind == "circle":
        found["normal"] = direction
        found["diameter_mm"] = 2 * float(shape.sizes[0])
    elif shape.kind == "slot":
        found["direction"], found["normal"] = vector(shape.T[:3, 0]), direction
        found["width_mm"] = 2 * float(shape.sizes[0])
        found["length_mm"] = 2 * float(shape.sizes.sum())
    elif shape.kind == "cone":
        found["direction"] = direction
        apex = shape.origin_mm - shape.direction * float(shape.sizes[0] / np.tan(shape.sizes[1]))
        found["point_mm"] = vector(apex)
        found["half_angle_deg"] = float(np.degrees(shape.sizes[1]))
    else:
        found["diameter_mm"] = 2 * float(shape.sizes[0])
        if shape.kind != "sphere":
            found["direction"] = direction
        if shape.kind == "torus":
            found["tube_diameter_mm"] = 2 * float(shape.sizes[1])
    return found


def _means_disagree(found: MeasuredPart) -> list[Text]:
    """Features whose sizes by tip and by stripe differ by more than chance explains."""
    if not found.is_full:
        return []
    texts: list[Text] = []
    for name in found.inspection.program.source.both:
        pair = [list(found.wanted).index((name, means)) for means in ("scan", "touch")]
        first, second = (found.knowledge.shapes[k] for k in pair)
        if not len(first.sizes):
            continue

        def difference(shapes: Sequence[Shape], pair: list[int] = pair) -> Floats:
            return np.array([float(shapes[pair[0]].sizes[0] - shapes[pair[1]].sizes[0])])

        row = found.knowledge.gradients(difference)[0]
        u = float(np.sqrt(max(row @ found.knowledge.total @ row, 0.0)))
        off = float(first.sizes[0] - second.sizes[0])
        if abs(off) > MEANS_SDS * u:
            texts.append(
                message(
                    "part-means-disagree",
                    feature=name,
                    off=quantity(2e3 * off, "µm", 1),
                    u=quantity(2e3 * u, "µm", 1),
                )
            )
    return texts
