"""How well clouds of gauges agree with their nominals: the paper's figures (Eq. 10-12)."""

from dataclasses import dataclass

import numpy as np

from app.errors import OperationError
from app.metrology.fitting.plane_sphere import PlaneFit, SphereFit, fit_plane, fit_sphere
from app.metrology.transforms import Floats

ARCSEC_PER_RAD = 180 / np.pi * 3600


@dataclass(frozen=True)
class NominalPlane:
    """A gauge plane as known beforehand, in the arm frame."""

    point_mm: Floats  # (3,)
    normal: Floats  # (3,) unit length

    @property
    def offset_mm(self) -> float:
        return float(self.normal @ self.point_mm)


@dataclass(frozen=True)
class NominalSphere:
    """A gauge sphere as known beforehand, in the arm frame."""

    centre_mm: Floats  # (3,)
    radius_mm: float


@dataclass(frozen=True)
class PlaneCheck:
    """A scanned plane, and its errors against the nominal where there is one."""

    fit: PlaneFit
    angle_arcsec: float | None = None
    """Angle between the normals (Eq. 10)."""
    z_error_um: float | None = None
    """``Z_N - Z`` of the cloud's centre projected along Z on both planes (Eq. 11-12);
    None where a plane stands too steeply for a projection along Z."""
    offset_um: float | None = None
    """Distance of the cloud's centre from the nominal plane, along its normal."""


@dataclass(frozen=True)
class SphereCheck:
    """A scanned sphere, and its errors against the nominal where there is one."""

    fit: SphereFit
    radius_error_um: float | None = None
    """Nominal minus measured, as the paper's section 4 has it."""
    centre_error_um: float | None = None
    """Distance between the centres."""


def check_plane(points_mm: Floats, nominal: NominalPlane | None = None) -> PlaneCheck:
    """Fits a plane to a cloud (N, 3) and compares it with the nominal (Eq. 10-12).

    Raises:
        Refusal: see ``primitives.fit_plane``.
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
    """A fitted plane against its nominal (Eq. 10-12); the normals' senses do not matter."""
    return PlaneCheck(
        fit=fit,
        angle_arcsec=angle_between_rad(fit.normal, nominal.normal) * ARCSEC_PER_RAD,
        z_error_um=_z_error_um(fit, nominal),
        offset_um=(float(nominal.normal @ fit.centre_mm) - nominal.offset_mm) * 1e3,
    )


def check_sphere(points_mm: Floats, nominal: NominalSphere | None = None) -> SphereCheck:
    """Fits a sphere to a cloud (N, 3) and compares it with the nominal (paper, Fig. 11).

    Raises:
        Refusal: see ``primitives.fit_sphere``.
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
    """Angle in [0, pi/2] between two normals (3,) whose signs do not matter (Eq. 10).

    By the arctangent: the arccosine of Eq. 10 loses half the digits near zero.
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
    """How far a figure scatters over several clouds (paper, Fig. 7-10)."""

    mean: float
    standard_deviation: float
    range: float


def compute_repeatability(values: list[float]) -> Repeatability:
    """Mean, standard deviation (n - 1) and range of a figure over two or more clouds."""
    if len(values) < 2:
        raise OperationError("too-few-clouds", "a spread needs at least two clouds")
    return Repeatability(
        float(np.mean(values)), float(np.std(values, ddof=1)), max(values) - min(values)
    )


def angle_ranges_arcsec(normals: Floats) -> Floats:
    """The largest angle (K,) between any two of the C normals (C, K, 3), of one sense."""
    apart = np.linalg.norm(normals[:, None] - normals[None], axis=3)
    return np.asarray(2 * np.arcsin((apart / 2).clip(0, 1)).max(axis=(0, 1)) * ARCSEC_PER_RAD)


def offset_ranges_um(offsets_mm: Floats) -> Floats:
    """Largest minus smallest (K,) of the C offsets (C, K)."""
    return np.asarray(1e3 * np.ptp(offsets_mm, axis=0))
