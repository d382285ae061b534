"""Location error of a sphere over articulations, and the error of the probe matrix it implies."""

from dataclasses import dataclass

import numpy as np

from crenel.errors import OperationError
from crenel.gauges.sphere.maths_enclosing_sphere import smallest_enclosing_sphere
from crenel.messages.message import message
from crenel.metrology.transforms import Floats

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
