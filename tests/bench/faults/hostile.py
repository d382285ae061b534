"""What strangers send to a station: floods of one kind each, over plain sockets."""

import random
import socket
import struct
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, suppress
from dataclasses import dataclass

CONNECTIONS = 1000
THREADS = 4
"""Of each flood."""
PATIENCE_S = 3.0
HEAD_BYTES = 100 << 20
PIECE_BYTES = 1 << 16
Address = tuple[str, int]


@dataclass
class FloodCounts:
    """How many requests were sent, and how many were answered by an error of the program."""

    requests: int = 0
    faults: int = 0

    def note(self, answer: bytes) -> None:
        self.requests += 1
        self.faults += answer.startswith(b"HTTP/1.1 500")


Flood = Callable[[Address, float, FloodCounts], None]
"""Goes on until a monotonic time in s."""


def ask(address: Address, request: bytes) -> bytes:
    """The beginning of what is answered; empty where nothing is."""
    with suppress(OSError), socket.create_connection(address, PATIENCE_S) as connection:
        connection.sendall(request)
        return connection.recv(PIECE_BYTES)
    return b""


def get(path: bytes, *headers: bytes, host: bytes = b"127.0.0.1") -> bytes:
    return b"\r\n".join([b"GET " + path + b" HTTP/1.1", b"Host: " + host, *headers, b"", b""])


def post(path: bytes, body: bytes, *headers: bytes) -> bytes:
    length = b"Content-Length: %d" % len(body)
    lines = [b"POST " + path + b" HTTP/1.1", b"Host: 127.0.0.1", length, *headers, b"", body]
    return b"\r\n".join(lines)


JSON = b"Content-Type: application/json"
ODD: tuple[bytes, ...] = (
    get(b"/" + b"a" * 300),
    get(b"/%00"),
    get(b"/%0a%0d%1b[2J"),
    get(b"/%ed%a0%80"),
    get(b"/%ff%fe"),
    get(b"/api/%00"),
    get(b"/..%2f..%2f..%2fetc/passwd"),
    get(b"/api/calibrations/..%2f..%2fx/image/%00"),
    get(b"/viewer/%00"),
    get(b"//evil.example/"),
    get(b"/" + b"%25" * 2000),
    get(b"/?" + b"a=b&" * 1500),
    get(b"/\x1b[31m\xe2\x80\xa8"),
    get(b"/api/home", b"Origin: http://["),
    get(b"/api/home", b"Origin: \xff\xfe"),
    get(b"/api/home", b"Cookie: \xed\xa0\x80=\x00"),
    get(b"/api/home", b"Cookie: crenel=" + b"x" * 4000),
    get(b"/metrics", b"Authorization: Bearer \xff"),
    get(b"/metrics", b"Authorization: " + b"Basic " * 500),
    get(b"/api/session", b"X-Forwarded-For: \xff, ::1%0a"),
    get(b"/api/session", b"Accept-Encoding: " + b"gzip," * 900),
    get(b"/", b"Range: bytes=0-,0-,0-"),
    get(b"/", b"If-Modified-Since: \xff"),
    get(b"/", b"Host: other"),
    get(b"/", host=b"[::1"),
    get(b"/", host=b"\xff:99999999"),
    post(b"/api/session", b'{"name": "\\ud800", "password": "\\ud800"}', JSON),
    post(b"/api/session", b"[" * 100_000, JSON),
    post(b"/api/session", b'{"name": ' + b"9" * 5000 + b"}", JSON),
    post(b"/api/session", b"\xff\xfe\x00", JSON),
    post(b"/api/session", b'{"name": NaN, "password": 1e999}', JSON),
    post(b"/api/session", b"{}", b"Content-Type: \xff/\xff; charset=\x00"),
    post(b"/api/session/code", b'{"code": "\\u0000"}', JSON),
    post(b"/api/session/kiosk", b'{"token": "\xed\xa0\x80"}', JSON),
    post(b"/api/stop", b"", b"Sec-Fetch-Site: cross-site"),
    post(b"/api/session", b"x", b"Transfer-Encoding: chunked"),
    b"POST /api/session HTTP/1.1\r\nHost: a\r\nTransfer-Encoding: chunked\r\n\r\nzz\r\nxx\r\n",
    b"POST /api/session HTTP/1.1\r\nHost: a\r\nContent-Length: -1\r\n\r\n",
    b"POST /api/session HTTP/1.1\r\nHost: a\r\nContent-Length: 99999999999999\r\n\r\n{}",
    b"OPTIONS * HTTP/1.1\r\nHost: a\r\n\r\n",
    b"CONNECT evil.example:443 HTTP/1.1\r\nHost: a\r\n\r\n",
    b"TRACE / HTTP/1.1\r\nHost: a\r\n\r\n",
    b"GET / HTTP/9.9\r\n\r\n",
    b"GET http://evil.example/ HTTP/1.1\r\nHost: evil.example\r\n\r\n",
    b"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n",
    b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03" + bytes(200),
    b"\x00" * 500,
    get(b"/api/live", b"Upgrade: websocket", b"Connection: Upgrade", b"Sec-WebSocket-Version: 1"),
    get(b"/api/live", b"Upgrade: websocket", b"Connection: Upgrade", b"Sec-WebSocket-Key: \xff"),
)
"""Requests that nobody ought to send."""


def odd_requests(address: Address, until_s: float, sent: FloodCounts) -> None:
    rng = random.Random(sent.requests)
    while time.monotonic() < until_s:
        for request in ODD:
            sent.note(ask(address, request))
            cut = bytearray(request[:4096])
            cut[rng.randrange(len(cut))] = rng.randrange(256)
            sent.note(ask(address, bytes(cut) + b"\r\n\r\n"))


def one_header(address: Address, until_s: float, sent: FloodCounts) -> None:
    """100 MB of headers on each connection."""
    piece = b"x" * PIECE_BYTES
    while time.monotonic() < until_s:
        sent.requests += 1
        with suppress(OSError), socket.create_connection(address, PATIENCE_S) as connection:
            connection.sendall(b"GET / HTTP/1.1\r\nHost: a\r\nX: ")
            for _ in range(HEAD_BYTES // PIECE_BYTES):
                connection.sendall(piece)


def many_headers(address: Address, until_s: float, sent: FloodCounts) -> None:
    request = get(b"/", *(b"X-%d: y" % number for number in range(5000)))
    while time.monotonic() < until_s:
        sent.note(ask(address, request))


def long_addresses(address: Address, until_s: float, sent: FloodCounts) -> None:
    number = 0
    while time.monotonic() < until_s:
        number += 1
        sent.note(ask(address, get(b"/api/%d/" % number + b"long" * (number % 2040))))


def big_bodies(address: Address, until_s: float, sent: FloodCounts) -> None:
    body = b'{"name": "' + b"x" * (8 << 20) + b'"}'
    while time.monotonic() < until_s:
        sent.note(ask(address, post(b"/api/session", body, JSON)))


def many_connections(address: Address, until_s: float, sent: FloodCounts) -> None:
    """A thousand at once, each of which has begun a request."""
    while time.monotonic() < until_s:
        with ExitStack() as opened:
            for _ in range(CONNECTIONS):
                with suppress(OSError):
                    one = socket.create_connection(address, PATIENCE_S)
                    opened.enter_context(one)
                    one.sendall(b"GET /")
                sent.requests += 1


def slow_requests(address: Address, until_s: float, sent: FloodCounts) -> None:
    """Two hundred connections, each sending a byte now and then."""
    with ExitStack() as opened:
        held = [opened.enter_context(one) for one in _connections(address, 200)]
        sent.requests += len(held)
        while time.monotonic() < until_s:
            for one in held:
                with suppress(OSError):
                    one.sendall(b"x")
            time.sleep(0.2)


def requests_ahead(address: Address, until_s: float, sent: FloodCounts) -> None:
    """Thousands on one connection, whose answers nobody reads."""
    while time.monotonic() < until_s:
        sent.requests += 1
        with suppress(OSError), socket.create_connection(address, PATIENCE_S) as connection:
            connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
            connection.sendall(get(b"/") * 5000)
            time.sleep(0.05)


def sudden_ends(address: Address, until_s: float, sent: FloodCounts) -> None:
    """Connections that are reset in the middle of a request, or of its answer."""
    while time.monotonic() < until_s:
        sent.requests += 1
        with suppress(OSError):
            one = socket.create_connection(address, PATIENCE_S)
            one.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
            one.sendall(get(b"/")[: 5 + sent.requests % 40])
            one.close()


def _connections(address: Address, number: int) -> Iterator[socket.socket]:
    for _ in range(number):
        with suppress(OSError):
            one = socket.create_connection(address, PATIENCE_S)
            one.sendall(b"POST /api/session HTTP/1.1\r\nHost: a\r\nX: ")
            yield one


FLOODS: dict[str, Flood] = {
    "odd requests": odd_requests,
    "100 MB of one header": one_header,
    "5000 headers": many_headers,
    "long addresses": long_addresses,
    "big bodies": big_bodies,
    "1000 connections": many_connections,
    "slow requests": slow_requests,
    "requests ahead": requests_ahead,
    "sudden ends": sudden_ends,
}


def flood(name: str, address: Address, seconds: float) -> FloodCounts:
    """Floods an address for so long, from all threads."""
    sent, until_s = FloodCounts(), time.monotonic() + seconds
    threads = [
        threading.Thread(target=FLOODS[name], args=(address, until_s, sent)) for _ in range(THREADS)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return sent
