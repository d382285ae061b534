"""Who is let in, what pages may load, and how errors are answered."""

import httpx
import pytest

from app.api import client as client_room
from app.api.guard import Guard
from tests.api.conftest import Server


@pytest.mark.parametrize("host", ["evil.example", "127.0.0.1.evil.example", "", "[", "localhost."])
def test_a_name_that_is_not_the_stations_is_not_answered(server: Server, host: str) -> None:
    answer = server.http.get("/api/home", headers={"host": host})
    assert answer.status_code in (400, 403)
    assert "station" not in answer.json() if answer.status_code == 403 else True


@pytest.mark.parametrize("host", ["localhost", "127.0.0.1", "LOCALHOST", "[::1]"])
def test_local_names_are_answered(server: Server, host: str) -> None:
    named = f"{host}:{server.port}"
    assert server.http.get("/api/home", headers={"host": named}).status_code == 200


@pytest.mark.parametrize(
    "origin", ["http://evil.example", "null", "http://127.0.0.1:1", "https://localhost"]
)
def test_a_foreign_page_changes_nothing(server: Server, origin: str) -> None:
    for path in ("/api/flow/start", "/api/stop", "/api/laser/on", "/api/scan/start"):
        answer = server.http.post(path, headers={"origin": origin}, json={"on": True})
        assert answer.status_code == 403
        assert answer.json()["code"] == "not-allowed"
    assert server.http.get("/api/home", headers={"origin": origin}).status_code == 200


def test_the_own_page_may(server: Server) -> None:
    own = {"origin": server.address}
    assert server.http.post("/api/laser/off", headers=own).status_code == 200


def test_further_names_come_from_the_settings() -> None:
    async def answers(scope: object, receive: object, send: object) -> None: ...

    guard = Guard(answers, hosts=("Station.local", "[fe80::1]"))
    for host, refused in (("station.local:8000", False), ("[fe80::1]:80", False), ("x", True)):
        scope = {"type": "http", "method": "GET", "headers": [(b"host", host.encode())]}
        assert bool(guard._refusal(scope)) is refused


def test_every_page_states_what_it_may_load(server: Server) -> None:
    for path in ("/", "/calibrate", "/api/home", "/api/nothing"):
        headers = server.http.get(path).headers
        assert "default-src 'self'" in headers["content-security-policy"]
        assert "unsafe-eval" not in headers["content-security-policy"]
        assert headers["x-content-type-options"] == "nosniff"
        assert "server" not in headers


@pytest.mark.parametrize(
    ("method", "path", "body", "status"),
    [
        ("GET", "/api/nothing", None, 404),
        ("DELETE", "/api/nothing/at/all", None, 404),
        ("GET", "/api/flow/image/nothing.png", None, 404),
        ("GET", "/api/flow/image/..%2f..%2fstation.db", None, 404),
        ("GET", "/api/scans/none/cloud.ply", None, 404),
        ("GET", "/api/calibrations/..%2f..%2fstation.db/calibration.json", None, 404),
        ("POST", "/api/scan/hand", b'{"on": 1}', 422),
        ("POST", "/api/scan/hand", b'{"on"', 422),
        ("POST", "/api/scan/hand", b"", 422),
        ("POST", "/api/exposure", b'{"exposure_us": -5}', 422),
        ("POST", "/api/exposure", b'{"exposure_us": NaN}', 422),
        ("POST", "/api/flow/command", b'{"name": "undo"}', 422),
        ("POST", "/api/flow/command", b'{"name":"undo","args":{},"rev":"1","key":"k"}', 422),
        ("POST", "/api/flow/command", b'{"name":"undo","args":{},"rev":1,"key":""}', 422),
        ("POST", "/api/scan/start", b'{"name": "' + b"x" * 500 + b'"}', 422),
        ("PUT", "/api/home", None, 404),
    ],
)
def test_errors_are_problems_in_words(
    server: Server, method: str, path: str, body: bytes | None, status: int
) -> None:
    headers = {"content-type": "application/json"} if body is not None else {}
    answer = server.http.request(method, path, content=body, headers=headers)
    assert answer.status_code == status
    assert answer.headers["content-type"] == "application/problem+json"
    problem = answer.json()
    assert problem["status"] == status
    assert problem["detail"].endswith(".")
    assert "view" not in problem
    assert "Traceback" not in answer.text


def test_what_fails_unexpectedly_tells_no_insides(
    server: Server, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    def broken() -> list[object]:
        raise RuntimeError("secret insides")

    monkeypatch.setattr(server.context.store.scans, "all", broken)
    answer = server.http.get("/api/scans")
    assert answer.status_code == 500
    assert "secret" not in answer.text
    assert answer.json()["remedy"]
    assert "secret insides" in caplog.text


def test_a_client_that_was_not_built_is_said_so(
    server: Server, monkeypatch: pytest.MonkeyPatch, tmp_path: object
) -> None:
    monkeypatch.setattr(client_room, "STATIC", tmp_path)
    answer = server.http.get("/")
    assert answer.status_code == 503
    assert "not built" in answer.text
    assert server.http.get("/api/home").status_code == 200


def test_the_built_client_is_served_with_every_address(
    server: Server, monkeypatch: pytest.MonkeyPatch, tmp_path_factory: pytest.TempPathFactory
) -> None:
    built = tmp_path_factory.mktemp("static")
    (built / "assets").mkdir()
    (built / "index.html").write_text("<title>Crenel</title>")
    (built / "assets" / "app-3f2a.js").write_text("export {}")
    (built.parent / "outside.txt").write_text("secret")
    monkeypatch.setattr(client_room, "STATIC", built)
    http: httpx.Client = server.http
    for path in ("/", "/calibrate", "/records/scans"):
        page = http.get(path)
        assert page.text == "<title>Crenel</title>"
        assert page.headers["cache-control"] == "no-cache"
    script = http.get("/assets/app-3f2a.js")
    assert "immutable" in script.headers["cache-control"]
    assert "javascript" in script.headers["content-type"]
    for path in ("/assets/gone.js", "/gone.svg", "/..%2foutside.txt", "/%2e%2e/outside.txt"):
        assert http.get(path).status_code == 404
    assert http.head("/").status_code == 200
