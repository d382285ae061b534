"""The room temperature: read every few seconds, and stored for comparison."""

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

from crenel.messages.message import Text
from crenel.station.devices.device_thread import device_error_text
from crenel_hardware.errors import DeviceError

STORE_EVERY_S = 600.0


class Thermometer(Protocol):
    """A source of temperature readings."""

    def read_c(self) -> float:
        """In °C; raises ``DeviceError``."""


@dataclass(frozen=True)
class Temperature:
    """The last reading; null without a thermometer, or if it fails."""

    celsius: float | None
    trouble: Text = ""


class TemperatureWatch:
    """Called from one thread at a time; ``now`` may be read from any thread.

    Args:
        keep: called with a reading every ten minutes.
    """

    def __init__(self, thermometer: Thermometer | None, keep: Callable[[float], object]) -> None:
        self._thermometer, self._keep = thermometer, keep
        self._lock = threading.Lock()
        self._now = Temperature(None)
        self._stored_s: float | None = None

    @property
    def there(self) -> bool:
        """Whether there is a thermometer at all."""
        return self._thermometer is not None

    @property
    def now(self) -> Temperature:
        return self._now

    def read(self) -> None:
        """Reads once; it may take a second."""
        if self._thermometer is None:
            return
        with self._lock:
            try:
                celsius = self._thermometer.read_c()
            except DeviceError as error:
                self._now = Temperature(None, device_error_text(error))
                return
            self._now = Temperature(celsius)
            now_s = time.monotonic()
            if self._stored_s is None or now_s - self._stored_s > STORE_EVERY_S:
                self._stored_s = now_s
                self._keep(celsius)
