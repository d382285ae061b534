"""Features of a program, as the drawing wants them: kinds, nominals, regions."""

import math
from itertools import product
from typing import Annotated, Literal, Self

import numpy as np
from pydantic import AfterValidator, AliasChoices, Field, model_validator

from crenel.formats.json_document import DocumentPart, NotNegative, Number, Positive, Vector3
from crenel.messages.message import message
from crenel.parts.maths.shapes import Kind, Shape, frame_along

Range = tuple[Number, Number]
HALF_TURN_DEG = 90.0
NEEDS: dict[Kind, tuple[str, ...]] = {
    "plane": ("normal",),
    "circle": ("normal", "diameter_mm"),
    "cylinder": ("direction", "diameter_mm", "length_mm"),
    "cone": ("direction", "half_angle_deg", "length_mm"),
    "sphere": ("diameter_mm",),
    "torus": ("direction", "diameter_mm", "tube_diameter_mm"),
    "slot": ("direction", "normal", "width_mm", "length_mm", "depth_mm"),
}
LEAST_TOUCHES: dict[Kind, int] = {
    "plane": 3,
    "circle": 3,
    "cylinder": 6,
    "cone": 6,
    "sphere": 4,
    "torus": 8,
    "slot": 6,
}

ADVISED_TOUCHES: dict[Kind, int] = {
    "plane": 7,
    "circle": 7,
    "cylinder": 12,
    "cone": 12,
    "sphere": 9,
    "torus": 17,
    "slot": 12,
}
"""So many show the form of a feature, too."""


def _check_direction(value: Vector3) -> Vector3:
    if math.hypot(*value) < 1e-6:
        raise ValueError(message("part-direction-without-length"))
    return value


def _check_range(value: Range) -> Range:
    if value[0] >= value[1]:
        raise ValueError(message("part-range-must-ascend"))
    return value


Direction = Annotated[Vector3, AfterValidator(_check_direction)]
"""A direction of any length but zero."""
Interval = Annotated[Range, AfterValidator(_check_range)]
Identifier = Annotated[str, Field(min_length=1, max_length=80)]


class NominalPart(DocumentPart):
    """Where a feature should be, and how large, in the part frame.

    ``point_mm`` lies on a plane or an axis, or is a centre or the apex of a cone; ranges of length
    and depth are along the direction or the normal from there.
    """

    point_mm: Vector3 = Field(
        validation_alias=AliasChoices("point_mm", "centre_mm", "center_mm", "apex_mm")
    )
    normal: Direction | None = None
    direction: Direction | None = Field(
        default=None, validation_alias=AliasChoices("direction", "axis", "long_direction")
    )
    diameter_mm: Positive | None = Field(
        default=None, validation_alias=AliasChoices("diameter_mm", "major_diameter_mm")
    )
    tube_diameter_mm: Positive | None = Field(
        default=None, validation_alias=AliasChoices("tube_diameter_mm", "minor_diameter_mm")
    )
    half_angle_deg: Annotated[Positive, Field(lt=HALF_TURN_DEG)] | None = None
    width_mm: Positive | None = None
    length_mm: Interval | Positive | None = Field(
        default=None, validation_alias=AliasChoices("length_mm", "overall_length_mm")
    )
    depth_mm: Interval | None = None


class RegionPart(DocumentPart):
    """Where points of a feature are taken: in any of some boxes, by two opposite corners."""

    boxes_mm: Annotated[tuple[tuple[Vector3, Vector3], ...], Field(min_length=1)]

    @model_validator(mode="after")
    def _corners_ascend(self) -> Self:
        for low, high in self.boxes_mm:
            if any(a > b for a, b in zip(low, high, strict=True)):
                raise ValueError(message("part-box-corners-must-ascend"))
        return self


class FeaturePart(DocumentPart):
    """One feature to measure."""

    id: Identifier
    kind: Kind
    internal: bool | None = None
    """Whether the material is outside: a bore. None: only of a slot."""
    nominal: NominalPart
    region: RegionPart | None = None
    form_allowance_mm: NotNegative = 0.0
    """Points nearer than this are never outliers."""

    @model_validator(mode="after")
    def _nominal_is_complete(self) -> Self:
        given = self.nominal
        if self.kind in ("plane", "circle") and given.normal is None and given.direction:
            object.__setattr__(given, "normal", given.direction)
        if self.kind in ("cylinder", "cone", "torus") and given.direction is None and given.normal:
            object.__setattr__(given, "direction", given.normal)
        missing = [name for name in NEEDS[self.kind] if getattr(given, name) is None]
        if missing:
            raise ValueError(
                message("part-nominal-lacks", kind=self.kind, names=", ".join(missing))
            )
        ranged = self.kind in ("cylinder", "cone")
        if ranged and not isinstance(given.length_mm, tuple):
            raise ValueError(message("part-length-is-range", kind=self.kind))
        if self.kind == "slot":
            self._check_slot()
        return self

    def _check_slot(self) -> None:
        given = self.nominal
        if isinstance(given.length_mm, tuple):
            raise ValueError(message("part-slot-length-is-one-number"))
        assert given.length_mm is not None
        assert given.width_mm is not None
        if given.length_mm < given.width_mm:
            raise ValueError(message("part-slot-shorter-than-wide"))
        assert given.direction is not None
        assert given.normal is not None
        if np.linalg.norm(np.cross(given.direction, given.normal)) < 1e-6:
            raise ValueError(message("part-slot-direction-along-normal"))

    @property
    def is_internal(self) -> bool:
        """Whether its material is outside."""
        return self.kind == "slot" if self.internal is None else self.internal

    def shape(self) -> Shape:
        """The nominal feature in the part frame."""
        given, point = self.nominal, np.array(self.nominal.point_mm)
        z = given.normal if self.kind in ("plane", "circle", "slot") else given.direction
        towards = np.array(given.direction) if self.kind == "slot" else None
        T = frame_along(np.array(z or (0.0, 0.0, 1.0)), point, towards)
        radius = (given.diameter_mm or 0.0) / 2
        sizes: tuple[float, ...] = (radius,)
        if self.kind == "plane":
            sizes = ()
        elif self.kind == "cone":
            sizes = (0.0, math.radians(given.half_angle_deg or 0.0))
        elif self.kind == "torus":
            sizes = (radius, (given.tube_diameter_mm or 0.0) / 2)
        elif self.kind == "slot":
            assert isinstance(given.length_mm, float | int)
            assert given.width_mm is not None
            sizes = (given.width_mm / 2, (given.length_mm - given.width_mm) / 2)
        return Shape(self.kind, T, np.array(sizes, dtype=np.float64))

    @property
    def along_mm(self) -> Range | None:
        """The range along the direction of an axis, or of the depth of a slot."""
        if self.kind == "slot":
            return self.nominal.depth_mm
        return self.nominal.length_mm if isinstance(self.nominal.length_mm, tuple) else None

    def extent_mm(self) -> tuple[Vector3, ...]:
        """The ends of its axis, or the corners of its region on its plane; empty without."""
        shape = self.shape()
        if self.kind == "plane":
            boxes = () if self.region is None else self.region.boxes_mm
            corners = np.array([c for box in boxes for c in product(*zip(*box, strict=True))])
            if not len(corners):
                return ()
            points = corners - np.outer(shape.distances(corners), shape.direction)
        elif self.along_mm is not None:
            points = shape.origin_mm + np.outer(self.along_mm, shape.direction)
        else:
            return ()
        return tuple((x, y, z) for x, y, z in points.tolist())


AlignmentKind = Literal["datums", "best-fit"]
