"""Queues requests without a sign-in, so that Stop waits for none of them.

Every request that is processed concurrently delays all others. Anonymous requests therefore have
few slots, and signed-in users as many as they need.
"""

import asyncio
import hashlib
import time
from collections import OrderedDict
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager

from starlette.requests import HTTPConnection
from starlette.responses import Response
from starlette.types import ASGIApp, Message, Receive, Scope, Send

PLACES = 2
"""Number of anonymous requests processed concurrently."""
TRUSTED_S = 300.0
"""A browser does not queue for this long after it was found signed in."""
MOST_TRUSTED = 512
IS_CONNECTED = "is_connected"
"""In the state of a request: whether its connection still exists."""
TURN = "turn"
"""In the state of an anonymous request: its slot."""


class AnonymousQueue:
    """ASGI middleware around the whole application."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app
        self._places = asyncio.Semaphore(PLACES)
        self._trusted: OrderedDict[bytes, float] = OrderedDict()
        """Expiry time by the digest of a browser's cookies."""

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] not in ("http", "websocket"):
            await self._app(scope, receive, send)
            return
        cookies = _digest(scope)
        if self._trusted.get(cookies, 0.0) > time.monotonic():
            await self._app(scope, receive, send)
            return
        turn = _Turn(self._places, receive, send)
        scope.setdefault("state", {})[TURN] = turn
        await turn.begin()
        try:
            if _is_connected(scope):
                await self._app(scope, turn.receive, turn.send)
            else:
                await _end(scope, send)
        finally:
            turn.end()
        if scope.get("state", {}).get("visitor") is not None:
            self._trust(cookies)

    def _trust(self, cookies: bytes) -> None:
        self._trusted[cookies] = time.monotonic() + TRUSTED_S
        self._trusted.move_to_end(cookies)
        if len(self._trusted) > MOST_TRUSTED:
            self._trusted.popitem(last=False)


class _Turn:
    """A slot for an anonymous request, from the first step to the answer; not while waiting for the
    network."""

    def __init__(self, places: asyncio.Semaphore, receive: Receive, send: Send) -> None:
        self._places, self._receive, self._send = places, receive, send
        self._has_place = self._answered = False

    async def begin(self) -> None:
        await self._places.acquire()
        self._has_place = True

    def end(self) -> None:
        if self._has_place:
            self._has_place = False
            self._places.release()

    async def receive(self) -> Message:
        self.end()
        message = await self._receive()
        if not self._answered:
            await self.begin()
        return message

    async def send(self, message: Message) -> None:
        self._answered = True
        self.end()
        await self._send(message)


@asynccontextmanager
async def without_place(connection: HTTPConnection) -> AsyncIterator[None]:
    """Leaves the slot to others while an anonymous request waits for another server."""
    turn: _Turn | None = connection.scope.get("state", {}).get(TURN)
    if turn is None:
        yield
        return
    turn.end()
    try:
        yield
    finally:
        await turn.begin()


def _is_connected(scope: Scope) -> bool:
    """Whether anyone is left to answer: a flood comes and goes faster than it is served."""
    is_connected: Callable[[], bool] | None = scope.get("state", {}).get(IS_CONNECTED)
    return is_connected is None or is_connected()


async def _end(scope: Scope, send: Send) -> None:
    """Nobody reads it; without it, the server would report the silence as a fault."""
    if scope["type"] == "http":
        await Response(status_code=503)(scope, _nothing, send)
    else:
        await send({"type": "websocket.close"})


async def _nothing() -> Message:
    return {"type": "http.disconnect"}


def _digest(scope: Scope) -> bytes:
    cookies = b";".join(value for name, value in scope["headers"] if name == b"cookie")
    return hashlib.sha256(cookies).digest()
