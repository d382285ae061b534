"""A station that serves in a process of its own."""

import contextlib
import multiprocessing
from collections.abc import Callable, Iterator
from multiprocessing.connection import Connection

PATIENCE_S = 120.0


@contextlib.contextmanager
def apart(serve: Callable[..., None], *arguments: object) -> Iterator[tuple[Connection, int]]:
    """Calls ``serve`` with a pipe and the arguments in a new process; ends it at the end.

    Yields our end of the pipe, once something has come through it, and the process's id.

    Raises:
        TimeoutError: nothing came.
    """
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe()
    process = context.Process(target=serve, args=(theirs, *arguments), daemon=True)
    process.start()
    try:
        if not ours.poll(PATIENCE_S):
            raise TimeoutError("the station does not start")
        yield ours, process.pid or 0
        ours.send("stop")
        process.join(20.0)
    finally:
        process.kill()
