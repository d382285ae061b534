"""The temperature of the room, from a file that Linux' own drivers keep up to date.

Such are ``/sys/bus/w1/devices/28-*/temperature`` of a DS18B20 and
``/sys/class/hwmon/hwmon*/temp1_input`` of many others.
"""

import errno
from pathlib import Path

from crenel.messages.message import message, quantity
from crenel_hardware.errors import DeviceError

LOWEST_C, HIGHEST_C = -40.0, 85.0
"""Beyond, the sensor is broken or gone: a DS18B20 reports 85 °C until its first reading."""


class FileThermometer:
    """Reads thousandths of a degree Celsius; a reading may take a second."""

    def __init__(self, path: Path) -> None:
        self._path = path

    def read_c(self) -> float:
        """The present temperature in °C.

        Raises:
            DeviceError: the file cannot be read, or its value is beyond ``LOWEST_C`` and
                ``HIGHEST_C``.
        """
        try:
            if not self._path.is_file():  # a pipe would be waited for
                raise FileNotFoundError(errno.ENOENT, "there is no such file")
            celsius = int(self._path.read_text()) / 1000.0
        except (OSError, ValueError) as error:
            raise DeviceError(
                message("thermometer-cannot-read", path=self._path, error=error),
                message("check-connection"),
            ) from error
        if not LOWEST_C < celsius < HIGHEST_C:
            raise DeviceError(
                message("thermometer-reads", path=self._path, celsius=quantity(celsius, "°C", 1)),
                message("check-connection"),
            )
        return celsius
