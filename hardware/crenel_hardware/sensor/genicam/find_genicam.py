"""Finds cameras for the ``genicam`` driver, on all networks and on USB."""

from collections.abc import Iterator, Sequence
from pathlib import Path

from crenel.messages.message import join
from crenel_hardware.device_files import permission_error
from crenel_hardware.discovery import Finding, FoundDevice
from crenel_hardware.errors import DeviceError
from crenel_hardware.sensor.genicam.aravis import load_aravis
from crenel_hardware.sensor.genicam.camera import (
    GIGE_VISION,
    USB3_VISION,
    ListedCamera,
    list_cameras,
)

_KIND = ("Class", "SubClass", "Protocol")
_USB3_VISION_CONTROL = ("ef", "05", "00")


def find_genicam() -> Sequence[Finding]:
    """The cameras that answer a search, which sends a broadcast into every network, and the USB
    cameras that this user may not open.

    A GigE Vision camera is addressed by its IP address, a USB3 Vision camera by its serial number.
    """
    try:
        aravis = load_aravis()
    except DeviceError as error:
        return [error]
    found: list[Finding] = list(find_forbidden_cameras())
    for camera in list_cameras(aravis):
        if camera.protocol == GIGE_VISION and camera.address:
            found.append(_as_finding(camera, {"address": camera.address}))
        elif camera.protocol == USB3_VISION and camera.serial_number:
            found.append(_as_finding(camera, {"serial_number": camera.serial_number}))
    return found


def find_forbidden_cameras(
    devices: Path = Path("/dev/bus/usb"), classes: Path = Path("/sys/bus/usb/devices")
) -> Iterator[DeviceError]:
    """USB3 Vision cameras that Linux lists, and that this user may not open; Aravis hides them.

    Source:
        AIA, USB3 Vision 1.0, section 4.1: class, subclass and protocol of the control interface.
    """
    for interface in sorted(classes.glob("*:*")):
        kind = tuple(_read(interface / f"bInterface{name}") for name in _KIND)
        if kind != _USB3_VISION_CONTROL:
            continue
        device = classes / interface.name.partition(":")[0]
        bus, number = _read(device / "busnum"), _read(device / "devnum")
        if not bus.isdecimal() or not number.isdecimal():
            continue
        name = _read(device / "product") or device.name
        refused = permission_error(devices / f"{int(bus):03}" / f"{int(number):03}", name)
        if refused is not None:
            yield refused


def _read(path: Path) -> str:
    """A value in sysfs; empty if it is missing."""
    try:
        return path.read_text("utf-8", "replace").strip()
    except OSError:
        return ""


def _as_finding(camera: ListedCamera, options: dict[str, str]) -> FoundDevice:
    names = (camera.vendor, camera.model, camera.serial_number, camera.address)
    title = join([name for name in names if name], " · ")
    return FoundDevice("sensor", "genicam", title, dict(options))
