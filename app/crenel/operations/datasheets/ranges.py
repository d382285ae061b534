"""Between which limits the numbers of a datasheet are: what its reader states of each field."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

from crenel.formats.datasheets.arm import ArmFile
from crenel.formats.datasheets.sensor import SensorDatasheet
from crenel.formats.datasheets.target import CharucoFile, ChessboardFile, ObjectFile
from crenel.formats.json_document import Document
from crenel.gauges.plan.document_gauge import GaugeFile
from crenel.gauges.plan.document_length_standard import LengthStandardFile
from crenel.operations.datasheets.documents import DatasheetForm

READERS: Mapping[DatasheetForm, type[Document]] = {
    "arm": ArmFile,
    "robot": ArmFile,
    "sensor": SensorDatasheet,
    "block": ObjectFile,
    "chessboard": ChessboardFile,
    "charuco": CharucoFile,
    "sphere": GaugeFile,
    "plane": GaugeFile,
    "ball-bar": LengthStandardFile,
    "step-gauge": LengthStandardFile,
}
ANY_PART = "*"
NOT_ENTERED = ("identification", "limits")
"""Parts of documents that no form has."""
LEAST, ABOVE, MOST = ("minimum", "ge"), ("exclusiveMinimum", "gt"), ("maximum", "le")
"""Names of the bounds of a number in a JSON schema; pydantic has other names where a value is
looked at before."""
Schema = Mapping[str, Any]


@dataclass(frozen=True)
class FieldRange:
    """The limits of a number, in the unit of its field; None where it has none."""

    least: float | None
    most: float | None
    above: bool
    """``least`` itself is too small."""


@cache
def list_ranges() -> Mapping[str, Mapping[str, FieldRange]]:
    """The ranges of each form's fields, which are named with points: ``lengths.*.length_mm``."""
    return {form: dict(_ranges(reader)) for form, reader in READERS.items()}


def _ranges(reader: type[Document]) -> Iterator[tuple[str, FieldRange]]:
    schema = reader.model_json_schema()
    return _walk(schema, schema.get("$defs", {}), ())


def _walk(
    schema: Schema, parts: Mapping[str, Schema], place: tuple[str, ...]
) -> Iterator[tuple[str, FieldRange]]:
    """The numbers in a piece of a JSON schema and below it."""
    if "$ref" in schema:
        name = schema["$ref"].rpartition("/")[2]
        if name not in parts:
            return  # it is within itself
        schema, parts = parts[name], {key: one for key, one in parts.items() if key != name}
    least, above, most = (
        next((schema[name] for name in names if name in schema), None)
        for names in (LEAST, ABOVE, MOST)
    )
    if (least, above, most) != (None, None, None):
        is_above = above is not None
        yield ".".join(place), FieldRange(above if is_above else least, most, is_above)
    inner = [
        *((one, place) for one in schema.get("anyOf", ())),
        *((one, (*place, name)) for name, one in _form_fields(schema)),
        *((one, (*place, str(i))) for i, one in enumerate(schema.get("prefixItems", ()))),
    ]
    if "items" in schema and "prefixItems" not in schema:
        inner.append((schema["items"], (*place, ANY_PART)))
    for piece, where in inner:
        yield from _walk(piece, parts, where)


def _form_fields(schema: Schema) -> Iterator[tuple[str, Schema]]:
    fields = schema.get("properties", {}).items()
    return ((name, field) for name, field in fields if name not in NOT_ENTERED)
