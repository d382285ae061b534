"""A data folder with something in every place of it, as a station leaves it."""

import shutil
import signal
import sqlite3
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path

from crenel.progress import Progress, no_progress
from crenel.store.store import RECORD_FOLDERS
from tests.bench.faults.served import prepare
from tests.bench.faults.station import StationProcess

SCANS = 2
SCAN_S = 0.6
SPARE = {
    "arms": "simulated.json",
    "objects": "simulated.json",
    "sensors": "simulated.json",
    "gauges": "plate.nominal.json",
}
"""What is copied to ``spare``: the demonstration writes its own datasheets again at each start."""
NOTIFIED = {"url": "http://127.0.0.1:9/", "secret": "x", "done": True, "fault": True, "due": True}
SETTINGS: dict[str, object] = {
    "threshold": None,
    "min_width_px": None,
    "choice": "continuity",
    "smoothing_px": None,
    "exposure_us": 4000.0,
    "blur_limit_mm": None,
    "record_pictures": False,
    "zones": [],
}
FOLDERS = ("arms", "objects", "sensors", "gauges", *RECORD_FOLDERS)


@dataclass(frozen=True)
class FolderRecords:
    """What is in the folder: the ids of its records."""

    scans: tuple[str, ...]
    calibration: str
    flow: str
    """The session of the calibration that is open."""
    verification: str
    """The one that is open."""
    performance: str
    """A test that was cancelled after some touches."""
    open_performance: str

    @property
    def records(self) -> tuple[str, ...]:
        """The ids of all that has ended."""
        return (*self.scans, self.calibration, self.performance)


def furnish(data: Path, progress: Progress = no_progress) -> FolderRecords:
    """Makes a data folder, which must not be there: calibration, scans, open sessions, settings.

    Raises:
        OperationError: the station does not go on.
    """
    prepare(data)
    with StationProcess(data) as station:
        station.enter()
        for number in range(SCANS):
            progress(number / (SCANS + 2), "a folder to be damaged: scans")
            station.begin_scan(f"Scan {number + 1}")
            station.wait(lambda: station.get("/api/scan")["seconds"] > SCAN_S)
            station.post("/api/scan/stop").raise_for_status()
        station.post("/api/notifications", **NOTIFIED).raise_for_status()
        station.post("/api/settings", **SETTINGS).raise_for_status()
        station.begin_session("arm", purpose="check")
        progress(SCANS / (SCANS + 2), "a folder to be damaged: sessions")
        performance = _cancel_performance_test(station)
        station.begin_session("performance")
        station.begin_session("verify")
        station.wait(lambda: station.ask("verify", "choose_gauge", id="plate"))
        station.begin_session("flow")
        station.wait(lambda: station.ask("flow", "confirm_devices"))
        station.wait(lambda: station.ask("flow", "run_simulation", all=True))
        station.wait(lambda: len(station.get("/api/flow")["picture"].get("points") or ()) > 3)
        station.post("/api/stop").raise_for_status()
        station.post("/api/backup").raise_for_status()
        station.wait(lambda: station.get("/api/health")["backup"]["last"])
        kept = FolderRecords(
            tuple(scan["id"] for scan in station.get("/api/scans")),
            station.get("/api/calibrations")[0]["id"],
            station.get("/api/flow")["session_id"],
            station.get("/api/verify")["session_id"],
            performance,
            station.get("/api/performance")["session_id"],
        )
        station.end(signal.SIGTERM)
    for folder, name in SPARE.items():
        shutil.copy(data / folder / name, data / folder / f"spare.{name.partition('.')[2]}")
    with closing(sqlite3.connect(data / "station.db")) as database:
        database.execute("PRAGMA wal_checkpoint(TRUNCATE)")
    return kept


def _cancel_performance_test(station: StationProcess) -> str:
    """Leaves a performance test of some touches behind, and returns its id."""
    station.begin_session("performance")
    station.wait(lambda: station.ask("performance", "run_simulation", all=True))
    station.wait(lambda: station.get("/api/performance")["progress"]["done"] > 1)
    station.post("/api/stop").raise_for_status()
    station.wait(lambda: station.ask("performance", "abandon", reason="other"))
    return str(station.get("/api/performances")[0]["id"])
