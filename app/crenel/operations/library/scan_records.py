"""What is known of scans beside their clouds: part and order, the file that says so, a picture."""

import logging
import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import ClassVar

from crenel.errors import OperationError
from crenel.formats.atomic_write import ensure_folder, write_atomically
from crenel.formats.clouds.cuts import FILE as CUTS
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.json_document import SOFTWARE, Document
from crenel.formats.results.scan_record import (
    CLOUD,
    NO_PART,
    SCAN,
    MergedScan,
    PartNames,
    ScanFile,
    read_scan_file,
)
from crenel.guide.common.guided_session import Provenance
from crenel.station.scan.scanner import Scanner
from crenel.station.scan.state import ScanResult
from crenel.store.scans import ScanRecord
from crenel.store.store import Store
from crenel.workflows.clouds.cloud_picture import LARGE_PX, SMALL_PX, cloud_picture

log = logging.getLogger(__name__)
NEXT_PART, PICTURES = "next-part.json", "pictures"
"""In the data folder. Pictures are not in the folders of their scans, which the archive copies and
takes from the disk."""


class NextPart(Document):
    """The part that is scanned next, over restarts."""

    FORMAT: ClassVar[str] = "crenel/next-part"

    part: PartNames


class ScanRecords:
    """Every method may be called from any thread.

    Args:
        changed: called when the next part is another.
    """

    def __init__(
        self, store: Store, scanner: Scanner, provenance: Provenance, changed: Callable[[], None]
    ) -> None:
        self._store, self._scanner, self._provenance = store, scanner, provenance
        self._changed = changed
        self._next = _read_next(store.folder / NEXT_PART)
        scanner.set_part(self._next)

    @property
    def next_part(self) -> PartNames:
        """The part of the scan that runs, or of the next one."""
        return self._next

    def set_next_part(self, part: PartNames) -> None:
        """Names the part of the next scans, and of one that runs."""
        NextPart(part=part).write(self._store.folder / NEXT_PART)
        self._next = part
        self._scanner.set_part(part)
        self._changed()

    def add(self, result: ScanResult) -> ScanRecord:
        """Lists a scan that has ended, and writes its file."""
        scan = ScanRecord(
            id=result.id,
            name=result.name,
            folder=result.folder,
            started_at=result.started_at,
            points=result.points,
            frames=result.frames,
            seconds=result.seconds,
            calibration_id=result.calibration_id,
            interrupted=result.interrupted,
            recording_bytes=result.recording_bytes,
            suspended_s=result.suspended_s,
            left_out=result.left_out,
            part=result.part,
            frames_too_fast=result.frames_too_fast,
            frames_lost=result.lost_frames,
        )
        self._store.scans.add(scan)
        try:
            self.write_file(scan)
        except OperationError as error:  # listed all the same, and written with its report
            log.warning("%s of scan %s: %s", SCAN, scan.id, error.line)
        return scan

    def rename(self, scan: ScanRecord, name: str) -> None:
        """Gives a scan another name."""
        self._store.scans.rename(scan.id, name)
        self._write_again(replace(scan, name=name))

    def name_part(self, scan: ScanRecord, part: PartNames) -> None:
        """Names the part of a scan."""
        self._store.scans.set_part(scan.id, part)
        self._write_again(replace(scan, part=part))

    def write_file(self, scan: ScanRecord, sources: tuple[MergedScan, ...] = ()) -> ScanFile:
        """Writes ``scan.json`` of a scan; what only an earlier one states is kept.

        Raises:
            OperationError: the folder cannot be written.
        """
        try:
            known = read_scan_file(scan.folder)
        except OperationError:  # damaged: the list has the rest
            known = None
        provenance = self._provenance
        written = ScanFile(
            name=scan.name,
            started_at=scan.started_at,
            part=scan.part,
            points=scan.points,
            frames=scan.frames,
            seconds=scan.seconds,
            frames_without_points=scan.left_out.frames,
            frames_with_line=scan.left_out.of,
            frames_too_fast=scan.frames_too_fast,
            frames_lost=scan.frames_lost,
            note=scan.interrupted,
            calibration_id=scan.calibration_id,
            sources=sources or (known.sources if known else ()),
            operator=known.operator if known else provenance.operator(),
            station=known.station if known else provenance.station,
            simulated=known.simulated if known else provenance.is_simulated(),
            software=SOFTWARE,
        )
        record = self._store.calibrations.get(scan.calibration_id)
        if record is not None:
            figures = record.figures
            stated = {
                "calibration": record.name,
                "calibration_um": figures.total_um,
                "arm_serial": figures.arm_serial,
                "sensor_serial": figures.sensor_serial,
            }
            written = written.model_copy(update=stated)
        if written != known:
            written.write(scan.folder / SCAN)
        return written

    def picture(self, scan: ScanRecord, large: bool = False) -> Path:
        """A picture of a scan, drawn where it is missing or older than cloud or cuts.

        Raises:
            OperationError: the cloud is not there or cannot be read.
        """
        path = self._picture_path(scan, large)
        changed_ns = cloud_changed_ns(scan)
        if path.is_file() and path.stat().st_mtime_ns >= changed_ns:
            return path
        drawn = cloud_picture(scan.folder / CLOUD, LARGE_PX if large else SMALL_PX)
        with convert_io_errors(path):
            ensure_folder(path.parent)
            write_atomically(path, drawn)
            os.utime(path, ns=(changed_ns, changed_ns))  # cut meanwhile, it is drawn again
        return path

    def forget(self, scan: ScanRecord) -> None:
        """A scan was deleted, and its pictures with it."""
        with convert_io_errors(self._store.folder):
            for large in (False, True):
                self._picture_path(scan, large).unlink(missing_ok=True)

    def _picture_path(self, scan: ScanRecord, large: bool) -> Path:
        ending = "-large.png" if large else ".png"
        return self._store.folder / PICTURES / f"{scan.folder.name}{ending}"

    def _write_again(self, scan: ScanRecord) -> None:
        """The file of a scan of which the archive alone has the folder stays as it is."""
        if scan.folder.is_dir():
            self.write_file(scan)


def _read_next(path: Path) -> PartNames:
    """Not stated, where the file is missing or cannot be read."""
    try:
        return NextPart.read(path).part if path.exists() else NO_PART
    except OperationError as error:
        log.warning("%s", error.line)
        return NO_PART


def cloud_changed_ns(scan: ScanRecord) -> int:
    """When the cloud or what is cut away of it last changed; 0 where neither is there."""
    parts = (scan.folder / CLOUD, scan.folder / CUTS)
    return max((part.stat().st_mtime_ns for part in parts if part.is_file()), default=0)
