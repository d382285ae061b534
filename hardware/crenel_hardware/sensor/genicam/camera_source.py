"""What sources of industrial cameras have in common, whichever library reaches the camera."""

import math
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

from crenel.messages.message import Text, join, message
from crenel_hardware.clock import now_ns
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import Delivery, SelectedColour
from crenel_hardware.sensor.genicam.block_ids import BlockCounter
from crenel_hardware.sensor.genicam.features import FeatureCamera, FeatureError
from crenel_hardware.sensor.genicam.picture_times import PictureTimes, SettingHistory
from crenel_hardware.sensor.genicam.pixel_formats import PixelFormat, decode, format_of
from crenel_hardware.sensor.genicam.profiles.profile_points import (
    COORDINATE_CODES,
    ArrivedImage,
    Brightness,
    ProfileFormat,
    line_points,
)
from crenel_hardware.sensor.genicam.profiles.scan_type import (
    offers_profiles,
    set_pictures,
    set_profiles,
)
from crenel_hardware.sensor.genicam.settings import (
    CameraOptions,
    ProfileOptions,
    apply_options,
    switch_laser,
)
from crenel_hardware.sensor.genicam.setup.offers import camera_offers
from crenel_hardware.sensor.genicam.setup.refusals import (
    settings_refusal_error,
    unknown_format_error,
)
from crenel_hardware.sensor.genicam.slow_line import SlowLine
from crenel_hardware.sensor.grey import to_grey
from crenel_hardware.sensor.image_source import (
    GrabbedImage,
    GreyImage,
    ImageSource,
    LinePoints,
    NoImage,
)

INCOMPLETE_S = 2.0
"""A camera that sends no whole picture for longer is refused."""
_FEWEST_INCOMPLETE = 10
_LONGEST_GAPS = 3
_QUEUE_S = 0.4
_QUEUE_BYTES = 128_000_000
_QUEUE_LINES = 1024


@dataclass(frozen=True, slots=True)
class ArrivedPicture:
    """One picture as it arrived; its bytes need to be valid only until the next one."""

    block_id: int
    whole: bool
    arrival_ns: int
    """Host-monotonic time at which its first packet arrived."""
    device_ns: int | None
    """The camera's stamp; None if it does not stamp its pictures."""
    exposure_us: float | None
    """As the camera states it with the picture; None if it does not."""
    image: ArrivedImage
    brightness: Brightness | None = None
    """The brightness of the line, beside a profile."""


class CameraSource(ImageSource):
    """Settings, exposure, laser, pictures and lines of an open camera. Raises ``DeviceError``.

    A subclass opens the camera, calls ``set_up``, and passes what arrives to ``show``. One whose
    options are ``ProfileOptions`` also has ``stop_stream`` and ``start_stream``.

    Args:
        title: the camera in words, for errors.
        options: from station.toml.
    """

    waits = False
    no_picture_remedy = message("check-firewall-for-pictures")

    def __init__(self, title: Text, options: CameraOptions) -> None:
        self._title = title
        self._options = options

    def set_up(self, camera: FeatureCamera) -> None:
        """Sets the options in an open camera; raises ``FeatureError``, too."""
        options = self._options
        self._features = camera
        profiles = isinstance(options, ProfileOptions) and offers_profiles(camera)
        settings = apply_options(self._title, camera, options)
        self.offers = camera_offers(camera)
        self.exposure_range_us = settings.exposure_range_us
        self.has_laser_switch = options.laser_line is not None
        self.free_running = options.trigger is None
        self.stamps, self.stamp_at = "device", options.stamp_at
        if settings.rate_hz and self.free_running:
            self.longest_gap_s = _LONGEST_GAPS / settings.rate_hz
        self._settings = settings
        _, _, width_px, height_px = settings.region
        fewest = self.queue_length
        most = max(fewest, _QUEUE_BYTES // (2 * width_px * height_px))
        self.queue_length = min(max(fewest, math.ceil(_QUEUE_S * (settings.rate_hz or 0))), most)
        bayer = options.bayer or settings.pixel_format.bayer
        is_raw = bayer is not None
        in_colour = is_raw or settings.pixel_format.channels is not None
        if options.laser_colour is not None and in_colour:
            self.selected = SelectedColour(options.laser_colour, bayer)
        self.size_px = (width_px // 2, height_px // 2) if is_raw else (width_px, height_px)
        if profiles and not is_raw:
            self.delivers = frozenset({"picture", "line"})
        self._exposures = SettingHistory(settings.exposure_us)
        self._laser = SettingHistory(not self.has_laser_switch)
        self._blocks = BlockCounter()
        self.line = SlowLine()
        self.times = PictureTimes(self._exposures, options.stamp_at, options.latency_us)
        self._whole_s = time.monotonic()
        self._incomplete = 0
        self._format: PixelFormat | None = None
        self._profile: ProfileFormat | None = None
        self._restarts = 0

    @contextmanager
    def opening(self) -> Iterator[None]:
        """Opens the camera within; what was opened is released if that fails."""
        try:
            yield
        except FeatureError as error:
            self.release()
            raise settings_refusal_error(self._title, error) from error
        except BaseException:
            self.release()
            raise

    def set_exposure_us(self, exposure_us: float) -> None:
        try:
            self._features.set_quantity("exposure_time", exposure_us)
            self._exposures.change(now_ns(), self._features.quantity("exposure_time"))
        except FeatureError as error:
            self.require_answer()
            raise settings_refusal_error(self._title, error) from error

    def set_laser(self, on: bool) -> None:
        # a picture is lit if the laser was on from the beginning to the end of its exposure
        if not on:
            self._laser.change(now_ns(), False)
        try:
            switch_laser(self._features, on)
        except FeatureError as error:
            raise settings_refusal_error(self._title, error) from error
        if on:
            self._laser.change(now_ns(), True)

    def set_delivery(self, delivery: Delivery) -> DeviceError | None:
        if (delivery == "line") == (self._profile is not None):
            return None
        try:
            self.stop_stream()
            refusal = self._change(delivery)
            self._blocks.restart()
            self.times.restart()
            self._restarts += 1
            self.line, self._whole_s, self._incomplete = SlowLine(), time.monotonic(), 0
            self.start_stream()
        except FeatureError as error:
            self.require_answer()
            raise settings_refusal_error(self._title, error) from error
        return refusal

    def _change(self, delivery: Delivery) -> DeviceError | None:
        """Sets the camera, which is stopped; returns why it does not send lines."""
        options = self._options
        assert isinstance(options, ProfileOptions)
        setup = self._title, self._features, options, self._settings, self._exposures.latest
        refusal = None
        if delivery == "line":
            try:
                self._profile = set_profiles(*setup)
                self.queue_length = max(self.queue_length, _QUEUE_LINES)
                return None
            except DeviceError as error:
                self.require_answer()
                refusal = error
        set_pictures(*setup)
        self._profile = None
        return refusal

    def stop_stream(self) -> None:
        """Ends the acquisition, and forgets what has not been taken; raises ``FeatureError``."""
        raise NotImplementedError

    def start_stream(self) -> None:
        """Begins an acquisition with the present settings; raises ``FeatureError``."""
        raise NotImplementedError

    def require_answer(self) -> None:
        """Asks the camera; raises ``DeviceError`` if it is lost."""
        raise NotImplementedError

    def show(self, picture: ArrivedPicture, is_late: bool = False) -> GrabbedImage | NoImage:
        """The picture as ``grab`` returns it. An incomplete one is not shown, but counted.

        ``is_late``: the line is known to be too slow.

        Raises:
            DeviceError: only incomplete ones have arrived for some time, the pixel format is not
                known, or the camera's clock was set.
        """
        stamp_ns = picture.device_ns if picture.whole else None
        if stamp_ns is not None and self.times.is_straggler(stamp_ns):
            return NoImage.SILENCE
        number = self._blocks.count(picture.block_id, picture.whole, stamp_ns)
        if not picture.whole:
            self._note_incomplete()
            return NoImage.SILENCE
        self._incomplete, self._whole_s = 0, time.monotonic()
        if number is None:
            return NoImage.SILENCE
        if stamp_ns is not None and self.times.has_jumped(stamp_ns, picture.arrival_ns):
            raise DeviceError(
                message("camera-clock-jumped", title=self._title), message("opens-again")
            )
        image: GreyImage | LinePoints | None
        if self._profile is None:
            image = self._decode(picture.image)
        else:
            image = self._points(picture.image, picture.brightness)
        if image is None:
            return NoImage.DAMAGED
        mid_ns, exposure_us = self.times.middle(
            picture.device_ns, picture.arrival_ns, picture.exposure_us
        )
        self.stamps, self.stamp_at = self.times.stamps, self.times.stamp_at
        half_ns = round(exposure_us * 500)
        if self.stamps == "device":
            is_late |= self.line.holds_up(number, mid_ns + half_ns, picture.arrival_ns)
        lit = self._laser.values_between(mid_ns - half_ns, mid_ns + half_ns)
        return GrabbedImage(
            image,
            mid_ns,
            exposure_us,
            sequence=number,
            full_scale=None if self._format is None else self._format.full_scale,
            # triggers between two acquisitions are not counted: a gap shows that some are missing
            pulse=None if self.free_running else number + 1 + self._restarts,
            laser_on=lit == {True},
            late=is_late,
        )

    def _decode(self, image: ArrivedImage) -> GreyImage | None:
        data, code, width_px, height_px, padding = image
        if self._format is None or self._format.code != code:
            self._format = format_of(code)
            if self._format is None:
                raise unknown_format_error(self._title, f"0x{code:08X}")
        raw = decode(data, self._format, width_px, height_px, padding)
        if raw is None:
            return None
        options = self._options
        return to_grey(raw, height_px, options.laser_colour, options.bayer or self._format.bayer)

    def _points(self, rows: ArrivedImage, brightness: Brightness | None) -> LinePoints | None:
        assert self._profile is not None
        if rows.code not in COORDINATE_CODES:
            raise unknown_format_error(self._title, f"0x{rows.code:08X}")
        if (rows.width_px, rows.height_px) != (self._profile.size_px[0], 1):
            return None
        return line_points(rows.data, rows.code, self._profile, brightness)

    def _note_incomplete(self) -> None:
        self._incomplete += 1
        since_s = time.monotonic() - self._whole_s
        if self._incomplete >= _FEWEST_INCOMPLETE and since_s > INCOMPLETE_S:
            check: Text = message("check-packet-size-and-network")
            raise DeviceError(
                message("pictures-arrive-incomplete", title=self._title),
                join([check, self.loss_remedy], " ") if self.loss_remedy else check,
            )
