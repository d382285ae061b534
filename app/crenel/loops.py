"""The one way to run what works for long: each loop has a thread or task, and none dies unnoticed.

A loop calls its step again and again. A step that fails is called again a moment later; its error
is logged once, and *Health* and the metrics know of it. A worker does one thing and ends. What an
error ends in any other thread or task, ``reporting_deaths`` reports; what stands still,
``naming_hangs`` names.
"""

import asyncio
import logging
import threading
import time
from collections import deque
from collections.abc import Awaitable, Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any, TypeVar

from crenel.loop_states import (
    LONGEST_TURN_S,
    PRESENT_LOOP,
    LoopFailure,
    LoopState,
    Supervision,
    error_text,
    merge_states,
)
from crenel.messages.message import message

log = logging.getLogger(__name__)
RESTART_S = 0.3
"""After a failed step, the next one begins this much later."""
LOOK_S = 0.5
"""Between two looks for loops that stand still."""
MOST_PASSED_S = 1.0
"""Between two looks, no more is counted: the program was suspended, or the machine was busy."""
MOST_DEATHS = 100
T = TypeVar("T")


class LoopRegistry:
    """All loops of the program, and the threads and tasks that an error has ended."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._running: set[Supervision] = set()
        self._ended: dict[str, LoopState] = {}
        self._stood: dict[Supervision, tuple[int, float]] = {}
        """Signs of life of each loop at the last look, and for how long there was no other."""
        self._looked_s: float | None = None
        self._deaths: deque[LoopFailure] = deque(maxlen=MOST_DEATHS)
        self.death_count = 0

    @contextmanager
    def supervising(self, supervision: Supervision) -> Iterator[Supervision]:
        """This loop runs, in this thread or task, while such a block is open."""
        name = supervision.name
        with self._lock:
            self._running.add(supervision)
        token = PRESENT_LOOP.set(supervision)
        try:
            yield supervision
        finally:
            PRESENT_LOOP.reset(token)
            supervision.note_moving()
            with self._lock:
                self._running.discard(supervision)
                self._ended[name] = merge_states(name, self._ended.get(name), supervision, 0)

    def find_hangs(self, now_s: float) -> None:
        """Notes which loops stand still; called again and again, by one thread.

        Args:
            now_s: of a clock like ``time.monotonic``.
        """
        passed_s = 0.0 if self._looked_s is None else min(now_s - self._looked_s, MOST_PASSED_S)
        self._looked_s = now_s
        with self._lock:
            running = tuple(self._running)
        before, self._stood = self._stood, {}
        for one in running:
            signs = one.signs
            known, stood_s = before.get(one, (signs, 0.0))
            stood_s = stood_s + passed_s if one.is_in_turn and signs == known else 0.0
            self._stood[one] = signs, stood_s
            if stood_s > one.longest_s:
                one.note_standing(stood_s, now_s)
            else:
                one.note_moving()

    def states(self) -> Sequence[LoopState]:
        """Every loop that runs or has run, by its name."""
        with self._lock:
            found = dict(self._ended)
            for one in self._running:
                found[one.name] = merge_states(one.name, found.get(one.name), one, 1)
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
            A step that waits for something declares it by ``waiting``, and returns when ``ending``
            is set and it is woken.
        ending: an event of the caller's that ends the loop.
        longest_s: a step without a sign of life for longer than this stands still.
    """

    def __init__(
        self,
        name: str,
        step: Callable[[], float | None],
        period_s: float = 0.0,
        ending: threading.Event | None = None,
        longest_s: float = LONGEST_TURN_S,
    ) -> None:
        self.ending = threading.Event() if ending is None else ending
        self._name, self._step, self._period_s = name, step, period_s
        self._longest_s = longest_s
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
        with LOOPS.supervising(Supervision(self._name, self._longest_s)) as supervision:
            supervision.thread = threading.get_ident()
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
            supervision.go_on()
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
    name: str,
    *steps: Callable[[], Awaitable[object]],
    period_s: float = RESTART_S,
    longest_s: float = LONGEST_TURN_S,
) -> None:
    """Awaits steps one after the other, again and again, until cancelled.

    A step that fails stops no other; one without a sign of life for longer than ``longest_s``
    stands still.
    """
    with LOOPS.supervising(Supervision(name, longest_s)) as supervision:
        supervision.task = asyncio.current_task()
        while True:
            failures = supervision.failures
            for step in steps:
                supervision.go_on()
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


async def on_thread(work: Callable[[], T]) -> T:
    """Does a step's work on a thread; the loop's stack is then that thread's."""
    loop = PRESENT_LOOP.get()

    def do() -> T:
        if loop is None:
            return work()
        loop.thread = threading.get_ident()
        try:
            return work()
        finally:
            loop.thread = None

    return await asyncio.to_thread(do)


@contextmanager
def naming_hangs() -> Iterator[None]:
    """Within it, loops that stand still are named in the log, *Health* and the metrics."""
    watch = Loop("hang-watch", lambda: LOOPS.find_hangs(time.monotonic()), LOOK_S)
    watch.start()
    try:
        yield
    finally:
        watch.stop()


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


def _is_cancelled() -> bool:
    task = asyncio.current_task()
    return task is not None and task.cancelling() > 0
