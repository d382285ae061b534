"""Notices a line that carries pictures more slowly than the camera takes them.

Until the camera's memory is full, no picture is lost: the pictures only come later and later, and
the first gap in their numbers is seen when the memory has been sent. Two signs show it before:

- Pictures are late, and each comes longer after the one before than it was exposed after it. This
  needs only the pictures, and some of them.
- Data arrive without a break, and fewer pictures are finished than the camera takes meanwhile.
  This needs a count of the bytes that arrived. It shows, before it has arrived, that a single
  picture takes too long.
"""

_LATE_NS = 100_000_000
"""A picture that arrives later than this after its exposure has waited somewhere."""
_HELD_UP = 1.5
"""The time from one arrival to the next, in times from one exposure to the next."""
_IN_A_ROW = 3
"""A computer that is busy for a moment holds up one picture, and the next ones follow at once."""
_WATCH_NS = 400_000_000
"""How long data arrive without a break before the pictures are counted."""
_LONGEST_LOOK_NS = 250_000_000
"""After a longer time without a look, the computer was busy, and what waited arrives at once."""
_FEWEST_PERIODS = 2
"""Pictures are counted over so many exposures, if these take longer."""


class SlowLine:
    """Judges the pictures of one camera in the order in which they arrive."""

    def __init__(self) -> None:
        self._last: tuple[int, int, int] | None = None
        self._held_up = 0
        self._period_ns: float | None = None
        self._begun_ns = self._looked_ns = 0
        self._bytes = self._pictures = 0
        self._is_noted = False

    def holds_up(self, number: int, exposed_ns: int, arrival_ns: int) -> bool:
        """Whether a picture is late, because the line was busy with the ones before it.

        Args:
            number: of the picture, in the count of the camera, which includes lost ones.
            exposed_ns: host time of the end of its exposure.
            arrival_ns: host time at which its first packet arrived.
        """
        last, self._last = self._last, (number, exposed_ns, arrival_ns)
        if last is None:
            return False
        taken_ns, came_ns = exposed_ns - last[1], arrival_ns - last[2]
        if number > last[0]:
            self._period_ns = taken_ns / (number - last[0])
        self._held_up = self._held_up + 1 if came_ns > _HELD_UP * taken_ns > 0 else 0
        return self._held_up >= _IN_A_ROW and arrival_ns - exposed_ns > _LATE_NS

    def is_too_slow(self, now_ns: int, transferred_bytes: int, has_arrived: bool) -> bool:
        """Whether the line is busy without a break, and brings too few pictures; said once for
        each of them. To be called at least every tenth of a second.

        Args:
            now_ns: host time.
            transferred_bytes: all that have arrived since the beginning.
            has_arrived: a picture has just arrived, complete or not.
        """
        is_idle = transferred_bytes == self._bytes
        if is_idle or now_ns - self._looked_ns > _LONGEST_LOOK_NS:
            self._watch_from(now_ns)
        self._looked_ns, self._bytes = now_ns, transferred_bytes
        self._pictures += has_arrived
        noted, self._is_noted = self._is_noted, self._is_noted and not has_arrived
        lasted_ns, period_ns = now_ns - self._begun_ns, self._period_ns
        if period_ns is None or lasted_ns < _WATCH_NS:
            return False
        # one more may be on its way
        is_slow = _HELD_UP * (self._pictures + 1) * period_ns < lasted_ns
        if is_slow or lasted_ns > _FEWEST_PERIODS * period_ns:
            self._watch_from(now_ns)
        self._is_noted |= is_slow and not has_arrived
        return is_slow and not noted

    def _watch_from(self, now_ns: int) -> None:
        self._begun_ns, self._pictures = now_ns, 0
