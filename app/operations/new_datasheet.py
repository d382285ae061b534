"""The datasheet of a camera that was just chosen: what is known of it, and how the line runs."""

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from app.errors import OperationError
from app.formats.datasheets.sensor import SensorDatasheet
from app.formats.io_errors import convert_io_errors
from app.guide.common.datasheet_library import DatasheetLibrary
from app.messages.message import message
from app.station.devices.sensor_device import StationSensor

FOLDER = "sensors"


@dataclass(frozen=True)
class UndescribedSensor:
    """A connected camera without a datasheet in the data folder."""

    name: str
    serial_number: str
    width_px: int
    height_px: int


def find_undescribed(sensor: StationSensor, library: DatasheetLibrary) -> UndescribedSensor | None:
    """The connected camera, if no datasheet has its serial number and the size of its pictures."""
    info = sensor.info
    if info is None:
        return None
    found = UndescribedSensor(info.name, info.serial_number, info.width_px, info.height_px)
    for entry in library.sensors.values():
        known = entry.datasheet
        size = (known.width_px, known.height_px)
        if size == (found.width_px, found.height_px) and known.serial_number == info.serial_number:
            return None
    return found


def write_datasheet(
    sensor: UndescribedSensor | None, stripe_axis: Literal["u", "v"], data: Path
) -> Path:
    """Writes ``sensors/NAME.json`` of a camera; a file that is there stays.

    Args:
        stripe_axis: "u" if the line has one point in each column, "v" if in each row.

    Raises:
        OperationError: no camera without a datasheet is connected, or the file cannot be written.
    """
    if sensor is None:
        raise OperationError("no-sensor", message("no-camera-without-datasheet"))
    folder = data / FOLDER
    words = f"{sensor.name} {sensor.serial_number} {sensor.width_px}x{sensor.height_px}"
    stem = re.sub(r"[^a-z0-9]+", "-", words.lower()).strip("-")[-80:].strip("-")
    names = [stem, *(f"{stem}-{number}" for number in range(2, 100))]
    path = next(path for name in names if not (path := folder / f"{name}.json").exists())
    with convert_io_errors(folder):
        folder.mkdir(parents=True, exist_ok=True)
    SensorDatasheet(
        name=sensor.name,
        serial_number=sensor.serial_number,
        width_px=sensor.width_px,
        height_px=sensor.height_px,
        stripe_axis=stripe_axis,
    ).write(path)
    return path
