"""Converts a device's own time to the host's clock.

A packet states when its sample was taken, on the device's clock; the host knows only when it
arrived: later by a transport delay that is small at best, and a fifth of a second when the machine
is busy. Only the minimum delay is constant. The difference ``arrival - device time`` is therefore
bounded from below by a line with a small slope (the offset of the clocks, drifting with their
difference in rate), and packets without additional delay lie on it.

This line is found as the edge of the lower convex hull of the differences over the last 20 s, at
their mean time; of each half second, only the smallest difference is kept. Any straight line below
all points has at best the slope of this edge, so that no threshold for "normal" delays is needed.
During the first five seconds, which are too short for a slope, the line is level and follows the
smallest difference of the last second, but no faster than clocks drift.

The minimum delay itself cannot be observed here. It is a constant (the option ``latency_us`` of the
driver), and appears in the data as the distance between a forward and a backward pass over one
plane.
"""

from collections import deque

import numpy as np
from numpy.typing import NDArray

_BUCKET_NS = 500_000_000
_BUCKETS = 40
_SLOPE_SPAN_NS = 5_000_000_000
_LEVEL_BUCKETS = 2
_MAX_DRIFT = 0.01
"""Larger than for any crystal (1e-4) and any ceramic resonator (5e-3)."""
_LATE_NS = 50_000_000
"""If a difference is this far from the line, a clock has jumped."""
_LATE_BUCKETS = 4
_MIN_STEP_NS = 500_000


class DeviceClock:
    """Maps device time to host-monotonic time; time stamps strictly increase.

    ``observe`` adds arrivals, ``stamp`` applies the mapping. If a better observation moves the
    mapping back, time stamps advance at half speed until they meet it. If a packet arrives
    impossibly early, or nothing has arrived on the line for two seconds, one of the clocks has
    jumped or stopped, and the line starts again.
    """

    def __init__(self) -> None:
        self._stamp_ns: int | None = None
        self.restart()

    def restart(self) -> None:
        """Discards the mapping after a restart of the device. Time stamps still increase."""
        self._origin_ns: int | None = None
        self._zero_ns = 0
        self._buckets: deque[tuple[float, float]] = deque(maxlen=_BUCKETS)
        self._bucket = 0
        self._best = (0.0, np.inf)
        self._late = 0
        self._slope = 0.0
        self._level_ns = 0.0
        self._device_ns: int | None = None

    def observe(self, device_ns: int, arrival_ns: int) -> None:
        """Observes only the last of packets that arrive together."""
        if self._origin_ns is None:
            self._origin_ns = arrival_ns - device_ns
            self._zero_ns = device_ns
            self._bucket = arrival_ns // _BUCKET_NS
        at = float(device_ns - self._zero_ns)
        difference = float(arrival_ns - device_ns - self._origin_ns)
        if arrival_ns // _BUCKET_NS != self._bucket:
            self._bucket = arrival_ns // _BUCKET_NS
            self._close_bucket()
        below = self._slope * at + self._level_ns - difference
        if below > _LATE_NS:  # impossibly early: the device's clock has jumped forward
            self._buckets.clear()
            self._slope, self._level_ns = 0.0, difference
        elif below > 0:
            self._level_ns -= below
        if difference < self._best[1]:
            self._best = (at, difference)

    def stamp(self, device_ns: int) -> int:
        """Host-monotonic nanoseconds of a device time; requires an earlier observation."""
        assert self._origin_ns is not None, "observe comes first"
        offset = self._level_ns + self._slope * (device_ns - self._zero_ns)
        stamp = device_ns + self._origin_ns + round(offset)
        if self._stamp_ns is not None:
            step = 1
            if self._device_ns is not None:
                step = max(1, min((device_ns - self._device_ns) // 2, _MIN_STEP_NS))
            stamp = max(stamp, self._stamp_ns + step)
        self._stamp_ns, self._device_ns = stamp, device_ns
        return stamp

    def _close_bucket(self) -> None:
        at, difference = self._best
        late = difference - self._slope * at - self._level_ns > _LATE_NS
        self._late = self._late + 1 if late else 0
        if self._late >= _LATE_BUCKETS:
            self._buckets.clear()
            self._late, self._slope = 0, 0.0
        self._buckets.append(self._best)
        self._best = (0.0, np.inf)
        points = np.array(self._buckets)
        if points[-1, 0] - points[0, 0] < _SLOPE_SPAN_NS:
            self._slope = 0.0
            self._level_ns = _level(points)
        else:
            self._slope = float(np.clip(_hull_slope(points), -_MAX_DRIFT, _MAX_DRIFT))
            self._level_ns = float((points[:, 1] - self._slope * points[:, 0]).min())


def _level(points: NDArray[np.float64]) -> float:
    """The smallest of the newest differences, or what the drift can have made of an earlier one:
    if the machine is held up for more than a second, all of the newest are late."""
    possible = points[:, 1] + _MAX_DRIFT * (points[-1, 0] - points[:, 0])
    return float(min(points[-_LEVEL_BUCKETS:, 1].min(), possible.min()))


def _hull_slope(points: NDArray[np.float64]) -> float:
    """Slope of the lower convex hull of (N, 2) points, ordered by x, at their mean x."""
    hull: list[tuple[float, float]] = []
    for x, y in points.tolist():
        while len(hull) > 1 and _turns_down(hull[-2], hull[-1], (x, y)):
            hull.pop()
        hull.append((x, y))
    middle = points[:, 0].mean()
    right = next(i for i in range(1, len(hull)) if hull[i][0] >= middle)
    (x0, y0), (x1, y1) = hull[right - 1], hull[right]
    return (y1 - y0) / (x1 - x0)


def _turns_down(a: tuple[float, float], b: tuple[float, float], c: tuple[float, float]) -> bool:
    return (b[0] - a[0]) * (c[1] - a[1]) <= (b[1] - a[1]) * (c[0] - a[0])


class ClockLead:
    """How far a device's clock is ahead of the host's: something may arrive late, not early."""

    def __init__(self) -> None:
        self._least_ns: int | None = None

    def gain_ns(self, device_ns: int, host_ns: int) -> int:
        """By how much this is earlier than the earliest before."""
        late_ns = host_ns - device_ns
        least_ns = late_ns if self._least_ns is None else self._least_ns
        self._least_ns = min(late_ns, least_ns)
        return least_ns - late_ns
