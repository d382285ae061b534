"""Pairs the camera's frames with the arm's trigger pulses, by their counts.

The arm counts its pulses from 1 at each start. The camera counts its triggers from any number on,
those of frames that are lost on the way among them. Which of them was the arm's first pulse is
seen at the pause before a start: the last frame before it and the first one after it have adjacent
counts, unless one of the two was lost, or frames of before the pause were held up until after it;
then the pulses are started once more. From then on, a frame's pulse gives its time by the arm's own
clock, however late the frame arrives. A frame that arrives before its pulse is another one's, and
the pulses are started once more.

A camera that is stopped to change between pictures and lines misses triggers meanwhile: where its
count has a gap at the change, the pulses are started once more.

A camera that misses triggers without counting them is noticed by the arrival of its frames, whose
median over ``JUDGED`` frames shifts by a whole period.
"""

import threading
import time
from collections import deque
from dataclasses import replace
from itertools import pairwise
from statistics import median
from typing import TypeVar

import numpy as np

from crenel_hardware.interfaces import SensorReading

Reading = TypeVar("Reading", bound=SensorReading)

STORED_PULSES = 512
STORED_FRAMES = 64
WAIT_S = 0.25
"""A frame waits so long for the arm's sample of its pulse."""
PAUSE_SEEN_NS = 200_000_000
"""Frames further apart than this lie on both sides of the pause, which takes 0.3 s or more."""
EARLY_NS = 50_000_000
"""A frame's stamp may lie before its pulse by this, if it is estimated from its arrival."""
DECIDED_NS = 500_000_000
"""If no pause is seen up to so long after the first pulse, it will not be."""
MOST_MISSING = 3
"""Between pulses whose samples were lost, the times of so many are interpolated."""
JUDGED = 15


class PulsePairing:
    """Gives frames the times of their pulses; for any thread.

    Args:
        delay_us: from a pulse to the start of its exposure.
    """

    def __init__(self, delay_us: float = 0.0) -> None:
        self._delay_ns = round(1e3 * delay_us)
        self._changed = threading.Condition()
        self._pulses: deque[tuple[int, int]] = deque(maxlen=STORED_PULSES)
        self._frames: deque[tuple[int, int]] = deque(maxlen=STORED_FRAMES)
        self._offset: int | None = None
        self._last: tuple[type[object], int] | None = None
        self._late_ns: deque[int] = deque(maxlen=JUDGED)
        self._usual_late_ns: float | None = None
        self._needs_start = False
        self._last_pulse_s = float("-inf")

    @property
    def is_paired(self) -> bool:
        """Whether the camera's count of the arm's first pulse is known."""
        return self._offset is not None

    @property
    def last_pulse_s(self) -> float:
        """When the last sample of a pulse came, on the monotonic clock; -inf before the first."""
        return self._last_pulse_s

    @property
    def needs_start(self) -> bool:
        """Whether the pulses have to be started once more."""
        return self._needs_start

    def restart(self) -> None:
        """The arm is about to start its pulses, after a pause."""
        with self._changed:
            self._pulses.clear()
            self._forget()

    def note_pulse(self, pulse: int, stamp_ns: int) -> None:
        """A sample of the arm that was latched at a pulse."""
        with self._changed:
            if self._pulses and pulse <= self._pulses[-1][0]:  # counted from 1 again
                self._pulses.clear()
                self._forget()
            self._pulses.append((pulse, stamp_ns))
            self._last_pulse_s = time.monotonic()
            self._changed.notify_all()

    def pair(self, frame: Reading) -> Reading | None:
        """The frame or line with the middle of its exposure by the arm's clock; None while unknown.

        Waits a little for the sample of its pulse. A frame without a count stays as it is.
        """
        if frame.pulse is None:
            return frame
        with self._changed:
            if self._was_stopped(type(frame), frame.pulse):
                self._forget()
                self._frames.clear()
                self._needs_start = True
            self._last = type(frame), frame.pulse
            self._frames.append((frame.pulse, frame.mid_exposure_ns))
            if self._offset is None:
                self._find_offset()
            if self._offset is None:
                return None
            pulse_ns = self._pulse_time_ns(frame.pulse - self._offset)
            if pulse_ns is None:
                return None
            middle_ns = pulse_ns + self._delay_ns + round(500 * frame.exposure_us)
            late_ns = frame.mid_exposure_ns - middle_ns
            if late_ns < -EARLY_NS or self._has_slipped(late_ns):
                self._forget()
                self._needs_start = True
                return None
        return replace(frame, mid_exposure_ns=middle_ns)

    def _was_stopped(self, kind: type[object], pulse: int) -> bool:
        """Whether the camera changed between pictures and lines, and may have missed triggers."""
        if self._last is None:
            return False
        last_kind, last_pulse = self._last
        return kind is not last_kind and pulse != last_pulse + 1

    def _forget(self) -> None:
        self._late_ns.clear()
        self._offset, self._usual_late_ns, self._needs_start = None, None, False

    def _find_offset(self) -> None:
        """Looks for the pause before the first pulse."""
        first_ns, frames = self._first_pulse_ns(), list(self._frames)
        if first_ns is None:
            return
        for (before, before_ns), (after, after_ns) in pairwise(frames):
            if after_ns < first_ns - EARLY_NS:
                continue
            if before_ns < after_ns - PAUSE_SEEN_NS and after == before + 1:
                self._offset = before
            else:
                self._needs_start = True
            return
        self._needs_start = frames[-1][1] > first_ns + DECIDED_NS

    def _first_pulse_ns(self) -> int | None:
        """When the first pulse came, by the first ones known; None before."""
        if len(self._pulses) < 2:
            return None
        (first, first_ns), (last, last_ns) = self._pulses[0], self._pulses[-1]
        return first_ns - (first - 1) * (last_ns - first_ns) // (last - first)

    def _pulse_time_ns(self, pulse: int) -> int | None:
        """When a pulse came; None if the arm's samples around it are missing."""
        self._changed.wait_for(lambda: self._pulses and self._pulses[-1][0] >= pulse, WAIT_S)
        known = np.array(self._pulses, dtype=np.int64).reshape(-1, 2)
        after = int(np.searchsorted(known[:, 0], pulse))
        if after == len(known):
            return None
        if known[after, 0] == pulse:
            return int(known[after, 1])
        if after == 0 or known[after, 0] - known[after - 1, 0] > MOST_MISSING + 1:
            return None
        (low, low_ns), (high, high_ns) = known[after - 1], known[after]
        return int(low_ns + (pulse - low) * (high_ns - low_ns) // (high - low))

    def _has_slipped(self, late_ns: int) -> bool:
        """Whether frames now arrive half a period off their usual delay."""
        self._late_ns.append(late_ns)
        if len(self._late_ns) < JUDGED or len(self._pulses) < 2:
            return False
        now_ns = median(self._late_ns)
        if self._usual_late_ns is None:
            self._usual_late_ns = now_ns
        (first, first_ns), (last, last_ns) = self._pulses[0], self._pulses[-1]
        return abs(now_ns - self._usual_late_ns) > (last_ns - first_ns) / (last - first) / 2
