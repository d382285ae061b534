"""What a datasheet says: its kind by its content, what it is called, and what is wrong in it."""

import json
import re
import unicodedata
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal, TypeGuard

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from crenel.errors import OperationError
from crenel.formats.arm_models.import_model import read_model
from crenel.formats.datasheets.arm import ArmFile, parse_any_arm
from crenel.formats.datasheets.sensor import SensorDatasheet
from crenel.formats.datasheets.target import ObjectFile, parse_object
from crenel.formats.file_names import display_path
from crenel.formats.io_errors import convert_all_errors
from crenel.formats.json_document import (
    field_name,
    is_valid_unicode,
    parse_format,
    state_format,
)
from crenel.gauges.exchange.read_certificate import parse_sphere_certificate
from crenel.gauges.plan.document_gauge import GaugeFile
from crenel.gauges.plan.document_length_standard import LengthStandardFile
from crenel.guide.common.datasheet_library import (
    CERTIFICATE_ENDING,
    parse_any_gauge,
    parse_station_sensor,
)
from crenel.messages.message import Message, Text, Value, message
from crenel.messages.validation import validation_text

DatasheetKind = Literal["arm", "sensor", "object", "gauge"]
DatasheetForm = Literal[
    "arm",
    "robot",
    "sensor",
    "block",
    "chessboard",
    "charuco",
    "sphere",
    "plane",
    "ball-bar",
    "step-gauge",
]
FOLDERS: Mapping[DatasheetKind, str] = {
    "arm": "arms",
    "sensor": "sensors",
    "object": "objects",
    "gauge": "gauges",
}
"""The folders of each kind in the data folder."""
KINDS: Mapping[str, DatasheetKind] = {
    ArmFile.FORMAT: "arm",
    SensorDatasheet.FORMAT: "sensor",
    ObjectFile.FORMAT: "object",
    GaugeFile.FORMAT: "gauge",
    LengthStandardFile.FORMAT: "gauge",
}
PARSERS: Mapping[DatasheetKind, Callable[[str, Path], object]] = {
    "arm": parse_any_arm,
    "sensor": parse_station_sensor,
    "object": parse_object,
    "gauge": parse_any_gauge,
}
OTHER_FORMS: Mapping[str, DatasheetForm] = {
    "chessboard": "chessboard",
    "charuco": "charuco",
    "sphere": "sphere",
    "plane": "plane",
    "step-gauge": "step-gauge",
}
"""The forms of objects and gauges, by what their documents say."""
_ROBOT = re.compile(r"^[^<]*(<[?!][^>]*>[^<]*)*<robot\b")
"""How URDF begins."""
FIELD_NAME = field_name("").message_id


@dataclass(frozen=True)
class DatasheetIdentity:
    """What a datasheet is, and which thing it describes."""

    kind: DatasheetKind
    form: DatasheetForm
    name: str
    serial_number: str
    certificate: str = ""
    issued_on: str = ""
    valid_until: str = ""
    size_px: tuple[int, int] | None = None
    """The size of a sensor's pictures, which has a datasheet for each."""
    joint_count: int = 0
    """The number of joints of an arm that reports them."""

    def is_same_thing(self, other: "DatasheetIdentity") -> bool:
        """Whether both describe one thing: by the serial number, or by the name where not both
        state one."""
        if (self.kind, self.size_px) != (other.kind, other.size_px):
            return False
        own, others = _comparable(self.serial_number), _comparable(other.serial_number)
        if own and others:
            return own == others
        return _comparable(self.name) == _comparable(other.name) != ""


@dataclass(frozen=True)
class FieldProblem:
    """What is wrong in a document."""

    field: str
    """As in the file, with points: ``joints.2.a_mm``; empty if it is not one field's."""
    missing: bool
    text: Text


def _comparable(text: str) -> str:
    return unicodedata.normalize("NFKC", text).strip().casefold()


def is_certificate(path: Path, text: str) -> bool:
    """Whether a file is a digital certificate rather than a document of the program."""
    return path.name.lower().endswith(CERTIFICATE_ENDING) or text.lstrip("\ufeff \t\r\n")[:1] == "<"


def identify(text: str, path: Path) -> DatasheetIdentity:
    """Evaluates the text of a file of any kind of datasheet, as a calibration would.

    Args:
        path: name of the file in errors.

    Raises:
        OperationError: it cannot be used.
    """
    with convert_all_errors(path):
        if not is_valid_unicode(text):
            why = message("text-has-half-character")
            raise OperationError("file-not-text", display_path(path), why, message("save-utf-8"))
        if _ROBOT.search(text) or text.strip()[:1].isalpha():
            raise _no_datasheet(text, path)
        if is_certificate(path, text):
            return evaluate(text, path, "gauge")
        found = parse_format(text, path)
        kind = KINDS.get(found) if isinstance(found, str) else None
        if kind is None:
            raise OperationError(
                "file-of-another-format",
                state_format(path, found),
                message("format-expected", format=", ".join(map(repr, KINDS))),
                message("give-right-file"),
            )
        return evaluate(text, path, kind)


def _no_datasheet(text: str, path: Path) -> OperationError:
    """Why a text is refused that is neither JSON nor a certificate: most people have the model of
    their arm as such a one."""
    remedy = message("take-model-over-in-form-of-arm")
    if not _ROBOT.search(text):
        try:
            read_model(text, {})
        except OperationError:
            remedy = message("choose-datasheet-or-certificate")
    why = message("text-is-no-datasheet")
    return OperationError("file-not-json", display_path(path), why, remedy)


def evaluate(text: str, path: Path, kind: DatasheetKind) -> DatasheetIdentity:
    """The same of a file that should be of this kind."""
    with convert_all_errors(path):
        if kind == "gauge" and is_certificate(path, text):
            fields: dict[str, Any] = parse_sphere_certificate(text, path).gauge.model_dump()
        else:
            PARSERS[kind](text, path)
            fields = json.loads(text.removeprefix("\ufeff"))
        return DatasheetIdentity(
            kind=kind,
            form=_form(kind, fields),
            name=_text(fields, "name"),
            serial_number=_text(fields, "serial_number"),
            certificate=_text(fields, "certificate"),
            issued_on=_text(fields, "issued_on"),
            valid_until=_text(fields, "valid_until"),
            size_px=(fields["width_px"], fields["height_px"]) if kind == "sensor" else None,
            joint_count=len(fields.get("joints", ())) if kind == "arm" else 0,
        )


def _text(fields: Mapping[str, Any], name: str) -> str:
    value = fields.get(name, "")
    return value if isinstance(value, str) else ""


def _form(kind: DatasheetKind, fields: Mapping[str, Any]) -> DatasheetForm:
    if kind == "arm":
        return "robot" if fields["convention"] == "pose" else "arm"
    if kind == "sensor":
        return "sensor"
    found = _text(fields, "shape") or _text(fields, "kind")
    return OTHER_FORMS.get(found, "block" if kind == "object" else "ball-bar")


def list_problems(error: OperationError) -> tuple[FieldProblem, ...]:
    """What is wrong in a refused document, by its fields as far as they are known."""
    cause = error.__cause__
    if not isinstance(cause, ValidationError):
        return (FieldProblem("", False, error.text),)
    errors = cause.errors(include_url=False)
    return tuple(_field_problem(one) for one in errors if not _is_follower(one, errors))


def _is_follower(error: ErrorDetails, errors: Sequence[ErrorDetails]) -> bool:
    """Whether a list is too short only because what is in it is wrong."""
    place = error["loc"]
    return error["type"] == "too_short" and any(
        one["loc"][: len(place)] == place and one is not error for one in errors
    )


def _field_problem(error: ErrorDetails) -> FieldProblem:
    """One problem; of fields that do not go together, it stands at the one that is named first."""
    text = validation_text(error)
    values = text.values.values() if isinstance(text, Message) else ()
    named = [str(one.values["name"]) for one in values if _is_field_name(one)]
    place = [str(part) for part in error["loc"]] + named[:1]
    return FieldProblem(".".join(place), error["type"] == "missing", message("sentence", text=text))


def _is_field_name(value: Value) -> TypeGuard[Message]:
    return isinstance(value, Message) and value.message_id == FIELD_NAME
