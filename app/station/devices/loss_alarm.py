"""Notices within a second that a device loses much of its data now."""

from collections import deque

from hardware.interfaces import LinkHealth

WINDOW_S = 1.0
SAMPLE_S = 0.05
"""Counts closer than this to the ones before are not kept."""
FEWEST, SHARE = 5, 0.3
"""The alarm is raised if so many records, and this share of all, are missing in the window."""
HELD_S = 5.0
"""It lasts for so long after the window in which it was last raised."""


class LossAlarm:
    """Judges the growing counts of one device; times are of any clock that runs evenly."""

    def __init__(self) -> None:
        self._samples: deque[tuple[float, LinkHealth]] = deque()
        self._until_s = float("-inf")

    def clear(self) -> None:
        """Begins with another device."""
        self._samples.clear()
        self._until_s = float("-inf")

    def note(self, now_s: float, counts: LinkHealth) -> None:
        """Notes the present counts, whose object may change afterwards."""
        samples = self._samples
        while len(samples) > 1 and now_s - samples[1][0] >= WINDOW_S:
            samples.popleft()
        if samples and _is_alarming(samples[0][1], counts):
            self._until_s = now_s + HELD_S
        if not samples or now_s - samples[-1][0] >= SAMPLE_S:
            kept = LinkHealth(counts.received, counts.lost, counts.corrupt, counts.late)
            samples.append((now_s, kept))

    def is_on(self, now_s: float) -> bool:
        """Whether much was lost just now."""
        return now_s < self._until_s


def _is_alarming(before: LinkHealth, now: LinkHealth) -> bool:
    """Whether records come later and later, or are lost in a row."""
    missing = now.lost + now.corrupt - before.lost - before.corrupt
    all_records = now.received - before.received + missing
    return now.late > before.late or (missing >= FEWEST and missing >= SHARE * all_records)
