"""Form deviations: the narrowest zone about the means of cells, and what noise alone would show.

The range of many noisy points is mostly noise. Form is therefore taken of the means of cells, and
its expectation under the known noise is computed by simulation.
"""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import linprog

from crenel.metrology.transforms import Floats
from crenel.parts.maths.feature_fit import FittedFeature
from crenel.parts.maths.point_errors import ScanErrors
from crenel.parts.maths.shapes import Shape
from crenel.parts.maths.shared_covariance import covariance_root

ROUNDS = 50
EXCHANGES = 40
FEWEST_ACTIVE = 60
CLOSE_MM = 1e-9
DRAWS = 200


@dataclass(frozen=True)
class FormDeviation:
    """The width of the narrowest zone, mm, and what noise makes of it.

    ``expected_mm`` is what noise alone would show on average of a perfect feature, and ``sd_mm``
    how far that scatters.
    """

    zone_mm: float
    expected_mm: float
    sd_mm: float


def narrowest_zone(shape: Shape, points_mm: Floats, offset_mm: float = 0.0) -> tuple[Shape, float]:
    """The feature for which the points (N, 3) lie in the narrowest zone, and its width, mm.

    Source:
        Anthony et al. (1996): linear programs about the present feature, repeated.
    """
    best = shape
    for _ in range(ROUNDS):
        off, _, J = best.linearise(points_mm)
        step, _ = minimax_step(J, off - offset_mm)
        moved = best.apply_step(step)
        if np.ptp(moved.distances(points_mm)) > np.ptp(off) - 1e-12:
            break
        best = moved
        if np.abs(step).max() < CLOSE_MM:
            break
    return best, float(np.ptp(best.distances(points_mm)))


def minimax_step(J: Floats, off: Floats) -> tuple[Floats, float]:
    """The step that makes the largest of ``|off + J step|`` least, and that value.

    Points are exchanged: a linear program has only those that can matter.
    """
    scale = 1 / np.maximum(np.abs(J).max(axis=0), 1e-12)
    A = J * scale
    m = A.shape[1]
    step = -np.linalg.lstsq(A, off, rcond=None)[0]
    active = np.argsort(-np.abs(off + A @ step))[: max(FEWEST_ACTIVE, 4 * m)]
    height = float(np.abs(off).max())
    for _ in range(EXCHANGES):
        rows = np.concatenate([A[active], -A[active]])
        rows = np.column_stack([rows, -np.ones(len(rows))])
        right = np.concatenate([-off[active], off[active]])
        found = linprog(
            np.r_[np.zeros(m), 1.0],
            A_ub=rows,
            b_ub=right,
            bounds=[(None, None)] * m + [(0, None)],
            method="highs",
        )
        step, height = found.x[:m], float(found.x[m])
        rest = np.abs(off + A @ step)
        worse = np.flatnonzero(rest > height * (1 + 1e-9) + 1e-12)
        worse = np.setdiff1d(worse, active)
        if not len(worse):
            break
        active = np.r_[active, worse[np.argsort(-rest[worse])][:200]]
    return scale * step, height


def form_deviation(fitted: FittedFeature, errors: ScanErrors, shared: Floats) -> FormDeviation:
    """The form of a scanned feature by the means of its cells.

    Args:
        errors: of the points used.
        shared: (P, P) covariance of the shared errors.
    """
    cell, normals = fitted.cell, fitted.shape.normals(errors.points_mm)
    count = np.bincount(cell)
    sums = [np.bincount(cell, errors.points_mm[:, axis]) for axis in range(3)]
    means = np.column_stack(sums) / count[:, None]
    _, zone = narrowest_zone(fitted.shape, means)
    first = np.zeros(len(count), dtype=np.int64)
    first[cell[::-1]] = np.arange(len(cell))[::-1]
    rows = errors.select(first).rows(normals[first]) @ covariance_root(shared)
    sd = np.sqrt(np.bincount(cell, errors.own_sd_mm(normals) ** 2)) / count
    _, _, J = fitted.shape.linearise(means)
    rng = np.random.default_rng(0)
    widths = []
    for _ in range(DRAWS):
        drawn = sd * rng.normal(size=len(sd)) + rows @ rng.normal(size=rows.shape[1])
        drawn = drawn + np.bincount(cell, errors.draw_readings(normals, rng)) / count
        widths.append(2 * minimax_step(J, drawn)[1])
    return FormDeviation(zone, float(np.mean(widths)), float(np.std(widths)))
