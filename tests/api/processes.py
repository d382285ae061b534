"""The demonstration in a process of its own, begun in a moment and killed at will."""

import contextlib
import multiprocessing
import socket
import threading
from collections.abc import Iterator
from multiprocessing.connection import Connection
from pathlib import Path

import httpx

from tests.entering import enter

PATIENCE_S = 200.0
# what the server imports is imported once, and each process begins with it
CONTEXT = multiprocessing.get_context("forkserver")
CONTEXT.set_forkserver_preload(["app.main", "app.demonstration", "hardware.twin.station"])


def _serve(pipe: Connection, data: Path) -> None:
    """In the process: the demonstration, with a hand in a hurry."""
    from app.demonstration import parts_of
    from app.main import build_app, make_server
    from hardware.twin.station import Twin, TwinConfig

    with Twin(TwinConfig(pace=4.0)) as twin, socket.socket() as listening:
        listening.bind(("127.0.0.1", 0))
        listening.listen()
        app = build_app(parts_of(twin, data))
        server = make_server(app)
        thread = threading.Thread(target=server.run, kwargs={"sockets": [listening]}, daemon=True)
        thread.start()
        pipe.send((listening.getsockname()[1], app.state.context.entrance.code))
        thread.join()


@contextlib.contextmanager
def demonstration(data: Path) -> Iterator[tuple[httpx.Client, int]]:
    """A client that entered, and the process's id; killed at the end if it still runs."""
    ours, theirs = CONTEXT.Pipe()
    process = CONTEXT.Process(target=_serve, args=(theirs, data), daemon=True)
    process.start()
    assert ours.poll(PATIENCE_S)
    port, code = ours.recv()
    try:
        with httpx.Client(base_url=f"http://127.0.0.1:{port}", timeout=20.0) as http:
            # its socket listens before it serves
            enter(http, code)
            yield http, process.pid or 0
    finally:
        process.kill()
        process.join()
