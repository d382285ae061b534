"""One device as the browser shows it."""

from dataclasses import dataclass
from typing import Literal

from app.station.reader import Link, LinkState
from hardware.interfaces import ArmInfo, SensorInfo


@dataclass(frozen=True, slots=True)
class DeviceState:
    """A device's state in words and numbers; counts are of all its connections."""

    title: str
    state: Literal["connected", "connecting", "lost", "off"]
    text: str
    age_s: float | None
    """Age of the newest data when this was made."""
    rate_hz: float | None
    received: int
    lost: int
    corrupt: int


def device_state(title: str, link: Link, info: ArmInfo | SensorInfo | None) -> DeviceState:
    """The state of a link; a connected device is told by its name and serial number."""
    text = link.text
    if info is not None and link.state is LinkState.CONNECTED:
        text = info.name
        if info.serial_number:
            text = f"{info.name}, serial number {info.serial_number}"
    return DeviceState(
        title,
        link.state.value,
        text,
        link.age_s,
        link.rate_hz,
        link.received,
        link.lost,
        link.corrupt,
    )
