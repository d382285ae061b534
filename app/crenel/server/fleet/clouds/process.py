"""Makes a cloud in a process of its own, which can be ended at any time."""

import os
import signal
import threading
from collections.abc import Callable, Mapping
from multiprocessing import connection, get_context, parent_process
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from typing import Any, Literal

from crenel.batch.single_cloud import CloudOrder, make_cloud
from crenel.batch.task import Refusal
from crenel.errors import OperationError
from crenel.loops import start_worker
from crenel.messages.message import Text, message

LOOK_S = 0.2
END_S = 5.0
NICENESS = 10
"""A station on the same machine goes first."""

Take = Callable[[Literal["share", "note"], Any], None]
"""Called with the share that is done, or with a note for whoever waits."""


class CloudCancelledError(Exception):
    """Nobody wants the cloud any more, or the server ends."""


def make_in_process(
    order: CloudOrder, take: Take, is_cancelled: Callable[[], bool]
) -> Mapping[str, Any]:
    """Makes a cloud, unless it is there; returns when the process has ended.

    Returns:
        The fields of its ``RebuiltCloud``.

    Raises:
        OperationError: it cannot be made.
        CloudCancelledError: it was cancelled; something may be left half-written.
    """
    context = get_context("spawn")
    reports, sending = context.Pipe(duplex=False)
    process = context.Process(target=_work, args=(order, sending), daemon=True)
    with reports:
        process.start()
        sending.close()
        try:
            return _follow(process, reports, take, is_cancelled)
        finally:
            _end(process)


def _follow(
    process: BaseProcess, reports: Connection, take: Take, is_cancelled: Callable[[], bool]
) -> Mapping[str, Any]:
    while not is_cancelled():
        if not reports.poll(LOOK_S):
            continue
        try:
            kind, value = reports.recv()
        except EOFError:
            process.join(END_S)
            status = process.exitcode or 0
            raise OperationError(
                "cloud-process", message("fleet-cloud-process-ended", status=status)
            ) from None
        if kind == "made":
            made: Mapping[str, Any] = value
            return made
        if kind == "refused":
            assert isinstance(value, Refusal)
            raise value.error()
        take(kind, value)
    raise CloudCancelledError


def _end(process: BaseProcess) -> None:
    process.terminate()
    process.join(END_S)
    if process.exitcode is None:
        process.kill()
        process.join()


def _work(order: CloudOrder, sending: Connection) -> None:
    """What the process does."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # of the whole group; the server ends this
    os.nice(NICENESS)
    start_worker("server-watch", _end_with_server)
    lock = threading.Lock()

    def send(kind: str, value: object) -> None:
        with lock:
            sending.send((kind, value))

    def say(text: Text) -> None:
        send("note", text)

    try:
        made = make_cloud(order, lambda share: send("share", share), say)
    except OperationError as error:
        send("refused", Refusal.of(error))
    else:
        send("made", dict(made))


def _end_with_server() -> None:
    """A server that is killed ends nobody."""
    server = parent_process()
    assert server is not None
    connection.wait([server.sentinel])
    os._exit(1)
