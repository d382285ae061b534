"""A camera as a source of pictures."""

import math
import threading
import time
from typing import Any

from app.messages.message import Text, message
from hardware.clock import now_ns
from hardware.errors import DeviceError
from hardware.sensor.genicam.aravis import AravisError
from hardware.sensor.genicam.block_ids import BlockCounter
from hardware.sensor.genicam.camera import open_camera
from hardware.sensor.genicam.link import CameraLink, control_lost_error
from hardware.sensor.genicam.picture_times import PictureTimes, SettingHistory
from hardware.sensor.genicam.pixel_formats import PixelFormat, decode, format_of
from hardware.sensor.genicam.settings import (
    GenicamOptions,
    apply_options,
    switch_laser,
    unknown_format_error,
)
from hardware.sensor.genicam.stream import CameraStream, StreamBlock
from hardware.sensor.grey import to_grey
from hardware.sensor.image_source import (
    EndOfRecordingError,
    GrabbedImage,
    GreyImage,
    ImageSource,
    NoImage,
)

_WAIT_S = 0.1
_SILENT_S = 0.3
_INCOMPLETE_S = 2.0
_FEWEST_INCOMPLETE = 10
_LONGEST_GAPS = 3
_QUEUE_S = 0.4
_QUEUE_BYTES = 128_000_000


class GenicamSource(ImageSource):
    """An open camera with GigE Vision or USB3 Vision. Raises ``DeviceError``.

    Args:
        title: the camera in words, for errors.
        stop: an event that is set when ``grab`` must end.
    """

    waits = False
    no_picture_remedy = message("check-firewall-for-pictures")

    def __init__(self, title: Text, options: GenicamOptions, stop: threading.Event) -> None:
        self._title = title
        self._options = options
        self._stop = stop
        self._lost = False
        self.camera = open_camera(title, options.address, options.serial_number)
        self._stream: CameraStream | None = None
        self._parser: int | None = None
        self._link: CameraLink | None = None
        try:
            self._set_up()
        except AravisError as error:
            self.release()
            raise DeviceError(
                message("camera-refused-settings", title=title, reason=error),
                message("check-options-or-restart-camera"),
            ) from error
        except BaseException:
            self.release()
            raise

    def _set_up(self) -> None:
        options, camera = self._options, self.camera
        self.name = " ".join(
            dict.fromkeys((camera.text("get_vendor_name"), camera.text("get_model_name")))
        ).strip()
        self.serial_number = camera.text("get_device_serial_number")
        self._link = CameraLink(self._title, camera)
        settings = apply_options(self._title, camera, options)
        self.exposure_range_us = settings.exposure_range_us
        self.has_laser_switch = options.laser_line is not None
        self.free_running = options.trigger is None
        self.stamps, self.stamp_at = "device", options.stamp_at
        if settings.rate_hz and self.free_running:
            self.longest_gap_s = _LONGEST_GAPS / settings.rate_hz
        width_px, height_px = settings.size_px
        most = max(self.queue_length, _QUEUE_BYTES // (2 * width_px * height_px))
        self.queue_length = min(
            max(self.queue_length, math.ceil(_QUEUE_S * (settings.rate_hz or 0.0))), most
        )
        is_raw = (options.bayer or settings.pixel_format.bayer) is not None
        self.size_px = (width_px // 2, height_px // 2) if is_raw else (width_px, height_px)
        self._exposures = SettingHistory(settings.exposure_us)
        self._laser = SettingHistory(not self.has_laser_switch)
        self._blocks = BlockCounter()
        self._times = PictureTimes(self._exposures, options.stamp_at, options.latency_us)
        self._heard_s = self._whole_s = time.monotonic()
        self._incomplete = 0
        self._format: PixelFormat | None = None
        self._ticks_hz = 1_000_000_000
        if options.chunks:
            if camera.has("GevTimestampTickFrequency"):
                self._ticks_hz = camera.integer("GevTimestampTickFrequency") or self._ticks_hz
            self._parser = camera.call("create_chunk_parser")
        self._stream = CameraStream(camera)
        camera.call("start_acquisition")

    def grab(self) -> GrabbedImage | NoImage:
        if self._stop.is_set():
            raise EndOfRecordingError
        assert self._stream is not None
        if not self.camera.has_control:
            self._require_control()
            raise control_lost_error(self._title)
        with self._stream.take(_WAIT_S) as block:
            if block is not None:
                self._heard_s = time.monotonic()
                return self._receive(self._stream, block)
        if time.monotonic() - self._heard_s > _SILENT_S:
            self._require_control()
        return NoImage.SILENCE

    def set_exposure_us(self, exposure_us: float) -> None:
        try:
            self.camera.call("set_exposure_time", exposure_us)
            self._exposures.change(now_ns(), self.camera.call("get_exposure_time"))
        except AravisError as error:
            self._require_control()
            raise self._refusal(error) from error

    def set_laser(self, on: bool) -> None:
        # a picture is lit if the laser was on from the beginning to the end of its exposure
        if not on:
            self._laser.change(now_ns(), False)
        try:
            switch_laser(self.camera, on)
        except AravisError as error:
            raise self._refusal(error) from error
        if on:
            self._laser.change(now_ns(), True)

    def is_alive(self) -> bool:
        return self._link is not None and self._link.is_alive()

    def release(self) -> None:
        """Switches the laser off, stops the camera and gives it up."""
        if not self._lost and self._stream is not None:
            try:
                if self.has_laser_switch:
                    switch_laser(self.camera, False)
                self.camera.call("stop_acquisition")
            except AravisError:
                self._lost = True
        if self._link is not None:
            self._link.close()
        if self._lost:
            threading.Thread(target=self._free, name="giving up a camera", daemon=True).start()
        else:
            self._free()

    def _free(self) -> None:
        if self._stream is not None:
            self._stream.close()
        if self._parser is not None:
            self.camera.aravis.call("g_object_unref", self._parser)
        self.camera.close()

    def _refusal(self, error: AravisError) -> DeviceError:
        return DeviceError(
            message("camera-refused-settings", title=self._title, reason=error),
            message("check-options-or-restart-camera"),
        )

    def _require_control(self) -> None:
        """Raises ``DeviceError`` if the camera does not answer, or obeys another program."""
        assert self._link is not None
        try:
            self._link.require_control()
        except DeviceError:
            self._lost = True
            raise
        self._heard_s = time.monotonic()

    def _receive(self, stream: CameraStream, block: StreamBlock) -> GrabbedImage | NoImage:
        number = self._blocks.count(block.block_id)
        if not block.whole:
            self._note_incomplete()
            return NoImage.SILENCE
        self._incomplete, self._whole_s = 0, self._heard_s
        if number is None:
            return NoImage.SILENCE
        image = self._decode(stream, block)
        if image is None:
            return NoImage.DAMAGED
        mid_ns, exposure_us = self._times.middle(
            self._device_ns(block), block.arrival_ns, self._chunk_exposure_us(block)
        )
        self.stamps, self.stamp_at = self._times.stamps, self._times.stamp_at
        half_ns = round(exposure_us * 500)
        lit = self._laser.values_between(mid_ns - half_ns, mid_ns + half_ns)
        return GrabbedImage(
            image,
            mid_ns,
            exposure_us,
            sequence=number,
            full_scale=None if self._format is None else self._format.full_scale,
            pulse=None if self.free_running else number + 1,
            laser_on=lit == {True},
        )

    def _decode(self, stream: CameraStream, block: StreamBlock) -> GreyImage | None:
        data, code, width_px, height_px, padding = stream.image(block)
        if self._format is None or self._format.code != code:
            self._format = format_of(code)
            if self._format is None:
                raise unknown_format_error(self._title, f"0x{code:08X}")
        raw = decode(data, self._format, width_px, height_px, padding)
        if raw is None:
            return None
        options = self._options
        return to_grey(raw, height_px, options.laser_colour, options.bayer or self._format.bayer)

    def _chunk_exposure_us(self, block: StreamBlock) -> float | None:
        if "ExposureTime" not in self._options.chunks:
            return None
        return float(self._chunk("float", block, b"ChunkExposureTime"))

    def _device_ns(self, block: StreamBlock) -> int | None:
        if "Timestamp" not in self._options.chunks:
            return block.device_ns
        ticks: int = self._chunk("integer", block, b"ChunkTimestamp")
        return ticks * 1_000_000_000 // self._ticks_hz or None

    def _chunk(self, kind: str, block: StreamBlock, name: bytes) -> Any:
        try:
            return self.camera.aravis.call(
                f"arv_chunk_parser_get_{kind}_value", self._parser, block.handle, name
            )
        except AravisError as error:
            raise self._refusal(error) from error

    def _note_incomplete(self) -> None:
        """Raises ``DeviceError`` if no whole picture arrives for some time."""
        self._incomplete += 1
        if self._incomplete >= _FEWEST_INCOMPLETE and self._heard_s - self._whole_s > _INCOMPLETE_S:
            raise DeviceError(
                message("pictures-arrive-incomplete", title=self._title),
                message("check-packet-size-and-network"),
            )
