"""Many browsers on one station while it scans: how old the state is that reaches them.

Each viewer holds the two connections of a browser's tab, the live state with the camera's
pictures and the 3D view. One of them is slow: it takes nothing for as long as it is there.
"""

import asyncio
import contextlib
import json
import tempfile
import threading
import time
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from multiprocessing.connection import Connection
from pathlib import Path

import httpx
import numpy as np
from websockets.asyncio.client import connect

from crenel.progress import Progress, no_progress
from crenel.station.bus import Bus
from crenel_hardware.simulator.devices.fast_simulator import FastStationConfig
from tests.bench.station.live import scanning, wait_for_stop
from tests.bench.station.subprocess_station import run_in_process, sign_in
from tests.bench.station.viewer_client import PROTOCOL

TOPIC = "pulse"
PULSE_S = 0.1
SETTLING_S = 2.0
"""What comes in the first moments, while all join at once, is not judged."""
GOODBYE_S = 0.1
"""Who has stopped reading does not see the answer to a goodbye, and waits no longer for it."""


@dataclass(frozen=True)
class ViewersBench:
    """What the viewers saw, and what the scan lost meanwhile."""

    viewers: int
    seconds: float
    states: int
    age_median_s: float
    age_95_s: float
    """Of the state that came to all but the slow one."""
    pictures_hz: float
    """Camera pictures a second and viewer."""
    view_mb_s: float
    """Of the 3D view, all viewers together."""
    lost_alone: int
    lost_watched: int
    """Frames lost before anybody looked on, and with all of them."""


COLUMNS = ("measure", "value")


def table(found: ViewersBench) -> list[tuple[str, str]]:
    return [
        ("viewers, one of them slow", f"{found.viewers} for {found.seconds:.0f} s"),
        (
            "age of the state at the others",
            f"{found.age_median_s:.3f} s median, {found.age_95_s:.3f} s 95th percentile"
            f" of {found.states}",
        ),
        ("camera pictures a second and viewer", f"{found.pictures_hz:.1f}"),
        ("the 3D view to all of them", f"{found.view_mb_s:.1f} MB/s"),
        ("frames lost, nobody looking on; all", f"{found.lost_alone}; {found.lost_watched}"),
    ]


def run(
    pace: FastStationConfig, viewers: int, seconds: float, progress: Progress = no_progress
) -> ViewersBench:
    """Scans, a quarter of the time unwatched; an HTTP error where the station does not."""
    with (
        tempfile.TemporaryDirectory(prefix="crenel-bench-") as folder,
        _run_station(Path(folder), pace) as (port, signed_in),
        httpx.Client(base_url=f"http://127.0.0.1:{port}", headers=signed_in, timeout=30.0) as http,
    ):
        http.post("/api/scan/start", json={"name": "Bench"}).raise_for_status()
        progress(0.0, "nobody looks on")
        time.sleep(seconds / 4)
        lost_alone = int(http.get("/api/scan").json()["lost_frames"])
        progress(0.25, f"{viewers} viewers")
        seen = asyncio.run(_crowd(port, signed_in, viewers, seconds))
        http.post("/api/stop").raise_for_status()
        lost = int(wait_for_stop(http)["lost_frames"])
    ages_s = np.array(seen.ages_s)
    return ViewersBench(
        viewers=viewers,
        seconds=seconds,
        states=len(ages_s),
        age_median_s=float(np.median(ages_s)),
        age_95_s=float(np.percentile(ages_s, 95)),
        pictures_hz=seen.pictures / (viewers - 1) / seconds,
        view_mb_s=seen.view_bytes / seconds / 1e6,
        lost_alone=lost_alone,
        lost_watched=lost - lost_alone,
    )


class _ViewerStatistics:
    """What came to all viewers together."""

    def __init__(self) -> None:
        self.ages_s: list[float] = []
        self.pictures = 0
        self.view_bytes = 0
        self._judged_from_s = time.monotonic() + SETTLING_S

    def take(self, text: str) -> None:
        now_s = time.monotonic()
        message = json.loads(text)
        if message.get("name") == TOPIC and now_s > self._judged_from_s:
            self.ages_s.append(now_s - float(message["value"]))


async def _crowd(
    port: int, signed_in: Mapping[str, str], viewers: int, seconds: float
) -> _ViewerStatistics:
    """All viewers at once, for so long."""
    seen = _ViewerStatistics()
    tasks = [asyncio.create_task(_idle(port, signed_in))]
    for _ in range(viewers - 1):
        tasks.append(asyncio.create_task(_follow(port, signed_in, seen)))
        tasks.append(asyncio.create_task(_look(port, signed_in, seen)))
    done, running = await asyncio.wait(tasks, timeout=seconds, return_when=asyncio.FIRST_EXCEPTION)
    for task in running:
        task.cancel()
    await asyncio.gather(*running, return_exceptions=True)
    for task in done:
        task.result()
    return seen


async def _follow(port: int, signed_in: Mapping[str, str], seen: _ViewerStatistics) -> None:
    """The live state, with the camera's pictures acknowledged as they come."""
    async with connect(
        f"ws://127.0.0.1:{port}/api/live", additional_headers=signed_in, close_timeout=GOODBYE_S
    ) as live:
        await live.send(json.dumps({"type": "preview", "on": True}))
        async for message in live:
            if isinstance(message, bytes):
                seen.pictures += 1
                header = json.loads(message[4 : 4 + int.from_bytes(message[:4], "big")])
                await live.send(json.dumps({"type": "preview_ack", "seq": header["seq"]}))
            else:
                seen.take(message)


async def _look(port: int, signed_in: Mapping[str, str], seen: _ViewerStatistics) -> None:
    """The 3D view."""
    async with connect(
        f"ws://127.0.0.1:{port}/viewer/",
        additional_headers=signed_in,
        subprotocols=[PROTOCOL],
        max_size=None,
        compression=None,
        close_timeout=GOODBYE_S,
    ) as view:
        async for message in view:
            seen.view_bytes += len(message)


async def _idle(port: int, signed_in: Mapping[str, str]) -> None:
    """A tablet that went to sleep with both connections open: it reads nothing more."""
    async with (
        connect(
            f"ws://127.0.0.1:{port}/api/live",
            additional_headers=signed_in,
            max_queue=1,
            ping_interval=None,
            close_timeout=GOODBYE_S,
        ) as live,
        connect(
            f"ws://127.0.0.1:{port}/viewer/",
            additional_headers=signed_in,
            subprotocols=[PROTOCOL],
            max_size=None,
            max_queue=1,
            ping_interval=None,
            close_timeout=GOODBYE_S,
        ),
    ):
        await live.send(json.dumps({"type": "preview", "on": True}))
        await asyncio.sleep(float("inf"))


@contextlib.contextmanager
def _run_station(data: Path, pace: FastStationConfig) -> Iterator[tuple[int, dict[str, str]]]:
    """A station in a process of its own; its port, and the header of a browser signed in."""
    with run_in_process(_serve, data, pace) as (pipe, _):
        yield pipe.recv()


def _serve(pipe: Connection, data: Path, pace: FastStationConfig) -> None:
    """In the station's process: until something comes through the pipe."""
    ended = threading.Event()
    with scanning(data, pace) as (station, port, _):
        pulse = threading.Thread(target=_pulse, args=(station.bus, ended))
        pulse.start()
        pipe.send((port, sign_in(station, port)))
        pipe.recv()
        ended.set()
        pulse.join()


def _pulse(bus: Bus, ended: threading.Event) -> None:
    """Publishes the time, often."""
    while not ended.wait(PULSE_S):
        bus.publish(TOPIC, time.monotonic())
