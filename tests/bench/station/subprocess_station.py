"""A station that serves: from a thread, or in a process of its own."""

import contextlib
import multiprocessing
import random
import socket
import threading
import time
from collections.abc import Callable, Iterator
from multiprocessing.connection import Connection

import httpx
from websockets.exceptions import ConnectionClosed

from crenel.api.access.browser import cookie_for
from crenel.errors import OperationError
from crenel.monitoring.system_info import resident
from crenel.operations.context import Context
from crenel.server.application import build_app
from crenel.server.listener import make_server
from crenel.server.station_parts import StationParts

PATIENCE_S = 120.0
_PORTS = range(12_000, 32_000)
"""Below those that systems give to whoever asks for any: nobody else gets one in the meantime."""
_TRIES = 100
MB = 1 << 20
GUEST = "Bench"


def stuck_error(what: str, patience_s: float = PATIENCE_S) -> OperationError:
    """That the station under test, or a viewer of it, does not go on."""
    return OperationError(
        "bench-stuck",
        f"Nothing was measured: {what}",
        f"nothing came of it in {patience_s:.0f} s",
        "run it again when the machine is less busy",
    )


@contextlib.contextmanager
def convert_connection_errors() -> Iterator[None]:
    """Says so where the station under test does not respond, or has gone."""
    try:
        yield
    except (httpx.TransportError, ConnectionClosed, EOFError, BrokenPipeError) as error:
        raise OperationError(
            "bench-broken",
            "Nothing was measured: the station under test does not respond",
            str(error) or type(error).__name__,
            "run it again when the machine is less busy",
        ) from error


def memory_mb(process: int) -> float:
    """What a process holds, by its id; NaN where the system does not say."""
    return (resident(process) or float("nan")) / MB


@contextlib.contextmanager
def run_in_process(
    serve: Callable[..., None], *arguments: object
) -> Iterator[tuple[Connection, int]]:
    """Calls ``serve`` with a pipe and the arguments in a new process; ends it at the end.

    Yields our end of the pipe, once something has come through it, and the process's id.

    Raises:
        OperationError: nothing came, or the connection to it broke.
    """
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe()
    process = context.Process(target=serve, args=(theirs, *arguments), daemon=True)
    process.start()
    theirs.close()  # else the end of the process would not end the pipe
    try:
        if not ours.poll(PATIENCE_S):
            raise stuck_error("the station does not start")
        with convert_connection_errors():
            yield ours, process.pid or 0
            ours.send("stop")
        process.join(20.0)
    finally:
        process.kill()
        process.join()
        ours.close()


def free_port(kind: socket.SocketKind = socket.SOCK_STREAM) -> int:
    """A port of 127.0.0.1 that nobody uses, of TCP or UDP, for a server that begins later.

    Raises:
        OSError: none of many ports can be used.
    """
    for port in random.SystemRandom().sample(_PORTS, _TRIES):
        with socket.socket(socket.AF_INET, kind) as own:
            try:
                own.bind(("127.0.0.1", port))
                return port
            except OSError:
                continue
    raise OSError(f"none of {_TRIES} ports from {_PORTS.start} to {_PORTS.stop} can be used")


@contextlib.contextmanager
def serve_in_thread(parts: StationParts) -> Iterator[tuple[Context, int]]:
    """A station that serves from a thread, and its port."""
    app = build_app(parts)
    server = make_server(app)
    with socket.socket() as listening:
        listening.bind(("127.0.0.1", 0))
        listening.listen()
        thread = threading.Thread(target=server.run, kwargs={"sockets": [listening]})
        thread.start()
        while not server.started:
            time.sleep(0.05)
        try:
            yield app.state.context, int(listening.getsockname()[1])
        finally:
            server.should_exit = True
            thread.join(15.0)


def sign_in(station: Context, port: int) -> dict[str, str]:
    """The header of a browser that is signed in at the station on a port."""
    return {"Cookie": f"{cookie_for(port)}={station.store.login_sessions.begin(GUEST, 'bench')}"}
