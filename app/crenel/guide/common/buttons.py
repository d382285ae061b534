"""What the arm's buttons mean: the main one, the undo button, and the undo button held.

An arm may have a button of its own for back; on one that has none, undo is held.
"""

import contextlib
import logging
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Literal, Protocol, TypeVar

log = logging.getLogger(__name__)
T = TypeVar("T")
LONG_PRESS_S = 0.8
ButtonName = Literal["primary", "undo", "back"]


class ButtonEdge(Protocol):
    """A button of the arm going down or up."""

    @property
    def stamp_ns(self) -> int: ...
    @property
    def button(self) -> str: ...
    @property
    def pressed(self) -> bool: ...


@dataclass(frozen=True, slots=True)
class Press:
    """A press that counts; ``stamp_ns`` is when the button went down."""

    stamp_ns: int
    button: ButtonName


class Buttons:
    """Reports presses one after another, on a thread of its own.

    The main button counts as it goes down. The undo button counts as it is let go; held for
    ``LONG_PRESS_S`` it is back, at once, so that the operator hears when to let go.

    Args:
        on_press: called with each press.
        there: whether the arm is connected; a button that goes down with the cable pulled
            out is never let go, and means nothing.
    """

    def __init__(self, on_press: Callable[[Press], None], there: Callable[[], bool]) -> None:
        self._on_press, self._there = on_press, there
        self._worker = ThreadPoolExecutor(1, thread_name_prefix="buttons")
        self._pending: tuple[Press, threading.Timer] | None = None

    def edge(self, event: ButtonEdge) -> None:
        """From the thread that reads the arm; returns at once."""
        self._do_next(self._edge, event)

    def close(self) -> None:
        """Ends its thread once the presses so far are reported; later ones mean nothing."""
        self._worker.shutdown()
        if self._pending is not None:
            self._pending[1].cancel()

    def _do_next(self, act: Callable[[T], None], what: T) -> None:
        with contextlib.suppress(RuntimeError):  # closed meanwhile
            self._worker.submit(self._run_safely, act, what)

    @staticmethod
    def _run_safely(act: Callable[[T], None], what: T) -> None:
        """A press that fails ends no later one."""
        try:
            act(what)
        except Exception:
            log.exception("a press of the arm's button failed")

    def _edge(self, event: ButtonEdge) -> None:
        name = str(event.button)
        if name == "undo":
            if event.pressed:
                self._hold(event.stamp_ns)
            else:
                self._release(event.stamp_ns)
        elif event.pressed and (name == "primary" or name == "back"):
            self._on_press(Press(event.stamp_ns, "primary" if name == "primary" else "back"))

    def _hold(self, stamp_ns: int) -> None:
        press = Press(stamp_ns, "back")
        timer = threading.Timer(LONG_PRESS_S, self._do_next, (self._long, press))
        timer.daemon = True
        self._pending = (press, timer)
        timer.start()

    def _long(self, press: Press) -> None:
        if self._pending is not None and self._pending[0] is press:
            self._pending = None
            if self._there():
                self._on_press(press)

    def _release(self, stamp_ns: int) -> None:
        if self._pending is None:
            return  # it was back already
        press, timer = self._pending
        self._pending = None
        timer.cancel()
        long = stamp_ns - press.stamp_ns >= LONG_PRESS_S * 1e9
        self._on_press(press if long else Press(press.stamp_ns, "undo"))
