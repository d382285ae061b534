"""Shapes fitted to points selected in the 3D view: their figures, and their drawing."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from crenel.gauges.quick.maths.errors import ARCSEC_PER_RAD
from crenel.messages.message import Text, message
from crenel.metrology.fitting.cylinder import CylinderFit, perpendicular_axes
from crenel.metrology.fitting.plane_sphere import PlaneFit, SphereFit
from crenel.metrology.fitting.shape import MeasuredShape, ShapeName
from crenel.metrology.transforms import Floats
from crenel.station.view3d.meshes import Mesh, ball, flat_mesh, tube

UM_PER_MM = 1e3
MARGIN = 0.04
"""A drawn shape extends beyond the fitted points by this."""


@dataclass(frozen=True)
class ShapeParameter:
    """A value with the scatter of the scan in it, k = 1; None if it is unknown. It is no
    uncertainty: errors of the calibration and of the arm are the same in all points."""

    label: Text
    value: float
    unit: str
    decimals: int
    scatter: float | None = None
    scatter_unit: str = ""


@dataclass(frozen=True)
class FittedShape:
    """The fitted shape as the operator reads it."""

    id: int
    shape: ShapeName
    points: int
    """Number of points that the fit used."""
    picked: int
    """Number of points in the region, from which the fitted ones were evenly selected."""
    every: bool
    """From all points of the scans, and not only from those that are shown."""
    rms_um: float
    largest_um: float
    form_um: float
    figures: tuple[ShapeParameter, ...]


def shape_parameters(measured: MeasuredShape) -> tuple[ShapeParameter, ...]:
    """The parameters of the shape, the most important first."""
    fit, known = measured.fit, _Scatter(measured.covariance)
    if isinstance(fit, PlaneFit):
        upright = float(np.arccos(np.clip(abs(fit.normal[2]), 0.0, 1.0)))
        # known at the middle of its points, and from there by its tilts to the arm's origin
        lever = np.array(
            [1.0, *(float(side @ fit.centre_mm) for side in perpendicular_axes(fit.normal))]
        )
        return (
            ShapeParameter(
                message("arms-zero"), fit.offset_mm, "mm", 3, known.along_um(lever), "µm"
            ),
            _angle(message("tilt-level"), upright, known.angle_arcsec(1)),
            *_vector(lambda axis: message("normal-component", axis=axis), fit.normal),
        )
    if isinstance(fit, SphereFit):
        return (
            ShapeParameter(message("diameter"), 2 * fit.radius_mm, "mm", 3, known.um(3, 2.0), "µm"),
            *(
                ShapeParameter(
                    message("centre", axis=axis),
                    float(fit.centre_mm[i]),
                    "mm",
                    3,
                    known.um(i),
                    "µm",
                )
                for i, axis in enumerate("XYZ")
            ),
        )
    level = float(np.arcsin(np.clip(abs(fit.direction[2]), 0.0, 1.0)))
    return (
        ShapeParameter(message("diameter"), 2 * fit.radius_mm, "mm", 3, known.um(4, 2.0), "µm"),
        _angle(message("axis-level"), level, known.angle_arcsec(2)),
        *_vector(lambda axis: message("axis-component", axis=axis), fit.direction),
    )


class _Scatter:
    """The scatter by the covariance of a fit, if there is one."""

    def __init__(self, covariance: Floats | None) -> None:
        self._covariance = covariance

    def um(self, parameter: int, factor: float = 1.0) -> float | None:
        """That of a length."""
        if self._covariance is None:
            return None
        return factor * UM_PER_MM * float(np.sqrt(self._covariance[parameter, parameter]))

    def along_um(self, gradient: Floats) -> float | None:
        """That of a length with these derivatives by the parameters (p,)."""
        if self._covariance is None:
            return None
        return UM_PER_MM * float(np.sqrt(gradient @ self._covariance @ gradient))

    def angle_arcsec(self, first: int) -> float | None:
        """That of a direction with two tilts, in its worst direction."""
        if self._covariance is None:
            return None
        tilts = self._covariance[first : first + 2, first : first + 2]
        return ARCSEC_PER_RAD * float(np.sqrt(np.linalg.eigvalsh(tilts)[-1]))


def _angle(label: Text, angle_rad: float, known_arcsec: float | None) -> ShapeParameter:
    return ShapeParameter(label, float(np.degrees(angle_rad)), "°", 3, known_arcsec, "″")


def _vector(label: Callable[[str], Text], direction: Floats) -> tuple[ShapeParameter, ...]:
    return tuple(
        ShapeParameter(label(axis), float(direction[i]), "", 5) for i, axis in enumerate("XYZ")
    )


def shape_mesh(measured: MeasuredShape, points_mm: Floats) -> Mesh:
    """The shape as fitted to points (N, 3), slightly larger."""
    fit = measured.fit
    used = points_mm[fit.used]
    if isinstance(fit, SphereFit):
        return ball(fit.centre_mm, fit.radius_mm)
    if isinstance(fit, CylinderFit):
        along = (used - fit.point_mm) @ fit.direction
        low, high = _reach(along)
        ends = fit.point_mm + np.outer([low, high], fit.direction)
        return tube(ends[0], ends[1], fit.radius_mm, fit.radius_mm)
    a, b = _main_directions(used, fit)
    low_a, high_a = _reach((used - fit.centre_mm) @ a)
    low_b, high_b = _reach((used - fit.centre_mm) @ b)
    foot = fit.centre_mm - fit.normal * float(fit.normal @ fit.centre_mm - fit.offset_mm)
    corners = [(low_a, low_b), (high_a, low_b), (high_a, high_b), (low_a, high_b)]
    return flat_mesh(np.array([foot + u * a + v * b for u, v in corners]))


def _main_directions(points: Floats, fit: PlaneFit) -> tuple[Floats, Floats]:
    """In the plane, along and across the points."""
    a, b = perpendicular_axes(fit.normal)
    flat = (points - fit.centre_mm) @ np.column_stack([a, b])
    vectors = np.linalg.eigh(flat.T @ flat)[1]
    return vectors[0, 1] * a + vectors[1, 1] * b, vectors[0, 0] * a + vectors[1, 0] * b


def _reach(along: Floats) -> tuple[float, float]:
    low, high = (float(x) for x in np.percentile(along, [0.2, 99.8]))
    margin = MARGIN * (high - low)
    return low - margin, high + margin
