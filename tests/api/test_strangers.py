"""Requests of strangers wait for one another; a signed-in user waits for none of them."""

import asyncio
from collections.abc import Callable, Coroutine
from functools import wraps
from typing import Any

from starlette.requests import HTTPConnection
from starlette.types import Message, Receive, Scope, Send

from crenel.security.anonymous_queue import PLACES, AnonymousQueue, without_place

GOOD = b"crenel-8000=good"


class Application:
    """Answers at once where ``opened``; knows one cookie."""

    def __init__(self) -> None:
        self.opened = asyncio.Event()
        self.at_once, self.most_at_once, self.answered = 0, 0, 0

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if (b"cookie", GOOD) in scope["headers"]:
            scope["state"]["visitor"] = "the operator"
            await send({"type": "http.response.start"})
            return
        await receive()
        self.at_once += 1
        self.most_at_once = max(self.at_once, self.most_at_once)
        await self.opened.wait()
        self.at_once -= 1
        await send({"type": "http.response.start"})
        self.answered += 1


def in_a_loop(test: Callable[[], Coroutine[Any, Any, None]]) -> Callable[[], None]:
    @wraps(test)
    def run() -> None:
        asyncio.run(test())

    return run


async def received() -> Message:
    return {"type": "http.request"}


async def sent(message: Message) -> None:
    pass


async def never() -> Message:
    await asyncio.Event().wait()
    raise AssertionError


def request(cookie: bytes = b"", path: str = "/") -> Scope:
    return {"type": "http", "path": path, "headers": [(b"cookie", cookie)], "state": {}}


async def asked(strangers: AnonymousQueue, cookie: bytes = b"") -> None:
    async with asyncio.timeout(5.0):
        await strangers(request(cookie), received, sent)


@in_a_loop
async def test_a_signed_in_browser_passes_strangers_that_are_many() -> None:
    application = Application()
    strangers = AnonymousQueue(application)
    await asked(strangers, GOOD)  # in line, like everybody for the first time
    crowd = [asyncio.create_task(asked(strangers)) for _ in range(50)]
    await asyncio.sleep(0.01)
    for _ in range(10):
        await asked(strangers, GOOD)
    assert application.answered == 0
    application.opened.set()
    await asyncio.gather(*crowd)
    assert application.answered == 50
    assert application.most_at_once <= PLACES


@in_a_loop
async def test_a_client_that_sends_slowly_or_goes_away_has_no_place() -> None:
    application = Application()
    application.opened.set()
    strangers = AnonymousQueue(application)
    slow = [asyncio.create_task(strangers(request(), never, sent)) for _ in range(50)]
    await asyncio.sleep(0.01)
    await asked(strangers)
    application.opened.clear()
    gone = [asyncio.create_task(asked(strangers)) for _ in range(50)]
    await asyncio.sleep(0.01)
    for one in (*slow, *gone):
        one.cancel()
    await asyncio.gather(*slow, *gone, return_exceptions=True)
    application.opened.set()
    for _ in range(2 * PLACES):
        await asked(strangers)
    assert application.answered == 1 + 2 * PLACES


@in_a_loop
async def test_who_waits_for_another_server_has_no_place() -> None:
    answered = asyncio.Event()
    waiting = 0

    async def asks_another(scope: Scope, receive: Receive, send: Send) -> None:
        nonlocal waiting
        if scope["path"] == "/provider":
            async with without_place(HTTPConnection(scope)):
                waiting += 1
                await answered.wait()
        await send({"type": "http.response.start"})

    strangers = AnonymousQueue(asks_another)
    asks = [request(path="/provider") for _ in range(10)]
    slow = [asyncio.create_task(strangers(one, received, sent)) for one in asks]
    async with asyncio.timeout(5.0):
        while waiting < len(slow):
            await asyncio.sleep(0)
    for _ in range(2 * PLACES):
        await asked(strangers)
    answered.set()
    await asyncio.gather(*slow)
    for _ in range(2 * PLACES):
        await asked(strangers)


@in_a_loop
async def test_a_request_whose_connection_is_gone_is_not_worked_on() -> None:
    application = Application()
    application.opened.set()
    strangers = AnonymousQueue(application)
    gone = request()
    gone["state"]["is_connected"] = lambda: False
    await strangers(gone, received, sent)
    assert application.answered == 0
    await asked(strangers)
    assert application.answered == 1


@in_a_loop
async def test_a_cookie_that_opens_nothing_waits_like_none() -> None:
    application = Application()
    strangers = AnonymousQueue(application)
    crowd = [asyncio.create_task(asked(strangers, b"crenel-8000=bad")) for _ in range(20)]
    await asyncio.sleep(0.01)
    assert application.at_once == PLACES
    application.opened.set()
    await asyncio.gather(*crowd)
