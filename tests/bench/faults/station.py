"""A station in a process of its own that the bench may kill, and what it does to it."""

import contextlib
import os
import re
import signal
import subprocess
import sys
import time
import uuid
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, Protocol

import httpx
from websockets.sync.client import ClientConnection, connect

from crenel.errors import OperationError
from tests.bench.station.subprocess_station import PATIENCE_S, stuck_error
from tests.sources import ROOT

View = dict[str, Any]
LINK = re.compile(r"(http://\S+)#code=(\w+)")
LOOK_S, END_S = 0.08, 20.0
ENDED = "ended"


class LaunchedProcess(Protocol):
    """A process as ``subprocess.Popen`` has it."""

    @property
    def pid(self) -> int: ...
    def poll(self) -> int | None: ...
    def wait(self, timeout: float | None = None) -> int: ...
    def send_signal(self, sig: int) -> None: ...
    def kill(self) -> None: ...


class StationProcess:
    """A simulated station on a data folder, from its start to its end; also one that refuses."""

    def __init__(
        self,
        data: Path,
        environment: Mapping[str, str] | None = None,
        user: int | None = None,
        options: Sequence[str] = (),
    ) -> None:
        data.parent.mkdir(parents=True, exist_ok=True)
        self._data = data
        self._output = data.with_name(f"{data.name}-{uuid.uuid4().hex[:6]}.txt")
        self._process = self._launch([str(data), *options], environment or {}, user)
        self.http = httpx.Client(timeout=30.0)

    def _launch(
        self, arguments: Sequence[str], environment: Mapping[str, str], user: int | None
    ) -> LaunchedProcess:
        with self._output.open("w") as console:
            return subprocess.Popen(
                [sys.executable, "-m", "tests.bench.faults.served", *arguments],
                env={**os.environ, **environment},
                cwd=ROOT,
                stdin=subprocess.DEVNULL,
                stdout=console,
                stderr=subprocess.STDOUT,
                user=user,
            )

    def __enter__(self) -> "StationProcess":
        return self

    def __exit__(self, *_: object) -> None:
        self.http.close()
        if self._process.poll() is None:
            self._process.send_signal(signal.SIGTERM)
            try:
                self._process.wait(END_S)
            except subprocess.TimeoutExpired:
                self._process.kill()
        self._process.wait()

    @property
    def pid(self) -> int:
        return self._process.pid

    @property
    def console_text(self) -> str:
        """All that the console has."""
        return self._output.read_text(errors="replace")

    def log_bytes(self) -> int:
        """Of the console and the station's log."""
        logs = (self._data / "logs").glob("*")
        return self._output.stat().st_size + sum(path.stat().st_size for path in logs)

    @property
    def status(self) -> int | None:
        """How it ended; None while it runs."""
        return self._process.poll()

    def enter(self) -> "StationProcess":
        """Signs in as the demonstration's guest, once the whole station is there.

        Raises:
            OperationError: it ended, or is not there in time.
        """
        self.wait(lambda: LINK.search(self.console_text) and "Ready after" in self.console_text)
        self.sign_in().raise_for_status()
        return self

    def sign_in(self) -> httpx.Response:
        """Signs in by the link that the console shows."""
        link = LINK.search(self.console_text)
        assert link is not None
        self.http.base_url = httpx.URL(link[1])
        return self.http.post("/api/session/code", json={"code": link[2]})

    def live(
        self,
        max_queue: int | None = 16,
        ping_interval: float | None = 20.0,
        close_timeout: float | None = 10.0,
    ) -> ClientConnection:
        """A live connection as a browser's page has it; to be closed by the caller."""
        cookies = "; ".join(f"{name}={value}" for name, value in self.http.cookies.items())
        return connect(
            str(self.http.base_url.copy_with(scheme="ws", path="/api/live")),
            additional_headers={"Cookie": cookies},
            max_queue=max_queue,
            ping_interval=ping_interval,
            close_timeout=close_timeout,
        )

    def wait(self, enough: Callable[[], Any]) -> Any:
        """What ``enough`` returns, once that is true.

        Raises:
            OperationError: the station ended, or it takes too long.
        """
        deadline_s = time.monotonic() + PATIENCE_S
        while not (found := enough()):
            if self.status is not None:
                last = (self.console_text.strip().splitlines() or ["it said nothing"])[-1]
                raise OperationError(ENDED, "the station ended", last)
            if time.monotonic() > deadline_s:
                raise stuck_error("the station does not go on")
            time.sleep(LOOK_S)
        return found

    def get(self, path: str) -> Any:
        return self.http.get(path).raise_for_status().json()

    def post(self, path: str, **body: object) -> httpx.Response:
        return self.http.post(path, json=body or None)

    def ask(self, flow: str, name: str, **args: object) -> bool:
        """Gives a command on the present view of a flow; whether it was done."""
        rev = self.get(f"/api/{flow}")["rev"]
        body = {"name": name, "args": args, "rev": rev, "key": uuid.uuid4().hex}
        return self.post(f"/api/{flow}/command", **body).status_code == 200

    def begin_session(self, flow: str, **body: object) -> None:
        """Begins a guided session; what has the arm is ended first."""
        ended = self.free_arm()
        if ended is not None:
            ended.raise_for_status()
        self.post(f"/api/{flow}/start", **body).raise_for_status()

    def free_arm(self) -> httpx.Response | None:
        """What is answered to the end of the activity that has the arm; None if none has it."""
        activity = self.get("/api/activity")["activity"]
        return None if activity is None else self.post("/api/activity/end", id=activity["id"])

    def begin_scan(self, name: str) -> None:
        """Starts a scan by the simulated operator, once the station allows it."""
        self.wait(lambda: self.get("/api/scan")["state"] == "idle")
        self.wait(lambda: self.post("/api/scan/start", name=name).status_code == 200)
        # the sweep of the scan before may still be ending
        self.wait(lambda: self.post("/api/scan/simulation", on=True).is_success)

    def stop_s(self) -> float:
        """How long Stop takes to be answered, in s."""
        began_s = time.monotonic()
        self.http.post("/api/stop").raise_for_status()
        return time.monotonic() - began_s

    def end(self, sign: int = signal.SIGTERM) -> float:
        """Asks it to end; how long that took, in s.

        Raises:
            OperationError: it does not.
        """
        began_s = time.monotonic()
        self._process.send_signal(sign)
        try:
            self._process.wait(END_S)
        except subprocess.TimeoutExpired as error:
            raise stuck_error("the station does not end", END_S) from error
        return time.monotonic() - began_s

    def kill(self) -> int:
        """Ends it with SIGKILL; the monotonic time in ns."""
        with contextlib.suppress(ProcessLookupError):
            os.kill(self.pid, signal.SIGKILL)
        killed_ns = time.monotonic_ns()
        self._process.wait()
        return killed_ns
