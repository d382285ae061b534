"""Where results are kept: a folder or a store, each under a name with the key of its task.

A result is whole exactly when its document is there, which is written last, at once, and the cloud
that it names has the size that it states.
"""

import json
from collections.abc import Iterator, Mapping, Sequence, Set
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, ClassVar

from crenel.archive.archive_settings import ArchiveSettings
from crenel.archive.place import is_in_records, local_folder
from crenel.archive.remote_store import PIECE_BYTES, read_document
from crenel.archive.store_errors import is_of_whole_place
from crenel.batch.calibrations import BySensor
from crenel.batch.patience import Patience, open_patiently
from crenel.batch.recordings import READERS
from crenel.batch.task import Desk
from crenel.errors import OperationError
from crenel.formats.atomic_write import ensure_folder
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.json_document import Document, DocumentPart, Software
from crenel.formats.open_file import open_file
from crenel.messages.message import Text, message

SHORT_KEY = 16
DOCUMENT, PART = ".json", ".part"
PROBE, PROBE_TEXT = ".crenel-probe", b"Crenel tried to write here.\n"


class UsedFiles(DocumentPart):
    """A calibration and its arm, by their SHA-256."""

    sensor: str = ""
    id: str
    calibration_sha256: str
    arm_sha256: str


class RebuiltCloud(Document):
    """``<station>-<scan>-<key>.json``: a rebuilt cloud, and from what it was made."""

    FORMAT: ClassVar[str] = "crenel/rebuilt-cloud"

    key: str
    station: str
    record: str
    started_at: str
    recording_sha256: str
    calibrations: tuple[UsedFiles, ...]
    software: Software
    cloud: str
    """Name of its file, beside the document."""
    cloud_bytes: int
    """Its size: a cloud that was cut off or removed since is made again."""
    points: int
    frames: int
    frames_without_stripe: int
    frames_without_joints: int
    seconds: float
    """The duration of the recording."""
    warnings: tuple[Text, ...] = ()


class ResultStore:
    """The results of one kind of task.

    Args:
        patience: with which it is waited for a store that cannot be reached; None: it fails.
    """

    def __init__(self, settings: ArchiveSettings, patience: Patience | None = None) -> None:
        self.settings = settings
        self._store = open_patiently(settings, "results", patience)

    def prepare(self) -> None:
        """Creates the folder of a store that is a folder, and writes a file there and removes it.

        Raises:
            OperationError: results cannot be written there.
        """
        if self.settings.is_folder:
            folder = Path(self.settings.url)
            with convert_io_errors(folder):
                ensure_folder(folder)
        self._store.write(PROBE, [PROBE_TEXT], len(PROBE_TEXT))
        with suppress(OperationError):  # some stores let files be written, but not removed
            self._store.remove(PROBE)

    def whole_keys(self, wanted: Set[str]) -> set[str]:
        """Which of these shortened keys have a whole result; raises ``OperationError``."""
        names = (name for name in self._store.names("") if name.endswith(DOCUMENT))
        stems = [name.removesuffix(DOCUMENT) for name in names]
        there = [stem for stem in stems if _key_in(stem) in wanted]
        with ThreadPoolExecutor(READERS, "read-results") as pool:
            read = pool.map(self.read, there)
            return {_key_in(stem) for stem, fields in zip(there, read, strict=True) if fields}

    def read(self, stem: str) -> dict[str, Any] | None:
        """The fields of a result's document; None if there is no whole result."""
        name = stem + DOCUMENT
        try:
            if self._store.size(name) is None:
                return None
            fields = json.loads(read_document(self._store, name))
            return fields if isinstance(fields, dict) and self._has_cloud(fields) else None
        except (ValueError, RecursionError):
            return None
        except OperationError as error:
            if is_of_whole_place(error):
                raise
            return None

    def _has_cloud(self, fields: Mapping[str, Any]) -> bool:
        """Whether the cloud is there as its document states it; results without one have it."""
        cloud = fields.get("cloud")
        return cloud is None or self._store.size(str(cloud)) == fields.get("cloud_bytes", -1)

    def write(self, stem: str, document: Document) -> Mapping[str, Any]:
        """Keeps a result's document; returns its fields."""
        content = document.text().encode()
        self._store.write(stem + DOCUMENT, [content], len(content))
        fields: dict[str, Any] = json.loads(content)
        return fields

    def write_table(self, name: str, text: str) -> None:
        """Keeps a table of all results; raises ``OperationError``."""
        content = text.encode()
        self._store.write(name, [content], len(content))

    @contextmanager
    def file(self, name: str, desk: Desk) -> Iterator[Path]:
        """A path for writing a file, which is kept under its name when the block ends."""
        if self.settings.is_folder:
            yield Path(self.settings.url) / name
            return
        path = desk.folder / name
        yield path
        self._store.write(name, _pieces(path), path.stat().st_size)

    def remove_parts(self, keys: Set[str] | None = None) -> None:
        """Removes what workers that were killed left half-written of these results, or of all."""
        if not self.settings.is_folder:
            return
        for part in Path(self.settings.url).glob(f".*{PART}"):
            target = part.name.removesuffix(PART).rpartition(".")[0]
            if keys is None or target.rpartition("-")[2].partition(".")[0] in keys:
                with suppress(OSError):
                    part.unlink()


def _pieces(path: Path) -> Iterator[bytes]:
    with convert_io_errors(path), open_file(path) as file:
        while piece := file.read(PIECE_BYTES):
            yield piece


def describe_files(calibrations: BySensor) -> tuple[UsedFiles, ...]:
    """What a document states of the calibrations."""
    return tuple(
        UsedFiles(
            sensor=sensor,
            id=one.id,
            calibration_sha256=one.calibration_sha256,
            arm_sha256=one.arm_sha256,
        )
        for sensor, one in calibrations.items()
    )


def _key_in(stem: str) -> str:
    return stem.rpartition("-")[2]


def stem_of(station: str, record: str, key: str) -> str:
    """The name of a result, without its suffix."""
    return f"{station}-{record}-{key[:SHORT_KEY]}"


def check_results_apart(output: ArchiveSettings, sources: Sequence[ArchiveSettings]) -> None:
    """Raises ``OperationError`` if results would be written into an archive or a data folder."""
    place = local_folder(output)
    for source in sources:
        read = local_folder(source)
        if f"{output.url.rstrip('/')}/".startswith(f"{source.url.rstrip('/')}/") or (
            place is not None and read is not None and is_in_records(place, read)
        ):
            raise OperationError(
                "output-is-source",
                message("batch-output-in-source", place=output.place),
                remedy=message("batch-name-another-output"),
            )
