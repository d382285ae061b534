"""A station whose broker strangers flood: Stop, memory, and the honest station beside."""

import json
import threading
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from contextlib import ExitStack, contextmanager, suppress
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import httpx
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection

from crenel.errors import OperationError
from crenel.progress import Progress, no_progress
from crenel.settings.station_toml import DEFAULT_FILE
from tests.bench.faults.broker.mosquitto import BINARY, Mosquitto
from tests.bench.faults.broker.publishers import HONEST, PUBLISHERS, honest_station, publish
from tests.bench.faults.calls import UNAVAILABLE
from tests.bench.faults.row import FaultRow
from tests.bench.faults.served import prepare
from tests.bench.faults.station import StationProcess
from tests.bench.station.subprocess_station import memory_mb

SECONDS, EVERY_S = 20.0, 0.25
TABS = 3
"""Browser tabs that show all stations."""
SETTLED_S = 20.0
EVERYTHING = "everything at once"


def run(
    data: Path,
    seconds: float = SECONDS,
    floods: Sequence[str] = tuple(PUBLISHERS),
    settled_s: float = SETTLED_S,
    progress: Progress = no_progress,
) -> list[FaultRow]:
    """Each flood for so long, and all of them at once, with Stop pressed four times a second.

    One station meets them all, with open tabs that show every station on the broker. A look at
    which the honest station beside the flood is not shown as live is not survived. The memory
    stated is the most since the tabs were open, not since the flood before.

    Args:
        data: a folder for the station's own, which is made.
        settled_s: until the memory of a station with open tabs no longer grows by itself.

    Raises:
        OperationError: there is no mosquitto here.
    """
    if BINARY is None:
        raise OperationError(
            UNAVAILABLE, "A hostile broker was not tried", "mosquitto is not installed"
        )
    prepare(data)
    rows = []
    with ExitStack() as opened:
        broker = opened.enter_context(Mosquitto(data.parent))
        _write_settings(data, broker.port)
        station = opened.enter_context(StationProcess(data)).enter()
        opened.enter_context(honest_station(broker.port))
        with _open_tabs(station) as shown:
            station.wait(lambda: shown.state_of(HONEST) == "live")
            time.sleep(settled_s)
            before_mb = memory_mb(station.pid)
            turns = [[name] for name in floods]
            if len(floods) > 1:
                turns.append(list(floods))
            for number, names in enumerate(turns):
                kind = f"broker: {names[0] if len(names) == 1 else EVERYTHING}"
                progress(number / len(turns), kind)
                row = FaultRow(kind)
                rows.append(row)
                most_mb = _flood(row, station, shown, broker.port, names, seconds)
                row.notes.append(f"{most_mb - before_mb:+.0f} MB")
        station.end()
    return rows


def _flood(
    row: FaultRow,
    station: StationProcess,
    shown: "_ShownStations",
    port: int,
    names: Sequence[str],
    seconds: float,
) -> float:
    """Looks four times a second while a process floods; the most memory in MB."""
    most_mb = memory_mb(station.pid)
    with ProcessPoolExecutor(1, get_context("spawn")) as processes:
        flooding = processes.submit(publish, list(names), port, seconds)
        while not flooding.done():
            time.sleep(EVERY_S)
            most_mb = max(most_mb, memory_mb(station.pid))
            try:
                row.note_stop(station.stop_s())
            except (httpx.HTTPError, OperationError) as error:
                row.notes.append(f"Stop failed: {type(error).__name__}")
            row.count_try(shown.state_of(HONEST) == "live")
        row.notes.append(f"{flooding.result()} messages")
    return most_mb


class _ShownStations:
    """What a tab shows of the stations on the broker."""

    def __init__(self) -> None:
        self.stations: list[dict[str, Any]] = []

    def take(self, text: str) -> None:
        """Reads a message of the live connection."""
        received = json.loads(text)
        if received.get("name") == "stations":
            self.stations = received["value"]

    def state_of(self, station: str) -> str:
        """Empty for one that is not shown."""
        states = (str(one["state"]) for one in self.stations if one["id"] == station)
        return next(states, "")


@contextmanager
def _open_tabs(station: StationProcess) -> Iterator[_ShownStations]:
    """Live connections that read everything; what the first one shows."""
    shown = [_ShownStations() for _ in range(TABS)]
    readers: list[threading.Thread] = []
    with ExitStack() as opened:
        for one in shown:
            tab = opened.enter_context(station.live())
            tab.send(json.dumps({"type": "stations", "on": True}))
            readers.append(threading.Thread(target=_read, args=(tab, one)))
            readers[-1].start()
        yield shown[0]
    for reader in readers:
        reader.join()


def _read(tab: ClientConnection, shown: _ShownStations) -> None:
    with suppress(ConnectionClosed):
        for received in tab:
            if isinstance(received, str):
                shown.take(received)


def _write_settings(data: Path, port: int) -> None:
    """The station listens to the broker on a port of this machine."""
    lines = ("[mqtt]", 'host = "127.0.0.1"', f"port = {port}", 'station = "bench"')
    (data / DEFAULT_FILE).write_text("\n".join(lines) + "\n")
