"""The live connection of a browser tab: topics, events, heartbeats, and the preview.

Each tab has its own task and its own subscription, and receives only the newest value of each
topic, so that a slow tab delays nobody.
"""

import asyncio
import contextlib
import time

from fastapi import WebSocket
from pydantic import TypeAdapter, ValidationError

from crenel.api.access.authorization import POLICY_VIOLATION, StationRouter, current_visitor
from crenel.api.access.browser import current_user
from crenel.api.access.connection import CloseReason, run_connection
from crenel.operations.context import Context, context_of
from crenel.security.permissions import MESSAGES, has_right
from crenel.station.bus import Subscription, Updates
from crenel.station.preview.preview import PreviewImage
from crenel.station.scan.state import ScanState
from crenel.store.login_sessions import Principal
from crenel.wire.json_response import encode_json
from crenel.wire.live_messages import (
    BeatMessage,
    EventMessage,
    Heartbeat,
    HelloMessage,
    LiveRequest,
    PreviewRequest,
    StationsRequest,
)

router = StationRouter()
BEAT_S = 1.0
LONGEST_REQUEST = 1024
REQUEST: TypeAdapter[LiveRequest] = TypeAdapter(LiveRequest)


@router.websocket("/api/live")
async def live(socket: WebSocket) -> None:
    """The live connection: hello, the snapshot, then the changes."""
    context = context_of(socket)
    await socket.accept()
    with context.bus.subscribe(without={"preview", "stations"}) as subscription:
        tab = _Tab(context, socket, subscription, current_visitor(socket))
        context.monitoring.tabs += 1
        try:
            await tab.run()
        finally:
            context.monitoring.tabs -= 1
            tab.close()


class _Tab:
    """One browser tab."""

    def __init__(
        self, context: Context, socket: WebSocket, subscription: Subscription, visitor: Principal
    ) -> None:
        self._context, self._socket, self._subscription = context, socket, subscription
        self._visitor = visitor
        self._previewing = False

    async def run(self) -> None:
        """Runs until the tab closes; if one direction ends, it ends both."""
        await run_connection(self._socket, self._send(), self._receive())

    def close(self) -> None:
        self._set_preview(False)

    async def _send(self) -> None:
        hello = HelloMessage(self._context.station, current_user(self._visitor))
        await self._text(hello)
        await self._pass_on(await self._subscription.next())
        beat_at = time.monotonic()  # the first tells the browser that it has the snapshot
        while True:
            if time.monotonic() >= beat_at:
                await self._text(BeatMessage())
                beat_at = time.monotonic() + BEAT_S
            left_s = beat_at - time.monotonic()
            with contextlib.suppress(TimeoutError):
                # ``wait_for`` of Python 3.11 loses a cancellation that comes together with updates
                async with asyncio.timeout(max(left_s, 0.0)):
                    updates = await self._subscription.next()
                await self._pass_on(updates)

    async def _pass_on(self, updates: Updates) -> None:
        for name, value in updates.topics.items():
            if isinstance(value, PreviewImage):
                # the next one only after the acknowledgement of this one
                self._subscription.want("preview", False)
                await self._socket.send_bytes(value.to_bytes())
                continue
            shown = self._context.scan_state(value) if isinstance(value, ScanState) else value
            await self._topic(name, shown)
        for event in updates.events:
            await self._text(EventMessage(event.id, event.kind, event.quality, event.text))

    async def _topic(self, name: str, value: object) -> None:
        """Omits a topic that cannot be sent; the others continue."""
        text = self._context.topic_texts.of(name, value)
        if text is not None:
            await self._socket.send_text(text)

    async def _text(self, message: object) -> None:
        await self._socket.send_text(encode_json(message).decode())

    async def _receive(self) -> CloseReason | None:
        while True:
            received = await self._socket.receive()
            if received["type"] == "websocket.disconnect":
                return None
            text = received.get("text")
            try:
                if text is None or len(text) > LONGEST_REQUEST:
                    raise ValueError
                self._handle(REQUEST.validate_json(text))
            except (ValidationError, ValueError):
                return CloseReason(POLICY_VIOLATION, "not a message of this protocol")

    def _handle(self, request: LiveRequest) -> None:
        if not has_right(MESSAGES[request.type], self._visitor.role, self._visitor.kiosk):
            raise ValueError
        if isinstance(request, Heartbeat):
            self._context.lease.beat(self._visitor.id)
        elif isinstance(request, PreviewRequest):
            self._set_preview(request.on)
        elif isinstance(request, StationsRequest):
            self._subscription.want("stations", request.on)
        elif self._previewing:
            self._subscription.want("preview", True)

    def _set_preview(self, on: bool) -> None:
        if on == self._previewing:
            return
        self._previewing = on
        self._subscription.want("preview", on)
        if on:
            self._context.preview.add_viewer()
        else:
            self._context.preview.remove_viewer()
