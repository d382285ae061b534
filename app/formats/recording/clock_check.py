"""What the stamps of a recording show of its clocks: holes, and jumps."""

from array import array
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Stamps = NDArray[np.int64]

JUMP_NS = 100_000_000
"""By so much a stamp goes back, or runs apart from the time it was logged at, in a jump."""
HOLE_PERIODS = 1.5
"""Further apart than so many of the usual periods, something between is missing."""


@dataclass(frozen=True)
class ClockReport:
    """What is odd about the stamps of one device."""

    holes: int
    """Places where samples are missing."""
    missing: int
    """About how many of them, by the usual period."""
    longest_ns: int
    """Of the holes."""
    longest_at_ns: int
    """The last stamp before it."""
    jumps: int
    """Places where the clock was set back or forth."""
    first_jump_at_ns: int


class ClockWatch:
    """Looks at the stamps of one device in the order of the file."""

    def __init__(self) -> None:
        self._stamps_ns = array("q")
        self._last: tuple[int, int] | None = None
        self._jumps = 0
        self._first_jump_at_ns = 0

    def add(self, stamps_ns: Stamps, log_ns: Stamps) -> None:
        """Takes stamps (J,) and the times (J,) at which their messages were logged."""
        if not len(stamps_ns):
            return
        before = self._last or (int(stamps_ns[0]), int(log_ns[0]))
        step = np.diff(stamps_ns, prepend=before[0])
        logged = np.diff(log_ns, prepend=before[1])
        odd = (step < -JUMP_NS) | (np.abs(step - logged) > JUMP_NS)
        if odd.any():
            if not self._jumps:
                self._first_jump_at_ns = int(stamps_ns[np.argmax(odd)])
            self._jumps += int(odd.sum())
        self._last = int(stamps_ns[-1]), int(log_ns[-1])
        self._stamps_ns.frombytes(np.ascontiguousarray(stamps_ns, np.int64).tobytes())

    def report(self) -> ClockReport:
        """What was found in all stamps so far."""
        steps = np.diff(np.unique(np.array(self._stamps_ns)))
        if len(steps) < 3:
            return ClockReport(0, 0, 0, 0, self._jumps, self._first_jump_at_ns)
        period = float(np.median(steps))
        holes = steps > HOLE_PERIODS * period
        longest = int(np.argmax(steps))
        at_ns = int(np.unique(np.array(self._stamps_ns))[longest])
        return ClockReport(
            holes=int(holes.sum()),
            missing=int((np.rint(steps[holes] / period) - 1).sum()),
            longest_ns=int(steps[longest]) if holes.any() else 0,
            longest_at_ns=at_ns if holes.any() else 0,
            jumps=self._jumps,
            first_jump_at_ns=self._first_jump_at_ns,
        )
