"""Finds serial ports for the ``serial-encoder`` driver, as pyserial lists them."""

from collections.abc import Sequence
from pathlib import Path

from serial.tools import list_ports

from app.messages.message import join
from hardware.discovery import Finding, FoundDevice
from hardware.permission import permission_error


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
        found.append(FoundDevice("arm", "serial-encoder", title, {"url": url}))
        refused = permission_error(Path(port.device), port.device)
        if refused is not None:
            found.append(refused)
    return found
