"""The server behind a proxy: the sub-path, whose word for it counts, and what is missing."""

import socket
from collections.abc import Iterator
from contextlib import contextmanager

import httpx
import pytest
from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Route

from crenel.api.access.browser import own_address, set_cookie
from crenel.api.access.sub_path import page_base
from crenel.errors import OperationError
from crenel.server.listener import local_address, with_root_path
from crenel.server.middleware import Guard
from crenel.server.starting_page import StartingApp, StartStep
from crenel.settings.settings import Serving
from tests.api.conftest import code_of, until
from tests.api.test_starting import served

pytestmark = pytest.mark.device

CADDY = {
    "host": "plant.example.org",
    "x-forwarded-for": "192.0.2.7",
    "x-forwarded-host": "plant.example.org",
    "x-forwarded-proto": "https",
    "via": "1.1 Caddy",
}
"""What Caddy's reverse_proxy sends beside the browser's own headers."""
LISTED = Serving(proxies=("127.0.0.1",), hosts=("plant.example.org",))
PREFIX = {"x-forwarded-prefix": "/crenel"}


def answer(request: Request) -> Response:
    """What the server knows of a request, and a cookie as a sign-in sets it."""
    known = {
        "path": request.url.path,
        "base": page_base(request.scope),
        "address": own_address(request, "/"),
        "client": request.client.host if request.client else "",
    }
    response = JSONResponse(known)
    set_cookie(response, request, "token", kiosk=False)
    return response


@contextmanager
def behind(serving: Serving) -> Iterator[httpx.Client]:
    """A client of a server that answers so."""
    routes = [Route("/{path:path}", answer, methods=["GET", "POST"])]
    app = Starlette(routes=routes)
    app.add_middleware(Guard, hosts=serving.hosts)
    starting = StartingApp("", [], StartStep("", 1.0, lambda: app), serving.hosts)
    with served(starting, serving) as (http, _):
        until(lambda: "ready" not in http.get("/api/starting").json())
        yield http


@pytest.mark.parametrize(
    ("sent", "path", "base"),
    [
        ("/", "/", "/crenel/"),
        ("/records/calibration/a", "/records/calibration/a", "/crenel/"),
        ("/crenel", "/", "/crenel/"),
        ("/crenel/records/b", "/records/b", "/crenel/"),
        ("/crenel/crenel/x", "/crenel/x", "/crenel/"),
        ("/crenelated", "/crenelated", "/crenel/"),
    ],
)
def test_a_sub_path_is_known_whether_the_proxy_removes_it_or_not(
    sent: str, path: str, base: str
) -> None:
    for serving, headers in (
        (LISTED, PREFIX),
        (LISTED, {"x-forwarded-prefix": "/crenel/"}),
        (with_root_path(LISTED, "/crenel/"), {}),
    ):
        with behind(serving) as http:
            known = http.get(sent, headers=headers).json()
        assert (known["path"], known["base"]) == (path, base)
        assert known["address"].endswith("/crenel/")


@pytest.mark.parametrize(
    ("sent", "base"),
    [("/", "./"), ("/scan", "./"), ("/records/x", "../"), ("/a/b/", "../../"), ("/a%2Fb", "./")],
)
def test_without_a_sub_path_a_page_finds_its_files_by_its_own_address(sent: str, base: str) -> None:
    with behind(Serving()) as http:
        answered = http.get(sent)
    assert answered.json()["base"] == base
    assert "Path=/;" in answered.headers["set-cookie"]


def test_what_caddy_sends_is_used_if_it_is_listed() -> None:
    with behind(LISTED) as http:
        answered = http.post("/x", headers=CADDY | PREFIX | {"origin": "https://plant.example.org"})
    known, cookie = answered.json(), answered.headers["set-cookie"]
    assert known["address"] == "https://plant.example.org/crenel/"
    assert known["client"] == "192.0.2.7"
    assert cookie.startswith("crenel-443-crenel=")
    assert "Path=/crenel/" in cookie
    assert "Secure" in cookie


def test_nobody_else_is_believed(caplog: pytest.LogCaptureFixture) -> None:
    with behind(Serving()) as http:
        for _ in range(3):
            known = http.get("/x", headers={"x-forwarded-proto": "https"} | PREFIX).json()
    assert known["base"] == "./"
    assert known["address"].startswith("http://127.0.0.1:")
    assert known["address"].endswith("/")
    said = [line for line in caplog.messages if "X-Forwarded-Prefix from 127.0.0.1" in line]
    assert len(said) == 1
    assert "proxies" in said[0]


@pytest.mark.parametrize(
    "stated", ["crenel", "//evil.example", "/a/../b", "/api", "/viewer/x", '/"><script>', "/a b"]
)
def test_what_is_no_sub_path_is_not_used(stated: str, caplog: pytest.LogCaptureFixture) -> None:
    with behind(LISTED) as http:
        known = http.get("/x", headers={"x-forwarded-prefix": stated}).json()
    assert known["base"] == "./"
    assert any("it is no sub-path" in line for line in caplog.messages)


def test_a_websocket_without_its_upgrade_is_said(caplog: pytest.LogCaptureFixture) -> None:
    handshake = {"sec-websocket-key": "AAAAAAAAAAAAAAAAAAAAAA==", "sec-websocket-version": "13"}
    with behind(LISTED) as http:
        for _ in range(3):
            answered = http.get("/api/live", headers=handshake)
    assert code_of(answered) == (426, "no-upgrade")
    assert "Upgrade $http_upgrade" in answered.json()["remedy"]
    assert len([line for line in caplog.messages if "without its upgrade" in line]) == 1


def test_a_host_that_is_not_the_browsers_is_said(caplog: pytest.LogCaptureFixture) -> None:
    page = {"origin": "https://plant.example.org"}
    with behind(LISTED) as http:
        for _ in range(3):
            answered = http.post("/x", headers=page)
        foreign = http.post("/x", headers=page | {"sec-fetch-site": "cross-site"})
        unlisted = http.get("/x", headers={"host": "station_upstream"})
    assert code_of(answered) == (403, "not-allowed")
    assert "plant.example.org" in answered.json()["detail"]
    assert "Host $http_host" in answered.json()["remedy"]
    assert not foreign.json()["remedy"]
    assert "Host $http_host" in unlisted.json()["remedy"]
    assert len([line for line in caplog.messages if "at plant.example.org" in line]) == 1


def test_the_console_names_the_address_with_the_sub_path() -> None:
    serving = with_root_path(Serving(), "/room-2/crenel/")
    with socket.create_server(("127.0.0.1", 0)) as listening:
        address = local_address("127.0.0.1", listening, serving)
        assert address == f"http://127.0.0.1:{listening.getsockname()[1]}/room-2/crenel/"
    with pytest.raises(OperationError, match="--root-path"):
        with_root_path(Serving(), "/viewer")
