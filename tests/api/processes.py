"""The demonstration in a process of its own, begun in a moment and killed at will."""

import contextlib
import socket
import threading
from collections.abc import Iterator
from multiprocessing.connection import Connection
from pathlib import Path
from types import SimpleNamespace

import httpx

from tests.api.calibrated import use_truth
from tests.entering import enter
from tests.forked import CONTEXT

PATIENCE_S = 200.0


def _serve(pipe: Connection, data: Path, calibrated: bool) -> None:
    """In the process: the demonstration, with a fast simulated operator."""
    from crenel.server.application import build_app
    from crenel.server.demo import station_parts
    from crenel.server.listener import make_server
    from crenel_hardware.simulator.station import SimulatedStation
    from tests.bench.faults.served import HALF

    with SimulatedStation(HALF) as simulation, socket.socket() as listening:
        listening.bind(("127.0.0.1", 0))
        listening.listen()
        app = build_app(station_parts(simulation, data))
        context = app.state.context
        if calibrated and context.store.calibrations.active() is None:
            use_truth(SimpleNamespace(simulation=simulation, data=data, context=context), "truth")
        server = make_server(app)
        thread = threading.Thread(target=server.run, kwargs={"sockets": [listening]}, daemon=True)
        thread.start()
        pipe.send((listening.getsockname()[1], context.authenticator.code))
        thread.join()


@contextlib.contextmanager
def demonstration(data: Path, calibrated: bool = False) -> Iterator[tuple[httpx.Client, int]]:
    """A client that entered, and the process's id; killed at the end if it still runs.
    ``calibrated``: a true calibration is in use from the beginning."""
    ours, theirs = CONTEXT.Pipe(duplex=False)
    process = CONTEXT.Process(target=_serve, args=(theirs, data, calibrated), daemon=True)
    with ours:
        with theirs:
            process.start()
        assert ours.poll(PATIENCE_S)
        port, code = ours.recv()
    try:
        with httpx.Client(base_url=f"http://127.0.0.1:{port}", timeout=PATIENCE_S) as http:
            # its socket listens before it serves
            enter(http, code)
            yield http, process.pid or 0
    finally:
        process.kill()
        process.join()
