"""Watches the event loop: how often, how long and by what it was blocked."""

import asyncio
import logging
import sys
import threading
import time
import traceback
from dataclasses import dataclass, replace

from crenel.loop_states import note_progress
from crenel.loops import Loop
from crenel.messages.message import message, quantity
from crenel.timestamps import utc_now

log = logging.getLogger(__name__)
LIMIT_S = 0.25
"""If the loop is blocked for longer than this, live values visibly freeze."""
PERIOD_S = 0.1
FRAMES = 16
"""Number of innermost stack frames that are logged."""
PAUSE_S = 0.75
"""If the watchdog thread itself wakes up this late, the whole program was blocked, not only the
loop."""


@dataclass(frozen=True)
class Stalls:
    """The stalls since the start."""

    count: int = 0
    longest_s: float = 0.0
    last_s: float = 0.0
    last_at: str = ""
    last_stack: str = ""
    pauses: int = 0
    """Number of times that the whole program was blocked: the machine was busy, suspended or short
    of memory."""
    longest_pause_s: float = 0.0


class LoopWatchdog:
    """A thread that expects an answer of the loop ten times a second.

    If there is none within ``limit_s``, it counts a stall and logs the stack of the loop's thread.
    """

    def __init__(self, limit_s: float = LIMIT_S) -> None:
        self._limit_s = limit_s
        self._stalls = Stalls()
        self._stopping = threading.Event()
        self._loop: Loop | None = None

    @property
    def stalls(self) -> Stalls:
        return self._stalls

    @property
    def limit_s(self) -> float:
        return self._limit_s

    def start(self, loop: asyncio.AbstractEventLoop) -> None:
        """Watches the loop of the calling thread."""
        self._stopping.clear()
        watched = threading.get_ident()
        self._loop = Loop("loop-watchdog", lambda: self._look(loop, watched), ending=self._stopping)
        self._loop.start()

    def stop(self) -> None:
        if self._loop is not None:
            self._loop.stop(2.0)
            self._loop = None

    def _look(self, loop: asyncio.AbstractEventLoop, watched: int) -> None:
        answered = threading.Event()
        asked_s = time.monotonic()
        try:
            loop.call_soon_threadsafe(answered.set)
        except RuntimeError:  # the loop was closed
            self._stopping.set()
            return
        if not answered.wait(self._limit_s):
            self._note_stall(asked_s, answered, watched)
        woke_s = time.monotonic()
        self._stopping.wait(PERIOD_S)
        self._note_pause(time.monotonic() - woke_s - PERIOD_S)

    def _note_stall(self, asked_s: float, answered: threading.Event, watched: int) -> None:
        late_s = time.monotonic() - asked_s - self._limit_s
        if late_s > PAUSE_S:
            self._note_pause(late_s)
            return
        frame = sys._current_frames().get(watched)
        stack = "".join(traceback.format_stack(frame, FRAMES)) if frame is not None else ""
        limit_s, more = self._limit_s, {"trace": stack}
        limit = quantity(limit_s, "s", 2)
        log.warning(message("log-event-loop-held-up", limit=limit), extra=more)
        while not answered.wait(PERIOD_S) and not self._stopping.is_set():
            note_progress()
        lasted_s = time.monotonic() - asked_s
        log.warning(message("log-event-loop-goes-on", duration=quantity(lasted_s, "s", 2)))
        self._stalls = replace(
            self._stalls,
            count=self._stalls.count + 1,
            longest_s=max(self._stalls.longest_s, lasted_s),
            last_s=lasted_s,
            last_at=utc_now(),
            last_stack=stack,
        )

    def _note_pause(self, late_s: float) -> None:
        if late_s <= PAUSE_S:
            return
        log.warning(message("log-program-stood-still", duration=quantity(late_s, "s", 2)))
        self._stalls = replace(
            self._stalls,
            pauses=self._stalls.pauses + 1,
            longest_pause_s=max(self._stalls.longest_pause_s, late_s),
        )
