"""Long work, one job at a time, outside the event loop, with progress."""

import logging
import threading
import time
from collections.abc import Callable
from typing import Generic, TypeVar

from crenel.errors import OperationError
from crenel.loops import start_worker
from crenel.messages.message import Text, message
from crenel.station.bus import Bus

log = logging.getLogger(__name__)

T = TypeVar("T")
Progress = Callable[[Text, float], None]
"""Called by the work with its current step and the share done (0 to 1)."""


class Job(Generic[T]):
    """One job: its progress and its result."""

    def __init__(self, title: Text) -> None:
        self.title = title
        self.text: Text = ""
        self.fraction: float | None = None
        self.result: T | None = None
        self.refusal: OperationError | None = None
        """Why there is no result, also after an unexpected error."""
        self.finished = False

    def progress(self, text: Text, fraction: float) -> None:
        self.text, self.fraction = text, fraction


class Jobs:
    """Runs one job at a time in a separate thread."""

    def __init__(self, bus: Bus) -> None:
        self._bus = bus
        self._lock = threading.Lock()
        self._current: Job[object] | None = None
        self._thread: threading.Thread | None = None
        self.on_ended: Callable[[str, float], None] = lambda title, seconds: None
        """Called with the English title and the duration of each job."""

    @property
    def current(self) -> Job[object] | None:
        """The job that is running, if any."""
        with self._lock:
            return self._current

    def start(
        self, title: Text, work: Callable[[Progress], T], done: Callable[[Job[T]], None]
    ) -> Job[T]:
        """Starts work in a thread; ``done`` runs on the event loop after its end.

        Raises:
            OperationError: ``busy`` while another job runs.
        """
        job: Job[T] = Job(title)
        with self._lock:
            if self._current is not None:
                raise OperationError(
                    "busy",
                    message("cannot-start", title=title),
                    message("still-running", title=self._current.title),
                    message("wait-until-has-ended"),
                )
            self._current = job  # type: ignore[assignment]  # read only as a job of anything
        self._thread = start_worker(f"job-{title!s}", self._run, job, work, done)
        return job

    def wait(self, timeout_s: float) -> None:
        """Waits for the running job, if any, to end."""
        thread = self._thread
        if thread is not None:
            thread.join(timeout_s)

    def _run(
        self, job: Job[T], work: Callable[[Progress], T], done: Callable[[Job[T]], None]
    ) -> None:
        began_s = time.monotonic()
        try:
            job.result = work(job.progress)
        except OperationError as refusal:
            job.refusal = refusal
        except Exception as error:  # the operator sees an error, and the station continues
            log.exception("%s failed", job.title)
            job.refusal = OperationError(
                "failed",
                message("activity-failed", title=job.title),
                f"{type(error).__name__}: {error}",
                message("nothing-changed-stations-log-has-details"),
            )
        finally:
            job.finished = True
            with self._lock:
                self._current = None
            self.on_ended(str(job.title), time.monotonic() - began_s)
        self._bus.call(done, job)
