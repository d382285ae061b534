"""Recovery after a killed process or a full disk: lists scans, computes their clouds, removes
leftovers."""

import json
import logging
import shutil
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

from crenel.archive.records import is_in_archive_only, is_without_its_cloud
from crenel.errors import OperationError, sentence
from crenel.formats.atomic_write import sync_file, sync_folder
from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.json_document import has_sha256, read_text
from crenel.formats.recording.reader import (
    SCAN_CALIBRATION,
    SCAN_NAME,
    SCAN_STARTED,
    find_damage,
    open_recording,
)
from crenel.formats.results.calibration import read_calibration
from crenel.formats.results.scan_record import CLOUD, LONGEST_NAME, part_from_metadata
from crenel.formats.session.calibration_session import ARM
from crenel.gauges.plan.document import RESULT
from crenel.loops import start_worker
from crenel.messages.message import Text, join, message
from crenel.operations.scan_calibrations import scan_calibrations
from crenel.station.bus import Bus
from crenel.station.jobs import Jobs
from crenel.station.scan.messages import suspension_text
from crenel.station.scan.scanner import Scanner
from crenel.station.scan.storage import RECORDING, ScanFolders
from crenel.store.scans import ScanRecord
from crenel.store.store import Store
from crenel.timestamps import is_moment, moment_of_ns
from crenel.workflows.reconstruct import Reconstruction, reconstruct_cloud

log = logging.getLogger(__name__)
DELETED = ".deleted-"
"""Prefix of folders of scans that are being deleted."""
KILLED = message("station-ended-during-scan")
RETRY_S = 10.0
END_S = 5.0
VERIFICATION = "verification.json"


class _CloudPostponedError(Exception):
    """The cloud is computed later: a scan starts, or the program ends."""


class Recovery:
    """Lists recordings that are not in the list, and computes missing clouds.

    Clouds are computed one after the other in a separate thread, while no scan and no other job is
    running.
    """

    def __init__(
        self,
        store: Store,
        scanner: Scanner,
        jobs: Jobs,
        bus: Bus,
        note_records: Callable[[], None],
    ) -> None:
        self._store, self._scanner, self._jobs, self._bus = store, scanner, jobs, bus
        self._note_records = note_records
        self._scans = store.folder / "scans"
        self._folders = ScanFolders(self._scans)
        self._errors: dict[str, OperationError] = {}
        self._hashed: dict[tuple[Path, int, str], bool] = {}
        self._not_before_s = 0.0
        self._scans_changed_ns = 0
        self._came_back: list[ScanRecord] = []
        self._ending = threading.Event()
        self._thread: threading.Thread | None = None

    # -- at the start --------------------------------------------------------

    def list_unlisted(self) -> None:
        """Lists every recording of a scan without a row as interrupted."""
        scans = self._store.scans.all()
        listed = {scan.folder for scan in scans} | {self._scans / scan.id for scan in scans}
        try:
            found = sorted(self._scans.iterdir())
        except OSError as error:
            log.warning("scans are not searched: %s", error)
            return
        for folder in found:
            try:
                self._list_recording(folder, folder in listed)
            except (OSError, OperationError) as error:
                text = error.line if isinstance(error, OperationError) else str(error)
                log.warning("%s is left as it is: %s", folder, text)

    def _list_recording(self, folder: Path, listed: bool) -> None:
        if folder.is_symlink() or not folder.is_dir():
            return
        if folder.name.startswith(DELETED):
            shutil.rmtree(folder)
            return
        for part in folder.glob(".*.part"):
            part.unlink()
        recording = folder / RECORDING
        if listed or not recording.is_file():
            return
        if not recording.stat().st_size:
            _remove_empty(folder)
            return
        scan = _scan_record(folder, open_recording(recording).station_metadata())
        for path in (recording, folder / CLOUD):
            if path.is_file():
                sync_file(path)
        sync_folder(folder)
        sync_folder(self._scans)
        self._store.scans.add(scan)
        self._bus.event("scan-found", message("recording-kept", name=scan.name), "attention")

    # -- while the station runs ----------------------------------------------

    def step(self) -> None:
        """Lists scans that waited for the disk, and starts to compute a missing cloud."""
        now_s = time.monotonic()
        busy = self._thread is not None and self._thread.is_alive()
        if busy or now_s < self._not_before_s or self._is_busy():
            return
        try:
            self._store.scans.add_waiting()
        except OperationError:
            self._not_before_s = now_s + RETRY_S
            return
        scan = next(iter(self._without_cloud()), None)
        if scan is None or self._folders.start_space_error() is not None:
            self._not_before_s = now_s + RETRY_S / 4
            return
        self._thread = start_worker("recovery", self._make_cloud, scan)

    def close(self) -> None:
        """Abandons a cloud in progress; it starts again after the next start."""
        self._ending.set()
        if self._thread is not None:
            self._thread.join(END_S)

    def _is_busy(self) -> bool:
        return self._scanner.recording() is not None or self._jobs.current is not None

    def _without_cloud(self) -> Iterator[ScanRecord]:
        """Interrupted scans, and those that came back from the archive, which keeps no clouds."""
        for scan in (*self._store.scans.list_interrupted(), *self._scans_that_came_back()):
            missing = not (scan.folder / CLOUD).exists() and not self._is_away(scan.folder)
            if scan.id not in self._errors and missing:
                yield scan

    def _scans_that_came_back(self) -> list[ScanRecord]:
        """The scans that came back without their clouds; looked for when a scan comes or goes."""
        try:
            changed_ns = self._scans.stat().st_mtime_ns
        except OSError:
            return []
        if changed_ns != self._scans_changed_ns:
            self._scans_changed_ns = changed_ns
            self._came_back = [one for one in self._store.scans.all() if self._is_fetched(one)]
        return self._came_back

    def _is_fetched(self, scan: ScanRecord) -> bool:
        """Whether a scan came back from the archive without its cloud."""
        return is_without_its_cloud(self._store.folder, scan.folder.name)

    def _make_cloud(self, scan: ScanRecord) -> None:
        try:
            made = self._rebuild(scan)
            text = message("points-made", name=scan.name, points=made.points)
            if made.incomplete:
                missing = made.warnings[0]
                text = message(
                    "scan-saved-incomplete", name=scan.name, count=made.points, missing=missing
                )
            self._bus.event("scan-rebuilt", text, "bad" if made.incomplete else "good")
        except _CloudPostponedError:
            return
        except OperationError as refusal:
            if refusal.code in ("disk-full", "not-kept"):
                self._not_before_s = time.monotonic() + RETRY_S
                return
            self._errors[scan.id] = refusal
            log.warning("no cloud for scan %s: %s", scan.id, refusal.line)
        except Exception as error:  # the station continues
            log.exception("the cloud of scan %s cannot be made", scan.id)
            self._errors[scan.id] = OperationError("failed", message("program-failed"), f"{error}")
        self._note_records()

    def _rebuild(self, scan: ScanRecord) -> Reconstruction:
        """Computes the cloud of a scan as during the scan, and however much is missing: its record
        says so."""
        recording = scan.folder / RECORDING
        found = scan_calibrations(self._store, scan)
        made = reconstruct_cloud(
            recording,
            {name: read_calibration(record.file) for name, record in found.items()},
            read_any_arm(next(iter(found.values())).file.parent / ARM),
            scan.folder / CLOUD,
            self._progress,
            allow_incomplete=True,
        )
        if scan.interrupted:  # others are listed as they were counted while they ran
            self._store.scans.complete(
                scan.id, made.points, made.all_frames, made.seconds, made.left_out
            )
        return made

    def _progress(self, share: float, text: Text) -> None:
        if self._ending.is_set() or self._is_busy():
            raise _CloudPostponedError

    # -- what is shown -------------------------------------------------------

    def scan_note(self, scan: ScanRecord) -> Text:
        """Problems of a scan's recording, why it ended early, and its gaps; usually empty."""
        note = self._recording_note(scan)
        if scan.suspended_s <= 0:
            return note
        gap = suspension_text(scan.suspended_s)
        return join([note, gap], " ") if note else gap

    def _recording_note(self, scan: ScanRecord) -> Text:
        if self._is_away(scan.folder):
            return message("archive-fetch-record", kind="scans", id=scan.folder.name)
        damage = "" if scan.sources else find_damage(scan.folder / RECORDING, scan.recording_bytes)
        if damage:
            return sentence(damage)
        error = self._errors.get(scan.id)
        if not scan.interrupted:
            if not self._is_fetched(scan):
                return sentence(scan.left_out.text) if scan.left_out.is_too_much else ""
            if error is None:
                return message("points-made-again-while-no-scan")
            return message("points-not-made-again", why=error.why or error.what)
        if (scan.folder / CLOUD).exists():
            kept = message("what-recorded-kept", interrupted=scan.interrupted)
            if scan.left_out.is_too_much:
                return join([sentence(scan.left_out.text), kept], " ")
            return kept
        if error is None:
            return message("points-made-when-there-room-no", interrupted=scan.interrupted)
        why = error.why or error.what
        return message("no-points-can-made", interrupted=scan.interrupted, why=why)

    def find_damage(self) -> list[Text]:
        """The recordings of scans, verifications and performance tests that have changed."""
        damaged: list[Text] = []
        for scan in self._store.scans.all():
            if scan.sources or self._is_away(scan.folder):  # merged clouds have no recording
                continue
            if damage := find_damage(scan.folder / RECORDING, scan.recording_bytes):
                damaged.append(join([scan.name, damage], ": "))
        for verification in self._store.verifications.all():
            damaged += self._damage_of_inputs(verification.id, verification.folder / VERIFICATION)
        for performance in self._store.performances.all():
            damaged += self._damage_of_inputs(performance.id, performance.folder / RESULT)
        return damaged

    def _damage_of_inputs(self, record_id: str, document: Path) -> Iterator[Text]:
        """The changed recordings among the inputs that a document of results names."""
        for name, sha256 in _recording_hashes(document):
            path = document.parent / name
            if (damage := find_damage(path)) and not self._matches_hash(path, sha256):
                yield join([f"{record_id}, {name}", damage], ": ")

    def _is_away(self, folder: Path) -> bool:
        """Whether the archive has a scan that is no longer on this disk."""
        return is_in_archive_only(self._store.folder, "scans", folder.name)

    def _matches_hash(self, path: Path, sha256: str) -> bool:
        """Whether an incomplete recording was accepted as such, for example after a killed
        process."""
        try:
            key = path, path.stat().st_size, sha256
            if key not in self._hashed:
                self._hashed[key] = has_sha256(path, sha256)
        except (OSError, OperationError):
            return False
        return self._hashed[key]


def _scan_record(folder: Path, metadata: dict[str, str]) -> ScanRecord:
    """The record of a scan, from the metadata of its recording and from its folder."""
    began = metadata.get(SCAN_STARTED, "")
    if not is_moment(began):
        began = moment_of_ns(folder.stat().st_mtime_ns).isoformat(timespec="seconds")
    return ScanRecord(
        id=folder.name,
        name=metadata.get(SCAN_NAME, "")[:LONGEST_NAME] or folder.name,
        folder=folder,
        started_at=began,
        points=0,
        frames=0,
        seconds=0.0,
        calibration_id=metadata.get(SCAN_CALIBRATION, "")[:LONGEST_NAME],
        interrupted=KILLED,
        recording_bytes=(folder / RECORDING).stat().st_size,
        part=part_from_metadata(metadata),
    )


def _remove_empty(folder: Path) -> None:
    """Removes the folder of a scan without recorded data, unless it contains other files."""
    (folder / RECORDING).unlink()
    if not any(folder.iterdir()):
        folder.rmdir()


def _recording_hashes(document: Path) -> list[tuple[str, str]]:
    """Names and hashes of the recordings among the inputs of a document of results."""
    try:
        with convert_io_errors(document):
            inputs = json.loads(read_text(document))["inputs"]
        return [(one["file"], one["sha256"]) for one in inputs if one["file"].endswith(RECORDING)]
    except (OperationError, ValueError, KeyError, TypeError, AttributeError):
        return []
