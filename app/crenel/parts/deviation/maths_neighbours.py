"""Means over the cells around each cell, by which one that errs by chance is not taken for good."""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array
from scipy.spatial import cKDTree

from crenel.metrology.transforms import Floats
from crenel.parts.deviation.maths_cells import SurfaceCells

REACH = 1.6
"""Of a cell's edge: the eight around it on a plane."""
SAME_WAY = 0.9
"""Least cosine between normals of cells of one surface."""


@dataclass(frozen=True)
class LocalMeans:
    """Of each cell with those around it."""

    deviation_mm: Floats
    """(C,)"""
    own_sd_mm: Floats
    """(C,) standard deviation of what no two cells share."""


def local_means(cells: SurfaceCells, own_sd_mm: Floats, edge_mm: float) -> LocalMeans:
    """The means over each cell and its neighbours, by their points."""
    pairs = cKDTree(cells.at_mm).query_pairs(REACH * edge_mm, output_type="ndarray")
    cosine = np.einsum("pi,pi->p", cells.normals[pairs[:, 0]], cells.normals[pairs[:, 1]])
    pairs = pairs[cosine > SAME_WAY]
    own = np.arange(len(cells))
    rows = np.concatenate([own, pairs[:, 0], pairs[:, 1]])
    columns = np.concatenate([own, pairs[:, 1], pairs[:, 0]])
    weights = cells.count[columns].astype(np.float64)
    around = coo_array((weights, (rows, columns)), (len(own), len(own))).tocsr()
    total = np.bincount(rows, weights, len(own))
    variance = around.power(2) @ own_sd_mm**2
    return LocalMeans(around @ cells.deviation_mm / total, np.sqrt(variance) / total)
