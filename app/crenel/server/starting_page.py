"""The station during its start: it reports the progress from the first second on.

``StartingApp`` answers instead of the application, behind the same guard, and is replaced by it
when the steps are done: the socket, the server and its connections stay. Only light modules may be
imported here.
"""

import asyncio
import time
from collections.abc import Callable, Collection, Sequence
from concurrent.futures import Future
from dataclasses import dataclass
from typing import Any, Generic, TypeVar

from pydantic_core import to_json
from starlette.applications import Starlette
from starlette.datastructures import Headers
from starlette.responses import Response
from starlette.types import ASGIApp, Receive, Scope, Send

from crenel.api.access.sub_path import page_base
from crenel.api.static_files import file_response, names_a_file, page_response
from crenel.loops import start_worker
from crenel.messages.message import Text, message
from crenel.server.middleware import Guard
from crenel.wire.json_response import problem
from crenel.wire.readiness import Readiness

PAGE = "starting.html"
PROGRESS = "/api/starting"
STATION_PATHS = ("api", "metrics", "viewer")
"""First parts of the addresses that only the station itself can answer."""
TRY_AGAIN_LATER = 1013
ABANDONED_AFTER_S = 3.0
"""If the program is ended while a step runs, it waits for this long at most."""
QUIET_S, SHOWN_S = 2.0, 20.0
"""After a failure, open pages are answered until they have been quiet, and at most, for so long."""
# The steps of the start, as the page shows them.
NUMERICS = message("numerics")
PICTURES = message("image-processing")
VIEW = message("n-3d-view")
GUIDE = message("guided-steps")
DEVICES = message("devices")
DATA = message("data-folder")
MEASURING = message("extraction-detection")


T_co = TypeVar("T_co", covariant=True)


@dataclass(frozen=True)
class StartStep(Generic[T_co]):
    """One step of the start: its name, its duration on a cold start in seconds, and the work
    itself."""

    words: Text
    cost_s: float
    prepare: Callable[[], T_co]


class _StartCancelledError(Exception):
    """The program was ended during its start."""


class StartingApp:
    """ASGI application: the starting page, then the station.

    Args:
        station: its name.
        steps: done one after the other, in a thread of their own.
        building: the last of them, which makes the application.
        hosts: as ``Guard`` has them.
    """

    def __init__(
        self,
        station: str,
        steps: Sequence[StartStep[object]],
        building: StartStep[Starlette],
        hosts: Collection[str] = (),
    ) -> None:
        self._station, self._steps, self._building = station, steps, building
        self._done = 0
        self._app: ASGIApp = Guard(self._answer, hosts)
        self._ending = asyncio.Event()
        self.on_ready: Callable[[Starlette, float], None] = lambda app, seconds: None
        """Called on the event loop when the application answers, with the elapsed seconds."""
        self.on_failed: Callable[[], None] = lambda: None
        """Called on the event loop if a step failed; ``failure`` has the reason."""
        self.failure: BaseException | None = None
        self._asked_s: float | None = None
        """When a browser asked for something last."""

    @property
    def readiness(self) -> Readiness:
        """Progress of the start."""
        steps = (*self._steps, self._building)
        costs = [step.cost_s for step in steps]
        return Readiness(
            ready=False,
            failed=self.failure is not None,
            station=self._station,
            steps=[step.words for step in steps],
            done=self._done,
            share=sum(costs[: self._done]) / sum(costs),
        )

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] == "lifespan":
            await self._live(receive, send)
        else:
            await self._app(scope, receive, send)

    async def _live(self, receive: Receive, send: Send) -> None:
        await receive()
        life = asyncio.create_task(self._prepare_and_run())
        await send({"type": "lifespan.startup.complete"})
        await receive()
        self._ending.set()
        await life
        await send({"type": "lifespan.shutdown.complete"})

    async def _prepare_and_run(self) -> None:
        began_s = time.monotonic()
        try:
            app = await self._build_app()
            async with app.router.lifespan_context(app):
                self._app = app
                if not self._ending.is_set():
                    self.on_ready(app, time.monotonic() - began_s)
                await self._ending.wait()
        except (_StartCancelledError, asyncio.CancelledError):
            pass  # a second interrupt does not wait for the end
        except BaseException as error:
            self.failure = error
            await self._tell_pages()
            self.on_failed()

    async def _tell_pages(self) -> None:
        """Answers pages that are open or just loading, which then say that the start failed."""
        failed_s = time.monotonic()
        while self._asked_s is not None and not self._ending.is_set():
            now_s = time.monotonic()
            if now_s - self._asked_s > QUIET_S or now_s - failed_s > SHOWN_S:
                break
            await asyncio.sleep(0.1)

    async def _build_app(self) -> Starlette:
        """The application, built in a thread.

        Raises:
            _StartCancelledError: the program was ended in the meantime.
            BaseException: the exception of a step.
        """
        result: Future[Starlette] = Future()

        def prepare() -> None:
            try:
                result.set_result(self._prepare())
            except BaseException as error:
                result.set_exception(error)

        # a thread that nobody waits for: a step that hangs does not outlive the program
        start_worker("prepare", prepare)
        built, ending = asyncio.wrap_future(result), asyncio.create_task(self._ending.wait())
        first: tuple[asyncio.Future[Any], ...] = (built, ending)
        await asyncio.wait(first, return_when=asyncio.FIRST_COMPLETED)
        ending.cancel()
        await asyncio.wait([built], timeout=ABANDONED_AFTER_S)
        if not built.done():
            raise _StartCancelledError
        return await built

    def _prepare(self) -> Starlette:
        for step in self._steps:
            step.prepare()
            self._done += 1
            if self._ending.is_set():
                raise _StartCancelledError
        return self._building.prepare()

    async def _answer(self, scope: Scope, receive: Receive, send: Send) -> None:
        """During the start: the page and its progress; nothing else."""
        self._asked_s = time.monotonic()
        if scope["type"] == "websocket":
            await receive()
            await send({"type": "websocket.close", "code": TRY_AGAIN_LATER})
            return
        await self._response(scope)(scope, receive, send)

    def _response(self, scope: Scope) -> Response:
        method, path = scope["method"], scope["path"]
        asked = path.removeprefix("/")
        if method not in ("GET", "HEAD") or asked.split("/")[0] in STATION_PATHS:
            return self._progress() if path == PROGRESS else _starting_problem()
        found = file_response(asked, Headers(scope=scope).get("accept-encoding", ""))
        if found is None and names_a_file(asked):
            return problem(404, "not-found", message("there-nothing", path=path))
        return found or _forbid_caching(page_response(PAGE, page_base(scope)))

    def _progress(self) -> Response:
        return Response(to_json(self.readiness), media_type="application/json")


def _starting_problem() -> Response:
    answer = problem(503, "starting", message("station-starting"), message("try-again-moment"))
    answer.headers["Retry-After"] = "1"
    return answer


def _forbid_caching(page: Response) -> Response:
    """The address is that of the client: no browser may cache this page for it."""
    page.headers["Cache-Control"] = "no-store"
    return page
