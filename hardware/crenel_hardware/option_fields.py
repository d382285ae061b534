"""The options of a driver as fields of a form, from its options model."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, Any, Literal, TypeAlias, cast

from pydantic import TypeAdapter, ValidationError
from pydantic.fields import FieldInfo

from crenel.messages.message import Text, Unit
from crenel_hardware.options import Options, Shown

FieldKind: TypeAlias = Literal["text", "number", "switch", "choice", "list"]
UNITS: dict[str, Unit] = {
    "us": "µs",
    "ms": "ms",
    "s": "s",
    "hz": "Hz",
    "px": "px",
    "mm": "mm",
    "m": "m",
    "deg": "°",
    "rad": "rad",
}
"""By the ending of an option's name."""
MAIN = (
    *("url", "source", "path", "address", "host", "ip", "device", "topic", "unit", "port"),
    *("serial", "serial_number", "baudrate", "exposure_us", "rate_hz", "laser_colour"),
)
"""Options that are shown at once, in this order; those that a driver requires come before."""


@dataclass(frozen=True, slots=True)
class OptionField:
    """One option of a driver."""

    key: str
    label: Text
    kind: FieldKind
    unit: Unit
    choices: tuple[str, ...]
    words: Mapping[str, Text]
    """Choices in words; the others are shown as they are."""
    required: bool
    default: str
    """As it would be entered; empty if there is none."""
    main: bool
    """Whether it is one of those that are needed most."""
    help: Text
    """How it is filled in, where the label does not say it."""


def option_fields(model: type[Options]) -> tuple[OptionField, ...]:
    """The fields of a driver's options, those needed most first; tables of options are left out."""
    schema = model.model_json_schema()
    shapes = schema.get("properties", {})
    fields = [
        _field(key, info, _variants(shapes[key], schema.get("$defs", {})))
        for key, info in model.model_fields.items()
    ]
    shown = [one for one in fields if one is not None]
    return tuple(sorted(shown, key=_rank))


def _rank(field: OptionField) -> tuple[bool, int]:
    """Smaller for what is needed more."""
    key = field.key
    return not field.required, MAIN.index(key) if key in MAIN else len(MAIN)


def read_entered(
    model: type[Options] | None, entered: Mapping[str, object]
) -> dict[str, str | int | float | bool | list[Any]]:
    """Options with the types that the driver expects, from what was entered as text.

    An empty text is an option that is not given. What fits no type of its option stays as it is:
    the driver's error then names it. Without a model, a text that looks like a number is one.
    """
    typed: dict[str, str | int | float | bool | list[Any]] = {}
    for key, value in entered.items():
        if isinstance(value, str) and not value.strip():
            continue
        info = None if model is None else model.model_fields.get(key)
        typed[key] = cast(
            "str", value if not isinstance(value, str) else _first_fitting(info, value)
        )
    return typed


def _first_fitting(info: FieldInfo | None, text: str) -> object:
    candidates = _readings(text.strip())
    if info is None:
        return candidates[0]
    shape: Any = info.annotation
    if info.metadata:
        shape = Annotated[(shape, *info.metadata)]
    adapter: TypeAdapter[object] = TypeAdapter(shape)
    for candidate in candidates:
        try:
            adapter.validate_python(candidate, strict=True)
        except ValidationError:
            continue
        return candidate
    # a number out of its range is better named as a number than as a text
    return candidates[0]


def _readings(text: str) -> Sequence[object]:
    """What a text may mean, the likeliest first: a number, true or false, a list, the text itself,
    or a list of texts."""
    readings: list[object] = []
    for form in (text, f"[{text}]"):
        try:
            read = json.loads(form)
        except ValueError:
            continue
        if isinstance(read, (bool, int, float, list)):
            readings.append(read)
    return [*readings, text, [part.strip() for part in text.split(",")]]


def _variants(shape: Mapping[str, Any], definitions: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    """The types that an option may have in the JSON schema, without null."""
    if "$ref" in shape:
        return _variants(definitions[str(shape["$ref"]).rpartition("/")[2]], definitions)
    if "anyOf" in shape:
        return [one for each in shape["anyOf"] for one in _variants(each, definitions)]
    return [] if shape.get("type") == "null" else [shape]


def _field(key: str, info: FieldInfo, variants: list[Mapping[str, Any]]) -> OptionField | None:
    types = {one.get("type") for one in variants}
    choices = tuple(
        str(value)
        for one in variants
        for value in one.get("enum", [one["const"]] if "const" in one else [])
    )
    if types <= {"object"}:
        return None
    kind: FieldKind = "text"
    if choices and all("enum" in one or "const" in one for one in variants):
        kind = "choice"
    elif types == {"boolean"}:
        kind = "switch"
    elif types <= {"integer", "number"}:
        kind = "number"
    elif types == {"array"}:
        kind = "list"
    required = info.is_required()
    default = "" if required else _as_text(info.get_default(call_default_factory=True))
    unit = UNITS.get(key.rpartition("_")[2], "") if "_" in key else ""
    shown = next((one for one in info.metadata if isinstance(one, Shown)), None)
    if shown is None:
        shown = Shown(_words_of(key.rpartition("_")[0] if unit else key), info.description or "")
    return OptionField(
        key=key,
        label=shown.label,
        kind=kind,
        unit=unit,
        choices=choices,
        words=shown.choices,
        required=required,
        default=default,
        main=required or key in MAIN,
        help=shown.help,
    )


def _words_of(key: str) -> str:
    return key.replace("_", " ").capitalize()


def _as_text(value: object) -> str:
    """A value as it would be entered."""
    if value is None:
        return ""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (list, tuple)):
        return ", ".join(_as_text(one) for one in value)
    return f"{value:g}" if isinstance(value, float) else str(value)
