"""When a picture was exposed, for how long, and with which state of the laser."""

from collections import deque

from crenel_hardware.device_clock import ClockLead, DeviceClock
from crenel_hardware.interfaces import StampKind
from crenel_hardware.sensor.image_source import StampAt

_KEPT = 16
_RECENT_NS = 1_000_000_000
_EARLY_NS, _LONGEST_WAY_NS = 20_000_000, 3_000_000_000
"""How much earlier than possible a picture may seem to arrive, and how late it may be."""
_LATEST_ANSWER_NS = 1_000_000_000
"""A reading of the clock is noted later than it was answered, but hardly by more than this."""
_TO_MIDDLE: dict[StampAt, float] = {
    "exposure-start": 0.5,
    "mid-exposure": 0.0,
    "exposure-end": -0.5,
    "frame-end": -0.5,
}
"""From the stamped event to the middle of the exposure, in exposures."""


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


class PictureTimes:
    """Computes the middle of each exposure from the camera's stamp; the results increase.

    Args:
        exposures: the exposure in µs over time.
        stamp_at: what the camera stamps.
        latency_us: taken off each stamp.
    """

    def __init__(self, exposures: SettingHistory, stamp_at: StampAt, latency_us: float) -> None:
        self.stamps: StampKind = "device"
        """``"arrival"`` as soon as the camera has sent a picture without a stamp."""
        self.stamp_at = stamp_at
        self._exposures = exposures
        self._latency_us = latency_us
        self._by_arrival, self._by_reading = DeviceClock(), DeviceClock()
        self._is_compared, self._was_set = False, False
        self._read, self._arrived = ClockLead(), ClockLead()
        self._last_picture_ns: int | None = None
        self._behind = 0
        self._last_ns: int | None = None

    def compare(self, device_ns: int, host_ns: int) -> None:
        """Notes that a time of the camera's clock is a time of the host's.

        From then on, the arrival of a picture does not matter; unless it seems to arrive before its
        exposure, or long after it: then these are times of different clocks, or not yet well known.
        """
        self._was_set |= self._read.gain_ns(device_ns, host_ns) > _LATEST_ANSWER_NS
        self._is_compared = True
        self._by_reading.observe(device_ns, host_ns)

    def restart(self) -> None:
        """The camera was stopped and starts again; some begin to stamp from zero then."""
        self._last_picture_ns, self._arrived = None, ClockLead()

    def is_straggler(self, device_ns: int) -> bool:
        """Whether a picture that arrives now was overtaken by the one before, as one of the
        acquisition before can be. Two in a row show a clock that was set: ``has_jumped``."""
        if self._last_picture_ns is None or device_ns >= self._last_picture_ns:
            self._behind = 0
            return False
        self._behind += 1
        return self._behind == 1

    def has_jumped(self, device_ns: int, arrival_ns: int) -> bool:
        """Whether the camera's clock was set while it sends pictures: by the stamp of a picture, or
        by the last comparison."""
        last_ns, self._last_picture_ns = self._last_picture_ns, device_ns
        gain_ns = self._arrived.gain_ns(device_ns, arrival_ns)
        fell_back = last_ns is not None and device_ns < last_ns
        return self._was_set or fell_back or gain_ns > _LONGEST_WAY_NS

    def middle(
        self, device_ns: int | None, arrival_ns: int, exposure_us: float | None
    ) -> tuple[int, float]:
        """Host-monotonic middle of an exposure in ns, and the exposure in µs.

        Args:
            device_ns: the camera's stamp, if it has one.
            arrival_ns: host-monotonic arrival of the first packet, which follows the exposure.
            exposure_us: as the camera states it with the picture, if it does.
        """
        if device_ns is None:
            self.stamps, self.stamp_at = "arrival", "frame-end"
            event_ns = arrival_ns
        else:
            shortest_us = min(self._exposures.values_between(arrival_ns - _RECENT_NS, arrival_ns))
            after_event_us = (0.5 + _TO_MIDDLE[self.stamp_at]) * (exposure_us or shortest_us)
            event_ns = self._event_ns(device_ns, arrival_ns - round(after_event_us * 1000))
        event_ns -= round(self._latency_us * 1000)
        to_middle = _TO_MIDDLE[self.stamp_at]
        if exposure_us is None:
            before_event_us = (0.5 - to_middle) * self._exposures.latest
            exposure_us = self._exposures.value_at(event_ns - round(before_event_us * 1000))
        middle_ns = event_ns + round(to_middle * exposure_us * 1000)
        if self._last_ns is not None:
            middle_ns = max(middle_ns, self._last_ns + 1)
        self._last_ns = middle_ns
        return middle_ns, exposure_us

    def _event_ns(self, device_ns: int, latest_ns: int) -> int:
        """Host time of a stamp, which was no later than ``latest_ns``."""
        self._by_arrival.observe(device_ns, latest_ns)
        by_arrival_ns = self._by_arrival.stamp(device_ns)
        if self._is_compared:
            event_ns = self._by_reading.stamp(device_ns)
            if -_EARLY_NS < latest_ns - event_ns < _LONGEST_WAY_NS:
                return event_ns
        return by_arrival_ns
