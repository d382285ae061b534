"""``*.nominal.json``: where a gauge truly is, in the arm frame."""

import math
from pathlib import Path
from typing import ClassVar, Literal, Self

import numpy as np
from pydantic import model_validator

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.json_document import Document, SizeMm, Vector3
from crenel.gauges.quick.maths.errors import NominalPlane, NominalSphere
from crenel.messages.message import message

UNIT_TOLERANCE = 1e-6


class PlaneFile(Document):
    FORMAT: ClassVar[str] = "crenel/nominal"

    shape: Literal["plane"] = "plane"
    point_mm: Vector3
    normal: Vector3

    @model_validator(mode="after")
    def _normal_is_unit(self) -> Self:
        length = math.hypot(*self.normal)
        if abs(length - 1) > UNIT_TOLERANCE:
            raise ValueError(message("normal-must-be-of-unit-length", length=f"{length:.6g}"))
        return self


class SphereFile(Document):
    FORMAT: ClassVar[str] = "crenel/nominal"

    shape: Literal["sphere"] = "sphere"
    centre_mm: Vector3
    radius_mm: SizeMm


class _AnyNominal(Document):
    FORMAT: ClassVar[str] = "crenel/nominal"

    shape: str


def read_nominal(path: Path) -> NominalPlane | NominalSphere:
    """Reads a gauge's nominal; raises ``OperationError`` naming the file and the field."""
    shape = _AnyNominal.read(path).shape
    if shape == "plane":
        plane = PlaneFile.read(path)
        return NominalPlane(np.array(plane.point_mm), np.array(plane.normal))
    if shape == "sphere":
        sphere = SphereFile.read(path)
        return NominalSphere(np.array(sphere.centre_mm), sphere.radius_mm)
    raise OperationError(
        "shape-unknown",
        message("gauge-shape", path=display_path(path), shape=repr(shape)),
        message("gauges-are-plane-or-sphere"),
    )
