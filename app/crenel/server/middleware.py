"""Which pages may access the server, and what its own pages may load.

The server answers only to its own names and to plain addresses (which prevents DNS rebinding: no
foreign page has an address as its name), and accepts changes and live connections only from its own
pages (which stops foreign pages in the same browser). Requests must be small and arrive quickly,
because they are read before their sender is known. Permissions are checked after this, in
``access``.
"""

import asyncio
import ipaddress
from collections.abc import Collection
from dataclasses import dataclass
from urllib.parse import urlsplit

from starlette.datastructures import Headers, MutableHeaders
from starlette.responses import PlainTextResponse
from starlette.types import ASGIApp, Receive, Scope, Send
from starlette.types import Message as AsgiMessage

from crenel.api.access.sub_path import sub_path_of
from crenel.messages.message import Text, message, quantity
from crenel.report.html_policy import POLICY
from crenel.server.behind_proxy import Complaints
from crenel.wire.json_response import RequestError, problem

LOCAL_NAMES = ("localhost", "127.0.0.1", "::1")
LARGEST_BODY = 1 << 18
BODY_S = 15.0
PRIVATE_PATHS = ("/api/", "/metrics")
"""Private content, also for a later user of the same browser."""
SAFE_METHODS = ("GET", "HEAD", "OPTIONS")
SCHEMES = ("http", "https", "ws", "wss")
OWNED_SITES = ("same-origin", "none")
"""Browsers' marks of a request by the station's own pages, or of a typed address."""
LONGEST_PATH, LONGEST_PART = 1024, 200
NOTHING = message("no-page-file-has-such-address")
FOREIGN = message("only-stations-own-pages-may-do")
PAGES = (
    "default-src 'self'; img-src 'self' data: blob:; style-src 'self' 'unsafe-inline'; "
    "frame-ancestors 'self'; object-src 'none'; base-uri 'none'; form-action 'none'"
)
# The viewer's page is one file that unpacks its own script and WebAssembly. It may reach only the
# scene.
VIEWER = (
    "default-src 'self'; script-src 'self' 'unsafe-inline' 'unsafe-eval' blob:; "
    "style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; font-src 'self' data:; "
    "connect-src {places} data: blob:; worker-src 'self' blob:; "
    "frame-ancestors 'self'; object-src 'none'; base-uri 'none'; form-action 'none'"
)

# A report is read and printed; its content is never executed or fetched.
REPORT = f"{POLICY}; sandbox; frame-ancestors 'self'; base-uri 'none'; form-action 'none'"


@dataclass(frozen=True, slots=True)
class RequestRefusal:
    """Why a request is refused; with a ``kind``, a proxy may be the cause, and it is logged."""

    what: Text
    remedy: Text = ""
    kind: str = ""


class Guard:
    """ASGI middleware around the whole application.

    Args:
        hosts: additional names by which browsers may reach the server.
        file: the settings in which they are given.
    """

    def __init__(
        self, app: ASGIApp, hosts: Collection[str] = (), file: str = "station.toml"
    ) -> None:
        self._app, self._file = app, file
        self._hosts = {*LOCAL_NAMES, *(host.lower().strip("[]") for host in hosts)}
        self._complaints = Complaints()

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] not in ("http", "websocket"):
            await self._app(scope, receive, send)
            return
        refusal = self._refusal(scope)
        if refusal is not None:
            if refusal.kind:
                self._complaints.log(refusal.kind, refusal.what, refusal.remedy)
            await _refuse(refusal, scope, receive, send)
            return
        path = scope["path"]
        if not _may_be(path):
            await _refuse(RequestRefusal(NOTHING), scope, receive, send, 404)
            return
        if scope["type"] == "http":
            receive = _Body(receive)
        await self._app(scope, receive, _with_headers(send, _policy(scope), path))

    def _refusal(self, scope: Scope) -> RequestRefusal | None:
        headers = Headers(scope=scope)
        host = headers.get("host", "").lower()
        if _name(host) not in self._hosts and not _is_address(_name(host)):
            name = _name(host)
            what = message("station-does-not-answer-to-name", name=name, file=self._file)
            return RequestRefusal(what, message("proxy-pass-host"), "name")
        if scope["type"] == "http" and scope["method"] in SAFE_METHODS:
            return None
        origin, site = headers.get("origin"), headers.get("sec-fetch-site", "none")
        if site.lower() not in OWNED_SITES:
            return RequestRefusal(FOREIGN)
        if origin is None or _place(origin) == host:
            return None
        if not _name(_place(origin)):
            return RequestRefusal(FOREIGN)
        what = message("proxy-changes-host", page=_place(origin), host=host)
        return RequestRefusal(what, message("proxy-pass-host"), "host")


def _may_be(path: str) -> bool:
    """Whether a path can exist; nothing has such long names, or control characters."""
    longest = max(map(len, path.split("/")))
    return path.isprintable() and len(path) <= LONGEST_PATH and longest <= LONGEST_PART


def _policy(scope: Scope) -> str:
    path: str = scope["path"]
    if path.startswith("/viewer/"):
        host = Headers(scope=scope).get("host", "")
        place = f"{host}{sub_path_of(scope)}/viewer/"
        return VIEWER.format(places=" ".join(f"{one}://{place}" for one in SCHEMES))
    return REPORT if path.endswith("/report.html") else PAGES


def _place(origin: str) -> str:
    """The host with its port; an empty string if it is not an address."""
    try:
        return urlsplit(origin).netloc.lower()
    except ValueError:
        return ""


def _name(host: str) -> str:
    """The host without its port and brackets; an empty string if it is not a host."""
    try:
        parts = urlsplit(f"//{host}")
        plain = parts.netloc == host and "@" not in host and parts.port != 0
        return (parts.hostname or "") if plain else ""
    except ValueError:
        return ""


def _is_address(name: str) -> bool:
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True


class _Body:
    """Receives a request: its body up to ``LARGEST_BODY``, within ``BODY_S``.

    Raises:
        RequestError: it is too large or too late.
    """

    def __init__(self, receive: Receive) -> None:
        self._receive, self._bytes, self._is_complete = receive, 0, False
        self._until_s = 0.0

    async def __call__(self) -> AsgiMessage:
        if self._is_complete:
            return await self._receive()
        self._until_s = self._until_s or asyncio.get_running_loop().time() + BODY_S
        try:
            async with asyncio.timeout_at(self._until_s):
                part = await self._receive()
        except TimeoutError:
            late = message("request-did-not-arrive", limit=quantity(BODY_S, "s"))
            raise RequestError(408, late) from None
        self._bytes += len(part.get("body", b""))
        self._is_complete = not part.get("more_body", False)
        if self._bytes > LARGEST_BODY:
            limit = quantity(LARGEST_BODY // 1024, "kB")
            raise RequestError(413, message("more-than-kb-were-sent", limit=limit))
        return part


async def _refuse(
    refusal: RequestRefusal, scope: Scope, receive: Receive, send: Send, status: int = 403
) -> None:
    if scope["type"] == "websocket":
        await receive()
        await send({"type": "websocket.close", "code": 1008, "reason": str(refusal.what)[:120]})
        return
    if "text/html" in Headers(scope=scope).get("accept", ""):  # somebody reads it
        text = f"{refusal.what!s} {refusal.remedy!s}".strip()
        await PlainTextResponse(text, status)(scope, receive, send)
        return
    code = "not-found" if status == 404 else "not-allowed"
    await problem(status, code, refusal.what, refusal.remedy)(scope, receive, send)


def _with_headers(send: Send, policy: str, path: str) -> Send:
    own = path.startswith(PRIVATE_PATHS)

    async def sending(part: AsgiMessage) -> None:
        if part["type"] == "http.response.start":
            headers = MutableHeaders(scope=part)
            headers["Content-Security-Policy"] = policy
            headers["X-Content-Type-Options"] = "nosniff"
            headers["Referrer-Policy"] = "same-origin"
            headers["Cross-Origin-Opener-Policy"] = "same-origin"
            headers["Cross-Origin-Resource-Policy"] = "same-origin"
            if own:
                headers.setdefault("Cache-Control", "no-store")
        await send(part)

    return sending
