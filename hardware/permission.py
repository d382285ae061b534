"""Says which group a user must join to open a device file."""

import getpass
import os
from pathlib import Path

from app.messages.message import message
from hardware.errors import DeviceError


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
