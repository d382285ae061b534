"""Where the scanned part lies: by an alignment that is given, or by its own surface."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import Message, Text, join, message, quantity
from crenel.metrology.transforms import Floats, inverse
from crenel.parts.cad.evaluate_part import Part, size_text
from crenel.parts.cad.maths_closest import MeshTree
from crenel.parts.cad.maths_smooth import SmoothSurface
from crenel.parts.deviation.maths_best_fit import BestFit, best_fit
from crenel.parts.deviation.maths_cell_errors import CellErrors, cell_errors
from crenel.parts.deviation.maths_cells import SurfaceCells, surface_cells
from crenel.parts.deviation.maths_fit_errors import (
    cell_weights,
    fit_pose,
    fit_to_cells,
    move_to_cells,
)
from crenel.parts.deviation.maths_free_motions import FreeMotion, free_motions
from crenel.parts.deviation.maths_uncertainty import PartPose, independent_pose
from crenel.parts.document_results import AlignmentResult
from crenel.parts.maths.point_errors import ScanErrors
from crenel.parts.maths.shapes import first_of_cells
from crenel.units import mistaken_unit

SETTLED_MM = 1e-4
ROUNDS = 5
THINNED_MM = 2.0
"""One point of each cube of this edge is enough to find the pose."""
LEAST_WITHIN, WORST_MM = 0.5, 0.5
"""Less of a scan near the part, or farther from it, is a scan of another part."""
ODD_RATIO = 4.0
DOUBTFUL_MM = 0.05
"""Where a fit leaves more, on average, the part's mirror image is tried."""


@dataclass(frozen=True)
class PlacedScan:
    """Cells of a scan on the part."""

    cells: SurfaceCells
    errors: CellErrors | None
    """None: the scan's uncertainty is not known."""
    pose: PartPose
    has_pose_errors: bool
    fit: BestFit | None
    notes: tuple[Text, ...]


@dataclass(frozen=True)
class ScanOnPart:
    """A scan and the part that it is of."""

    part: Part
    points_mm: Floats
    """(N, 3) arm frame."""
    errors: ScanErrors | None
    cell_mm: float

    def cells(self, T_part_arm: Floats) -> SurfaceCells:
        """The cells of the scan in a pose of the part."""
        part = self.part
        return surface_cells(part.tree, part.surface, self.points_mm, T_part_arm, self.cell_mm)


def place_by_alignment(scan: ScanOnPart, alignment: AlignmentResult) -> PlacedScan:
    """The cells of a scan by an alignment, whose errors count as independent of the scan's."""
    T = inverse(np.array(alignment.T_arm_part))
    cells = scan.cells(T)
    check_cells(scan, cells)
    errors = None if scan.errors is None else cell_errors(cells, scan.errors, T)
    shared = 0 if errors is None else errors.shared.shape[1]
    covariance = np.zeros((6, 6))
    if alignment.covariance is not None:
        covariance = np.array(alignment.covariance)
    pose = independent_pose(T, np.array(alignment.pivot_mm), covariance, shared)
    return PlacedScan(cells, errors, pose, alignment.covariance is not None, None, ())


def place_by_best_fit(scan: ScanOnPart, locked: Sequence[str] = ()) -> PlacedScan:
    """The cells of a scan where its surface fits the part best.

    Raises:
        OperationError: the scan has another size, fits badly, or leaves a motion of the part free.
    """
    part, held = scan.part, tuple(locked)
    _check_size(scan)
    thin = scan.points_mm[first_of_cells(scan.points_mm, THINNED_MM)]
    fit = best_fit(part.tree, part.surface, thin, None, held)
    if fit.mean_mm > DOUBTFUL_MM:
        _refuse_mirror_image(part, thin, fit)
    if fit.within < LEAST_WITHIN or not fit.residual_mm < WORST_MM:
        raise _misfit_error(fit.residual_mm, fit.within)
    pivot, size, T = part.mesh.middle_mm, part.mesh.diagonal_mm, fit.T_part_arm
    cells = scan.cells(T)
    check_cells(scan, cells)
    used = cell_weights(cells) > 0
    free = free_motions(cells.at_mm[used], cells.normals[used], pivot, size, held)
    if free:
        raise _free_motions_error(free)
    for _ in range(ROUNDS):
        by = fit_to_cells(cells, pivot, size, held)
        T = move_to_cells(T, cells, by, pivot)
        moved = np.abs(by @ cells.deviation_mm) * np.r_[size, size, size, 1, 1, 1]
        cells = scan.cells(T)
        if moved.max() < SETTLED_MM:
            break
    by = fit_to_cells(cells, pivot, size, held)
    notes: list[Text] = []
    if fit.second is not None:
        notes.append(
            message(
                "part-second-pose-fits",
                first=quantity(1e3 * fit.mean_mm, "µm", 1),
                second=quantity(1e3 * fit.second.mean_mm, "µm", 1),
            )
        )
    if scan.errors is None:
        pose = independent_pose(T, pivot, np.zeros((6, 6)), 0)
        return PlacedScan(cells, None, pose, False, fit, tuple(notes))
    errors = cell_errors(cells, scan.errors, T)
    return PlacedScan(cells, errors, fit_pose(T, pivot, by, errors), True, fit, tuple(notes))


def _refuse_mirror_image(part: Part, points_mm: Floats, fit: BestFit) -> None:
    """Raises ``OperationError`` where the scan fits the part's mirror image much better."""
    mirrored = part.mesh.mirror()
    other = best_fit(MeshTree(mirrored), SmoothSurface(mirrored), points_mm)
    if other.mean_mm < fit.mean_mm / 2:
        raise OperationError(
            "part-mirrored",
            message(
                "part-fits-mirror-image",
                residual=quantity(1e3 * fit.mean_mm, "µm"),
                mirrored=quantity(1e3 * other.mean_mm, "µm"),
            ),
            "",
            message("part-export-without-mirroring"),
        )


def _check_size(scan: ScanOnPart) -> None:
    """Raises ``OperationError`` where the scan has another size than the part."""
    part = scan.part
    low, high = np.quantile(scan.points_mm, [0.005, 0.995], axis=0)
    size = float(np.linalg.norm(high - low))
    ratio = size / part.mesh.diagonal_mm
    if 1 / ODD_RATIO**2 < ratio < ODD_RATIO:
        return
    unit = mistaken_unit(ratio, 0.6)
    raise OperationError(
        "part-size-differs",
        message("part-is-of-size", size=size_text(part.mesh), scan=quantity(size, "mm", 1)),
        message("part-of-other-unit", unit=unit) if unit else "",
        message("part-give-unit-of-it", unit=unit or "mm"),
    )


def check_cells(scan: ScanOnPart, cells: SurfaceCells) -> None:
    """Raises ``OperationError`` where hardly any point is on the part."""
    near = 1 - cells.beyond / max(len(scan.points_mm), 1)
    if len(cells) < 3 or near < LEAST_WITHIN / 5:
        raise _misfit_error(float("nan"), near)


def _misfit_error(residual_mm: float, within: float) -> OperationError:
    share = quantity(100 * within, "%")
    what = message("part-fits-not-share", share=share)
    if np.isfinite(residual_mm):
        residual = quantity(residual_mm, "mm", 2)
        what = message("part-fits-not", residual=residual, share=share)
    return OperationError(
        "part-fit-poor", what, message("part-fits-not-why"), message("part-fits-not-remedy")
    )


def _free_motions_error(free: Sequence[FreeMotion]) -> OperationError:
    names = []
    for one in free:
        prefix = "r" if one.kind == "turn" else ""
        if one.axis:
            names.append(prefix + one.axis)
    return OperationError(
        "part-fit-free",
        message("part-fit-leaves-free", motions=join([_describe(one) for one in free], "; ")),
        message("part-fit-is-not-fixed"),
        message("part-lock-or-scan-more", names=", ".join(names) or "rz"),
    )


def _describe(one: FreeMotion) -> Message:
    x, y, z = one.direction
    along: Text = one.axis or message(
        "part-direction", x=quantity(x, "", 2), y=quantity(y, "", 2), z=quantity(z, "", 2)
    )
    if one.kind == "shift":
        return message("part-free-shift", axis=along)
    x, y, z = one.at_mm
    place = message(
        "part-place", x=quantity(x, "", 1), y=quantity(y, "", 1), z=quantity(z, "mm", 1)
    )
    return message("part-free-turn", axis=along, place=place)
