"""``program.json``: what is to be measured of a part, and within which limits."""

import math
from collections import Counter
from collections.abc import Iterable
from typing import Annotated, ClassVar, Literal, Self

from pydantic import Field, model_validator

from crenel.formats.json_document import (
    Document,
    DocumentPart,
    Name,
    NotNegative,
    Number,
    Positive,
    Vector3,
)
from crenel.messages.message import message
from crenel.parts.document_nominal import AlignmentKind, FeaturePart, Identifier
from crenel.parts.maths.dimensions import ORIENTATIONS, SIZED, DimensionKind
from crenel.parts.maths.shapes import Kind

PROGRAM = "program.json"
CELL_MM = 0.8
Means = Literal["scan", "touch"]
Unit = Literal["mm", "um", "µm", "deg", "°"]
OF_TWO = ("distance", "angle")
ANGLES = ("angle", "half-angle")
FormKind = Literal["flatness", "roundness", "cylindricity"]
FORMS: dict[str, tuple[Kind, ...]] = {
    "flatness": ("plane",),
    "roundness": ("circle",),
    "cylindricity": ("cylinder",),
}


class PartPart(DocumentPart):
    """The part, by its drawing."""

    name: Name = ""
    drawing: Name = ""
    serial_number: Name = ""
    cad: str | None = None
    unit: Literal["mm"] = "mm"
    expansion_per_c: NotNegative | None = None
    """Of its material, 1/°C."""
    expansion_sd_per_c: NotNegative | None = None
    """None: a tenth of it."""


class AlignmentPart(DocumentPart):
    """How the part frame follows from features."""

    kind: AlignmentKind = "datums"
    primary: Identifier | None = None
    secondary: Identifier | None = None
    tertiary: Identifier | None = None
    features: tuple[Identifier, ...] = ()
    """Of a best fit."""
    locked: tuple[Literal["x", "y", "z", "rx", "ry", "rz"], ...] = ()
    by: Means | None = None
    """None: by the source of each feature."""

    @model_validator(mode="after")
    def _has_features(self) -> Self:
        if self.kind == "datums" and self.primary is None:
            raise ValueError(message("part-datums-without-primary"))
        if self.kind == "best-fit" and not self.features:
            raise ValueError(message("part-best-fit-without-features"))
        if self.tertiary is not None and self.secondary is None:
            raise ValueError(message("part-tertiary-without-secondary"))
        return self

    @property
    def used(self) -> tuple[str, ...]:
        """The features that it needs, in their order."""
        if self.kind == "best-fit":
            return self.features
        given = (self.primary, self.secondary, self.tertiary)
        return tuple(name for name in given if name is not None)


class DimensionPart(DocumentPart):
    """One dimension, its nominal value, and its limits as deviations from that."""

    id: Identifier
    kind: DimensionKind | FormKind
    features: Annotated[tuple[Identifier, ...], Field(min_length=1, max_length=2)]
    nominal: Number = 0.0
    lower: Number | None = None
    upper: Number | None = None
    unit: Unit = "mm"
    along: str | None = None
    axis: Literal["x", "y", "z"] | None = None
    datums: tuple[Identifier, ...] = ()
    reference: Identifier | None = None
    """The plane in which axes are taken as points; None: the primary datum."""

    @model_validator(mode="before")
    @classmethod
    def _has_usual_unit(cls, given: object) -> object:
        if isinstance(given, dict) and given.get("kind") in ANGLES:
            return {"unit": "deg", **given}
        return given

    @model_validator(mode="after")
    def _makes_sense(self) -> Self:
        low, high = self.lower, self.upper
        if low is not None and high is not None and low > high:
            raise ValueError(message("part-lower-above-upper", lower=f"{low:g}", upper=f"{high:g}"))
        count = 2 if self.kind in OF_TWO else 1
        if len(self.features) != count:
            raise ValueError(message("part-dimension-features", kind=self.kind, count=count))
        if count == 2 and self.features[0] == self.features[1]:
            raise ValueError(message("part-dimension-of-one-feature-twice"))
        if (self.kind in ANGLES) != (self.unit in ("deg", "°")):
            raise ValueError(message("part-unit-of-other-kind", kind=self.kind, unit=self.unit))
        if self.kind in ORIENTATIONS and len(self.datums) != 1:
            raise ValueError(message("part-orientation-needs-datum", kind=self.kind))
        if self.kind == "coordinate" and self.axis is None:
            raise ValueError(message("part-coordinate-without-axis"))
        if self.kind == "position" and self.upper is None and self.lower is not None:
            raise ValueError(message("part-position-needs-upper"))
        return self

    @property
    def needed(self) -> tuple[str, ...]:
        """The features that it needs; an axis of the part frame may be among the names."""
        others = (self.along, self.reference)
        return (*self.features, *self.datums, *(one for one in others if one is not None))

    @property
    def per_unit(self) -> float:
        """How many of its unit are in a mm or a degree."""
        return 1e3 if self.unit in ("um", "µm") else 1.0


class SourcePart(DocumentPart):
    """By which means each feature is measured."""

    default: Means = "scan"
    scan: tuple[Identifier, ...] = ()
    touch: tuple[Identifier, ...] = ()
    both: tuple[Identifier, ...] = ()


class CellsPart(DocumentPart):
    """The edge of the cells in which points are gathered, and the limits of a map of deviations."""

    radius_mm: Annotated[Positive, Field(le=50.0)] = CELL_MM
    lower_mm: Number | None = None
    upper_mm: Number | None = None


class SkippedPart(DocumentPart):
    """A feature that is left out of one inspection."""

    feature: Identifier
    reason: Name


class ProgramFile(Document):
    """The file."""

    FORMAT: ClassVar[str] = "crenel/inspection-program"

    name: Name = ""
    part: PartPart = PartPart()
    features: Annotated[tuple[FeaturePart, ...], Field(min_length=1)]
    alignment: AlignmentPart | None = None
    """None: nominals are in the arm frame."""
    dimensions: tuple[DimensionPart, ...] = ()
    source: SourcePart = SourcePart()
    map: CellsPart = CellsPart()
    skipped: tuple[SkippedPart, ...] = ()
    """What an inspection leaves out, in the copy of its own folder."""

    @model_validator(mode="after")
    def _is_whole(self) -> Self:
        _refuse_twice("features", (one.id for one in self.features))
        _refuse_twice("dimensions", (one.id for one in self.dimensions))
        if self.alignment is not None:
            self._check_known("alignment", self.alignment.used)
        for name in ("scan", "touch", "both"):
            self._check_known(f"source.{name}", getattr(self.source, name))
        self._check_known("skipped", (one.feature for one in self.skipped))
        for skipped in self.skipped:
            if self.alignment is not None and skipped.feature in self.alignment.used:
                raise ValueError(message("part-datum-is-skipped", feature=repr(skipped.feature)))
        kinds = {one.id: one.kind for one in self.features}
        for one in self.dimensions:
            place = f"dimensions {one.id!r}"
            self._check_known(place, (*one.features, *one.datums))
            if one.along is not None and one.along not in "xyz":
                self._check_known(place, (one.along,))
            if one.reference is not None:
                self._check_known(place, (one.reference,))
                if kinds[one.reference] != "plane":
                    raise ValueError(message("part-reference-is-no-plane", place=place))
            allowed = SIZED.get(one.kind) or FORMS.get(one.kind)
            found = kinds[one.features[0]]
            if one.kind in ORIENTATIONS:
                self._check_orientation(place, one)
            if allowed is not None and found not in allowed:
                raise ValueError(
                    message("part-no-such-size", place=place, kind=one.kind, feature=found)
                )
        return self

    def _check_orientation(self, place: str, one: DimensionPart) -> None:
        """A datum with a direction, and a feature with an extent."""
        datum = self.feature(one.datums[0])
        if datum.kind not in ("plane", "cylinder", "cone"):
            raise ValueError(message("part-datum-without-direction", place=place, datum=datum.id))
        feature = self.feature(one.features[0])
        if feature.kind == "plane" and not feature.extent_mm():
            raise ValueError(message("part-plane-without-region", place=place, feature=feature.id))

    def _check_known(self, place: str, names: Iterable[str]) -> None:
        known = [one.id for one in self.features]
        for name in names:
            if name not in known:
                raise ValueError(
                    message(
                        "part-feature-unknown",
                        place=place,
                        feature=repr(name),
                        names=", ".join(known),
                    )
                )

    def feature(self, name: str) -> FeaturePart:
        """The feature of an id that is known."""
        return next(one for one in self.features if one.id == name)

    def without_skipped(self) -> "ProgramFile":
        """What is measured: without skipped features, and the dimensions that need them."""
        left_out = {one.feature for one in self.skipped}
        if not left_out:
            return self
        source = {
            name: tuple(one for one in getattr(self.source, name) if one not in left_out)
            for name in ("scan", "touch", "both")
        }
        return self.model_copy(
            update={
                "features": tuple(one for one in self.features if one.id not in left_out),
                "dimensions": tuple(
                    one for one in self.dimensions if not left_out & set(one.needed)
                ),
                "source": self.source.model_copy(update=source),
            }
        )

    @property
    def not_measured(self) -> tuple[str, ...]:
        """The dimensions that skipped features leave without a value."""
        measured = {one.id for one in self.without_skipped().dimensions}
        return tuple(one.id for one in self.dimensions if one.id not in measured)

    def means_of(self, name: str) -> Means:
        """By which means a feature's dimensions are measured."""
        if name in self.source.touch:
            return "touch"
        if name in self.source.scan or name in self.source.both:
            return "scan"
        return self.source.default

    def list_wanted(self) -> tuple[tuple[str, Means], ...]:
        """Each feature with each of the means by which it is to be measured."""
        found: dict[tuple[str, Means], None] = {}
        for one in self.features:
            found[one.id, self.means_of(one.id)] = None
            if one.id in self.source.both:
                found[one.id, "scan"] = found[one.id, "touch"] = None
            if self.alignment is not None and one.id in self.alignment.used:
                found[one.id, self.datum_means(one.id)] = None
        return tuple(found)

    def datum_means(self, name: str) -> Means:
        """By which means a feature is measured for the alignment."""
        by = None if self.alignment is None else self.alignment.by
        return self.means_of(name) if by is None else by

    def extent_mm(self) -> tuple[Vector3, Vector3]:
        """The two corners of the box about all nominals, mm."""
        points = [one.nominal.point_mm for one in self.features]
        points += [
            corner
            for one in self.features
            if one.region is not None
            for box in one.region.boxes_mm
            for corner in box
        ]
        (x0, x1), (y0, y1), (z0, z1) = (
            (min(axis), max(axis)) for axis in zip(*points, strict=True)
        )
        return (x0, y0, z0), (x1, y1, z1)

    def size_mm(self) -> float:
        """About how large the part is: the extent of its nominals."""
        return max(math.dist(*self.extent_mm()), 10.0)


def _refuse_twice(place: str, names: Iterable[str]) -> None:
    for name, count in Counter(names).items():
        if count > 1:
            raise ValueError(message("part-id-twice", place=place, id=repr(name)))
