"""The moves of the simulated operator: played one after another, with progress, and cancelled."""

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass

from crenel_hardware.clock import now_ns
from crenel_hardware.interfaces import Button
from crenel_hardware.simulator.devices.motion import HALT_S, JointPath, Motion

LEAD_NS = 4_000_000
SETTLE_S, PRESS_S = 0.36, 0.05


@dataclass(frozen=True)
class OperatorState:
    """What the simulated operator does now; ``progress`` is from 0 to 1."""

    activity: str = ""
    progress: float = 0.0

    @property
    def busy(self) -> bool:
        return self.activity != ""


class _CancelledError(Exception):
    """The move under way was cancelled."""


class MoveExecutor:
    """Plays the true arm's paths and presses its buttons, one move at a time.

    Any thread may read ``state`` and ``cancel``.

    Args:
        press: called with a button, whether it goes down, and when.
        halted: called after a move that was cancelled.
    """

    def __init__(
        self,
        motion: Motion,
        press: Callable[[Button, bool, int], None],
        halted: Callable[[], None],
    ) -> None:
        self._motion, self._press, self._after_cancel = motion, press, halted
        self._lock = threading.Lock()
        self._cancelled = threading.Event()
        self._state = OperatorState()

    @property
    def state(self) -> OperatorState:
        return self._state

    def cancel(self) -> None:
        """Makes the move under way stop smoothly and end; later moves are not affected."""
        self._cancelled.set()

    @contextmanager
    def move(self, activity: str) -> Iterator[None]:
        """Within it paths are played and buttons pressed; a cancelled one is left at once,
        and what stands after it goes on."""
        with self._lock:
            self._cancelled.clear()
            self._state = OperatorState(activity)
            try:
                yield
            except _CancelledError:
                self._motion.halt(now_ns())
                self._after_cancel()
                threading.Event().wait(HALT_S)
            finally:
                self._state = OperatorState()

    def play(self, path: JointPath, begin: float, end: float, trembles: bool = False) -> None:
        """Plays a path and waits for its end, reporting progress from ``begin`` to ``end``."""
        if self._cancelled.is_set():
            raise _CancelledError
        start_ns = now_ns() + LEAD_NS
        end_ns = self._motion.play(path, start_ns, trembles)
        while (left_s := (end_ns - now_ns()) / 1e9) > 0:
            done = 1 - min(left_s / path.duration_s, 1.0)
            self._state = OperatorState(self._state.activity, begin + done * (end - begin))
            if self._cancelled.wait(min(left_s, 0.05)):
                raise _CancelledError

    def press_primary(self) -> None:
        """Once the tip rests."""
        self._pause(SETTLE_S)
        pressed_ns = now_ns()
        self._press(Button.PRIMARY, True, pressed_ns)
        self._press(Button.PRIMARY, False, pressed_ns + round(PRESS_S * 0.8e9))
        self._pause(PRESS_S)

    def _pause(self, seconds: float) -> None:
        if self._cancelled.wait(seconds):
            raise _CancelledError
