"""The station as an application: everything wired together, opened and closed in order."""

import asyncio
import gc
from collections.abc import AsyncIterator, Callable
from contextlib import AbstractAsyncContextManager, asynccontextmanager

from fastapi import Depends, FastAPI

from app.api import (
    arm,
    calibrations,
    client,
    flow,
    health,
    live,
    machine,
    metrics,
    people,
    problems,
    records,
    reports,
    session,
    settings,
    telling,
    verify,
    view,
    viewer,
)
from app.api.access import authorise
from app.api.context import Context
from app.api.guard import Guard
from app.api.observer import observe
from app.api.strangers import Strangers
from app.api.ticker import tick
from app.api.wiring import Parts, close_context, open_context
from app.files.software import SOFTWARE


def build_app(parts: Parts) -> FastAPI:
    """The application; devices are opened when it starts and closed when it ends.

    Raises:
        Refusal: the data folder cannot be used, or is in use by another server.
    """
    context = open_context(parts)
    app = FastAPI(
        title="Crenel",
        version=SOFTWARE.version,
        lifespan=_lifespan(context),
        docs_url=None,
        redoc_url=None,
        openapi_url=None,
        # what was done stands in the audit log before it is answered
        dependencies=[Depends(authorise, scope="function")],
    )
    app.state.context = context
    problems.install(app)
    for room in (
        session,
        people,
        flow,
        arm,
        verify,
        calibrations,
        machine,
        settings,
        records,
        reports,
        health,
        telling,
        metrics,
        view,
        live,
        viewer,
        client,
    ):
        app.include_router(room.router)
    app.add_middleware(Guard, hosts=parts.hosts)
    app.add_middleware(Strangers)
    return app


def _lifespan(context: Context) -> Callable[[FastAPI], AbstractAsyncContextManager[None]]:
    @asynccontextmanager
    async def lifespan(app: FastAPI) -> AsyncIterator[None]:
        context.bus.attach(asyncio.get_running_loop())
        context.rig.start()
        context.preview.start()
        # what stands now stays: looking through all of it would hold up the sensor for 0.1 s
        gc.collect()
        gc.freeze()
        ticking = asyncio.create_task(tick(context))
        observing = asyncio.create_task(observe(context))
        try:
            yield
        finally:
            ticking.cancel()
            observing.cancel()
            await asyncio.wait([observing])
            await asyncio.to_thread(close_context, context)
            # callbacks of what has just ended are waiting on this loop
            await asyncio.sleep(0)
            context.bus.detach()
            context.store.close()
            context.watch.close()

    return lifespan
