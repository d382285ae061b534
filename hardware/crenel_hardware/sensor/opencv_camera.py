"""The ``opencv`` driver: a USB camera, a network stream or a video file, through OpenCV.

In station.toml::

    [sensor]
    driver = "opencv"
    source = 0                  # a camera's number, "/dev/video0", "rtsp://…", "http://…", a file
    width_px = 1280             # optional, of a camera; with height_px
    height_px = 1024
    rate_hz = 60.0              # optional: asked of a camera; a file's own rate otherwise
    exposure_us = 2000.0        # optional, of a camera: switches its automatic exposure off
    exposure_range_us = [100.0, 20000.0]   # optional: lets the operator set it within this
    latency_us = 0.0            # optional: from the end of the exposure to the stamp, see below
    loop = false                # optional, of a file
    laser_colour = "red"        # optional, of a colour camera: red, green or blue
    bayer = "RGGB"              # optional, of raw pictures: the colours of 2 × 2 pixels

Grey: with ``laser_colour``, that channel of the colour picture. Else, where the camera sends a
luma channel (grey, YUYV, NV12, motion JPEG), that is taken as it is; elsewhere BGR is converted.
With ``bayer``, the camera's raw pixels of the laser's colour alone are the picture, without
interpolation: half as wide and high as the sensor, which the datasheet then has to say.
Motion JPEG, H.264 and the like are lossy: good for a look, not for measuring.

Stamps: a picture's event is the V4L2 driver's monotonic time of the buffer where there
is one, else the moment at which ``grab`` returned. The middle of the exposure is
``event - latency_us - exposure / 2``. The latency (readout and transport; a constant for
one camera in one mode) cannot be seen from here; it shows in the data as the distance
between a forward and a backward pass over one plane. A file's pictures are stamped a
period apart, from the moment of opening.
"""

import math
import sys
import threading
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated

import cv2
from pydantic import PositiveFloat, PositiveInt

from crenel.messages.message import Text, join, message, rounded
from crenel_hardware.clock import now_ns
from crenel_hardware.errors import DeviceError, device_lost_error
from crenel_hardware.options import Options, Shown, read_options
from crenel_hardware.sensor.grabbing import GrabbingSensor
from crenel_hardware.sensor.grey import (
    colour_taken,
    require_colour,
    to_grey,
)
from crenel_hardware.sensor.image_source import (
    EndOfRecordingError,
    GrabbedImage,
    ImageSource,
    NoImage,
    PlaybackTimer,
)
from crenel_hardware.shared_options import (
    EXPOSURE,
    RATE,
    Bayer,
    CameraLatency,
    ChosenLaserColour,
    ExposureRange,
    Loop,
)

_OPEN_MS, _READ_MS = 5000, 3000
_STREAMS = ("rtsp", "rtsps", "http", "https", "rtmp", "rtmps", "udp", "srt")
"""FFmpeg has further kinds, which read files and pipes."""
_STAMP_AGE_NS = 1_000_000_000
_V4L2_MANUAL = 1


class OpenCvOptions(Options):
    """Options of the driver in station.toml."""

    title = message("driver-opencv")
    usual = True
    source: Annotated[int | str, Shown(message("option-source"))]
    width_px: Annotated[PositiveInt | None, Shown(message("option-width"))] = None
    height_px: Annotated[PositiveInt | None, Shown(message("option-height"))] = None
    rate_hz: Annotated[PositiveFloat | None, RATE] = None
    exposure_us: Annotated[PositiveFloat | None, EXPOSURE] = None
    exposure_range_us: ExposureRange = None
    latency_us: CameraLatency = 0.0
    loop: Loop = False
    laser_colour: ChosenLaserColour = None
    bayer: Bayer = None


def from_options(options: Mapping[str, object]) -> GrabbingSensor:
    """The driver for one ``[sensor]`` table of station.toml; raises ``DeviceError``."""
    read = read_options(OpenCvOptions, options, "sensor")
    if read.exposure_range_us is not None and read.exposure_us is None:
        raise DeviceError(
            message("station-toml-exposure-range-alone"),
            message("add-exposure-us-line"),
        )

    require_colour(read.bayer, read.laser_colour)

    def connect(stop: threading.Event) -> ImageSource:
        return _Recording(read, stop) if _is_file(read.source) else _Camera(read)

    return GrabbingSensor(_title(read.source), connect, first_within_s=_OPEN_MS / 1000 + 5)


class _Recording(ImageSource):
    """A video file, played at its rate."""

    waits = True

    def __init__(self, options: OpenCvOptions, stop: threading.Event) -> None:
        self._path = Path(str(options.source))
        self._title = _title(options.source)
        for key in ("width_px", "height_px", "exposure_us"):
            if getattr(options, key) is not None:
                raise DeviceError(
                    message("station-toml-key-not-for-video", key=key),
                    message("take-out", key=key),
                )
        self._loop = options.loop
        self._laser_colour, self._bayer = options.laser_colour, options.bayer
        self._capture = self._open()
        rate_hz = options.rate_hz or self._capture.get(cv2.CAP_PROP_FPS)
        if not (math.isfinite(rate_hz) and rate_hz > 0):
            raise DeviceError(
                message("video-without-rate", title=self._title), message("set-sensor-rate-hz")
            )
        self._pace = PlaybackTimer(rate_hz, stop)
        self.name = self._path.name

    def grab(self) -> GrabbedImage | NoImage:
        there, raw = self._capture.read()
        if not there:
            if not self._loop:
                raise EndOfRecordingError
            self._capture.release()
            self._capture = self._open()
            there, raw = self._capture.read()
            if not there:
                raise DeviceError(
                    message("video-has-no-picture", title=self._title), message("is-file-complete")
                )
        image = to_grey(raw, raw.shape[0], self._laser_colour, self._bayer)
        self.selected = self.selected or colour_taken(raw, self._laser_colour, self._bayer)
        due_ns = self._pace.wait()
        return NoImage.DAMAGED if image is None else GrabbedImage(image, due_ns, 0.0)

    def release(self) -> None:
        self._capture.release()

    def _open(self) -> cv2.VideoCapture:
        if not self._path.is_file():
            raise DeviceError(
                message("no-video-file-named", path=self._path), message("check-sensor-source")
            )
        capture = cv2.VideoCapture(str(self._path), cv2.CAP_FFMPEG)
        if not capture.isOpened():
            raise DeviceError(
                message("device-cannot-be-played", title=self._title),
                message("is-it-a-complete-video"),
            )
        return capture


class _Camera(ImageSource):
    """A camera or a network stream, which comes when it comes."""

    waits = False

    def __init__(self, options: OpenCvOptions) -> None:
        self._title = _title(options.source)
        self._laser_colour, self._bayer = options.laser_colour, options.bayer
        self._latency_ns = round(options.latency_us * 1000)
        self._exposure_us = 0.0
        self._last_ns = 0
        self.name, self.serial_number = usb_identity(options.source)
        self._capture = _open_live(options.source, self._title)
        self._backend = self._capture.getBackendName()
        try:
            self._configure(options)
        except DeviceError:
            self._capture.release()
            raise

    def grab(self) -> GrabbedImage | NoImage:
        if not self._capture.grab():
            raise device_lost_error(self._title)
        event_ns = self._event_ns(now_ns())
        there, raw = self._capture.retrieve()
        if not there:
            return NoImage.DAMAGED
        image = to_grey(raw, self._height_px or raw.shape[0], self._laser_colour, self._bayer)
        if image is None:
            return NoImage.DAMAGED
        self.selected = self.selected or colour_taken(raw, self._laser_colour, self._bayer)
        exposure_us = self._exposure_us
        mid_ns = event_ns - self._latency_ns - round(exposure_us * 500)
        self._last_ns = max(mid_ns, self._last_ns + 1)
        return GrabbedImage(image, self._last_ns, exposure_us)

    def set_exposure_us(self, exposure_us: float) -> None:
        shortest, longest = self.exposure_range_us
        if shortest < longest:
            self._apply_exposure(exposure_us)

    def release(self) -> None:
        self._capture.release()

    def _event_ns(self, arrival_ns: int) -> int:
        if self._backend == "V4L2":
            buffer_ns = round(self._capture.get(cv2.CAP_PROP_POS_MSEC) * 1e6)
            if 0 <= arrival_ns - buffer_ns < _STAMP_AGE_NS:
                return buffer_ns
        return arrival_ns

    def _configure(self, options: OpenCvOptions) -> None:
        wanted = {
            "width_px": (cv2.CAP_PROP_FRAME_WIDTH, options.width_px),
            "height_px": (cv2.CAP_PROP_FRAME_HEIGHT, options.height_px),
            "rate_hz": (cv2.CAP_PROP_FPS, options.rate_hz),
        }
        for prop, value in wanted.values():
            if value is not None:
                self._capture.set(prop, value)
        for key, (prop, value) in wanted.items():
            given = self._capture.get(prop)
            if value is not None and abs(given - value) > 0.02 * value:
                raise DeviceError(
                    message(
                        "camera-cannot-do",
                        title=self._title,
                        key=key,
                        value=f"{value:g}",
                        given=f"{given:g}",
                    ),
                    message("correct-sensor-take-out", key=key),
                )
        # The camera's own luma or raw pixels, where the system passes them on unconverted.
        raw = self._laser_colour is None or self._bayer is not None
        if self._backend == "V4L2" and raw:
            self._capture.set(cv2.CAP_PROP_CONVERT_RGB, 0)
        self._height_px = int(self._capture.get(cv2.CAP_PROP_FRAME_HEIGHT))
        if options.exposure_us is not None:
            self._apply_exposure(options.exposure_us)
            shortest, longest = options.exposure_range_us or (self._exposure_us,) * 2
            self.exposure_range_us = (shortest, longest)

    def _apply_exposure(self, exposure_us: float) -> None:
        setting, actual_us = exposure_setting(self._backend, exposure_us)
        if self._backend == "V4L2":
            self._capture.set(cv2.CAP_PROP_AUTO_EXPOSURE, _V4L2_MANUAL)
        if not self._capture.set(cv2.CAP_PROP_EXPOSURE, setting):
            raise DeviceError(
                message(
                    "does-not-take-exposure", title=self._title, exposure=rounded(actual_us, "µs")
                ),
                message("correct-sensor-exposure-us-take-out"),
            )
        self._exposure_us = actual_us


def exposure_setting(backend: str, exposure_us: float) -> tuple[float, float]:
    """What to set for an exposure, and what that is in µs.

    V4L2 counts in whole 100 µs; Windows' interfaces in whole powers of two of a second.
    """
    if backend == "V4L2":
        steps = max(1, round(exposure_us / 100))
        return float(steps), 100.0 * steps
    power = round(math.log2(exposure_us * 1e-6))
    return float(power), 1e6 * 2.0**power


def usb_identity(
    source: int | str, classes: Path = Path("/sys/class/video4linux")
) -> tuple[str, str]:
    """Name and serial number of a camera, where Linux knows them; else the source, and ""."""
    node = f"video{source}" if isinstance(source, int) else Path(source).resolve().name
    name, serial_number = classes / node / "name", classes / node / "device" / ".." / "serial"
    return (
        name.read_text().strip() if name.is_file() else str(source),
        serial_number.read_text().strip() if serial_number.is_file() else "",
    )


def _is_file(source: int | str) -> bool:
    return isinstance(source, str) and "://" not in source and not source.startswith("/dev/")


def _title(source: int | str) -> Text:
    if _is_file(source):
        return message("video-file", source=source)
    is_stream = isinstance(source, str) and "://" in source
    return message("video-stream", source=source) if is_stream else message("camera", source=source)


def _open_live(source: int | str, title: Text) -> cv2.VideoCapture:
    # A camera that is away is tried again and again; OpenCV would warn each time.
    cv2.utils.logging.setLogLevel(cv2.utils.logging.LOG_LEVEL_ERROR)
    if isinstance(source, str) and "://" in source:
        if source.partition("://")[0].lower() not in _STREAMS:
            kinds = ", ".join(f"{kind}://" for kind in _STREAMS)
            raise DeviceError(
                message("device-cannot-be-opened", title=title),
                message("enter-stream-address", kinds=kinds),
            )
        timeouts = [cv2.CAP_PROP_OPEN_TIMEOUT_MSEC, _OPEN_MS]
        timeouts += [cv2.CAP_PROP_READ_TIMEOUT_MSEC, _READ_MS]
        capture = cv2.VideoCapture(source, cv2.CAP_FFMPEG, timeouts)
        remedy: Text = message("check-address-network-and-power")
    else:
        on_linux = sys.platform == "linux"
        capture = cv2.VideoCapture(source, cv2.CAP_V4L2 if on_linux else cv2.CAP_ANY)
        remedy = join([message("check-cable-no-other-program-uses"), *_cameras()], " ")
    if not capture.isOpened():
        raise DeviceError(message("device-cannot-be-opened", title=title), remedy)
    return capture


def _cameras() -> list[Text]:
    """Which cameras there are, in a sentence; nothing where there is none."""
    names = sorted(str(path) for path in Path("/dev").glob("video*"))
    return [message("cameras-are", names=", ".join(names))] if names else []
