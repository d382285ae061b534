"""The station as an application: all parts connected, opened and closed in order."""

import asyncio
import gc
from collections.abc import AsyncIterator, Callable
from contextlib import AbstractAsyncContextManager, asynccontextmanager

from fastapi import FastAPI

from crenel.api.answers import problems
from crenel.api.routers import ROUTES
from crenel.formats.json_document import SOFTWARE
from crenel.loops import naming_hangs, reporting_deaths
from crenel.operations.context import Context
from crenel.operations.publishers import observe, tick
from crenel.security.anonymous_queue import AnonymousQueue
from crenel.server.composition import close_context, open_context
from crenel.server.middleware import Guard
from crenel.server.station_parts import StationParts


def build_app(parts: StationParts) -> FastAPI:
    """The application; devices are opened on its start and closed on its end.

    Raises:
        OperationError: the data folder cannot be used, or is in use by another server.
    """
    context = open_context(parts)
    app = FastAPI(
        title="Crenel",
        version=SOFTWARE.version,
        lifespan=_lifespan(context),
        docs_url=None,
        redoc_url=None,
        openapi_url=None,
        routes=ROUTES,
    )
    app.state.context = context
    problems.install(app)
    app.add_middleware(Guard, hosts=parts.hosts)
    app.add_middleware(AnonymousQueue)
    return app


def _lifespan(context: Context) -> Callable[[FastAPI], AbstractAsyncContextManager[None]]:
    @asynccontextmanager
    async def lifespan(app: FastAPI) -> AsyncIterator[None]:
        context.bus.attach(asyncio.get_running_loop())
        context.rig.start()
        context.preview.start()
        # objects that exist now are excluded: scanning all of them would delay the sensor by 0.1 s
        gc.collect()
        gc.freeze()
        with reporting_deaths(), naming_hangs():
            ticking = asyncio.create_task(tick(context))
            observing = asyncio.create_task(observe(context))
            try:
                yield
            finally:
                ticking.cancel()
                observing.cancel()
                await asyncio.wait([observing])
                try:
                    await asyncio.to_thread(close_context, context)
                finally:
                    # callbacks of ended tasks are waiting on this loop
                    await asyncio.sleep(0)
                    context.bus.detach()
                    context.store.close()
                    context.monitoring.close()

    return lifespan
