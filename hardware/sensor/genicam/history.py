"""Which exposure, and which state of the laser, a picture had."""

from collections import deque

_KEPT = 16


class SettingHistory:
    """The values of a setting over time; a picture that arrives now may be older than the last
    change."""

    def __init__(self, value: float) -> None:
        self._changes: deque[tuple[int, float]] = deque([(0, value)], maxlen=_KEPT)

    def change(self, at_ns: int, value: float) -> None:
        """Notes a value that holds from a host time on."""
        self._changes.append((at_ns, value))

    @property
    def latest(self) -> float:
        return self._changes[-1][1]

    def value_at(self, time_ns: int) -> float:
        """The value at a host time; the oldest one known for an earlier time."""
        changes = tuple(self._changes)
        held = [value for at_ns, value in changes if at_ns <= time_ns]
        return held[-1] if held else changes[0][1]

    def values_between(self, start_ns: int, end_ns: int) -> set[float]:
        """All values that the setting had between two host times."""
        inside = {value for at_ns, value in tuple(self._changes) if start_ns < at_ns <= end_ns}
        return inside | {self.value_at(start_ns)}
