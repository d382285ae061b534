"""The station as a server: everything wired together, started, and ended in order."""

import asyncio
import gc
import logging
import socket
import tempfile
from collections.abc import AsyncIterator, Callable
from contextlib import AbstractAsyncContextManager, asynccontextmanager
from dataclasses import asdict, replace
from pathlib import Path

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
from app.api.ticker import tick
from app.api.watch import Watching
from app.api.wiring import Parts, close_context, open_context
from app.files.software import SOFTWARE
from app.metrology.refusal import Refusal
from app.replay import Replay
from app.serving import (
    LOCAL,
    NETWORK_WORDS,
    FirstLine,
    address_of,
    listen,
    make_server,
    network_of,
    raise_file_limit,
)
from app.settings import DEFAULT_FILE, Serving, Settings, read_settings, user_data_folder
from app.station.warm_up import warm_up
from hardware.errors import DeviceError
from hardware.registry import arm_driver, sensor_driver
from hardware.thermometer import FileThermometer

PORTS_TRIED = 20
FIRST_START = "the first start compiles for a minute or two"


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
        dependencies=[Depends(authorise)],
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


def serve(config: Path | None, data: Path | None, host: str, port: int, open_browser: bool) -> None:
    """Runs the station on the devices that ``station.toml`` names, until it is told to end.

    Raises:
        Refusal: settings, driver, data folder or port are not in order.
    """
    settings = read_settings(config)
    arm, sensor = settings.arm, settings.sensor
    try:  # an unknown driver or a wrong option is told now, not at the first connection
        arm_driver(arm.driver, arm.options)
        sensor_driver(sensor.driver, sensor.options)
    except DeviceError as error:
        named = error.what.replace(DEFAULT_FILE, str(config or DEFAULT_FILE), 1)
        raise Refusal("driver", named, remedy=error.remedy) from error
    listening = listen(host, port, 1)
    parts = Parts(
        name=settings.name,
        data=data or settings.data,
        arm=lambda: arm_driver(arm.driver, arm.options),
        sensor=lambda: sensor_driver(sensor.driver, sensor.options),
        hosts=(*settings.hosts, host),
        limits=settings.limits,
        verification=settings.verification,
        due=settings.due,
        watching=_watching(settings),
    )
    print(f"Starting the station; {FIRST_START}.", flush=True)
    _run(parts, listening, host, open_browser, serving=settings.serving)


def _watching(settings: Settings) -> Watching:
    """What the settings have of it, and the settings themselves as they may be looked at."""
    mqtt = settings.mqtt
    file = settings.temperature
    told = {
        "drivers": {"arm": settings.arm.driver, "sensor": settings.sensor.driver},
        "name": settings.name,
        "data": str(settings.data),
        "hosts": list(settings.hosts),
        "limits": asdict(settings.limits),
        "tls": settings.serving.tls_certificate is not None,
        "arm": dict(settings.arm.options),
        "sensor": dict(settings.sensor.options),
        "mqtt": None if mqtt is None else {k: str(v) for k, v in asdict(mqtt).items()},
        "temperature": None if file is None else str(file),
    }
    return Watching(
        address=settings.address,
        backups=settings.backups,
        mqtt=mqtt,
        thermometer=None if file is None else FileThermometer(file),
        told=told,
    )


def demo(data: Path | None, host: str, port: int, open_browser: bool) -> None:
    """Runs the whole station on simulated devices; where the port is taken, on the next free.

    Raises:
        Refusal: the data folder is not in order, or no port is free.
    """
    from app.demonstration import simulated_parts

    listening = listen(host, port, PORTS_TRIED)
    print(f"Starting the simulated station; {FIRST_START}.", flush=True)
    with simulated_parts(data or user_data_folder() / "demo", (host,)) as parts:
        _run(parts, listening, host, open_browser)


def replay(show: Replay, title: str, host: str, port: int, open_browser: bool) -> None:
    """Runs the display on a recording, in a data folder of its own that is then removed.

    Raises:
        Refusal: no port is free.
    """
    listening = listen(host, port, PORTS_TRIED)
    with tempfile.TemporaryDirectory(prefix="crenel-replay-") as data:
        parts = Parts(title, Path(data), show.arm, show.sensor, hosts=(host,), guest="Replay")
        _run(parts, listening, host, open_browser, show)


def _run(
    parts: Parts,
    listening: socket.socket,
    host: str,
    open_browser: bool,
    show: Replay | None = None,
    serving: Serving = LOCAL,
) -> None:
    """Serves until SIGINT or SIGTERM.

    Raises:
        Refusal: the data folder cannot be used, or is in use by another server.
    """
    raise_file_limit()
    network = network_of(host, serving)
    app = build_app(replace(parts, watching=replace(parts.watching, network=network)))
    server = make_server(app, serving)
    warm_up()
    console = logging.StreamHandler()
    console.setLevel(logging.WARNING)  # the rest is in the log of the Health page
    console.setFormatter(FirstLine("%(asctime)s %(name)s: %(message)s"))
    logging.getLogger().addHandler(console)
    server.address = address_of(host, listening, serving)
    entrance = app.state.context.entrance
    if entrance.by_code:
        server.address += f"#code={entrance.code}"
    elif entrance.first_start:
        server.first_words.append(
            f"Nobody can sign in yet. The code {entrance.code} makes the first administrator there."
        )
    server.first_words += NETWORK_WORDS[network]
    server.open_browser = open_browser
    if show is not None:
        show.start(app.state.context.scene, app.state.context.bus)
    try:
        server.run(sockets=[listening])
    except KeyboardInterrupt:
        pass  # uvicorn raises the signal again once it has ended in order
    finally:
        listening.close()
        if show is not None:
            show.stop()
