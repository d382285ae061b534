"""Location error of a sphere over articulations, and the error of the probe matrix it implies."""

from dataclasses import dataclass
from itertools import combinations

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.metrology.transforms import Floats

MOST = 12
TOLERANCE = 1e-9
"""In mm: points closer together are one."""


@dataclass(frozen=True)
class EnclosingSphere:
    """The smallest sphere about some points."""

    centre_mm: Floats  # (3,)
    diameter_mm: float


def smallest_enclosing_sphere(points_mm: Floats) -> EnclosingSphere:
    """The smallest sphere that holds all points.

    All pairs, triples and quadruples are tried: at most four points lie on its surface.

    Args:
        points_mm: (N, 3), 1 <= N <= ``MOST``.

    Source:
        Location error L_Dia of ISO 10360-12: the diameter of the zone that holds the centres.

    Example:
        >>> smallest_enclosing_sphere(np.array([[0.0, 0, 0], [2, 0, 0], [1, 0.5, 0]])).diameter_mm
        2.0
    """
    points = np.asarray(points_mm, dtype=np.float64)
    assert 1 <= len(points) <= MOST, len(points)
    best: EnclosingSphere | None = None
    points = _distinct(points)
    if len(points) == 1:
        return EnclosingSphere(points[0], 0.0)
    for size in (2, 3, 4):
        for chosen in combinations(points, size):
            centre = _circumcentre(np.array(chosen))
            if centre is None:
                continue
            radius = float(np.linalg.norm(chosen[0] - centre))
            if best is not None and 2 * radius >= best.diameter_mm:
                continue
            if (np.linalg.norm(points - centre, axis=1) <= radius + TOLERANCE).all():
                best = EnclosingSphere(centre, 2 * radius)
    assert best is not None, "a sphere through two, three or four points holds all"
    return best


def _distinct(points: Floats) -> Floats:
    """The points (K, 3) without those that coincide with an earlier one."""
    kept: list[Floats] = []
    for point in points:
        if all(np.linalg.norm(point - other) > TOLERANCE for other in kept):
            kept.append(point)
    return np.array(kept)


def _circumcentre(points: Floats) -> Floats | None:
    """The point of their affine hull that is equally far from all (K, 3); None if they are
    dependent."""
    edges = points[1:] - points[0]
    gram = edges @ edges.T
    if np.linalg.matrix_rank(gram, tol=1e-12 * max(float(gram.max()), 1e-12)) < len(edges):
        return None
    shares = np.linalg.solve(2 * gram, np.diag(gram))
    return np.asarray(points[0] + shares @ edges)


FEWEST = 3
DETERMINED = 1e-3
"""If the orientations differ less than this (as the smallest share of a full turn's effect), a
direction of the error cannot be seen."""


@dataclass(frozen=True)
class ImpliedOffset:
    """The error of the probe matrix's translation that would explain the centres best."""

    offset_mm: Floats
    """(3,) in the sensor's frame: the sensor is really this far from where the matrix has it."""
    covariance: Floats
    """(3, 3) mm², by the centres' scatter about it."""
    left_mm: float
    """L_Dia that would remain after it is corrected."""

    @property
    def size_mm(self) -> float:
        return float(np.linalg.norm(self.offset_mm))

    @property
    def is_significant(self) -> bool:
        """Whether it differs from zero by more than chance, with 95 %."""
        # three components, and as many degrees of freedom as estimated: Hotelling's test with the
        # limit of chi-square is too sharp for few centres; twice its 95 % point is not
        square = self.offset_mm @ np.linalg.solve(self.covariance, self.offset_mm)
        return bool(square > 2 * 7.81)


def location_error_mm(centres_mm: Floats) -> float:
    """``L_Dia``: the diameter of the smallest sphere that holds the centres (N, 3).

    Source:
        ISO 10360-12 (the zone that contains the centres); symbol L_Dia.
    """
    return smallest_enclosing_sphere(centres_mm).diameter_mm


def estimate_offset(
    centres_mm: Floats, R_arm_sensor: Floats, arm_sd_mm: float = 0.0
) -> ImpliedOffset:
    """The constant offset in the sensor's frame that moves the centres apart like this.

    A probe matrix whose translation is wrong by ``d`` moves every point by ``-R_arm_sensor d``:
    with another orientation, to another side. Least squares over the articulations, with the true
    centre unknown.

    Args:
        centres_mm: (N, 3) measured centres, N >= 3.
        R_arm_sensor: (N, 3, 3) mean orientation of the sensor in each articulation.
        arm_sd_mm: standard deviation along an axis by which the arm alone moves a centre from
            articulation to articulation; the residuals of few centres can hide it.

    Raises:
        OperationError: ``articulations-alike``: the orientations do not separate the offset from
            the position of the sphere.
    """
    count = len(centres_mm)
    A = np.zeros((3 * count, 6))
    for i, R in enumerate(R_arm_sensor):
        A[3 * i : 3 * i + 3, :3] = np.eye(3)
        A[3 * i : 3 * i + 3, 3:] = R
    found, _, _, singular = np.linalg.lstsq(A, centres_mm.ravel(), rcond=None)
    if count < FEWEST or singular[-1] < DETERMINED * singular[0]:
        raise OperationError(
            "articulations-alike",
            message("articulations-too-alike"),
            message("offset-not-separable"),
            message("scan-sphere-from-other-sides"),
        )
    # the points lie where the wrong matrix puts them: the true sensor is on the other side
    offset = np.asarray(-found[3:], dtype=np.float64)
    residuals = centres_mm.ravel() - A @ found
    freedom = max(3 * count - 6, 1)
    scatter = max(float(residuals @ residuals) / freedom, arm_sd_mm**2)
    covariance = np.asarray(np.linalg.inv(A.T @ A)[3:, 3:] * scatter, dtype=np.float64)
    corrected = centres_mm - np.einsum("nij,j->ni", R_arm_sensor, found[3:])
    return ImpliedOffset(offset, covariance, location_error_mm(corrected))
