"""One device as the browser shows it."""

from dataclasses import dataclass
from typing import Literal

from crenel.findings import GRAVEST_FIRST, Quality
from crenel.messages.message import Text, join, message
from crenel.station.devices.device_thread import Link, LinkState
from crenel.station.devices.losses import NO_LOSSES, Losses
from crenel_hardware.interfaces import ArmInfo, SensorInfo, StampKind

State = Literal["absent", "connected", "connecting", "lost", "off"]
QUALITY: dict[State, Quality] = {
    "absent": "attention",
    "connected": "good",
    "connecting": "attention",
    "lost": "bad",
    "off": "bad",
}
LOSS_ATTENTION, LOSS_BAD = 0.001, 0.01
"""Shares of the data of the last minutes."""


@dataclass(frozen=True, slots=True)
class DeviceState:
    """State of a device in words and numbers; counts include all its connections."""

    title: Text
    state: State
    quality: Quality
    """By its link and its losses: every sign of the device shows this one."""
    text: Text
    age_s: float | None
    """Age of the newest data at that time."""
    rate_hz: float | None
    received: int
    lost: int
    corrupt: int
    stamps: StampKind | None = None
    """Where the time stamps come from; None while it is not connected."""
    silent: bool = False
    """It answers, but sends no data."""
    losing: bool = False
    """Whether much of its data is lost, or comes later and later, just now."""
    lately: Losses = NO_LOSSES
    loss_remedy: Text = ""
    """What to do on this computer against losses, if the driver knows it."""


def link_quality(state: State, silent: bool) -> Quality:
    """Whether a device sends data.

    Args:
        silent: it answers, and waits for a trigger or a change: neither good nor bad.
    """
    return "neutral" if silent else QUALITY[state]


def loss_quality(lately: Losses, losing: bool) -> Quality:
    """Whether all its data arrives.

    Args:
        losing: much of it is lost, or comes later and later, just now.
    """
    if losing or lately.share > LOSS_BAD:
        return "bad"
    return "attention" if lately.share > LOSS_ATTENTION else "good"


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
    state: State = link.state.value
    qualities = link_quality(state, link.silent), loss_quality(link.lately, link.losing)
    return DeviceState(
        title,
        state,
        min(qualities, key=GRAVEST_FIRST.index),
        text,
        link.age_s,
        link.rate_hz,
        link.received,
        link.lost,
        link.corrupt,
        info.stamps if info is not None else None,
        link.silent,
        link.losing,
        link.lately,
        info.loss_remedy if isinstance(info, SensorInfo) else "",
    )
