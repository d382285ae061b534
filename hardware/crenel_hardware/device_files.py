"""Device files: the serial ports that are connected, and who may open a file.

``find_serial_ports`` is the finder of the ``bridge`` driver; pyserial lists the ports.
"""

import getpass
import os
from collections.abc import Sequence
from pathlib import Path

from serial.tools import list_ports

from crenel.messages.message import join, message
from crenel_hardware.discovery import Finding, FoundDevice
from crenel_hardware.errors import DeviceError


def find_serial_ports(identities: Path = Path("/dev/serial/by-id")) -> Sequence[Finding]:
    """Every serial port, USB adapters first, and those that this user may not open.

    A path by the adapter's identity, which stays the same after a restart, is preferred.
    """
    lasting = {path.resolve(): path for path in sorted(identities.glob("*"))}
    found: list[Finding] = []
    ports = sorted(list_ports.comports(), key=lambda port: (port.vid is None, port.device))
    for port in ports:
        known = port.description not in (None, "n/a", port.device)
        parts = (port.description if known else None, port.serial_number, port.device)
        title = join([part for part in parts if part], " · ")
        url = str(lasting.get(Path(port.device).resolve(), port.device))
        found.append(FoundDevice("arm", "bridge", title, {"url": url}))
        refused = permission_error(Path(port.device), port.device)
        if refused is not None:
            found.append(refused)
    return found


def permission_error(device: Path, name: str) -> DeviceError | None:
    """Why this user may not read and write a device file of Linux; None if allowed, or no file.

    Args:
        device: such as ``/dev/ttyUSB0``.
        name: what a person recognises it by.
    """
    if os.name != "posix" or not device.exists() or os.access(device, os.R_OK | os.W_OK):
        return None
    group = device.group()
    what = message("device-not-permitted", name=name, device=device)
    if group == "root":
        return DeviceError(what, message("ask-administrator-for-access", device=device))
    command = f"sudo usermod -aG {group} {getpass.getuser()}"
    return DeviceError(what, message("join-group-of-device", command=command))
