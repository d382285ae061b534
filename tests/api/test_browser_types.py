"""What goes to browsers is as the schema says that their types are made of."""

import json
from dataclasses import fields
from typing import Any

import pytest
from jsonschema import Draft7Validator
from websockets.sync.client import connect

from crenel.api import browser_types
from crenel.messages.message import text_from_json
from crenel.wire.live_messages import Topics
from tests.api.conftest import PATIENCE_S, Server

pytestmark = pytest.mark.device

OF_A_STATION = {"control", "devices", "flow", "scan", "settings", "home", "view", "report"}
"""Topics that every station has from its start."""
SCHEMA: dict[str, Any] = json.loads(browser_types.FILE.read_text(encoding="utf-8"))


def in_words(data: Any) -> Any:
    """The same with texts where the data of texts were, as the client shows them."""
    if isinstance(data, list):
        return [in_words(one) for one in data]
    if not isinstance(data, dict):
        return data
    try:
        return str(text_from_json(data))
    except ValueError:
        return {name: in_words(one) for name, one in data.items()}


def without_docstrings(schema: Any) -> Any:
    """The same without descriptions: not every version of Pydantic takes those of dataclasses."""
    if isinstance(schema, list):
        return [without_docstrings(one) for one in schema]
    if not isinstance(schema, dict):
        return schema
    if isinstance(schema.get("description"), str):
        schema = {name: one for name, one in schema.items() if name != "description"}
    return {name: without_docstrings(one) for name, one in schema.items()}


def validate(shape: str, value: object) -> None:
    Draft7Validator({**SCHEMA, "$ref": f"#/$defs/{shape}"}).validate(in_words(value))


def test_the_schema_is_of_this_program() -> None:
    """``python -m crenel.api.browser_types`` writes it again."""
    assert without_docstrings(browser_types.make_schema()) == without_docstrings(SCHEMA)


def test_all_that_a_connection_begins_with(server: Server) -> None:
    topics: dict[str, Any] = {}
    with connect(server.live, additional_headers=server.cookie) as socket:
        validate("HelloMessage", json.loads(socket.recv(PATIENCE_S)))
        while not set(topics) >= OF_A_STATION:
            message = json.loads(socket.recv(PATIENCE_S))
            if message["type"] == "topic":
                topics[message["name"]] = message["value"]
    assert set(topics) <= {field.name for field in fields(Topics)}
    for name, value in topics.items():
        shape = SCHEMA["$defs"]["Topics"]["properties"][name]
        Draft7Validator({**SCHEMA, **shape}).validate(in_words(value))


@pytest.mark.parametrize(
    ("path", "shape", "status"),
    [
        ("session", "SignInState", 200),
        ("home", "Home", 200),
        ("health", "HealthView", 200),
        ("notifications", "Notifications", 200),
        ("scans/none/cloud", "Problem", 404),
    ],
)
def test_answers_and_refusals(server: Server, path: str, shape: str, status: int) -> None:
    answer = server.http.get(f"/api/{path}")
    assert answer.status_code == status
    validate(shape, answer.json())


def test_another_shape_is_noticed(server: Server) -> None:
    assert not Draft7Validator({**SCHEMA, "$ref": "#/$defs/Home"}).is_valid({"station": 1})
