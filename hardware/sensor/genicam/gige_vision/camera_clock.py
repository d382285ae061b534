"""Compares the clock of a GigE Vision camera with the host's.

The stamps of pictures are related to the host's time by their arrival at best, which hides how
long the camera needed from the exposure to the first packet. A camera also keeps its present time
in a register on command. The command's answer comes a fraction of a millisecond later, so the two
clocks are known to each other without any such delay.

Source:
    AIA, GigE Vision 2.0, section 28.3 (time stamp registers).
"""

import time

from hardware.clock import now_ns
from hardware.sensor.genicam.aravis import AravisError
from hardware.sensor.genicam.camera import AravisCamera

TICK_FREQUENCY_REGISTER = 0x093C
LATCH_REGISTER, TIMESTAMP_REGISTER = 0x0944, 0x0948
_LATCH = 0b10
_PERIOD_NS, _FIRST_PERIOD_NS, _FIRST_READINGS = 1_000_000_000, 200_000_000, 25
"""At first, the clock is read more often."""
_TRIAL_S = 0.02
_MOST_DIFFERENCE_NS = 5_000_000
"""By how much the clocks may differ over the trial."""


class CameraClock:
    """Reads the camera's clock now and then.

    ``works`` is False of a camera without this command, or whose clock does not run with the
    host's.
    """

    def __init__(self, camera: AravisCamera) -> None:
        self._camera = camera
        self._read_ns = self._readings = 0
        self._shortest_ns: int | None = None
        self._ticks_hz = 0
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
        return self._compare()

    def _is_running(self) -> bool:
        try:
            self._ticks_hz = self._camera.read_wide_register(TICK_FREQUENCY_REGISTER)
            if not self._ticks_hz:
                return False
            first_camera_ns, first_host_ns = self._compare()
            time.sleep(_TRIAL_S)
            second_camera_ns, second_host_ns = self._compare()
        except AravisError:
            return False
        self._read_ns = 0
        passed_ns = second_camera_ns - first_camera_ns
        return abs(passed_ns - (second_host_ns - first_host_ns)) < _MOST_DIFFERENCE_NS

    def _compare(self) -> tuple[int, int]:
        sent_ns = now_ns()
        self._camera.write_register(LATCH_REGISTER, _LATCH)
        answered_ns = now_ns()
        ticks = self._camera.read_wide_register(TIMESTAMP_REGISTER)
        took_ns = answered_ns - sent_ns
        self._shortest_ns = min(took_ns, self._shortest_ns or took_ns)
        self._read_ns = answered_ns
        # half of the shortest way to and fro passes between the command and its answer
        return ticks * 1_000_000_000 // self._ticks_hz, answered_ns - self._shortest_ns // 2
