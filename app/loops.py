"""The one way to run what works for long: each loop has a thread or task, and none dies unnoticed.

A loop calls its step again and again. A step that fails is called again a moment later; its error
is logged once, and *Health* and the metrics know of it. A worker does one thing and ends. What an
error ends in any other thread or task, ``reporting_deaths`` reports.
"""

import asyncio
import logging
import threading
import time
from collections import deque
from collections.abc import Awaitable, Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

from app.errors import OperationError
from app.messages.message import Text, message

log = logging.getLogger(__name__)
RESTART_S = 0.3
"""After a failed step, the next one begins this much later."""
FAILING_S = 5.0
"""A loop fails now if its last step failed, less than this ago; a step may take longer."""
CALM_S = 60.0
"""An error is logged again after a loop has worked for this long."""
MOST_KINDS, MOST_DEATHS = 20, 100
LONGEST_ERROR = 200


@dataclass(frozen=True, slots=True)
class LoopFailure:
    """What failed, why, and when (``time.monotonic``)."""

    name: str
    error: Text
    at_s: float


@dataclass(frozen=True, slots=True)
class LoopState:
    """All loops of one name: one for each sensor has the same name."""

    name: str
    running: int
    failures: int
    """Since the program began, also of loops that have ended."""
    failing: bool
    """Whether one of them fails now."""
    newest: LoopFailure | None


class Supervision:
    """What becomes of the steps of one loop; used by the thread or task of the loop alone."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.failures = 0
        self.newest: LoopFailure | None = None
        self._failed_last = False
        self._logged: set[str] = set()

    @property
    def is_failing(self) -> bool:
        return self._failed_last and not self._has_worked_for(FAILING_S)

    def note_success(self) -> None:
        """A step has ended well."""
        self._failed_last = False
        if self._logged and self._has_worked_for(CALM_S):
            self._logged.clear()
            log.info(message("log-loop-works-again", name=self.name))

    def note_failure(self, error: BaseException) -> None:
        """A step has ended with an error; each kind of error is logged once until all is well."""
        self._failed_last = True
        self.failures += 1
        self.newest = LoopFailure(self.name, error_text(error), time.monotonic())
        kind = _kind(error)
        if kind in self._logged or len(self._logged) >= MOST_KINDS:
            return
        self._logged.add(kind)
        if isinstance(error, OperationError):  # of a disk, a device, a file: Health shows it
            text = message("log-loop-refused", name=self.name, reason=error.text)
            log.warning(text)
        else:
            log.error(message("log-loop-failed", name=self.name), exc_info=error)

    def _has_worked_for(self, seconds: float) -> bool:
        return self.newest is None or time.monotonic() - self.newest.at_s > seconds


class LoopRegistry:
    """All loops of the program, and the threads and tasks that an error has ended."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._running: set[Supervision] = set()
        self._ended: dict[str, LoopState] = {}
        self._deaths: deque[LoopFailure] = deque(maxlen=MOST_DEATHS)
        self.death_count = 0

    @contextmanager
    def supervising(self, name: str) -> Iterator[Supervision]:
        """A loop of this name runs while such a block is open."""
        supervision = Supervision(name)
        with self._lock:
            self._running.add(supervision)
        try:
            yield supervision
        finally:
            with self._lock:
                self._running.discard(supervision)
                self._ended[name] = _merge(name, self._ended.get(name), supervision, 0)

    def states(self) -> Sequence[LoopState]:
        """Every loop that runs or has run, by its name."""
        with self._lock:
            found = dict(self._ended)
            for one in self._running:
                found[one.name] = _merge(one.name, found.get(one.name), one, 1)
        return [found[name] for name in sorted(found)]

    def deaths(self) -> Sequence[LoopFailure]:
        """The last threads and tasks that an error has ended, the newest last."""
        with self._lock:
            return tuple(self._deaths)

    def note_death(self, name: str, error: BaseException) -> None:
        """Reports a thread or task that an error has ended."""
        with self._lock:
            self._deaths.append(LoopFailure(name, error_text(error), time.monotonic()))
            self.death_count += 1
        log.error(message("log-thread-died", name=name), exc_info=error)


LOOPS = LoopRegistry()
"""The loops of the program."""


class Loop:
    """Calls a step again and again on a thread of its own, until it is stopped.

    Args:
        name: of the thread.
        step: one round; may return the pause before the next one, otherwise it is ``period_s``.
            A step that waits for something returns when ``ending`` is set and it is woken.
        ending: an event of the caller's that ends the loop.
    """

    def __init__(
        self,
        name: str,
        step: Callable[[], float | None],
        period_s: float = 0.0,
        ending: threading.Event | None = None,
    ) -> None:
        self.ending = threading.Event() if ending is None else ending
        self._name, self._step, self._period_s = name, step, period_s
        self._error: BaseException | None = None
        self._thread = threading.Thread(target=self._run, name=name, daemon=True)

    def start(self) -> None:
        self._thread.start()

    def stop(
        self, timeout_s: float | None = 5.0, wake: Callable[[], object] = lambda: None
    ) -> None:
        """Ends the loop after the present step; ``wake`` ends what the step waits for."""
        self.ending.set()
        wake()
        if self._thread.ident is not None:
            self._thread.join(timeout_s)

    def is_alive(self) -> bool:
        return self._thread.is_alive()

    def _run(self) -> None:
        with LOOPS.supervising(self._name) as supervision:
            while not self.ending.is_set():
                try:
                    self._advance(supervision)
                except BaseException as error:  # noted in the next round, where it may fail again
                    self._error = error

    def _advance(self, supervision: Supervision) -> None:
        if self._error is not None:
            error, self._error = self._error, None
            supervision.note_failure(error)
            self.ending.wait(RESTART_S)
        else:
            pause_s = self._step()
            supervision.note_success()
            if pause_s is None:
                pause_s = self._period_s
            if pause_s > 0:
                self.ending.wait(pause_s)


def start_worker(name: str, work: Callable[..., object], *args: Any) -> threading.Thread:
    """Does one thing in a thread of its own, which ends with it."""
    thread = threading.Thread(target=work, args=args, name=name, daemon=True)
    thread.start()
    return thread


async def repeat(
    name: str, *steps: Callable[[], Awaitable[object]], period_s: float = RESTART_S
) -> None:
    """Awaits steps one after the other, again and again, until cancelled.

    A step that fails stops no other.
    """
    with LOOPS.supervising(name) as supervision:
        while True:
            failures = supervision.failures
            for step in steps:
                try:
                    await step()
                except (Exception, asyncio.CancelledError) as error:
                    if _is_cancelled():
                        raise
                    supervision.note_failure(error)
            if supervision.failures == failures:
                supervision.note_success()
                await asyncio.sleep(period_s)
            else:
                await asyncio.sleep(max(period_s, RESTART_S))


@contextmanager
def reporting_deaths() -> Iterator[None]:
    """Reports every thread, and every task of the running event loop, that an error ends.

    Used on the event loop.
    """
    loop = asyncio.get_running_loop()
    hook_before, handler_before = threading.excepthook, loop.get_exception_handler()

    def note_thread(died: threading.ExceptHookArgs) -> None:
        error = died.exc_value if died.exc_value is not None else died.exc_type()
        LOOPS.note_death(died.thread.name if died.thread is not None else "?", error)
        if hook_before is not threading.__excepthook__:
            hook_before(died)

    def note_task(loop: asyncio.AbstractEventLoop, about: dict[str, Any]) -> None:
        task, error = about.get("task") or about.get("future"), about.get("exception")
        if error is None or task is None:
            loop.default_exception_handler(about)
            return
        LOOPS.note_death(getattr(task.get_coro(), "__qualname__", "task"), error)

    threading.excepthook = note_thread
    loop.set_exception_handler(note_task)
    try:
        yield
    finally:
        threading.excepthook = hook_before
        loop.set_exception_handler(handler_before)


def error_text(error: BaseException) -> Text:
    """An error in a line; of an unexpected one, its kind too."""
    if isinstance(error, OperationError):
        return error.text
    return f"{type(error).__name__}: {error}"[:LONGEST_ERROR]


def _is_cancelled() -> bool:
    task = asyncio.current_task()
    return task is not None and task.cancelling() > 0


def _kind(error: BaseException) -> str:
    """The kind of an error and the line that raised it."""
    at = error.__traceback__
    while at is not None and at.tb_next is not None:
        at = at.tb_next
    place = "" if at is None else f"{at.tb_frame.f_code.co_filename}:{at.tb_lineno}"
    code = error.code if isinstance(error, OperationError) else ""
    return f"{type(error).__name__} {code} {place}"


def _merge(name: str, known: LoopState | None, supervision: Supervision, running: int) -> LoopState:
    """What is known of a name, with one loop more."""
    failing = supervision.is_failing and bool(running)
    if known is None:
        return LoopState(name, running, supervision.failures, failing, supervision.newest)
    both = [one for one in (known.newest, supervision.newest) if one is not None]
    return LoopState(
        name,
        known.running + running,
        known.failures + supervision.failures,
        known.failing or failing,
        max(both, key=lambda one: one.at_s, default=None),
    )
