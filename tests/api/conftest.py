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

from crenel.guide.calibration.automatic import simulated_operator
from crenel.operations.context import Context
from crenel.operations.services import MonitoringSettings
from crenel.server.application import build_app
from crenel.server.demo import station_parts
from crenel.server.listener import make_server
from crenel.single_sign_on.settings import SignInSettings
from crenel.store import accounts
from crenel_hardware.clock import now_ns
from crenel_hardware.interfaces import Button
from crenel_hardware.simulator.station import SimulatedStation, SimulationConfig
from tests.api.calibrated import use_truth
from tests.bench.faults.served import HALF
from tests.entering import cookie, enter
from tests.forked import fork_server
from tests.sent_texts import TextCollector

__all__ = ["fork_server"]

T = TypeVar("T")
View = dict[str, Any]
"""Of a guide, as a browser gets it."""
PATIENCE_S = 480.0
"""For everything that is waited for: a machine with other work takes long."""
PRESS_S = 20.0
ATTEMPTS = 5
"""Of the simulated operator, who stops where a device is lost."""
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


def until(ready: Callable[[], object]) -> None:
    wait_for(ready, bool)


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


def code_of(answer: httpx.Response) -> tuple[int, str]:
    """The status and the code of a problem."""
    return answer.status_code, answer.json()["code"]


def refusal(answer: httpx.Response) -> str:
    assert answer.status_code == 422, answer.text
    return str(answer.json()["detail"])


class Desk:
    """The operator's end of a guide: its view, and its commands."""

    http: httpx.Client
    path = "/api/flow"
    closing = "abandon"
    """The command that ends what is open."""

    def view(self) -> View:
        return dict(self.http.get(self.path).json())

    def command(self, name: str, rev: object = None, key: str = "", **args: object) -> Any:
        """Posts a command, by default on the present view."""
        rev = self.view()["rev"] if rev is None else rev
        body = {"name": name, "args": args, "rev": rev, "key": key or uuid.uuid4().hex}
        return self.http.post(f"{self.path}/command", json=body)

    def do(self, name: str, **args: Any) -> View:
        """A command that must be done; the view after it."""
        return run_command(lambda: self.command(name, **args))

    def wait(self, ready: Callable[[View], bool]) -> View:
        return wait_for(self.view, ready)

    def wait_until_idle(self) -> View:
        return self.wait(lambda view: view["busy"] is None)

    def simulate_up_to_review(self) -> View:
        """The simulated operator does what is left, and begins again where a busy machine lost a
        device for a moment."""
        attempts = 0
        while (view := self.wait_until_idle())["step"] != "review":
            assert attempts < ATTEMPTS, view["findings"]
            attempts += 1
            self.do("run_simulation", all=True)
        return view

    def close(self) -> None:
        """Ends what is open, once nothing is under way."""
        self.wait_until_idle()
        if self.view()["running"]:
            self.do(self.closing)


@dataclass
class Server(Desk):
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

    def flow(self) -> View:
        return self.view()

    def press(self, button: Button) -> None:
        self.simulation.device.press(button, True, now_ns())
        self.simulation.device.press(button, False, now_ns() + 50_000_000)


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
    """Ended with its module, as it takes much of a core; ``STATION`` of a module says what is
    simulated."""
    config: SimulationConfig = getattr(request.module, "STATION", HALF)
    with running_server(tmp_path_factory.mktemp("station"), config) as server:
        yield server
    # every language has all that it sent
    assert not server.sent.untranslated()


@pytest.fixture
def at_setup(server: Server) -> Server:
    """A new session at the set-up step, with the block chosen, whatever a test before has used."""
    server.close()
    server.http.post("/api/flow/start").raise_for_status()
    server.do("confirm_devices")
    server.do("choose", field="object", id="simulated")
    return server


@pytest.fixture
def touching(at_setup: Server) -> Server:
    """A new session at the touch step of the block, with the arm at rest."""
    at_setup.do("confirm_setup")
    at_setup.wait(lambda view: is_enabled(view, "take_point"))
    return at_setup


@pytest.fixture(scope="module")
def calibration(server: Server) -> str:
    return use_truth(server, f"truth-{uuid.uuid4().hex[:6]}")


def is_enabled(view: View, name: str) -> bool:
    return any(action["name"] == name and action["enabled"] for action in view["actions"])
