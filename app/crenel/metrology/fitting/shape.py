"""Standard uncertainty of a fitted shape's parameters, from the scatter of the scan itself.

Points of one frame share the error of the frame, and adjacent frames share the error of the arm;
treated as independent, a million points would suggest nanometres. The points are therefore grouped
in runs of consecutive frames, and the covariance is that of clustered residuals (Liang and Zeger,
1986): only the contributions of different runs are independent.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.fitting.cylinder import (
    CylinderFit,
    cylinder_distances,
    cylinder_jacobian,
    fit_cylinder,
    perpendicular_axes,
)
from crenel.metrology.fitting.plane_sphere import PlaneFit, SphereFit, fit_plane, fit_sphere
from crenel.metrology.transforms import Floats

MOST_RUNS = 12
FEWEST_RUNS = 10


def parameter_covariance(
    jacobian: Floats, residuals: Floats, frame: NDArray[np.int64]
) -> Floats | None:
    """Covariance of least-squares parameters (k = 1) from the scatter between runs of frames.

    Points of one frame share the error of the frame, and adjacent frames share that of the arm.
    Residuals are therefore treated as independent only between runs of consecutive frames.

    Args:
        jacobian: (N, p) derivatives of the residuals by the parameters.
        residuals: (N,) at the least-squares solution.
        frame: (N,) frame number of each point, in order of time.

    Returns:
        (p, p); None if the points come from too few frames.

    Source:
        Clustered residuals: Liang and Zeger (1986).
    """
    numbers, of_frame = np.unique(frame, return_inverse=True)
    parameters = jacobian.shape[1]
    runs = min(MOST_RUNS, len(numbers))
    if runs < max(FEWEST_RUNS, parameters + 2):
        return None
    # with about equally many points each
    points_before = np.concatenate([[0], np.cumsum(np.bincount(of_frame))[:-1]])
    run_of_frame = np.minimum(points_before * runs // len(residuals), runs - 1)
    run = np.unique(run_of_frame, return_inverse=True)[1][of_frame]
    runs = int(run.max()) + 1
    if runs < max(FEWEST_RUNS, parameters + 2):
        return None
    pull = np.column_stack([np.bincount(run, column * residuals, runs) for column in jacobian.T])
    inverse = np.linalg.inv(jacobian.T @ jacobian)
    # one parameter each makes the scatter of the runs look smaller than it is
    return np.asarray(runs / (runs - parameters) * (inverse @ (pull.T @ pull) @ inverse))


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
    """Rms of the distances of the points used."""
    covariance: Floats | None
    """None with too few frames."""

    def distances(self, points_mm: Floats) -> Floats:
        """Signed distances (N,) in mm of points (N, 3)."""
        return distances_from(self.fit, points_mm)


def measure_shape(
    name: ShapeName,
    points_mm: Floats,
    frame: NDArray[np.int64],
    seen_from_mm: Floats | None = None,
) -> MeasuredShape:
    """Fits a shape to the points of a scan, with the covariance of its parameters.

    Args:
        name: ``plane``, ``sphere`` or ``cylinder``.
        points_mm: (N, 3) in any frame.
        frame: (N,) frame number of each point, in order of time.
        seen_from_mm: (3,) a place outside, to whose side the normal of a plane points; None: its
            largest component is positive.

    Returns:
        The fit in the same frame; its covariance is None with too few frames.

    Raises:
        OperationError: as ``fit_plane``, ``fit_sphere`` and ``fit_cylinder``.
    """
    fit: PlaneFit | SphereFit | CylinderFit
    if name == "plane":
        fit = _turn_outward(fit_plane(points_mm), seen_from_mm)
    elif name == "sphere":
        fit = fit_sphere(points_mm)
    else:
        fit = fit_cylinder(points_mm)
    points = points_mm[fit.used]
    off = distances_from(fit, points)
    covariance = parameter_covariance(shape_jacobian(fit, points), off, frame[fit.used])
    return MeasuredShape(name, fit, float(np.max(np.abs(off))), covariance)


def distances_from(fit: PlaneFit | SphereFit | CylinderFit, points_mm: Floats) -> Floats:
    """Signed distances of points from a fitted shape.

    Args:
        fit: a plane, sphere or cylinder.
        points_mm: (N, 3) in the frame of the fit.

    Returns:
        (N,) mm; positive outside, or on the side of the plane's normal.
    """
    if isinstance(fit, PlaneFit):
        return np.asarray(points_mm @ fit.normal - fit.offset_mm)
    if isinstance(fit, SphereFit):
        return np.asarray(np.linalg.norm(points_mm - fit.centre_mm, axis=1) - fit.radius_mm)
    axis = np.concatenate([fit.point_mm, fit.direction])
    return cylinder_distances(points_mm, (axis, fit.radius_mm))


def shape_jacobian(fit: PlaneFit | SphereFit | CylinderFit, points_mm: Floats) -> Floats:
    """Derivatives (N, p) of the distances by the parameters.

    Args:
        fit: a plane, sphere or cylinder.
        points_mm: (N, 3) in the frame of the fit.

    Returns:
        In mm per mm and per rad; the parameters are those of ``MeasuredShape``.
    """
    if isinstance(fit, PlaneFit):
        a, b = perpendicular_axes(fit.normal)
        away = points_mm - fit.centre_mm
        return np.column_stack([-np.ones(len(away)), away @ a, away @ b])
    if isinstance(fit, SphereFit):
        away = points_mm - fit.centre_mm
        outward = away / np.linalg.norm(away, axis=1)[:, None]
        return np.column_stack([-outward, -np.ones(len(away))])
    return cylinder_jacobian(points_mm, np.concatenate([fit.point_mm, fit.direction]))


def _turn_outward(fit: PlaneFit, seen_from_mm: Floats | None) -> PlaneFit:
    """The plane with its normal to the side of a place, or else with the largest component of its
    normal positive, so that equal planes have equal values."""
    if seen_from_mm is None:
        is_outward = bool(fit.normal[np.argmax(np.abs(fit.normal))] > 0)
    else:
        is_outward = float(fit.normal @ seen_from_mm) >= fit.offset_mm
    if is_outward:
        return fit
    return PlaneFit(-fit.normal, -fit.offset_mm, fit.centre_mm, fit.rms_mm, fit.form_mm, fit.used)
