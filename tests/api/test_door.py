"""Who is let in, what pages may load, and how errors are answered."""

import contextlib
import gzip
import http.client
import threading
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from types import SimpleNamespace

import httpx
import pytest

from crenel.api import reports, static_files
from crenel.errors import OperationError
from crenel.server import listener as serving
from crenel.server import middleware as guard
from crenel.server.middleware import LARGEST_BODY, Guard
from crenel.store.database import Database
from tests.api.conftest import PATIENCE_S, Server, code_of, wait_for
from tests.api.test_connections import connected

pytestmark = pytest.mark.device


@pytest.mark.parametrize("host", ["evil.example", "127.0.0.1.evil.example", "", "[", "localhost."])
def test_a_name_that_is_not_the_stations_is_not_answered(server: Server, host: str) -> None:
    answer = server.http.get("/api/home", headers={"host": host})
    assert answer.status_code in (400, 403)
    assert "station" not in answer.json() if answer.status_code == 403 else True


LOCAL = ["localhost", "127.0.0.1", "LOCALHOST", "[::1]"]
PLAIN = ["192.168.1.20", "[fe80::1]:8000", "10.0.0.5:8000"]
"""No page of somebody else's can have an address for its name."""


@pytest.mark.parametrize("host", [*(f"{name}:{{port}}" for name in LOCAL), *PLAIN])
def test_local_names_and_plain_addresses_are_answered(server: Server, host: str) -> None:
    path = "/api/session" if host in PLAIN else "/api/home"  # no cookie goes to another address
    headers = {"host": host.format(port=server.port)}
    assert server.http.get(path, headers=headers).status_code == 200


@pytest.mark.parametrize(
    "origin", ["http://evil.example", "null", "http://127.0.0.1:1", "https://localhost"]
)
def test_a_foreign_page_changes_nothing(server: Server, origin: str) -> None:
    for path in ("flow/start", "stop", "laser/on", "scan/start", "settings"):
        answer = server.http.post(f"/api/{path}", headers={"origin": origin}, json={"on": True})
        assert code_of(answer) == (403, "not-allowed")
    assert server.http.get("/api/home", headers={"origin": origin}).status_code == 200


@pytest.mark.parametrize("origin", ["http://[", "http://[::1", "//", "\\", "http://\xff"])
def test_an_origin_that_is_none_is_a_foreign_one(server: Server, origin: str) -> None:
    headers = {b"origin": origin.encode("latin-1")}
    assert server.http.post("/api/stop", headers=headers).status_code == 403


@pytest.mark.parametrize(
    ("site", "status"),
    [("cross-site", 403), ("same-site", 403), ("same-origin", 204), ("none", 204)],
)
def test_what_is_marked_as_anothers_is_refused(server: Server, site: str, status: int) -> None:
    assert server.http.post("/api/stop", headers={"sec-fetch-site": site}).status_code == status
    assert server.http.get("/api/home", headers={"sec-fetch-site": "cross-site"}).is_success


@pytest.mark.parametrize(
    "path",
    [
        *("/" + "a" * 300, "/" + "a/" * 3000, "/assets/" + "a" * 150 + "/" * 900),
        *("/%00", "/assets/%00.js", "/api/%00", "/viewer/%00", "/api/scans/%00/cloud.ply"),
        *("/%1b%5b31m", "/x%e2%80%a8y"),
    ],
)
def test_an_address_that_nothing_can_have_is_not_found(
    server: Server, path: str, caplog: pytest.LogCaptureFixture
) -> None:
    assert server.http.get(path).status_code == 404
    assert not [one for one in caplog.records if one.levelname in ("WARNING", "ERROR")]


def test_the_own_page_may(server: Server) -> None:
    own = {"origin": server.address}
    assert server.http.post("/api/laser/off", headers=own).status_code == 200


def test_further_names_come_from_the_settings() -> None:
    async def answers(scope: object, receive: object, send: object) -> None: ...

    at_the_door = Guard(answers, hosts=("Station.local",))
    for host, refused in (("station.local:8000", False), ("station:8000", True), ("x", True)):
        scope = {"type": "http", "method": "GET", "headers": [(b"host", host.encode())]}
        assert bool(at_the_door._refusal(scope)) is refused


def test_a_person_at_a_wrong_name_reads_plain_words(server: Server) -> None:
    answer = server.http.get("/", headers={"host": "evil.example", "accept": "text/html"})
    assert answer.status_code == 403
    assert answer.text.startswith("This server does not respond to the name 'evil.example'.")


def test_what_a_stranger_sends_is_small(server: Server) -> None:
    headers = {"content-type": "application/json"}

    def much() -> Iterator[bytes]:
        for _ in range(100):
            yield b" " * LARGEST_BODY

    with httpx.Client(base_url=server.address, timeout=PATIENCE_S) as nobody:
        answer = nobody.post("/api/session", content=much(), headers=headers)
    assert answer.status_code == 413
    assert answer.json()["detail"] == "The request is larger than 256 kB."


def test_what_is_sent_comes_soon(server: Server, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(guard, "BODY_S", 0.2)
    with connected(server) as slow:
        asked = f"POST /api/session HTTP/1.1\r\nHost: localhost:{server.port}\r\n"
        slow.sendall(f"{asked}Content-Length: 50\r\n\r\n{{".encode())
        assert slow.recv(100).startswith(b"HTTP/1.1 408")


def test_a_silent_connection_is_closed(server: Server, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(serving, "SILENT_S", 0.5)
    with connected(server) as silent, connected(server) as begun:
        begun.sendall(b"GET /api/home HTTP/1.1\r\nHost: loc")
        assert silent.recv(100) == b""
        assert begun.recv(100) == b""


def test_an_asking_connection_is_kept(server: Server, monkeypatch: pytest.MonkeyPatch) -> None:
    now_s, looks, look = [0.0], [0], serving.StationServer._close_silent

    def counted(station: serving.StationServer) -> None:
        look(station)
        looks[0] += 1

    monkeypatch.setattr(serving, "time", SimpleNamespace(monotonic=lambda: now_s[0]))
    monkeypatch.setattr(serving.StationServer, "_close_silent", counted)
    kept = http.client.HTTPConnection("127.0.0.1", server.port, timeout=PATIENCE_S)
    kept.connect()
    kept.auto_open = 0
    with contextlib.closing(kept):
        for _ in range(4):
            kept.request("GET", "/api/health")
            with kept.getresponse() as answer:
                assert answer.status < 500
                assert answer.read()
            looked = looks[0]
            wait_for(lambda: looks[0], lambda count: count > looked + 1)  # noqa: B023
            now_s[0] += 0.6 * serving.SILENT_S


def test_what_is_ones_own_stays_in_no_browser(server: Server) -> None:
    for path in ("/api/home", "/api/accounts", "/metrics"):
        assert server.http.get(path).headers["cache-control"] == "no-store"


def fill(database: Database) -> None:
    rows = "INSERT INTO audit (at, who, address, act, outcome) VALUES ('', ?, '', '', '')"
    for _ in range(100):
        with database.transaction() as connection:
            connection.execute(rows, ("x" * 4000,))


def test_a_full_disk_is_reported_and_keeps_nobody_from_stop(server: Server) -> None:
    """SQLite itself says that the disk is full: its file may grow no further."""
    server.close()
    database = server.context.store._database
    pages = database.read("PRAGMA page_count")[0][0]
    database.read(f"PRAGMA max_page_count = {pages}")
    try:
        with pytest.raises(OperationError, match="full"):
            fill(database)
        assert server.http.post("/api/stop").status_code == 204
        assert server.http.post("/api/laser/off").status_code == 200
        for _ in range(61):
            answer = server.http.post("/api/kiosk-links", json={"name": "w" * 60})
            if answer.status_code != 200:
                break
        assert answer.status_code == 507
        assert answer.json()["detail"] == "The change was not saved: the station's disk is full."
        for _ in range(300):  # small rows still fit for a while
            answer = server.http.post("/api/flow/start")
            if answer.status_code == 200:
                answer = server.command("abandon")
            if answer.status_code != 200:
                break
        assert answer.status_code == 507
    finally:
        database.read("PRAGMA max_page_count = 1073741823")
    # a session that could not be written is none, and stands in nobody's way
    assert server.http.post("/api/flow/start").json()["running"]
    server.do("confirm_devices")
    server.do("abandon")
    for kiosk in server.http.get("/api/kiosk-links").json():
        server.http.delete(f"/api/kiosk-links/{kiosk['id']}").raise_for_status()


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
        ("POST", "/api/scan/simulation", b'{"on": 1}', 422),
        ("POST", "/api/scan/simulation", b'{"on"', 422),
        ("POST", "/api/scan/simulation", b"", 422),
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


def test_what_fails_unexpectedly_reveals_no_insides(
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
    monkeypatch.setattr(static_files, "STATIC", tmp_path)
    answer = server.http.get("/")
    assert answer.status_code == 503
    assert "not built" in answer.text
    assert server.http.get("/api/home").status_code == 200


CODINGS_SENT = {
    "gzip, deflate, br, zstd": "br",
    "gzip, deflate": "gzip",
    "br;q=0, gzip;q=0.5": "gzip",
    "br;q=0.000, gzip ; q=0": None,
    "brotli": None,
    "": None,
    "*": None,
}
"""What a browser or a proxy accepts, and what it gets."""


def test_the_built_client_is_served_with_every_address(
    server: Server, monkeypatch: pytest.MonkeyPatch, tmp_path_factory: pytest.TempPathFactory
) -> None:
    built = tmp_path_factory.mktemp("static")
    (built / "assets").mkdir()
    (built / "index.html").write_text("<title>Crenel</title>")
    script_text = "export {}" * 100
    (built / "assets" / "app-3f2a.js").write_text(script_text)
    (built / "assets" / "app-3f2a.js.gz").write_bytes(gzip.compress(script_text.encode()))
    (built / "assets" / "app-3f2a.js.br").write_bytes(b"brotli")
    (built / "assets" / "font-9c.woff2").write_bytes(b"font")
    (built.parent / "outside.txt").write_text("secret")
    monkeypatch.setattr(static_files, "STATIC", built)
    http: httpx.Client = server.http
    for path in ("/", "/calibrate", "/records/scans"):
        page = http.get(path)
        assert page.text == "<title>Crenel</title>"
        assert page.headers["cache-control"] == "no-cache"
    script = http.get("/assets/app-3f2a.js")
    assert "immutable" in script.headers["cache-control"]
    for accepts, coding in CODINGS_SENT.items():
        headers = {"accept-encoding": accepts}
        with http.stream("GET", "/assets/app-3f2a.js", headers=headers) as answer:
            content = b"".join(answer.iter_raw())
        assert answer.headers.get("content-encoding") == coding
        assert answer.headers["vary"] == "Accept-Encoding"
        assert "immutable" in answer.headers["cache-control"]
        assert "javascript" in answer.headers["content-type"]
        if coding == "gzip":
            content = gzip.decompress(content)
        assert content == (b"brotli" if coding == "br" else script_text.encode())
    assert "vary" not in http.get("/assets/font-9c.woff2").headers
    for path in ("/assets/gone.js", "/gone.svg", "/..%2foutside.txt", "/%2e%2e/outside.txt"):
        assert http.get(path).status_code == 404
    assert http.head("/").status_code == 200


def test_many_reports_do_not_hinder_stop(server: Server, monkeypatch: pytest.MonkeyPatch) -> None:
    printed = threading.Event()

    def slow(*_: object) -> bytes:
        printed.wait(PATIENCE_S)
        return b"%PDF"

    monkeypatch.setattr(reports, "_verification", lambda *_: server.data)
    monkeypatch.setattr(reports, "render_report", slow)
    with ThreadPoolExecutor(60) as many:
        asked = [many.submit(server.http.get, "/api/verifications/1/report.pdf") for _ in range(60)]
        try:
            for _ in range(5):
                assert server.http.post("/api/stop").status_code == 204
        finally:
            printed.set()
        assert {one.result().status_code for one in asked} == {200}
