"""A task, and how a worker does it."""

import resource
import sys
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Literal, Protocol, Self

from crenel.archive.manifest import ArchivedFile
from crenel.archive.pace import ArchiveEndedError, Pace
from crenel.archive.transfer import download_file
from crenel.batch.places import Dependency, RecordFile
from crenel.batch.recording_copy import copy_without_pictures
from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.json_document import SOFTWARE
from crenel.messages.message import Text, message, replace_name
from crenel.progress import Progress, no_progress

PROGRESS_TOPIC = "crenel-progress"
"""The topic of Dask's events with the share of a task that is done, from its worker."""
REPORT_S = 0.5
"""Between two of them."""

STOPPING = {
    "archive-forbidden",
    "archive-full",
    "archive-library",
    "archive-secret",
    "disk-full",
    "extra-missing",
    "folder-forbidden",
    "folder-read-only",
}
"""Codes of errors that all other tasks would meet, too."""


PASSING = {"archive-away", "archive-differs"}
"""Codes of errors that may have passed by the time at which the place is looked at: connections
that are cut, and files that came incomplete."""


@dataclass(frozen=True)
class Desk:
    """What a worker provides for a task."""

    folder: Path
    """For temporary files; removed afterwards."""
    threads: int
    """That compute at the same time."""
    is_ending: Callable[[], bool]
    note: Progress = no_progress
    """Called with the progress of the task."""
    names: dict[str, str] = field(default_factory=dict)
    """By the path of a temporary file or folder: what it is a copy of, for messages."""

    def report(self, share: float, text: Text) -> None:
        """The progress of the task; raises ``ArchiveEndedError`` if the worker ends."""
        if self.is_ending():
            raise ArchiveEndedError
        self.note(share, text)

    def name_copy(self, path: Path, of: str) -> None:
        """Has messages name a temporary file, or a folder, by what it is a copy of."""
        self.names[display_path(path)] = of

    def find_recording(self, file: RecordFile, name: str) -> Path:
        """A recording on this machine: that of a folder, or a copy; perhaps without pictures of
        frames that have stripes.

        Raises:
            OperationError: it cannot be read, or differs from its sums.
        """
        if file.place.settings.is_folder:
            return Path(file.place.settings.url) / file.name
        target = self.folder / name
        self.name_copy(target, file.full_name)
        pace = _EndingPace(self)
        with convert_io_errors(target):
            store = file.place.store()
            if copy_without_pictures(store, file.name, file.bytes, target, pace.take):
                return target
        return self.copy(file, name)

    def copy(self, file: RecordFile, name: str) -> Path:
        """A copy of a file of a record on this machine, compared by its hash.

        Raises:
            OperationError: it cannot be read, or differs from its hash.
        """
        target = self.folder / name
        self.name_copy(target, file.full_name)
        described = ArchivedFile(
            path=name, bytes=file.bytes, sha256=file.digest(), mtime_ns=file.mtime_ns
        )
        with convert_io_errors(target):
            target.parent.mkdir(parents=True, exist_ok=True)
            download_file(described, file.name, target, file.place.store(), _EndingPace(self))
        return target


class _EndingPace(Pace):
    """At full speed, until the worker ends."""

    def __init__(self, desk: Desk) -> None:
        super().__init__(1.0, lambda: False)
        self._desk = desk

    def take(self, count: int) -> None:
        self._desk.report(0.0, "")


class Task(Protocol):
    """A task whose result is kept under its key; it can be pickled."""

    @property
    def key(self) -> str:
        """Hexadecimal; of all that determines the result."""

    @property
    def name(self) -> str:
        """In messages."""

    @property
    def size_bytes(self) -> int:
        """By which the progress is measured."""

    @property
    def depends_on(self) -> Sequence[Dependency]:
        """The places that it reads and writes."""

    def perform(self, desk: Desk) -> Mapping[str, Any]:
        """Makes the result and keeps it, unless it is there.

        Returns:
            The fields of its document.

        Raises:
            OperationError: it cannot be made.
        """


@dataclass(frozen=True)
class Refusal:
    """An ``OperationError`` as it comes from a worker."""

    code: str
    what: Text
    why: Text = ""
    remedy: Text = ""

    @classmethod
    def of(cls, error: OperationError) -> Self:
        """The parts of an error."""
        return cls(error.code, error.what, error.why, error.remedy)

    def naming(self, names: Mapping[str, str]) -> Self:
        """The same with other names of some files, by their paths."""
        what, why, remedy = self.what, self.why, self.remedy
        for path in sorted(names, key=len, reverse=True):
            what, why, remedy = (
                replace_name(text, path, names[path]) for text in (what, why, remedy)
            )
        return replace(self, what=what, why=why, remedy=remedy)

    def error(self) -> OperationError:
        """The error again."""
        return OperationError(self.code, self.what, self.why, self.remedy)


@dataclass(frozen=True)
class Outcome:
    """What became of a task."""

    state: Literal["done", "refused", "again", "away", "stop"]
    """``again``: it may succeed if it is tried again; ``away``: a place cannot be reached now;
    ``stop``: all others would fail, too."""
    result: Mapping[str, Any] = field(default_factory=dict)
    refusal: Refusal | None = None
    seconds: float = 0.0
    """That the worker was busy with it."""
    memory_bytes: int = 0
    """Most that the worker's process has used so far."""


def perform_on_worker(task: Task, version: str, threads: int, is_watched: bool) -> Outcome:
    """Does a task in a worker of Dask.

    Args:
        version: of the software that asks for it.
        is_watched: its progress is sent as events.
    """
    from distributed import Status, get_worker

    worker = get_worker()
    ending = (Status.closing, Status.closing_gracefully, Status.closed)
    if version != SOFTWARE.version:
        versions = message("batch-other-version", here=version, there=SOFTWARE.version)
        return Outcome("stop", refusal=Refusal("other-version", versions))
    note: Progress = no_progress
    if is_watched:
        note = _at_intervals(
            lambda share: worker.log_event(PROGRESS_TOPIC, {"key": task.key, "share": share})
        )
    scratch = Path(worker.local_directory)
    return perform(task, scratch, threads, lambda: worker.status in ending, note)


def _at_intervals(send: Callable[[float], None]) -> Progress:
    due_s = 0.0

    def note(share: float, text: Text) -> None:
        nonlocal due_s
        if (now_s := time.monotonic()) >= due_s:
            due_s = now_s + REPORT_S
            send(share)

    return note


def perform(
    task: Task,
    scratch: Path,
    threads: int,
    is_ending: Callable[[], bool] = lambda: False,
    note: Progress = no_progress,
) -> Outcome:
    """Does a task in this process.

    Args:
        scratch: a folder for temporary files.
    """
    began_s = time.perf_counter()
    outcome = _try(task, Desk(scratch, threads, is_ending, note))
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return Outcome(
        outcome.state,
        outcome.result,
        outcome.refusal,
        time.perf_counter() - began_s,
        peak if sys.platform == "darwin" else peak * 1024,
    )


def _try(task: Task, desk: Desk) -> Outcome:
    try:
        with TemporaryDirectory(prefix="crenel-", dir=desk.folder) as folder:
            return Outcome("done", task.perform(replace(desk, folder=Path(folder))))
    except OperationError as error:
        refusal = Refusal.of(error).naming(desk.names)
    if refusal.code in STOPPING:
        return Outcome("stop", refusal=refusal)
    is_away = refusal.code == "archive-ended" or not all(
        place.is_there() for place in task.depends_on
    )
    if is_away:
        return Outcome("away", refusal=refusal)
    return Outcome("again" if refusal.code in PASSING else "refused", refusal=refusal)
