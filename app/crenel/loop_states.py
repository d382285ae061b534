"""What becomes of the program's loops: how often one failed and why, and whether one stands still.

A loop stands still if its turn shows no sign of life for longer than the loop states. What a turn
may wait for without end, a device or an order, it declares by ``waiting``; a long turn that goes on
says so by ``note_progress``.
"""

import asyncio
import logging
import os
import sys
import time
import traceback
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, replace
from importlib.util import find_spec
from pathlib import Path
from types import FrameType
from typing import Any

from crenel.errors import OperationError
from crenel.messages.message import Text, message, quantity

log = logging.getLogger(__name__)
FAILING_S = 5.0
"""A loop fails now if its last step failed, less than this ago; a step may take longer."""
CALM_S = 60.0
"""An error is logged again after a loop has worked for this long."""
LONGEST_TURN_S = 10.0
"""A loop whose turn shows no sign of life for longer than this stands still, unless it states
another time."""
MOST_KINDS = 20
LONGEST_ERROR = 200
FRAMES = 16
"""Number of innermost stack frames that are logged."""
OWN = tuple(
    str(Path(spec.origin).parent) + os.sep
    for spec in map(find_spec, ("crenel", "crenel_hardware"))
    if spec and spec.origin
)
"""The folders of the program's own code."""


@dataclass(frozen=True, slots=True)
class LoopFailure:
    """What failed, why, and when (``time.monotonic``)."""

    name: str
    error: Text
    at_s: float


@dataclass(frozen=True, slots=True)
class LoopHang:
    """A turn that stood still."""

    where: str
    """The innermost function of the program in which it stood, with its file and line."""
    stood_s: float
    at_s: float
    """When it was last seen to stand (``time.monotonic``)."""
    is_now: bool


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
    hangs: int = 0
    """Since the program began."""
    hang: LoopHang | None = None
    """One that stands now, or the newest."""

    @property
    def stands(self) -> bool:
        """Whether one of them stands still now."""
        return self.hang is not None and self.hang.is_now


class Supervision:
    """What becomes of the steps of one loop.

    Used by the thread or task of the loop; ``LoopRegistry.find_hangs`` looks at it from outside.

    Args:
        longest_s: a turn without a sign of life for longer than this stands still.
    """

    def __init__(self, name: str, longest_s: float = LONGEST_TURN_S) -> None:
        self.name, self.longest_s = name, longest_s
        self.signs = 0
        """Counts the signs of life so far."""
        self.is_in_turn = False
        self.thread: int | None = None
        """Ident of the thread that does the present step; of a task, None if it awaits something
        else."""
        self.task: asyncio.Task[Any] | None = None
        self.hangs = 0
        self.hang: LoopHang | None = None
        self.failures = 0
        self.newest: LoopFailure | None = None
        self._failed_last = False
        self._logged: set[str] = set()

    @property
    def is_failing(self) -> bool:
        return self._failed_last and not self._has_worked_for(FAILING_S)

    def go_on(self) -> None:
        """A turn begins, or is not over yet."""
        self.signs += 1
        self.is_in_turn = True

    def rest(self) -> None:
        """The turn is over, or waits for something."""
        self.signs += 1
        self.is_in_turn = False

    def note_success(self) -> None:
        """A step has ended well."""
        self.rest()
        self._failed_last = False
        if self._logged and self._has_worked_for(CALM_S):
            self._logged.clear()
            log.info(message("log-loop-works-again", name=self.name))

    def note_failure(self, error: BaseException) -> None:
        """A step has ended with an error; each kind of error is logged once until all is well."""
        self.rest()
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

    def note_standing(self, stood_s: float, now_s: float) -> None:
        """Its turn has stood still for too long; it is logged once."""
        if self.hang is not None and self.hang.is_now:
            self.hang = replace(self.hang, stood_s=stood_s, at_s=now_s)
            return
        stack = self._stack()
        self.hangs += 1
        self.hang = LoopHang(_place(stack), stood_s, now_s, True)
        stood, more = quantity(stood_s, "s"), {"trace": "".join(stack.format())}
        text = message("log-loop-stands", name=self.name, stood=stood, where=self.hang.where)
        log.error(text, extra=more)

    def note_moving(self) -> None:
        """Its turn does not stand still, or not any more."""
        if self.hang is not None and self.hang.is_now:
            self.hang = replace(self.hang, is_now=False)
            stood = quantity(self.hang.stood_s, "s")
            log.warning(message("log-loop-goes-on", name=self.name, stood=stood))

    def _stack(self) -> traceback.StackSummary:
        """What the loop does now, the innermost call last."""
        ident = self.thread
        frames = _frames_of_task(self.task) if ident is None else _frames_of_thread(ident)
        return traceback.StackSummary.extract((one, one.f_lineno) for one in frames[-FRAMES:])

    def _has_worked_for(self, seconds: float) -> bool:
        return self.newest is None or time.monotonic() - self.newest.at_s > seconds


PRESENT_LOOP: ContextVar[Supervision | None] = ContextVar("loop", default=None)
"""The loop of this thread or task; None if it is of none."""


def note_progress() -> None:
    """The turn of this thread's or task's loop takes long, and goes on."""
    if (loop := PRESENT_LOOP.get()) is not None:
        loop.go_on()


@contextmanager
def waiting() -> Iterator[None]:
    """Within it, the loop of this thread or task waits for what may never come."""
    loop = PRESENT_LOOP.get()
    if loop is not None:
        loop.rest()
    try:
        yield
    finally:
        if loop is not None:
            loop.go_on()


def error_text(error: BaseException) -> Text:
    """An error in a line; of an unexpected one, its kind too."""
    if isinstance(error, OperationError):
        return error.text
    return f"{type(error).__name__}: {error}"[:LONGEST_ERROR]


def _frames_of_thread(ident: int) -> list[FrameType]:
    innermost = sys._current_frames().get(ident)
    return [] if innermost is None else [one for one, _ in traceback.walk_stack(innermost)][::-1]


def _frames_of_task(task: asyncio.Task[Any] | None) -> list[FrameType]:
    """The frames of what the task awaits, and what that awaits."""
    frames: list[FrameType] = []
    awaited: Any = None if task is None else task.get_coro()
    while awaited is not None:
        frame = getattr(awaited, "cr_frame", None)
        frames += [] if frame is None else [frame]
        awaited = getattr(awaited, "cr_await", None)
    return frames


def _place(stack: Sequence[traceback.FrameSummary]) -> str:
    """The innermost function of the program, with its file and line."""
    own = [one for one in stack if one.filename.startswith(OWN)]
    for one in (own or stack)[-1:]:
        return f"{one.name}, {Path(one.filename).name}:{one.lineno}"
    return "?"


def _kind(error: BaseException) -> str:
    """The kind of an error and the line that raised it."""
    at = error.__traceback__
    while at is not None and at.tb_next is not None:
        at = at.tb_next
    place = "" if at is None else f"{at.tb_frame.f_code.co_filename}:{at.tb_lineno}"
    code = error.code if isinstance(error, OperationError) else ""
    return f"{type(error).__name__} {code} {place}"


def merge_states(
    name: str, known: LoopState | None, supervision: Supervision, running: int
) -> LoopState:
    """What is known of a name, with one loop more."""
    hang = supervision.hang
    found = LoopState(
        name,
        running,
        supervision.failures,
        supervision.is_failing and bool(running),
        supervision.newest,
        supervision.hangs,
        hang,
    )
    if known is None:
        return found
    newest = [one for one in (known.newest, found.newest) if one is not None]
    hangs = [one for one in (known.hang, hang) if one is not None]
    return LoopState(
        name,
        known.running + running,
        known.failures + found.failures,
        known.failing or found.failing,
        max(newest, key=lambda one: one.at_s, default=None),
        known.hangs + found.hangs,
        max(hangs, key=lambda one: (one.is_now, one.at_s), default=None),
    )
