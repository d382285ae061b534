"""A real server on the simulated station, which the tests of this package share."""

import socket
import threading
import time
import uuid
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, TypeVar
from unittest.mock import patch

import httpx
import pytest
from argon2 import PasswordHasher
from fastapi import FastAPI
from pydantic_core import to_jsonable_python
from websockets.exceptions import ConnectionClosed
from websockets.sync.connection import Connection

from app.bench.faults.served import HALF
from app.guide.calibration import simulated_operator
from app.operations.context import Context
from app.operations.services import MonitoringSettings
from app.server.application import build_app
from app.server.demo import station_parts
from app.server.listener import make_server
from app.single_sign_on.settings import SignInSettings
from app.store import accounts
from hardware.simulator.station import SimulatedStation, SimulationConfig
from tests.entering import cookie, enter
from tests.forked import fork_server
from tests.sent_texts import TextCollector

__all__ = ["fork_server"]

T = TypeVar("T")
PATIENCE_S = 240.0
"""For everything that is waited for: a machine with other work takes long."""
PRESS_S = 20.0
LOOK_S = 0.15
"""How often a test looks whether a view is as wanted: each look costs station and test time."""
QUICK_HASHER = PasswordHasher(time_cost=1, memory_cost=64)
"""As good in all but what it costs to guess."""
POSES, BOARD_POSES = 3, 6
"""Of the simulated operator's calibrations: fewer than a demonstration's, as each takes seconds."""


def wait_for(read: Callable[[], T], ready: Callable[[T], object]) -> T:
    """What is read, once it is as wanted."""
    deadline = time.monotonic() + PATIENCE_S
    while not ready(value := read()):
        assert time.monotonic() < deadline, value
        time.sleep(LOOK_S)
    return value


def comes(condition: Callable[[], object]) -> bool:
    """Whether something comes of a press of the arm's button, which an arm that was lost for a
    moment does not pass on: it is pressed again then."""
    deadline = time.monotonic() + PRESS_S
    while not condition() and time.monotonic() < deadline:
        time.sleep(LOOK_S)
    return bool(condition())


def until_closed(socket: Connection) -> int:
    """Takes what comes; the code that the server closes with."""
    try:
        while True:
            socket.recv(PATIENCE_S)
    except ConnectionClosed as closed:
        return closed.rcvd.code if closed.rcvd else 0


def run_command(command: Callable[[], httpx.Response]) -> dict[str, Any]:
    """The answer to a command that must be done; on a busy machine a device may be late for it."""
    return dict(wait_for(command, lambda answer: answer.status_code == 200).json())


@dataclass
class Server:
    """A running server, its context, and its simulation."""

    port: int
    data: Path
    context: Context
    simulation: SimulatedStation
    http: httpx.Client
    application: FastAPI
    sent: TextCollector
    """The texts that it sent to browsers."""

    @property
    def address(self) -> str:
        return f"http://127.0.0.1:{self.port}"

    @property
    def live(self) -> str:
        return f"ws://127.0.0.1:{self.port}/api/live"

    @property
    def cookie(self) -> dict[str, str]:
        """The header of a live connection."""
        return cookie(self.http)

    def flow(self) -> dict[str, Any]:
        return dict(self.http.get("/api/flow").json())

    def command(
        self, name: str, rev: object = None, key: str = "", **args: object
    ) -> httpx.Response:
        """Posts a command, by default on the present view."""
        body = {
            "name": name,
            "args": args,
            "rev": self.flow()["rev"] if rev is None else rev,
            "key": key or uuid.uuid4().hex,
        }
        return self.http.post("/api/flow/command", json=body)

    def do(self, name: str, **args: Any) -> dict[str, Any]:
        """A command that must be done; the view after it."""
        return run_command(lambda: self.command(name, **args))

    def wait(self, ready: Callable[[dict[str, Any]], bool]) -> dict[str, Any]:
        """The flow's view, once it is as wanted."""
        return wait_for(self.flow, ready)


@contextmanager
def running_server(
    data: Path,
    config: SimulationConfig = HALF,
    monitoring: MonitoringSettings | None = None,
    sign_in: SignInSettings | None = None,
) -> Iterator[Server]:
    """A server on a data folder, with a client that has entered; it ends in order."""
    with (
        patch.object(accounts, "HASHER", QUICK_HASHER),
        patch.multiple(simulated_operator, POSES=POSES, BOARD_POSES=BOARD_POSES),
        SimulatedStation(config) as simulation,
        socket.socket() as listening,
    ):
        listening.bind(("127.0.0.1", 0))
        listening.listen()
        parts = replace(station_parts(simulation, data), sign_in=sign_in)
        app = build_app(parts if monitoring is None else replace(parts, monitoring=monitoring))
        running = make_server(app)
        thread = threading.Thread(target=running.run, kwargs={"sockets": [listening]})
        thread.start()
        port = listening.getsockname()[1]
        sent = TextCollector()
        hooks = {"response": [sent.answer]}
        address = f"http://127.0.0.1:{port}"
        with httpx.Client(base_url=address, timeout=PATIENCE_S, event_hooks=hooks) as http:
            enter(http, app.state.context.authenticator.code)
            context = app.state.context
            yield Server(port, data, context, simulation, http, app, sent)
            # the live connection's newest topics, and the events that it still has
            latest = context.bus._take({}, {"preview"}, 0)
            sent.value(to_jsonable_python(latest.topics, inf_nan_mode="null"))
            for event in latest.events:
                sent.text(event.text)
        running.should_exit = True
        thread.join(PATIENCE_S)
        assert not thread.is_alive()


@pytest.fixture(scope="module")
def server(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Server]:
    """Ended with its module: a station takes much of a core, also while nobody asks it anything.

    A module may say by ``STATION`` what is simulated.
    """
    config: SimulationConfig = getattr(request.module, "STATION", HALF)
    with running_server(tmp_path_factory.mktemp("station"), config) as server:
        yield server
    # every language has all that it sent
    assert not server.sent.untranslated()


@pytest.fixture
def at_setup(server: Server) -> Server:
    """A new session at the set-up step, with the block chosen.

    What was used last is preselected, and a test before may have used the chessboard.
    """
    server.wait(lambda view: view["busy"] is None)
    if server.flow()["running"]:
        server.do("abandon")
    server.http.post("/api/flow/start").raise_for_status()
    server.do("confirm_devices")
    server.do("choose", field="object", id="simulated")
    return server


@pytest.fixture
def touching(at_setup: Server) -> Server:
    """A new session at the touch step of the block, with the arm at rest."""
    server = at_setup
    server.do("confirm_setup")
    server.wait(lambda view: is_enabled(view, "take_point"))
    return server


def is_enabled(view: dict[str, Any], name: str) -> bool:
    actions = view["actions"]
    assert isinstance(actions, list)
    return any(action["name"] == name and action["enabled"] for action in actions)
