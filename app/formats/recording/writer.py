"""Writing a scan recording (MCAP) while it is taken."""

import os
import threading
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import TracebackType
from typing import Self

from foxglove import Channel, Context, Schema, open_mcap
from foxglove.channels import JointStatesChannel, RawImageChannel
from foxglove.mcap import MCAPCompression, MCAPWriteOptions
from foxglove.messages import JointState, JointStates, RawImage, Timestamp

from app.formats.atomic_write import sync_folder
from app.formats.images import GreyImage
from app.formats.io_errors import convert_io_errors, error_from_os
from app.formats.recording.decoders import IMAGE_TOPIC, JOINTS_TOPIC, STRIPE_TOPIC
from app.formats.recording.reader import STATION_METADATA
from app.formats.recording.stripe_message import STRIPE_SCHEMA, encode_stripe, stripe_descriptors
from app.metrology.stripe import Stripe
from app.metrology.transforms import Floats

CHUNK_BYTES = 1 << 20


class RecordingWriter:
    """A recording that grows on disk; what is there is readable at any moment.

    Chunks of 1 MiB go to disk as they fill, LZ4 compressed, so that a killed process
    loses less than one of them. For use from one thread, but for ``sync``. ``close``
    completes the file and syncs it; leaving the ``with`` block closes.
    """

    def __init__(
        self, path: Path, joint_names: Sequence[str], station: Mapping[str, str] | None = None
    ) -> None:
        """Creates the file, which must not exist.

        Args:
            station: what is known of the devices and was set: ``arm_serial``,
                ``sensor_serial``, ``arm_delay_ns``, ``extraction``.

        Raises:
            OperationError: the file exists or cannot be created.
        """
        self._names = tuple(joint_names)
        self._sink = _Sink(path)
        # kept: its channels close with it
        self._context = context = Context()
        options = MCAPWriteOptions(
            compression=MCAPCompression.Lz4, chunk_size=CHUNK_BYTES, profile="crenel"
        )
        self._writer = open_mcap(self._sink, context=context, writer_options=options)
        self._writer.write_metadata(STATION_METADATA, dict(station or {}))
        self._joints = JointStatesChannel(JOINTS_TOPIC, context=context)
        self._images = RawImageChannel(IMAGE_TOPIC, context=context)
        self._stripes = Channel(
            STRIPE_TOPIC,
            message_encoding="protobuf",
            schema=Schema(name=STRIPE_SCHEMA, encoding="protobuf", data=stripe_descriptors()),
            context=context,
        )
        self._open = True

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def write_metadata(self, station: Mapping[str, str]) -> None:
        """What has changed of ``station``; a reader goes by what stands last."""
        self._writer.write_metadata(STATION_METADATA, dict(station))
        self._sink.check()

    @property
    def bytes_written(self) -> int:
        return self._sink.written

    def joints(self, stamp_ns: int, q_rad: Sequence[float] | Floats) -> None:
        """One reading of the arm, angles (n,) before sign and offset.

        Raises:
            OperationError: the disk is full or gone, as do the other two.
        """
        states = [
            JointState(name=name, position=float(angle))
            for name, angle in zip(self._names, q_rad, strict=True)
        ]
        message = JointStates(timestamp=_timestamp(stamp_ns), joints=states)
        self._joints.log(message, log_time=stamp_ns)
        self._sink.check()

    def stripe(self, stamp_ns: int, stripe: Stripe, width_px: int, height_px: int) -> None:
        """The stripe of a frame, by the stamp of its mid-exposure."""
        message = encode_stripe(stripe, stamp_ns, width_px, height_px)
        self._stripes.log(message, log_time=stamp_ns)
        self._sink.check()

    def image(self, stamp_ns: int, image: GreyImage) -> None:
        """A frame's picture (height, width), by the stamp of its mid-exposure."""
        height, width = image.shape
        self._images.log(
            RawImage(
                timestamp=_timestamp(stamp_ns),
                frame_id="sensor",
                width=width,
                height=height,
                encoding="mono8" if image.itemsize == 1 else "mono16",
                step=width * image.itemsize,
                data=image.astype(image.dtype.newbyteorder("<"), copy=False).tobytes(),
            ),
            log_time=stamp_ns,
        )
        self._sink.check()

    def flush(self) -> None:
        """Passes to the system what has come so far: a killed process does not lose it."""
        self._writer.flush()
        self._sink.check()

    def sync(self) -> None:
        """Brings to the disk what was flushed: a power failure does not lose it.

        From any thread, so that a slow disk holds up no writing; the next write raises
        where it failed.
        """
        self._sink.sync()

    def close(self) -> None:
        """Completes the file on disk; idempotent. Raises ``OperationError`` where it could not."""
        if not self._open:
            return
        self._open = False
        try:
            self._writer.close()
        finally:
            self._sink.close()
        self._sink.check()


class _Sink:
    """The file under the writer. A failure is kept for ``check``: the writer prints its own.

    After a failure the writer gets no error, and the position where it would stand, so that
    it ends in order; it does not bear to find itself elsewhere.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self._failure: OSError | None = None
        self._at = self._end = 0
        self.written = 0
        self._closing = threading.Lock()
        with convert_io_errors(path):
            self._file = open(path, "xb", buffering=0)  # noqa: SIM115  closed by close()
            sync_folder(path.parent)

    def write(self, data: bytes | bytearray) -> int:
        view = memoryview(data)
        try:
            while len(view) and self._failure is None:
                view = view[self._file.write(view) :]
        except OSError as error:
            self._failure = error
        self.written += len(data)
        self._at += len(data)
        self._end = max(self._end, self._at)
        return len(data)

    def seek(self, offset: int, whence: int = 0) -> int:
        self._at = offset + (0, self._at, self._end)[whence]
        if self._failure is None:
            self._file.seek(self._at)
        return self._at

    def flush(self) -> None:
        """Nothing is held back here."""

    def sync(self) -> None:
        with self._closing:
            if not self._file.closed:
                self._sync()

    def _sync(self) -> None:
        try:
            os.fsync(self._file.fileno())
        except OSError as error:
            self._failure = self._failure or error

    def close(self) -> None:
        with self._closing:
            self._sync()
            try:
                self._file.close()
            except OSError as error:
                self._failure = self._failure or error

    def check(self) -> None:
        if self._failure is not None:
            raise error_from_os(self._failure, self._path) from self._failure


def _timestamp(stamp_ns: int) -> Timestamp:
    seconds, nanoseconds = divmod(stamp_ns, 1_000_000_000)
    return Timestamp(sec=seconds, nsec=nanoseconds)
