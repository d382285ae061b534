"""The server behind a reverse proxy: the sub-path, and what the proxy does not pass on.

uvicorn applies the addresses and the scheme that listed proxies forward; this does the same with
the sub-path, before it.
"""

import logging
import re
from collections.abc import Collection

from starlette.datastructures import Headers
from starlette.types import ASGIApp, Receive, Scope, Send

from crenel.api.access.sub_path import without_sub_path
from crenel.messages.message import Text, join, message
from crenel.server.connections import is_among, networks_of
from crenel.settings.settings import ROOT_PATH
from crenel.wire.json_response import problem

log = logging.getLogger(__name__)
PREFIX = "x-forwarded-prefix"
HANDSHAKE = "sec-websocket-key"
"""A header that proxies pass on, unlike the upgrade that belongs to it."""


class Complaints:
    """Logs each kind of complaint once: every request repeats it, and strangers can cause it."""

    def __init__(self) -> None:
        self._logged: set[str] = set()

    def log(self, kind: str, what: Text, remedy: Text) -> None:
        """Logs a complaint, unless one of its kind was logged before."""
        if kind not in self._logged:
            self._logged.add(kind)
            log.warning(join([what, remedy], " "))


class BehindProxy:
    """ASGI middleware, the outermost: removes the sub-path from the path of each request, and
    notes it in the scope.

    The proxy may remove the sub-path itself or pass it on. A request that is a WebSocket's without
    its upgrade is refused with what to set, and logged once.

    Args:
        root_path: the sub-path by the settings; what a listed proxy states comes first.
        proxies: their addresses or networks.
    """

    def __init__(self, app: ASGIApp, root_path: str = "", proxies: Collection[str] = ()) -> None:
        self._app, self._root_path = app, root_path
        self._proxies = networks_of(proxies)
        self._complaints = Complaints()

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] not in ("http", "websocket"):
            await self._app(scope, receive, send)
            return
        headers = Headers(scope=scope)
        if scope["type"] == "http" and HANDSHAKE in headers:
            what, remedy = message("proxy-does-not-pass-upgrade"), message("proxy-pass-upgrade")
            self._complaints.log("upgrade", what, remedy)
            await problem(426, "no-upgrade", what, remedy)(scope, receive, send)
            return
        sub_path = self._read_prefix(headers, scope) or self._root_path
        await self._app(without_sub_path(scope, sub_path) if sub_path else scope, receive, send)

    def _read_prefix(self, headers: Headers, scope: Scope) -> str:
        """The sub-path that a listed proxy states; others are not believed."""
        stated = headers.get(PREFIX, "").rstrip("/")
        if not stated:
            return ""
        peer = scope["client"][0] if scope.get("client") else ""
        if not is_among(peer, self._proxies):
            unlisted = message("proxy-not-listed", address=peer)
            self._complaints.log("unlisted", unlisted, message("proxy-list-it"))
            return ""
        if not re.fullmatch(ROOT_PATH, stated):
            unusable = message("proxy-sub-path-unusable")
            self._complaints.log("sub-path", unusable, message("settings-give-root-path"))
            return ""
        return stated
