"""The data that a device loses: over the last minutes, and noticed within a second."""

import time
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass

from crenel_hardware.interfaces import LinkHealth

WINDOW_S = 600.0
SAMPLE_S = 5.0

ALARM_WINDOW_S = 1.0
ALARM_SAMPLE_S = 0.05
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
        while len(samples) > 1 and now_s - samples[1][0] >= ALARM_WINDOW_S:
            samples.popleft()
        if samples and _is_alarming(samples[0][1], counts):
            self._until_s = now_s + HELD_S
        if not samples or now_s - samples[-1][0] >= ALARM_SAMPLE_S:
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


@dataclass(frozen=True, slots=True)
class Losses:
    """The losses of one device in the last minutes, by ``WINDOW_S``."""

    received: int
    lost: int
    corrupt: int

    @property
    def share(self) -> float:
        """0 to 1; 0 for a silent device."""
        total = self.received + self.lost + self.corrupt
        return (self.lost + self.corrupt) / total if total else 0.0


NO_LOSSES = Losses(0, 0, 0)


class LossWindow:
    """Increases of growing counts within a window of time."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._samples: deque[tuple[float, Losses]] = deque()

    def note(self, received: int, lost: int, corrupt: int) -> None:
        """The current counts; called at any rate. Counts that fall are of another device."""
        now_s = self._clock()
        if self._samples and received < self._samples[-1][1].received:
            self._samples.clear()
        if self._samples and now_s - self._samples[-1][0] < SAMPLE_S:
            return
        self._samples.append((now_s, Losses(received, lost, corrupt)))
        while len(self._samples) > 2 and now_s - self._samples[1][0] >= WINDOW_S:
            self._samples.popleft()

    def over(self, received: int, lost: int, corrupt: int) -> Losses:
        """Increase of the counts in the window."""
        if not self._samples:
            return NO_LOSSES
        first = self._samples[0][1]
        return Losses(
            max(received - first.received, 0),
            max(lost - first.lost, 0),
            max(corrupt - first.corrupt, 0),
        )
