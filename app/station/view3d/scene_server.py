"""viser's own server, closed to everything except the station's server.

By default, it serves the scene to every program on this machine and every page in its browsers, and
opens a public tunnel on request, in a process forked from the station.
"""

import secrets
import threading
from collections.abc import Callable, Mapping
from hmac import compare_digest
from http import HTTPStatus
from typing import Any

import viser
import websockets.asyncio.server
from viser import _messages
from websockets.asyncio.server import ServerConnection
from websockets.datastructures import Headers
from websockets.http11 import Request, Response

KEY = "X-Scene-Key"
FORBIDDEN = HTTPStatus.FORBIDDEN
SHARING = (_messages.ShareUrlRequest, _messages.ShareUrlDisconnect)
_opening = threading.Lock()

Process = Callable[[ServerConnection, Request], Response | None]


def open_server(label: str) -> tuple[viser.ViserServer, Mapping[str, str]]:
    """The server, and the header that it requires of every request; no browser sends it."""
    key = secrets.token_urlsafe(32)
    serve = websockets.asyncio.server.serve

    def closed(*args: Any, process_request: Process, **options: Any) -> Any:
        def process(connection: ServerConnection, request: Request) -> Response | None:
            given = request.headers.get_all(KEY)
            if "Origin" in request.headers or not any(
                compare_digest(one.encode("utf-8", "replace"), key.encode()) for one in given
            ):
                return Response(FORBIDDEN, FORBIDDEN.phrase, Headers(), b"")
            return process_request(connection, request)

        return serve(*args, process_request=process, **options)

    with _opening:
        # viser has no such option; its server is running after construction
        websockets.asyncio.server.serve = closed  # type: ignore[assignment, misc]
        try:
            server = viser.ViserServer(host="127.0.0.1", port=0, label=label, verbose=False)
        finally:
            websockets.asyncio.server.serve = serve  # type: ignore[misc]
    for message in SHARING:
        server._websock_server.unregister_handler(message)
    return server, {KEY: key}
