"""The station's scans as a library: what is opened, what is continued, and the list of all."""

import logging
import threading
from contextlib import suppress

from crenel.archive.records import is_in_archive_only
from crenel.errors import OperationError
from crenel.formats.results.scan_record import CLOUD
from crenel.guide.common.guided_session import Provenance
from crenel.loops import start_worker
from crenel.messages.message import message
from crenel.operations.library.merging import Merger
from crenel.operations.library.record_view import RecordView, as_stored_scan
from crenel.operations.library.scan_records import ScanRecords
from crenel.station.bus import Bus
from crenel.station.jobs import Jobs
from crenel.station.scan.scanner import Scanner
from crenel.station.scan.state import ScanResult
from crenel.station.view3d.scene import Scene
from crenel.station.view3d.view_controller import ViewController
from crenel.store.scans import ScanRecord
from crenel.store.store import Store
from crenel.wire.library import ContinuedRecord, LibraryState

log = logging.getLogger(__name__)
TOPIC = "library"


class ScanLibrary:
    """Every method may be called from any thread."""

    def __init__(
        self,
        bus: Bus,
        store: Store,
        scanner: Scanner,
        scene: Scene,
        view: ViewController,
        jobs: Jobs,
        provenance: Provenance,
    ) -> None:
        self._bus, self._store, self._scanner, self._view = bus, store, scanner, view
        self._lock = threading.Lock()
        self._continued: ContinuedRecord | None = None
        self._growing: dict[str, str] = {}
        """Scans that run or are saved, with the record that each continues."""
        self.records = ScanRecords(store, scanner, provenance, self.publish)
        self.merger = Merger(store, self.records, view.note_records)
        self.record_view = RecordView(
            bus, scene, view, jobs, lambda: scanner.recording() is not None, self.publish
        )
        self.publish()

    def close(self) -> None:
        self.record_view.close_loop()

    def publish(self) -> None:
        """Sends browsers the present state."""
        self._bus.publish(TOPIC, self.state())

    def state(self) -> LibraryState:
        return LibraryState(self.records.next_part, self._continued, self.record_view.opened)

    def continue_record(self, scan: ScanRecord | None) -> None:
        """Adds the next scans to this record; None: each is a record of its own again.

        Raises:
            OperationError: they would not be in its frame.
        """
        if scan is not None:
            self._check_continuable(scan)
            self.records.set_next_part(scan.part)
        self._continued = None if scan is None else _continuation(scan)
        self.publish()

    def note_begin(self, scan_id: str) -> None:
        """A scan has begun: what it continues is shown beside it."""
        if self._continued is None:
            return
        scan = self._store.scans.get(self._continued.id)
        try:
            if scan is None:
                raise OperationError("scan-gone", message("continued-scan-no-longer-there"))
            self._check_continuable(scan)
            self._view.show(as_stored_scan(scan))
        except OperationError as refusal:
            self._continued = None
            self._bus.event("refused", refusal.text, "attention")
            self.publish()
            return
        with self._lock:
            self._growing[scan_id] = scan.id

    def note_end(self, result: ScanResult) -> None:
        """A scan has ended: it is listed, and added to the record that it continues."""
        scan = self.records.add(result)
        with self._lock:
            continued = self._growing.pop(scan.id, None)
        start_worker("scan-record", self._complete, scan, continued)

    def forget(self, scan: ScanRecord) -> None:
        """A scan was deleted."""
        self.records.forget(scan)
        if self._continued is not None and self._continued.id == scan.id:
            self.continue_record(None)

    def last_scan(self) -> ScanRecord | None:
        """The last scan since the start, which the view shows when nothing is opened."""
        scan_id = self._scanner.state().scan_id
        return None if scan_id is None else self._store.scans.get(scan_id)

    def _check_continuable(self, scan: ScanRecord) -> None:
        used, wanted = self._scanner.calibration_id, self._calibration_ids(scan)
        if is_in_archive_only(self._store.folder, "scans", scan.folder.name):
            why = message("archive-fetch-record", kind="scans", id=scan.folder.name)
        elif not (scan.folder / CLOUD).is_file():
            why = message("cloud-not-in-data-folder", name=scan.name)
        elif wanted != {used}:
            why = message(
                "continued-has-other-calibration",
                own=", ".join(self._names(wanted)),
                used=", ".join(self._names({used} if used else set())) or "–",
            )
        else:
            return
        raise OperationError(
            "cannot-continue",
            message("scan-cannot-be-continued", name=scan.name),
            why,
            message("scan-alone-then-merge"),
        )

    def _calibration_ids(self, scan: ScanRecord) -> set[str]:
        """The calibrations of all scans that a record is made of."""
        found = {scan.calibration_id}
        for one in scan.sources:
            source = self._store.scans.get(one)
            if source is not None:
                found.add(source.calibration_id)
        return found

    def _names(self, calibration_ids: set[str]) -> list[str]:
        found = (self._store.calibrations.get(one) for one in calibration_ids)
        return sorted(record.name for record in found if record is not None)

    def _complete(self, scan: ScanRecord, continued_id: str | None) -> None:
        """On a worker's thread: draws a finished scan, and adds it to what it continues."""
        with suppress(OperationError):  # drawn when it is looked at
            self.records.picture(scan)
        if continued_id is not None:
            self._grow(continued_id, scan)

    def _grow(self, continued_id: str, scan: ScanRecord) -> None:
        """Merges a finished scan with the record that it continues."""
        continued = self._store.scans.get(continued_id)
        if continued is None or not scan.points:
            return
        try:
            into = continued if continued.sources else None
            merged = self.merger.merge([continued, scan], into=into)
        except OperationError as refusal:
            self._bus.event("refused", refusal.text, "bad")
            return
        if self._continued is not None and self._continued.id == continued_id:
            self._continued = _continuation(merged)
        count = len(merged.sources)
        self._bus.event(
            "scans-merged",
            message("scan-added-to-record", name=merged.name, count=count, points=merged.points),
            "good",
        )
        self.publish()


def _continuation(scan: ScanRecord) -> ContinuedRecord:
    return ContinuedRecord(scan.id, scan.name, max(len(scan.sources), 1))
