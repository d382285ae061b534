"""A station that strangers flood: Stop, memory and the log meanwhile."""

import threading
import time
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import httpx

from app.bench.faults.hostile import FLOODS, Address, Sent
from app.bench.faults.row import FaultRow
from app.bench.faults.served import prepare
from app.bench.faults.station import Station
from app.bench.station.subprocess_station import memory_mb
from app.errors import Refusal
from app.progress import Progress, no_progress

SECONDS = 20.0
THREADS = 4
EVERY_S, AN_HOUR_S = 0.25, 3600.0
LEAST_TRIES = 3
"""Of Stop, however long it takes."""


def run(data: Path, seconds: float = SECONDS, progress: Progress = no_progress) -> list[FaultRow]:
    """Each flood for so long, from four threads, with Stop pressed four times a second.

    A request that is answered by 500 is not survived. All kinds meet one station, which has a
    live connection open that nobody reads.

    Args:
        data: a folder for the station's own, which is made.
    """
    prepare(data)
    rows = []
    with Station(data) as station:
        station.enter()
        base = station.http.base_url
        address = (base.host, base.port or 0)
        with station.live(max_queue=1, ping_interval=None):
            for number, name in enumerate(FLOODS):
                progress(number / len(FLOODS), f"flood: {name}")
                rows.append(_under(station, name, address, seconds))
        station.end()
    return rows


def _under(station: Station, name: str, address: Address, seconds: float) -> FaultRow:
    """Stop is pressed here while the flood comes from a process of its own."""
    row = FaultRow(f"flood: {name}")
    before_mb, before_bytes = memory_mb(station.pid), station.logged_bytes()
    most_mb, pressed, failed = before_mb, 0, list[str]()
    with ProcessPoolExecutor(1, get_context("spawn")) as processes:
        flood = processes.submit(_flood, name, address, seconds)
        while not flood.done() or pressed < LEAST_TRIES:
            pressed += 1
            try:
                row.stopped(station.stop_s())
            except (httpx.HTTPError, Refusal) as error:
                failed.append(type(error).__name__)
            most_mb = max(most_mb, memory_mb(station.pid))
            time.sleep(EVERY_S)
        sent = flood.result()
    hour_mb = (station.logged_bytes() - before_bytes) * AN_HOUR_S / seconds / 1e6
    row.tries, row.survived = sent.requests, sent.requests - sent.faults
    row.notes.append(f"{most_mb - before_mb:+.0f} MB, {hour_mb:.2f} MB logged an hour")
    if failed:
        row.notes.append(f"Stop failed {len(failed)} times of {pressed}: {failed[0]}")
    return row


def _flood(name: str, address: Address, seconds: float) -> Sent:
    sent, until_s = Sent(), time.monotonic() + seconds
    threads = [
        threading.Thread(target=FLOODS[name], args=(address, until_s, sent)) for _ in range(THREADS)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return sent
