"""Merges scans into one cloud: chosen ones, or those that continue an earlier one."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from datetime import UTC, datetime

from crenel.archive.records import is_in_archive_only
from crenel.errors import OperationError
from crenel.formats.recording.completeness import MissingFrames
from crenel.formats.results.scan_record import CLOUD, MergedScan, read_scan_file
from crenel.messages.message import Message, Text, message
from crenel.operations.library.scan_records import ScanRecords
from crenel.progress import Progress, no_progress
from crenel.station.scan.storage import ScanFolders
from crenel.store.scans import ScanRecord
from crenel.store.store import Store
from crenel.workflows.clouds.merge_clouds import MergedPart, merge_clouds

FEWEST, MOST = 2, 50


class Merger:
    """Merges what lies in the frame of one arm; the scans themselves stay as they are.

    Args:
        changed: called when the list of scans is another.
    """

    def __init__(self, store: Store, records: ScanRecords, changed: Callable[[], None]) -> None:
        self._store, self._records, self._changed = store, records, changed
        self._folders = ScanFolders(store.folder / "scans")

    def check(self, scans: Sequence[ScanRecord]) -> None:
        """Raises ``OperationError`` where scans cannot become one cloud, with the reason."""
        if not FEWEST <= len({scan.id for scan in scans}) <= MOST:
            why = message("merge-takes-some", fewest=FEWEST, most=MOST)
            raise _refusal(why, message("choose-other-scans"))
        arms = {self._arm_of(scan) for scan in scans}
        if len(arms) > 1:
            listed = ", ".join(sorted(arms))
            raise _refusal(
                message("scans-of-several-arms", arms=listed), message("compare-no-arms")
            )
        for scan in scans:
            if is_in_archive_only(self._store.folder, "scans", scan.folder.name):
                why = message("archive-fetch-record", kind="scans", id=scan.folder.name)
                raise _refusal(why, message("fetch-it-first"))
            if not (scan.folder / CLOUD).is_file():
                why = message("cloud-not-in-data-folder", name=scan.name)
                raise _refusal(why, message("rebuild-recording-crenel-reconstruct"))
        ids = [one for scan in scans for one in (scan.sources or (scan.id,))]
        if len(set(ids)) < len(ids):
            raise _refusal(message("scan-would-be-twice"), message("choose-other-scans"))

    def merge(
        self,
        scans: Sequence[ScanRecord],
        name: Text = "",
        into: ScanRecord | None = None,
        progress: Progress = no_progress,
    ) -> ScanRecord:
        """Makes one cloud of scans, and lists it.

        Args:
            name: of the new record; by default, by the first of the scans.
            into: one of the scans that is itself merged, which then has the points of all.

        Raises:
            OperationError: as ``check``, a cloud cannot be read, or the disk is full.
        """
        self.check(scans)
        refusal = self._folders.start_space_error()
        if refusal is not None:
            raise refusal
        now = datetime.now(UTC)
        folder = into.folder if into is not None else self._folders.new(now)
        parts = merge_clouds(
            [(scan.folder / CLOUD, scan.frames) for scan in scans], folder / CLOUD, progress
        )
        sources = tuple(
            source
            for scan, part in zip(scans, parts, strict=True)
            for source in _sources(scan, part)
        )
        first = scans[0]
        merged = ScanRecord(
            id=folder.name,
            name=name or message("merged-scan", name=first.name),
            folder=folder,
            started_at=now.isoformat(timespec="seconds"),
            points=sum(part.points for part in parts),
            frames=sum(scan.frames for scan in scans),
            seconds=sum(scan.seconds for scan in scans),
            calibration_id=first.calibration_id,
            suspended_s=sum(scan.suspended_s for scan in scans),
            left_out=MissingFrames(
                sum(scan.left_out.frames for scan in scans),
                sum(scan.left_out.of for scan in scans),
            ),
            part=first.part,
            frames_too_fast=_total([scan.frames_too_fast for scan in scans]),
            frames_lost=_total([scan.frames_lost for scan in scans]),
            sources=tuple(source.id for source in sources),
        )
        if into is not None:
            merged = replace(merged, name=into.name, started_at=into.started_at, part=into.part)
            self._store.scans.note_merged(merged)
        else:
            self._store.scans.add(merged)
        self._records.write_file(merged, sources)
        self._changed()
        return merged

    def _arm_of(self, scan: ScanRecord) -> str:
        """The serial number of its arm, in whose frame its points are.

        Raises:
            OperationError: its calibration is not known here.
        """
        record = self._store.calibrations.get(scan.calibration_id)
        if record is None:
            why = message("calibration-no-longer-here", name=scan.name)
            raise _refusal(why, message("choose-other-scans"))
        return record.figures.arm_serial


def _sources(scan: ScanRecord, part: MergedPart) -> tuple[MergedScan, ...]:
    """The scans that a cloud is made of, as they are in the merged one."""
    known = read_scan_file(scan.folder) if scan.sources else None
    if known is not None and known.sources:
        return tuple(
            one.model_copy(update={"frame": one.frame + part.first_frame}) for one in known.sources
        )
    source = MergedScan(
        id=scan.id,
        name=scan.name,
        calibration_id=scan.calibration_id,
        points=part.points,
        frame=part.first_frame,
    )
    return (source,)


def _total(counts: Sequence[int | None]) -> int | None:
    """None where one is not known."""
    known = [count for count in counts if count is not None]
    return sum(known) if len(known) == len(counts) else None


def _refusal(why: Text, remedy: Message) -> OperationError:
    return OperationError("cannot-merge", message("scans-cannot-be-merged"), why, remedy)
