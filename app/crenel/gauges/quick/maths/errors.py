"""How well clouds of gauges agree with their nominals: the article's figures (Eq. 10-12)."""

from dataclasses import dataclass

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.metrology.fitting.plane_sphere import PlaneFit, SphereFit, fit_plane, fit_sphere
from crenel.metrology.transforms import Floats

ARCSEC_PER_RAD = 180 / np.pi * 3600


@dataclass(frozen=True)
class NominalPlane:
    """A gauge plane from its certificate or from probing, in the arm frame."""

    point_mm: Floats  # (3,)
    normal: Floats  # (3,) unit length

    @property
    def offset_mm(self) -> float:
        return float(self.normal @ self.point_mm)


@dataclass(frozen=True)
class NominalSphere:
    """A gauge sphere from its certificate or from probing, in the arm frame."""

    centre_mm: Floats  # (3,)
    radius_mm: float


@dataclass(frozen=True)
class PlaneCheck:
    """A scanned plane, and its errors relative to the nominal, if there is one."""

    fit: PlaneFit
    angle_arcsec: float | None = None
    """Angle between the normals (Eq. 10)."""
    z_error_um: float | None = None
    """``Z_N - Z`` of the cloud's centre projected along Z on both planes (Eq. 11-12); None if a
    plane is too steep for a projection along Z."""
    offset_um: float | None = None
    """Distance of the cloud's centre from the nominal plane, along its normal."""


@dataclass(frozen=True)
class SphereCheck:
    """A scanned sphere, and its errors relative to the nominal, if there is one."""

    fit: SphereFit
    radius_error_um: float | None = None
    """Nominal minus measured, as in section 4 of the article."""
    centre_error_um: float | None = None
    """Distance between the centres."""


def check_plane(points_mm: Floats, nominal: NominalPlane | None = None) -> PlaneCheck:
    """Fits a plane to a cloud and compares it with the nominal.

    Args:
        points_mm: (N, 3), arm frame; NaN points are never used.
        nominal: None if only the fit is wanted.

    Returns:
        The fit, its normal towards the side of the nominal's, and the errors in arcsec and µm.

    Raises:
        OperationError: as ``fit_plane``.

    Source:
        Eq. 10 to 12 of the article.

    Example:
        >>> x, y = (axis.ravel() for axis in np.meshgrid(np.arange(9.0), np.arange(9.0)))
        >>> cloud = np.column_stack([x, y, np.full(81, 0.002)])
        >>> nominal = NominalPlane(np.zeros(3), np.array([0.0, 0.0, 1.0]))
        >>> round(check_plane(cloud, nominal).offset_um, 6)
        2.0
    """
    fit = fit_plane(points_mm)
    if nominal is None:
        return PlaneCheck(fit)
    if float(fit.normal @ nominal.normal) < 0:
        fit = PlaneFit(
            -fit.normal, -fit.offset_mm, fit.centre_mm, fit.rms_mm, fit.form_mm, fit.used
        )
    return compare_plane(fit, nominal)


def compare_plane(fit: PlaneFit, nominal: NominalPlane) -> PlaneCheck:
    """The errors of a fitted plane relative to its nominal; the signs of the normals do not matter.

    Args:
        fit, nominal: in the same frame.

    Source:
        Eq. 10 to 12 of the article.
    """
    return PlaneCheck(
        fit=fit,
        angle_arcsec=angle_between_rad(fit.normal, nominal.normal) * ARCSEC_PER_RAD,
        z_error_um=_z_error_um(fit, nominal),
        offset_um=(float(nominal.normal @ fit.centre_mm) - nominal.offset_mm) * 1e3,
    )


def check_sphere(points_mm: Floats, nominal: NominalSphere | None = None) -> SphereCheck:
    """Fits a sphere to a cloud and compares it with the nominal.

    Args:
        points_mm: (N, 3), arm frame; NaN points are never used.
        nominal: None if only the fit is wanted.

    Returns:
        The fit, and the errors in µm: nominal minus measured radius, distance of the centres.

    Raises:
        OperationError: as ``fit_sphere``.

    Source:
        The article, section 4 and Fig. 11.
    """
    fit = fit_sphere(points_mm)
    if nominal is None:
        return SphereCheck(fit)
    return SphereCheck(
        fit=fit,
        radius_error_um=(nominal.radius_mm - fit.radius_mm) * 1e3,
        centre_error_um=float(np.linalg.norm(fit.centre_mm - nominal.centre_mm)) * 1e3,
    )


def angle_between_rad(a: Floats, b: Floats) -> float:
    """Angle between two planes by their normals, whose signs do not matter.

    Args:
        a, b: (3,) unit length.

    Returns:
        Rad, 0 to pi/2.

    Source:
        Eq. 10 of the article, by the arctangent: the arccosine loses half the digits near zero.

    Example:
        >>> angle_between_rad(np.array([0.0, 0.0, 1.0]), np.array([0.0, 1e-9, -1.0]))
        1e-09
    """
    return float(np.arctan2(np.linalg.norm(np.cross(a, b)), abs(float(a @ b))))


def _z_error_um(fit: PlaneFit, nominal: NominalPlane) -> float | None:
    if min(abs(fit.normal[2]), abs(nominal.normal[2])) < 0.05:
        return None
    x, y, _ = fit.centre_mm
    z_nominal = (nominal.offset_mm - nominal.normal[0] * x - nominal.normal[1] * y) / (
        nominal.normal[2]
    )
    z_measured = (fit.offset_mm - fit.normal[0] * x - fit.normal[1] * y) / fit.normal[2]
    return float(z_nominal - z_measured) * 1e3


@dataclass(frozen=True)
class Repeatability:
    """The scatter of a figure over several clouds (article, Fig. 7-10)."""

    mean: float
    standard_deviation: float
    range: float


def compute_repeatability(values: list[float]) -> Repeatability:
    """Mean, standard deviation (n - 1) and range of a figure over several clouds.

    Args:
        values: one per cloud, at least two, in one unit.

    Raises:
        OperationError: ``too-few-clouds``.

    Source:
        The article, Fig. 7 to 10.

    Example:
        >>> compute_repeatability([1.0, 2.0, 3.0])
        Repeatability(mean=2.0, standard_deviation=1.0, range=2.0)
    """
    if len(values) < 2:
        raise OperationError("too-few-clouds", message("spread-needs-least-two-clouds"))
    return Repeatability(
        float(np.mean(values)), float(np.std(values, ddof=1)), max(values) - min(values)
    )


def angle_ranges_arcsec(normals: Floats) -> Floats:
    """The largest angle between any two of several normals, for several planes at once.

    Args:
        normals: (C, K, 3) unit normals of C clouds for K planes, with consistent signs.

    Returns:
        (K,) arcsec.
    """
    apart = np.linalg.norm(normals[:, None] - normals[None], axis=3)
    return np.asarray(2 * np.arcsin((apart / 2).clip(0, 1)).max(axis=(0, 1)) * ARCSEC_PER_RAD)


def offset_ranges_um(offsets_mm: Floats) -> Floats:
    """Largest minus smallest offset over several clouds, for several planes at once.

    Args:
        offsets_mm: (C, K) of C clouds for K planes.

    Returns:
        (K,) µm.
    """
    return np.asarray(1e3 * np.ptp(offsets_mm, axis=0))
