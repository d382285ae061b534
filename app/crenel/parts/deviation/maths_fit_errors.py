"""What makes a best fit err: the errors of all cells that it uses, to first order."""

import numpy as np
from scipy.sparse import csr_array

from crenel.metrology.transforms import Floats
from crenel.parts.deviation.maths_best_fit import move_about, tukey_weights
from crenel.parts.deviation.maths_cell_errors import CellErrors
from crenel.parts.deviation.maths_cells import SurfaceCells
from crenel.parts.deviation.maths_uncertainty import PartPose
from crenel.parts.maths.datums import MOTION_NAMES


def cell_weights(cells: SurfaceCells) -> Floats:
    """(C,) weights of cells in a best fit: 0 of those far beyond the scatter of all."""
    return tukey_weights(cells.deviation_mm - float(np.median(cells.deviation_mm)))


def fit_to_cells(
    cells: SurfaceCells, pivot_mm: Floats, size_mm: float, locked: tuple[str, ...]
) -> Floats:
    """(6, C) by which deviations of cells move the best fit, a left twist about the pivot."""
    weights = cell_weights(cells)
    turns = np.cross(cells.at_mm - pivot_mm, cells.normals) / size_mm
    D = np.eye(6)[:, [k for k, name in enumerate(MOTION_NAMES) if name not in locked]]
    J = np.concatenate([turns, cells.normals], axis=1) @ D
    moved = -D @ np.linalg.pinv(J.T @ (weights[:, None] * J), rcond=1e-9) @ (J * weights[:, None]).T
    moved[:3] /= size_mm
    return np.asarray(moved)


def move_to_cells(T_part_arm: Floats, cells: SurfaceCells, by: Floats, pivot_mm: Floats) -> Floats:
    """The pose after one step of the best fit to cells; ``by`` as of ``fit_to_cells``."""
    return move_about(T_part_arm, pivot_mm, by @ cells.deviation_mm)


def fit_pose(T_part_arm: Floats, pivot_mm: Floats, by: Floats, errors: CellErrors) -> PartPose:
    """The pose of a best fit to cells, with what makes it err."""
    return PartPose(
        T_part_arm,
        pivot_mm,
        by @ errors.shared,
        csr_array(csr_array(by) @ errors.by_readings),
        np.asarray((by * errors.own_sd_mm**2) @ by.T),
    )
