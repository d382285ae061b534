"""The datasheets of devices that were just chosen: what they say themselves, and what is asked.

A camera is asked how the line runs in its picture. Of an arm that reports poses, nothing needs to
be known; one that reports joints needs its kinematic model, which only its owner has.
"""

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from crenel.errors import OperationError
from crenel.formats.datasheets.arm import ArmFile
from crenel.formats.datasheets.sensor import SensorDatasheet
from crenel.formats.json_document import Document
from crenel.guide.common.datasheet_library import DatasheetLibrary
from crenel.messages.message import message
from crenel.operations.datasheets.documents import FOLDERS
from crenel.operations.datasheets.files import WRITING, free_path
from crenel.station.devices.arm_device import StationArm
from crenel.station.devices.sensor_device import StationSensor


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
    words = f"{sensor.name} {sensor.serial_number} {sensor.width_px}x{sensor.height_px}"
    datasheet = SensorDatasheet(
        name=sensor.name,
        serial_number=sensor.serial_number,
        width_px=sensor.width_px,
        height_px=sensor.height_px,
        stripe_axis=stripe_axis,
    )
    return _write(datasheet, data / FOLDERS["sensor"], words)


@dataclass(frozen=True)
class UndescribedArm:
    """A connected arm without a datasheet in the data folder."""

    name: str
    serial_number: str
    joint_count: int
    """0 of an arm that reports poses, whose datasheet can be written here."""


def find_undescribed_arm(arm: StationArm, library: DatasheetLibrary) -> UndescribedArm | None:
    """The connected arm, if no datasheet may be its own."""
    info = arm.info
    if info is None:
        return None
    found = UndescribedArm(info.name, info.serial_number, info.joint_count)
    return None if is_described(found, library) else found


def is_described(arm: UndescribedArm, library: DatasheetLibrary) -> bool:
    """Whether a datasheet is of an arm of this kind, and of no other unit."""
    for entry in library.arms.values():
        known = entry.datasheet
        joint_count = known.reading_size if known.reading_kind == "joints" else 0
        serial_numbers = {known.serial_number, arm.serial_number} - {""}
        if joint_count == arm.joint_count and len(serial_numbers) < 2:
            return True
    return False


def write_arm_datasheet(arm: UndescribedArm | None, data: Path) -> Path:
    """Writes ``arms/NAME.json`` of an arm that reports poses; a file that is there stays.

    Raises:
        OperationError: no such arm is connected, or the file cannot be written.
    """
    if arm is None or arm.joint_count:
        raise OperationError("no-arm", message("no-arm-without-datasheet"))
    datasheet = ArmFile(name=arm.name, serial_number=arm.serial_number, convention="pose")
    return _write(datasheet, data / FOLDERS["arm"], f"{arm.name} {arm.serial_number}")


def _write(datasheet: Document, folder: Path, words: str) -> Path:
    """A new file of this folder."""
    with WRITING:
        path = free_path(folder, words.lower(), ".json")
        datasheet.write(path)
    return path
