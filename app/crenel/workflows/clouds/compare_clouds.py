"""How far one cloud lies from another: each point from the plane through its neighbours there.

What is found is scatter and form together: of both clouds, and of what lies between the two scans.
It is no measurement uncertainty.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import KDTree

from crenel.errors import OperationError
from crenel.formats.clouds.cuts import sample_kept
from crenel.formats.clouds.points import positions_of
from crenel.messages.message import message
from crenel.metrology.transforms import Floats

NEIGHBOURS = 12
"""The plane at a place of the reference is through so many of its neighbours."""
MOST_CELLS = 150_000
"""The reference is thinned to the means of cells, which lie alike in all directions, as points of
stripes do not."""
WIDER = 1.4
"""By this factor cells grow until neighbours are around a place, not on one stripe."""
TRIED, FEWEST_AROUND = 2000, 0.95
ROUNDEST = 0.05
"""Neighbours span a plane if their second extent is more than this share of the first, squared."""
ROUGHEST = 5.0
"""Where neighbours leave their plane by more than so many times what is usual, there is an edge."""
REACH = 0.75
"""A point further from the reference, along its surface, than this share of the radius of a plane
lies beside it, not on it."""
FEWEST = 100
UPRIGHT = 0.2
"""A plane whose normal rises less than this is a wall: its outside is away from the middle."""


@dataclass(frozen=True, slots=True)
class CloudDeviation:
    """Deviations of one cloud from another, of the points that lie on it."""

    points: int
    """The number of points that were compared."""
    share_beside: float
    """Share of the compared points, 0 to 1, that the reference does not reach."""
    mean_um: float
    rms_um: float
    p95_um: float
    """95 % of the deviations are not larger than this, without their sign."""
    plane_mm: float
    """Usual radius of the planes: the points of the reference are no closer."""
    flatness_um: float
    """By how much the reference usually leaves its planes, rms: scatter, and curvature on the
    radius. Smaller deviations mean nothing."""


@dataclass(frozen=True, slots=True)
class _Planes:
    """Planes through neighbours: centres and normals (N, 3), and of each (N,) whether the
    neighbours span one, their rms distance from it, and the distance of the furthest."""

    centres_mm: Floats
    normals: Floats
    found: NDArray[np.bool_]
    off_mm: Floats
    radii_mm: Floats


def read_places(cloud: Path, most: int) -> Floats:
    """At most so many points (N, 3) of a ``cloud.ply``, evenly from all but what was cut away.

    Raises:
        OperationError: it is missing, cut off, or written by another program.
    """
    return positions_of(sample_kept(cloud, most))


class LocalPlanes:
    """A cloud as planes, each through some neighbours."""

    def __init__(self, reference_mm: Floats) -> None:
        """Fits the planes.

        Args:
            reference_mm: points (N, 3).

        Raises:
            OperationError: there are too few.
        """
        if len(reference_mm) < FEWEST:
            raise OperationError(
                "few-points",
                message("comparison-needs-points", count=len(reference_mm), needed=FEWEST),
                remedy=message("compare-scans-of-one-place"),
            )
        cells_mm = _thin(reference_mm)
        self._tree = KDTree(cells_mm)
        self._planes = _fit_planes(self._tree, cells_mm)
        self.radius_mm = float(np.median(self._planes.radii_mm))
        self.flatness_mm = float(np.median(self._planes.off_mm[self._planes.found]))
        self._found = self._planes.found & (self._planes.off_mm <= ROUGHEST * self.flatness_mm)
        self._reach_mm = REACH * self.radius_mm

    def distances(self, points_mm: Floats) -> Floats:
        """Signed distances (N,) in mm of points (N, 3), positive outside; infinite of those that
        lie beside the reference."""
        apart, nearest = self._tree.query(points_mm, workers=-1)
        offsets = points_mm - self._planes.centres_mm[nearest]
        found = np.einsum("ni,ni->n", offsets, self._planes.normals[nearest])
        # along the surface, not across it: a large deviation is one, too
        beside = np.sqrt(np.maximum(apart**2 - found**2, 0.0)) > self._reach_mm
        return np.where(beside | ~self._found[nearest], np.inf, found)

    def summarise(self, distances_mm: Floats) -> CloudDeviation:
        """Figures of distances (N,) by ``distances``.

        Raises:
            OperationError: too few points lie on the reference.
        """
        on_mm = distances_mm[np.isfinite(distances_mm)]
        if len(on_mm) < FEWEST:
            raise OperationError(
                "no-overlap",
                message("clouds-do-not-overlap", count=len(on_mm), total=len(distances_mm)),
                remedy=message("compare-scans-of-one-place"),
            )
        return CloudDeviation(
            points=len(on_mm),
            share_beside=1.0 - len(on_mm) / len(distances_mm),
            mean_um=1e3 * float(on_mm.mean()),
            rms_um=1e3 * float(np.sqrt(np.mean(on_mm**2))),
            p95_um=1e3 * float(np.percentile(np.abs(on_mm), 95)),
            plane_mm=self.radius_mm,
            flatness_um=1e3 * self.flatness_mm,
        )


def _thin(points_mm: Floats) -> Floats:
    """The means (M, 3) of cells, as small as neighbours then lie all around."""
    size_mm = float(np.linalg.norm(np.ptp(points_mm, axis=0))) / np.sqrt(MOST_CELLS)
    while True:
        cells_mm = _cell_means(points_mm, size_mm)
        if len(cells_mm) <= MOST_CELLS:
            tried = cells_mm[:: max(len(cells_mm) // TRIED, 1)]
            found = _fit_planes(KDTree(cells_mm), tried).found
            if found.mean() >= FEWEST_AROUND or len(cells_mm) < 10 * NEIGHBOURS:
                return cells_mm
        size_mm *= WIDER


def _cell_means(points_mm: Floats, size_mm: float) -> Floats:
    cells = np.floor((points_mm - points_mm.min(axis=0)) / size_mm).astype(np.int64)
    span = cells.max(axis=0) + 1
    keys = (cells[:, 0] * span[1] + cells[:, 1]) * span[2] + cells[:, 2]
    _, cell_of, counts = np.unique(keys, return_inverse=True, return_counts=True)
    sums = [np.bincount(cell_of.ravel(), column) for column in points_mm.T]
    return np.column_stack(sums) / counts[:, None]


def _fit_planes(tree: KDTree, places_mm: Floats) -> _Planes:
    """Through the neighbours of places (N, 3)."""
    apart, near = tree.query(places_mm, min(NEIGHBOURS, tree.n), workers=-1)
    neighbours = np.asarray(tree.data)[near]
    centres = neighbours.mean(axis=1)
    around = neighbours - centres[:, None, :]
    extents, axes = np.linalg.eigh(np.einsum("nki,nkj->nij", around, around))
    normals = axes[:, :, 0]
    return _Planes(
        centres,
        normals * _outward(centres, normals)[:, None],
        extents[:, 1] > ROUNDEST * extents[:, 2],
        np.sqrt(np.maximum(extents[:, 0], 0.0) / near.shape[1]),
        apart[:, -1],
    )


def _outward(centres_mm: Floats, normals: Floats) -> NDArray[np.floating]:
    """1 or -1 (N,) by which normals (N, 3) point upwards, and those of walls away from the
    middle."""
    away = np.einsum("ni,ni->n", (centres_mm - centres_mm.mean(axis=0))[:, :2], normals[:, :2])
    up = normals[:, 2]
    return np.where(np.where(np.abs(up) >= UPRIGHT, up, away) < 0, -1.0, 1.0)
