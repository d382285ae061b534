"""Cells of about equal area on a nominal surface, and the points of a scan in each."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.transforms import Floats, apply
from crenel.parts.cad.maths_closest import MeshTree
from crenel.parts.cad.maths_smooth import SmoothSurface
from crenel.parts.deviation.maths_face_points import face_points

BAND_MM = 2.0
"""What is farther from the nominal surface is no point of it."""
UNIT_FLOOR = 1e-9


@dataclass(frozen=True)
class SurfaceCells:
    """Cells with points of a scan, in the part frame."""

    points: NDArray[np.int64]
    """(N,) the points within the band, of those given, by cell."""
    cell: NDArray[np.int64]
    """(N,) the cell of each of them, ascending."""
    count: NDArray[np.int64]
    """(C,) of each cell."""
    at_mm: Floats
    """(C, 3) mean place on the nominal surface."""
    normals: Floats
    """(C, 3) unit, outwards."""
    deviation_mm: Floats
    """(C,) mean distance, positive outside."""
    scatter_mm: Floats
    """(C,) standard deviation of the distances; 0 of a single point."""
    chord_error_mm: Floats
    """(C,) how far the curved surface may be from the triangles there."""
    beyond: int
    """Points farther than the band."""
    at_edges: int
    """Points at a sharp edge or past it, which are of no face."""

    def __len__(self) -> int:
        return len(self.count)


def surface_cells(
    tree: MeshTree,
    surface: SmoothSurface,
    points_mm: Floats,
    T_part_arm: Floats,
    edge_mm: float,
    band_mm: float = BAND_MM,
) -> SurfaceCells:
    """The cells of the nominal surface on which points (N, 3) of the arm frame lie.

    A smooth patch of the surface is divided into squares of the two axes that its normal is
    farthest from, so that cells on faces along the axes have equal areas, others up to 1.7 times
    as large.
    """
    on = face_points(tree, surface, apply(T_part_arm, points_mm), band_mm)
    faces, at, normals = on.faces, on.at_mm, on.normals
    number = _cell_numbers(surface.patches[faces], normals, at, edge_mm)
    order = np.argsort(number, kind="stable")
    number = number[order]
    count = np.bincount(number)
    sums = np.column_stack([at[order], normals[order]])
    means = _means(number, sums, count)
    off = on.distance_mm[order]
    mean = _means(number, off[:, None], count)[:, 0]
    squares = np.bincount(number, (off - mean[number]) ** 2, len(count))
    chord = np.zeros(len(count))
    np.maximum.at(chord, number, tree.mesh.chord_errors_mm[faces[order]])
    length = np.linalg.norm(means[:, 3:], axis=1)
    return SurfaceCells(
        on.index[order],
        number,
        count,
        means[:, :3],
        means[:, 3:] / np.maximum(length, UNIT_FLOOR)[:, None],
        mean,
        np.sqrt(squares / np.maximum(count - 1, 1)),
        chord,
        on.beyond,
        on.at_edges,
    )


def _cell_numbers(
    patches: NDArray[np.int32], normals: Floats, at_mm: Floats, edge_mm: float
) -> NDArray[np.int64]:
    """(N,) from 0 on, of cells of this edge."""
    if not len(patches):
        return np.zeros(0, np.int64)
    axis = np.argmax(np.abs(normals), axis=1)
    is_low = normals[np.arange(len(axis)), axis] < 0
    at = np.floor(at_mm / edge_mm + 0.5).astype(np.int64)  # faces of round numbers are between
    at -= at.min(axis=0)
    at[np.arange(len(axis)), axis] = 0
    width = at.max(axis=0) + 1
    key = patches.astype(np.int64) * 6 + 2 * axis + is_low
    for k in range(3):
        key = key * width[k] + at[:, k]
    return np.asarray(np.unique(key, return_inverse=True)[1].ravel(), dtype=np.int64)


def _means(number: NDArray[np.int64], rows: Floats, count: NDArray[np.int64]) -> Floats:
    """(C, K) means of the rows (N, K) of each cell."""
    sums = [np.bincount(number, rows[:, k], len(count)) for k in range(rows.shape[1])]
    return np.asarray(np.column_stack(sums) / count[:, None])
