"""Finds cameras for the ``opencv`` driver: the video devices of Linux, by their names in sysfs."""

import re
from collections.abc import Sequence
from pathlib import Path

from crenel.messages.message import join
from crenel_hardware.device_files import permission_error
from crenel_hardware.discovery import Finding, FoundDevice
from crenel_hardware.sensor.opencv_camera import usb_identity

_CODECS = re.compile(r"\b(codec|isp|encoder|decoder|scaler)\b", re.IGNORECASE)
"""Video devices of a processor that are no cameras."""


def find_cameras(
    devices: Path = Path("/dev"), classes: Path = Path("/sys/class/video4linux")
) -> Sequence[Finding]:
    """The cameras that the kernel lists, and those that this user may not open.

    Of the nodes that one camera has, the first gives pictures; the others give metadata
    (``index`` in sysfs, kernel documentation of V4L2). A path by the camera's identity,
    which stays the same after a restart, is preferred to a number.
    """
    found: list[Finding] = []
    lasting = {path.resolve(): path for path in sorted((devices / "v4l" / "by-id").glob("*"))}
    for node in sorted(classes.glob("video*"), key=lambda path: int(path.name[5:] or 0)):
        device, index = devices / node.name, node / "index"
        if index.is_file() and index.read_text().strip() != "0":
            continue
        name, serial_number = usb_identity(str(device), classes)
        if not device.exists() or _CODECS.search(name):
            continue
        title = join([part for part in (name, serial_number, str(device)) if part], " · ")
        source = str(lasting.get(device.resolve(), device))
        found.append(FoundDevice("sensor", "opencv", title, {"source": source}))
        refused = permission_error(device, name)
        if refused is not None:
            found.append(refused)
    return found
