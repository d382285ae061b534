"""Live connections with browsers: what each direction does, and how they end together."""

import asyncio
from collections.abc import Coroutine
from contextlib import suppress
from dataclasses import dataclass

from starlette.websockets import WebSocket, WebSocketDisconnect, WebSocketState

from crenel.api.access.authorization import SIGN_IN_CHECK_S, current_visitor, visitor_of
from crenel.operations.context import context_of

SIGNED_OUT = 4401


@dataclass(frozen=True, slots=True)
class CloseReason:
    """Why the station closes a connection."""

    code: int = 1000
    text: str = ""


async def run_connection(
    socket: WebSocket, *directions: Coroutine[object, object, CloseReason | None]
) -> None:
    """Runs what a connection does until one of its directions ends, or its user signs out.

    The others are ended before the connection is closed, so that nothing is sent afterwards.
    """
    tasks = [asyncio.create_task(one) for one in (*directions, _wait_for_sign_out(socket))]
    try:
        await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
    finally:
        for task in tasks:
            task.cancel()
        results = await asyncio.gather(*tasks, return_exceptions=True)
    for result in results:
        if isinstance(result, Exception) and not isinstance(result, WebSocketDisconnect):
            raise result
    reason = next((one for one in results if isinstance(one, CloseReason)), None)
    if reason is not None and socket.application_state is WebSocketState.CONNECTED:
        with suppress(WebSocketDisconnect):
            await socket.close(reason.code, reason.text)


async def _wait_for_sign_out(socket: WebSocket) -> CloseReason:
    """Returns when this browser's login session is no longer valid, or its permissions have
    changed.

    Control ends with it, even if another program ended the session.
    """
    visitor = current_visitor(socket)
    while await asyncio.to_thread(visitor_of, socket) == visitor:
        await asyncio.sleep(SIGN_IN_CHECK_S)
    context_of(socket).lease.leave(visitor.id)
    return CloseReason(SIGNED_OUT, "signed out")
