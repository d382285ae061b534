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

import numpy as np
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


AXIS_M = 0.2
GRID_LABEL = "□ 100 mm"
"""Size of the grid's squares, without words: viewers of different languages share the scene."""


def prepare_scene(server: viser.ViserServer) -> None:
    """Table, axes and light, without viser's own panels."""
    server.gui.configure_theme(show_logo=False, show_share_button=False, brand_color=(38, 132, 190))
    server.gui.main_panel.minimize()
    server.scene.configure_default_lights(enabled=True, cast_shadow=False)
    server.scene.add_grid(
        "/table",
        width=2.0,
        height=2.0,
        cell_size=0.1,
        cell_thickness=0.5,
        cell_color=(150, 156, 164),
        section_size=0.5,
        section_thickness=0.8,
        section_color=(134, 140, 148),
        fade_distance=2.5,
        fade_strength=1.5,
        fade_from="origin",
        shadow_opacity=0.0,
    )
    server.scene.add_frame("/axes", axes_length=AXIS_M, axes_radius=0.003, origin_radius=0.006)
    for i, axis in enumerate("XYZ"):
        end = 1.12 * AXIS_M * np.eye(3)[i]
        server.scene.add_label(f"/axes/{axis}", axis, position=end, anchor="center-center")
    server.scene.add_label(
        "/table/cell",
        GRID_LABEL,
        position=(0.0, -0.2, 0.0),
        anchor="center-center",
    )
