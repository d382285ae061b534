"""Figures of elements and of pairs of them: values, and what each is known to.

A length or an angle that is not near zero is known by its derivatives by the free parameters of
its elements. Near zero, it is the length of a vector, and known as that is along the direction in
which it is known worst.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from crenel.metrology.transforms import Floats
from crenel.parts.maths.knowledge import Knowledge
from crenel.parts.maths.limits import length_by_chance
from crenel.parts.maths.shapes import Shape

Quantity = Literal["length", "angle"]
Values = Callable[[Sequence[Shape]], Floats]
Directions = Callable[[Sequence[Shape]], tuple[Floats, Floats]]
NEAR_ZERO_SDS = 10.0
"""A vector is near zero below so many standard deviations."""
UP = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True)
class ElementFigure:
    """A value by name, mm or rad, with its standard uncertainty and the shares of its sources."""

    name: str
    quantity: Quantity
    value: float
    standard_uncertainty: float
    shares: tuple[tuple[str, float], ...]
    by_chance: float | None = None
    """What chance alone would show where the value is near zero."""


def measure_value(
    name: str,
    quantity: Quantity,
    knowledge: Knowledge,
    values: Values,
    towards: Floats | None = None,
) -> ElementFigure:
    """A value that follows the parameters smoothly, or the part of a vector along a direction."""
    found = values(knowledge.shapes)
    way = np.ones(1) if towards is None else towards
    gradient = np.asarray(way @ knowledge.gradients(values))
    u = float(np.sqrt(max(float(gradient @ knowledge.total @ gradient), 0.0)))
    shares = tuple(knowledge.contributions(gradient).items())
    return ElementFigure(name, quantity, float(way @ found), u, shares)


def measure_distance(name: str, knowledge: Knowledge, vector: Values) -> ElementFigure:
    """The length of a vector (3,)."""
    found = vector(knowledge.shapes)
    length = float(np.linalg.norm(found))
    covariance = _covariance(knowledge, vector)
    if length > NEAR_ZERO_SDS * _largest_sd(covariance):
        return measure_value(name, "length", knowledge, vector, found / length)
    worst = np.linalg.eigh(covariance)[1][:, -1]
    known = measure_value(name, "length", knowledge, vector, worst)
    return replace(known, value=length, by_chance=length_by_chance(covariance))


def measure_angle(name: str, knowledge: Knowledge, directions: Directions) -> ElementFigure:
    """The angle between two directions, at most a right one."""

    def angle(shapes: Sequence[Shape]) -> Floats:
        a, b = directions(shapes)
        return np.array([np.arctan2(np.linalg.norm(np.cross(a, b)), abs(float(a @ b)))])

    def sines(shapes: Sequence[Shape]) -> Floats:
        return np.cross(*directions(shapes))

    value = float(angle(knowledge.shapes)[0])
    covariance = _covariance(knowledge, sines)
    near = NEAR_ZERO_SDS * _largest_sd(covariance)
    if near < value < np.pi / 2 - near:
        return measure_value(name, "angle", knowledge, angle)
    if value <= near:
        worst = np.linalg.eigh(covariance)[1][:, -1]
        known = measure_value(name, "angle", knowledge, sines, worst)
        return replace(known, value=value, by_chance=length_by_chance(covariance))
    # near a right angle, its cosine is what follows smoothly
    known = measure_value(
        name, "angle", knowledge, lambda shapes: np.array([np.dot(*directions(shapes))])
    )
    return replace(known, value=value)


def measure_inclination(name: str, knowledge: Knowledge, directions: Directions) -> ElementFigure:
    """The angle of an axis from a plane: what is missing to a right one from the normal."""
    found = measure_angle(name, knowledge, directions)
    return replace(found, value=float(np.pi / 2 - found.value), by_chance=None)


def element_figures(knowledge: Knowledge) -> tuple[ElementFigure, ...]:
    """The figures of the only element, the most important first."""
    (shape,) = knowledge.shapes
    from_up: Directions = lambda one: (one[0].direction, UP)  # noqa: E731
    if shape.kind == "plane":
        return (
            measure_value("origin", "length", knowledge, _offset),
            measure_angle("tilt", knowledge, from_up),
        )
    if shape.kind == "cone":
        return (
            measure_value("cone-angle", "angle", knowledge, lambda one: 2 * one[0].sizes[1:2]),
            measure_inclination("level", knowledge, from_up),
        )
    diameter = measure_value("diameter", "length", knowledge, lambda one: 2 * one[0].sizes[:1])
    if shape.kind == "sphere":
        centre = (_coordinate(f"centre-{name}", k, knowledge) for k, name in enumerate("xyz"))
        return diameter, *centre
    return diameter, measure_inclination("level", knowledge, from_up)


def turn_outward(shape: Shape) -> Shape:
    """A plane or a cylinder, turned so that the largest component of its direction is positive."""
    direction = shape.direction
    if shape.kind not in ("plane", "cylinder") or direction[np.argmax(np.abs(direction))] > 0:
        return shape
    T = shape.T.copy()
    T[:3, 1:3] *= -1
    return replace(shape, T=T)


def _offset(shapes: Sequence[Shape]) -> Floats:
    return np.array([float(shapes[0].direction @ shapes[0].origin_mm)])


def _coordinate(name: str, axis: int, knowledge: Knowledge) -> ElementFigure:
    return measure_value(
        name, "length", knowledge, lambda one: one[0].origin_mm[axis : axis + 1].copy()
    )


def _covariance(knowledge: Knowledge, values: Values) -> Floats:
    gradients = knowledge.gradients(values)
    return np.asarray(gradients @ knowledge.total @ gradients.T)


def _largest_sd(covariance: Floats) -> float:
    return float(np.sqrt(max(float(np.linalg.eigvalsh(covariance)[-1]), 0.0)))
