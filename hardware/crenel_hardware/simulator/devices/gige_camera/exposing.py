"""When the camera exposes, how long, and how much of the laser's light falls into it."""

import threading
import time
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

from crenel.loop_states import note_progress
from crenel.loops import Loop
from crenel_hardware.clock import now_ns
from crenel_hardware.simulator.devices.gige_camera.features import EXPOSURE_ACTIVE, LINES
from crenel_hardware.simulator.devices.gige_camera.registers import RegisterMap

CORE_SHARE = 0.5
"""The simulation of pictures takes no more of the machine; the frame rate gives way."""
STORED_TRIGGERS = 4
"""Triggers that wait for their exposure; the pictures of those beyond are lost."""
_WAKE_S = 0.05
_KEPT_SWITCHES = 64


@dataclass(frozen=True, slots=True)
class TakenExposure:
    """One exposure, in host-monotonic time."""

    start_ns: int
    exposure_us: float
    laser_share: float
    """Share of its time during which the laser was on, 0 to 1."""
    number: int
    """Counts all exposures since the start of the acquisition, from 1, and lost triggers."""

    @property
    def mid_ns(self) -> int:
        return self.start_ns + round(500 * self.exposure_us)

    @property
    def end_ns(self) -> int:
        return self.start_ns + round(1000 * self.exposure_us)


class LaserLine:
    """The output that carries the laser: how it was switched, and when."""

    def __init__(self, registers: RegisterMap, line: str) -> None:
        self._registers, self._index = registers, LINES[line]
        self._switches: deque[tuple[int, bool]] = deque([(0, False)], maxlen=_KEPT_SWITCHES)

    def note(self) -> None:
        """Reads the registers after any of them was written."""
        registers = self._registers
        source = registers.integer("LineSource", self._index)
        is_output = registers.integer("LineMode", self._index) == 1
        on = False
        if is_output and source != EXPOSURE_ACTIVE:
            on = registers.integer("UserOutputValue", source - 1) == 1
        elif is_output:
            on = True
        if on != self._switches[-1][1]:
            self._switches.append((now_ns(), on))

    @property
    def is_on(self) -> bool:
        return self._switches[-1][1]

    def share(self, start_ns: int, end_ns: int) -> float:
        """Share of a time during which the laser was on."""
        switches = [*self._switches, (end_ns, False)]
        lit_ns = sum(
            max(0, min(until_ns, end_ns) - max(since_ns, start_ns))
            for (since_ns, on), (until_ns, _) in pairwise(switches)
            if on
        )
        return lit_ns / (end_ns - start_ns)


class ExposureLoop:
    """Exposes between ``start`` and ``stop``, freely or at triggers, on a thread of its own.

    Args:
        take: makes a picture of an exposure that is over, and sends it.
        finished: called after the last picture of an acquisition of a few.
    """

    def __init__(
        self,
        registers: RegisterMap,
        laser: LaserLine,
        take: Callable[[TakenExposure], None],
        finished: Callable[[], None],
    ) -> None:
        self._registers, self._laser, self._take = registers, laser, take
        self._finished = finished
        # one lock for both: a register that is written may start or stop the exposures, which read
        # registers
        self._changed = threading.Condition(registers.lock)
        self._triggers: deque[int] = deque()
        self._running = self._ending = False
        self._acquisition = 0
        self._number = self._left = 0
        self._due_ns = 0
        self._loop = Loop("camera-exposures", self._take_next)

    def start_thread(self) -> None:
        self._loop.start()

    def end_thread(self) -> None:
        self._loop.stop(None, self._end)

    def _end(self) -> None:
        with self._changed:
            self._ending = True
            self._changed.notify_all()

    def start(self) -> None:
        """Begins an acquisition, and counts from 1."""
        registers = self._registers
        counts = {0: -1, 1: 1, 2: registers.integer("AcquisitionFrameCount")}
        with self._changed:
            self._left = counts[registers.integer("AcquisitionMode")]
            self._acquisition += 1
            self._running, self._number, self._due_ns = True, 0, now_ns()
            self._triggers.clear()
            self._changed.notify_all()

    def stop(self) -> None:
        with self._changed:
            self._running = False
            self._acquisition += 1
            self._changed.notify_all()

    def trigger(self, at_ns: int, source: int) -> None:
        """An edge at the input with the value ``source`` of ``TriggerSource``."""
        with self._changed:
            if not (self._running and self._is_triggered):
                return
            if self._registers.integer("TriggerSource") != source:
                return
            if len(self._triggers) == STORED_TRIGGERS:
                self._triggers.popleft()
            self._number += 1
            self._triggers.append(at_ns)
            self._changed.notify_all()

    @property
    def _is_triggered(self) -> bool:
        return self._registers.integer("TriggerMode") == 1

    def _take_next(self) -> None:
        exposure = self._expose()
        if exposure is None:
            return
        began_s = time.thread_time()
        self._take(exposure)
        rest_ns = round(1e9 * (time.thread_time() - began_s) * (1 / CORE_SHARE - 1))
        with self._changed:
            self._due_ns = max(self._due_ns, now_ns() + rest_ns)
            self._left -= 1
            done = self._running and self._left == 0
        if done:
            self.stop()
            self._finished()

    def _expose(self) -> TakenExposure | None:
        """The next exposure, when it is over; None at the end of the thread."""
        with self._changed:
            while not self._ending:
                note_progress()
                start_ns = self._next_start_ns()
                if start_ns is None or start_ns > now_ns():
                    left_s = _WAKE_S if start_ns is None else (start_ns - now_ns()) / 1e9
                    self._changed.wait(max(min(left_s, _WAKE_S), 0.0))
                    continue
                acquisition, number = self._acquisition, self._count()
                exposure_us = self._registers.real("ExposureTime")
                self._due_ns = max(start_ns + round(1e9 / self._rate_hz()), start_ns)
                end_ns = start_ns + round(1000 * exposure_us)
                while self._acquisition == acquisition and not self._ending:
                    if (left_ns := end_ns - now_ns()) <= 0:
                        share = self._laser.share(start_ns, end_ns)
                        return TakenExposure(start_ns, exposure_us, share, number)
                    self._changed.wait(left_ns / 1e9)
        return None

    def _next_start_ns(self) -> int | None:
        """When the next exposure begins; None if that is not known."""
        if not self._running:
            return None
        if self._is_triggered:
            return self._triggers[0] if self._triggers else None
        return self._due_ns if self._due_ns > now_ns() - 1_000_000 else now_ns()

    def _count(self) -> int:
        """The number of the exposure that begins."""
        if self._is_triggered:
            number = self._number - len(self._triggers) + 1
            self._triggers.popleft()
            return number
        self._number += 1
        return self._number

    def _rate_hz(self) -> float:
        limited = self._registers.integer("AcquisitionFrameRateEnable")
        exposure_us = self._registers.real("ExposureTime")
        rate_hz = 1e6 / exposure_us
        if self._registers.sends_profiles:
            return min(rate_hz, self._registers.real("AcquisitionLineRate"))
        return min(rate_hz, self._registers.real("AcquisitionFrameRate")) if limited else rate_hz
