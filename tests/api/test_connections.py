"""Floods at the server's own socket: what is kept of them, and who is served meanwhile."""

import contextlib
import socket
import time
from collections.abc import Iterator

import httpx
import pytest

from crenel.server import connections
from crenel.server.connections import LARGEST_HEAD, LONGEST_URL, MOST_HEADERS
from tests.api.conftest import PATIENCE_S, Server, wait_for

pytestmark = pytest.mark.device

HEAD = b"GET /api/session HTTP/1.1\r\nHost: localhost\r\n"
UPGRADE = HEAD.replace(b"session", b"live") + b"Upgrade: websocket\r\nConnection: Upgrade\r\n"


@contextlib.contextmanager
def connected(server: Server) -> Iterator[socket.socket]:
    with socket.create_connection(("127.0.0.1", server.port), timeout=PATIENCE_S) as own:
        yield own


def answer_to(server: Server, *parts: bytes) -> bytes:
    """What the server says first; it may close while it is still sent to."""
    with connected(server) as own:
        with contextlib.suppress(ConnectionError):
            for part in parts:
                own.sendall(part)
        try:
            return own.recv(1000)
        except ConnectionError:
            return b"closed"


@pytest.fixture
def few_places(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(connections, "MOST_OF_ONE", 20)
    monkeypatch.setattr(connections, "MOST_AT_ONCE", 60)


def stop_over(own: socket.socket, server: Server) -> bytes:
    stop = f"POST /api/stop HTTP/1.1\r\nHost: localhost:{server.port}\r\n"
    own.sendall(f"{stop}Cookie: {server.cookie['Cookie']}\r\nContent-Length: 0\r\n\r\n".encode())
    return own.recv(1000)


@pytest.mark.parametrize(
    "much",
    [
        HEAD + b"X: " + b"v" * LARGEST_HEAD,
        HEAD + b"".join(b"X-%d: v\r\n" % number for number in range(10_000)),
        b"GET /" + b"a" * (LARGEST_HEAD + 1000),
        b"GET /" + b"a" * 2 * LONGEST_URL + b" HTTP/1.1\r\nHost: localhost\r\n\r\n",
        HEAD + b"X:\r\n" * 5 * MOST_HEADERS + b"\r\n",
        b"POST /api/nothing HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n"
        + b"".join(b"T-%d: %s\r\n" % (number, b"v" * 1000) for number in range(100)),
    ],
    ids=["one", "many", "address", "whole address", "whole many", "trailers"],
)
def test_headers_are_taken_up_to_32_kb(server: Server, much: bytes) -> None:
    answer = answer_to(server, much)
    assert answer.startswith(b"HTTP/1.1 431") or b"HTTP/1.1 404" in answer or answer == b"closed"
    assert b"200 OK" not in answer


@pytest.mark.parametrize(
    "parts",
    [(b"\r\n", HEAD + b"\r\n"), (HEAD, b"X: " + b"v" * 30_000, b"\r\n\r\n")],
    ids=["nothing before", "30 kB"],
)
def test_what_is_unusual_but_allowed_is_answered(server: Server, parts: tuple[bytes, ...]) -> None:
    assert answer_to(server, *parts).startswith(b"HTTP/1.1 200")


def test_requests_that_wait_for_no_answer_are_few(server: Server) -> None:
    with connected(server) as own, contextlib.suppress(ConnectionError):
        for _ in range(1000):
            own.sendall((HEAD + b"\r\n") * 100)
        pytest.fail("a connection may not go on asking")


@pytest.mark.parametrize("header", [b"Sec-WebSocket-Key", b"Origin", b"Sec-WebSocket-Protocol"])
def test_a_handshake_with_other_characters_is_refused(
    server: Server, caplog: pytest.LogCaptureFixture, header: bytes
) -> None:
    assert answer_to(server, UPGRADE + header + b": \xff\r\n\r\n").startswith(b"HTTP/1.1 400")
    assert not [one for one in caplog.records if one.levelname == "ERROR"]


def test_early_bytes_end_a_connection(server: Server, caplog: pytest.LogCaptureFixture) -> None:
    key = b"Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n"
    assert answer_to(server, UPGRADE + key + b"\x00" * 100_000) in (b"", b"closed")
    assert "Fatal error" not in caplog.text


def test_a_crowd_that_asks_nothing_leaves_its_places(server: Server, few_places: None) -> None:
    with contextlib.ExitStack() as crowd:
        silent = [crowd.enter_context(connected(server)) for _ in range(100)]
        for one in silent:
            with contextlib.suppress(ConnectionError):
                one.sendall(HEAD)
        for _ in range(5):
            with httpx.Client(base_url=server.address, timeout=PATIENCE_S) as other:
                assert other.get("/api/session").status_code == 200
        left = wait_for(lambda: sum(map(is_open, silent)), lambda left: left <= 20)
        assert left, "a few may wait"


def test_a_crowd_takes_no_place_of_a_signed_in_user(server: Server, few_places: None) -> None:
    with connected(server) as own, contextlib.ExitStack() as crowd:
        for _ in range(10):
            for number in range(40):
                one = crowd.enter_context(connected(server))
                with contextlib.suppress(ConnectionError):
                    one.sendall(HEAD + b"\r\n" if number % 2 else b"")
            assert stop_over(own, server).startswith(b"HTTP/1.1 204")


def test_an_idle_user_outlives_a_crowd(server: Server, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(connections, "MOST_OF_ONE", 20)
    with connected(server) as own:
        assert stop_over(own, server).startswith(b"HTTP/1.1 204")
        time.sleep(2 * connections.GRACE_S)
        ends = time.monotonic() + 2.0
        while time.monotonic() < ends:
            with contextlib.ExitStack() as crowd:
                for _ in range(30):
                    crowd.enter_context(connected(server))
                time.sleep(0.6 * connections.GRACE_S)
        assert stop_over(own, server).startswith(b"HTTP/1.1 204")


def is_open(connection: socket.socket) -> bool:
    connection.setblocking(False)
    try:
        return connection.recv(1) != b""
    except BlockingIOError:
        return True
    except ConnectionError:
        return False
