"""One file among the datasheets: read, and as the page lists it."""

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from crenel.errors import OperationError
from crenel.formats.file_names import check_name, display_path, escape_unprintable
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.json_document import decode_text
from crenel.formats.open_file import read_bounded
from crenel.messages.message import Text, join, message
from crenel.operations.datasheets.documents import DatasheetIdentity, DatasheetKind, evaluate
from crenel.operations.datasheets.last_uses import Uses, content_version, read_uses
from crenel.operations.datasheets.view import DatasheetRow
from crenel.station.devices.rig import Rig
from crenel.store.store import Store
from crenel.timestamps import moment_of_ns, utc_now


@dataclass(frozen=True)
class Entry:
    """A file that is there."""

    path: Path
    version: str
    """The version of the file's bytes."""
    content: str
    """The version of what it says, as copies of it say it; empty for a certificate, of which copies
    differ."""
    since_ns: int
    found: DatasheetIdentity | None
    problem: Text


def read_entry(path: Path, kind: DatasheetKind) -> Entry:
    """A file that is there, or why it cannot be read."""
    version, said, since_ns = "", "", 0
    try:
        with convert_io_errors(path):
            since_ns = path.stat().st_mtime_ns
            content = read_bounded(path)
        version = hashlib.sha256(content).hexdigest()
        said = content_version(content, kind) if path.suffix == ".json" else ""
        check_name(path)
        found = evaluate(decode_text(content, path), path, kind)
    except OperationError as error:
        return Entry(path, version, said, since_ns, None, error.text)
    return Entry(path, version, said, since_ns, found, "")


class DatasheetRows:
    """What is said of a file beside what it says: of the connected devices, and of records."""

    def __init__(self, store: Store, rig: Rig) -> None:
        self._store, self._rig = store, rig

    def row(
        self,
        kind: DatasheetKind,
        entry: Entry,
        retired: bool,
        uses: Uses | None = None,
        present: Sequence[Entry] = (),
    ) -> DatasheetRow:
        """A file as the page shows it.

        Args:
            uses: of all things; read if they are not given.
            present: all files of its kind that are in use.
        """
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
            issued_on=found.issued_on if found else "",
            valid_until=found.valid_until if found else "",
            since=moment_of_ns(entry.since_ns).isoformat(timespec="seconds"),
            last_use=uses.last(found),
            in_use=() if retired else tuple(uses.calibrations(found, entry.content)),
            connected=not retired and found is not None and self._is_connected(found),
            note="" if retired or found is None else self._note(found, entry, uses, present),
        )

    def _is_connected(self, found: DatasheetIdentity) -> bool:
        devices = {"arm": self._rig.arm.info, "sensor": self._rig.sensor.info}
        info = devices.get(found.kind)
        return info is not None and found.serial_number == info.serial_number != ""

    def _note(
        self, found: DatasheetIdentity, entry: Entry, uses: Uses, present: Sequence[Entry]
    ) -> Text:
        doubles = [
            display_path(one.path.name)
            for one in present
            if one is not entry and one.found and one.found.is_same_thing(found)
        ]
        if doubles:
            return message("datasheet-twice", files=join(doubles))
        return self.unlikely(found) or (uses.note(found, entry.content) if entry.content else "")

    def unlikely(self, found: DatasheetIdentity) -> Text:
        """That a certificate will be issued only, or that the model of the connected arm has fewer
        or more rows than it has joints."""
        if found.issued_on > utc_now()[:10]:
            return message("certificate-issued-later", day=found.issued_on)
        info = self._rig.arm.info
        if info is None or found.form != "arm" or info.joint_count in (0, found.joint_count):
            return ""
        if len({info.serial_number, found.serial_number} - {""}) > 1:
            return ""  # it is of another unit
        return message("arm-has-other-joints", joints=info.joint_count, rows=found.joint_count)
