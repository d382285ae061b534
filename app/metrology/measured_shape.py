"""A plane, sphere or cylinder measured on part of a scan: the fit, and how well it is known."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from app.metrology.cylinder import (
    CylinderFit,
    across,
    cylinder_distances,
    cylinder_jacobian,
    fit_cylinder,
)
from app.metrology.fit_uncertainty import parameter_covariance
from app.metrology.frames import Floats
from app.metrology.primitives import PlaneFit, SphereFit, fit_plane, fit_sphere

ShapeName = Literal["plane", "sphere", "cylinder"]


@dataclass(frozen=True)
class MeasuredShape:
    """A fitted shape, with the covariance of its parameters, k = 1.

    In mm and rad; of a plane: the shift along its normal and two tilts; of a sphere: its
    centre and its radius; of a cylinder: two shifts, two tilts, and its radius.
    """

    name: ShapeName
    fit: PlaneFit | SphereFit | CylinderFit
    largest_mm: float
    """Of the distances of the points used."""
    covariance: Floats | None
    """None where too few frames took part to tell."""

    def distances(self, points_mm: Floats) -> Floats:
        """Signed distances (N,) in mm of points (N, 3)."""
        return distances_from(self.fit, points_mm)


def measure_shape(name: ShapeName, points_mm: Floats, frame: NDArray[np.int64]) -> MeasuredShape:
    """Fits a shape to points (N, 3) that came from frames (N,); see ``primitives``.

    Raises:
        Refusal: too few points, or points that fix no such shape.
    """
    fit: PlaneFit | SphereFit | CylinderFit
    if name == "plane":
        fit = _facing_up(fit_plane(points_mm))
    elif name == "sphere":
        fit = fit_sphere(points_mm)
    else:
        fit = fit_cylinder(points_mm)
    points = points_mm[fit.used]
    off = distances_from(fit, points)
    covariance = parameter_covariance(_jacobian(fit, points), off, frame[fit.used])
    return MeasuredShape(name, fit, float(np.max(np.abs(off))), covariance)


def distances_from(fit: PlaneFit | SphereFit | CylinderFit, points_mm: Floats) -> Floats:
    """Signed distances (N,) in mm; outside, or on the normal's side, is positive."""
    if isinstance(fit, PlaneFit):
        return np.asarray(points_mm @ fit.normal - fit.offset_mm)
    if isinstance(fit, SphereFit):
        return np.asarray(np.linalg.norm(points_mm - fit.centre_mm, axis=1) - fit.radius_mm)
    axis = np.concatenate([fit.point_mm, fit.direction])
    return cylinder_distances(points_mm, (axis, fit.radius_mm))


def _jacobian(fit: PlaneFit | SphereFit | CylinderFit, points_mm: Floats) -> Floats:
    """Change (N, p) of the distances with the parameters."""
    if isinstance(fit, PlaneFit):
        a, b = across(fit.normal)
        away = points_mm - fit.centre_mm
        return np.column_stack([-np.ones(len(away)), away @ a, away @ b])
    if isinstance(fit, SphereFit):
        away = points_mm - fit.centre_mm
        outward = away / np.linalg.norm(away, axis=1)[:, None]
        return np.column_stack([-outward, -np.ones(len(away))])
    return cylinder_jacobian(points_mm, np.concatenate([fit.point_mm, fit.direction]))


def _facing_up(fit: PlaneFit) -> PlaneFit:
    """With the normal's largest part positive, so that the same plane reads the same."""
    if fit.normal[np.argmax(np.abs(fit.normal))] > 0:
        return fit
    return PlaneFit(-fit.normal, -fit.offset_mm, fit.centre_mm, fit.rms_mm, fit.form_mm, fit.used)
