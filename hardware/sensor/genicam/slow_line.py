"""Notices a line that carries pictures more slowly than the camera takes them.

Until the camera's memory is full, no picture is lost: the pictures only come later and later, and
the first gap in their numbers is seen when the memory has been sent. This shows it before.
"""

_LATE_NS = 100_000_000
"""A picture that arrives later than this after its exposure has waited somewhere."""
_HELD_UP = 1.5
"""The time from one arrival to the next, in times from one exposure to the next."""
_IN_A_ROW = 3
"""A computer that is busy for a moment holds up one picture, and the next ones follow at once."""


class SlowLine:
    """Judges the pictures of one camera in the order in which they arrive."""

    def __init__(self) -> None:
        self._last: tuple[int, int] | None = None
        self._held_up = 0

    def holds_up(self, exposed_ns: int, arrival_ns: int) -> bool:
        """Whether a picture is late, because the line was busy with the ones before it.

        Args:
            exposed_ns: host time of the end of its exposure.
            arrival_ns: host time at which its first packet arrived.
        """
        last, self._last = self._last, (exposed_ns, arrival_ns)
        if last is None:
            return False
        taken_ns, came_ns = exposed_ns - last[0], arrival_ns - last[1]
        self._held_up = self._held_up + 1 if came_ns > _HELD_UP * taken_ns > 0 else 0
        return self._held_up >= _IN_A_ROW and arrival_ns - exposed_ns > _LATE_NS
