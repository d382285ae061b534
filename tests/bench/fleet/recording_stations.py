"""Simulated stations as processes, which make scans and archive them in a store."""

import threading
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from crenel.archive.archive import Archive
from crenel.archive.archive_settings import ArchiveSettings
from crenel.archive.notes import NOTES
from crenel.archive.pace import full_speed
from crenel.archive.records import list_records, open_record_lists
from crenel.settings.station_toml import DEFAULT_FILE
from tests.bench.faults.served import SMALL, prepare
from tests.bench.faults.station import StationProcess
from tests.bench.fleet.s3_server import BUCKET

PLANT = "plant"
"""In the bucket: what the stations' archives are in."""
KEY, SECRET = "key", "secret"


@dataclass(frozen=True)
class BenchStation:
    """A station's name and its data folder."""

    name: str
    data: Path
    archive: ArchiveSettings

    def scans(self) -> list[Path]:
        """The folders of its scans."""
        return sorted(path for path in (self.data / "scans").iterdir() if path.is_dir())

    def count_noted(self) -> int:
        """Its scans that it has noted as archived."""
        return sum(1 for _ in (self.data / NOTES / "scans").glob("*.json"))


def make_station(top: Path, name: str, endpoint: str) -> BenchStation:
    """A data folder of a calibrated station with an archive in the store at an endpoint."""
    data = top / name
    prepare(data, SMALL)
    secret = (top / "secret").absolute()  # relative ones start at station.toml
    secret.write_text(SECRET)
    fields = {
        "url": f"s3://{BUCKET}/{PLANT}/{name}",
        "endpoint": endpoint,
        "access_key": KEY,
        "secret_file": str(secret),
    }
    lines = [f'{key} = "{value}"' for key, value in fields.items()]
    (data / DEFAULT_FILE).write_text("\n".join(["[archive]", *lines, ""]))
    settings = ArchiveSettings.model_validate(fields, context=data / DEFAULT_FILE)
    return BenchStation(name, data, settings)


class Recordings:
    """Scans that several stations make simultaneously, each one after the other.

    Args:
        count: of all stations together.
        seconds: of each scan.
    """

    def __init__(
        self,
        processes: Sequence[StationProcess],
        count: int,
        seconds: float,
        pool: ThreadPoolExecutor,
    ) -> None:
        self.made = 0
        self._seconds, self._lock = seconds, threading.Lock()
        self._left = count
        self._futures: list[Future[None]] = [pool.submit(self._record, one) for one in processes]

    @property
    def running(self) -> bool:
        """Whether any station still scans; raises ``OperationError`` of one that does not go on."""
        for future in self._futures:
            if future.done():
                future.result()
        return not all(future.done() for future in self._futures)

    def stop(self) -> None:
        """Begins no more scans."""
        with self._lock:
            self._left = 0

    def _record(self, station: StationProcess) -> None:
        while self._take():
            station.begin_scan("Part")
            time.sleep(self._seconds)
            station.wait(lambda: station.get("/api/scan")["seconds"] >= self._seconds)
            station.post("/api/scan/stop").raise_for_status()
            station.wait(lambda: station.get("/api/scan")["state"] == "idle")
            with self._lock:
                self.made += 1

    def _take(self) -> bool:
        with self._lock:
            self._left -= 1
            return self._left >= 0


@contextmanager
def recording(stations: Sequence[BenchStation], count: int, seconds: float) -> Iterator[Recordings]:
    """Starts the stations, which make so many scans together and then go on archiving.

    Raises:
        OperationError: a station does not start.
    """
    with ExitStack() as processes:
        started = [
            processes.enter_context(StationProcess(one.data, options=("--small",)))
            for one in stations
        ]
        for one in started:
            one.enter()
        with ThreadPoolExecutor(len(started), "record") as pool:
            recordings = Recordings(started, count, seconds, pool)
            try:
                yield recordings
            finally:
                recordings.stop()


def count_archived(station: BenchStation) -> int:
    """The scans of which the archive has exactly the station's files, by reading all of them.

    Raises:
        OperationError: the station still runs, or the archive cannot be read.
    """
    with open_record_lists(station.data) as lists:
        # where a copy is not whole, this removes the note about it
        Archive(station.archive, station.data.name, station.data, lists, full_speed()).verify()
        records = list_records(station.data, lists, datetime.now(UTC))
    return sum(one.kind == "scans" and one.is_archived for one in records)
