"""The 3D view after a long scan: how soon a second viewer has all of it, and what it takes.

Points go to the display as in a scan, in a station of its own process; the
viewer reads the 3D view's socket through the station's server.
"""

import contextlib
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass
from multiprocessing.connection import Connection
from pathlib import Path

import httpx
import numpy as np

from crenel.formats.clouds.points import Points, pack_points
from crenel.progress import Progress, no_progress
from crenel.station.view3d.scene import Scene
from crenel_hardware.simulator.devices.fast_simulator import FastStationConfig
from tests.bench.station.live import serving
from tests.bench.station.subprocess_station import MB, memory_mb, run_in_process, sign_in
from tests.bench.station.viewer_client import watch_view

LINE, LINES_A_PIECE = 2000, 16
PIECE = LINE * LINES_A_PIECE
WIDE_MM, LONG_MM, STEP_MM = 400.0, 600.0, 0.1
"""The part, swept again and again, each time in between the lines of before."""
NOISE_MM = 0.02
MAX_WAITING = 200_000
COLUMNS = ("measure", "value")


@dataclass(frozen=True)
class ViewBench:
    """What the view did with it."""

    points: int
    points_displayed: int
    displayed_per_s: float
    """Points a second that the display took."""
    memory_mb: float
    """Of the station, at the end."""
    join_s: float
    """From a second viewer's connection until it has all that is shown."""
    join_mb: float
    """That it was sent."""
    recolour_s: float
    """From the wish for other colours until the last point of the viewer has them."""


def table(found: ViewBench) -> list[tuple[str, str]]:
    return [
        ("points scanned, shown", f"{found.points}, {found.points_displayed}"),
        ("taken by the display", f"{found.displayed_per_s / 1e6:.1f} million points/s"),
        ("the station's memory", f"{found.memory_mb:.0f} MB"),
        ("a second viewer has the whole picture", f"{found.join_s:.2f} s, {found.join_mb:.0f} MB"),
        ("all points in other colours", f"{found.recolour_s:.2f} s"),
    ]


def run(points: int, progress: Progress = no_progress) -> ViewBench:
    """Shows so many points, then lets a second viewer join."""
    with (
        tempfile.TemporaryDirectory(prefix="crenel-bench-") as folder,
        _run_station(Path(folder), points) as (pipe, port, pid, signed_in),
        httpx.Client(base_url=f"http://127.0.0.1:{port}", headers=signed_in, timeout=30.0) as http,
    ):
        began_s = time.monotonic()
        while (given := int(pipe.recv())) < points:
            progress(given / points, f"{given / 1e6:.0f} million points")
        seconds = time.monotonic() - began_s
        address = f"ws://127.0.0.1:{port}/viewer/"
        with watch_view(address, signed_in, 0, 1.0, until_whole=True) as watched:
            joined = watched()
        shown = sum(scan["points_shown"] for scan in http.get("/api/view").json()["scans"])
        with watch_view(address, signed_in, 0, 1.0, coloured=shown) as watched:
            time.sleep(1.0)
            asked_s = time.monotonic()
            http.post("/api/view/colours", json={"measure": "intensity"}).raise_for_status()
            coloured_s = watched().coloured_at_s - asked_s
        return ViewBench(
            points=points,
            points_displayed=shown,
            displayed_per_s=points / seconds,
            memory_mb=memory_mb(pid),
            join_s=joined.complete_s,
            join_mb=joined.bytes / MB,
            recolour_s=coloured_s,
        )


@contextlib.contextmanager
def _run_station(data: Path, points: int) -> Iterator[tuple[Connection, int, int, dict[str, str]]]:
    """A station in a process of its own that shows so many points.

    Yields its pipe, port and id, and the header of a browser that is signed in there.
    """
    with run_in_process(_serve, data, points) as (pipe, pid):
        port, signed_in = pipe.recv()
        yield pipe, port, pid, signed_in


def _serve(pipe: Connection, data: Path, points: int) -> None:
    """In the station's process: until something comes through the pipe."""
    with serving(data, FastStationConfig(profiles_hz=2.0, width_px=100)) as (station, port, _):
        pipe.send((port, sign_in(station, port)))
        _show(station.scene, points, pipe)
        pipe.recv()


def _show(scene: Scene, points: int, pipe: Connection) -> None:
    """As a scan does, as fast as the display takes them without leaving any out."""
    scene.begin("bench")
    random = np.random.default_rng(1)
    given = 0
    while given < points:
        while scene.waiting > MAX_WAITING:
            time.sleep(0.005)
        scene.add_points(_piece(given, random))
        given += PIECE
        if given // PIECE % 50 == 0:
            pipe.send(min(given, points - 1))
    while scene.waiting:
        time.sleep(0.01)
    time.sleep(0.5)
    pipe.send(points)


def _piece(given: int, random: np.random.Generator) -> Points:
    """The next lines across a wavy part."""
    line = given // LINE + np.repeat(np.arange(LINES_A_PIECE), LINE)
    lines = int(LONG_MM / STEP_MM)
    y = STEP_MM * (line % lines) + 0.37 * STEP_MM * (line // lines)
    x = 300.0 + WIDE_MM / LINE * np.tile(np.arange(LINE), LINES_A_PIECE)
    z = 20.0 * np.sin(x / 60.0) * np.cos(y / 80.0) + random.normal(0.0, NOISE_MM, len(x))
    places = np.column_stack([x, y, z])
    return pack_points(places, 60.0 + 30.0 * np.sin(x / 9.0), np.full(len(x), 8.0), line)
