"""The connections of the server, and limits of what one may send before it is read.

uvicorn limits neither the header of a request nor the number of connections, and accepts any number
of pipelined requests.
"""

import asyncio
import ipaddress
import time
from collections.abc import Collection
from functools import lru_cache
from typing import Any

from uvicorn._types import ASGISendEvent
from uvicorn.protocols.http.httptools_impl import HttpToolsProtocol
from uvicorn.protocols.utils import ClientDisconnected
from uvicorn.protocols.websockets.websockets_sansio_impl import WebSocketsSansIOProtocol
from websockets.frames import CloseCode

from crenel.security.anonymous_queue import IS_CONNECTED
from crenel.security.login_throttle import address_key

LARGEST_HEAD = 1 << 15
"""The largest head of a request: its first line with all its headers, or the data after its
body."""
LONGEST_URL = 1 << 13
MOST_HEADERS = 200
"""Each one needs a call; browsers send twenty."""
MOST = 192
MOST_OF_ONE = 128
"""The most connections of one address: some twenty tabs, with the files that they load."""
MOST_AT_ONCE = 320
"""Time until the next check."""
GRACE_S = 0.2
"""Time that a connection may take to send its request before others get priority."""
MOST_AHEAD = 2
"""Requests sent before the answer to the first of them; browsers send none."""
SLICE_BYTES = 4096
DONE = 6
"""Priority of a request that changes something."""
TOO_LARGE = (
    b"HTTP/1.1 431 Request Header Fields Too Large\r\n"
    b"content-type: text/plain; charset=utf-8\r\ncontent-length: 33\r\nconnection: close\r\n\r\n"
    b"The request's headers are > 32 kB"
)


Network = ipaddress.IPv4Network | ipaddress.IPv6Network


class BoundedHttp(HttpToolsProtocol):
    """A connection that is closed if it has too many headers or requests."""

    proxies: Collection[Network] = ()
    """Proxies, whose addresses represent many browsers and have no limit of their own."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self._unread_bytes = 0
        """Counts the bytes of a head, or of the data after a body, since the last data that the
        application may read."""
        self._headers = 0
        """Counts the headers of the current request, or of the data after its body."""
        self.url = b""
        self.since_s = time.monotonic()
        """Time since the last complete request."""
        self.app_state = {**self.app_state, IS_CONNECTED: self._is_connected}

    def _is_connected(self) -> bool:
        return not self.transport.is_closing()

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        super().connection_made(transport)
        if len(self.connections) > MOST_AT_ONCE:
            make_space(self.connections, grace_s=0.0)
            if len(self.connections) > MOST_AT_ONCE:
                transport.abort()

    def data_received(self, data: bytes) -> None:
        for start in range(0, len(data), SLICE_BYTES):
            piece = data[start : start + SLICE_BYTES]
            if self.transport.is_closing():
                return
            if self.transport.get_protocol() is not self:  # a live connection from here on
                self.transport.get_protocol().data_received(piece)  # type: ignore[attr-defined]
                continue
            self._unread_bytes += len(piece)
            super().data_received(piece)
            if self._is_too_large():
                self.transport.write(TOO_LARGE)
                self.transport.close()
            elif len(self.pipeline) > MOST_AHEAD:
                self.transport.close()

    def _is_too_large(self) -> bool:
        too_many = self._headers > MOST_HEADERS or len(self.url) > LONGEST_URL
        return too_many or self._unread_bytes > LARGEST_HEAD

    def on_message_begin(self) -> None:
        self._headers = 0
        super().on_message_begin()

    def on_header(self, name: bytes, value: bytes) -> None:
        self._headers += 1
        super().on_header(name, value)

    def on_headers_complete(self) -> None:
        self._unread_bytes = 0
        super().on_headers_complete()

    def handle_websocket_upgrade(self) -> None:
        """As in uvicorn, which fails at its own headers if they are not ASCII."""
        others = (value for name, value in self.scope["headers"] if name.lower() != b"cookie")
        if all(value.isascii() for value in others):
            super().handle_websocket_upgrade()
        else:
            self.send_400_response("A header of this handshake is not ASCII.")

    def on_body(self, body: bytes) -> None:
        self._unread_bytes = 0
        super().on_body(body)

    def on_message_complete(self) -> None:
        self._unread_bytes = 0
        self.since_s = time.monotonic()
        super().on_message_complete()

    @property
    def claim(self) -> int:
        """Priority of the connection, in ascending order: nothing requested yet, everything
        answered, an incomplete request, an answer that is not read, pages and files, answered
        requests of signed-in users, and running requests."""
        if self.cycle is None:
            return 0
        if self.cycle.response_complete:
            return 5 if self.cycle.scope["state"].get("visitor") else 1
        if self.cycle.more_body:
            return 2
        if self.flow.write_paused:
            return 3
        return 4 if self.scope["method"] in ("GET", "HEAD") else DONE


class BoundedWebSocket(WebSocketsSansIOProtocol):
    """A live connection that receives nothing before it is accepted, and does not answer pings of
    clients that do not read the answers."""

    def data_received(self, data: bytes) -> None:
        if self.handshake_initiated and not self.handshake_complete:
            self.transport.abort()  # every browser waits for the answer
            return
        super().data_received(data)

    async def send(self, message: ASGISendEvent) -> None:
        await self.writable.wait()
        if self.close_sent:  # since a message that was none
            raise ClientDisconnected
        await super().send(message)

    def send_receive_event_to_app(self) -> None:
        if self.curr_msg_data_type == "text" and not self.close_sent:
            try:
                b"".join(self.frames).decode()
            except UnicodeDecodeError:  # a fault of the client, not of the server
                self.frames = []
                self.conn.send_close(CloseCode.INVALID_DATA)
                self.handle_parser_exception()
                return
        super().send_receive_event_to_app()

    def handle_ping(self) -> None:
        answer = b"".join(self.conn.data_to_send())
        if self.writable.is_set():
            self.transport.write(answer)


def http_protocol(proxies: Collection[str]) -> type[BoundedHttp]:
    """The protocol of a server behind these proxies."""
    return type("BoundedHttp", (BoundedHttp,), {"proxies": networks_of(proxies)})


def networks_of(proxies: Collection[str]) -> list[Network]:
    """The networks of proxies, each given as an address or a network."""
    return [ipaddress.ip_network(proxy, strict=False) for proxy in proxies]


def is_among(address: str, proxies: Collection[Network]) -> bool:
    """Whether a connection from this address is a proxy's."""
    if not proxies or not address:
        return False
    plain = ipaddress.ip_address(address.partition("%")[0])
    return any(plain in network for network in proxies)


def make_space(connections: set[Any], grace_s: float = GRACE_S) -> None:
    """Closes surplus connections, those with the lowest priority first.

    A client that opens many connections without requests therefore excludes nobody, even on the
    same machine.
    """
    places: dict[str, list[Any]] = {}
    for connection in connections:
        places.setdefault(_address(connection), []).append(connection)
    for crowd in places.values():
        if not _is_proxy(crowd[0]):
            _drop_surplus(crowd, len(crowd) - MOST_OF_ONE, grace_s)
    if len(connections) > MOST:
        everybody = sorted(places.values(), key=len, reverse=True)
        _drop_surplus(
            [one for crowd in everybody for one in crowd], len(connections) - MOST, grace_s
        )


def _drop_surplus(crowd: list[Any], surplus: int, grace_s: float) -> None:
    """Removes the surplus of a group, as far as it is not being served."""
    if surplus <= 0:
        return
    before_s = time.monotonic() - grace_s
    idle = [one for one in crowd if isinstance(one, BoundedHttp) and one.claim < DONE]
    for one in sorted(idle, key=_rank)[:surplus]:
        # the newest ones are spared for now, and no connection with higher priority is closed
        # instead
        if one.since_s <= before_s:
            one.connections.discard(one)  # it is lost only in the next iteration of the loop
            one.transport.abort()


def _rank(connection: BoundedHttp) -> tuple[int, float]:
    return connection.claim, connection.since_s


def _address(connection: Any) -> str:
    return _client_address(connection.client[0]) if connection.client else ""


_client_address = lru_cache(4096)(address_key)


def _is_proxy(connection: Any) -> bool:
    client = connection.client
    return is_among(client[0] if client else "", getattr(connection, "proxies", ()))
