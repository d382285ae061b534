"""The parts that a station keeps: files that arrive in pieces are read in the background."""

import logging
import secrets
import shutil
import threading
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from crenel.errors import OperationError
from crenel.formats.atomic_write import ensure_folder, make_folder
from crenel.formats.io_errors import convert_io_errors
from crenel.loops import start_worker
from crenel.messages.message import Text, message, quantity
from crenel.parts.compare.document_part import (
    LONGEST_NAME,
    MOST_BYTES,
    MOST_PARTS,
    PARTS,
    SUFFIXES,
    KeptPart,
)
from crenel.parts.compare.guide_view import ReadingPart, Refused

log = logging.getLogger(__name__)
ARRIVING = ".arriving-"
"""Of the folder of a file that is not read yet."""
FREE_BYTES = 500_000_000
"""That a disk keeps free, for scans."""
READ_MEMORY_BYTES = 4 << 30


@dataclass(frozen=True)
class ArrivingFile:
    """A file of which pieces arrive."""

    id: str
    name: str
    folder: Path
    file: str
    size: int
    received: int = 0


class KeptParts:
    """Every method may be called from any thread.

    Args:
        data: the station's data folder.
        changed: called when what browsers show has changed.
    """

    def __init__(self, data: Path, changed: Callable[[], None]) -> None:
        self._data, self._folder = data, data / PARTS
        self._changed = changed
        self._lock = threading.RLock()
        self._parts: dict[str, KeptPart] | None = None
        self._arriving: ArrivingFile | None = None
        self._share: float | None = None
        """Of reading; None: nothing is read."""
        self._closing = threading.Event()
        self.refused: Refused | None = None
        """The last file, or comparison, that was refused."""

    def close(self) -> None:
        """Ends reading."""
        self._closing.set()

    def all(self) -> dict[str, KeptPart]:
        """The parts by their ids, the newest first; those that cannot be read are left out."""
        with self._lock:
            if self._parts is None:
                self._parts = self._read_all()
            return dict(self._parts)

    def get(self, part_id: str) -> KeptPart:
        """A part; raises ``OperationError`` where it is no longer there."""
        part = self.all().get(part_id)
        if part is None:
            raise OperationError(
                "no-part", message("compare-part-gone"), "", message("compare-choose-part")
            )
        return part

    def file_of(self, part_id: str) -> Path:
        """Where its file is."""
        return self._folder / part_id / self.get(part_id).file

    def save(self, part_id: str, part: KeptPart) -> None:
        """Keeps what was stated for a part."""
        with self._lock:
            part.write(self._folder / part_id / "part.json")
            self.all()[part_id] = part
            assert self._parts is not None
            self._parts[part_id] = part
        self._changed()

    def remove(self, part_id: str) -> None:
        """Removes a part; what was compared with it stays. Does nothing if it is not there."""
        with self._lock:
            if part_id not in self.all() or self._parts is None:
                return
            with convert_io_errors(self._folder):
                self._drop(self._folder / part_id)
            del self._parts[part_id]
        self._changed()

    @property
    def reading(self) -> ReadingPart | None:
        """What arrives or is read now."""
        with self._lock:
            file, share = self._arriving, self._share
            if file is None:
                return None
            if share is None:
                return ReadingPart(file.name, round(file.received / file.size, 2), False)
            return ReadingPart(file.name, share, True)

    def begin(self, name: str, size: int) -> ArrivingFile:
        """A file begins to arrive; one that has not arrived completely is dropped for it.

        Raises:
            OperationError: of another kind, too large, or the disk has no space.
        """
        name = " ".join(name.replace("\\", "/").rpartition("/")[2].split())[-LONGEST_NAME:]
        suffix = Path(name).suffix.lower()
        if suffix not in SUFFIXES:
            raise _refusal(
                name, message("compare-file-of-other-kind"), message("compare-give-known-format")
            )
        if not size:
            raise _refusal(name, message("compare-file-empty"), message("compare-export-again"))
        if size > MOST_BYTES:
            limit = quantity(MOST_BYTES / 1e6, "MB")
            raise _refusal(
                name,
                message("compare-file-too-large", limit=limit),
                message("compare-export-coarser"),
            )
        with self._lock:
            if self._share is not None:
                raise _refusal(
                    name, message("compare-other-file-is-read"), message("wait-until-has-ended")
                )
            if len(self.all()) >= MOST_PARTS:
                raise _refusal(
                    name,
                    message("compare-too-many-parts", most=MOST_PARTS),
                    message("compare-remove-part-first"),
                )
            with convert_io_errors(self._folder):
                ensure_folder(self._folder)
                for left in self._folder.glob(f"{ARRIVING}*"):
                    shutil.rmtree(left, ignore_errors=True)
                if shutil.disk_usage(self._folder).free < size + FREE_BYTES:
                    raise _refusal(
                        name, message("compare-disk-too-full"), message("compare-free-space")
                    )
                part_id = secrets.token_hex(6)
                folder = self._folder / f"{ARRIVING}{part_id}"
                make_folder(folder)
                (folder / f"part{suffix}").touch()
            self._arriving = ArrivingFile(part_id, name, folder, f"part{suffix}", size)
            self.refused = None
            found = self._arriving
        self._changed()
        return found

    def take(self, part_id: str, at: int, piece: bytes) -> int:
        """Adds a piece of a file that arrives, from this byte on; reads it when it is complete.

        Returns:
            How many bytes of it have arrived.

        Raises:
            OperationError: it is not the file that arrives, or not its next piece.
        """
        with self._lock:
            file = self._arriving
            if file is None or file.id != part_id or self._share is not None:
                raise OperationError(
                    "no-upload", message("compare-other-file-begun"), "", message("compare-again")
                )
            if 0 < at + len(piece) <= file.received:
                return file.received  # sent again, as its answer was lost
            if at != file.received or not piece or at + len(piece) > file.size:
                raise OperationError(
                    "wrong-piece",
                    message("compare-wrong-piece", received=file.received, size=file.size),
                    "",
                    message("compare-send-from-there"),
                )
            with convert_io_errors(file.folder), (file.folder / file.file).open("ab") as into:
                into.write(piece)
            self._arriving = file = replace(file, received=at + len(piece))
            is_whole = file.received == file.size
            if is_whole:
                self._share = 0.0
        self._changed()
        if is_whole:
            start_worker("part-reading", self._examine, file)
        return file.received

    def _examine(self, file: ArrivingFile) -> None:
        """On a worker's thread: reads a file that has arrived, and keeps it or says why not."""
        # imported when the first part arrives: most stations compare nothing
        from crenel.parts.compare.evaluate_comparison import PartOrder, examine_part
        from crenel.parts.compare.evaluate_process import CancelledError, run_in_process

        def progress(share: float, text: Text) -> None:
            self._share = round(share, 2)
            self._changed()

        order = PartOrder(self._data, file.folder, file.file, file.name)
        refused: Refused | None = None
        try:
            run_in_process(examine_part, order, progress, self._closing.is_set, READ_MEMORY_BYTES)
            self._keep(file)
        except OperationError as error:
            refused = Refused(file.name, error.text)
        except CancelledError:
            pass
        except Exception as error:
            log.exception("the part %s could not be read", file.name)
            refused = Refused(file.name, f"{type(error).__name__}: {error}")
        finally:
            shutil.rmtree(file.folder, ignore_errors=True)
            with self._lock:
                self._arriving, self._share, self.refused = None, None, refused
            self._changed()

    def _keep(self, file: ArrivingFile) -> None:
        """In the place of a part of the same name, whose tolerance it takes over."""
        part = KeptPart.of_folder(file.folder)
        with self._lock:
            former = [one for one, known in self.all().items() if known.name == part.name]
            if former:
                known = self.all()[former[0]]
                same_size = part.size == known.size
                part = part.model_copy(
                    update={
                        "lower_mm": known.lower_mm,
                        "upper_mm": known.upper_mm,
                        "unit": known.unit if same_size else "",
                    }
                )
                part.write(file.folder / "part.json")
            with convert_io_errors(self._folder):
                file.folder.rename(self._folder / file.id)
                for one in former:
                    self._drop(self._folder / one)
            kept = {one: known for one, known in self.all().items() if one not in former}
            self._parts = {file.id: part, **kept}

    def _drop(self, folder: Path) -> None:
        """Renamed first: if the process is killed in between, half a folder is no part."""
        doomed = folder.with_name(f"{ARRIVING}{folder.name}")
        folder.rename(doomed)
        shutil.rmtree(doomed, ignore_errors=True)

    def _read_all(self) -> dict[str, KeptPart]:
        found: dict[str, KeptPart] = {}
        folders = self._folder.iterdir() if self._folder.is_dir() else ()
        for folder in folders:
            if folder.name.startswith(".") or not folder.is_dir():
                continue
            try:
                found[folder.name] = KeptPart.of_folder(folder)
            except OperationError as error:
                log.warning("%s", error.line)
        newest = sorted(found.items(), key=lambda one: one[1].added_at, reverse=True)
        return dict(newest)


def _refusal(name: str, why: Text, remedy: Text) -> OperationError:
    return OperationError("part-not-taken", message("compare-not-taken", name=name), why, remedy)
