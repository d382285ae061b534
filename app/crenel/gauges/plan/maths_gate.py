"""Which points of a scan belong to the sphere: by a geometric gate fixed before the test.

No residual decides: only the distance from the calibrated sphere, the cone about its holder, and
the angle of incidence at which the sensor sees it.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.fitting.reference_sphere import sphere_centre
from crenel.metrology.transforms import Floats

SHELL_MM = 10.0
INCIDENCE_DEG = 60.0
CONE_DEG = 100.0
ROUNDS = 20


@dataclass(frozen=True)
class SphereGate:
    """The gate; every value is printed with the results."""

    shell_mm: float = SHELL_MM
    """Points this far inside or outside the calibrated sphere take part."""
    incidence_deg: float = INCIDENCE_DEG
    """Largest angle between the surface's normal and the view, from the calibrated sphere."""
    cone_deg: float = CONE_DEG
    """Points further than this from the pole, which is opposite to the holder, do not."""


@dataclass(frozen=True)
class GatedSphere:
    """The points of the sphere, and where it was found."""

    inside: NDArray[np.bool_]
    """(N,) of the points given."""
    centre_mm: Floats
    """(3,) of the calibrated sphere, by which the gate was placed."""


def within_gate(
    points_mm: Floats,
    views: Floats,
    diameter_mm: float,
    pole: Floats,
    centre_mm: Floats,
    gate: SphereGate,
) -> NDArray[np.bool_]:
    """Which points (N,) are within the gate about a sphere whose centre (3,) is known.

    Args:
        points_mm, views, diameter_mm, pole: as of ``gate_sphere``.
    """
    axis = np.asarray(pole) / np.linalg.norm(pole)
    away = points_mm - centre_mm
    distance = np.linalg.norm(away, axis=1)
    with np.errstate(invalid="ignore", divide="ignore"):
        outward = away / distance[:, None]
    inside = np.abs(distance - diameter_mm / 2) <= gate.shell_mm
    inside &= np.einsum("ij,ij->i", outward, views) >= np.cos(np.radians(gate.incidence_deg))
    inside &= outward @ axis >= np.cos(np.radians(gate.cone_deg))
    return np.asarray(inside)


def gate_sphere(
    points_mm: Floats,
    views: Floats,
    diameter_mm: float,
    pole: Floats,
    start_mm: Floats,
    gate: SphereGate = SphereGate(),
) -> GatedSphere:
    """The points of the sphere in a scan.

    The calibrated sphere is placed by the points within the gate, and the gate by that sphere,
    until the selection stays.

    Args:
        points_mm: (N, 3), arm frame.
        views: (N, 3) unit directions from each point to the camera.
        diameter_mm: calibrated.
        pole: (3,) away from the holder.
        start_mm: (3,) about where its centre is, within half a radius.
    """
    centre, inside = np.asarray(start_mm), np.zeros(len(points_mm), dtype=np.bool_)
    for _ in range(ROUNDS):
        now = within_gate(points_mm, views, diameter_mm, pole, centre, gate)
        if now.sum() < 4 or np.array_equal(now, inside):
            break
        inside = now
        centre = sphere_centre(points_mm[inside], diameter_mm)
    return GatedSphere(inside, centre)
