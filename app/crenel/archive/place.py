"""Where an archive lies: never in the records that it copies, and best on a disk of its own."""

from collections.abc import Iterator
from pathlib import Path

from crenel.archive.archive_settings import ArchiveSettings
from crenel.archive.notes import NOTES
from crenel.archive.records import KINDS
from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.real_folders import is_within, share_disk
from crenel.messages.message import message

LOCAL_PROTOCOLS = ("file", "local")
"""Protocols by which fsspec reaches folders of this machine."""


def local_folder(settings: ArchiveSettings) -> Path | None:
    """The folder of an archive that is on this machine, or mounted there; None for all others."""
    if settings.is_folder:
        return Path(settings.url)
    # a cache of fsspec stands before what it caches
    protocol, _, path = settings.url.rpartition("::")[2].partition("://")
    return Path(path).expanduser().absolute() if protocol in LOCAL_PROTOCOLS else None


def is_in_records(place: Path, folder: Path) -> bool:
    """Whether a place lies in a data folder or an archive, or in one of its folders of records,
    which may be links."""
    return any(is_within(place, each) for each in _folders(folder))


def check_apart(settings: ArchiveSettings, data: Path) -> None:
    """Raises ``OperationError`` if an archive would be in the data folder, or that in the archive:
    records would be copied into themselves, and the only copies moved on one disk."""
    place = local_folder(settings)
    if place is None:
        return
    if any(
        is_in_records(there, data) or is_within(own, there)
        for there in _folders(place)
        for own in _folders(data)
    ):
        raise OperationError(
            "archive-inside",
            message("archive-overlaps-data", place=settings.place, folder=display_path(data)),
            message("archive-copies-itself"),
            message("archive-name-place-apart"),
        )


def is_on_disk_of(settings: ArchiveSettings, data: Path) -> bool | None:
    """Whether the archive would be lost with a disk of the records; None where it is on no disk of
    this machine, or not there."""
    place = local_folder(settings)
    if place is None or not place.exists():
        return None
    return any(share_disk(place, own) for own in _folders(data))


def _folders(folder: Path) -> Iterator[Path]:
    """A data folder or an archive, and what it may have of records and of notes about them."""
    yield folder
    for name in (*KINDS, NOTES):
        yield folder / name
