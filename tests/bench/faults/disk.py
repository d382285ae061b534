"""A station whose disk fills up at any call that takes from it, and has space again."""

import mmap
import random
import shutil
import struct
from pathlib import Path
from types import TracebackType
from typing import Self

from crenel.errors import OperationError
from crenel.progress import Progress, no_progress
from tests.bench.faults.calls import compile_library, preload_environment
from tests.bench.faults.furnished import FolderRecords, furnish
from tests.bench.faults.looking import query_station
from tests.bench.faults.row import FaultRow
from tests.bench.faults.station import StationProcess

TRIES = 30
MAX_CALLS = 400
"""Calls after which it is full at the latest; about as many as one look makes."""
LENGTHS = (1, 2, 5, 20, 100, -1)
"""So many calls find it full; -1 for all until it is emptied."""
NEVER = -1


class Disk:
    """What the preloaded library goes by: calls until it is full, calls it stays so, calls."""

    def __init__(self, path: Path) -> None:
        path.write_bytes(struct.pack("3q", NEVER, 0, 0))
        self._file = path.open("r+b")
        self._memory = mmap.mmap(self._file.fileno(), 0)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._memory.close()
        self._file.close()

    def fill(self, after: int, length: int) -> None:
        struct.pack_into("q", self._memory, 8, length)
        struct.pack_into("q", self._memory, 0, after)

    def empty(self) -> None:
        struct.pack_into("q", self._memory, 0, NEVER)


def run(
    data: Path,
    tries: int = TRIES,
    seed: int = 0,
    progress: Progress = no_progress,
    kept: FolderRecords | None = None,
) -> FaultRow:
    """Fills the disk after any number of calls while everything is asked of a station.

    Meanwhile it answers without a fault, lets people sign in and stops; with space again a scan
    is kept; and after a restart everything is there that was listed.

    Args:
        data: a folder for the station's own, which is made.
        kept: what is in the folder, where it is furnished already.

    Raises:
        OperationError: the library cannot be preloaded here.
    """
    data.parent.mkdir(parents=True, exist_ok=True)
    library = compile_library(data.parent)
    kept = kept or furnish(data, progress)
    rng, row = random.Random(seed), FaultRow("a disk that fills up")
    for number in range(tries):
        after, length = rng.randrange(MAX_CALLS * (number + 1) // tries), rng.choice(LENGTHS)
        progress(number / tries, f"a disk that is full after {after} calls")
        copy = data.with_name(f"{data.name}-filled")
        shutil.copytree(data, copy)
        try:
            with Disk(data.parent / "disk") as disk:
                wrong, lost = _try(copy, library, disk, (after, length), kept, row)
            notes = "; ".join([*wrong, *lost])
            named = f"after {after}, for {length}: {notes}" if notes else ""
            row.count_try(not notes, bool(lost), named)
        finally:
            shutil.rmtree(copy)
    return row


def _try(
    data: Path, library: Path, disk: Disk, when: tuple[int, int], kept: FolderRecords, row: FaultRow
) -> tuple[list[str], list[str]]:
    environment = preload_environment(data, library, DISK=data.parent / "disk")
    try:
        with StationProcess(data, environment) as station:
            station.enter()
            disk.fill(*when)
            wrong = query_station(station, {"scan_id": list(kept.scans)}).faults
            row.note_stop(station.stop_s())
            wrong += _sign_in_again(station)
            disk.empty()
            station.begin_scan("With space again")
            station.wait(lambda: station.get("/api/scan")["frames"] > 0)
            station.post("/api/scan/stop").raise_for_status()
            listed = _list_stored(station)
            station.kill()
        with StationProcess(data) as station:
            station.enter()
            lost = [f"{one} is not listed" for one in listed - _list_stored(station)]
    except OperationError as refusal:
        return [refusal.line], []
    return wrong, lost


def _sign_in_again(station: StationProcess) -> list[str]:
    answer = station.sign_in()
    return [] if answer.is_success else [f"signing in: {answer.status_code} {answer.text[:200]}"]


def _list_stored(station: StationProcess) -> set[str]:
    """What the station calls saved: scans, calibrations, and the points of the open session."""
    records = [*station.get("/api/scans"), *station.get("/api/calibrations")]
    flow = station.get("/api/flow")
    points = flow["picture"].get("points") or ()
    return {one["id"] for one in records} | {
        f"point {point.get('face')} {point['index']} of {flow['session_id']}" for point in points
    }
