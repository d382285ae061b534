"""How much of what came from the broker was not read, and why."""

import time
from collections import Counter
from collections.abc import Callable, Mapping
from typing import Literal

DropReason = Literal["long", "strange", "often", "crowded"]
"""long: over the bound; strange: no message of a station; often: more of one topic than can be
shown; crowded: of more stations than are kept."""


class Unread:
    """Counts since the start. It is written on the event loop and read on any thread."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._counts: Counter[DropReason] = Counter()
        self._newest_s: float | None = None

    def add(self, why: DropReason, number: int = 1) -> None:
        self._counts[why] += number
        self._newest_s = self._clock()

    @property
    def counts(self) -> Mapping[str, int]:
        """By the reason; those that never were are missing."""
        return {str(why): number for why, number in self._counts.items()}

    @property
    def ago_s(self) -> float | None:
        """Since the newest; None where all were read."""
        return None if self._newest_s is None else self._clock() - self._newest_s
