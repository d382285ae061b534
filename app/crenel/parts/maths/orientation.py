"""Orientation deviations: how wide a zone, oriented by a datum, holds a feature along its extent.

The feature is the associated one, by least squares, and not the surface itself: after ISO 1101,
whose zone holds the surface.
"""

import numpy as np

from crenel.metrology.transforms import Floats
from crenel.parts.maths.shapes import Shape

ALONG_COSINE = float(np.cos(np.deg2rad(0.5)))
"""Nominal directions are taken as parallel if they are so close to it."""


def is_along_datum(nominal: Shape, datum: Shape) -> bool:
    """Whether directions of a feature and its datum are parallel by design: both of its tilts then
    count, else only the one in their common plane."""
    return abs(float(nominal.direction @ datum.direction)) > ALONG_COSINE


def orientation_deviation(
    nominal: Shape, found: Shape, extent_mm: Floats, nominal_datum: Shape, datum: Shape
) -> Floats:
    """The width (1,) of the zone, or a vector (1,) or (2,) whose length it is, mm.

    Args:
        nominal, found: the feature as drawn and as measured, part frame.
        extent_mm: (K, 3) ends of the nominal axis, or corners of the nominal plane.
        nominal_datum, datum: what the zone is oriented by, likewise.
    """
    d0, n0 = nominal.direction, nominal_datum.direction
    d, n = _facing(found.direction, d0), _facing(datum.direction, n0)
    by_design = float(d0 @ n0)
    if is_along_datum(nominal, nominal_datum):
        n = n * np.sign(by_design)
        if nominal.kind == "plane":
            away = ((found.origin_mm - extent_mm) @ d) / float(d @ n)
            return np.array([float(np.ptp(extent_mm @ n + away))])
        length = float(np.linalg.norm(extent_mm[1] - extent_mm[0]))
        across = nominal.T[:3, :2] - np.outer(n, n @ nominal.T[:3, :2])
        return np.asarray(length * (d @ across))
    turned = float(np.arccos(np.clip(d @ n, -1, 1)) - np.arccos(np.clip(by_design, -1, 1)))
    if nominal.kind == "plane":
        towards = n0 - by_design * d0
        length = float(np.ptp(extent_mm @ (towards / np.linalg.norm(towards))))
    else:
        length = float(np.linalg.norm(extent_mm[1] - extent_mm[0]))
    return np.array([length * turned])


def _facing(direction: Floats, nominal: Floats) -> Floats:
    return direction if float(direction @ nominal) >= 0 else -direction
