"""Dimensions of features in the part frame: values, and the vectors whose lengths some of them are.

Lengths near zero are biased upwards by noise; of them the vector is kept, and decided on.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from crenel.metrology.transforms import Floats
from crenel.parts.maths.datums import meet_plane
from crenel.parts.maths.orientation import is_along_datum, orientation_deviation
from crenel.parts.maths.shapes import Shape

DimensionKind = Literal[
    "diameter",
    "width",
    "length",
    "half-angle",
    "distance",
    "angle",
    "coordinate",
    "position",
    "parallelism",
    "perpendicularity",
    "angularity",
]
ORIENTATIONS = ("parallelism", "perpendicularity", "angularity")
AXIS_KINDS = ("cylinder", "cone", "circle", "slot", "torus")
PARALLEL_SINE = 0.1
"""Below this sine between an axis and a plane, their distance is meant."""


@dataclass(frozen=True)
class FeaturePlace:
    """A feature's part in a dimension: by number, and as it should be."""

    number: int
    nominal: Shape
    extent_mm: Floats = field(default_factory=lambda: np.zeros((0, 3)))
    """(K, 3) ends of its nominal axis, or corners of its nominal plane."""


@dataclass(frozen=True)
class Dimension:
    """What is measured of which features.

    ``along`` is a direction, or the feature whose direction is taken; ``axis`` one of the part's
    axes (0 to 2); ``reference`` the plane in which axes are taken as points; ``datum`` what orients
    the zone of an orientation.
    """

    kind: DimensionKind
    features: tuple[FeaturePlace, ...]
    nominal: float
    along: FeaturePlace | Floats | None = None
    axis: int | None = None
    reference: FeaturePlace | None = None
    datum: FeaturePlace | None = None

    @property
    def is_vector(self) -> bool:
        """Whether the value is the length of a vector."""
        if self.datum is not None:
            (place,) = self.features
            is_plane = place.nominal.kind == "plane"
            return not (is_plane and is_along_datum(place.nominal, self.datum.nominal))
        return self.kind == "position" or (
            self.kind == "distance"
            and self.along is None
            and all(one.nominal.kind != "plane" for one in self.features)
        )

    @property
    def factor(self) -> float:
        """What the length of the vector is multiplied by."""
        return 2.0 if self.kind == "position" else 1.0


def measure_dimension(dimension: Dimension, shapes: Sequence[Shape]) -> Floats:
    """The value (1,) of a dimension, or its vector (k,), mm or degrees.

    Args:
        shapes: all features, in the part frame.
    """
    return _MEASURES[dimension.kind](dimension, shapes)


def dimension_value(dimension: Dimension, measured: Floats) -> float:
    """The value of a dimension, of what ``measure_dimension`` returns."""
    if dimension.is_vector:
        return dimension.factor * float(np.linalg.norm(measured))
    return float(measured[0])


def point_of(
    place: FeaturePlace, shapes: Sequence[Shape], reference: FeaturePlace | None
) -> Floats:
    """(3,) the point that stands for a feature: a centre, an axis where it meets the reference
    plane, a plane below its nominal point."""
    shape, nominal = shapes[place.number], place.nominal
    if shape.kind in ("sphere", "torus"):
        return shape.origin_mm
    if shape.kind == "plane":
        rise = float(shape.direction @ nominal.direction)
        away = float((shape.origin_mm - nominal.origin_mm) @ shape.direction) / rise
        return np.asarray(nominal.origin_mm + away * nominal.direction)
    if reference is not None:
        plane = shapes[reference.number]
        if abs(float(plane.direction @ shape.direction)) > PARALLEL_SINE:
            return meet_plane(shape, plane.origin_mm, plane.direction)
    return meet_plane(shape, nominal.origin_mm, nominal.direction)


def _sizes(dimension: Dimension, shapes: Sequence[Shape]) -> Floats:
    (place,) = dimension.features
    shape = shapes[place.number]
    sizes = shape.sizes
    if dimension.kind == "half-angle":
        return np.degrees(sizes[1:2])
    if dimension.kind == "length":
        return np.array([2 * (sizes[0] + sizes[1])])
    return np.asarray(2 * sizes[:1])


def _distance(dimension: Dimension, shapes: Sequence[Shape]) -> Floats:
    first, second = dimension.features
    if dimension.along is not None:
        ends, nominals = _ends(dimension, shapes), _nominal_ends(dimension)
        direction, by_design = _along(dimension, shapes)
        value = float((ends[1] - ends[0]) @ direction)
        return np.array(
            [_as_designed(value, float((nominals[1] - nominals[0]) @ by_design), dimension)]
        )
    planes = [one for one in dimension.features if one.nominal.kind == "plane"]
    if not planes:
        ends = _ends(dimension, shapes)
        return np.asarray(ends[1] - ends[0])
    plane = planes[0]
    other = second if plane is first else first
    shape = shapes[plane.number]
    at = point_of(other, shapes, dimension.reference)
    value = float((at - shape.origin_mm) @ shape.direction)
    designed = float((other.nominal.origin_mm - plane.nominal.origin_mm) @ plane.nominal.direction)
    return np.array([_as_designed(value, designed, dimension)])


def _as_designed(value: float, designed: float, dimension: Dimension) -> float:
    """A signed distance with the sign that makes the nominal one what the program says."""
    return -value if designed * dimension.nominal < 0 else value


def _ends(dimension: Dimension, shapes: Sequence[Shape]) -> list[Floats]:
    return [point_of(one, shapes, dimension.reference) for one in dimension.features]


def _nominal_ends(dimension: Dimension) -> list[Floats]:
    return [one.nominal.origin_mm for one in dimension.features]


def _along(dimension: Dimension, shapes: Sequence[Shape]) -> tuple[Floats, Floats]:
    """The direction of a distance, as measured and as designed."""
    if isinstance(dimension.along, FeaturePlace):
        found, nominal = shapes[dimension.along.number], dimension.along.nominal
        return _facing(found.direction, nominal.direction), nominal.direction
    assert dimension.along is not None
    return dimension.along, dimension.along


def _facing(direction: Floats, nominal: Floats) -> Floats:
    return direction if float(direction @ nominal) >= 0 else -direction


def _angle(dimension: Dimension, shapes: Sequence[Shape]) -> Floats:
    first, second = dimension.features
    a, b = (
        _facing(_element(shapes[one.number]), _element(one.nominal)) for one in dimension.features
    )
    between = float(np.degrees(np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b)))
    if (first.nominal.kind == "plane") != (second.nominal.kind == "plane"):
        between = 90.0 - between
        return np.array([min((between, -between), key=lambda one: abs(one - dimension.nominal))])
    choices = (between, 180.0 - between)
    return np.array([min(choices, key=lambda one: abs(one - dimension.nominal))])


def _element(shape: Shape) -> Floats:
    """The direction that an angle takes of a feature: of a slot, its long one."""
    return np.asarray(shape.T[:3, 0]) if shape.kind == "slot" else shape.direction


def _coordinate(dimension: Dimension, shapes: Sequence[Shape]) -> Floats:
    (place,) = dimension.features
    assert dimension.axis is not None
    at = point_of(place, shapes, dimension.reference)
    return np.asarray(at[dimension.axis : dimension.axis + 1])


def _position(dimension: Dimension, shapes: Sequence[Shape]) -> Floats:
    (place,) = dimension.features
    nominal = place.nominal
    off = point_of(place, shapes, dimension.reference) - nominal.origin_mm
    across, aside, normal = nominal.T[:3, :3].T
    if nominal.kind == "plane":
        return np.array([float(off @ normal)])
    if nominal.kind in AXIS_KINDS:
        off = off - nominal.direction * float(off @ nominal.direction)
        return np.array([float(off @ across), float(off @ aside)])
    return np.asarray(off)


def _orientation(dimension: Dimension, shapes: Sequence[Shape]) -> Floats:
    (place,) = dimension.features
    assert dimension.datum is not None
    return orientation_deviation(
        place.nominal,
        shapes[place.number],
        place.extent_mm,
        dimension.datum.nominal,
        shapes[dimension.datum.number],
    )


_MEASURES = {
    **dict.fromkeys(ORIENTATIONS, _orientation),
    "diameter": _sizes,
    "width": _sizes,
    "length": _sizes,
    "half-angle": _sizes,
    "distance": _distance,
    "angle": _angle,
    "coordinate": _coordinate,
    "position": _position,
}
SIZED: dict[str, tuple[str, ...]] = {
    "diameter": ("circle", "cylinder", "sphere", "torus"),
    "width": ("slot",),
    "length": ("slot",),
    "half-angle": ("cone",),
    **dict.fromkeys(ORIENTATIONS, ("plane", "cylinder", "cone")),
}
"""The kinds of feature that have a size, or an extent."""
