"""The map of deviations of an inspection: its scan in the frame of its own datums.

Datums that were measured by the scan err as its points do. What the frame takes from sensor, arm,
tip and readings is therefore added to what each cell takes from them, before anything is squared.
"""

from pathlib import Path

import numpy as np
from scipy.sparse import csr_array

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.metrology.decision import DecisionRule
from crenel.metrology.transforms import Floats, inverse
from crenel.parts.cad.evaluate_part import Part, read_part
from crenel.parts.deviation.evaluate_deviation import (
    DeviationOrder,
    DeviationResult,
    judge_placed,
)
from crenel.parts.deviation.evaluate_pose import PlacedScan, ScanOnPart, check_cells
from crenel.parts.deviation.maths_cell_errors import cell_errors
from crenel.parts.deviation.maths_decisions import IN, OUT, UNDECIDED, DeviationLimits
from crenel.parts.deviation.maths_uncertainty import PartPose, independent_pose
from crenel.parts.document_program import ProgramFile
from crenel.parts.document_results import InspectionFile, MapDecisionPart
from crenel.parts.evaluate import MeasuredPart
from crenel.parts.evaluate_alignment import frame_twist
from crenel.parts.evaluate_folder import FolderFiles

PARTS = ("part.stl", "part.step", "part.stp")
SCAN = 0
"""The source of features by scan; every other one is a feature's touches."""


def read_inspected_part(files: FolderFiles) -> Part:
    """The part of an inspection folder: the file that its program names, or ``part.stl``.

    Raises:
        OperationError: there is none, or no scan; it cannot be read.
    """
    program = ProgramFile.read(files.program)
    folder = files.program.parent
    names = PARTS if program.part.cad is None else (program.part.cad,)
    path = next((folder / name for name in names if (folder / name).is_file()), None)
    if path is None or not files.scans:
        raise OperationError(
            "map-without-part" if path is None else "map-without-scan",
            message("part-map-needs-part-and-scan", folder=str(folder), names=", ".join(names)),
            "",
            message("part-put-part-or-leave-map"),
        )
    limits = map_limits(program)
    return read_part(path, None, None if limits is None else limits.width_mm)


def map_limits(program: ProgramFile) -> DeviationLimits | None:
    """The limits of a program's map; None if it has none on one of the sides."""
    lower, upper = program.map.lower_mm, program.map.upper_mm
    return None if lower is None or upper is None else DeviationLimits(lower, upper)


def map_part(found: MeasuredPart, part: Part, rule: DecisionRule) -> DeviationResult:
    """The map of a measured part in its own frame.

    Raises:
        OperationError: hardly any point is on the part, or its facets are too coarse.
    """
    program, data = found.inspection.program, found.data
    assert data.scan is not None
    shared = found.inspection.station.shared
    T = inverse(found.T_arm_part)
    errors = None if shared is None else data.scan
    scan = ScanOnPart(part, data.scan.points_mm, errors, program.map.radius_mm)
    cells = scan.cells(T)
    check_cells(scan, cells)
    pivot = part.mesh.middle_mm
    if errors is None:
        placed = PlacedScan(
            cells, None, independent_pose(T, pivot, np.zeros((6, 6)), 0), False, None, ()
        )
    else:
        of_cells = cell_errors(cells, errors, T)
        placed = PlacedScan(cells, of_cells, datum_pose(found, pivot), True, None, ())
    order = DeviationOrder(
        found.inspection.files.scans[0],
        part,
        limits=map_limits(program),
        cell_mm=program.map.radius_mm,
        rule=rule,
    )
    return judge_placed(placed, shared, data.scan.frame, order)


def datum_pose(found: MeasuredPart, pivot_mm: Floats) -> PartPose:
    """The part's frame by its features, with what each error does to it, split as that of cells.

    Args:
        pivot_mm: (3,) part frame.
    """
    scan = found.data.scan
    assert scan is not None
    G = -found.knowledge.gradients(
        lambda shapes: frame_twist(found.T_arm_part, found.align(shapes), pivot_mm)
    )
    fitted = [one.fitted for one in found.features]
    shared = G @ np.concatenate([one.sums.shared for one in fitted])
    parts = found.knowledge.parts
    own = G @ (parts["stripe"] + parts["touches"] + parts["form"]) @ G.T
    joints = len(scan.reading_sd)
    by_readings = np.zeros((6, len(scan.motion.T_arm_flange), joints))
    at = 0
    for one in found.features:
        sums, m = one.fitted.sums, len(one.fitted.own)
        by = np.einsum("am,kmj->akj", G[:, at : at + m], sums.by_readings)
        at += m
        if one.source == SCAN:
            by_readings[:, sums.frames] += by
        else:
            own = own + np.einsum("akj,bkj->ab", by, by)
    return PartPose(
        inverse(found.T_arm_part), pivot_mm, shared, csr_array(by_readings.reshape(6, -1)), own
    )


def with_map(document: InspectionFile, result: DeviationResult, program: Path) -> InspectionFile:
    """The result with what its map decided, where the program has limits."""
    limits = map_limits(ProgramFile.read(program))
    warnings = (*document.warnings, *result.warnings)
    if limits is None:
        return document.model_copy(update={"warnings": warnings})
    found = MapDecisionPart(
        cells=len(result.decisions),
        inside=result.count(IN),
        outside=result.count(OUT),
        undecided=result.count(UNDECIDED),
        lower_mm=limits.lower_mm,
        upper_mm=limits.upper_mm,
        probability=None if result.profile is None else result.profile.probability,
        decision=result.outcome,
    )
    return document.model_copy(update={"map": found, "warnings": warnings})
