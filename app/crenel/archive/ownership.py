"""Whose an archive is: its marker names the station, so that another one does not use its place."""

import re
import secrets
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from crenel.archive.manifest import ArchiveNote, Manifest
from crenel.archive.notes import NOTES
from crenel.archive.planning import StationRecord
from crenel.archive.records import KINDS
from crenel.archive.remote_store import RemoteStore, read_document
from crenel.archive.store_errors import StoreError
from crenel.archive.transfer import newest_manifest, read_manifest
from crenel.errors import OperationError
from crenel.formats.atomic_write import ensure_folder, write_atomically
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.open_file import read_bounded
from crenel.messages.message import message

MARKER = "crenel-archive.txt"
"""In the root of every archive: a folder without it is a mount that is missing."""
FIRST_LINE = "An archive of Crenel stations. Keep this file: stations look for it."
IDENTITY = "station-id"
ID_BYTES = 16
ID_LINE = re.compile(r"^Station: ([0-9a-f]{32})$", re.MULTILINE)
NAME_LINE = re.compile(r"^Name: (.+)$", re.MULTILINE)
LONGEST_NAME = 200


@dataclass(frozen=True)
class Owner:
    """The station that an archive belongs to."""

    id: str
    """The id of the station by its data folder; empty in archives of earlier versions."""
    name: str
    """As in its settings when the archive was new."""


KnownRecords = tuple[Sequence[ArchiveNote], Sequence[StationRecord]]
"""What a station knows to be archived, and what is on its disk."""


def read_owner(store: RemoteStore) -> Owner | None:
    """The owner by the marker of an archive; None where there is no marker.

    Raises:
        StoreError: the archive cannot be used.
    """
    size = store.size(MARKER)
    if size is None:
        return None
    text = read_document(store, MARKER).decode(errors="replace") if size else ""
    ids, names = ID_LINE.search(text), NAME_LINE.search(text)
    return Owner(ids[1] if ids else "", names[1].strip()[:LONGEST_NAME] if names else "")


def claim_archive(store: RemoteStore, place: str, owner: Owner) -> None:
    """Writes the marker of an archive.

    Args:
        place: of the archive, in messages.

    Raises:
        StoreError: the archive cannot be used.
        OperationError: another station claimed it at the same time.
    """
    lines = (FIRST_LINE, f"Name: {owner.name}", f"Station: {owner.id}", "")
    content = "\n".join(lines).encode()
    store.write(MARKER, [content], len(content))
    found = read_owner(store)
    if found is None or found.id != owner.id:
        raise _foreign_error(place, found or Owner("", ""))


def check_owner(
    store: RemoteStore,
    place: str,
    found: Owner,
    owner: Owner,
    list_known: Callable[[], KnownRecords],
) -> None:
    """Checks that an archive is that of a station, or has records of it: those of earlier versions
    do not say whose they are, and a backup may be older than the identity. An archive that says
    nothing is claimed if it has no records or those of the station.

    Args:
        place: of the archive, in messages.
        found: the owner by its marker.
        owner: the station.
        list_known: what the station knows; called only where the marker does not name it.

    Raises:
        StoreError: the archive cannot be used.
        OperationError: it is that of another station.
    """
    if found.id == owner.id:
        return
    there = {kind: set(store.names(kind)) for kind in KINDS}
    notes, records = list_known()
    is_new = not found.id and not any(there.values())
    known = [note for note in notes if note.id in there[note.kind]]
    here = [record for record in records if record.id in there[record.kind]]
    if not (
        is_new
        or any(read_manifest(store, note.folder) is not None for note in known)
        or any(_is_copy(newest_manifest(store, one.kind, one.id), one) for one in here)
    ):
        raise _foreign_error(place, found)
    if not found.id:
        # what takes new files only need not name its owner; one that is away says so next
        with suppress(StoreError):
            claim_archive(store, place, owner)


def owner_of(data: Path, name: str) -> Owner:
    """A station as the owner of archives; its data folder gets an identity if it has none.

    Args:
        name: of the station.

    Raises:
        OperationError: the disk does not take it.
    """
    path = data / NOTES / IDENTITY
    with convert_io_errors(path):
        known = read_bounded(path).decode(errors="replace").strip() if path.exists() else ""
        if not re.fullmatch(r"[0-9a-f]{32}", known):
            known = secrets.token_hex(ID_BYTES)
            ensure_folder(path.parent)
            write_atomically(path, f"{known}\n".encode())
    return Owner(known, " ".join(name.split())[:LONGEST_NAME])


def _is_copy(manifest: Manifest | None, record: StationRecord) -> bool:
    """Whether a record in the archive has files of this record alone, by name and size."""
    if manifest is None or not manifest.files:
        return False
    here = {(stamp.path, stamp.bytes) for stamp in record.stamps}
    return all((file.path, file.bytes) in here for file in manifest.files)


def _foreign_error(place: str, found: Owner) -> OperationError:
    what = (
        message("archive-of-station", place=place, station=found.name)
        if found.name
        else message("archive-of-another", place=place)
    )
    return OperationError("archive-foreign", what, remedy=message("archive-own-place"))
