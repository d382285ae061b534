"""Whatever is sent, any text in every field, any name in every folder: it answers, and lives on."""

import contextlib
import json
import os
import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import quote

import httpx
import pytest
import schemathesis
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from schemathesis.core.result import Ok
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect

from tests.api.processes import PATIENCE_S, demonstration
from tests.bench.station.viewer_client import PROTOCOL
from tests.entering import cookie

pytestmark = [pytest.mark.device, pytest.mark.soak]

ROOT = Path(__file__).resolve().parents[2]
TRIES = 5
SIGNS_OUT = ("delete", "/api/session")
REPEATABLY = settings(deadline=None, database=None, derandomize=True)
QUICKLY = settings(REPEATABLY, max_examples=TRIES, suppress_health_check=list(HealthCheck))
TEXTS = (
    "\ud800",
    "\udcfc",
    "a\x00\u2028\x1b[2J",
    "זרוע \u202egnp.exe",
    "x" * 10_000,
    "\U0001f469\u200d\U0001f527" + "Z" + "\u0301\u0327" * 200,
    "../../etc/passwd",
)
NAMES = (
    *(b"Pr\xfcf", b"a\xe2\x80\xa8b", b"\xe2\x80\xaegnp"),
    b"\xf0\x9f\x91\xa9\xe2\x80\x8d\xf0\x9f\x94\xa7",
    *(b"Z" + b"\xcc\x81" * 80, b"x" * 240, b"new\nline", b"\x1b[2J", b" "),
)
LISTED = (
    *("arms", "objects", "sensors", "gauges", "scans", "sessions", "verifications"),
    "sessions/truth/pictures",
)


@pytest.fixture(scope="module")
def data(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("any")


@pytest.fixture(scope="module")
def http(data: Path) -> Iterator[httpx.Client]:
    with demonstration(data, calibrated=True) as (client, _):
        yield client
        # after all that it still does its work
        assert client.get("/api/home").status_code == 200
        client.post("/api/flow/start").raise_for_status()


@pytest.mark.filterwarnings("ignore")
def test_every_route_answers_anything(http: httpx.Client, data: Path) -> None:
    schema = schemathesis.openapi.from_dict(http.get("/api/openapi.json").json())
    tried = 0
    for found in schema.get_all_operations():
        assert isinstance(found, Ok)
        operation = found.ok()
        if (operation.method.lower(), operation.path) == SIGNS_OUT:
            continue

        @QUICKLY
        @given(case=operation.as_strategy())
        def answers(case: schemathesis.Case[Any]) -> None:
            answer = case.call(base_url=str(http.base_url), headers=cookie(http), timeout=30)
            if answer.status_code < 400:
                return
            reported = f"{case.method} {case.formatted_path}: {answer} {answer.text[:500]}"
            assert answer.status_code < 500, reported
            assert_discreet(answer.text, data)
            assert {"title", "status", "detail"} <= set(json.loads(answer.text)), reported

        answers()
        tried += 1
    assert tried > 60


def assert_discreet(text: str, data: Path) -> None:
    for secret in ("Traceback", 'File "', "site-packages", str(ROOT), str(data), sys.prefix):
        assert secret not in text


@settings(QUICKLY, max_examples=40)
@given(sent=st.one_of(st.binary(max_size=200), st.text(max_size=200)))
def test_the_live_connection_takes_anything(http: httpx.Client, sent: bytes | str) -> None:
    address = f"ws://{http.base_url.netloc.decode()}/api/live"
    with connect(address, additional_headers=cookie(http)) as live:
        live.send(sent)
        with contextlib.suppress(ConnectionClosed):
            while True:
                live.recv(timeout=20)
    assert live.close_code == 1008
    assert http.get("/api/session").status_code == 200


@settings(QUICKLY, max_examples=3)
@given(sent=st.lists(st.one_of(st.binary(max_size=200), st.text(max_size=200)), min_size=10))
def test_the_3d_view_takes_anything(http: httpx.Client, sent: list[bytes | str]) -> None:
    address, headers = f"ws://{http.base_url.netloc.decode()}/viewer/", cookie(http)
    # it reads no more, and does not see the answer to its goodbye
    options: dict[str, Any] = {"subprotocols": [PROTOCOL], "close_timeout": 0.5}
    for _ in range(2):  # and the next client has it, too
        with connect(address, additional_headers=headers, **options) as view:
            view.recv(timeout=20)
            for message in sent:
                view.send(message)
    assert http.get("/api/session").status_code == 200


class Page:
    """A live connection as a page keeps one; what it is sent is read as it comes."""

    def __init__(self, http: httpx.Client) -> None:
        address = f"ws://{http.base_url.netloc.decode()}/api/live"
        self._live = connect(address, additional_headers=cookie(http), max_size=None)
        self.ended = False
        self._thread = threading.Thread(target=self._read, daemon=True)
        self._thread.start()

    def _read(self) -> None:
        with contextlib.suppress(ConnectionClosed):
            for message in self._live:
                assert isinstance(message, bytes) or json.loads(message) is not None
        self.ended = True

    def close(self) -> bool:
        """Whether it lived until now."""
        lived = not self.ended
        self._live.close()
        self._thread.join(PATIENCE_S)
        return lived


def operations(document: dict[str, Any]) -> Iterator[tuple[str, str, dict[str, Any]]]:
    for path, methods in document["paths"].items():
        for method, operation in methods.items():
            if (method, path) != SIGNS_OUT:
                yield method, path, operation


def filled_with(schema: dict[str, Any], document: dict[str, Any], text: str) -> object:
    """A value of a schema, each of its texts this one."""
    if "$ref" in schema:
        name = schema["$ref"].rsplit("/", 1)[-1]
        return filled_with(document["components"]["schemas"][name], document, text)
    if options := schema.get("anyOf") or schema.get("oneOf"):
        return filled_with(options[0], document, text)
    match schema.get("type"):
        case "object":
            any_fields = {"any": {"type": "string"}, text: {"type": "string"}}
            fields = schema.get("properties", any_fields)
            return {name: filled_with(of, document, text) for name, of in fields.items()}
        case "array":
            return [filled_with(schema.get("items", {}), document, text)]
        case "integer" | "number":
            return 1
        case "boolean":
            return True
    return schema["enum"][0] if "enum" in schema else text


def address_with(path: str, operation: dict[str, Any], text: str) -> str:
    """The operation's address, each of its parameters this text."""
    escaped = quote(text.encode("utf-8", "surrogateescape" if text == "\udcfc" else "replace"), "")
    asked = []
    for parameter in operation.get("parameters", []):
        if parameter["in"] == "path":
            path = path.replace(f"{{{parameter['name']}}}", escaped or "%20")
        elif parameter["in"] == "query":
            asked.append(f"{parameter['name']}={escaped}")
    return f"{path}?{'&'.join(asked)}" if asked else path


@pytest.mark.parametrize("text", TEXTS, ids=[ascii(text[:8]) for text in TEXTS])
def test_any_text_in_every_field(http: httpx.Client, text: str) -> None:
    document = http.get("/api/openapi.json").json()
    page, tried = Page(http), 0
    for method, path, operation in operations(document):
        content = None
        if body := operation.get("requestBody"):
            (kind,) = list(body["content"].values())[:1]
            value = filled_with(kind.get("schema", {}), document, text)
            content = json.dumps(value).encode()  # half a character as its escape
        address = address_with(path, operation, text)
        headers = {"Content-Type": "application/json"} if content else {}
        answer = http.request(method, address, content=content, headers=headers)
        assert answer.status_code < 500, (method, address[:200], answer.text[:300])
        tried += 1
    assert tried > 60
    assert http.get("/api/home").status_code == 200
    assert page.close()


def test_any_name_in_every_folder(http: httpx.Client, data: Path) -> None:
    page = Page(http)
    for folder in LISTED:
        (data / folder).mkdir(parents=True, exist_ok=True)
        for i, name in enumerate(NAMES):
            entry = data / folder / os.fsdecode(name + (b".json" if folder[-1] == "s" else b""))
            entry.mkdir() if i % 3 == 2 else entry.write_text("{}")
    http.post("/api/flow/start").raise_for_status()
    for method, path, operation in operations(http.get("/api/openapi.json").json()):
        if method == "get":
            answer = http.get(address_with(path, operation, "truth"))
            assert answer.status_code < 500, (path, answer.text[:300])
            assert str(data) not in answer.text, path
    assert http.get("/api/home").json()["checks"][0]["state"] != "failed"
    assert page.close()
