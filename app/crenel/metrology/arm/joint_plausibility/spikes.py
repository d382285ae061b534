"""Single outlying readings, detected from the three before and the three after."""

import math
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

LATER = 3
"""Number of readings before and after from which a reading is judged."""
NOISE_SDS = 12.0
EXTRAPOLATED = math.sqrt(20.0)
"""The noise of a parabola through three readings at the fourth, including that one's own noise."""
MOST_JERK_RAD_S3 = 30_000.0
MOST_ACCELERATION_RAD_S2 = 300.0
"""Deviation of a person's motion from a parabola within one period."""
BOUNCE = 0.5
"""A tip that bounces returns at less than half its speed; time stamps may be off by the same share
of a period."""
REGULAR = 0.4
"""Time stamps that are off by a larger share of a period mean a gap."""

At = tuple[int, Sequence[float]]


@dataclass(frozen=True)
class Spike:
    """A single reading that stands out from those around it."""

    stamp_ns: int
    joint: int
    off_rad: float


class Spikes:
    """Detects readings that depart to one side from the motion before and after.

    A joint that is stopped or pushed changes its speed once: the readings before do not show it,
    those after do, or vice versa; while it happens, the reading lies on the other side of the
    middle of its neighbours. A spike departs to the same side from the parabola of the three
    before, from that of the three after, and from the middle of its neighbours. No oscillation
    below a third of the rate looks like that.
    """

    def __init__(self, joint_count: int) -> None:
        self._noise_rad = [math.inf] * joint_count
        self._window: deque[At] = deque(maxlen=2 * LATER + 1)

    def set_noise(self, sds_rad: Sequence[float], steps_rad: Sequence[float]) -> None:
        """The encoders' noise (n,) as standard deviations, and their steps (n,), in rad."""
        self._noise_rad = [
            NOISE_SDS * EXTRAPOLATED * sd + 2 * step
            for sd, step in zip(sds_rad, steps_rad, strict=True)
        ]

    def forget(self) -> None:
        """The next readings do not continue the previous ones."""
        self._window.clear()

    def find(self, stamp_ns: int, q_rad: Sequence[float]) -> Spike | None:
        """Takes the next reading (n,), and judges the one three readings before."""
        window = self._window
        window.append((stamp_ns, q_rad))
        if len(window) <= 2 * LATER:
            return None
        # almost all readings end here
        around = (window[at][1] for at in (LATER - 1, LATER, LATER + 1))
        for before, at, after, noise in zip(*around, self._noise_rad, strict=True):
            if not -noise <= at - 0.5 * (before + after) <= noise:
                return self._spike()
        return None

    def _spike(self) -> Spike | None:
        stamps = [stamp_ns for stamp_ns, _ in self._window]
        period_ns = (stamps[-1] - stamps[0]) / (len(stamps) - 1)
        uneven_ns = REGULAR * period_ns
        if any(abs(after - before - period_ns) > uneven_ns for before, after in pairwise(stamps)):
            return None
        step_s = period_ns / 1e9
        moved_rad = step_s**2 * min(MOST_JERK_RAD_S3 * step_s, MOST_ACCELERATION_RAD_S2)
        found, most_rad = None, 0.0
        for joint, noise_rad in enumerate(self._noise_rad):
            off_rad, swept_rad = self._departure(joint)
            beyond_rad = abs(off_rad) - noise_rad - moved_rad - BOUNCE * swept_rad
            if beyond_rad > most_rad:
                found, most_rad = Spike(stamps[LATER], joint, off_rad), beyond_rad
        return found

    def _departure(self, joint: int) -> tuple[float, float]:
        """Departure of the middle reading to one side, and motion of the joint in a period, in
        rad."""
        at = self._window[LATER][1][joint]
        a, b, c, _, d, e, f = (
            math.remainder(q_rad[joint] - at, math.tau) for _, q_rad in self._window
        )
        departures = (-3 * c + 3 * b - a, -0.5 * (c + d), -3 * d + 3 * e - f)
        swept_rad = 0.5 * max(abs(c - a), abs(f - d))
        if min(departures) > 0:
            return min(departures), swept_rad
        return min(max(departures), 0.0), swept_rad
