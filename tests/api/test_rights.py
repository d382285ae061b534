"""Every route and every message, for everyone who may come: nobody, a kiosk, each role."""

import itertools
import json
import re
from collections.abc import Iterator

import httpx
import pytest
from fastapi.routing import APIRoute, APIWebSocketRoute
from websockets.exceptions import InvalidStatus
from websockets.sync.client import connect

from crenel.api import live
from crenel.api.access.authorization import authorise
from crenel.api.access.browser import cookie_for
from crenel.security.permissions import MESSAGES, ROUTES, WEBSOCKET, Right, Rule
from crenel.store.accounts import Role
from tests.api.conftest import PATIENCE_S, Server, until_closed

pytestmark = pytest.mark.device

ROLES = ("viewer", "operator", "admin")
WHO = ("nobody", "kiosk", *ROLES)
MAY = {
    Right.enter: set(WHO),
    Right.look: {"kiosk", *ROLES},
    Right.scrape: {"kiosk", *ROLES},
    Right.be: set(ROLES),
    Right.operate: {"operator", "admin"},
    Right.act: {"operator", "admin"},
    Right.administer: {"admin"},
}
HTTP = [key for key in ROUTES if key[0] != WEBSOCKET]
LIVE = [key for key in ROUTES if key[0] == WEBSOCKET]


@pytest.fixture(scope="module")
def tokens(server: Server) -> Iterator[dict[str, str]]:
    store = server.context.store
    for name in ROLES:
        store.accounts.add(f"the {name}", Role[name], None)
    kiosk, token = store.kiosk_links.add("the kiosk", "the admin")
    people = {name: store.login_sessions.begin(f"the {name}", "test") for name in ROLES}
    yield {"nobody": "", "kiosk": token, **people}
    store.kiosk_links.remove(kiosk.id)
    for name in ROLES:
        store.accounts.remove(f"the {name}")
    server.http.post("/api/control/take", json={"reason": "the test is over"}).raise_for_status()
    server.http.post("/api/stop").raise_for_status()
    if server.flow()["running"]:
        server.do("abandon")


@pytest.fixture(scope="module")
def stranger(server: Server) -> Iterator[httpx.Client]:
    with httpx.Client(base_url=server.address, timeout=PATIENCE_S) as http:
        yield http


def cookie(server: Server, token: str) -> dict[str, str]:
    return {"Cookie": f"{cookie_for(server.port)}={token}"} if token else {}


def test_every_route_has_its_rule_and_every_rule_its_route(server: Server) -> None:
    found = {
        (method, route.path)
        for route in server.application.routes
        if isinstance(route, APIRoute | APIWebSocketRoute)
        for method in (getattr(route, "methods", None) or {WEBSOCKET})
    }
    assert found == set(ROUTES)


def test_every_route_is_authorised_first(server: Server) -> None:
    for route in server.application.routes:
        assert isinstance(route, APIRoute | APIWebSocketRoute)
        assert route.dependant.dependencies[0].call is authorise, route.path


@pytest.mark.parametrize(("method", "path"), HTTP)
def test_a_route_lets_in_whom_it_should(
    server: Server, stranger: httpx.Client, tokens: dict[str, str], method: str, path: str
) -> None:
    right = ROUTES[method, path].right
    address = re.sub(r"{[^}]+}", "nothing", path)
    stranger.cookies.clear()
    for who in WHO:
        if (method, path) == ("DELETE", "/api/session") and who != "nobody":
            continue  # it ends the very sign-in, which tests/api/test_session.py looks at
        headers = cookie(server, tokens[who])
        answer = stranger.request(method, address, headers=headers, json={"neither": "nor"})
        code = answer.json()["code"] if is_problem(answer) else ""
        if who in MAY[right]:
            assert code not in ("signed-out", "role", "not-allowed"), (who, answer.text)
            assert answer.status_code != 500
        else:
            expected = (401, "signed-out") if who == "nobody" else (403, "role")
            assert (answer.status_code, code) == expected, who


def is_problem(answer: httpx.Response) -> bool:
    reported = "problem" in answer.headers.get("content-type", "")
    return reported and answer.request.method != "HEAD"


@pytest.mark.parametrize("path", [path for _, path in LIVE])
def test_who_may_look_is_connected_live(server: Server, tokens: dict[str, str], path: str) -> None:
    address = f"ws://127.0.0.1:{server.port}{path.replace('{key}', 'a' * 16)}"
    for who in WHO:
        headers = cookie(server, tokens[who])
        if who == "nobody":
            with pytest.raises(InvalidStatus) as refused:
                connect(address, additional_headers=headers)
            assert refused.value.response.status_code == 403
        else:
            with connect(address, additional_headers=headers, close_timeout=0.5):
                pass


@pytest.mark.parametrize(
    ("kind", "who"), list(itertools.product(sorted({*MESSAGES, "shutdown", "share"}), WHO[1:]))
)
def test_a_message_is_obeyed_or_ends_the_connection(
    server: Server, tokens: dict[str, str], kind: str, who: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(live, "BEAT_S", 0.05)
    off: dict[str, object] = {"on": False}
    rest: dict[str, dict[str, object]] = {
        "preview": off,
        "stations": off,
        "preview_ack": {"seq": 1},
    }
    with connect(server.live, additional_headers=cookie(server, tokens[who])) as socket:
        socket.send(json.dumps({"type": kind, **rest.get(kind, {})}))
        if kind in MESSAGES and who in MAY[MESSAGES[kind]]:
            for _ in range(2):
                while '"beat"' not in str(socket.recv(PATIENCE_S)):
                    continue
        else:
            assert until_closed(socket) == 1008


def test_a_route_without_a_rule_is_denied_to_everyone(
    server: Server, tokens: dict[str, str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delitem(ROUTES, ("GET", "/api/home"))
    with httpx.Client(base_url=server.address) as http:
        for who in WHO:
            answer = http.get("/api/home", headers=cookie(server, tokens[who]))
            assert (answer.status_code, answer.json()["code"]) == (403, "not-allowed")
    monkeypatch.setitem(ROUTES, ("GET", "/api/home"), Rule(Right.look))
