"""Has the arm trigger the cameras, and starts its pulses again whenever a pairing is lost.

One output of the arm is wired to the inputs of all cameras, so that a pulse starts an exposure of
each. Every camera counts the pulses from a number of its own, and has a pairing of its own. A new
start concerns them all: the arm counts from 1 again.
"""

import logging
import threading
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from crenel.loops import Loop
from crenel.station.pulses.pulse_pairing import PulsePairing
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import ArmDriver, PulseSource, SensorDriver

log = logging.getLogger(__name__)

LOOK_S = 0.1
SETTLE_S = 0.7
"""Pulses run for this long before they are started once more, so that frames precede the pause."""
FIRST_PAUSE_S, LONGEST_PAUSE_S = 0.5, 30.0
"""A camera that cannot be paired stops the others no more often than this."""
QUIET_S = 5.0
SILENT_S, SILENT_PERIODS = 2.0, 3.0
"""Pulses of which none comes for so long, and for so many periods, do not run: their start, or the
answer to it, was lost, or the arm stopped them."""


@dataclass(frozen=True)
class TriggerSettings:
    """How the arm triggers the cameras."""

    rate_hz: float
    delay_us: float = 0.0
    """From a pulse to the start of its exposure, by the camera's datasheet."""
    delays_us: Mapping[str, float] = field(default_factory=dict)
    """The delays of those of several sensors that have another delay, by their names."""

    def delay_of_us(self, sensor: str) -> float:
        """The delay of a sensor; the name of the only one is empty."""
        return self.delays_us.get(sensor, self.delay_us)


class PulseTrigger:
    """Keeps the arm's pulses running while the arm and a camera are connected."""

    def __init__(self, settings: TriggerSettings, pairings: Sequence[PulsePairing]) -> None:
        self._settings = settings
        self._pairings = tuple(pairings)
        self._wake = threading.Event()
        self._arm: ArmDriver | None = None
        self._sensors: tuple[SensorDriver, ...] = ()
        self._pause_s = 0.0
        self._again_s = float("-inf")
        self._started_s = float("inf")
        self._refusal = ""
        self._loop = Loop("pulse-trigger", self._look)

    def start(self) -> None:
        self._loop.start()

    def stop(self) -> None:
        """Ends the pulses."""
        self._loop.stop(2.0, self._wake.set)
        if isinstance(self._arm, PulseSource):
            self._arm.stop_pulses()

    def use(self, arm: ArmDriver | None, sensors: Sequence[SensorDriver | None]) -> None:
        """The open drivers; others than before, or None while one is lost."""
        there = tuple(sensor for sensor in sensors if sensor is not None)
        begins = arm is not self._arm or any(one not in self._sensors for one in there)
        self._arm, self._sensors = arm, there
        if begins:
            self._wake.set()

    def _look(self) -> None:
        begins = self._wake.wait(LOOK_S)
        self._wake.clear()
        arm = self._arm
        if self._loop.ending.is_set() or not self._sensors or not isinstance(arm, PulseSource):
            return
        if begins:
            self._start_pulses(arm)
        elif any(pairing.needs_start for pairing in self._pairings) or self._is_silent():
            self._start_again(arm)
        elif time.monotonic() > self._again_s + QUIET_S:
            self._pause_s = 0.0

    def _is_silent(self) -> bool:
        """Whether no pulse has come for long, since the last start."""
        heard_s = max([self._started_s, *(pairing.last_pulse_s for pairing in self._pairings)])
        silent_s = max(SILENT_S, SILENT_PERIODS / self._settings.rate_hz)
        return time.monotonic() > heard_s + silent_s

    def _start_again(self, arm: PulseSource) -> None:
        """Starts the pulses for a camera that could not be paired, or is not any more."""
        now_s = time.monotonic()
        if now_s >= self._again_s:
            self._pause_s = min(max(2 * self._pause_s, FIRST_PAUSE_S), LONGEST_PAUSE_S)
            self._start_pulses(arm)
            self._again_s = time.monotonic() + self._pause_s

    def _start_pulses(self, arm: PulseSource) -> None:
        try:
            for pairing in self._pairings:
                pairing.restart()
            arm.start_pulses(self._settings.rate_hz)
            self._refusal = ""
            self._loop.ending.wait(SETTLE_S)
        except DeviceError as error:  # as long as no pulse comes, they are started again
            if str(error) != self._refusal:
                log.warning("the arm's pulses cannot be started: %s", error)
                self._refusal = str(error)
        except Exception:
            self._wake.set()
            raise
        finally:
            self._started_s = time.monotonic()
