"""One device as the browser shows it."""

import time
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from app.findings import Quality
from app.messages.message import Text, join, message
from app.station.devices.device_thread import Link, LinkState
from hardware.interfaces import ArmInfo, SensorInfo, StampKind

State = Literal["absent", "connected", "connecting", "lost", "off"]
QUALITY: dict[State, Quality] = {
    "absent": "attention",
    "connected": "good",
    "connecting": "attention",
    "lost": "bad",
    "off": "bad",
}


@dataclass(frozen=True, slots=True)
class DeviceState:
    """State of a device in words and numbers; counts include all its connections."""

    title: Text
    state: State
    text: Text
    age_s: float | None
    """Age of the newest data at that time."""
    rate_hz: float | None
    received: int
    lost: int
    corrupt: int
    stamps: StampKind | None = None
    """Where the time stamps come from; None while it is not connected."""
    losing: bool = False
    """Whether much of its data is lost, or comes later and later, just now."""
    loss_remedy: Text = ""
    """What to do on this computer against losses, if the driver knows it."""


def device_state(
    title: Text, link: Link, info: ArmInfo | SensorInfo | None, label: str = ""
) -> DeviceState:
    """The state of a link; for a connected device, with its name and serial number.

    Args:
        label: what people call the device; empty if they call it nothing else.
    """
    text: Text = link.text
    if info is not None and link.state is LinkState.CONNECTED:
        text = info.name
        if info.serial_number:
            text = message(
                "name-and-serial-number", name=info.name, serial_number=info.serial_number
            )
        text = join([label, text], " · ") if label else text
    return DeviceState(
        title,
        link.state.value,
        text,
        link.age_s,
        link.rate_hz,
        link.received,
        link.lost,
        link.corrupt,
        info.stamps if info is not None else None,
        link.losing,
        info.loss_remedy if isinstance(info, SensorInfo) else "",
    )


WINDOW_S = 600.0
SAMPLE_S = 5.0


@dataclass(frozen=True, slots=True)
class Losses:
    """Of one device, in the window."""

    received: int
    lost: int
    corrupt: int

    @property
    def share(self) -> float:
        """0 to 1; 0 for a silent device."""
        total = self.received + self.lost + self.corrupt
        return (self.lost + self.corrupt) / total if total else 0.0


class LossWindow:
    """Increases of growing counts within a window of time."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._samples: deque[tuple[float, Losses]] = deque()

    def note(self, received: int, lost: int, corrupt: int) -> None:
        """The current counts; called at any rate. Counts that fall are of another device."""
        now_s = self._clock()
        if self._samples and received < self._samples[-1][1].received:
            self._samples.clear()
        if self._samples and now_s - self._samples[-1][0] < SAMPLE_S:
            return
        self._samples.append((now_s, Losses(received, lost, corrupt)))
        while len(self._samples) > 2 and now_s - self._samples[1][0] >= WINDOW_S:
            self._samples.popleft()

    def over(self, received: int, lost: int, corrupt: int) -> Losses:
        """Increase of the counts in the window."""
        if not self._samples:
            return Losses(0, 0, 0)
        first = self._samples[0][1]
        return Losses(
            max(received - first.received, 0),
            max(lost - first.lost, 0),
            max(corrupt - first.corrupt, 0),
        )
