"""The options of the driver, and how they are set in a camera.

What a camera can do is asked of the camera. A value that it does not offer is an error, never
replaced by another one.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, Literal

from pydantic import Field, PositiveFloat

from crenel.messages.message import Text, message
from crenel_hardware.options import Options, Shown
from crenel_hardware.sensor.genicam.features import FeatureCamera, Quantity
from crenel_hardware.sensor.genicam.pixel_formats import PixelFormat
from crenel_hardware.sensor.genicam.setup.picture_format import (
    select_intensity,
    set_pixel_format,
    set_region,
)
from crenel_hardware.sensor.genicam.setup.refusals import (
    not_offered_error,
    refusals,
    require_offered,
)
from crenel_hardware.sensor.image_source import StampAt
from crenel_hardware.shared_options import (
    EXPOSURE,
    RATE,
    SERIAL,
    Bayer,
    CameraLatency,
    ChosenLaserColour,
    ExposureRange,
    KnownAddress,
    PacketSize,
)

LONGEST_EXPOSURE_US = 500_000.0
"""Longer exposures are not offered: they would look like a lost camera."""
_TOLERANCE = 0.02
_TRIGGERS = ("FrameStart", "ExposureStart", "AcquisitionStart", "LineStart")
"""What an edge may start, as the cameras name it; the first one that the camera has is used."""


class CameraOptions(Options):
    """Options in station.toml that every industrial camera has."""

    serial_number: Annotated[str | None, Field(min_length=1), SERIAL] = None
    pixel_format: Annotated[str | None, Shown(message("option-pixel-format"))] = None
    region: Annotated[
        list[Annotated[int, Field(ge=0)]] | None,
        Field(min_length=4, max_length=4),
        Shown(message("option-region"), message("option-help-region")),
    ] = None
    exposure_us: Annotated[PositiveFloat | None, EXPOSURE] = None
    exposure_range_us: ExposureRange = None
    gain_db: Annotated[float | None, Shown(message("option-gain"))] = None
    rate_hz: Annotated[PositiveFloat | None, RATE] = None
    trigger: Annotated[
        str | None,
        Field(min_length=1),
        Shown(message("option-trigger"), message("option-help-trigger")),
    ] = None
    trigger_edge: Annotated[
        Literal["rising", "falling"],
        Shown(
            message("option-trigger-edge"),
            choices={
                "rising": message("option-choice-rising"),
                "falling": message("option-choice-falling"),
            },
        ),
    ] = "rising"
    laser_line: Annotated[
        str | None,
        Field(min_length=1),
        Shown(message("option-laser-line"), message("option-help-laser-line")),
    ] = None
    stamp_at: Annotated[
        StampAt,
        Shown(
            message("option-stamp-at"),
            message("option-help-stamp-at"),
            {
                "exposure-start": message("option-choice-exposure-start"),
                "mid-exposure": message("option-choice-mid-exposure"),
                "exposure-end": message("option-choice-exposure-end"),
                "frame-end": message("option-choice-frame-end"),
            },
        ),
    ] = "exposure-start"
    latency_us: CameraLatency = 0.0
    laser_colour: ChosenLaserColour = None
    bayer: Bayer = None


class ProfileOptions(CameraOptions):
    """Further options of the drivers that read profile cameras."""

    line_rows: Annotated[
        Literal["region", "sensor"],
        Shown(
            message("option-line-rows"),
            message("option-help-line-rows"),
            {
                "region": message("option-choice-region"),
                "sensor": message("option-choice-sensor"),
            },
        ),
    ] = "region"
    line_offset_px: Annotated[
        float,
        Field(ge=-16_384, le=16_384),
        Shown(message("option-line-offset"), message("option-help-line-offset")),
    ] = 0.0
    line_sigma_px: Annotated[
        PositiveFloat | None,
        Shown(message("option-line-sigma"), message("option-help-line-sigma")),
    ] = None
    line_rate_hz: Annotated[
        PositiveFloat | None, Shown(message("option-line-rate"), message("option-help-line-rate"))
    ] = None


class GenicamOptions(ProfileOptions):
    """Options of the driver in station.toml."""

    title = message("driver-genicam")
    address: KnownAddress = None
    packet_size: PacketSize = None
    chunks: Annotated[
        list[Literal["ExposureTime", "Timestamp"]],
        Shown(message("option-chunks"), message("option-help-chunks")),
    ] = Field(default_factory=list)


@dataclass(frozen=True, slots=True)
class CameraSettings:
    """What the camera is set to."""

    pixel_format: PixelFormat
    region: tuple[int, int, int, int]
    """Offsets x and y, width and height of the camera's pictures, in px."""
    exposure_us: float
    exposure_range_us: tuple[float, float]
    rate_hz: float | None


def apply_options(title: Text, camera: FeatureCamera, options: CameraOptions) -> CameraSettings:
    """Sets up an open camera.

    Raises:
        DeviceError: the camera does not offer what the options ask for.
    """
    with refusals(title):
        if "Continuous" in camera.choices("AcquisitionMode"):
            camera.choose("AcquisitionMode", "Continuous")
        camera.clear_triggers()
        select_intensity(camera)
        pixel_format = set_pixel_format(
            title, camera, options.pixel_format, options.bayer, options.laser_colour
        )
        set_region(title, camera, options.region)
        if isinstance(options, GenicamOptions) and options.packet_size is not None:
            camera.set_packet_size(options.packet_size)
        exposure_us, exposure_range_us = _set_exposure(title, camera, options)
        _set_gain(title, camera, options.gain_db)
        if options.rate_hz is not None:
            _set_number(title, camera, "rate_hz", "frame_rate", options.rate_hz)
        rate_hz = camera.quantity("frame_rate") if camera.offers("frame_rate") else None
        if options.trigger is not None:
            set_trigger(title, camera, options.trigger, options.trigger_edge)
            if options.rate_hz is None and camera.has("AcquisitionFrameRateEnable"):
                camera.switch("AcquisitionFrameRateEnable", False)
        if options.laser_line is not None:
            _route_laser(title, camera, options.laser_line)
        chunks = options.chunks if isinstance(options, GenicamOptions) else ()
        _enable_chunks(title, camera, chunks)
        region = camera.region()
    return CameraSettings(pixel_format, region, exposure_us, exposure_range_us, rate_hz or None)


def _set_exposure(
    title: Text, camera: FeatureCamera, options: CameraOptions
) -> tuple[float, tuple[float, float]]:
    """Sets a fixed exposure; returns it in µs, and the range that the operator may set."""
    if not camera.offers("exposure_time"):
        if options.exposure_us is not None:
            raise not_offered_error(title, "exposure_us", f"{options.exposure_us:g}", "–")
        return 0.0, (0.0, 0.0)
    if "Off" in camera.choices("ExposureAuto"):
        camera.choose("ExposureAuto", "Off")
    if "Timed" in camera.choices("ExposureMode"):
        camera.choose("ExposureMode", "Timed")
    if options.exposure_us is not None:
        _set_number(title, camera, "exposure_us", "exposure_time", options.exposure_us)
    exposure_us = camera.quantity("exposure_time")
    shortest, longest = camera.bounds("exposure_time")
    longest = max(shortest, min(longest, LONGEST_EXPOSURE_US))
    if options.exposure_range_us is not None:
        least, most = options.exposure_range_us
        if not shortest <= least <= most <= longest:
            given = f"[{shortest:g}, {longest:g}]"
            raise not_offered_error(
                title, "exposure_range_us", str(options.exposure_range_us), given
            )
        shortest, longest = least, most
    if not shortest <= exposure_us <= longest:
        exposure_us = min(max(exposure_us, shortest), longest)
        camera.set_quantity("exposure_time", exposure_us)
        exposure_us = camera.quantity("exposure_time")
    return exposure_us, (shortest, longest)


def _set_gain(title: Text, camera: FeatureCamera, gain_db: float | None) -> None:
    if not camera.offers("gain"):
        if gain_db is not None:
            raise not_offered_error(title, "gain_db", f"{gain_db:g}", "–")
        return
    if "Off" in camera.choices("GainAuto"):
        camera.choose("GainAuto", "Off")
    if gain_db is not None:
        _set_number(title, camera, "gain_db", "gain", gain_db)


def _set_number(
    title: Text, camera: FeatureCamera, key: str, quantity: Quantity, value: float
) -> None:
    """Sets a quantity that the camera may round; one outside its range is an error."""
    if quantity == "frame_rate" and not camera.offers(quantity):
        raise not_offered_error(title, key, f"{value:g}", "–")
    least, most = camera.bounds(quantity)
    if not least * (1 - _TOLERANCE) <= value <= most * (1 + _TOLERANCE):
        raise not_offered_error(title, key, f"{value:g}", f"{least:g} … {most:g}")
    camera.set_quantity(quantity, value)
    found = camera.quantity(quantity)
    if abs(found - value) > max(_TOLERANCE * abs(value), 0.1):
        raise not_offered_error(title, key, f"{value:g}", f"{found:g}")


def set_trigger(title: Text, camera: FeatureCamera, source: str, edge: str) -> None:
    """One picture, or profile, at each edge of a line."""
    starts = camera.choices("TriggerSelector")
    if starts:
        known = [name for name in _TRIGGERS if name in starts]
        if not known:
            raise not_offered_error(title, "trigger", source, ", ".join(starts))
        camera.choose("TriggerSelector", known[0])
    require_offered(title, "trigger", source, camera.choices("TriggerSource"))
    camera.choose("TriggerSource", source)
    activation = f"{edge.capitalize()}Edge"
    if camera.has("TriggerActivation"):
        require_offered(title, "trigger_edge", activation, camera.choices("TriggerActivation"))
        camera.choose("TriggerActivation", activation)
    elif edge != "rising":
        raise not_offered_error(title, "trigger_edge", edge, "rising")
    camera.choose("TriggerMode", "On")


def _route_laser(title: Text, camera: FeatureCamera, line: str) -> None:
    """Connects an output line with a user output, which ``switch_laser`` sets."""
    require_offered(title, "laser_line", line, camera.choices("LineSelector"))
    camera.choose("LineSelector", line)
    if "Output" in camera.choices("LineMode"):
        camera.choose("LineMode", "Output")
    outputs = [name for name in camera.choices("LineSource") if name.startswith("UserOutput")]
    if not outputs:
        raise not_offered_error(title, "laser_line", line, ", ".join(camera.choices("LineSource")))
    own_number = [name for name in outputs if name[-1] == line[-1]]
    output = (own_number or outputs)[0]
    camera.choose("LineSource", output)
    if camera.has("UserOutputSelector"):
        camera.choose("UserOutputSelector", output)
    switch_laser(camera, False)


def switch_laser(camera: FeatureCamera, on: bool) -> None:
    """Switches the line that carries the laser; raises ``FeatureError``."""
    camera.switch("UserOutputValue", on)


def _enable_chunks(title: Text, camera: FeatureCamera, names: Sequence[str]) -> None:
    """Lets the camera append data to each picture."""
    if not camera.has("ChunkModeActive"):
        if names:
            raise not_offered_error(title, "chunks", ", ".join(names), "–")
        return
    camera.switch("ChunkModeActive", bool(names))
    offered = camera.choices("ChunkSelector") if names else []
    for name in names:
        require_offered(title, "chunks", name, offered)
        camera.choose("ChunkSelector", name)
        camera.switch("ChunkEnable", True)
