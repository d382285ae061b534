"""The clouds that are wanted, made one after the other."""

import logging
import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import count
from typing import Any, Literal

from crenel.batch.single_cloud import CloudOrder
from crenel.errors import OperationError
from crenel.loop_states import waiting
from crenel.loops import Loop
from crenel.messages.message import Text, message
from crenel.server.fleet.clouds.kept_clouds import KeptClouds
from crenel.server.fleet.clouds.process import CloudCancelledError, make_in_process

log = logging.getLogger(__name__)
MOST_WAITING = 20
MOST_FAILED = 50
"""Whose reasons are kept."""
LEAVE_S = 15.0
FULL_CODES = {"disk-full", "archive-full"}
COMMAND_CODES = {"no-calibration", "archive-forbidden", "archive-missing"}
"""Codes of errors whose remedy is an option of the command line."""


@dataclass
class CloudJob:
    """A cloud that is wanted, and what becomes of it."""

    id: int
    station: str
    order: CloudOrder
    state: Literal["waiting", "working", "failed"] = "waiting"
    share: float = 0.0
    note: Text = ""
    problem: Text = ""
    """Why it failed."""
    cancelled: bool = False


class CloudQueue:
    """Orders of clouds, and the thread that has them made; what is made is in the folder alone.

    Args:
        keep: called with what is not made yet at each change of it, one call at a time; a server
            that ends makes no change.
    """

    def __init__(self, kept: KeptClouds, keep: Callable[[Sequence[CloudJob]], None]) -> None:
        self._kept, self._keep = kept, keep
        self._jobs: dict[int, CloudJob] = {}
        self._ids = count(1)
        self._lock = threading.Lock()
        self._wake, self._ending = threading.Event(), threading.Event()
        self._loop = Loop("fleet-clouds", self._make_next, ending=self._ending)
        self._has_begun = False

    def start(self, orders: Sequence[tuple[str, CloudOrder]] = ()) -> None:
        """Begins to work; nothing else uses the folder yet.

        Args:
            orders: with their stations, what an earlier server did not make.
        """
        with self._lock:
            for station, order in orders:
                if all(one.order != order for one in self._jobs.values()):
                    job = CloudJob(next(self._ids), station, order)
                    self._jobs[job.id] = job
            self._note_pending()
        self._loop.start()

    def close(self) -> None:
        """Ends the cloud that is being made; nothing of it is left."""
        self._loop.stop(LEAVE_S, self._wake.set)

    def add(self, station: str, order: CloudOrder) -> CloudJob:
        """Orders a cloud; what was ordered before and is not made yet is the same.

        Raises:
            OperationError: too many wait.
        """
        with self._lock:
            pending = self._pending()
            for job in pending:
                if job.order == order:
                    return job
            if len(pending) > MOST_WAITING:
                raise OperationError("queue-full", message("fleet-clouds-queue-full"))
            failed = [one.id for one in self._jobs.values() if one.state == "failed"]
            again = [one for one in failed if self._jobs[one].order == order]
            for one in (*again, *failed[:-MOST_FAILED]):
                self._jobs.pop(one, None)
            job = CloudJob(next(self._ids), station, order)
            self._jobs[job.id] = job
            self._note_pending()
        self._wake.set()
        return job

    def jobs_of(self, station: str, scan_id: str) -> Sequence[CloudJob]:
        """What is wanted of a scan, the first order first."""
        with self._lock:
            jobs = list(self._jobs.values())
        return [one for one in jobs if (one.station, one.order.scan_id) == (station, scan_id)]

    def cancel(self, job_id: int) -> None:
        """Nobody wants it any more; its work ends a moment later."""
        with self._lock:
            job = self._jobs.get(job_id)
            if job is None:
                return
            job.cancelled = True
            if job.state != "working":
                del self._jobs[job_id]
            self._note_pending()

    def _pending(self) -> list[CloudJob]:
        return [one for one in self._jobs.values() if one.state != "failed" and not one.cancelled]

    def _note_pending(self) -> None:
        self._keep(self._pending())

    def _clear(self) -> None:
        with self._lock:  # the file of the orders is not being written meanwhile
            self._kept.clear()

    def _make_next(self) -> None:
        """Makes the next cloud, or waits for an order; begins with what an earlier server left."""
        if not self._has_begun:
            self._clear()
            self._kept.keep_limit()
            self._has_begun = True
        self._wake.clear()
        if self._ending.is_set():
            return
        job = self._begin_next()
        if job is None:
            with waiting():
                self._wake.wait()
        else:
            self._make(job)

    def _begin_next(self) -> CloudJob | None:
        with self._lock:
            job = next((one for one in self._jobs.values() if one.state == "waiting"), None)
            if job is not None:
                job.state = "working"
            return job

    def _make(self, job: CloudJob) -> None:
        def take(kind: Literal["share", "note"], value: Any) -> None:
            if kind == "share":
                job.share, job.note = value, ""
            else:
                job.note = value

        problem: Text = ""
        try:
            with waiting():  # for another process, which says how far it is
                made = make_in_process(
                    job.order, take, lambda: job.cancelled or self._ending.is_set()
                )
            self._kept.note_use(made["cloud"])
            self._kept.keep_limit(made["cloud"])
        except CloudCancelledError:
            if not job.cancelled:  # the server ends
                return
        except OperationError as error:
            problem = _words_of(error)
            log.warning("a cloud of %s is not made: %s", job.order.scan_id, error.line)
        except Exception as error:  # the next order may succeed
            problem = message("what-and-why", what=message("program-failed"), why=error)
            log.exception("a cloud of %s is not made", job.order.scan_id)
        finally:
            if job.order.scheduler is None:  # other workers may still be writing
                self._clear()
        with self._lock:
            if problem and not job.cancelled:
                job.problem, job.state = problem, "failed"
            else:
                self._jobs.pop(job.id, None)
            self._note_pending()


def _words_of(error: OperationError) -> Text:
    """Why a cloud is not made, and what to do about it here."""
    if error.code in FULL_CODES:
        remedy = message("fleet-clouds-make-room")
        return OperationError(error.code, error.what, error.why, remedy).text
    return error.reason if error.code in COMMAND_CODES else error.text
