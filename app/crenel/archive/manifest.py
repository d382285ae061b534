"""What the archive holds of a record: its files with their hashes, and the station's own note."""

import hashlib
import json
from collections.abc import Sequence
from pathlib import Path, PurePosixPath
from typing import Annotated, ClassVar, Literal, Self

from pydantic import AfterValidator, Field, ValidationError

from crenel.errors import OperationError
from crenel.formats.io_errors import error_from_validation
from crenel.formats.json_document import Document, DocumentPart, is_valid_unicode
from crenel.messages.message import message
from crenel.timestamps import LATEST_NS, parse_moment

Kind = Literal["sessions", "scans", "verifications", "performance"]
"""The folder of the data folder in which a record is."""
MANIFEST = "manifest.json"
MOST_BYTES = 2**53
"""More than any disk has; every database represents it exactly."""
SHORT = 16
"""Hexadecimal digits that name a content."""


def _check_inside(path: str) -> str:
    parts = PurePosixPath(path).parts
    if not parts or path.startswith("/") or ".." in parts or "\\" in path or "\0" in path:
        raise ValueError(message("archive-path-leads-out", path=path))
    return path


def _check_id(record_id: str) -> str:
    if len(PurePosixPath(record_id).parts) != 1 or record_id.startswith("."):
        raise ValueError(message("archive-path-leads-out", path=record_id))
    return _check_inside(record_id)


def _check_moment(text: str) -> str:
    parse_moment(text)
    return text


Moment = Annotated[str, AfterValidator(_check_moment)]
InnerPath = Annotated[str, Field(min_length=1, max_length=400), AfterValidator(_check_inside)]
RecordId = Annotated[str, Field(min_length=1, max_length=200), AfterValidator(_check_id)]
Sha256 = Annotated[str, Field(pattern="^[0-9a-f]{64}$")]


class ArchivedFile(DocumentPart):
    """One file of a record; its path is relative to the record's folder."""

    path: InnerPath
    bytes: Annotated[int, Field(ge=0, le=MOST_BYTES)]
    sha256: Sha256
    mtime_ns: Annotated[int, Field(ge=0, le=LATEST_NS)]
    """When it was last changed on the station, since 1970."""


class Manifest(Document):
    """``manifest.json`` in the archive. It is written last: a record is whole exactly when it has
    one."""

    FORMAT: ClassVar[str] = "crenel/archived-record"

    kind: Kind
    id: RecordId
    content: Annotated[str, Field(pattern="^[0-9a-f]{16}$")]
    """A hash of the files' hashes: another content is another folder in the archive."""
    archived_at: Moment
    label: str | None = None
    """What the operator calls a scan; None in older manifests and for other records."""
    calibration_id: str | None = None
    """The calibration in use for a scan; None as for ``label``."""
    points: Annotated[int, Field(ge=0, le=MOST_BYTES)] | None = None
    """The points in a scan's cloud, which is made again when it is needed; None as for
    ``label``."""
    files: tuple[ArchivedFile, ...]

    @property
    def folder(self) -> str:
        """The folder of the files in the archive."""
        return f"{self.kind}/{self.id}/{self.content}"

    @property
    def size_bytes(self) -> int:
        """All files together."""
        return sum(file.bytes for file in self.files)

    @classmethod
    def parse(cls, content: bytes, name: str) -> Self:
        """Reads a manifest from the archive.

        Raises:
            OperationError: it is damaged, or of another version.
        """
        try:
            fields = json.loads(content)
        except (ValueError, RecursionError):
            fields = None
        if not isinstance(fields, dict) or not is_valid_unicode(fields):
            raise OperationError("archive-manifest", message("archive-manifest-damaged", name=name))
        cls._check_format(Path(name), fields)
        try:
            found = cls.model_validate(fields)
        except ValidationError as error:
            raise error_from_validation(name, error) from error
        if found.content != content_name(found.files):
            raise OperationError("archive-manifest", message("archive-manifest-damaged", name=name))
        return found


class ArchiveNote(Manifest):
    """``archive/<kind>/<id>.json`` in the data folder: the manifest that the archive has, and when
    its files were last read there."""

    FORMAT: ClassVar[str] = "crenel/archive-note"

    verified_at: str
    fetched_at: str = ""
    """When the record was brought back; empty if it never was."""


def content_name(files: Sequence[ArchivedFile]) -> str:
    """The name of a content: the same files with the same bytes have the same."""
    lines = sorted(f"{file.sha256} {file.bytes} {file.path}" for file in files)
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()[:SHORT]
