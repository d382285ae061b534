"""Errors of the mean deviations of cells: by what all share, by each frame, and their own."""

from dataclasses import dataclass, replace

import numpy as np
from scipy.sparse import csr_array, vstack

from crenel.metrology.transforms import Floats
from crenel.parts.deviation.maths_cells import SurfaceCells
from crenel.parts.maths.point_errors import ErrorSums, ScanErrors

TOGETHER = 32
"""Cells whose derivatives are computed at a time."""


@dataclass(frozen=True)
class CellErrors:
    """What makes the mean deviations of C cells err, to first order."""

    shared: Floats
    """(C, P) derivatives by the errors that everything shares."""
    by_readings: csr_array
    """(C, F·n) by one standard deviation of each reading of each frame."""
    own_sd_mm: Floats
    """(C,) standard deviations of what no other cell has."""


def cell_errors(cells: SurfaceCells, scan: ScanErrors, T_part_arm: Floats) -> CellErrors:
    """The errors of cells of a scan.

    The points of a cell in one frame count as their mean, which lies in the laser plane as they do.

    Args:
        scan: all points among which the cells count theirs.
    """
    frame = scan.frame[cells.points]
    frames = len(scan.motion.T_arm_flange)
    pairs, first, pair, size = np.unique(
        cells.cell * frames + frame, return_index=True, return_inverse=True, return_counts=True
    )
    pair_cell = pairs // frames
    points = scan.points_mm[cells.points]
    means = np.column_stack([np.bincount(pair, points[:, k]) / size for k in range(3)])
    share = size / cells.count[pair_cell]
    normals = (cells.normals @ T_part_arm[:3, :3])[pair_cell]  # arm frame
    whole = replace(
        scan, points_mm=means, frame=frame[first], spread_mm=scan.spread_mm[cells.points][first]
    )
    count, joints = len(cells), scan.motion.by_noise.shape[2]
    shared: list[Floats] = []
    readings: list[csr_array] = []
    for begin in range(0, count, TOGETHER):
        rows = np.arange(*np.searchsorted(pair_cell, [begin, begin + TOGETHER]))
        gains = np.zeros((len(rows), min(TOGETHER, count - begin)))
        gains[np.arange(len(rows)), pair_cell[rows] - begin] = share[rows]
        sums = whole.select(rows).sums(gains, normals[rows])
        shared.append(sums.shared)
        readings.append(_by_readings(sums, frames, joints))
    own = scan.select(cells.points).own_sd_mm((cells.normals @ T_part_arm[:3, :3])[cells.cell])
    stripe = np.bincount(cells.cell, own**2, count) / cells.count**2
    return CellErrors(
        np.concatenate(shared),
        vstack(readings, format="csr"),
        np.sqrt(np.maximum(stripe, cells.scatter_mm**2 / cells.count)),
    )


def _by_readings(sums: ErrorSums, frames: int, joints: int) -> csr_array:
    """(m, F·n)"""
    by = np.moveaxis(sums.by_readings, 1, 0)  # (m, K, n)
    columns = joints * sums.frames[:, None] + np.arange(joints)
    row, place, joint = np.nonzero(by)
    return csr_array(
        (by[row, place, joint], (row, columns[place, joint])), (len(by), frames * joints)
    )
