"""The simulated station with its devices failing in every step of a calibration and in a scan.

Times are as a browser sees them: from the fault until the live connection reports it, and
from its end until the device is reported as connected again.
"""

import json
import math
import tempfile
import threading
import time
import uuid
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import httpx
from websockets.sync.client import connect
from websockets.sync.connection import Connection

from crenel.progress import Progress, no_progress
from crenel.server.demo import station_parts
from crenel_hardware.simulator.station import SimulatedStation, SimulationConfig
from tests.bench.faults.served import CONFIG
from tests.bench.station.subprocess_station import (
    GUEST,
    PATIENCE_S,
    convert_connection_errors,
    serve_in_thread,
    sign_in,
    stuck_error,
)

View = dict[str, Any]
KIND = "devices"
"""Its name on the command line."""
POLL_S = 0.05
DEVICES = ("arm", "sensor")
CONTACT_COUNT = 4
"""Done in their step before the devices fail there."""
HELD_S = 1.0
"""A failure goes on for so long after the report of it."""


@dataclass(frozen=True)
class Failure:
    """One way to fail."""

    name: str
    device: str
    begin: Callable[[SimulatedStation], None]


def _unplug(station: SimulatedStation) -> None:
    station.arm_faults.unplugged = True


def _spoil(station: SimulatedStation) -> None:
    station.arm_faults.corrupt_rate = station.arm_faults.garbage_rate = 1.0


def _lose_camera(station: SimulatedStation) -> None:
    station.camera_faults.lost = True


def _freeze(station: SimulatedStation) -> None:
    station.arm_faults.frozen_joint = 3


def _turn_on(station: SimulatedStation) -> None:
    faults = station.arm_faults
    faults.odd_rad, faults.odd_every, faults.odd_joint = 6 * math.pi, 1, 0


def _offset_readings(station: SimulatedStation) -> None:
    faults = station.arm_faults
    faults.odd_rad, faults.odd_every, faults.odd_joint = math.pi / 2, 211, 2


FAILURES = (
    Failure("arm unplugged", "arm", _unplug),
    Failure("garbage on the arm's line", "arm", _spoil),
    Failure("joint 4 frozen", "arm", _freeze),
    Failure("joint 1 three turns on", "arm", _turn_on),
    Failure("joint 3 off by 90° once in 211", "arm", _offset_readings),
    Failure("camera lost", "sensor", _lose_camera),
)


@dataclass(frozen=True)
class DeviceFaultRow:
    """What came of one failure in one step."""

    step: str
    failure: str
    reported_s: float
    back_s: float
    untrue: int
    """Reports between the first that it is gone and the end of the failure that show the device as
    there, or the laser of a lost camera as on or off."""
    intact: bool
    """Whether everything that was taken before was there afterwards, in the same step."""


COLUMNS = ("step", "failure", "said after", "there again after", "untrue signs", "what was taken")


def table(rows: list[DeviceFaultRow]) -> list[tuple[str, ...]]:
    return [
        (
            row.step,
            row.failure,
            f"{row.reported_s:.2f} s",
            f"{row.back_s:.2f} s",
            str(row.untrue),
            "kept" if row.intact else "LOST",
        )
        for row in rows
    ]


def run(
    progress: Progress = no_progress, config: SimulationConfig = CONFIG
) -> list[DeviceFaultRow]:
    """Every failure in every step; a refusal where the station does not go on."""
    with (
        tempfile.TemporaryDirectory(prefix="crenel-bench-") as folder,
        SimulatedStation(config) as simulation,
    ):
        parts = replace(station_parts(simulation, Path(folder)), guest=GUEST)
        with convert_connection_errors(), serve_in_thread(parts) as (station, port):
            signed_in = sign_in(station, port)
            with (
                httpx.Client(
                    base_url=f"http://127.0.0.1:{port}", headers=signed_in, timeout=30.0
                ) as http,
                connect(f"ws://127.0.0.1:{port}/api/live", additional_headers=signed_in) as live,
                _DeviceMonitor(live) as monitor,
            ):
                return list(_walk(_StationClient(http, monitor, simulation), progress))


def count_done(view: View) -> int:
    """How much of a step is done."""
    return int((view["progress"] or {"done": 0})["done"])


class _DeviceMonitor:
    """What the live connection reports of the devices, read all the time as a browser does.

    A connection that nobody reads answers no pings, and the station ends it.
    """

    def __init__(self, live: Connection) -> None:
        self._live = live
        self._there: dict[str, bool] = {}
        self._gone: str | None = None
        self._untrue = 0
        self._changed = threading.Condition()
        self._thread = threading.Thread(target=self._read, daemon=True)

    def __enter__(self) -> "_DeviceMonitor":
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._live.close()
        self._thread.join()

    def _read(self) -> None:
        for message in self._live:
            received = json.loads(message) if isinstance(message, str) else {}
            if received.get("name") != "devices":
                continue
            with self._changed:
                self._there = {
                    device: received["value"][device]["state"] == "connected" for device in DEVICES
                }
                self._untrue += self._is_untrue(received["value"])
                self._changed.notify_all()

    def _is_untrue(self, devices: View) -> bool:
        """Whether a sign shows what cannot be known of a device that is gone."""
        if self._gone is None:
            return False
        shown = devices[self._gone]
        laser = devices["laser"]["state"] if self._gone == "sensor" else "unknown"
        return (shown["state"], shown["quality"]) == ("connected", "good") or laser != "unknown"

    def untrue_while_gone(self, device: str) -> int:
        """How many reports are untrue within the time that a failure goes on."""
        with self._changed:
            self._gone, self._untrue = device, 0
        time.sleep(HELD_S)
        with self._changed:
            self._gone = None
            return self._untrue

    def when(self, device: str, there: bool) -> float:
        """The monotonic time in s at which a device is reported as connected, or as lost.

        Raises:
            OperationError: it is not reported.
        """
        with self._changed:
            if not self._changed.wait_for(
                lambda: self._there.get(device) is there, timeout=PATIENCE_S
            ):
                raise stuck_error(f"nothing is reported of the {device}")
            return time.monotonic()


class _StationClient:
    """The station under test, from its browser's end."""

    def __init__(
        self, http: httpx.Client, monitor: _DeviceMonitor, simulation: SimulatedStation
    ) -> None:
        self.http, self._monitor, self._simulation = http, monitor, simulation

    def view(self) -> View:
        return dict(self.http.get("/api/flow").json())

    def until(self, enough: Callable[[View], bool]) -> View:
        deadline_s = time.monotonic() + PATIENCE_S
        while not enough(view := self.view()):
            if time.monotonic() > deadline_s:
                raise stuck_error(f"the flow stays at {view['step']}")
            time.sleep(POLL_S)
        return view

    def command(self, name: str, **args: object) -> None:
        """As soon as the station lets it."""

        def accepted(view: View) -> bool:
            body = {"name": name, "args": args, "rev": view["rev"], "key": uuid.uuid4().hex}
            return self.http.post("/api/flow/command", json=body).status_code == 200

        self.until(accepted)

    def rest(self) -> None:
        """Stops the simulated operator."""
        self.http.post("/api/stop").raise_for_status()
        self.until(lambda view: view["busy"] is None)

    def fail(
        self, step: str, taken: Callable[[], object] | None = None
    ) -> Iterator[DeviceFaultRow]:
        """Every failure; ``taken`` returns what must not change by it."""
        taken = taken or self.step_contents
        for failure in FAILURES:
            before = taken()
            self._monitor.when(failure.device, True)
            failed_s = time.monotonic()
            failure.begin(self._simulation)
            said_s = self._monitor.when(failure.device, False) - failed_s
            untrue = self._monitor.untrue_while_gone(failure.device)
            self._simulation.clear_faults()
            mended_s = time.monotonic()
            back_s = self._monitor.when(failure.device, True) - mended_s
            intact = before == taken()
            yield DeviceFaultRow(step, failure.name, said_s, back_s, untrue, intact)

    def step_contents(self) -> tuple[str, int, int]:
        """The step, and how much there is in it."""
        view = self.view()
        points = len(view["picture"].get("points") or ())
        return view["step"], points, count_done(view)


def _walk(bench: _StationClient, progress: Progress) -> Iterator[DeviceFaultRow]:
    """A calibration by the simulated operator, and a scan, failing at each step."""
    bench.http.post("/api/flow/start").raise_for_status()
    bench.until(lambda view: bool(view["actions"][0]["enabled"]))
    progress(0.0, "devices")
    yield from bench.fail("devices")
    bench.command("confirm_devices")
    progress(0.1, "setup")
    yield from bench.fail("setup")
    bench.command("run_simulation", all=True)
    bench.until(lambda view: len(view["picture"].get("points") or ()) >= CONTACT_COUNT)
    bench.rest()
    progress(0.3, "touch")
    yield from bench.fail("touch")
    bench.command("run_simulation", all=True)
    bench.until(lambda view: view["step"] == "capture")
    bench.rest()
    progress(0.6, "capture")
    yield from bench.fail("capture")
    bench.command("run_simulation", all=True)
    bench.until(lambda view: view["step"] == "review" and view["busy"] is None)
    progress(0.8, "review")
    yield from bench.fail("review")
    bench.command("accept")
    bench.http.post("/api/scan/start", json={"name": "Bench"}).raise_for_status()
    progress(0.9, "scan")
    yield from bench.fail("scan", lambda: bench.http.get("/api/scan").json()["state"])
    bench.http.post("/api/scan/stop").raise_for_status()
