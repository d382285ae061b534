"""The options of the driver, and how they are set in a camera.

What a camera can do is asked of the camera. A value that it does not offer is an error, never
replaced by another one.
"""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Annotated, Literal

from pydantic import Field, PositiveFloat

from app.messages.message import Text, message
from hardware.errors import DeviceError
from hardware.options import Options
from hardware.sensor.genicam.aravis import AravisError
from hardware.sensor.genicam.camera import AravisCamera
from hardware.sensor.genicam.pixel_formats import FORMATS, PixelFormat
from hardware.sensor.grey import BayerPattern, LaserColour, require_colour
from hardware.sensor.image_source import StampAt

_OFF, _CONTINUOUS = 0, 0
_NEVER_ADJUST = 0
LONGEST_EXPOSURE_US = 500_000.0
"""Longer exposures are not offered: they would look like a lost camera."""
_TOLERANCE = 0.02
_TRIGGERS = ("FrameStart", "ExposureStart", "AcquisitionStart")
"""What an edge may start, as the cameras name it; the first one that the camera has is used."""


class GenicamOptions(Options):
    """Options of the driver in station.toml."""

    address: str | None = Field(default=None, min_length=1)
    serial_number: str | None = Field(default=None, min_length=1)
    pixel_format: str | None = None
    region: list[Annotated[int, Field(ge=0)]] | None = Field(
        default=None, min_length=4, max_length=4
    )
    exposure_us: PositiveFloat | None = None
    exposure_range_us: list[PositiveFloat] | None = Field(default=None, min_length=2, max_length=2)
    gain_db: float | None = None
    rate_hz: PositiveFloat | None = None
    packet_size: int | None = Field(default=None, ge=576, le=16_000)
    trigger: str | None = Field(default=None, min_length=1)
    trigger_edge: Literal["rising", "falling"] = "rising"
    laser_line: str | None = Field(default=None, min_length=1)
    stamp_at: StampAt = "exposure-start"
    latency_us: float = Field(default=0.0, ge=0, le=1_000_000)
    chunks: list[Literal["ExposureTime", "Timestamp"]] = Field(default_factory=list)
    laser_colour: LaserColour | None = None
    bayer: BayerPattern | None = None


@dataclass(frozen=True, slots=True)
class CameraSettings:
    """What the camera is set to."""

    pixel_format: PixelFormat
    size_px: tuple[int, int]
    """Width and height of the camera's pictures."""
    exposure_us: float
    exposure_range_us: tuple[float, float]
    rate_hz: float | None


def apply_options(title: Text, camera: AravisCamera, options: GenicamOptions) -> CameraSettings:
    """Sets up an open camera.

    Raises:
        DeviceError: the camera does not offer what the options ask for.
    """
    with _refusals(title):
        camera.call("set_acquisition_mode", _CONTINUOUS)
        camera.call("clear_triggers")
        pixel_format = _set_pixel_format(title, camera, options)
        _set_region(title, camera, options.region)
        if camera.is_gige and options.packet_size is not None:
            camera.aravis.call(
                "arv_gv_device_set_packet_size_adjustment", camera.device, _NEVER_ADJUST
            )
            camera.call("gv_set_packet_size", options.packet_size)
        exposure_us, exposure_range_us = _set_exposure(title, camera, options)
        _set_gain(title, camera, options.gain_db)
        if options.rate_hz is not None:
            _set_number(title, camera, "rate_hz", "frame_rate", options.rate_hz)
        rate_hz = camera.call("get_frame_rate") if _can(camera, "frame_rate") else None
        if options.trigger is not None:
            _set_trigger(title, camera, options.trigger, options.trigger_edge)
            if options.rate_hz is None and camera.has("AcquisitionFrameRateEnable"):
                camera.switch("AcquisitionFrameRateEnable", False)
        if options.laser_line is not None:
            _route_laser(title, camera, options.laser_line)
        _enable_chunks(title, camera, options.chunks)
        _, _, width_px, height_px = camera.region()
    return CameraSettings(
        pixel_format, (width_px, height_px), exposure_us, exposure_range_us, rate_hz or None
    )


@contextmanager
def _refusals(title: Text) -> Iterator[None]:
    try:
        yield
    except AravisError as error:
        raise DeviceError(
            message("camera-refused-settings", title=title, reason=error),
            message("check-options-or-restart-camera"),
        ) from error


def _require(title: Text, key: str, value: str, offered: list[str]) -> None:
    if value not in offered:
        raise _not_offered(title, key, value, ", ".join(offered) or "–")


def _not_offered(title: Text, key: str, value: str, given: str) -> DeviceError:
    return DeviceError(
        message("camera-cannot-do", title=title, key=key, value=value, given=given),
        message("correct-sensor-take-out", key=key),
    )


def _can(camera: AravisCamera, quantity: str) -> bool:
    return bool(camera.call(f"is_{quantity}_available"))


def _set_pixel_format(title: Text, camera: AravisCamera, options: GenicamOptions) -> PixelFormat:
    """The format of the options; else the present one, if it is understood; else the best known."""
    offered = camera.choices("PixelFormat")
    wanted = options.pixel_format
    if wanted is not None:
        _require(title, "pixel_format", wanted, offered)
    else:
        present = camera.choice("PixelFormat")
        order = list(FORMATS)
        known = sorted((name for name in offered if name in FORMATS), key=order.index)
        wanted = present if present in FORMATS or not known else known[0]
    if wanted not in FORMATS:
        raise unknown_format_error(title, wanted)
    camera.choose("PixelFormat", wanted)
    pixel_format = FORMATS[wanted]
    require_colour(options.bayer or pixel_format.bayer, options.laser_colour)
    return pixel_format


def unknown_format_error(title: Text, name: str) -> DeviceError:
    """The error of a pixel format that the driver does not understand."""
    return DeviceError(
        message("pixel-format-unknown", title=title, name=name),
        message("pixel-formats-are", names=", ".join(FORMATS)),
    )


def _set_region(title: Text, camera: AravisCamera, region: list[int] | None) -> None:
    """Sets the region of interest, without one the whole sensor."""
    width_px, height_px = camera.sensor_size()
    wanted = (0, 0, width_px, height_px) if region is None else tuple(region)
    x, y, width, height = wanted
    if x + width > width_px or y + height > height_px:
        raise _not_offered(title, "region", str(region), f"[0, 0, {width_px}, {height_px}]")
    # a camera limits each offset by the present size, and each size by the present offset
    camera.call("set_region", 0, 0, width, height)
    camera.call("set_region", x, y, width, height)
    found = camera.region()
    if region is not None and found != wanted:
        raise _not_offered(title, "region", str(region), str(list(found)))


def _set_exposure(
    title: Text, camera: AravisCamera, options: GenicamOptions
) -> tuple[float, tuple[float, float]]:
    """Sets a fixed exposure; returns it in µs, and the range that the operator may set."""
    if not _can(camera, "exposure_time"):
        if options.exposure_us is not None:
            raise _not_offered(title, "exposure_us", f"{options.exposure_us:g}", "–")
        return 0.0, (0.0, 0.0)
    if _can(camera, "exposure_auto"):
        camera.call("set_exposure_time_auto", _OFF)
    if "Timed" in camera.choices("ExposureMode"):
        camera.choose("ExposureMode", "Timed")
    if options.exposure_us is not None:
        _set_number(title, camera, "exposure_us", "exposure_time", options.exposure_us)
    exposure_us = camera.call("get_exposure_time")
    shortest, longest = camera.bounds("exposure_time")
    longest = max(shortest, min(longest, LONGEST_EXPOSURE_US))
    if options.exposure_range_us is not None:
        least, most = options.exposure_range_us
        if not shortest <= least <= most <= longest:
            given = f"[{shortest:g}, {longest:g}]"
            raise _not_offered(title, "exposure_range_us", str(options.exposure_range_us), given)
        shortest, longest = least, most
    if not shortest <= exposure_us <= longest:
        exposure_us = min(max(exposure_us, shortest), longest)
        camera.call("set_exposure_time", exposure_us)
        exposure_us = camera.call("get_exposure_time")
    return exposure_us, (shortest, longest)


def _set_gain(title: Text, camera: AravisCamera, gain_db: float | None) -> None:
    if not _can(camera, "gain"):
        if gain_db is not None:
            raise _not_offered(title, "gain_db", f"{gain_db:g}", "–")
        return
    if _can(camera, "gain_auto"):
        camera.call("set_gain_auto", _OFF)
    if gain_db is not None:
        _set_number(title, camera, "gain_db", "gain", gain_db)


def _set_number(title: Text, camera: AravisCamera, key: str, quantity: str, value: float) -> None:
    """Sets a quantity that the camera may round; one outside its range is an error."""
    if quantity == "frame_rate" and not _can(camera, quantity):
        raise _not_offered(title, key, f"{value:g}", "–")
    least, most = camera.bounds(quantity)
    if not least * (1 - _TOLERANCE) <= value <= most * (1 + _TOLERANCE):
        raise _not_offered(title, key, f"{value:g}", f"{least:g} … {most:g}")
    camera.call(f"set_{quantity}", value)
    found = camera.call(f"get_{quantity}")
    if abs(found - value) > max(_TOLERANCE * abs(value), 0.1):
        raise _not_offered(title, key, f"{value:g}", f"{found:g}")


def _set_trigger(title: Text, camera: AravisCamera, source: str, edge: str) -> None:
    """One picture at each edge of a line."""
    starts = camera.choices("TriggerSelector")
    if starts:
        known = [
            name for name in ("FrameStart", "ExposureStart", "AcquisitionStart") if name in starts
        ]
        if not known:
            raise _not_offered(title, "trigger", source, ", ".join(starts))
        camera.choose("TriggerSelector", known[0])
    _require(title, "trigger", source, camera.choices("TriggerSource"))
    camera.choose("TriggerSource", source)
    activation = f"{edge.capitalize()}Edge"
    if camera.has("TriggerActivation"):
        _require(title, "trigger_edge", activation, camera.choices("TriggerActivation"))
        camera.choose("TriggerActivation", activation)
    elif edge != "rising":
        raise _not_offered(title, "trigger_edge", edge, "rising")
    camera.choose("TriggerMode", "On")


def _route_laser(title: Text, camera: AravisCamera, line: str) -> None:
    """Connects an output line with a user output, which ``switch_laser`` sets."""
    _require(title, "laser_line", line, camera.choices("LineSelector"))
    camera.choose("LineSelector", line)
    if "Output" in camera.choices("LineMode"):
        camera.choose("LineMode", "Output")
    outputs = [name for name in camera.choices("LineSource") if name.startswith("UserOutput")]
    if not outputs:
        raise _not_offered(title, "laser_line", line, ", ".join(camera.choices("LineSource")))
    own_number = [name for name in outputs if name[-1] == line[-1]]
    output = (own_number or outputs)[0]
    camera.choose("LineSource", output)
    if camera.has("UserOutputSelector"):
        camera.choose("UserOutputSelector", output)
    switch_laser(camera, False)


def switch_laser(camera: AravisCamera, on: bool) -> None:
    """Switches the line that carries the laser; raises ``AravisError``."""
    camera.switch("UserOutputValue", on)


def _enable_chunks(title: Text, camera: AravisCamera, names: Sequence[str]) -> None:
    """Lets the camera append data to each picture."""
    if not camera.has("ChunkModeActive"):
        if names:
            raise _not_offered(title, "chunks", ", ".join(names), "–")
        return
    camera.switch("ChunkModeActive", bool(names))
    offered = camera.choices("ChunkSelector") if names else []
    for name in names:
        _require(title, "chunks", name, offered)
        camera.choose("ChunkSelector", name)
        camera.switch("ChunkEnable", True)
