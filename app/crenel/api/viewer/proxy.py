"""The 3D view, reached through the origin of this server.

viser listens on loopback and answers this server only (see ``scene_server``), because any of its
clients may change the scene. From browsers, only camera messages are relayed, decoded and encoded
again; everything else is dropped.
"""

import asyncio
import contextlib
import math
import re
from collections.abc import Callable, Sequence
from urllib.parse import quote

import httpx
import msgspec
from fastapi import Request, WebSocket
from starlette.responses import RedirectResponse, Response
from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import ConnectionClosed, InvalidHandshake
from websockets.typing import Subprotocol

from crenel.api.access.authorization import StationRouter
from crenel.api.access.connection import CloseReason, run_connection
from crenel.api.access.sub_path import sub_path_of
from crenel.api.answers.problems import NotFoundError
from crenel.api.viewer.frames import camera_frame
from crenel.api.viewer.labels import LabelWriter
from crenel.api.viewer.point_limit import PointLimiter
from crenel.messages.language_file import ENGLISH, languages
from crenel.messages.message import message
from crenel.operations.context import TheContext, context_of
from crenel.station.view3d.selection import ViewCamera
from crenel.station.view3d.viewpoints import PageCameras, Vector
from crenel.wire.json_response import problem

router = StationRouter()
PASSED_HEADERS = ("content-type", "content-encoding")
TRY_AGAIN_LATER = 1013
KEY = re.compile("([0-9a-f]{16,64})(?:-([1-9][0-9]{0,3}))?(-inch)?(?:-([a-z]{2}))?")
"""A page's own name for its view, as the last part of the viewer's address, followed by the number
of cloud points (in thousands) that it can draw, if that is small, and by its unit and language, if
they are not mm and English."""


class CameraMessage(
    msgspec.Struct, tag="ViewerCameraMessage", tag_field="type", forbid_unknown_fields=True
):
    """viser's message of a browser's viewpoint: the only kind that is relayed."""

    wxyz: tuple[float, float, float, float]
    position: Vector
    fov: float
    near: float
    far: float
    image_height: int
    image_width: int
    look_at: Vector
    up_direction: Vector

    def view_camera(self) -> ViewCamera | None:
        """The viewpoint as the station uses it; None if there is none."""
        finite = all(map(math.isfinite, (*self.wxyz, *self.position)))
        if not finite or not any(self.wxyz) or not 0 < self.fov < math.pi:
            return None
        aspect = max(self.image_width, 1) / max(self.image_height, 1)
        return ViewCamera(self.wxyz, self.position, self.fov, aspect)


CAMERA = msgspec.msgpack.Decoder(CameraMessage)


def decode_camera(message: bytes) -> CameraMessage | None:
    """The part of a browser's message that is relayed to viser: a camera message, or nothing."""
    try:
        return CAMERA.decode(message)
    except msgspec.DecodeError:
        return None


@router.get("/viewer")
def redirect(request: Request) -> Response:
    return RedirectResponse(f"{sub_path_of(request.scope)}/viewer/")


@router.get("/viewer/{path:path}")
async def page(path: str, context: TheContext) -> Response:
    """The viewer's own page."""
    if KEY.fullmatch(path.rstrip("/")):
        path = ""
    address = f"http://127.0.0.1:{context.scene.port}/{quote(path)}"
    try:
        async with (
            httpx.AsyncClient(trust_env=False, timeout=10.0) as client,
            client.stream(
                "GET", address, headers={"accept-encoding": "gzip", **context.scene.key}
            ) as found,
        ):
            # as sent, so that viser's compression stays
            body = b"".join([part async for part in found.aiter_raw()])
    except httpx.HTTPError:
        return problem(
            503, "viewer-gone", message("view-3d-does-not-answer"), message("load-page-again")
        )
    if found.status_code == 404:
        raise NotFoundError(message("there-no-such-page-3d-view"))
    headers = {name: found.headers[name] for name in PASSED_HEADERS if name in found.headers}
    return Response(body, found.status_code, {**headers, "Cache-Control": "no-cache"})


@router.websocket("/viewer")
@router.websocket("/viewer/")
@router.websocket("/viewer/{key}")
@router.websocket("/viewer/{key}/")
async def socket(browser: WebSocket, key: str = "") -> None:
    """Relays the scene to the browser, and the browser's camera back.

    With a key, the station knows the viewpoint of that page, and how much it can draw.
    """
    pages, scene = context_of(browser).view_controller.pages, context_of(browser).scene
    asked = [Subprotocol(name) for name in browser.scope["subprotocols"]]
    try:
        viser = await connect(
            f"ws://127.0.0.1:{scene.port}/",
            additional_headers=scene.key,
            subprotocols=asked or None,
            compression=None,
            max_size=None,
            proxy=None,
            close_timeout=1,
        )
    except (OSError, InvalidHandshake, TimeoutError):
        await browser.accept()
        await browser.close(TRY_AGAIN_LATER, "the 3D view does not respond")
        return

    known = KEY.fullmatch(key)
    page = _Page(browser, pages, known[1] if known else "")
    filters = _filters(known) if known else []
    async with viser:
        await browser.accept(viser.subprotocol)
        try:
            await run_connection(
                browser, _to_browser(viser, browser, filters), _to_viser(browser, viser, page)
            )
        finally:
            page.leave()


def _filters(key: re.Match[str]) -> list[Callable[[bytes], bytes]]:
    """What changes the frames for a browser, by its key."""
    filters: list[Callable[[bytes], bytes]] = []
    if key[2]:
        filters.append(PointLimiter(1000 * int(key[2])).filter_frame)
    language = key[4] if key[4] in languages() else ENGLISH
    if key[3] or language != ENGLISH:
        filters.append(LabelWriter(bool(key[3]), language).filter_frame)
    return filters


class _Page:
    """Reports the viewpoint of a page to the station, under the key of the page, and changes it."""

    def __init__(self, browser: WebSocket, pages: PageCameras, key: str) -> None:
        self._browser, self._pages, self._key = browser, pages, key
        self._loop = asyncio.get_running_loop()
        self._camera: ViewCamera | None = None

    def look(self, message: CameraMessage) -> None:
        camera = message.view_camera()
        if camera is not None and self._key:
            self._camera = camera
            self._pages.look(self._key, camera, self._turn)

    def _turn(self, position_m: Vector, at_m: Vector) -> None:
        """Moves the camera of this browser; called from any thread."""
        sending = self._browser.send_bytes(camera_frame(position_m, at_m))
        asyncio.run_coroutine_threadsafe(sending, self._loop)

    def leave(self) -> None:
        """The connection is closed; the report of a newer one of the same page stays."""
        if self._camera is not None:
            self._pages.leave(self._key, self._camera)


async def _to_browser(
    viser: ClientConnection, browser: WebSocket, filters: Sequence[Callable[[bytes], bytes]]
) -> CloseReason:
    with contextlib.suppress(ConnectionClosed):
        async for message in viser:
            if isinstance(message, bytes):
                for change in filters:
                    message = change(message)
                await browser.send_bytes(message)
    return CloseReason()


async def _to_viser(browser: WebSocket, viser: ClientConnection, page: _Page) -> None:
    with contextlib.suppress(ConnectionClosed):
        while True:
            message = await browser.receive()
            if message["type"] == "websocket.disconnect":
                return
            camera = decode_camera(message.get("bytes") or b"")
            if camera is not None:
                page.look(camera)
                await viser.send(msgspec.msgpack.encode(camera))
