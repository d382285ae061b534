"""A station that strangers flood: Stop, memory and the log meanwhile."""

import time
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from multiprocessing import get_context
from pathlib import Path

import httpx

from crenel.errors import OperationError
from crenel.progress import Progress, no_progress
from tests.bench.faults.hostile import FLOODS, Address, flood
from tests.bench.faults.row import FaultRow
from tests.bench.faults.served import prepare
from tests.bench.faults.station import StationProcess
from tests.bench.station.subprocess_station import memory_mb

SECONDS = 20.0
EVERY_S, HOUR_S = 0.25, 3600.0
BEGINNING_S, SETTLED = 1.0, 0.4
"""A flood begins so much later than its process, and after this share of it, lines of each kind
are counted rather than written."""
MIN_TRIES = 3
"""Of Stop, however long it takes."""


def run(data: Path, seconds: float = SECONDS, progress: Progress = no_progress) -> list[FaultRow]:
    """Each flood for so long, from four threads, with Stop pressed four times a second.

    A request that is answered by 500 is not survived. All kinds meet one station, which has a
    live connection open that nobody reads. What is logged in an hour is what is logged at the
    beginning, until the first lines of each kind are written, and so much as after that for an
    hour; without what Stop itself logs.

    Args:
        data: a folder for the station's own, which is made.
    """
    prepare(data)
    rows = []
    with StationProcess(data) as station:
        station.enter()
        base = station.http.base_url
        address = (base.host, base.port or 0)
        # who reads nothing does not see the answer to its goodbye, either
        with station.live(max_queue=1, ping_interval=None, close_timeout=0.1):
            stop_bytes = _log_bytes_of_stop(station, seconds)
            for number, name in enumerate(FLOODS):
                progress(number / len(FLOODS), f"flood: {name}")
                rows.append(_measure_under(station, name, address, seconds, stop_bytes))
        station.end()
    return rows


@dataclass
class _Logged:
    """What a station logs at the beginning and from then on, and how often Stop was pressed."""

    station: StationProcess
    beginning_s: float
    pressed: int = 0
    """After the beginning."""

    def __post_init__(self) -> None:
        self._from_s = time.monotonic() + self.beginning_s
        self._first = self._before = self.station.log_bytes()
        self._pressed_before = 0

    def press(self) -> float:
        """Presses Stop; how long it took in s. Raises as ``StationProcess.stop_s``."""
        if not self.pressed and time.monotonic() < self._from_s:
            self._pressed_before += 1
            return self.station.stop_s()
        if not self.pressed:
            self._from_s, self._before = time.monotonic(), self.station.log_bytes()
        self.pressed += 1
        return self.station.stop_s()

    @property
    def bytes_by_stop(self) -> float:
        """Where nothing else is logged."""
        return (self.station.log_bytes() - self._before) / self.pressed

    def hour_bytes(self, stop_bytes: float) -> float:
        """The beginning, and as after it for an hour, without what Stop logs."""
        late = self.station.log_bytes() - self._before - stop_bytes * self.pressed
        early = self._before - self._first - stop_bytes * self._pressed_before
        return max(early, 0.0) + max(late, 0.0) * HOUR_S / (time.monotonic() - self._from_s)


def _log_bytes_of_stop(station: StationProcess, seconds: float) -> float:
    """Bytes that a station without a flood logs for each Stop."""
    logged, until_s = _Logged(station, SETTLED * seconds), time.monotonic() + seconds
    while time.monotonic() < until_s or not logged.pressed:
        logged.press()
        time.sleep(EVERY_S)
    return logged.bytes_by_stop


def _measure_under(
    station: StationProcess, name: str, address: Address, seconds: float, stop_bytes: float
) -> FaultRow:
    """Stop is pressed here while the flood comes from a process of its own."""
    row = FaultRow(f"flood: {name}")
    before_mb = most_mb = memory_mb(station.pid)
    pressed, failed = 0, list[str]()
    with ProcessPoolExecutor(1, get_context("spawn")) as processes:
        flooding = processes.submit(flood, name, address, seconds)
        logged = _Logged(station, BEGINNING_S + SETTLED * seconds)
        while not flooding.done() or pressed < MIN_TRIES or not logged.pressed:
            pressed += 1
            try:
                row.note_stop(logged.press())
            except (httpx.HTTPError, OperationError) as error:
                failed.append(type(error).__name__)
            most_mb = max(most_mb, memory_mb(station.pid))
            time.sleep(EVERY_S)
        sent = flooding.result()
        hour_mb = logged.hour_bytes(stop_bytes) / 1e6
    row.tries, row.survived = sent.requests, sent.requests - sent.faults
    row.notes.append(f"{most_mb - before_mb:+.0f} MB, {hour_mb:.3f} MB logged an hour")
    if failed:
        row.notes.append(f"Stop failed {len(failed)} times of {pressed}: {failed[0]}")
    return row
