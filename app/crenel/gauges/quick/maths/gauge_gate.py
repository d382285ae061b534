"""Form of a gauge over all points of a geometric gate, beside the filtered one.

No residual and no visit decides which points count: for a sphere, the distance from the calibrated
sphere; for a plane, the scanned area and the distance from the plane.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull, QhullError

from crenel.gauges.plan.maths_gate import SphereGate, gate_sphere
from crenel.gauges.plane.maths import least_squares_plane
from crenel.gauges.quick.maths.figure_uncertainty import range_sd, zone_sd
from crenel.metrology.fitting.cylinder import perpendicular_axes
from crenel.metrology.fitting.plane_sphere import PlaneFit, SphereFit
from crenel.metrology.fitting.reference_sphere import dispersion_mm, least_squares_sphere
from crenel.metrology.transforms import Floats

GATE_MM = 3.0
"""Points this far from the calibrated sphere, or from the plane, take part; what is further off
belongs to something else."""
CONE_DEG = 100.0
"""The cone of a sphere from the direction that its scan faces; beyond are its holder and the
table."""
EVERY_VIEW_DEG = 180.0


@dataclass(frozen=True)
class UnfilteredForm:
    """What all points of the gate are off their own least-squares shape."""

    points: int
    dispersion_mm: float
    """Width of the narrowest zone about the shape that holds 95 % of them."""
    range_mm: float
    """Largest minus smallest distance."""
    inside: NDArray[np.bool_]
    """(N,) the points of the gate, of the points given."""
    off_mm: Floats
    """(points,) their distances from their own shape; outward is positive."""
    range_sd_mm: float
    """Its standard uncertainty, by the scatter of the points."""
    dispersion_sd_mm: float


def sphere_form(points_mm: Floats, fit: SphereFit, radius_mm: float) -> UnfilteredForm:
    """Form of a scanned sphere over all points of the gate.

    Args:
        points_mm: (N, 3), arm frame, without NaN; of the whole cloud.
        fit: of the sphere, about which the gate is placed; its middle is where the cone points.
        radius_mm: from the certificate.

    Source:
        ISO 10360-8: probing form and dispersion, over all points.
    """
    near = np.abs(np.linalg.norm(points_mm - fit.centre_mm, axis=1) - radius_mm) <= GATE_MM
    outward = points_mm[near] - fit.centre_mm
    outward /= np.linalg.norm(outward, axis=1)[:, None]
    pole = _facing(outward)
    gate = SphereGate(GATE_MM, EVERY_VIEW_DEG, CONE_DEG)
    views = np.zeros_like(points_mm)  # the gate takes every angle of incidence
    found = gate_sphere(points_mm, views, 2 * radius_mm, pole, fit.centre_mm, gate)
    inside = found.inside
    sphere = least_squares_sphere(points_mm[inside])
    distances = np.linalg.norm(points_mm[inside] - sphere.centre_mm, axis=1)
    return UnfilteredForm(
        int(inside.sum()),
        dispersion_mm(distances),
        float(np.ptp(distances)),
        inside,
        distances - sphere.diameter_mm / 2,
        range_sd(distances),
        zone_sd(distances, dispersion_mm),
    )


def plane_form(points_mm: Floats, fit: PlaneFit, used_mm: Floats) -> UnfilteredForm:
    """Form of a scanned plane over all points of the gate.

    Args:
        points_mm: (N, 3), arm frame, without NaN; of the whole cloud.
        fit: of the plane.
        used_mm: (M, 3) points of the fit, whose outline is the scanned area.

    Source:
        ISO 10360-8: flat form, over all points.
    """
    inside = np.abs(points_mm @ fit.normal - fit.offset_mm) <= GATE_MM
    inside[inside] = _within_area(points_mm[inside], used_mm, fit)
    plane = least_squares_plane(points_mm[inside])
    outward = plane.normal if plane.normal @ fit.normal > 0 else -plane.normal
    off_mm = (points_mm[inside] - plane.centre_mm) @ outward
    return UnfilteredForm(
        int(inside.sum()),
        plane.dispersion_mm,
        plane.form_mm,
        inside,
        off_mm,
        range_sd(off_mm),
        zone_sd(off_mm, dispersion_mm),
    )


def _facing(outward: Floats) -> Floats:
    middle: Floats = outward.mean(axis=0)
    length = float(np.linalg.norm(middle))
    return middle / length if length > 1e-9 else np.array([0.0, 0.0, 1.0])


def _within_area(points_mm: Floats, used_mm: Floats, fit: PlaneFit) -> NDArray[np.bool_]:
    """(N,) points whose foot lies within the convex outline of the points used."""
    axes = np.stack(perpendicular_axes(fit.normal), axis=1)
    try:
        outline = ConvexHull((used_mm - fit.centre_mm) @ axes)
    except QhullError:  # all on one line, which the fit has already refused
        return np.ones(len(points_mm), dtype=np.bool_)
    feet = (points_mm - fit.centre_mm) @ axes
    inside = np.ones(len(feet), dtype=np.bool_)
    for a, b, offset in outline.equations:
        inside &= a * feet[:, 0] + b * feet[:, 1] + offset <= 1e-9
    return inside
