"""The datasheets of the station: listed, evaluated, added, retired and brought back."""

import hashlib
from collections.abc import Callable, Iterator
from pathlib import Path

from crenel.errors import OperationError
from crenel.formats.atomic_write import write_atomically
from crenel.formats.file_names import display_path, escape_unprintable
from crenel.guide.common.datasheet_library import (
    DatasheetLibrary,
    FolderContent,
    list_files,
    read_library,
)
from crenel.messages.message import join, message
from crenel.operations.datasheets.documents import (
    FOLDERS,
    DatasheetIdentity,
    DatasheetKind,
    identify,
    is_certificate,
    list_problems,
)
from crenel.operations.datasheets.files import (
    RETIRED,
    WRITING,
    free_path,
    move_file,
    put_in_place,
    retire_file,
    split_ending,
)
from crenel.operations.datasheets.last_uses import read_uses
from crenel.operations.datasheets.listed import DatasheetRows, Entry, read_entry
from crenel.operations.datasheets.ranges import list_ranges
from crenel.operations.datasheets.view import (
    ConnectedArmView,
    DatasheetCheck,
    DatasheetRow,
    DatasheetsView,
    JointsView,
)
from crenel.station.devices.rig import Rig
from crenel.store.store import Store


class Datasheets:
    """The datasheets of one station. Methods may be called from any thread.

    Args:
        note: called after each change; ``note_change`` after one by others.
    """

    def __init__(self, store: Store, rig: Rig, note: Callable[[], None]) -> None:
        self._store, self._rig, self.note_change = store, rig, note
        self._rows = DatasheetRows(store, rig)
        self._library = FolderContent(read_library, store.folder)

    def library(self) -> DatasheetLibrary:
        """What can be chosen for a calibration, as it was at most ``FRESH_S`` ago."""
        return self._library.latest(choosing=True)

    def view(self) -> DatasheetsView:
        """All that are there, those in use before the retired ones, by their names."""
        uses = read_uses(self._store)
        rows = [
            self._rows.row(kind, entry, retired, uses, [] if retired else entries)
            for kind in FOLDERS
            for retired in (False, True)
            for entries in [list(self._entries(kind, retired))]
            for entry in entries
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
        return DatasheetCheck(found.form, (), self._rows.unlikely(found))

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
                return self._rows.row(found.kind, kept, False)
            others = [one for one in same if one not in old]
            if others and not replace:
                raise _exists_error(path, found, others)
            words = split_ending(path.name)[0] if name else f"{found.name} {found.serial_number}"
            ending = ".xml" if is_certificate(path, text) else ".json"
            written = self._put(found.kind, words, ending, content, [*old, *others])
        self.note_change()
        return self._rows.row(found.kind, read_entry(written, found.kind), False)

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

    def path(
        self, kind: DatasheetKind, file: str, retired: bool, version: str | None = None
    ) -> Path:
        """The file; raises ``OperationError`` where there is none of this name and version."""
        return self._find(kind, file, retired, version).path

    def _put(
        self, kind: DatasheetKind, words: str, ending: str, content: bytes, replaced: list[Entry]
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

    def _entries(self, kind: DatasheetKind, retired: bool) -> Iterator[Entry]:
        folder = self._folder(kind, retired)
        endings = (".json", ".xml") if kind == "gauge" else (".json",)
        paths = [path for ending in endings for path in list_files(folder, ending, [])]
        return (read_entry(path, kind) for path in sorted(paths))

    def _find(
        self, kind: DatasheetKind, file: str, retired: bool, version: str | None = None
    ) -> Entry:
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


def _path_of(name: str) -> Path:
    """The file as errors name it; a form has none."""
    return Path(name or "datasheet.json")


def _exists_error(path: Path, found: DatasheetIdentity, same: list[Entry]) -> OperationError:
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
