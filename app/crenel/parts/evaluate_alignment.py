"""The part frame of an inspection, from its datums, and where it is known to how much."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np

from crenel.errors import OperationError
from crenel.formats.json_document import Vector3
from crenel.messages.message import message, quantity
from crenel.metrology.arm.kinematics import tip_of
from crenel.metrology.transforms import Floats, inverse, skew, vector_from_rotation
from crenel.parts.document_program import Means, ProgramFile
from crenel.parts.document_results import AlignmentResult, PlaceResult
from crenel.parts.evaluate_features import MeasuredPoints, faces_with_touches, place_features
from crenel.parts.evaluate_folder import StationKnowledge
from crenel.parts.maths.datums import Datum, align_datums
from crenel.parts.maths.knowledge import Knowledge
from crenel.parts.maths.rough_alignment import align_to_scan, align_to_touches
from crenel.parts.maths.shapes import Shape

ROUNDS = 4
SETTLED_MM = 1e-3
WORST_TOUCHES_MM, WORST_SCAN_MM = 2.0, 1.0
"""Touches or a scan that lie further off the nominal part are not of it."""

Aligner = Callable[[Sequence[Shape]], Floats]
"""``T_arm_part`` (4, 4) by all features, in the order of an inspection."""


@dataclass(frozen=True)
class FoundPart:
    """Where the part lies, and how its frame follows from features."""

    T_arm_part: Floats
    align: Aligner


def tip_radius(station: StationKnowledge, data: MeasuredPoints) -> float:
    """Of the tip, mm; 0 where nothing was touched."""
    return tip_of(station.arm).radius_mm if data.touched else 0.0


def find_part(data: MeasuredPoints, station: StationKnowledge) -> Floats:
    """``T_arm_part`` by datums, from touches or a scan without a start.

    Raises:
        OperationError: ``part-not-found``; as ``measure_features`` and ``align_datums``.
    """
    program = data.program
    if program.alignment is None:
        return np.eye(4)
    radius = tip_radius(station, data)
    T = _rough(data, radius)
    wanted = [(name, program.datum_means(name)) for name in program.alignment.used]
    wanted = list(dict.fromkeys(wanted))
    for _ in range(ROUNDS):
        before = T
        T = aligner(program, wanted, T)(place_features(data, wanted, T, radius))
        moved = float(np.abs(inverse(before) @ T - np.eye(4))[:3, 3].max())
        if moved < SETTLED_MM:
            break
    return T


def aligner(program: ProgramFile, wanted: Sequence[tuple[str, Means]], start: Floats) -> Aligner:
    """How the part frame follows from features in the order of ``wanted``."""
    alignment = program.alignment
    if alignment is None:
        return lambda shapes: start
    places = [wanted.index((name, program.datum_means(name))) for name in alignment.used]
    nominals = [program.feature(name).shape() for name in alignment.used]
    size = program.size_mm()
    newest: list[tuple[tuple[Shape, ...], Floats]] = []

    def align(shapes: Sequence[Shape]) -> Floats:
        measured = tuple(shapes[place] for place in places)
        # most steps of a derivative move no datum
        if newest and all(a is b for a, b in zip(newest[0][0], measured, strict=True)):
            return newest[0][1]
        datums = [Datum(*pair) for pair in zip(nominals, measured, strict=True)]
        stages = [datums] if alignment.kind == "best-fit" else [[one] for one in datums]
        T = align_datums(stages, start, size, alignment.locked)
        newest[:] = [(measured, T)]
        return T

    return align


def _rough(data: MeasuredPoints, tip_radius_mm: float) -> Floats:
    program = data.program
    assert program.alignment is not None
    touched = [name for name in program.alignment.used if name in data.touched]
    if len(touched) == len(program.alignment.used) or data.scan is None:
        if not data.touched:
            return np.eye(4)
        T, off = align_to_touches(faces_with_touches(data, tip_radius_mm))
        worst = WORST_TOUCHES_MM
    else:
        T, off = align_to_scan(list(data.faces.values()), data.scan.points_mm)
        worst = WORST_SCAN_MM
    if off > worst:
        raise OperationError(
            "part-not-found",
            message("part-not-found", off=quantity(off, "mm", 2)),
            message("part-not-found-why"),
            message("part-not-found-remedy"),
        )
    return T


def alignment_result(
    program: ProgramFile, T_arm_part: Floats, align: Aligner, knowledge: Knowledge, is_full: bool
) -> AlignmentResult:
    """The part frame with its covariance, and its uncertainty at the features."""
    points = np.array([one.nominal.point_mm for one in program.features])
    pivot = points.mean(axis=0)
    covariance = far_corner = None
    places: list[PlaceResult] = []
    if is_full:
        rows = knowledge.gradients(lambda shapes: frame_twist(T_arm_part, align(shapes), pivot))
        C = rows @ knowledge.total @ rows.T
        covariance = tuple(map(tuple, ((C + C.T) / 2).tolist()))

        def place(name: str, point: Vector3) -> PlaceResult:
            J = np.hstack([-skew(np.array(point) - pivot), np.eye(3)])
            u_mm = float(np.sqrt(max(np.trace(J @ C @ J.T), 0.0)))
            return PlaceResult(feature=name, point_mm=point, u_um=1e3 * u_mm)

        places = [place(one.id, one.nominal.point_mm) for one in program.features]
        corners = [
            place("", (x, y, z)) for x, y, z in product(*zip(*program.extent_mm(), strict=True))
        ]
        far_corner = max(corners, key=lambda one: one.u_um)
    return AlignmentResult.model_validate(
        {
            "T_arm_part": T_arm_part.tolist(),
            "covariance": covariance,
            "pivot_mm": pivot.tolist(),
            "known_at": places,
            "datums": () if program.alignment is None else program.alignment.used,
            "far_corner": far_corner,
        }
    )


def frame_twist(T_arm_part: Floats, moved: Floats, pivot_mm: Floats) -> Floats:
    """(6,) by which the part frame moved in itself: a rotation about a pivot, rad, and a shift."""
    change = inverse(T_arm_part) @ moved
    turn = vector_from_rotation(change[:3, :3])
    shift = change[:3, :3] @ pivot_mm + change[:3, 3] - pivot_mm
    return np.concatenate([turn, shift])
