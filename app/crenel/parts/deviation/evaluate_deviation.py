"""How far a scan or a cloud deviates from its part: map, decisions and what they rest on."""

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.formats.clouds.files import read_cloud
from crenel.formats.file_names import display_path
from crenel.messages.message import Text, message, quantity
from crenel.metrology.decision import GUARDED_95, DecisionRule
from crenel.metrology.transforms import Floats, inverse
from crenel.parts.cad.evaluate_part import Part
from crenel.parts.deviation.document_map import pack_cells
from crenel.parts.deviation.evaluate_pose import (
    PlacedScan,
    ScanOnPart,
    place_by_alignment,
    place_by_best_fit,
)
from crenel.parts.deviation.maths_decisions import (
    DRAWS,
    IN,
    LEAST_POINTS,
    MOST_CHORD,
    OUT,
    UNDECIDED,
    DeviationLimits,
    ProfileDecision,
    count_by_chance,
    decide_cells,
    decide_profile,
    temper_decisions,
)
from crenel.parts.deviation.maths_neighbours import local_means
from crenel.parts.deviation.maths_uncertainty import MapErrors, map_errors
from crenel.parts.document_results import AlignmentFile, Outcome
from crenel.parts.evaluate_folder import StationKnowledge, read_station
from crenel.parts.evaluate_points import read_scan
from crenel.progress import Progress, no_progress

CELL_MM = 0.8
"""Edge of a cell, as the nesting index of a filter."""
POINTS_SHARE, PLACED_SHARE = 0.5, 0.85
"""Of the work: up to the points of the scan, and up to the cells on the part."""


@dataclass(frozen=True)
class DeviationOrder:
    """What is to be compared with what, and how."""

    source: Path
    """A cloud, or a recording with its files."""
    part: Part
    calibration: Path | None = None
    arm: Path | None = None
    alignment: Path | None = None
    limits: DeviationLimits | None = None
    cell_mm: float = CELL_MM
    locked: tuple[str, ...] = ()
    rule: DecisionRule = GUARDED_95


@dataclass(frozen=True)
class DeviationResult:
    """A map and its decisions."""

    placed: PlacedScan
    u_mm: Floats
    """(C,) standard uncertainty; NaN where it is not known."""
    decisions: NDArray[np.uint8]
    """(C,)"""
    frames: NDArray[np.int64]
    """(C,) frames in each cell; 0 where they are not known."""
    profile: ProfileDecision | None
    by_chance: float | None
    """How many cells would be decided as out if all were as drawn."""
    budget_um: dict[str, float]
    """Rms over the cells of the standard uncertainty by each source; empty: scatter only."""
    variances_mm2: dict[str, Floats]
    """(C,) of each cell by each source, which add up to that of the cell; empty: scatter only."""
    warnings: tuple[Text, ...]

    @property
    def pose_of_part(self) -> Floats:
        """(4, 4) ``T_arm_part``."""
        return inverse(self.placed.pose.T_part_arm)

    def count(self, decision: int) -> int:
        """Cells of a decision."""
        return int(np.sum(self.decisions == decision))

    @property
    def outcome(self) -> Outcome:
        """The word for all cells and the profile together, where there are limits."""
        profile = None if self.profile is None else self.profile.decision
        if self.count(OUT) or profile == "fail":
            return "fail"
        return "pass" if profile == "pass" and not self.count(UNDECIDED) else "undecided"

    def rows(self) -> NDArray[np.void]:
        """The cells as ``map.ply`` has them."""
        cells = self.placed.cells
        return pack_cells(
            cells.at_mm, cells.deviation_mm, self.u_mm, self.decisions, cells.count, self.frames
        )


def is_recording(path: Path) -> bool:
    """Whether a file is a recording by its name."""
    return path.suffix.lower() == ".mcap"


def deviate(order: DeviationOrder, progress: Progress = no_progress) -> DeviationResult:
    """Compares a scan or a cloud with its part.

    Raises:
        OperationError: a file cannot be used, the scan does not fit the part, leaves a motion of it
            free, or the part's facets are too coarse for the tolerance.
    """
    warnings: list[Text] = []
    shared: Floats | None = None
    frame: NDArray[np.int64] | None
    if is_recording(order.source):
        station = _station(order)
        data = read_scan(
            order.source, station, lambda share, text: progress(POINTS_SHARE * share, text)
        )
        warnings += [*station.warnings, *data.warnings]
        shared = station.shared
        errors = None if shared is None else data.errors
        scan = ScanOnPart(order.part, data.errors.points_mm, errors, order.cell_mm)
        frame = data.errors.frame
    else:
        cloud = read_cloud(order.source)
        warnings.append(message("part-cloud-has-scatter-only"))
        scan = ScanOnPart(order.part, cloud.points_mm, None, order.cell_mm)
        frame = None if cloud.frame is None else cloud.frame.astype(np.int64)
    progress(POINTS_SHARE, message("part-finding-where-it-lies"))
    placed = _place(scan, order)
    progress(PLACED_SHARE, message("part-deciding-cells"))
    warnings += placed.notes
    if order.alignment is not None and not placed.has_pose_errors:
        warnings.append(message("part-alignment-without-covariance"))
    result = judge_placed(placed, shared, frame, order)
    return replace(result, warnings=(*warnings, *result.warnings))


def judge_placed(
    placed: PlacedScan,
    shared: Floats | None,
    frame: NDArray[np.int64] | None,
    order: DeviationOrder,
) -> DeviationResult:
    """Uncertainties and decisions of the cells of a scan that is in its place.

    Args:
        shared: (P, P) covariance of the errors that all points share; None: it is not known.
        frame: (N,) of each point; None: it is not known.

    Raises:
        OperationError: the part's facets are too coarse for the tolerance.
    """
    result = _judge(placed, _errors(placed, shared), order)
    return replace(result, frames=_frames_of_cells(placed, frame))


def _station(order: DeviationOrder) -> StationKnowledge:
    beside = order.source.parent
    return read_station(
        order.calibration or beside / "calibration.json", order.arm or beside / "arm.json"
    )


def _place(scan: ScanOnPart, order: DeviationOrder) -> PlacedScan:
    if order.alignment is None:
        return place_by_best_fit(scan, order.locked)
    return place_by_alignment(scan, AlignmentFile.read(order.alignment).alignment)


def _errors(placed: PlacedScan, shared: Floats | None) -> MapErrors | None:
    if placed.errors is None or shared is None or not placed.has_pose_errors:
        return None
    return map_errors(placed.cells, placed.errors, placed.pose, shared)


def _judge(placed: PlacedScan, known: MapErrors | None, order: DeviationOrder) -> DeviationResult:
    cells, limits = placed.cells, order.limits
    count = len(cells)
    u = np.full(count, np.nan) if known is None else known.standard_uncertainty_mm
    decisions = np.full(count, UNDECIDED, np.uint8)
    warnings: list[Text] = []
    profile, by_chance = None, None
    if limits is not None:
        is_coarse = cells.chord_error_mm > MOST_CHORD * limits.width_mm
        if is_coarse.any():
            warnings.append(_coarse(order, is_coarse, float(cells.chord_error_mm.max())))
        decisions = _decide(placed, u, order, limits)
        decisions[is_coarse | (cells.count < LEAST_POINTS)] = UNDECIDED
        if known is not None:
            by_chance = count_by_chance(u[cells.count >= LEAST_POINTS], limits, order.rule)
            if not is_coarse.any():
                profile = decide_profile(cells.deviation_mm, known.draw(DRAWS), limits)
    variances = {} if known is None else known.variances
    budget = {
        name: 1e3 * float(np.sqrt(max(float(np.mean(one)), 0.0))) for name, one in variances.items()
    }
    none = np.zeros(count, np.int64)
    return DeviationResult(
        placed, u, decisions, none, profile, by_chance, budget, variances, tuple(warnings)
    )


def _decide(
    placed: PlacedScan, u_mm: Floats, order: DeviationOrder, limits: DeviationLimits
) -> NDArray[np.uint8]:
    cells = placed.cells
    decisions = decide_cells(cells.deviation_mm, u_mm, limits, order.rule)
    if placed.errors is None:
        return decisions
    own = placed.errors.own_sd_mm
    local = local_means(cells, own, order.cell_mm)
    u_local = np.sqrt(np.maximum(u_mm**2 - own**2, 0.0) + local.own_sd_mm**2)
    around = decide_cells(local.deviation_mm, u_local, limits, order.rule)
    return temper_decisions(decisions, around, cells.deviation_mm, u_mm)


def _coarse(order: DeviationOrder, is_coarse: NDArray[np.bool_], worst_mm: float) -> Text:
    """What is said of facets too far from their surface; raises where that is all of them."""
    assert order.limits is not None
    worst = quantity(1e3 * worst_mm, "µm", 1)
    most = quantity(1e3 * MOST_CHORD * order.limits.width_mm, "µm", 1)
    if is_coarse.all():
        raise OperationError(
            "part-facets-coarse",
            message("part-facets-are-coarse", worst=worst),
            message("part-facets-permitted", most=most),
            message("part-facets-finer"),
        )
    count = int(is_coarse.sum())
    return message("part-cells-with-coarse-facets", count=count, worst=worst, most=most)


def _frames_of_cells(placed: PlacedScan, frame: NDArray[np.int64] | None) -> NDArray[np.int64]:
    cells = placed.cells
    if frame is None:
        return np.zeros(len(cells), np.int64)
    of_points = frame[cells.points]
    pairs = np.unique(cells.cell * (int(of_points.max(initial=0)) + 1) + of_points)
    return np.bincount(pairs // (int(of_points.max(initial=0)) + 1), minlength=len(cells))


def result_fields(result: DeviationResult, order: DeviationOrder) -> dict[str, object]:
    """The result for programs."""
    cells, placed, limits = result.placed.cells, result.placed, order.limits
    off, u = 1e3 * cells.deviation_mm, 1e3 * result.u_mm
    return {
        "source": display_path(order.source),
        "uncertainty": "full" if np.isfinite(u).all() else "scatter",
        "alignment": {
            "kind": "best-fit" if placed.fit is not None else "given",
            "T_arm_part": result.pose_of_part.tolist(),
            "residual_um": None if placed.fit is None else 1e3 * placed.fit.residual_mm,
        },
        "cell_mm": order.cell_mm,
        "cells": len(cells),
        "points": int(cells.count.sum()),
        "left_out": [
            {"rule": "beyond-band", "count": cells.beyond},
            {"rule": "at-edge", "count": cells.at_edges},
        ],
        "deviation_um": {
            "least": float(off.min()),
            "median": float(np.median(off)),
            "most": float(off.max()),
        },
        "scatter_um": 1e3 * float(np.median(cells.scatter_mm)),
        "standard_uncertainty_um": _spread(u),
        "budget_um": result.budget_um,
        "tolerance_mm": None if limits is None else [limits.lower_mm, limits.upper_mm],
        "in": result.count(IN),
        "out": result.count(OUT),
        "undecided": result.count(UNDECIDED),
        "out_by_chance": result.by_chance,
        "profile": None
        if result.profile is None
        else {
            "decision": result.profile.decision,
            "probability": result.profile.probability,
        },
        "rule": {"name": order.rule.name, "guard_factor": order.rule.guard_factor},
        "warnings": list(map(str, result.warnings)),
    }


def _spread(u_um: Floats) -> dict[str, float] | None:
    if not np.isfinite(u_um).all():
        return None
    return {
        "least": float(u_um.min()),
        "median": float(np.median(u_um)),
        "most": float(u_um.max()),
    }
