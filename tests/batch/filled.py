"""A station with scans and their calibration, and the archive of it."""

import os
from collections.abc import Sequence
from datetime import UTC, datetime, timedelta
from pathlib import Path

from crenel.formats.recording import reader
from crenel.formats.recording.writer import RecordingWriter
from crenel.store.scans import ScanRecord
from crenel.store.store import Store
from tests.archive.filled import archive_of
from tests.datasheets import write_arm
from tests.formats.builders import ARM, joints_every
from tests.formats.test_documents import calibration_file
from tests.workflows.test_reconstruct import MS, NAMES, record_stripe

CALIBRATION = "20260501-080000-calibration"
FIRST = datetime(2026, 5, 1, 10, tzinfo=UTC)
PLACEHOLDER = b"scan 0000"
ABOUT = {reader.ARM_SERIAL: "A-1", reader.SENSOR_SERIAL: "S-1"}
ABOUT |= {reader.SCAN_CALIBRATION: CALIBRATION}
"""What each recording says of its devices."""


def write_recording(path: Path, frames: int) -> Path:
    """A recording of some frames, 4 ms apart, as a station writes it."""
    about = ABOUT | {reader.SCAN_NAME: PLACEHOLDER.decode(), reader.SCAN_STARTED: FIRST.isoformat()}
    with RecordingWriter(path, NAMES, about) as writer:
        joints_every(writer, 0, (frames + 20) * 4 * MS, 4 * MS)
        for number in range(frames):
            record_stripe(writer, (10 + number) * 4 * MS)
    return path


def fill_station(data: Path, scans: Sequence[str], frames: int = 20) -> Store:
    """A data folder whose scans differ by their names and days, with their calibration."""
    store = Store(data)
    session = data / "sessions" / CALIBRATION
    session.mkdir(parents=True)
    calibration_file().write(session / "calibration.json")
    write_arm(session / "arm.json", ARM)
    store.journal.begin_session(CALIBRATION, "calibration")
    store.journal.end_session(CALIBRATION)
    template = write_recording(data / "template.mcap", frames).read_bytes()
    (data / "template.mcap").unlink()
    assert template.count(PLACEHOLDER) >= 1
    for number, scan_id in enumerate(scans):
        folder = data / "scans" / scan_id
        folder.mkdir(parents=True)
        started = FIRST + timedelta(days=number)
        name = b"scan %04d" % (number + 1)
        content = template.replace(PLACEHOLDER, name)
        content = content.replace(FIRST.isoformat().encode(), started.isoformat().encode())
        (folder / "scan.mcap").write_bytes(content)
        os.utime(folder / "scan.mcap", (started.timestamp() + 60,) * 2)
        (folder / "cloud.ply").write_bytes(b"ply")
        record = ScanRecord(scan_id, scan_id, folder, started.isoformat(), 5, 5, 1.0, CALIBRATION)
        store.scans.add(record)
    return store


def archive_and_close(store: Store, place: Path) -> None:
    """All that a station has, in its archive at a place that may be new."""
    place.mkdir(parents=True, exist_ok=True)
    try:
        archive_of(store, str(place)).run()
    finally:
        store.close()


def fill_archive(place: Path, data: Path, scans: Sequence[str]) -> None:
    archive_and_close(fill_station(data, scans), place)
