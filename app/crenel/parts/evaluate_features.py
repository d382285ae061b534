"""Features of a program by its scans and touches: assigned, fitted, and counted."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.formats.session.calibration_session import ContactReadings
from crenel.messages.message import Text, message, quantity
from crenel.metrology.transforms import Floats, apply, inverse
from crenel.parts.document_nominal import LEAST_TOUCHES, FeaturePart
from crenel.parts.document_program import Means, ProgramFile
from crenel.parts.document_results import ExclusionPart, ExclusionRule
from crenel.parts.evaluate_folder import Inspection
from crenel.parts.evaluate_points import ScanData, merge_scans, select_touches
from crenel.parts.maths.assignment import BAND_MM, Face, assign_points
from crenel.parts.maths.feature_fit import FeaturePoints, FittedFeature, fit_feature, fit_shape
from crenel.parts.maths.point_errors import ScanErrors, TouchErrors
from crenel.parts.maths.rough_alignment import TouchedFace
from crenel.parts.maths.shapes import Shape

LEAST_POINTS = 20
FAR_MM = 1.0
"""A touch so far from where its feature should be is not of it."""
SAME_PLACE_SHARE = 0.02
"""Touches that lie within this share of a feature's size are at one place."""


@dataclass(frozen=True)
class TakenPoints:
    """The points of one feature by one of the means, and where it should be."""

    part: FeaturePart
    means: Means
    start: Shape
    points: FeaturePoints
    source: int
    excluded: tuple[ExclusionPart, ...]
    warnings: tuple[Text, ...] = ()

    @property
    def given(self) -> tuple[str, Shape, FeaturePoints]:
        """What a fit is given."""
        return self.part.id, self.start, self.points


@dataclass(frozen=True)
class FeatureByMeans:
    """One feature as one of the means found it."""

    part: FeaturePart
    means: Means
    points: FeaturePoints
    fitted: FittedFeature
    source: int
    excluded: tuple[ExclusionPart, ...]
    warnings: tuple[Text, ...] = ()

    @classmethod
    def of(cls, taken: TakenPoints, fitted: FittedFeature) -> "FeatureByMeans":
        """A feature fitted to its points."""
        excluded = taken.excluded
        if fitted.outliers:
            excluded = (*excluded, ExclusionPart(rule="outlier", count=fitted.outliers))
        return cls(
            taken.part, taken.means, taken.points, fitted, taken.source, excluded, taken.warnings
        )


@dataclass
class MeasuredPoints:
    """All points of an inspection, gathered once."""

    program: ProgramFile
    faces: dict[str, Face]
    scan: ScanErrors | None
    sights: Floats | None
    touched: dict[str, tuple[TouchErrors, NDArray[np.int64]]]
    """Touches by feature, with their lines in the file."""
    touches_name: str = ""
    warnings: list[Text] = field(default_factory=list)


def gather_points(inspection: Inspection, scans: list[ScanData]) -> MeasuredPoints:
    """Points and touches of all features."""
    program = inspection.program
    faces = {one.id: face_of(one) for one in program.features}
    scan, sights = merge_scans(scans) if scans else (None, None)
    touched: dict[str, tuple[TouchErrors, NDArray[np.int64]]] = {}
    contacts: ContactReadings | None = inspection.touches
    for one in program.features:
        if contacts is not None and one.id in contacts.features:
            errors, rows = select_touches(contacts, one.id, inspection.station, faces[one.id].side)
            touched[one.id] = errors, rows + 2
    touches = inspection.files.touches
    return MeasuredPoints(
        program,
        faces,
        scan,
        sights,
        touched,
        "" if touches is None else inspection.files.name_of(touches),
        [text for one in scans for text in one.warnings],
    )


def face_of(part: FeaturePart) -> Face:
    """The nominal piece of surface of a feature."""
    boxes = () if part.region is None else tuple(np.array(box) for box in part.region.boxes_mm)
    return Face(part.shape(), part.is_internal, part.along_mm, boxes)


def faces_with_touches(data: MeasuredPoints, tip_radius_mm: float) -> list[TouchedFace]:
    """The touches of all features, for a rough alignment."""
    return [
        TouchedFace(data.faces[name], errors.points_mm, data.faces[name].side * tip_radius_mm)
        for name, (errors, _) in data.touched.items()
    ]


def measure_features(
    data: MeasuredPoints,
    wanted: Sequence[tuple[str, Means]],
    T_arm_part: Floats,
    tip_radius_mm: float,
) -> list[FeatureByMeans]:
    """Fits features, each by its means, where the part lies at ``T_arm_part`` (4, 4).

    Raises:
        OperationError: a feature without points, or that its points do not determine.
    """
    cell_mm = data.program.map.radius_mm
    return [
        FeatureByMeans.of(one, fit_feature(*one.given, cell_mm, one.part.form_allowance_mm))
        for one in take_points(data, wanted, T_arm_part, tip_radius_mm)
    ]


def place_features(
    data: MeasuredPoints,
    wanted: Sequence[tuple[str, Means]],
    T_arm_part: Floats,
    tip_radius_mm: float,
) -> list[Shape]:
    """The features alone, as ``measure_features`` fits them."""
    cell_mm = data.program.map.radius_mm
    return [
        fit_shape(*one.given, cell_mm, one.part.form_allowance_mm).shape
        for one in take_points(data, wanted, T_arm_part, tip_radius_mm)
    ]


def take_points(
    data: MeasuredPoints,
    wanted: Sequence[tuple[str, Means]],
    T_arm_part: Floats,
    tip_radius_mm: float,
) -> Iterator[TakenPoints]:
    """The points of features, each by its means, and what was left out of them."""
    T_part_arm = inverse(T_arm_part)
    in_part = sights = None
    scanned = any(means == "scan" for _, means in wanted)
    if scanned and data.scan is not None and data.sights is not None:
        # each axis in one piece, which boxes are compared with
        in_part = np.asfortranarray(apply(T_part_arm, data.scan.points_mm))
        sights = data.sights @ T_part_arm[:3, :3].T
    for number, (name, means) in enumerate(wanted):
        if means == "scan":
            assert in_part is not None
            assert sights is not None
            yield _by_scan(data, name, T_arm_part, in_part, sights)
        else:
            yield _by_touch(data, name, T_arm_part, tip_radius_mm, number + 1)


def _by_scan(
    data: MeasuredPoints, name: str, T_arm_part: Floats, in_part: Floats, sights: Floats
) -> TakenPoints:
    part, face = data.program.feature(name), data.faces[name]
    others = [one for other, one in data.faces.items() if other != name]
    assert data.scan is not None
    taken = assign_points(face, others, in_part, sights)
    if len(taken.kept) < LEAST_POINTS:
        raise OperationError(
            "feature-without-points",
            message("part-feature-has-points", feature=name, count=len(taken.kept)),
            message("part-scan-does-not-show-it"),
            message("part-scan-feature-or-check-alignment"),
        )
    errors = data.scan.select(taken.kept)
    points = FeaturePoints(errors, np.zeros(len(taken.kept)))
    excluded = _exclusions((("edge", taken.edge), ("incidence", taken.incidence)))
    warnings = (message("part-feature-seen-flat", feature=name),) if taken.steep else ()
    start = face.shape.move(T_arm_part)
    return TakenPoints(part, "scan", start, points, 0, excluded, warnings)


def _by_touch(
    data: MeasuredPoints, name: str, T_arm_part: Floats, tip_radius_mm: float, source: int
) -> TakenPoints:
    part, face = data.program.feature(name), data.faces[name]
    least = LEAST_TOUCHES[part.kind]
    if name not in data.touched:
        raise _too_few(data, name, 0, least)
    errors = data.touched[name][0]
    kept, excluded, warnings = _judge_touches(data, name, T_arm_part, tip_radius_mm)
    if len(kept) < least:
        raise _too_few(data, name, len(kept), least, warnings)
    errors = errors.select(kept)
    _refuse_one_place(data, name, errors.points_mm)
    points = FeaturePoints(errors, np.full(len(kept), face.side * tip_radius_mm))
    start = face.shape.move(T_arm_part)
    return TakenPoints(part, "touch", start, points, source, excluded, tuple(warnings))


def _judge_touches(
    data: MeasuredPoints, name: str, T_arm_part: Floats, tip_radius_mm: float
) -> tuple[NDArray[np.int64], tuple[ExclusionPart, ...], list[Text]]:
    """The touches that can be of a feature, and what is wrong with the others."""
    errors, lines = data.touched[name]
    x = apply(inverse(T_arm_part), errors.points_mm)
    face = data.faces[name]
    off = face.shape.distances(x)
    allowed = FAR_MM
    wrong_side = np.abs(off + face.side * tip_radius_mm) <= allowed
    good = np.abs(off - face.side * tip_radius_mm) <= allowed
    wrong_side &= ~good
    warnings: list[Text] = []
    counts: dict[ExclusionRule, int] = {"wrong-side": 0, "other-feature": 0}
    for k in np.flatnonzero(~good):
        place = message("row-place", path=data.touches_name, line=int(lines[k]))
        if wrong_side[k]:
            counts["wrong-side"] += 1
            warnings.append(message("part-touch-on-wrong-side", place=place, feature=name))
            continue
        counts["other-feature"] += 1
        other = _feature_at(data, name, x[k], tip_radius_mm)
        away = quantity(abs(float(off[k]) - face.side * tip_radius_mm), "mm", 2)
        warnings.append(
            message("part-touch-on-other", place=place, feature=name, other=other, away=away)
            if other
            else message("part-touch-far-off", place=place, feature=name, away=away)
        )
    return np.flatnonzero(good), _exclusions(counts.items()), warnings


def _exclusions(counts: Iterable[tuple[ExclusionRule, int]]) -> tuple[ExclusionPart, ...]:
    """Those that left something out."""
    return tuple(ExclusionPart(rule=rule, count=count) for rule, count in counts if count)


def _feature_at(data: MeasuredPoints, name: str, x: Floats, tip_radius_mm: float) -> str:
    """The id of another feature that a tip at a place (3,) touches; empty if there is none."""
    for other, face in data.faces.items():
        off = float(face.shape.distances(x[None])[0]) - face.side * tip_radius_mm
        along = bool(face.is_along(face.shape.local(x[None]), -tip_radius_mm)[0])
        if other != name and abs(off) < BAND_MM / 2 and along:
            return other
    return ""


def _refuse_one_place(data: MeasuredPoints, name: str, centres_mm: Floats) -> None:
    """Refuses touches that all are at one place of a feature."""
    extent = float(np.ptp(centres_mm, axis=0).max())
    if extent < SAME_PLACE_SHARE * _size(data, name):
        raise OperationError(
            "touches-at-one-place",
            message("part-touches-at-one-place", feature=name, count=len(centres_mm)),
            message("part-touches-extent", extent=quantity(extent, "mm", 2)),
            message("part-spread-touches"),
        )


def _size(data: MeasuredPoints, name: str) -> float:
    face = data.faces[name]
    if face.boxes_mm:
        return float(max(np.linalg.norm(box[1] - box[0]) for box in face.boxes_mm))
    if len(face.shape.sizes):
        return 2 * float(face.shape.sizes[0]) or 10.0
    return 10.0


def _too_few(
    data: MeasuredPoints, name: str, count: int, least: int, warnings: Sequence[Text] = ()
) -> OperationError:
    return OperationError(
        "too-few-touches",
        message(
            "part-too-few-touches",
            file=data.touches_name,
            feature=name,
            count=count,
            least=least,
        ),
        warnings[0] if warnings else "",
        message("part-touch-it-more", least=least),
    )
