"""Whatever is sent: the server answers in its own words, reveals no secrets, and lives on."""

import contextlib
import json
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest
import schemathesis
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from schemathesis.core.result import Ok
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect

from app.bench.station.viewer_client import PROTOCOL
from tests.api.processes import demonstration
from tests.entering import cookie

pytestmark = [pytest.mark.device, pytest.mark.soak]

ROOT = Path(__file__).resolve().parents[2]
TRIES = 5
SIGNS_OUT = ("DELETE", "/api/session")
REPEATABLY = settings(deadline=None, database=None, derandomize=True)
QUICKLY = settings(REPEATABLY, max_examples=TRIES, suppress_health_check=list(HealthCheck))


@pytest.fixture(scope="module")
def data(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("any")


@pytest.fixture(scope="module")
def http(data: Path) -> Iterator[httpx.Client]:
    with demonstration(data) as (client, _):
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
        if (operation.method.upper(), operation.path) == SIGNS_OUT:
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
