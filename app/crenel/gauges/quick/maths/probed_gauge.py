"""The position of a gauge by the touch probe: the plane or sphere through its contact points.

A scan of the same gauge is compared with it, as ISO 10360-9 compares two probing systems.
"""

from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.gauges.quick.maths.errors import NominalPlane, NominalSphere
from crenel.messages.message import message, quantity
from crenel.metrology.arm.kinematics import (
    AnyArm,
    flange_poses,
    tip_centres,
    tip_covariances,
    tip_of,
)
from crenel.metrology.fitting.cylinder import perpendicular_axes
from crenel.metrology.fitting.outlier_search import Agreement
from crenel.metrology.fitting.touched_shape import agree_on_plane, agree_on_sphere
from crenel.metrology.transforms import Floats

PLANE_LEAST, SPHERE_LEAST = 4, 5
LEAST_SPREAD_MM = 5.0
"""Minimum rms of a plane's contact points along the shorter side of their area, about their
middle."""
LEAST_FACING = 0.05
"""Minimum mean square of the sphere's outward directions at the contact points, along any
direction."""
FIXED_RADIUS = 1e-6
"""Contact points with a larger condition number do not determine the sphere's radius."""
STEPS = 30
TWO_SIGMA = 0.97725


def no_doubt() -> NDArray[np.bool_]:
    """Doubts no contact point."""
    return np.zeros(0, np.bool_)


@dataclass(frozen=True)
class ProbedPlane:
    """A plane determined by N contact points; its normal points to the side of the probe."""

    nominal: NominalPlane
    """Its point is the middle of the contact points."""
    residuals_mm: Floats
    """(N,) of the contact points, outward."""
    covariance: Floats
    """(3, 3) of the height in the middle (mm) and the tilts (rad) along ``perpendicular_axes``."""
    outliers: NDArray[np.bool_]
    """(N,) contact points that contradict the others and are excluded."""
    doubtful: NDArray[np.bool_] = field(default_factory=no_doubt)
    """(N,) contact points of which one is off while nothing tells which; all are used."""

    @property
    def rms_mm(self) -> float:
        return _rms(self.residuals_mm[~self.outliers])

    @property
    def angle_sd_rad(self) -> float:
        """Standard uncertainty of the normal in its worst direction, k = 1."""
        return _worst(self.covariance[1:, 1:])

    def height_sd_mm(self, point_mm: Floats) -> float:
        """Standard uncertainty of the plane at a point (3,) of it, k = 1."""
        a, b = perpendicular_axes(self.nominal.normal)
        away = point_mm - self.nominal.point_mm
        g = np.array([1.0, away @ a, away @ b])
        return float(np.sqrt(g @ self.covariance @ g))


@dataclass(frozen=True)
class ProbedSphere:
    """A sphere of known size determined by N contact points."""

    nominal: NominalSphere
    residuals_mm: Floats
    """(N,) of the contact points, outward."""
    covariance: Floats
    """(3, 3) of the centre, mm²."""
    radius_mm: float
    """From the contact points alone, not from the certificate."""
    radius_sd_mm: float
    outliers: NDArray[np.bool_]
    """(N,) contact points that contradict the others and are excluded."""
    doubtful: NDArray[np.bool_] = field(default_factory=no_doubt)
    """(N,) contact points of which one is off while nothing tells which; all are used."""

    @property
    def rms_mm(self) -> float:
        return _rms(self.residuals_mm[~self.outliers])

    @property
    def centre_sd_mm(self) -> float:
        """In the worst direction, k = 1."""
        return _worst(self.covariance)


ProbedGauge = ProbedPlane | ProbedSphere


def fit_probed_plane(arm: AnyArm, readings: Floats) -> ProbedPlane:
    """The plane that the tip probed, with its uncertainty.

    Args:
        arm: its tip radius is subtracted; its encoder noise is a lower limit of the uncertainty.
        readings: (N, k) of the arm at the contact points, N >= ``PLANE_LEAST``.

    Returns:
        The plane in the arm frame, its normal towards the flange, with covariance (k = 1).

    Raises:
        OperationError: ``too-few-touches`` or ``touches-on-a-line``.
    """
    every = _tips(arm, readings, PLANE_LEAST, "plane")
    found = agree_on_plane(every, tip_covariances(arm, readings))
    tips, used = every[found.kept], readings[found.kept]
    middle = tips.mean(axis=0)
    values, vectors = np.linalg.eigh((tips - middle).T @ (tips - middle) / len(tips))
    if np.sqrt(values[1]) < LEAST_SPREAD_MM:
        raise OperationError(
            "touches-on-a-line",
            message("touches-lie-within-one-line", width=quantity(2 * np.sqrt(values[1]), "mm", 1)),
            message("they-fix-no-plane"),
            message("touch-near-corners-too"),
        )
    normal = vectors[:, 0]
    if float(np.mean((_flanges(arm, used) - tips) @ normal)) < 0:
        normal = -normal
    off = (every - middle) @ normal
    a, b = perpendicular_axes(normal)
    J = np.column_stack([np.ones(len(tips)), (tips - middle) @ a, (tips - middle) @ b])
    sd = _contact_sd(arm, used, off[found.kept], np.tile(normal, (len(tips), 1)), 3)
    nominal = NominalPlane(middle - tip_of(arm).radius_mm * normal, normal)
    covariance = sd**2 * np.linalg.inv(J.T @ J)
    return ProbedPlane(nominal, off, covariance, ~found.kept, found.doubtful)


def fit_probed_sphere(arm: AnyArm, readings: Floats, radius_mm: float) -> ProbedSphere:
    """The sphere of known radius that the tip probed, with its uncertainty.

    Args:
        arm: its tip radius is subtracted; its encoder noise is a lower limit of the uncertainty.
        readings: (N, k) of the arm at the contact points, N >= ``SPHERE_LEAST``.
        radius_mm: from the certificate.

    Returns:
        The sphere in the arm frame with the covariance of its centre (k = 1), and the radius that
        the contact points
        alone give.

    Raises:
        OperationError: ``too-few-touches`` or ``touches-too-close``.
    """
    found = agree_on_probed_sphere(arm, readings, radius_mm)
    sphere = fit_agreeing_sphere(arm, readings, radius_mm, found.kept)
    return replace(sphere, doubtful=found.doubtful)


def agree_on_probed_sphere(arm: AnyArm, readings: Floats, radius_mm: float) -> Agreement:
    """Which contact points, as those of ``fit_probed_sphere``, agree.

    Raises:
        OperationError: ``too-few-touches``.
    """
    tips = _tips(arm, readings, SPHERE_LEAST, "sphere")
    reach_mm = radius_mm + tip_of(arm).radius_mm
    return agree_on_sphere(tips, tip_covariances(arm, readings), reach_mm)


def fit_agreeing_sphere(
    arm: AnyArm, readings: Floats, radius_mm: float, kept: NDArray[np.bool_]
) -> ProbedSphere:
    """The same sphere by those contact points (N,) alone that are kept.

    Raises:
        OperationError: ``touches-too-close``.
    """
    every, reach_mm = tip_centres(arm, readings), radius_mm + tip_of(arm).radius_mm
    tips, used = every[kept], readings[kept]
    free, free_mm, J = sphere_through(tips)
    centre = _fit_centre(tips, reach_mm, free)
    far, outward = _outward(tips, centre)
    if float(np.linalg.eigvalsh(outward.T @ outward)[0]) < LEAST_FACING * len(tips):
        raise OperationError(
            "touches-too-close",
            message("touches-lie-too-near-together-one"),
            message("they-do-not-determine-centre"),
            message("touch-top-all-around-side"),
        )
    sd = _contact_sd(arm, used, far - reach_mm, outward, 3)
    return ProbedSphere(
        NominalSphere(centre, radius_mm),
        _outward(every, centre)[0] - reach_mm,
        np.asarray(sd**2 * np.linalg.inv(outward.T @ outward)),
        free_mm - tip_of(arm).radius_mm,
        _radius_sd_mm(arm, used, _outward(tips, free)[0] - free_mm, J),
        ~kept,
    )


def _radius_sd_mm(arm: AnyArm, readings: Floats, off: Floats, J: Floats) -> float:
    values, vectors = np.linalg.eigh(J.T @ J)
    if values[0] < FIXED_RADIUS * values[-1]:
        return float("inf")
    cofactor = float(np.sum(vectors[3] ** 2 / values))
    return _contact_sd(arm, readings, off, J[:, :3], 4) * float(np.sqrt(cofactor))


def _outward(tips: Floats, centre: Floats) -> tuple[Floats, Floats]:
    """Distances (N,) from a centre, and directions (N, 3)."""
    away = tips - centre
    far = np.linalg.norm(away, axis=1)
    return far, away / far[:, None]


def _tips(arm: AnyArm, readings: Floats, least: int, shape: str) -> Floats:
    if len(readings) < least:
        raise OperationError(
            "too-few-touches",
            message("has-touches", shape=shape, count=len(readings)),
            message("least-needed", least=least),
            message("touch-more-places"),
        )
    return tip_centres(arm, readings)


def _flanges(arm: AnyArm, readings: Floats) -> Floats:
    return np.asarray(flange_poses(arm, readings)[:, :3, 3])


def _contact_sd(
    arm: AnyArm, readings: Floats, off: Floats, outward: Floats, parameters: int
) -> float:
    """Standard uncertainty of one contact point, k = 1: from their scatter, corrected for their
    number, and at least that of the encoders."""
    from scipy.special import stdtrit  # slow to import, and seldom needed

    of_encoders = np.einsum("ni,nij,nj->n", outward, tip_covariances(arm, readings), outward)
    encoders = float(np.sqrt(np.mean(of_encoders)))
    freedom = len(off) - parameters
    if freedom < 1:
        return encoders
    scatter = float(np.sqrt(off @ off / freedom)) * float(stdtrit(freedom, TWO_SIGMA)) / 2
    return max(scatter, encoders)


def sphere_through(tips: Floats) -> tuple[Floats, float, Floats]:
    """Least-squares sphere through tip centres, without a filter, by Gauss-Newton.

    Args:
        tips: (N, 3) mm, N >= 4.

    Returns:
        Centre (3,) and radius in mm, and the Jacobian (N, 4) of the residuals.
    """
    system = np.column_stack([2 * tips, np.ones(len(tips))])
    start = np.linalg.lstsq(system, np.sum(tips**2, axis=1), rcond=None)[0]
    centre: Floats = start[:3]
    radius = float(np.sqrt(max(start[3] + centre @ centre, 1e-9)))
    for _ in range(STEPS):
        far, outward = _outward(tips, centre)
        J = np.column_stack([outward, np.ones(len(tips))])
        change = np.linalg.lstsq(J, far - radius, rcond=None)[0]
        centre, radius = centre + change[:3], radius + float(change[3])
    return centre, radius, J


def _fit_centre(tips: Floats, radius_mm: float, start: Floats) -> Floats:
    """Centre (3,) of the sphere of known radius that fits the tips best, by Gauss-Newton."""
    centre = start
    for _ in range(STEPS):
        far, outward = _outward(tips, centre)
        centre = centre + np.linalg.lstsq(outward, far - radius_mm, rcond=None)[0]
    return centre


def _rms(residuals: Floats) -> float:
    return float(np.sqrt(np.mean(residuals**2)))


def _worst(covariance: Floats) -> float:
    return float(np.sqrt(np.linalg.eigvalsh(covariance)[-1]))
