"""Dimensions between two elements: those that make sense for what they are and how they lie."""

from collections.abc import Sequence

import numpy as np

from crenel.metrology.transforms import Floats
from crenel.parts.elements.maths_figures import (
    ElementFigure,
    measure_angle,
    measure_distance,
    measure_inclination,
    measure_value,
)
from crenel.parts.maths.knowledge import Knowledge
from crenel.parts.maths.shapes import Shape

PARALLEL_RAD = np.radians(5.0)
"""Planes and axes within this angle of each other are meant to be parallel."""
AXES = ("cylinder", "cone")


def relation_figures(knowledge: Knowledge) -> tuple[ElementFigure, ...]:
    """The dimensions between the two elements, the most important first."""
    kinds = tuple(_role(one) for one in knowledge.shapes)
    if kinds == ("plane", "plane"):
        return _planes(knowledge)
    if kinds == ("axis", "axis"):
        return _axes(knowledge)
    if kinds == ("centre", "centre"):
        return (measure_distance("centres-distance", knowledge, _between_origins),)
    if "plane" in kinds and "axis" in kinds:
        return _axis_and_plane(knowledge)
    if "plane" in kinds:
        return (measure_value("centre-plane-distance", "length", knowledge, _from_plane),)
    return (measure_distance("centre-axis-distance", knowledge, _from_axis),)


def _role(shape: Shape) -> str:
    if shape.kind == "plane":
        return "plane"
    return "axis" if shape.kind in AXES else "centre"


def _planes(knowledge: Knowledge) -> tuple[ElementFigure, ...]:
    angle = measure_angle("planes-angle", knowledge, _directions)
    if angle.value > PARALLEL_RAD:
        return (angle,)
    return measure_value("planes-distance", "length", knowledge, _between_planes), angle


def _axes(knowledge: Knowledge) -> tuple[ElementFigure, ...]:
    angle = measure_angle("axes-angle", knowledge, _directions)
    if angle.value > PARALLEL_RAD:
        return angle, measure_value("axes-nearest", "length", knowledge, _nearest)
    return measure_distance("axes-distance", knowledge, _between_axes), angle


def _axis_and_plane(knowledge: Knowledge) -> tuple[ElementFigure, ...]:
    angle = measure_inclination("axis-plane-angle", knowledge, _directions)
    if angle.value > PARALLEL_RAD:
        return (angle,)
    return measure_value("axis-plane-distance", "length", knowledge, _from_plane), angle


def _directions(shapes: Sequence[Shape]) -> tuple[Floats, Floats]:
    return shapes[0].direction, shapes[1].direction


def _mean_direction(shapes: Sequence[Shape]) -> Floats:
    a, b = _directions(shapes)
    mean = a + (b if float(a @ b) >= 0 else -b)
    return np.asarray(mean / np.linalg.norm(mean))


def _between_origins(shapes: Sequence[Shape]) -> Floats:
    return np.asarray(shapes[1].origin_mm - shapes[0].origin_mm)


def _between_planes(shapes: Sequence[Shape]) -> Floats:
    """Along the mean of both normals, from the middle of one to the middle of the other."""
    return np.array([abs(float(_between_origins(shapes) @ _mean_direction(shapes)))])


def _between_axes(shapes: Sequence[Shape]) -> Floats:
    """In the plane across both axes that lies in the middle of both."""
    direction = _mean_direction(shapes)
    middle = (shapes[0].origin_mm + shapes[1].origin_mm) / 2
    first, second = (
        one.origin_mm
        + one.direction
        * float((middle - one.origin_mm) @ direction)
        / float(one.direction @ direction)
        for one in shapes
    )
    return np.asarray(second - first)


def _nearest(shapes: Sequence[Shape]) -> Floats:
    """The distance of two axes that cross where they come nearest."""
    across = np.cross(*_directions(shapes))
    return np.array([abs(float(_between_origins(shapes) @ across)) / np.linalg.norm(across)])


def _from_plane(shapes: Sequence[Shape]) -> Floats:
    """Of a centre, or of the middle of an axis."""
    plane, other = sorted(shapes, key=lambda one: one.kind != "plane")
    return np.array([abs(float((other.origin_mm - plane.origin_mm) @ plane.direction))])


def _from_axis(shapes: Sequence[Shape]) -> Floats:
    axis, centre = sorted(shapes, key=lambda one: one.kind not in AXES)
    away = centre.origin_mm - axis.origin_mm
    return np.asarray(away - axis.direction * float(away @ axis.direction))
