"""``crenel verify`` and ``crenel study`` over archives: the clouds of verifications, each rebuilt
with the calibration that was verified, with a given one, or with all of the station."""

import errno
import hashlib
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Literal

from crenel.archive.archive_settings import ArchiveSettings
from crenel.archive.remote_store import RemoteStore, read_document
from crenel.archive.store_errors import is_of_whole_place
from crenel.batch.calibrations import ARM, CALIBRATION, CalibrationFiles, read_files
from crenel.batch.patience import Patience
from crenel.batch.places import Dependency, Place, PlaceRecord
from crenel.batch.recordings import Selection, find_records
from crenel.batch.results import ResultStore, stem_of
from crenel.batch.task import Desk, Refusal
from crenel.errors import OperationError
from crenel.formats import csv_table
from crenel.formats.file_names import display_path
from crenel.formats.io_errors import error_from_os
from crenel.formats.json_document import SOFTWARE
from crenel.gauges.plan.document_gauge import Shape
from crenel.gauges.quick.document import VERIFICATION, VerificationFile, read_verification
from crenel.gauges.quick.evaluate_study import FIGURES, AcceptedCalibration, study_verification
from crenel.messages.uncertainty import uncertainty_decimals
from crenel.progress import Progress, no_progress
from crenel.timestamps import is_moment, parse_moment

RECORD = "record"
CLOUD_SUFFIX = ".ply"
COLUMNS = (
    *("station", "verification", "taken_at", "cloud", "calibration"),
    *(column for name in FIGURES for column in (name, f"U_{name}")),
)
"""Beside each figure its expanded uncertainty (k = 2)."""
With = Literal["own", "all"]
"""Which calibrations: that which was verified, or all of the station."""


@dataclass(frozen=True)
class VerificationTask:
    """One verification, each of its clouds rebuilt with each of some calibrations."""

    key: str
    record: PlaceRecord
    taken_at: str
    sources: tuple[CalibrationFiles, ...]
    output: ArchiveSettings

    @property
    def name(self) -> str:
        return f"{self.record.place.station}/{self.record.id}"

    @property
    def size_bytes(self) -> int:
        return sum(file.bytes for file in self.record.files.values()) * len(self.sources)

    @property
    def stem(self) -> str:
        """The name of the result without its suffix."""
        return stem_of(self.record.place.station, self.record.id, self.key)

    @property
    def depends_on(self) -> Sequence[Dependency]:
        return (self.record.place.dependency, Dependency(self.output))

    def perform(self, desk: Desk) -> Mapping[str, Any]:
        results = ResultStore(self.output)
        if (known := results.read(self.stem)) is not None:
            return known
        # copied from a folder, too: a place that is lost midway must not look like a calibration
        # that does not fit
        desk.name_copy(desk.folder / RECORD, self.record.full_name)
        for path, file in self.record.files.items():
            if not path.endswith(CLOUD_SUFFIX):
                desk.copy(file, f"{RECORD}/{path}")
        accepted = []
        for number, files in enumerate(self.sources):
            folder = desk.folder / f"calibration-{number}"
            folder.mkdir()
            files.write(folder)
            accepted.append(AcceptedCalibration(files.id, files.id, folder))
        return results.write(self.stem, study_verification(desk.folder / RECORD, accepted))


def plan_verifications(
    places: Sequence[Place],
    selection: Selection,
    output: ArchiveSettings,
    rebuilt_with: With | tuple[CalibrationFiles, ...],
    shape: Shape | None = None,
    progress: Progress = no_progress,
    patience: Patience | None = None,
) -> tuple[list[VerificationTask], list[tuple[str, Refusal]]]:
    """The chosen verifications, and those that cannot be read.

    Args:
        shape: of the gauge; None: any.
        patience: with which it is waited for stores that cannot be reached.

    Raises:
        OperationError: a place cannot be read.
    """
    tasks: list[VerificationTask] = []
    refused: list[tuple[str, Refusal]] = []
    for place in selection.places(places):
        every: list[CalibrationFiles] | None = None
        for record, store in find_records(place, "verifications", progress, patience):
            try:
                found = _read_if_chosen(record, store, selection, shape)
                if found is None:
                    continue
                known, own = found
                if rebuilt_with == "all" and every is None:
                    every, unreadable = _calibrations_of(place, store)
                    refused += unreadable
                sources = _sources(rebuilt_with, own, every or [])
                key = _key_of(record, sources)
            except OperationError as error:
                if is_of_whole_place(error):
                    raise
                refused.append((f"{place.station}/{record.id}", Refusal.of(error)))
                continue
            taken_at = known.clouds[0].taken_at
            tasks.append(VerificationTask(key, record, taken_at, sources, output))
    return tasks, refused


def _sources(
    rebuilt_with: With | tuple[CalibrationFiles, ...],
    own: CalibrationFiles,
    every: Sequence[CalibrationFiles],
) -> tuple[CalibrationFiles, ...]:
    if rebuilt_with == "own":
        return (own,)
    return (tuple(every) or (own,)) if rebuilt_with == "all" else rebuilt_with


def _read_if_chosen(
    record: PlaceRecord, store: RemoteStore, selection: Selection, shape: Shape | None
) -> tuple[VerificationFile, CalibrationFiles] | None:
    """An accepted verification with the calibration that it verified."""
    if VERIFICATION not in record.files:
        return None
    known = _read_verification(record, store)
    taken_at = known.clouds[0].taken_at if known.clouds else ""
    chosen = (
        is_moment(taken_at)
        and selection.period.contains(parse_moment(taken_at))
        and shape in (None, known.gauge.shape)
        and (not selection.taken_with or known.calibration.id in selection.taken_with)
    )
    if not chosen:
        return None
    for name in (CALIBRATION, ARM):
        if name not in record.files:
            missing = FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT))
            raise error_from_os(missing, f"{record.full_name}/{name}")
    calibration, arm = (
        read_document(store, record.files[name].name) for name in (CALIBRATION, ARM)
    )
    return known, CalibrationFiles(known.calibration.id, calibration, arm)


def _read_verification(record: PlaceRecord, store: RemoteStore) -> VerificationFile:
    content = read_document(store, record.files[VERIFICATION].name)
    with TemporaryDirectory(prefix="crenel-") as folder:
        (Path(folder) / VERIFICATION).write_bytes(content)
        try:
            return read_verification(Path(folder))
        except OperationError as error:
            names = {display_path(folder): record.full_name}
            raise Refusal.of(error).naming(names).error() from error


def list_shapes(places: Sequence[Place], patience: Patience | None = None) -> Iterator[Shape]:
    """The gauge's shape of each accepted verification that can be read.

    Raises:
        OperationError: a place cannot be read.
    """
    for place in places:
        for record, store in find_records(place, "verifications", patience=patience):
            if VERIFICATION not in record.files:
                continue
            try:
                yield _read_verification(record, store).gauge.shape
            except OperationError as error:
                if is_of_whole_place(error):
                    raise


def _calibrations_of(
    place: Place, store: RemoteStore
) -> tuple[list[CalibrationFiles], list[tuple[str, Refusal]]]:
    """All calibrations of a station, and those that cannot be read; those of other devices are left
    out by the study itself."""
    found: list[CalibrationFiles] = []
    refused: list[tuple[str, Refusal]] = []
    for one in place.ids("sessions", store):
        try:
            files = read_files(place, one, store)
            if files is not None:
                with TemporaryDirectory(prefix="crenel-") as folder:
                    files.read(Path(folder))
                found.append(files)
        except OperationError as error:
            if is_of_whole_place(error):
                raise
            refused.append((f"{place.station}/{one}", Refusal.of(error)))
    return found, refused


def _key_of(record: PlaceRecord, sources: Iterable[CalibrationFiles]) -> str:
    files = [
        f"{file.digest()} {path}"
        for path, file in sorted(record.files.items())
        if not path.endswith(CLOUD_SUFFIX)
    ]
    used = [f"{one.id} {one.digest}" for one in sources]
    lines = ["verification", SOFTWARE.version, *files, *used]
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()


def table_of(results: Iterable[tuple[VerificationTask, Mapping[str, Any]]]) -> list[list[str]]:
    """One row for each cloud and calibration; cells of figures that there are not are empty.

    Args:
        results: the fields of ``crenel/study`` documents.
    """
    rows = []
    for task, study in results:
        for row in study["rows"]:
            uncertainty = row.get("expanded_uncertainty", {})
            rows.append(
                [
                    task.record.place.station,
                    task.record.id,
                    task.taken_at,
                    study["clouds"][row["cloud"]],
                    study["calibration_ids"][row["calibration"]],
                    *(
                        cell
                        for name in FIGURES
                        for cell in _figure_cells(row.get(name), uncertainty.get(name))
                    ),
                ]
            )
    return sorted(rows)


def _figure_cells(value: float | None, uncertainty: float | None) -> tuple[str, str]:
    if value is None or uncertainty is None:
        return ("" if value is None else f"{value:.3f}", "")
    return f"{value:.3f}", f"{uncertainty:.{uncertainty_decimals(uncertainty)}f}"


def table_with_uncertainties(rows: Sequence[Sequence[str]]) -> tuple[list[str], list[list[str]]]:
    """Headings and rows for printing: figures that a row has, each with its uncertainty."""
    first = len(COLUMNS) - 2 * len(FIGURES)
    known = [i for i in range(first, len(COLUMNS), 2) if any(row[i] for row in rows)]
    headings = [*COLUMNS[:first], *(COLUMNS[i] for i in known)]
    return headings, [
        [*row[:first], *(" ± ".join(filter(None, row[i : i + 2])) for i in known)] for row in rows
    ]


def table_text(rows: Iterable[Sequence[str]]) -> str:
    """The table as CSV, with its header."""
    return csv_table.table_text(COLUMNS, rows)
