"""Runs work on a part in a process of its own: bounded, behind a running scan, ended at any time.

The process reads its order from stdin and writes reports to stdout, pickled; both ends are of this
program. It ends with stdin: a station that is killed ends nobody. This module imports no numerical
library.
"""

import os
import pickle
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from contextlib import suppress
from typing import IO, TypeVar

from crenel.errors import OperationError
from crenel.loops import start_worker
from crenel.messages.message import Text, message, quantity
from crenel.progress import Progress

STARTED_MODULES = ("crenel.parts.compare.evaluate_process",)
T = TypeVar("T")
Work = Callable[[T, Progress], object]
"""A function of a module, which the process imports: its order, and where it reports to."""
LOOK_S = 0.1
NICENESS = 10
MOST_MEMORY_BYTES = 8 << 30
"""Address space of the process, where the system can limit it."""
QUIET = {"OPENBLAS_NUM_THREADS": "1"}
"""The cores are the station's."""


class CancelledError(Exception):
    """The work was ended before its end; nothing of it is left."""


def run_in_process(
    work: Work[T],
    order: T,
    progress: Progress,
    is_cancelled: Callable[[], bool],
    most_memory_bytes: int = MOST_MEMORY_BYTES,
) -> None:
    """Does the work; returns when its process has ended.

    Raises:
        OperationError: as the work does, or its process ended, as by want of memory.
        CancelledError: ``is_cancelled`` said so.
    """
    process = subprocess.Popen(
        [sys.executable, "-P", "-m", *STARTED_MODULES],
        env=os.environ | QUIET,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )
    assert process.stdin is not None
    assert process.stdout is not None
    start_worker("part-cancelling", _watch, process, is_cancelled)
    with process.stdin, process.stdout:
        try:
            with suppress(BrokenPipeError):  # what it has ended with is in its reports
                pickle.dump((work, order, most_memory_bytes), process.stdin)
                process.stdin.flush()
            _follow(process.stdout, progress, most_memory_bytes)
        except OperationError:
            if is_cancelled():
                raise CancelledError from None
            raise
        finally:
            _end(process)


def _follow(reports: IO[bytes], progress: Progress, most_memory_bytes: int) -> None:
    while True:
        try:
            kind, value = pickle.load(reports)
        except (EOFError, pickle.UnpicklingError):
            limit = quantity(most_memory_bytes / 1e9, "GB")
            raise OperationError(
                "part-process-ended",
                message("compare-process-ended"),
                message("compare-process-memory", limit=limit),
                message("compare-give-smaller"),
            ) from None
        if kind == "done":
            return
        if kind == "refused":
            raise OperationError(*value)
        progress(*value)


def _watch(process: "subprocess.Popen[bytes]", is_cancelled: Callable[[], bool]) -> None:
    """On a worker's thread: ends the process when it is not wanted any more."""
    while process.poll() is None:
        if is_cancelled():
            _end(process)
        time.sleep(LOOK_S)


def _end(process: "subprocess.Popen[bytes]") -> None:
    """With whatever it has started."""
    if process.poll() is None:
        with suppress(ProcessLookupError, PermissionError, AttributeError):
            os.killpg(process.pid, signal.SIGKILL)
        process.kill()
    process.wait()


def _main() -> int:
    """What the process does."""
    output = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())  # on which libraries print
    work, order, most_memory_bytes = pickle.load(sys.stdin.buffer)
    with suppress(AttributeError, OSError):  # Windows has none
        os.nice(NICENESS)
    start_worker("station-watch", _end_with_station)
    _limit_memory(most_memory_bytes)

    def send(kind: str, value: object) -> None:
        pickle.dump((kind, value), output)
        output.flush()

    try:
        work(order, lambda share, text: send("progress", (share, text)))
    except OperationError as error:
        send("refused", (error.code, error.what, error.why, error.remedy))
    except MemoryError:
        return 1
    else:
        send("done", None)
    return 0


def _limit_memory(most_bytes: int) -> None:
    with suppress(ImportError):  # Windows limits no memory
        import resource

        _, most = resource.getrlimit(resource.RLIMIT_AS)
        limit = most_bytes if most < 0 else min(most_bytes, most)
        resource.setrlimit(resource.RLIMIT_AS, (limit, most))


def _end_with_station() -> None:
    sys.stdin.buffer.read()
    with suppress(AttributeError, OSError):
        os.killpg(0, signal.SIGKILL)
    os._exit(1)


def step(text: Text, begin: float, end: float, progress: Progress) -> Progress:
    """Reports a piece of work, which is this part of the whole.

    Args:
        text: of the piece, where it does not say what it does itself.
    """
    return lambda share, now: progress(begin + (end - begin) * share, now or text)


if __name__ == "__main__":
    os._exit(_main())  # without waiting for the thread that reads stdin
