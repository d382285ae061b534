"""What small movements of a sphere's points make of its figures, by geometry alone.

Independent of the evaluation: to first order, over the 25 places of the pattern.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from crenel.gauges.plan.maths_gate import INCIDENCE_DEG
from crenel.gauges.sphere.maths_location import smallest_enclosing_sphere
from crenel.gauges.sphere.maths_pattern import pattern_directions
from crenel.metrology.transforms import Floats
from tests.bench.metrology.rendered_sphere import RenderedStation
from tests.bench.metrology.synthetic_sphere import POLE

PointMovement = Callable[[Floats, Floats], Floats]
"""The movement (3,) mm of a point (3,) that is measured with the sensor in a pose (4, 4)."""


@dataclass(frozen=True)
class SphereEffect:
    """What a movement makes of the figures by scan, without noise."""

    location_um: float
    size_um: float
    """Of the sphere through 25 places."""


def sphere_change(outward: Floats, moves_mm: Floats) -> Floats:
    """The change (4,) mm of centre and radius of a least-squares sphere.

    Args:
        outward: (N, 3) directions of its points.
        moves_mm: (N, 3) movements of these points.
    """
    J = np.column_stack([outward, np.ones(len(outward))])
    along = np.einsum("ij,ij->i", outward, moves_mm)
    return np.asarray(np.linalg.lstsq(J, along, rcond=None)[0])


def scan_effect(station: RenderedStation, movement: PointMovement) -> SphereEffect:
    """The effect on the five scans of a station."""
    outward = pattern_directions(POLE)
    points = station.centre_mm + station.radius_mm * outward
    n, offset_mm = np.array(station.rig.light_plane.normal), station.rig.light_plane.offset_mm
    centres, along = [], np.full((len(station.scans), len(outward)), np.nan)
    for number, scan in enumerate(station.scans):
        T = scan.T_arm_sensor
        normals = T[:, :3, :3] @ n
        off = np.einsum("fi,ki->fk", normals, points)
        off -= (offset_mm + np.einsum("fi,fi->f", normals, T[:, :3, 3]))[:, None]
        lit = T[np.argmin(np.abs(off), axis=0)]
        views = lit[:, :3, :3] @ station.rig.optics.centre_mm + lit[:, :3, 3] - points
        views /= np.linalg.norm(views, axis=1)[:, None]
        seen = np.einsum("ki,ki->k", views, outward) > np.cos(np.radians(INCIDENCE_DEG))
        moves = np.array([movement(*pair) for pair in zip(lit, points, strict=True)])
        centres.append(sphere_change(outward[seen], moves[seen])[:3])
        along[number, seen] = np.einsum("ki,ki->k", moves, outward)[seen]
    J = np.column_stack([outward, np.ones(len(outward))])
    whole = np.linalg.lstsq(J, np.nanmean(along, axis=0), rcond=None)[0]
    location_mm = smallest_enclosing_sphere(np.array(centres)).diameter_mm
    return SphereEffect(1e3 * location_mm, 2e3 * float(whole[3]))
