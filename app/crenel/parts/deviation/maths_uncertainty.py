"""Standard uncertainties of the deviations of cells, with that of the part's frame."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_array

from crenel.metrology.transforms import Floats
from crenel.parts.deviation.maths_cell_errors import CellErrors
from crenel.parts.deviation.maths_cells import SurfaceCells
from crenel.parts.maths.point_errors import SHARED_SOURCES, normal_twists
from crenel.parts.maths.shared_covariance import covariance_root

SOURCES = (*SHARED_SOURCES, "encoders", "points", "alignment", "cad")
DRAWN_TOGETHER = 100


@dataclass(frozen=True)
class PartPose:
    """Where the part lies, and what makes its pose err, as of the deviations of cells.

    A small error of the pose is a left twist (rad, mm) of ``T_part_arm`` about ``pivot_mm``.
    """

    T_part_arm: Floats
    pivot_mm: Floats
    """(3,) part frame."""
    shared: Floats
    """(6, P)"""
    by_readings: csr_array | None
    """(6, F·n) by the readings of the scan's frames; None: it does not depend on them."""
    own: Floats
    """(6, 6) covariance of what the scan does not share."""

    def derivatives(self, at_mm: Floats, normals: Floats) -> Floats:
        """(C, 6) of distances at places (C, 3) along normals (C, 3), part frame."""
        return normal_twists(at_mm - self.pivot_mm, normals)

    def covariance(self, shared: Floats) -> Floats:
        """(6, 6) of the pose, from the covariance (P, P) of the shared errors."""
        found = self.shared @ shared @ self.shared.T + self.own
        if self.by_readings is not None:
            found = found + (self.by_readings @ self.by_readings.T).toarray()
        return np.asarray(found)


@dataclass(frozen=True)
class MapErrors:
    """All that makes the deviations of cells err."""

    shared: Floats
    """(C, P) with what the pose adds."""
    covariance: Floats
    """(P, P) of the shared errors."""
    cells: CellErrors
    pose: PartPose
    by_pose: Floats
    """(C, 6)"""
    chord_mm: Floats
    """(C,) standard uncertainty by the facets of the nominal surface."""

    @property
    def variances(self) -> dict[str, Floats]:
        """(C,) mm² by source; their sum is the square of the standard uncertainty.

        Where errors of two sources cancel, a part may be negative.
        """
        by = self.shared @ self.covariance
        parts = {
            name: np.sum(by[:, some] * self.shared[:, some], axis=1)
            for name, some in SHARED_SOURCES.items()
        }
        readings = np.asarray(self.cells.by_readings.power(2).sum(axis=1)).ravel()
        if (by_frames := self.pose.by_readings) is not None:
            cross = (self.cells.by_readings @ by_frames.T).toarray()
            readings = readings + 2 * np.sum(cross * self.by_pose, axis=1)
            readings = readings + _quadratic(self.by_pose, (by_frames @ by_frames.T).toarray())
        parts["encoders"] = readings
        parts["points"] = self.cells.own_sd_mm**2
        parts["alignment"] = _quadratic(self.by_pose, self.pose.own)
        parts["cad"] = self.chord_mm**2
        return parts

    @property
    def standard_uncertainty_mm(self) -> Floats:
        """(C,)"""
        total = np.sum(list(self.variances.values()), axis=0)
        return np.asarray(np.sqrt(np.maximum(total, 0.0)))

    def draw(self, draws: int, seed: int = 1) -> Iterator[Floats]:
        """Errors (C, D) of all cells together, D at a time, so many draws in all."""
        rng = np.random.default_rng(seed)
        root = self.shared @ covariance_root(self.covariance)
        own_pose = self.by_pose @ covariance_root(self.pose.own)
        alone = np.hypot(self.cells.own_sd_mm, self.chord_mm)[:, None]
        frames = self.cells.by_readings.shape[1]
        for begin in range(0, draws, DRAWN_TOGETHER):
            some = min(DRAWN_TOGETHER, draws - begin)
            readings = rng.normal(size=(frames, some))
            errors = root @ rng.normal(size=(root.shape[1], some))
            errors += self.cells.by_readings @ readings
            if self.pose.by_readings is not None:
                errors += self.by_pose @ (self.pose.by_readings @ readings)
            errors += own_pose @ rng.normal(size=(6, some))
            yield errors + alone * rng.normal(size=(len(alone), some))


def map_errors(
    cells: SurfaceCells, errors: CellErrors, pose: PartPose, covariance: Floats
) -> MapErrors:
    """The errors of a map: those of the cells' points and of the pose, with the facets'.

    Args:
        covariance: (P, P) of the shared errors.
    """
    by_pose = pose.derivatives(cells.at_mm, cells.normals)
    return MapErrors(
        errors.shared + by_pose @ pose.shared,
        covariance,
        errors,
        pose,
        by_pose,
        cells.chord_error_mm / np.sqrt(3),
    )


def _quadratic(rows: Floats, matrix: Floats) -> Floats:
    return np.asarray(np.einsum("ci,ij,cj->c", rows, matrix, rows))


def independent_pose(
    T_part_arm: Floats, pivot_mm: Floats, covariance: Floats, shared: int
) -> PartPose:
    """A pose whose errors (6, 6) are not those of the scan, which shares so many."""
    return PartPose(T_part_arm, pivot_mm, np.zeros((6, shared)), None, covariance)
