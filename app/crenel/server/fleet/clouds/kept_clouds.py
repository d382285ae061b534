"""The folder of the clouds that were made on demand: the layout of ``crenel rebuild``, up to a
limit."""

import os
import re
import shutil
from collections import defaultdict
from contextlib import suppress
from glob import escape
from pathlib import Path

from pydantic import ValidationError

from crenel.archive.archive_settings import ArchiveSettings
from crenel.batch.places import settings_for
from crenel.batch.results import DOCUMENT, PROBE, RebuiltCloud, ResultStore
from crenel.errors import OperationError
from crenel.formats.clouds.files import COPC

PLY = ".ply"
RESULT = re.compile(rf"(.+-[0-9a-f]{{16}})({re.escape(DOCUMENT)}|{re.escape(COPC)}|{PLY})")
"""The name of a file that a result has."""
SCRATCH = ".scratch"


class KeptClouds:
    """Clouds with their documents. A document's time is when its cloud was made or last fetched.

    Args:
        folder: of its own; it is created when the first cloud is made.
        limit_bytes: of all results; the one that was used least recently goes first.
    """

    def __init__(self, folder: Path, limit_bytes: float) -> None:
        self.settings: ArchiveSettings = settings_for(str(folder))
        self.scratch = folder / SCRATCH
        self._folder, self._limit_bytes = folder, limit_bytes
        self._results = ResultStore(self.settings)

    def clear(self) -> None:
        """Removes what work that was interrupted left behind; no work may be under way."""
        self._results.remove_parts()
        with suppress(OSError):
            (self._folder / PROBE).unlink()
        for left in (self.scratch, *self._folder.glob(".copc-*")):
            shutil.rmtree(left, ignore_errors=True)

    def of_recording(self, scan_id: str, sha256: str) -> list[RebuiltCloud]:
        """The whole clouds of a recording, by its hash; the one that was used last first."""
        found = []
        for path in self._folder.glob(f"*-{escape(scan_id)}-*{DOCUMENT}"):
            document = self._read(path)
            if document is not None and document.recording_sha256 == sha256:
                with suppress(FileNotFoundError):  # it is removed just now
                    found.append((path.stat().st_mtime_ns, document))
        return [document for _, document in sorted(found, key=lambda one: one[0], reverse=True)]

    def fetch(self, name: str) -> Path | None:
        """The file of a cloud by its name, which is used now; None if there is no whole one."""
        matched = RESULT.fullmatch(name)
        if matched is None or matched[2] == DOCUMENT:
            return None
        document = self._read(self._folder / (matched[1] + DOCUMENT))
        if document is None or document.cloud != name:
            return None
        self.note_use(name)
        return self._folder / name

    def note_use(self, name: str) -> None:
        """Notes that a cloud was made or fetched now."""
        if (matched := RESULT.fullmatch(name)) is not None:
            with suppress(OSError):
                os.utime(self._folder / (matched[1] + DOCUMENT))

    def keep_limit(self, spared: str = "") -> None:
        """Removes results until the limit is kept.

        Args:
            spared: the name of a cloud that stays, however large it is.
        """
        results: dict[str, list[tuple[Path, os.stat_result]]] = defaultdict(list)
        for path in self._folder.glob("*"):
            if (matched := RESULT.fullmatch(path.name)) is not None:
                with suppress(FileNotFoundError):
                    results[matched[1]].append((path, path.stat()))
        size = sum(stat.st_size for files in results.values() for _, stat in files)
        for files in sorted(results.values(), key=lambda its: max(s.st_mtime_ns for _, s in its)):
            if size <= self._limit_bytes:
                return
            if spared in {path.name for path, _ in files}:
                continue
            # the document last: if this is interrupted, the next time goes on
            for path, stat in sorted(files, key=lambda one: one[0].suffix == DOCUMENT):
                with suppress(OSError):
                    path.unlink(missing_ok=True)
                    size -= stat.st_size

    def _read(self, path: Path) -> RebuiltCloud | None:
        try:
            fields = self._results.read(path.name.removesuffix(DOCUMENT))
            return None if fields is None else RebuiltCloud.model_validate(fields)
        except (OperationError, ValidationError):
            return None
