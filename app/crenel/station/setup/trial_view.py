"""What a tried device shows: its link, its picture or its joints."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, Literal, TypeAlias

from crenel.errors import sentence
from crenel.messages.message import Text, join, message, word
from crenel.metrology.mosaic import shows_mosaic
from crenel.station.devices.arm_device import StationArm
from crenel.station.devices.device_thread import DeviceReader, Link, LinkState
from crenel.station.devices.rig import DeviceName
from crenel.station.devices.sensor_device import StationSensor
from crenel_hardware.interfaces import (
    ArmInfo,
    Frame,
    OptionOffer,
    PoseSample,
    SensorInfo,
    SensorReading,
    StampKind,
)

MUCH_LOST = 0.01
TrialState: TypeAlias = Literal["opening", "live", "waiting", "failed", "ended"]


@dataclass(frozen=True)
class TrialView:
    """A device that is tried, or one that the station uses."""

    number: int
    """Counts the trials."""
    kind: DeviceName
    driver: str
    options: Mapping[str, object]
    in_use: bool
    """The station uses it: this is its live state, and nothing was opened."""
    state: TrialState
    text: Text
    """Why there are no data; empty while they come."""
    name: str
    serial_number: str
    rate_hz: float | None
    received: int
    lost: int
    corrupt: int
    stamps: StampKind | None
    """None before it is open."""
    loss_text: Text
    """That much is being lost, and what to do; empty otherwise."""
    width_px: int | None
    height_px: int | None
    exposure_us: float | None
    exposure_range_us: tuple[float, float] | None
    """None if the exposure cannot be set."""
    offers: tuple[OptionOffer, ...]
    """What the device offers for the options; empty where it cannot be asked."""
    picture_text: Text
    """What is wrong with the pictures, and what to do; empty otherwise."""
    picture: int | None
    """The number of the newest picture; None before the first."""
    joints_deg: tuple[float, ...]
    position_mm: tuple[float, float, float] | None
    rotation_deg: tuple[float, float, float] | None
    """The rotation vector of a pose, whose length is the angle."""


@dataclass(frozen=True)
class TrialSubject:
    """What is tried: one of the two devices, by driver and options."""

    kind: DeviceName
    driver: str
    options: Mapping[str, object]
    in_use: bool
    sensor: str = ""
    """The name of the sensor in use, where the station has several."""


def view_arm(number: int, subject: TrialSubject, arm: StationArm, ended: Text = "") -> TrialView:
    """The view of an arm; ``ended`` says why the trial is over, if it is."""
    info = arm.info
    newest = arm.latest()
    pose = newest if isinstance(newest, PoseSample) else None
    return replace(
        _view_link(number, subject, arm.reader, info, ended),
        joints_deg=arm.joints_deg(),
        position_mm=None if pose is None else pose.position_mm,
        rotation_deg=None if pose is None else _rotation_deg(pose.quaternion_xyzw),
    )


def view_sensor(
    number: int, subject: TrialSubject, sensor: StationSensor, ended: Text = ""
) -> TrialView:
    """The view of a sensor; as ``view_arm``."""
    info, latest = sensor.info, sensor.frames.newest
    shortest, longest = info.exposure_range_us if info else (0.0, 0.0)
    return replace(
        _view_link(number, subject, sensor.reader, info, ended),
        width_px=info.width_px if info else None,
        height_px=info.height_px if info else None,
        exposure_us=latest.exposure_us if latest and info and latest.exposure_us > 0 else None,
        exposure_range_us=(shortest, longest) if shortest < longest else None,
        offers=info.offers if info else (),
        picture_text=_picture_text(latest),
        picture=latest.sequence if latest and not ended else None,
    )


def _view_link(
    number: int,
    subject: TrialSubject,
    reader: DeviceReader[Any, Any],
    info: ArmInfo | SensorInfo | None,
    ended: Text,
) -> TrialView:
    """What all devices show, without data."""
    link = reader.link()
    return TrialView(
        number=number,
        kind=subject.kind,
        driver=subject.driver,
        options=subject.options,
        in_use=subject.in_use,
        state=_state(link, reader.error, ended),
        text=_text(link, reader.error, ended),
        name=info.name if info else "",
        serial_number=info.serial_number if info else "",
        rate_hz=link.rate_hz,
        received=link.received,
        lost=link.lost,
        corrupt=link.corrupt,
        stamps=info.stamps if info else None,
        loss_text=_loss_text(subject.kind, link, info),
        width_px=None,
        height_px=None,
        exposure_us=None,
        exposure_range_us=None,
        offers=(),
        picture_text="",
        picture=None,
        joints_deg=(),
        position_mm=None,
        rotation_deg=None,
    )


def _loss_text(kind: DeviceName, link: Link, info: ArmInfo | SensorInfo | None) -> Text:
    remedy = info.loss_remedy if isinstance(info, SensorInfo) else ""
    if link.losing:
        remedy = remedy or message("use-shorter-cable-port-own-close")
        return join([message("data-lost-now", title=word(kind)), remedy], " ")
    share = (link.lost + link.corrupt) / max(link.received + link.lost + link.corrupt, 1)
    return remedy if share > MUCH_LOST else ""


def _picture_text(latest: SensorReading | None) -> Text:
    if not isinstance(latest, Frame) or not shows_mosaic(latest.image):
        return ""
    found, remedy = message("pixels-alternate-as-raw"), message("choose-bayer-or-grey-pictures")
    return join([sentence(found), sentence(remedy)], " ")


def _state(link: Link, error: Text, ended: Text) -> TrialState:
    if ended:
        return "ended"
    if link.state is LinkState.CONNECTED:
        return "live" if link.rate_hz is not None or link.received else "waiting"
    return "failed" if error or link.state is LinkState.LOST else "opening"


def _text(link: Link, error: Text, ended: Text) -> Text:
    if ended or link.state is LinkState.CONNECTED:
        return ended
    return error or link.text


def _rotation_deg(
    quaternion_xyzw: tuple[float, float, float, float],
) -> tuple[float, float, float]:
    x, y, z, w = quaternion_xyzw
    sine = math.sqrt(x * x + y * y + z * z)
    angle_deg = math.degrees(2 * math.atan2(sine, abs(w)))
    scale = math.copysign(angle_deg / sine, w) if sine > 0 else 0.0
    return x * scale, y * scale, z * scale
