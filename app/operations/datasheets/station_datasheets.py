"""The datasheets of the station: listed, evaluated, added, retired and brought back."""

import hashlib
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

from app.errors import OperationError
from app.formats.atomic_write import write_atomically
from app.formats.file_names import check_name, display_path, escape_unprintable
from app.formats.io_errors import convert_io_errors
from app.formats.json_document import decode_text
from app.formats.open_file import read_bounded
from app.guide.common.datasheet_library import (
    DatasheetLibrary,
    FolderContent,
    list_files,
    read_library,
)
from app.messages.message import Text, join, message
from app.operations.datasheets.documents import (
    FOLDERS,
    DatasheetIdentity,
    DatasheetKind,
    evaluate,
    identify,
    is_certificate,
    list_problems,
)
from app.operations.datasheets.files import (
    RETIRED,
    WRITING,
    free_path,
    move_file,
    put_in_place,
    retire_file,
    split_ending,
)
from app.operations.datasheets.last_uses import Uses, read_uses
from app.operations.datasheets.ranges import list_ranges
from app.operations.datasheets.view import (
    ConnectedArmView,
    DatasheetCheck,
    DatasheetRow,
    DatasheetsView,
    JointsView,
)
from app.station.devices.rig import Rig
from app.store.store import Store
from app.timestamps import moment_of_ns


@dataclass(frozen=True)
class _Entry:
    """A file that is there."""

    path: Path
    version: str
    since_ns: int
    found: DatasheetIdentity | None
    problem: Text


class Datasheets:
    """The datasheets of one station. Methods may be called from any thread.

    Args:
        note: called after each change; ``note_change`` after one by others.
    """

    def __init__(self, store: Store, rig: Rig, note: Callable[[], None]) -> None:
        self._store, self._rig, self.note_change = store, rig, note
        self._library = FolderContent(read_library, store.folder)

    def library(self) -> DatasheetLibrary:
        """What can be chosen for a calibration, as it was at most ``FRESH_S`` ago."""
        return self._library.latest(choosing=True)

    def view(self) -> DatasheetsView:
        """All that are there, those in use before the retired ones, by their names."""
        uses = read_uses(self._store)
        rows = [
            self._row(kind, entry, retired, uses)
            for kind in FOLDERS
            for retired in (False, True)
            for entry in self._entries(kind, retired)
        ]
        info = self._rig.arm.info
        arm = (
            None
            if info is None
            else ConnectedArmView(info.name, info.serial_number, info.joint_count)
        )
        return DatasheetsView(tuple(rows), arm, list_ranges())

    def joints(self) -> JointsView:
        """How the connected arm stands."""
        return JointsView(self._rig.arm.joints_deg())

    def check(self, name: str, text: str) -> DatasheetCheck:
        """Evaluates a document without keeping it."""
        try:
            found = identify(text, _path_of(name))
        except OperationError as error:
            return DatasheetCheck(None, list_problems(error), "")
        return DatasheetCheck(found.form, (), self._unlikely(found))

    def add(self, name: str, text: str, replace: bool = False, edited: str = "") -> DatasheetRow:
        """Keeps a document that can be evaluated; one of the same thing is retired.

        Args:
            name: of its file, as the person has it; may be empty.
            replace: the person agrees that another of the same thing is retired.
            edited: version of the datasheet of which this is an edited copy, which is retired.

        Raises:
            OperationError: it cannot be evaluated; the thing has a datasheet (``datasheet-exists``)
                and ``replace`` is not said; the edited one has been changed meanwhile
                (``datasheet-changed``); or it cannot be written. Everything is then as before.
        """
        path = _path_of(name)
        found = identify(text, path)
        content = text.encode()
        with WRITING:
            present = list(self._entries(found.kind, False))
            old = [one for one in present if edited and one.version == edited]
            if edited and not old:
                raise _conflict_error(path)
            same = [one for one in present if one.found and one.found.is_same_thing(found)]
            version = hashlib.sha256(content).hexdigest()
            kept = next((one for one in present if one.version == version), None)
            if kept is not None:
                return self._row(found.kind, kept, False)
            others = [one for one in same if one not in old]
            if others and not replace:
                raise _exists_error(path, found, others)
            words = split_ending(path.name)[0] if name else f"{found.name} {found.serial_number}"
            ending = ".xml" if is_certificate(path, text) else ".json"
            written = self._put(found.kind, words, ending, content, [*old, *others])
        self.note_change()
        return self._row(found.kind, _read_entry(written, found.kind), False)

    def retire(self, kind: DatasheetKind, file: str, version: str) -> None:
        """Takes a datasheet out of use; it is kept.

        Raises:
            OperationError: there is none of this name (``no-datasheet``), it has been changed
                meanwhile (``datasheet-changed``), or it cannot be moved.
        """
        with WRITING:
            retire_file(self._find(kind, file, False, version).path)
        self.note_change()

    def restore(self, kind: DatasheetKind, file: str, version: str, replace: bool = False) -> None:
        """Brings a retired datasheet back into use.

        Raises:
            OperationError: as ``retire`` and ``add``.
        """
        with WRITING:
            entry = self._find(kind, file, True, version)
            if entry.found is None:
                raise OperationError(
                    "datasheet-unreadable", display_path(entry.path), entry.problem
                )
            found = entry.found
            present = self._entries(kind, False)
            same = [one for one in present if one.found and one.found.is_same_thing(found)]
            if same and not replace:
                raise _exists_error(entry.path, found, same)
            for one in same:
                retire_file(one.path)
            stem, ending = split_ending(entry.path.name)
            move_file(entry.path, free_path(self._folder(kind, False), stem, ending))
        self.note_change()

    def path(self, kind: DatasheetKind, file: str, retired: bool) -> Path:
        """The file; raises ``OperationError`` where there is none of this name."""
        return self._find(kind, file, retired).path

    def _put(
        self, kind: DatasheetKind, words: str, ending: str, content: bytes, replaced: list[_Entry]
    ) -> Path:
        """Writes a new version under the name of the one that it replaces, if its kind of file is
        the same; those that it replaces are retired."""
        written = next((one.path for one in replaced if one.path.suffix == ending), None)
        if written is not None:
            put_in_place(written, content)
        else:
            written = free_path(self._folder(kind, False), words, ending)
            write_atomically(written, content)
        for one in replaced:
            if one.path != written:
                retire_file(one.path)
        return written

    def _folder(self, kind: DatasheetKind, retired: bool) -> Path:
        folder = self._store.folder / FOLDERS[kind]
        return folder / RETIRED if retired else folder

    def _entries(self, kind: DatasheetKind, retired: bool) -> Iterator[_Entry]:
        folder = self._folder(kind, retired)
        endings = (".json", ".xml") if kind == "gauge" else (".json",)
        paths = [path for ending in endings for path in list_files(folder, ending, [])]
        return (_read_entry(path, kind) for path in sorted(paths))

    def _find(
        self, kind: DatasheetKind, file: str, retired: bool, version: str | None = None
    ) -> _Entry:
        """The file of this name, which is never used as a path."""
        folder = self._folder(kind, retired)
        entry = next(
            (
                one
                for one in self._entries(kind, retired)
                if escape_unprintable(one.path.name) == file
            ),
            None,
        )
        if entry is None:
            what = message("datasheet-not-there", file=display_path(folder / file))
            raise OperationError("no-datasheet", what, remedy=message("load-the-list-again"))
        if version is not None and entry.version != version:
            raise _conflict_error(entry.path)
        return entry

    def _row(
        self, kind: DatasheetKind, entry: _Entry, retired: bool, uses: Uses | None = None
    ) -> DatasheetRow:
        found, uses = entry.found, uses or read_uses(self._store)
        return DatasheetRow(
            kind=kind,
            file=escape_unprintable(entry.path.name),
            version=entry.version,
            retired=retired,
            form=found.form if found else None,
            problem=entry.problem,
            name=found.name if found else "",
            serial_number=found.serial_number if found else "",
            certificate=found.certificate if found else "",
            valid_until=found.valid_until if found else "",
            since=moment_of_ns(entry.since_ns).isoformat(timespec="seconds"),
            last_use=uses.last(found),
            in_use=() if retired else tuple(uses.calibrations(found, entry.version)),
            connected=not retired and found is not None and self._is_connected(found),
            note=""
            if retired or found is None
            else self._unlikely(found) or uses.note(found, entry.version),
        )

    def _is_connected(self, found: DatasheetIdentity) -> bool:
        devices = {"arm": self._rig.arm.info, "sensor": self._rig.sensor.info}
        info = devices.get(found.kind)
        return info is not None and found.serial_number == info.serial_number != ""

    def _unlikely(self, found: DatasheetIdentity) -> Text:
        """That the model of the connected arm has fewer or more rows than it has joints."""
        info = self._rig.arm.info
        if info is None or found.form != "arm" or info.joint_count in (0, found.joint_count):
            return ""
        if len({info.serial_number, found.serial_number} - {""}) > 1:
            return ""  # it is of another unit
        return message("arm-has-other-joints", joints=info.joint_count, rows=found.joint_count)


def _path_of(name: str) -> Path:
    """The file as errors name it; a form has none."""
    return Path(name or "datasheet.json")


def _read_entry(path: Path, kind: DatasheetKind) -> _Entry:
    """A file that is there, or why it cannot be read."""
    version, since_ns = "", 0
    try:
        with convert_io_errors(path):
            since_ns = path.stat().st_mtime_ns
            content = read_bounded(path)
        version = hashlib.sha256(content).hexdigest()
        check_name(path)
        found = evaluate(decode_text(content, path), path, kind)
    except OperationError as error:
        return _Entry(path, version, since_ns, None, error.text)
    return _Entry(path, version, since_ns, found, "")


def _exists_error(path: Path, found: DatasheetIdentity, same: list[_Entry]) -> OperationError:
    known = join([display_path(one.path) for one in same])
    number, name = found.serial_number, found.name
    what = (
        message("datasheet-of-number-exists", serial_number=number, name=name, files=known)
        if number
        else message("datasheet-of-name-exists", name=name, files=known)
    )
    return OperationError("datasheet-exists", what, remedy=message("replace-the-datasheet"))


def _conflict_error(path: Path) -> OperationError:
    what = message("datasheet-changed-meanwhile", file=display_path(path))
    return OperationError("datasheet-changed", what, remedy=message("load-the-list-again"))
