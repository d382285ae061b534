"""Compares the clock of a GigE Vision camera with the host's.

The stamps of pictures are related to the host's time by their arrival at best, which hides how
long the camera needed from the exposure to the first packet. A camera also keeps its present time
in a register on command. The command's answer comes a fraction of a millisecond later, so the two
clocks are known to each other without any such delay. On a busy computer, an answer may be noted
much later: of such readings, the quickest counts.

Source:
    AIA, GigE Vision 2.0, section 28.3 (time stamp registers).
"""

import time
from dataclasses import dataclass

from crenel_hardware.clock import now_ns
from crenel_hardware.sensor.genicam.aravis import AravisError
from crenel_hardware.sensor.genicam.camera import AravisCamera

TICK_FREQUENCY_REGISTER = 0x093C
LATCH_REGISTER, TIMESTAMP_REGISTER = 0x0944, 0x0948
_LATCH = 0b10
_PERIOD_NS, _FIRST_PERIOD_NS, _FIRST_READINGS = 1_000_000_000, 200_000_000, 25
"""At first, the clock is read more often."""
_TRIAL_S = 0.02
_MOST_DIFFERENCE_NS = 5_000_000
"""By how much the clocks may differ over the trial."""
_LONGER_NS = 2_000_000
"""A command that took longer than the quickest one by more than this is given again."""
_TRIES = 3


@dataclass(frozen=True, slots=True)
class _ClockReading:
    """A time of the camera's clock, latched between the command and its answer."""

    camera_ns: int
    sent_ns: int
    answered_ns: int

    @property
    def took_ns(self) -> int:
        return self.answered_ns - self.sent_ns


class CameraClock:
    """Reads the camera's clock now and then.

    ``works`` is False of a camera without this command, or whose clock does not run with the
    host's.
    """

    def __init__(self, camera: AravisCamera) -> None:
        self._camera = camera
        self._read_ns = self._readings = 0
        self._quickest_ns = self._ticks_hz = 0
        self.works = camera.is_gige and self._is_running()

    def read(self) -> tuple[int, int] | None:
        """Camera's and host-monotonic time of one moment, in ns; None if it was read lately.

        Raises:
            AravisError: the camera did not answer.
        """
        period_ns = _FIRST_PERIOD_NS if self._readings < _FIRST_READINGS else _PERIOD_NS
        if not self.works or now_ns() - self._read_ns < period_ns:
            return None
        self._readings += 1
        best = self._read_clock()
        for _ in range(_TRIES - 1):
            if best.took_ns <= self._quickest_ns + _LONGER_NS:
                break
            # the computer was busy, or the answer got lost: another one tells more
            best = min(best, self._read_clock(), key=lambda reading: reading.took_ns)
        # half of the quickest way to and fro passes between the command and its answer
        return best.camera_ns, best.answered_ns - self._quickest_ns // 2

    def _is_running(self) -> bool:
        try:
            self._ticks_hz = self._camera.read_wide_register(TICK_FREQUENCY_REGISTER)
            if not self._ticks_hz:
                return False
            first = self._read_clock()
            time.sleep(_TRIAL_S)
            second = self._read_clock()
        except AravisError:
            return False
        self._read_ns = 0
        # a busy computer notes an answer late, but never before it came
        least_ns = second.sent_ns - first.answered_ns - _MOST_DIFFERENCE_NS
        most_ns = second.answered_ns - first.sent_ns + _MOST_DIFFERENCE_NS
        return least_ns < second.camera_ns - first.camera_ns < most_ns

    def _read_clock(self) -> _ClockReading:
        sent_ns = now_ns()
        self._camera.write_register(LATCH_REGISTER, _LATCH)
        self._read_ns = answered_ns = now_ns()
        ticks = self._camera.read_wide_register(TIMESTAMP_REGISTER)
        reading = _ClockReading(ticks * 1_000_000_000 // self._ticks_hz, sent_ns, answered_ns)
        self._quickest_ns = min(reading.took_ns, self._quickest_ns or reading.took_ns)
        return reading
