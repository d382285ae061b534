"""The weighted least squares of the parameters of an arm and the centres of the measured places.

The centre of each place is unknown and affects only its own points: it is eliminated place by place
(QR), and a small system for the arm's parameters remains.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import solve_triangular

from app.errors import OperationError
from app.messages.message import join, message
from app.metrology.arm.identification.observations import Group, StackedObservations
from app.metrology.arm.identification.parameters import (
    encoder_covariances,
    parameter_values,
    tip_jacobian,
    with_parameters,
)
from app.metrology.arm.kinematics import Arm
from app.metrology.fitting.plane_sphere import fit_sphere
from app.metrology.transforms import Floats

Indices = NDArray[np.intp]

CONSTRAINT_MM = 1e-4
"""The two ends of a bar are at its true length to this; the error of its length is a parameter."""
LEAST_SCATTER_MM = 5e-4
RADIUS_PRIOR_MM = 10.0
"""A weak prior of the tip radius, which only keeps the solution finite."""


@dataclass(frozen=True)
class Unknowns:
    """All unknowns of the adjustment."""

    arm: Arm
    centres_mm: Floats
    """(P, 3) centre of each place, arm frame."""
    radius_excess_mm: float
    """How much larger the spheres are measured than the radii of sphere and tip state."""
    bar_errors_mm: Floats
    """(B,) of each artefact: true minus calibrated length."""


@dataclass(frozen=True)
class PointResiduals:
    """Deviations of the points at given unknowns."""

    vectors_mm: Floats
    """(N, 3) tip minus centre; on spheres, only along the outward direction."""
    whitened: Floats
    """(N,) the same relative to its own standard deviation (Mahalanobis distance)."""
    bars_mm: Floats
    """(G,) distance of the ends minus the true length, for each position of a bar."""

    @property
    def distances_mm(self) -> Floats:
        """(N,)"""
        return np.asarray(np.linalg.norm(self.vectors_mm, axis=1))


@dataclass(frozen=True)
class ReducedSystem:
    """The system for the parameters alone: ``rows @ change = right``, in standard deviations.

    The first ``others`` columns belong to the spheres' radius excess and the bars' errors, the
    remaining ones to the arm's parameters in the requested order.
    """

    rows: Floats
    right: Floats
    others: int
    back: tuple[Floats, ...]
    """For each group: the upper triangle from which its centres are recovered."""


def initial_unknowns(arm: Arm, data: StackedObservations) -> Unknowns:
    """The given arm, with the centre of each place where most of its points have it."""
    tips, _ = tip_jacobian(arm, data.q_rad)
    centres = np.empty((len(data.places), 3))
    for i, place in enumerate(data.places):
        points = tips[place.rows]
        if place.diameter_mm is None:
            centres[i] = np.median(points, axis=0)
            continue
        try:
            centres[i] = fit_sphere(points).centre_mm
        except OperationError as refusal:
            what = join([place.label, refusal.what], ": ")
            raise OperationError(
                refusal.code, what, refusal.why, message("touch-more-sphere")
            ) from refusal
    return Unknowns(arm, centres, 0.0, np.zeros(len(data.bar_names)))


@dataclass(frozen=True)
class TipPrediction:
    """The tip at every point, by an arm."""

    tips_mm: Floats  # (N, 3)
    J: Floats  # (N, 3, 10 n + 3) by every parameter of the arm
    covariances: Floats  # (N, 3, 3) by the encoders' noise


def predict_tips(data: StackedObservations, at: Unknowns) -> TipPrediction:
    """The tips of all points, by the arm of the unknowns."""
    tips, J = tip_jacobian(at.arm, data.q_rad)
    return TipPrediction(tips, J, encoder_covariances(at.arm, J))


def mahalanobis(
    data: StackedObservations, at: Unknowns, sight: TipPrediction, scatter_mm: float
) -> Floats:
    """(N,) distance of each point from its place relative to its standard deviation."""
    return _norms(_linearise(data, at, sight, scatter_mm).right)


@dataclass(frozen=True)
class _WhitenedRows:
    """Whitened rows of every point: seats use three, spheres the first of three."""

    vectors_mm: Floats
    right: Floats  # (N, 3)
    by_tip: Floats  # (N, 3, 3): whitened derivative by the position of the tip


def residuals(data: StackedObservations, at: Unknowns, scatter_mm: float) -> PointResiduals:
    """Position of every point relative to its place; ``scatter_mm`` is added to the encoders'
    noise."""
    linear = _linearise(data, at, predict_tips(data, at), scatter_mm)
    bars = np.array(
        [_bar_distance(at, group) - _true_length(data, at, group) for group in _bar_groups(data)]
    )
    return PointResiduals(linear.vectors_mm, np.linalg.norm(linear.right, axis=1), bars)


def reduce_system(
    data: StackedObservations, at: Unknowns, columns: Indices, weights: Floats, scatter_mm: float
) -> ReducedSystem:
    """The linear system at given unknowns, with all centres eliminated.

    Args:
        columns: the parameters that move.
        weights: (N,) of each point, 0 to exclude it.
    """
    sight = predict_tips(data, at)
    linear = _linearise(data, at, sight, scatter_mm)
    root = np.sqrt(weights)
    others = (1 if data.on_sphere.any() else 0) + len(data.bar_names)
    width = others + len(columns)
    body = np.zeros((len(data.q_rad), 3, width + 1))
    if data.on_sphere.any():
        # on spheres, only the first row counts, along the outward direction
        body[data.on_sphere, 0, 0] = -_norms(linear.by_tip[data.on_sphere, 0])
    body[:, :, others:width] = linear.by_tip @ sight.J[:, :, columns]
    body[:, :, width] = -linear.right
    body *= root[:, None, None]
    by_centre = -linear.by_tip * root[:, None, None]
    left: list[Floats] = []
    back: list[Floats] = []
    for group in data.groups:
        triangle = _triangle(_group_rows(data, at, group, by_centre, body))
        unknown = 3 * len(group.places)
        back.append(triangle[:unknown])
        left.append(triangle[unknown:, unknown:])
    left.append(_prior_rows(data, at, width))
    rows = _triangle(np.concatenate(left))
    return ReducedSystem(rows[:, :width], rows[:, width], others, tuple(back))


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
    spheres = 1 if data.on_sphere.any() else 0
    return Unknowns(
        with_parameters(at.arm, values),
        centres,
        at.radius_excess_mm + (float(change[0]) if spheres else 0.0),
        at.bar_errors_mm + change[spheres : system.others],
    )


def settle_centres(
    data: StackedObservations, at: Unknowns, weights: Floats, scatter_mm: float
) -> Unknowns:
    """The best centres for a fixed arm, radius and bar lengths: the places as this arm measures
    them.

    The ends of a bar are then independent of each other.
    """
    free = replace(
        data, groups=tuple(Group((i,)) for i in range(len(data.places))), bars=(), bar_names=()
    )
    bar_errors, at = at.bar_errors_mm, replace(at, bar_errors_mm=np.zeros(0))
    none = np.zeros(0, dtype=np.intp)
    for _ in range(20):
        system = reduce_system(free, at, none, weights, scatter_mm)
        held = np.zeros(system.others)
        after = apply_change(free, at, none, held, system)
        far = float(np.max(np.abs(after.centres_mm - at.centres_mm)))
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


def _prior_rows(data: StackedObservations, at: Unknowns, width: int) -> Floats:
    """Prior rows for the lengths of the bars and, weakly, for the radius of the tip."""
    spheres = 1 if data.on_sphere.any() else 0
    rows = np.zeros((spheres + len(data.bar_names), width + 1))
    if spheres:
        rows[0, 0], rows[0, -1] = 1.0, -at.radius_excess_mm
        rows[0] /= RADIUS_PRIOR_MM
    for k, name in enumerate(data.bar_names):
        sd = next(bar.standard_uncertainty_mm for bar in data.bars if bar.name == name)
        rows[spheres + k, spheres + k], rows[spheres + k, -1] = 1.0, -at.bar_errors_mm[k]
        rows[spheres + k] /= max(sd, CONSTRAINT_MM)
    return rows


def _bar_groups(data: StackedObservations) -> list[Group]:
    return [group for group in data.groups if group.bar is not None]


def _bar_column(data: StackedObservations, group: Group) -> int:
    assert group.bar is not None
    spheres = 1 if data.on_sphere.any() else 0
    return spheres + data.bar_names.index(data.bars[group.bar].name)


def _true_length(data: StackedObservations, at: Unknowns, group: Group) -> float:
    assert group.bar is not None
    bar = data.bars[group.bar]
    return bar.length_mm + float(at.bar_errors_mm[data.bar_names.index(bar.name)])


def _bar_distance(at: Unknowns, group: Group) -> float:
    a, b = (at.centres_mm[number] for number in group.places)
    return float(np.linalg.norm(b - a))


def _norms(vectors: Floats) -> Floats:
    return np.asarray(np.linalg.norm(vectors, axis=1))
