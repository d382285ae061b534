"""Has the arm trigger the camera, and starts its pulses again whenever the pairing is lost."""

import logging
import threading
from dataclasses import dataclass

from app.station.pulses.pulse_pairing import PulsePairing
from hardware.errors import DeviceError
from hardware.interfaces import ArmDriver, PulseSource, SensorDriver

log = logging.getLogger(__name__)

LOOK_S = 0.1
SETTLE_S = 0.7
"""Pulses run for this long before they are started once more, so that frames precede the pause."""


@dataclass(frozen=True)
class TriggerSettings:
    """How the arm triggers the camera."""

    rate_hz: float
    delay_us: float = 0.0
    """From a pulse to the start of its exposure, by the camera's datasheet."""


class PulseTrigger:
    """Keeps the arm's pulses running while arm and camera are connected."""

    def __init__(self, settings: TriggerSettings, pairing: PulsePairing) -> None:
        self._settings = settings
        self._pairing = pairing
        self._wake = threading.Event()
        self._ending = threading.Event()
        self._devices: tuple[ArmDriver | None, SensorDriver | None] = (None, None)
        self._thread = threading.Thread(target=self._run, name="pulse-trigger", daemon=True)

    def start(self) -> None:
        self._thread.start()

    def stop(self) -> None:
        """Ends the pulses."""
        self._ending.set()
        self._wake.set()
        self._thread.join(2.0)
        arm, _ = self._devices
        if isinstance(arm, PulseSource):
            arm.stop_pulses()

    def use(self, arm: ArmDriver | None, sensor: SensorDriver | None) -> None:
        """The open drivers; others than before, or None while one is lost."""
        if (arm, sensor) != self._devices:
            self._devices = (arm, sensor)
            self._wake.set()

    def _run(self) -> None:
        while not self._ending.is_set():
            changed = self._wake.wait(LOOK_S)
            self._wake.clear()
            arm, sensor = self._devices
            if sensor is None or not isinstance(arm, PulseSource):
                continue
            if changed or self._pairing.needs_start:
                self._start_pulses(arm)

    def _start_pulses(self, arm: PulseSource) -> None:
        try:
            self._pairing.restart()
            arm.start_pulses(self._settings.rate_hz)
            self._ending.wait(SETTLE_S)
        except DeviceError as error:  # its reader closes it and opens it again
            log.warning("the arm's pulses cannot be started: %s", error)
