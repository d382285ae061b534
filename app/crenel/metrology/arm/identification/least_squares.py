"""The weighted least squares of the parameters of an arm and the centres of the measured places.

The centre of each place is unknown and affects only its own points: it is eliminated place by place
(QR), and a small system for the arm's parameters remains. Coordinates of another instrument add
their rows to it.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import solve_triangular

from crenel.metrology.arm.identification.coordinate_rows import (
    coordinate_residuals,
    coordinate_rows,
)
from crenel.metrology.arm.identification.observations import Group, StackedObservations
from crenel.metrology.arm.identification.parameters import (
    Indices,
    parameter_values,
    tip_jacobian,
    with_parameters,
)
from crenel.metrology.arm.identification.scatter import Scatter
from crenel.metrology.arm.identification.unknowns import Unknowns
from crenel.metrology.arm.kinematics import tips_with_covariances
from crenel.metrology.fitting.outlier_search import Disagreement
from crenel.metrology.transforms import Floats

CONSTRAINT_MM = 1e-4
"""The two ends of a bar are at its true length to this; the error of its length is a parameter."""
RADIUS_PRIOR_MM = 10.0
"""A weak prior of the tip radius, which only keeps the solution finite."""


@dataclass(frozen=True)
class PointResiduals:
    """Deviations of the points at given unknowns, touches first, then coordinates."""

    vectors_mm: Floats
    """(N + M, 3) tip minus centre, on spheres only along the outward direction; marker minus
    measured point."""
    touches: Floats
    """(N,) the same relative to its own standard deviation (Mahalanobis distance)."""
    coordinates: Floats
    """(M, 6) the same of each coordinate, then of the rotations; 0 where none was measured."""
    angles_rad: Floats
    """(M,) between measured and predicted rotation; 0 where none was measured."""
    bars_mm: Floats
    """(G,) distance of the ends minus the true length, for each position of a bar."""

    @property
    def whitened(self) -> Floats:
        """(N + M,) Mahalanobis distance of each point."""
        return np.concatenate([self.touches, _norms(self.coordinates)])

    @property
    def distances_mm(self) -> Floats:
        """(N + M,)"""
        return _norms(self.vectors_mm)


@dataclass(frozen=True)
class ReducedSystem:
    """The system for the parameters alone: ``rows @ change = right``, in standard deviations.

    The first ``others`` columns belong to the unknowns that are no parameters of the arm, the
    remaining ones to the arm's parameters in the requested order.
    """

    rows: Floats
    right: Floats
    others: int
    back: tuple[Floats, ...]
    """For each group: the upper triangle from which its centres are recovered."""
    kinds: tuple[Floats, Floats, Floats]
    """The same rows (without the right side) of touches and certified lengths, of coordinates, and
    of rotations."""


@dataclass(frozen=True)
class TipPrediction:
    """The tip at every touch, by an arm."""

    tips_mm: Floats  # (N, 3)
    covariances: Floats  # (N, 3, 3) by the encoders' noise


def predict_tips(data: StackedObservations, at: Unknowns) -> TipPrediction:
    """The tips of all touches, by the arm of the unknowns."""
    return TipPrediction(*tips_with_covariances(at.arm, data.q_rad))


def mahalanobis(
    data: StackedObservations, at: Unknowns, sight: TipPrediction, scatter_mm: float
) -> Floats:
    """(N,) distance of each touch from its place relative to its standard deviation."""
    return _norms(_linearise(data, at, sight, scatter_mm).right)


@dataclass(frozen=True)
class _WhitenedRows:
    """Whitened rows of every touch: seats use three, spheres the first of three."""

    vectors_mm: Floats
    right: Floats  # (N, 3)
    by_tip: Floats  # (N, 3, 3): whitened derivative by the position of the tip


def residuals(data: StackedObservations, at: Unknowns, scatter: Scatter) -> PointResiduals:
    """Position of every touch relative to its place, of every coordinate relative to the arm."""
    linear = _linearise(data, at, predict_tips(data, at), scatter.touch_mm)
    measured = coordinate_residuals(data, at, scatter)
    bars = np.array(
        [_bar_distance(at, group) - _true_length(data, at, group) for group in _bar_groups(data)]
    )
    vectors = np.concatenate([linear.vectors_mm, measured.off[:, :3]])
    angles = _norms(measured.off[:, 3:])
    return PointResiduals(vectors, _norms(linear.right), measured.whitened, angles, bars)


def reduce_system(
    data: StackedObservations, at: Unknowns, columns: Indices, weights: Floats, scatter: Scatter
) -> ReducedSystem:
    """The linear system at given unknowns, with all centres eliminated.

    Args:
        columns: the parameters that move.
        weights: (N + M,) of each point, 0 to exclude it.
    """
    others = data.others
    width = others.count + len(columns)
    touched, back = _touch_rows(data, at, columns, weights[: data.touches], scatter.touch_mm)
    measured = coordinate_rows(data, at, columns, scatter)
    measured *= np.sqrt(weights[data.touches :])[:, None, None]
    points, turns = (measured[:, own].reshape(-1, width + 1) for own in (slice(3), slice(3, 6)))
    lengths, radius = _length_rows(data, at, width), _radius_rows(data, at, width)
    touched = np.concatenate([touched, lengths])
    rows = _triangle(np.concatenate([touched, points, turns, radius]))
    kinds = (touched[:, :width], points[:, :width], turns[:, :width])
    return ReducedSystem(rows[:, :width], rows[:, width], others.count, tuple(back), kinds)


def _touch_rows(
    data: StackedObservations, at: Unknowns, columns: Indices, weights: Floats, scatter_mm: float
) -> tuple[Floats, list[Floats]]:
    """Rows of the touches without their centres, and what recovers the centres of each group."""
    others = data.others
    width = others.count + len(columns)
    by_centre, body = _touch_equations(data, at, columns, weights, scatter_mm)
    left: list[Floats] = [np.zeros((0, width + 1))]
    back: list[Floats] = []
    for group in data.groups:
        triangle = _triangle(_group_rows(data, at, group, by_centre, body))
        unknown = 3 * len(group.places)
        back.append(triangle[:unknown])
        left.append(triangle[unknown:, unknown:])
    return np.concatenate(left), back


def _touch_equations(
    data: StackedObservations, at: Unknowns, columns: Indices, weights: Floats, scatter_mm: float
) -> tuple[Floats, Floats]:
    """Derivatives (N, 3, 3) of the touches by their centres, and (N, 3, width + 1) by all other
    unknowns, with the right side."""
    others = data.others
    width = others.count + len(columns)
    linear = _linearise(data, at, predict_tips(data, at), scatter_mm)
    root = np.sqrt(weights)
    body = np.zeros((data.touches, 3, width + 1))
    if others.radius is not None:
        # on spheres, only the first row counts, along the outward direction
        body[data.on_sphere, 0, others.radius] = -_norms(linear.by_tip[data.on_sphere, 0])
    if len(columns):
        J = tip_jacobian(at.arm, data.q_rad)[1][:, :, columns]
        body[:, :, others.count : width] = linear.by_tip @ J
    body[:, :, width] = -linear.right
    body *= root[:, None, None]
    return -linear.by_tip * root[:, None, None], body


def group_disagreements(
    data: StackedObservations,
    at: Unknowns,
    columns: Indices,
    kept: NDArray[np.bool_],
    scatter: Scatter,
    covariance: Floats,
) -> Iterator[tuple[NDArray[np.intp], Disagreement]]:
    """How the touches of each group disagree at the best fit, and which they are.

    Args:
        columns: the parameters that move.
        kept: (N + M,) points that count.
        covariance: of all unknowns but the centres.
    """
    weights = kept[: data.touches].astype(np.float64)
    by_centre, body = _touch_equations(data, at, columns, weights, scatter.touch_mm)
    for group in data.groups:
        rows = _group_rows(data, at, group, by_centre, body)
        touches = np.concatenate(
            [np.arange(data.touches)[data.places[i].rows] for i in group.places]
        )
        unknown = 3 * len(group.places)
        U, s, _ = np.linalg.svd(rows[:, :unknown], full_matrices=False)
        Q = U[:, s > 1e-9 * s.max(initial=0.0)]
        by_others = rows[:, unknown:-1] - Q @ (Q.T @ rows[:, unknown:-1])
        information = np.eye(len(rows)) - Q @ Q.T - by_others @ covariance @ by_others.T
        size = 1 if data.on_sphere[touches[0]] else 3
        counted = np.flatnonzero(kept[touches])
        own = (3 * counted[:, None] + np.arange(size)).ravel()
        yield (
            touches[counted],
            Disagreement(information[np.ix_(own, own)], -rows[own, -1], size),
        )


def step(
    data: StackedObservations, at: Unknowns, columns: Indices, system: ReducedSystem
) -> tuple[Unknowns, float]:
    """The unknowns after one Gauss-Newton step, and its largest change in standard deviations."""
    norms = np.maximum(np.linalg.norm(system.rows, axis=0), 1e-300)
    change, *_ = np.linalg.lstsq(system.rows / norms, system.right, rcond=1e-13)
    size = float(np.max(np.abs(change), initial=0.0))
    return apply_change(data, at, columns, change / norms, system), size


def apply_change(
    data: StackedObservations, at: Unknowns, columns: Indices, change: Floats, system: ReducedSystem
) -> Unknowns:
    """The unknowns after a change of parameters; the centres follow."""
    centres = at.centres_mm.copy()
    for group, triangle in zip(data.groups, system.back, strict=True):
        unknown = 3 * len(group.places)
        right = triangle[:, -1] - triangle[:, unknown:-1] @ change
        diagonal = np.abs(np.diag(triangle[:, :unknown]))
        if len(triangle) < unknown or diagonal.min() <= 1e-9 * max(diagonal.max(), 1e-300):
            shift, *_ = np.linalg.lstsq(triangle[:, :unknown], right, rcond=1e-9)
        else:
            shift = solve_triangular(triangle[:, :unknown], right)
        centres[list(group.places)] += shift.reshape(-1, 3)
    values = parameter_values(at.arm)
    values[columns] += change[system.others :]
    moved = replace(at, arm=with_parameters(at.arm, values), centres_mm=centres)
    return moved.change_others(data, change[: system.others])


def settle_centres(
    data: StackedObservations, at: Unknowns, weights: Floats, scatter: Scatter
) -> Unknowns:
    """The best centres for a fixed arm, radius, bar lengths, frames and markers: the places as
    this arm measures them.

    The ends of a bar are then independent of each other.
    """
    free = replace(
        data, groups=tuple(Group((i,)) for i in range(len(data.places))), bars=(), bar_names=()
    )
    bar_errors, at = at.bar_errors_mm, replace(at, bar_errors_mm=np.zeros(0))
    none = np.zeros(0, dtype=np.intp)
    for _ in range(20):
        system = reduce_system(free, at, none, weights, scatter)
        held = np.zeros(system.others)
        after = apply_change(free, at, none, held, system)
        far = float(np.max(np.abs(after.centres_mm - at.centres_mm), initial=0.0))
        at = after
        if far < 1e-7:
            break
    return replace(at, bar_errors_mm=bar_errors)


def _linearise(
    data: StackedObservations, at: Unknowns, sight: TipPrediction, scatter_mm: float
) -> _WhitenedRows:
    covariances = sight.covariances + scatter_mm**2 * np.eye(3)
    off = sight.tips_mm - at.centres_mm[data.place_of]
    whiten = np.linalg.inv(np.linalg.cholesky(covariances))
    vectors = off.copy()
    on = data.on_sphere
    if on.any():
        distances = np.maximum(_norms(off[on]), 1e-9)
        outward = off[on] / distances[:, None]
        sds = np.sqrt(np.einsum("ni,nij,nj->n", outward, covariances[on], outward))
        reach = data.sphere_radii_mm[on] + at.arm.tip.radius_mm + at.radius_excess_mm
        gap = distances - reach
        vectors[on] = gap[:, None] * outward
        whiten[on] = 0.0
        whiten[on, 0] = outward / sds[:, None]
    right = np.einsum("nij,nj->ni", whiten, vectors)
    return _WhitenedRows(vectors, right, whiten)


def _triangle(rows: Floats) -> Floats:
    """The upper triangle of the rows' QR factors: the same least squares with fewer rows."""
    return np.asarray(np.linalg.qr(rows, mode="r"))


def _group_rows(
    data: StackedObservations, at: Unknowns, group: Group, by_centre: Floats, body: Floats
) -> Floats:
    """Rows of one group: the columns of its centres, then of the parameters, then the right
    side."""
    unknown, width = 3 * len(group.places), body.shape[2]
    blocks: list[Floats] = []
    for k, number in enumerate(group.places):
        rows = data.places[number].rows
        block = np.zeros((3 * (rows.stop - rows.start), unknown + width))
        block[:, 3 * k : 3 * k + 3] = by_centre[rows].reshape(-1, 3)
        block[:, unknown:] = body[rows].reshape(-1, width)
        blocks.append(block)
    if group.bar is not None:
        a, b = (at.centres_mm[number] for number in group.places)
        along = (b - a) / max(float(np.linalg.norm(b - a)), 1e-9)
        row = np.zeros((1, unknown + width))
        row[0, :3], row[0, 3:6] = -along, along
        row[0, unknown + _bar_column(data, group)] = -1.0
        row[0, -1] = _true_length(data, at, group) - _bar_distance(at, group)
        blocks.append(row / CONSTRAINT_MM)
    return np.concatenate(blocks)


def length_deviations(data: StackedObservations, at: Unknowns) -> Floats:
    """(B,) error of each bar's length relative to the uncertainty of its certificate."""
    return np.asarray(at.bar_errors_mm / length_uncertainties_mm(data))


def length_uncertainties_mm(data: StackedObservations) -> Floats:
    """(B,) of the certificates; infinite of a bar whose length is free."""
    stated = {bar.name: bar.standard_uncertainty_mm for bar in data.bars}
    return np.array([max(stated[name], CONSTRAINT_MM) for name in data.bar_names])


def _length_rows(data: StackedObservations, at: Unknowns, width: int) -> Floats:
    """Rows of the certified lengths of the bars."""
    rows = np.zeros((len(data.bar_names), width + 1))
    rows[:, data.others.bars] = np.diag(1 / length_uncertainties_mm(data))
    rows[:, -1] = -length_deviations(data, at)
    return rows


def _radius_rows(data: StackedObservations, at: Unknowns, width: int) -> Floats:
    """The weak prior row of the radius of the tip, if spheres were touched."""
    radius = data.others.radius
    if radius is None:
        return np.zeros((0, width + 1))
    row = np.zeros((1, width + 1))
    row[0, radius], row[0, -1] = 1.0, -at.radius_excess_mm
    return row / RADIUS_PRIOR_MM


def _bar_groups(data: StackedObservations) -> list[Group]:
    return [group for group in data.groups if group.bar is not None]


def _bar_column(data: StackedObservations, group: Group) -> int:
    assert group.bar is not None
    first: int = data.others.bars.start
    return first + data.bar_names.index(data.bars[group.bar].name)


def _true_length(data: StackedObservations, at: Unknowns, group: Group) -> float:
    assert group.bar is not None
    bar = data.bars[group.bar]
    return bar.length_mm + float(at.bar_errors_mm[data.bar_names.index(bar.name)])


def _bar_distance(at: Unknowns, group: Group) -> float:
    a, b = (at.centres_mm[number] for number in group.places)
    return float(np.linalg.norm(b - a))


def _norms(vectors: Floats) -> Floats:
    return np.asarray(np.linalg.norm(vectors, axis=1))
