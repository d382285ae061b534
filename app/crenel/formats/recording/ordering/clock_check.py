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
    """The longest of the gaps."""
    longest_at_ns: int
    """The last stamp before the longest gap."""
    jumps: int
    """Number of times that the clock was set back or forward."""
    first_jump_at_ns: int


class ClockWatch:
    """Checks the stamps of one device, in the order of the file or in which they were logged."""

    def __init__(self) -> None:
        self._stamps_ns = array("q")
        self._log_ns = array("q")

    def add(self, stamps_ns: Stamps, log_ns: Stamps) -> None:
        """Adds stamps (J,) and the times (J,) at which their messages were logged."""
        for kept, times_ns in ((self._stamps_ns, stamps_ns), (self._log_ns, log_ns)):
            kept.frombytes(np.ascontiguousarray(times_ns, np.int64).tobytes())

    def report(self, as_logged: bool = False) -> ClockReport:
        """The faults in all stamps so far.

        Args:
            as_logged: whether the order in which they were logged counts, not that of the file.
        """
        stamps_ns, log_ns = np.array(self._stamps_ns), np.array(self._log_ns)
        if as_logged:
            order = np.lexsort((stamps_ns, log_ns))
            stamps_ns, log_ns = stamps_ns[order], log_ns[order]
        step, logged = np.diff(stamps_ns), np.diff(log_ns)
        odd = np.flatnonzero((step < -JUMP_NS) | (np.abs(step - logged) > JUMP_NS))
        jumps = len(odd), int(stamps_ns[odd[0] + 1]) if len(odd) else 0
        known_ns = np.unique(stamps_ns)
        steps = np.diff(known_ns)
        if len(steps) < 3:
            return ClockReport(0, 0, 0, 0, *jumps)
        period = float(np.median(steps))
        holes = steps > HOLE_PERIODS * period
        longest = int(np.argmax(steps))
        return ClockReport(
            holes=int(holes.sum()),
            missing=int((np.rint(steps[holes] / period) - 1).sum()),
            longest_ns=int(steps[longest]) if holes.any() else 0,
            longest_at_ns=int(known_ns[longest]) if holes.any() else 0,
            jumps=jumps[0],
            first_jump_at_ns=jumps[1],
        )
