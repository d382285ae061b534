"""The pictures of a camera, as they arrive."""

import ctypes
import time
from collections.abc import Iterator
from contextlib import contextmanager
from ctypes import byref, c_int, c_size_t
from dataclasses import dataclass

import numpy as np

from crenel_hardware.clock import now_ns
from crenel_hardware.sensor.genicam.aravis import AravisError
from crenel_hardware.sensor.genicam.camera import AravisCamera
from crenel_hardware.sensor.genicam.pixel_formats import Bytes
from crenel_hardware.sensor.genicam.profiles.profile_points import NO_IMAGE, ArrivedImage

_SUCCESS = 0
_FEWEST_BUFFERS, _MOST_BUFFERS = 8, 64
_BUFFER_BYTES = 256_000_000
_SMALL_BYTES, _SMALL_BUFFERS = 65_536, 512
"""A block no larger than the first is a profile; they come far more often than pictures."""
_OLDEST_ARRIVAL_NS = 2_000_000_000
_STREAM_COUNT = "arv_stream_get_info_uint64_by_name"


@dataclass(frozen=True, slots=True)
class StreamBlock:
    """One picture of the stream, in the memory of Aravis: valid until the next one is taken."""

    block_id: int
    whole: bool
    arrival_ns: int
    """Host-monotonic time at which its first packet arrived."""
    device_ns: int | None
    """The camera's stamp; None if it does not stamp its pictures."""
    handle: int


class CameraStream:
    """The stream of an open camera. Lost packets of GigE Vision are requested again.

    Raises ``AravisError``.
    """

    def __init__(self, camera: AravisCamera) -> None:
        self._aravis = camera.aravis
        self._handle: int = camera.call("create_stream", None, None) or 0
        if not self._handle:
            raise AravisError("the camera has no stream")
        payload = camera.call("get_payload")
        most = _SMALL_BUFFERS if payload <= _SMALL_BYTES else _MOST_BUFFERS
        count = min(max(_BUFFER_BYTES // max(payload, 1), _FEWEST_BUFFERS), most)
        for _ in range(count):
            self._push(self._aravis.call("arv_buffer_new_allocate", payload))

    @contextmanager
    def take(self, timeout_s: float) -> Iterator[StreamBlock | None]:
        """The next block, or None after ``timeout_s``."""
        handle = self._aravis.call(
            "arv_stream_timeout_pop_buffer", self._handle, round(timeout_s * 1e6)
        )
        if handle is None:
            yield None
            return
        try:
            yield self._read_block(handle)
        finally:
            self._push(handle)

    def images(self, block: StreamBlock) -> list[ArrivedImage]:
        """The image of a block, or all its parts; the bytes are not copied."""
        parts = 0
        if self._aravis.has("arv_buffer_get_n_parts"):
            parts = self._aravis.call("arv_buffer_get_n_parts", block.handle)
        if parts <= 1 and (image := self._image(block)).data.size:
            return [image]
        return [self._part(block, number) for number in range(parts)] or [NO_IMAGE]

    def _part(self, block: StreamBlock, number: int) -> ArrivedImage:
        size, x, y = c_size_t(), c_int(), c_int()
        at = self._aravis.call("arv_buffer_get_part_data", block.handle, number, byref(size))
        self._aravis.call("arv_buffer_get_part_padding", block.handle, number, byref(x), byref(y))
        code, width_px, height_px = (
            self._aravis.call(f"arv_buffer_get_part_{name}", block.handle, number)
            for name in ("pixel_format", "width", "height")
        )
        return ArrivedImage(_bytes_at(at, size.value), code, width_px, height_px, x.value)

    def _image(self, block: StreamBlock) -> ArrivedImage:
        size, x, y = c_size_t(), c_int(), c_int()
        at = self._aravis.call("arv_buffer_get_image_data", block.handle, byref(size))
        self._aravis.call("arv_buffer_get_image_padding", block.handle, byref(x), byref(y))
        code, width_px, height_px = (
            self._aravis.call(f"arv_buffer_get_image_{name}", block.handle)
            for name in ("pixel_format", "width", "height")
        )
        return ArrivedImage(_bytes_at(at, size.value), code, width_px, height_px, x.value)

    @property
    def transferred_bytes(self) -> int | None:
        """All that have arrived since the start; None of an Aravis that does not count them."""
        if not self._handle or not self._aravis.has(_STREAM_COUNT):
            return None
        return int(self._aravis.call(_STREAM_COUNT, self._handle, b"n_transferred_bytes"))

    def close(self) -> None:
        """Ends the thread of Aravis, and frees the buffers; idempotent."""
        handle, self._handle = self._handle, 0
        if handle:
            self._aravis.call("g_object_unref", handle)

    def _push(self, buffer: int) -> None:
        if self._handle:
            self._aravis.call("arv_stream_push_buffer", self._handle, buffer)

    def _read_block(self, handle: int) -> StreamBlock:
        status, block_id, device_ns, system_ns = (
            self._aravis.call(f"arv_buffer_get_{name}", handle)
            for name in ("status", "frame_id", "timestamp", "system_timestamp")
        )
        # Aravis notes the arrival on the wall clock, and copies it where the camera has no stamp.
        age_ns, now = time.time_ns() - system_ns, now_ns()
        return StreamBlock(
            block_id,
            status == _SUCCESS,
            now - age_ns if 0 <= age_ns < _OLDEST_ARRIVAL_NS else now,
            device_ns if device_ns not in (0, system_ns) else None,
            handle,
        )


def _bytes_at(at: int | None, size: int) -> Bytes:
    """Memory of Aravis, not copied."""
    if not at or not size:
        return np.empty(0, np.uint8)
    held = (ctypes.c_uint8 * size).from_address(at)
    return np.frombuffer(memoryview(held), np.uint8)
