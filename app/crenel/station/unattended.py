"""Stops scan and lasers when nobody is in control and the arm stands still."""

import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from crenel.findings import Finding
from crenel.messages.message import Text, message, quantity

MOVED_MM = 0.5
"""How far the arm gets from where it stood before that is a movement, however slow."""


@dataclass(frozen=True)
class Unattended:
    """What the watch looks at, each as of now.

    Args:
        silence_s: how long nobody who has control was heard.
        place_mm: numbers that change as the arm moves; None while its readings are missing.
        is_lit: whether a scan runs, or a laser is on that the station can switch off.
        is_driven: whether a job of the station moves the arm.
        limit_s: how long the two last before the stop; None for never.
    """

    silence_s: Callable[[], float]
    place_mm: Callable[[], Sequence[float] | None]
    is_lit: Callable[[], bool]
    is_driven: Callable[[], bool]
    limit_s: Callable[[], float | None]


class UnattendedWatch:
    """Stops what runs with nobody in control; while the arm moves, it stops nothing.

    Args:
        stop: stops scan and lasers, with the reason.
        note: shows the reason until the next activity.
    """

    def __init__(
        self,
        station: Unattended,
        stop: Callable[[Text], None],
        note: Callable[[Finding], None],
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._station, self._stop, self._note, self._clock = station, stop, note, clock
        self._lock = threading.Lock()
        self._stood_mm: Sequence[float] = ()
        self._still_since_s = clock()

    def look(self) -> None:
        """Called a few times per second."""
        with self._lock:
            still_s = self._time_still()
            limit_s = self._station.limit_s()
            if limit_s is None or not self._station.is_lit():
                return
            if min(still_s, self._station.silence_s()) < limit_s:
                return
        because = message("unattended-stop", limit=quantity(limit_s, "s"))
        self._stop(because)
        self._note(Finding("bad", because, message("unattended-stop-remedy")))

    def _time_still(self) -> float:
        """How long the arm has stood; an arm whose readings are missing is not known to move."""
        place_mm, now_s = self._station.place_mm(), self._clock()
        if self._station.is_driven():
            self._still_since_s = now_s
        elif place_mm is not None and self._has_moved(place_mm):
            self._stood_mm, self._still_since_s = place_mm, now_s
        return now_s - self._still_since_s

    def _has_moved(self, place_mm: Sequence[float]) -> bool:
        if len(place_mm) != len(self._stood_mm):
            return True
        pairs = zip(place_mm, self._stood_mm, strict=True)
        return max(abs(now - before) for now, before in pairs) > MOVED_MM
