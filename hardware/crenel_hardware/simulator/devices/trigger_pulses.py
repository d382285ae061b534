"""The simulated arm's output of trigger pulses."""

from crenel_hardware.simulator.devices.arm_packets import PulseRequest

PAUSE_NS = 320_000_000
RATES_HZ = (1.0, 400.0)


class TriggerPulses:
    """Counts from 1 after every start, which follows a pause."""

    def __init__(self) -> None:
        self.rate_hz = 0.0
        self._start_ns = 0
        self._number = 0
        self._last: PulseRequest | None = None

    def set(self, request: PulseRequest, now_ns: int) -> bool:
        """Starts or stops the pulses; False for a rate that is not possible.

        A repeated request changes nothing.
        """
        rate_hz = request.rate_mhz / 1000
        if rate_hz and not RATES_HZ[0] <= rate_hz <= RATES_HZ[1]:
            return False
        if request != self._last:
            self._last = request
            self.rate_hz, self._number = rate_hz, 0
            self._start_ns = now_ns + PAUSE_NS
        return True

    def due(self, now_ns: int) -> list[tuple[int, int]]:
        """Moments and numbers of the pulses since the last call."""
        pulses = []
        while self.rate_hz:
            at_ns = self._start_ns + round(self._number * 1e9 / self.rate_hz)
            if at_ns > now_ns:
                break
            self._number += 1
            pulses.append((at_ns, self._number))
        return pulses
