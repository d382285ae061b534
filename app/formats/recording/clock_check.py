"""Clock faults that the time stamps of a recording reveal: gaps, and jumps."""

from array import array
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Stamps = NDArray[np.int64]

JUMP_NS = 100_000_000
"""A jump: a stamp that goes back by this, or deviates by this from the time at which it was
logged."""
HOLE_PERIODS = 1.5
"""If stamps are further apart than this multiple of the usual period, samples are missing."""


@dataclass(frozen=True)
class ClockReport:
    """Faults in the time stamps of one device."""

    holes: int
    """Number of gaps."""
    missing: int
    """Approximate number of missing samples, by the usual period."""
    longest_ns: int
    """Of the gaps."""
    longest_at_ns: int
    """The last stamp before the longest gap."""
    jumps: int
    """Number of times that the clock was set back or forward."""
    first_jump_at_ns: int


class ClockWatch:
    """Checks the stamps of one device in the order of the file."""

    def __init__(self) -> None:
        self._stamps_ns = array("q")
        self._last: tuple[int, int] | None = None
        self._jumps = 0
        self._first_jump_at_ns = 0

    def add(self, stamps_ns: Stamps, log_ns: Stamps) -> None:
        """Adds stamps (J,) and the times (J,) at which their messages were logged."""
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
        """The faults in all stamps so far."""
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
