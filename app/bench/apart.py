"""A station that serves: from a thread, or in a process of its own."""

import contextlib
import multiprocessing
import socket
import threading
import time
from collections.abc import Callable, Iterator
from multiprocessing.connection import Connection

from app.api.access import cookie_for
from app.api.context import Context
from app.api.wiring import Parts
from app.main import build_app, make_server

PATIENCE_S = 120.0
GUEST = "Bench"


@contextlib.contextmanager
def apart(serve: Callable[..., None], *arguments: object) -> Iterator[tuple[Connection, int]]:
    """Calls ``serve`` with a pipe and the arguments in a new process; ends it at the end.

    Yields our end of the pipe, once something has come through it, and the process's id.

    Raises:
        TimeoutError: nothing came.
    """
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe()
    process = context.Process(target=serve, args=(theirs, *arguments), daemon=True)
    process.start()
    try:
        if not ours.poll(PATIENCE_S):
            raise TimeoutError("the station does not start")
        yield ours, process.pid or 0
        ours.send("stop")
        process.join(20.0)
    finally:
        process.kill()


@contextlib.contextmanager
def served(parts: Parts) -> Iterator[tuple[Context, int]]:
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
    return {"Cookie": f"{cookie_for(port)}={station.store.sign_ins.begin(GUEST, 'bench')}"}
