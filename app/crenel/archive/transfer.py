"""Copies one record to the archive, reads it back there, and brings it back.

The order of a copy: each file, read back and compared by its hash; then the manifest; then the
station's note. A process that is killed in between leaves files without a manifest, which the next
attempt uses if their content is right.
"""

import hashlib
from collections.abc import Iterator, Sequence
from contextlib import closing
from pathlib import Path

from pydantic import ValidationError

from crenel.archive.manifest import MANIFEST, ArchivedFile, ArchiveNote, Manifest, content_name
from crenel.archive.pace import Pace
from crenel.archive.planning import FileStamp, StationRecord
from crenel.archive.records import stamps_in
from crenel.archive.remote_store import PIECE_BYTES, RemoteStore, read_document
from crenel.archive.store_errors import DamagedCopyError, SourceError, is_of_whole_place
from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.io_errors import error_from_os
from crenel.formats.open_file import open_file
from crenel.messages.message import message
from crenel.timestamps import utc_now


def archive_record(record: StationRecord, store: RemoteStore, pace: Pace) -> ArchiveNote:
    """Copies a record, unless the archive has this content already.

    Returns:
        The note about it; the caller stores it.

    Raises:
        StoreError: the archive cannot be reached, is full, refuses, or does not hold what was
            written to it.
        SourceError: a file of the record cannot be read, or changes.
        ArchiveEndedError: the station ends.
    """
    files = hash_files(record, pace)
    manifest = Manifest(
        kind=record.kind,
        id=record.id,
        content=content_name(files),
        archived_at=utc_now(),
        label=record.label,
        calibration_id=record.calibration_id,
        points=record.points,
        files=files,
    )
    present = _find_present(manifest, record, store)
    if present is not None and find_difference(present, store, pace) is None:
        held = {"content": present.content, "files": present.files}
        manifest = manifest.model_copy(update=held)
        if present.label == record.label:
            return _note(manifest, present.archived_at)
    else:
        for file in files:
            _copy_file(record.folder, file, f"{manifest.folder}/{file.path}", store, pace)
    if stamps_in(record.folder) != record.stamps:
        raise _change_error(record.folder)
    content = manifest.text().encode()
    store.write(f"{manifest.folder}/{MANIFEST}", [content], len(content))
    if b"".join(store.read(f"{manifest.folder}/{MANIFEST}")) != content:
        raise DamagedCopyError(f"{manifest.folder}/{MANIFEST}")
    return _note(manifest, manifest.archived_at)


def _find_present(manifest: Manifest, record: StationRecord, store: RemoteStore) -> Manifest | None:
    """The manifest of the same files in the archive; perhaps with those that are left out now."""
    present = read_manifest(store, manifest.folder)
    if present is not None or not record.left_out:
        return present
    earlier = newest_manifest(store, record.kind, record.id)
    if earlier is None:
        return None
    others = tuple(file for file in earlier.files if file.path not in record.left_out)
    return earlier if content_name(others) == manifest.content else None


def find_difference(manifest: Manifest, store: RemoteStore, pace: Pace) -> str | None:
    """Reads a record in the archive: the first file that is missing or differs; None if the record
    is whole.

    Raises:
        StoreError: the archive cannot be reached, or refuses.
    """
    present = read_manifest(store, manifest.folder)
    if present is None or present.content != manifest.content:
        return f"{manifest.folder}/{MANIFEST}"
    for file in manifest.files:
        name = f"{manifest.folder}/{file.path}"
        if not _holds(store, name, file, pace):
            return name
    return None


def find_incomplete(manifests: Sequence[Manifest], store: RemoteStore) -> list[str]:
    """Finds the first file of each record that the archive lacks or has in another size. Contents
    are not read.

    Raises:
        StoreError: the archive cannot be reached, or refuses.
    """
    sizes: dict[str, int] = {}
    for kind in sorted({one.kind for one in manifests}):
        sizes |= store.sizes(kind)
    found = []
    for one in manifests:
        needed = {f"{one.folder}/{file.path}": file.bytes for file in one.files}
        wrong = [name for name, size in needed.items() if sizes.get(name) != size]
        if f"{one.folder}/{MANIFEST}" not in sizes:
            wrong.append(f"{one.folder}/{MANIFEST}")
        found += wrong[:1]
    return found


def read_manifest(store: RemoteStore, folder: str) -> Manifest | None:
    """The manifest of a folder in the archive; None if it has none, or one that is damaged or of
    another folder."""
    name = f"{folder}/{MANIFEST}"
    try:
        if store.size(name) is None:
            return None
        found = Manifest.parse(read_document(store, name), name)
    except OperationError as error:
        if is_of_whole_place(error):
            raise
        return None
    return found if found.folder == folder else None


def newest_manifest(store: RemoteStore, kind: str, record_id: str) -> Manifest | None:
    """The last content of a record that the archive has whole."""
    folders = [f"{kind}/{record_id}/{name}" for name in store.names(f"{kind}/{record_id}")]
    found = [one for folder in folders if (one := read_manifest(store, folder)) is not None]
    return max(found, key=lambda one: one.archived_at, default=None)


def download_file(
    file: ArchivedFile, name: str, target: Path, store: RemoteStore, pace: Pace
) -> None:
    """Writes a file of the archive to a new file, compared by its hash.

    Raises:
        StoreError: it differs from its manifest, or the archive cannot be reached.
        OSError: it cannot be written.
    """
    found = hashlib.sha256()
    with open(target, "xb") as writing, closing(store.read(name)) as pieces:  # type: ignore[type-var]
        for piece in pieces:
            pace.take(len(piece))
            found.update(piece)
            writing.write(piece)
    if found.hexdigest() != file.sha256:
        raise DamagedCopyError(name)


def hash_files(record: StationRecord, pace: Pace) -> tuple[ArchivedFile, ...]:
    """The files that the archive takes of a record, with their hashes, by reading them.

    Raises:
        SourceError: one cannot be read, or changes.
    """
    return tuple(_hash_file(record.folder, stamp, pace) for stamp in record.copied)


def _hash_file(folder: Path, stamp: FileStamp, pace: Pace) -> ArchivedFile:
    if stamp.path == MANIFEST:
        raise _name_error(folder / stamp.path)
    found, count = hashlib.sha256(), 0
    for piece in _pieces(folder / stamp.path, pace):
        found.update(piece)
        count += len(piece)
    if count != stamp.bytes:
        raise _change_error(folder / stamp.path)
    try:
        return ArchivedFile(
            path=stamp.path, bytes=count, sha256=found.hexdigest(), mtime_ns=stamp.mtime_ns
        )
    except ValidationError as error:
        raise _name_error(folder / stamp.path) from error


def _pieces(path: Path, pace: Pace) -> Iterator[bytes]:
    try:
        with open_file(path) as file:
            while piece := file.read(PIECE_BYTES):
                pace.take(len(piece))
                yield piece
    except OSError as error:
        why = error_from_os(error, path)
        raise SourceError(why.code, why.what, why.why, why.remedy) from error


def _copy_file(folder: Path, file: ArchivedFile, name: str, store: RemoteStore, pace: Pace) -> None:
    """Writes one file unless the archive has it, and reads it back."""
    if _holds(store, name, file, pace):
        return
    store.write(name, _pieces_as_hashed(folder / file.path, file, pace), file.bytes)
    if not _holds(store, name, file, pace):
        raise DamagedCopyError(name)


def _pieces_as_hashed(path: Path, file: ArchivedFile, pace: Pace) -> Iterator[bytes]:
    """The content of a file; it ends with an error if that is not what was hashed."""
    found = hashlib.sha256()
    for piece in _pieces(path, pace):
        found.update(piece)
        yield piece
    if found.hexdigest() != file.sha256:
        raise _change_error(path)


def _holds(store: RemoteStore, name: str, file: ArchivedFile, pace: Pace) -> bool:
    """Whether a file in the archive has the content, by reading it."""
    found = hashlib.sha256()
    try:
        if store.size(name) != file.bytes:
            return False
        for piece in store.read(name):
            pace.take(len(piece))
            found.update(piece)
    except DamagedCopyError:
        return False
    return found.hexdigest() == file.sha256


def _note(manifest: Manifest, archived_at: str) -> ArchiveNote:
    fields = {name: getattr(manifest, name) for name in Manifest.model_fields}
    return ArchiveNote(**{**fields, "archived_at": archived_at}, verified_at=utc_now())


def _name_error(path: Path) -> SourceError:
    return SourceError(
        "archive-name",
        message("archive-cannot-hold-name", path=display_path(path)),
        remedy=message("rename"),
    )


def _change_error(path: Path) -> SourceError:
    return SourceError(
        "archive-changed",
        message("archive-record-changes", path=display_path(path)),
        remedy=message("archive-tried-again"),
    )
