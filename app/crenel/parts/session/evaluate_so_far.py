"""What the touches of an inspection show while it is under way: frame, features, dimensions."""

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np

from crenel.errors import OperationError
from crenel.formats.session.calibration_session import contact_readings
from crenel.messages.message import Text, message, quantity
from crenel.metrology.arm.kinematics import tip_centres, tip_of
from crenel.metrology.decision import DecisionRule
from crenel.metrology.transforms import Floats, apply, inverse, skew
from crenel.parts.document_nominal import LEAST_TOUCHES
from crenel.parts.document_program import ProgramFile, SourcePart
from crenel.parts.document_results import AlignmentResult
from crenel.parts.evaluate import MeasuredPart, decide_dimensions, measure_inspection
from crenel.parts.evaluate_alignment import alignment_result
from crenel.parts.evaluate_features import FAR_MM, face_of
from crenel.parts.evaluate_folder import FolderFiles, Inspection, StationKnowledge
from crenel.parts.maths.assignment import BAND_MM, Face
from crenel.parts.session.evaluate_found import FoundSoFar, FrameKnowledge

SAME_PLACE_MM = 0.3


@dataclass(frozen=True)
class TouchedSoFar:
    """All touches that count, in their order."""

    features: tuple[str, ...]
    readings: Floats
    """(N, k) of the arm."""

    def has(self, program: ProgramFile, name: str) -> bool:
        """Whether a feature has its least touches."""
        return Counter(self.features)[name] >= LEAST_TOUCHES[program.feature(name).kind]


@dataclass(frozen=True)
class PartKnowledge:
    """Program, files and station of an inspection, as its folder has them."""

    files: FolderFiles
    program: ProgramFile
    station: StationKnowledge
    rule: DecisionRule

    @property
    def datums(self) -> tuple[str, ...]:
        """The features that the part frame needs."""
        alignment = self.program.alignment
        return () if alignment is None else alignment.used


def find_so_far(part: PartKnowledge, touched: TouchedSoFar, wanted: Iterable[str]) -> FoundSoFar:
    """The frame, and the dimensions of ``wanted`` features as far as they can be stated."""
    program = part.program
    if not touched.features:
        return FoundSoFar()
    if not all(touched.has(program, name) for name in part.datums):
        return FoundSoFar(residuals_um=_residuals_of_planes(part, touched))
    reduced = _reduce(program, part.datums, set(wanted), touched)
    if reduced is None:
        return FoundSoFar()
    contacts = contact_readings(touched.features, part.station.arm, touched.readings)
    try:
        found = measure_inspection(Inspection(part.files, reduced, part.station, contacts), [])
        results = decide_dimensions(found, part.rule).results
        aligned = alignment_result(
            program, found.T_arm_part, found.align, found.knowledge, found.is_full
        )
    except OperationError as refusal:
        residuals = _residuals_of_planes(part, touched)
        return FoundSoFar(residuals_um=residuals, refusal=refusal)
    return FoundSoFar(
        _frame_knowledge(part, found.T_arm_part, aligned),
        found.is_full,
        {one.id: one for one in results},
        _residuals(found, touched),
    )


def _reduce(
    program: ProgramFile, datums: Sequence[str], wanted: set[str], touched: TouchedSoFar
) -> ProgramFile | None:
    """The program of the datums and the wanted features alone, with the dimensions of the latter
    whose other features are touched, too."""
    ready = {one.id for one in program.features if touched.has(program, one.id)}
    names, dimensions = {one.id for one in program.features}, []
    needed = {*datums, *(wanted & ready)}
    for one in program.dimensions:
        others = set(one.needed) & names
        if wanted & set(one.features) and others <= ready:
            dimensions.append(one)
            needed |= others
    features = tuple(one for one in program.features if one.id in needed)
    if not features:
        return None
    alignment = program.alignment
    if alignment is not None:
        alignment = alignment.model_copy(update={"by": "touch"})
    return program.model_copy(
        update={
            "features": features,
            "dimensions": tuple(dimensions),
            "alignment": alignment,
            "source": SourcePart(default="touch"),
        }
    )


def _frame_knowledge(
    part: PartKnowledge, T_arm_part: Floats, aligned: AlignmentResult
) -> FrameKnowledge:
    return FrameKnowledge(T_arm_part, *frame_uncertainty(part.program, aligned))


def frame_uncertainty(
    program: ProgramFile, aligned: AlignmentResult
) -> tuple[float | None, float | None]:
    """What a part frame is known to at the worst of the datums and at the furthest corner of the
    nominal features, µm, k = 1; None where only scatter is known."""
    known = {one.feature: one.u_um for one in aligned.known_at}
    if aligned.covariance is None or program.alignment is None:
        return None, None
    C, pivot = np.array(aligned.covariance), np.array(aligned.pivot_mm)
    far = 0.0
    for corner in _corners(program):
        J = np.hstack([-skew(corner - pivot), np.eye(3)])
        far = max(far, 1e3 * float(np.sqrt(max(np.trace(J @ C @ J.T), 0.0))))
    return max(known[name] for name in program.alignment.used), far


def _corners(program: ProgramFile) -> Floats:
    """(8, 3) of the box about all nominal points and regions."""
    points = [one.nominal.point_mm for one in program.features]
    boxes = [one.region.boxes_mm for one in program.features if one.region is not None]
    points += [corner for each in boxes for box in each for corner in box]
    return np.array(list(product(*zip(np.min(points, 0), np.max(points, 0), strict=True))))


def _residuals(found: MeasuredPart, touched: TouchedSoFar) -> dict[int, float]:
    arm = found.inspection.station.arm
    centres = tip_centres(arm, touched.readings)
    residuals: dict[int, float] = {}
    for one in found.features:
        face = face_of(one.part)
        rows = [k for k, name in enumerate(touched.features) if name == one.part.id]
        off = one.fitted.shape.distances(centres[rows]) - face.side * tip_of(arm).radius_mm
        residuals.update(zip(rows, (1e3 * off).tolist(), strict=True))
    return residuals


def _residuals_of_planes(part: PartKnowledge, touched: TouchedSoFar) -> dict[int, float]:
    """Before the frame is known: off the plane through the touches of each plane."""
    centres = tip_centres(part.station.arm, touched.readings)
    residuals: dict[int, float] = {}
    for name in dict.fromkeys(touched.features):
        if part.program.feature(name).kind != "plane" or not touched.has(part.program, name):
            continue
        rows = [k for k, one in enumerate(touched.features) if one == name]
        x = centres[rows] - centres[rows].mean(axis=0)
        off = x @ np.linalg.svd(x)[2][-1]
        residuals.update(zip(rows, (1e3 * off).tolist(), strict=True))
    return residuals


def refuse_touch(
    part: PartKnowledge,
    touched: TouchedSoFar,
    frame: FrameKnowledge | None,
    name: str,
    reading: Floats,
) -> None:
    """Refuses a new touch that cannot be of a feature, or is where one was.

    Raises:
        OperationError: it is named what the touch is instead.
    """
    arm = part.station.arm
    centre = tip_centres(arm, reading[None])[0]
    rows = [k for k, one in enumerate(touched.features) if one == name]
    if rows:
        apart = np.linalg.norm(tip_centres(arm, touched.readings[rows]) - centre, axis=1)
        if apart.min() < SAME_PLACE_MM:
            number = int(np.argmin(apart)) + 1
            raise _not_taken(message("part-touch-is-at-place", feature=name, number=number))
    if frame is None:
        return
    at, radius = apply(inverse(frame.T_arm_part), centre[None]), tip_of(arm).radius_mm
    face = face_of(part.program.feature(name))
    off = float(face.shape.distances(at)[0])
    if abs(off - face.side * radius) <= FAR_MM:
        return
    if abs(off + face.side * radius) <= FAR_MM:
        raise _not_taken(message("part-touch-is-on-wrong-side", feature=name))
    away = quantity(abs(off - face.side * radius), "mm", 2)
    if other := _feature_at(part.program, name, at, radius):
        text = message("part-touch-is-on-other", feature=name, other=other, away=away)
        raise _not_taken(text)
    raise _not_taken(message("part-touch-is-far-off", feature=name, away=away))


def _not_taken(why: Text) -> OperationError:
    return OperationError("not-of-feature", why, remedy=message("part-touch-feature-named"))


def _feature_at(program: ProgramFile, name: str, at: Floats, radius_mm: float) -> str:
    for one in program.features:
        face: Face = face_of(one)
        off = float(face.shape.distances(at)[0]) - face.side * radius_mm
        along = bool(face.is_along(face.shape.local(at), -radius_mm)[0])
        near = bool(_within_reach(face, at, radius_mm))
        if one.id != name and abs(off) < BAND_MM / 2 and along and near:
            return one.id
    return ""


def _within_reach(face: Face, at: Floats, radius_mm: float) -> bool:
    """Whether a tip (1, 3) is by one of the boxes of a face, if it has any."""
    grown = [box + radius_mm * np.array([[-1.0], [1.0]]) for box in face.boxes_mm]
    return not grown or any(bool(((at >= a) & (at <= b)).all()) for a, b in grown)
