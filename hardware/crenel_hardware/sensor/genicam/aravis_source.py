"""A camera that Aravis reaches, as a source of pictures."""

import threading
import time
from pathlib import Path
from typing import Any

from crenel.loops import start_worker
from crenel.messages.message import Text, message, quantity
from crenel_hardware.clock import now_ns
from crenel_hardware.errors import DeviceError
from crenel_hardware.sensor.genicam.aravis import AravisError
from crenel_hardware.sensor.genicam.camera import open_camera
from crenel_hardware.sensor.genicam.camera_source import ArrivedPicture, CameraSource
from crenel_hardware.sensor.genicam.gige_vision.camera_clock import CameraClock
from crenel_hardware.sensor.genicam.link import CameraLink, control_lost_error
from crenel_hardware.sensor.genicam.profiles.profile_points import NO_IMAGE, choose_image
from crenel_hardware.sensor.genicam.settings import GenicamOptions, switch_laser
from crenel_hardware.sensor.genicam.setup.refusals import settings_refusal_error
from crenel_hardware.sensor.genicam.stream import CameraStream, StreamBlock
from crenel_hardware.sensor.image_source import EndOfRecordingError, GrabbedImage, NoImage

LIMIT = Path("/proc/sys/net/core/rmem_max")
"""Linux: the largest receive buffer of a socket that a program without privileges may request."""
_ADVISED_BYTES = 33_554_432


def receive_buffer_remedy(picture_bytes: int, limit: Path = LIMIT) -> Text:
    """What to do where the limit is smaller than one picture; empty if it is not, or not known.

    Aravis requests a buffer of one picture. In a smaller one, packets are lost as soon as the
    computer is busy with something else for a few milliseconds.

    Args:
        picture_bytes: the payload of the camera.
    """
    try:
        limit_bytes = int(limit.read_text())
    except (OSError, ValueError):
        return ""
    if limit_bytes >= picture_bytes:
        return ""
    return message(
        "raise-receive-buffer",
        limit=quantity(limit_bytes / 1e3, "kB"),
        picture=quantity(picture_bytes / 1e3, "kB"),
        command=f"sudo sysctl -w net.core.rmem_max={_ADVISED_BYTES}",
    )


_WAIT_S = 0.1
_SILENT_S = 0.3


class GenicamSource(CameraSource):
    """An open camera with GigE Vision or USB3 Vision. Raises ``DeviceError``.

    Args:
        title: the camera in words, for errors.
        stop: an event that is set when ``grab`` must end.
    """

    def __init__(self, title: Text, options: GenicamOptions, stop: threading.Event) -> None:
        super().__init__(title, options)
        self._chunks = options.chunks
        self._stop = stop
        self._lost = False
        self.camera = open_camera(title, options.address, options.serial_number)
        self._stream: CameraStream | None = None
        self._parser: int | None = None
        self._link: CameraLink | None = None
        with self.opening():
            self._start()

    def _start(self) -> None:
        camera = self.camera
        self.name = " ".join(
            dict.fromkeys((camera.text("get_vendor_name"), camera.text("get_model_name")))
        ).strip()
        self.serial_number = camera.text("get_device_serial_number")
        self._link = CameraLink(self._title, camera)
        self.set_up(camera)
        self._ticks_hz = 1_000_000_000
        if self._chunks:
            if camera.has("GevTimestampTickFrequency"):
                self._ticks_hz = camera.integer("GevTimestampTickFrequency") or self._ticks_hz
            self._parser = camera.call("create_chunk_parser")
        self._clock = CameraClock(camera)
        if camera.is_gige:
            self.loss_remedy = receive_buffer_remedy(camera.call("get_payload"))
        self.start_stream()

    def start_stream(self) -> None:
        self._stream = CameraStream(self.camera)
        self.camera.call("start_acquisition")
        self._heard_s = time.monotonic()

    def stop_stream(self) -> None:
        self.camera.call("stop_acquisition")
        if self._stream is not None:
            self._stream.close()
            self._stream = None

    def grab(self) -> GrabbedImage | NoImage:
        if self._stop.is_set():
            raise EndOfRecordingError
        assert self._stream is not None
        if not self.camera.has_control:
            self.require_answer()
            raise control_lost_error(self._title)
        with self._stream.take(_WAIT_S) as block:
            is_slow = self._is_line_slow(self._stream, block is not None)
            if block is not None:
                self._heard_s = time.monotonic()
                self._compare_clocks()
                if self._is_of_before(block):
                    return NoImage.SILENCE
                return self.show(self._complete(self._stream, block), is_slow)
        if time.monotonic() - self._heard_s > _SILENT_S:
            self.require_answer()
        return NoImage.LATE if is_slow else NoImage.SILENCE

    def _is_line_slow(self, stream: CameraStream, has_arrived: bool) -> bool:
        transferred_bytes = stream.transferred_bytes
        return transferred_bytes is not None and self.line.is_too_slow(
            now_ns(), transferred_bytes, has_arrived
        )

    def _compare_clocks(self) -> None:
        """Right after a picture, when the camera is there: a lost one is noticed elsewhere."""
        try:
            compared = self._clock.read()
        except AravisError:
            return
        if compared is not None:
            self.times.compare(*compared)

    def is_alive(self) -> bool:
        return self._link is not None and self._link.is_alive()

    def require_answer(self) -> None:
        """Raises ``DeviceError`` if the camera does not answer, or obeys another program."""
        assert self._link is not None
        try:
            self._link.require_control()
        except DeviceError:
            self._lost = True
            raise
        self._heard_s = time.monotonic()

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
            start_worker("camera-release", self._free)
        else:
            self._free()

    def _free(self) -> None:
        if self._stream is not None:
            self._stream.close()
        if self._parser is not None:
            self.camera.aravis.call("g_object_unref", self._parser)
        self.camera.close()

    def _is_of_before(self, block: StreamBlock) -> bool:
        """Whether the camera took a picture before it was set to append data to each."""
        if not self._chunks or not block.whole:
            return False
        return not self.camera.aravis.call("arv_buffer_has_chunks", block.handle)

    def _complete(self, stream: CameraStream, block: StreamBlock) -> ArrivedPicture:
        # of an incomplete block, not even the format may be known
        images = stream.images(block) if block.whole else [NO_IMAGE]
        image, brightness = choose_image(images)
        return ArrivedPicture(
            block_id=block.block_id,
            whole=block.whole,
            arrival_ns=block.arrival_ns,
            device_ns=self._device_ns(block),
            exposure_us=self._exposure_us(block),
            image=image,
            brightness=brightness,
        )

    def _exposure_us(self, block: StreamBlock) -> float | None:
        if "ExposureTime" not in self._chunks or not block.whole:
            return None
        return float(self._chunk("float", block, b"ChunkExposureTime"))

    def _device_ns(self, block: StreamBlock) -> int | None:
        if "Timestamp" not in self._chunks or not block.whole:
            return block.device_ns
        ticks: int = self._chunk("integer", block, b"ChunkTimestamp")
        return ticks * 1_000_000_000 // self._ticks_hz or None

    def _chunk(self, kind: str, block: StreamBlock, name: bytes) -> Any:
        try:
            return self.camera.aravis.call(
                f"arv_chunk_parser_get_{kind}_value", self._parser, block.handle, name
            )
        except AravisError as error:
            raise settings_refusal_error(self._title, error) from error
