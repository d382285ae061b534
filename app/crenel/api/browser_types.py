"""The models of everything sent between server and browser, as one JSON schema.

``python -m crenel.api.browser_types`` writes it to ``frontend/src/api``, where the client's build
generates TypeScript from it.
"""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from fastapi.routing import APIRoute
from pydantic import TypeAdapter
from pydantic.json_schema import GenerateJsonSchema, JsonSchemaMode
from pydantic_core import core_schema

from crenel.api.routers import ROUTES
from crenel.formats.json_document import DocumentPart
from crenel.gauges.judgement.document import PerformanceFile
from crenel.gauges.quick.document import VerificationFile
from crenel.messages.message import Message, MessageList, Quantity
from crenel.messages.stored import SUFFIX
from crenel.station.preview.preview import PreviewHeader
from crenel.wire.fleet import FLEET_ANSWERS
from crenel.wire.fleet_drift import FleetDrift
from crenel.wire.live_messages import BeatMessage, EventMessage, HelloMessage, LiveRequest, Topics
from crenel.wire.schema import Problem, ProblemMessages, RecordedCalibration

FILE = Path(__file__).parents[3] / "frontend/src/api/wire.schema.json"
REFERENCE = "#/$defs/"
TEXTS = {REFERENCE + kind.__name__ for kind in (Message, MessageList, Quantity)}
MESSAGES = REFERENCE + ProblemMessages.__name__
"""The client replaces the English texts of a problem by these messages."""
BESIDE_ROUTES: tuple[Any, ...] = (
    Topics,
    HelloMessage,
    EventMessage,
    BeatMessage,
    LiveRequest,
    PreviewHeader,
    Problem,
    RecordedCalibration,
    *FLEET_ANSWERS,
    FleetDrift,
)
"""Models that are sent and are not the declared answer of a route of the station."""
FILES: tuple[Any, ...] = (VerificationFile, PerformanceFile)
"""The station's own files that are sent unchanged."""
Schema = dict[str, Any]


class _BrowserSchema(GenerateJsonSchema):
    """No titles of fields: the client would generate a type for each."""

    def field_title_should_be_set(self, schema: core_schema.CoreSchema | Any) -> bool:
        return False


def make_schema() -> Schema:
    """JSON schema (draft 7) with one definition per model, by the name of its class.

    Texts are strings in it, because the client renders them on arrival.
    """
    # what a model accepts, not what its own serialiser makes of it
    wanted: list[tuple[int, JsonSchemaMode, TypeAdapter[Any]]] = [
        (number, "validation", TypeAdapter(shape))
        for number, shape in enumerate((*_shapes_of_routes(), *BESIDE_ROUTES, *FILES))
    ]
    schemas, shared = TypeAdapter.json_schemas(wanted, schema_generator=_BrowserSchema)
    found: Schema = shared["$defs"]
    # a model that nothing else refers to is inlined, under its title
    for schema in schemas.values():
        if "title" in schema and "$ref" not in schema:
            found.setdefault(schema["title"], schema)
    without_none = {Problem.__name__, *(part.__name__ for part in _subclasses(DocumentPart))}
    shapes = {
        name: _shape(found[name], name in without_none)
        for name in sorted(found)
        if REFERENCE + name not in {*TEXTS, MESSAGES}
    }
    return {
        "$schema": "http://json-schema.org/draft-07/schema#",
        "type": "object",
        "additionalProperties": False,
        "properties": {name: {"$ref": REFERENCE + name} for name in shapes},
        "$defs": shapes,
    }


def _shapes_of_routes() -> Iterator[Any]:
    """The answers of the routes, and the bodies of their requests."""
    for route in ROUTES:
        if isinstance(route, APIRoute):
            if route.response_model is not None:
                yield route.response_model
            yield from (one.field_info.annotation for one in route.dependant.body_params)


def _subclasses(kind: type) -> Iterator[type]:
    subclasses: list[type] = kind.__subclasses__()
    for part in subclasses:
        yield part
        yield from _subclasses(part)


def _shape(schema: Schema, without_none: bool) -> Schema:
    """One model; a field that the station sends is always present unless it is left out as None."""
    shape: Schema = _simplify(schema)
    shape.pop("title", None)
    is_request = shape.get("additionalProperties") is False
    if not is_request:
        shape["required"] = [
            name
            for name, field in shape["properties"].items()
            if not (without_none and field.get("default", "") is None)
        ]
    return shape


def _simplify(schema: Any) -> Any:
    """Texts as strings, arrays of fixed length as in draft 7, no messages next to texts."""
    if isinstance(schema, list):
        return [_simplify(one) for one in schema]
    if not isinstance(schema, dict):
        return schema
    simple = {key: _simplify(value) for key, value in schema.items()}
    if "prefixItems" in simple:
        simple["items"] = simple.pop("prefixItems")
    if isinstance(simple.get("anyOf"), list):
        simple = _without_texts(simple)
    if isinstance(simple.get("properties"), dict):
        simple["properties"] = {
            name: one
            for name, one in simple["properties"].items()
            if not name.endswith(SUFFIX) and one.get("$ref") != MESSAGES
        }
    return simple


def _without_texts(union: Schema) -> Schema:
    """A union without the kinds of text: the client has a string."""
    left = [one for one in union["anyOf"] if one.get("$ref") not in TEXTS]
    if len(left) == 1:
        return {**{key: value for key, value in union.items() if key != "anyOf"}, **left[0]}
    return {**union, "anyOf": left}


if __name__ == "__main__":
    FILE.write_text(json.dumps(make_schema(), indent=1, ensure_ascii=False) + "\n", "utf-8")
