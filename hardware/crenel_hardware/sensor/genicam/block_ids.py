"""Unwraps the numbers that a camera gives its pictures."""

from collections import deque
from itertools import pairwise

_WRAP = 0xFFFF
"""GigE Vision 1 counts from 1 to 65535 and then from 1 again: 0 is not a picture."""
_LATE = 0x7FFF
_MOST_LATE = 64
_MOST_LATE_NS = 5_000_000_000
"""A picture that is behind by more than one of these is no late one: the host has fewer buffers,
and waits less for missing packets."""
_KEPT = 16


class BlockCounter:
    """Counts a camera's pictures from the block ids in its stream, lost ones included.

    Block ids have 16 bits in GigE Vision 1, and 64 bits in GigE Vision 2 and USB3 Vision. The
    width is not announced here: an id above 65535 shows that it is 64.

    An id of 16 bits that falls back has three causes: the count wrapped, the picture is a late
    one, or the camera began to count again. The camera's time stamps decide, where it has them.

    Source:
        AIA, GigE Vision 2.0, sections 24.2 (block_id) and 24.3 (block_id64).
    """

    def __init__(self) -> None:
        self._last: int | None = None
        self._count = -1
        self._long = False
        self._stamped: deque[tuple[int, int]] = deque(maxlen=_KEPT)
        """Number and stamp of the last pictures that had both."""

    def restart(self) -> None:
        """The camera was stopped, and counts from the beginning: its next picture follows the last
        one."""
        self._last, self._long = None, False
        self._stamped.clear()

    def count(self, block_id: int, whole: bool = True, stamp_ns: int | None = None) -> int | None:
        """The number of a picture, from 0 at the first one; None of a repeated or late one.

        An incomplete picture may have the id 0, which says that its id did not arrive; it has no
        number, either. Its place in the count shows by the next one.
        The picture after a new start of the camera's count is the next one: what was lost in
        between is not known.

        Args:
            stamp_ns: of a whole picture, by the camera's clock, if it has one.
        """
        if block_id == 0 and not whole:
            return None
        self._long |= block_id > _WRAP
        step = self._step(block_id, stamp_ns)
        if step is None:
            return None
        self._last = block_id
        self._count += step
        if stamp_ns is not None:
            self._stamped.append((self._count, stamp_ns))
        return self._count

    def _step(self, block_id: int, stamp_ns: int | None) -> int | None:
        """By how much the count rises; None if it does not."""
        last = self._last
        if last is None:
            return 1
        if self._long:
            return None if block_id == last else max(block_id - last, 1)
        step = (block_id - last) % _WRAP
        if step == 0:
            return None
        is_late = step > _LATE
        if block_id < last and self._began_again(step - _WRAP if is_late else step, stamp_ns):
            self._stamped.clear()
            return 1
        return None if is_late else step

    def _began_again(self, step: int, stamp_ns: int | None) -> bool:
        """Whether the stamps contradict so many pictures ahead, or behind if negative."""
        if stamp_ns is None or len(self._stamped) < 2:
            return False
        last, last_ns = self._stamped[-1]
        passed_ns = stamp_ns - last_ns
        if step > 0:
            # the shortest interval seen: a triggered camera may pause, but not count ahead
            shortest_ns = min((b - a) // (n - m) for (m, a), (n, b) in pairwise(self._stamped))
            ahead = self._count + step - last
            return passed_ns <= 0 or passed_ns < ahead * shortest_ns // 2
        return passed_ns > 0 or passed_ns < -_MOST_LATE_NS or -step > _MOST_LATE
