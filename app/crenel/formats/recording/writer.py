"""Writes a scan recording (MCAP) during the scan."""

import os
import threading
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import TracebackType
from typing import Self

from foxglove_schemas_protobuf.JointState_pb2 import JointState
from foxglove_schemas_protobuf.JointStates_pb2 import JointStates
from foxglove_schemas_protobuf.Pose_pb2 import Pose
from foxglove_schemas_protobuf.PoseInFrame_pb2 import PoseInFrame
from foxglove_schemas_protobuf.Quaternion_pb2 import Quaternion
from foxglove_schemas_protobuf.RawImage_pb2 import RawImage
from foxglove_schemas_protobuf.Vector3_pb2 import Vector3
from google.protobuf.timestamp_pb2 import Timestamp
from mcap.well_known import MessageEncoding, SchemaEncoding
from mcap.writer import CompressionType, Writer
from mcap_protobuf.schema import register_schema

from crenel.errors import OperationError
from crenel.formats.atomic_write import sync_folder
from crenel.formats.images import GreyImage
from crenel.formats.io_errors import convert_io_errors, error_from_os
from crenel.formats.recording.reader import STATION_METADATA
from crenel.formats.recording.stripe_message import STRIPE_SCHEMA, encode_stripe, stripe_descriptors
from crenel.formats.recording.topics import (
    IMAGE_TOPIC,
    JOINTS_TOPIC,
    POSE_TOPIC,
    STRIPE_TOPIC,
    sensor_topic,
)
from crenel.metrology.stripe import Stripe
from crenel.metrology.transforms import Floats
from crenel.units import MM_PER_M

CHUNK_BYTES = 1 << 20


class RecordingWriter:
    """A recording that grows on disk; its content is readable at any moment.

    Chunks of 1 MiB go to disk when they are full, LZ4 compressed, so that a killed process loses
    less than one of them. Each picture has a chunk of its own, so that stripes and joints can be
    read without them by the index of the chunks. For use from one thread, except ``sync``.
    ``close`` completes the file and syncs it; leaving the ``with`` block closes.
    """

    def __init__(
        self,
        path: Path,
        joint_names: Sequence[str] | None,
        station: Mapping[str, str] | None = None,
        sensors: Sequence[str] = ("",),
        log_offset_ns: int = 0,
    ) -> None:
        """Creates the file, which must not exist.

        Args:
            joint_names: of the arm's joints; None of an arm that reports poses.
            station: properties of the devices and settings: ``arm_serial``, ``sensor_serial``,
                ``arm_delay_ns``, ``extraction``.
            sensors: names of several sensors; the name of the only one is empty.
            log_offset_ns: added to time stamps, it gives the times at which messages are logged,
                those of the wall clock, by which other programs lay recordings beside each other.

        Raises:
            OperationError: the file exists or cannot be created.
        """
        self._names = None if joint_names is None else tuple(joint_names)
        self._log_offset_ns = log_offset_ns
        self._file = _SyncedFile(path)
        self._writer = Writer(
            self._file,  # type: ignore[arg-type]  # of a file it uses write, tell and flush
            chunk_size=CHUNK_BYTES,
            compression=CompressionType.LZ4,
        )
        try:
            self._writer.start(profile="crenel")
            self.write_metadata(station or {})
        except OperationError:
            self._file.close()
            raise
        self._readings = (
            self._channel(POSE_TOPIC, register_schema(self._writer, PoseInFrame))
            if self._names is None
            else self._channel(JOINTS_TOPIC, register_schema(self._writer, JointStates))
        )
        images = register_schema(self._writer, RawImage)
        self._images = {
            name: self._channel(sensor_topic(IMAGE_TOPIC, name), images) for name in sensors
        }
        stripes = self._writer.register_schema(
            STRIPE_SCHEMA, SchemaEncoding.Protobuf, stripe_descriptors()
        )
        self._stripes = {
            name: self._channel(sensor_topic(STRIPE_TOPIC, name), stripes) for name in sensors
        }
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
        """Updates ``station``; readers use the last record."""
        self._writer.add_metadata(STATION_METADATA, dict(station))

    @property
    def bytes_written(self) -> int:
        return self._file.tell()

    def reading(self, stamp_ns: int, reading: Sequence[float] | Floats) -> None:
        """One reading of the arm: joint angles (n,) in rad, or a pose (7,) in mm.

        Raises:
            OperationError: the disk is full or gone; the other methods raise the same.
        """
        if self._names is None:
            self._add(self._readings, stamp_ns, _pose_message(stamp_ns, reading))
        else:
            self.joints(stamp_ns, reading)

    def joints(self, stamp_ns: int, q_rad: Sequence[float] | Floats) -> None:
        """Angles (n,) in rad before sign and offset, of an arm with joints."""
        assert self._names is not None, "the recording is of an arm that reports poses"
        states = [
            JointState(name=name, position=angle)
            for name, angle in zip(self._names, q_rad, strict=True)
        ]
        message = JointStates(timestamp=_timestamp(stamp_ns), joints=states)
        self._add(self._readings, stamp_ns, message.SerializeToString())

    def stripe(
        self, stamp_ns: int, stripe: Stripe, width_px: int, height_px: int, sensor: str = ""
    ) -> None:
        """The stripe of a sensor's frame, with the time stamp of its mid-exposure."""
        data = encode_stripe(stripe, stamp_ns, width_px, height_px)
        self._add(self._stripes[sensor], stamp_ns, data)

    def image(self, stamp_ns: int, image: GreyImage, sensor: str = "") -> None:
        """The picture (height, width) of a frame, with the time stamp of its mid-exposure."""
        height, width = image.shape
        message = RawImage(
            timestamp=_timestamp(stamp_ns),
            frame_id="sensor",
            width=width,
            height=height,
            encoding="mono8" if image.itemsize == 1 else "mono16",
            step=width * image.itemsize,
            data=image.astype(image.dtype.newbyteorder("<"), copy=False).tobytes(),
        )
        self.flush()
        self._add(self._images[sensor], stamp_ns, message.SerializeToString())
        self.flush()

    def flush(self) -> None:
        """Passes everything so far to the operating system: a killed process does not lose it."""
        self._writer.flush()

    def sync(self) -> None:
        """Syncs to disk what was flushed: a power failure does not lose it.

        May be called from any thread, so that a slow disk does not delay writing; if it fails, the
        next write raises.
        """
        self._file.sync()

    def close(self) -> None:
        """Completes the file on disk; idempotent. Raises ``OperationError`` if it fails."""
        if not self._open:
            return
        self._open = False
        try:
            if self._file.failure is None:
                self._writer.finish()
        finally:
            self._file.close()
        if self._file.failure is not None:
            raise self._file.failure

    def _channel(self, topic: str, schema_id: int) -> int:
        return self._writer.register_channel(topic, MessageEncoding.Protobuf, schema_id)

    def _add(self, channel_id: int, stamp_ns: int, data: bytes) -> None:
        log_ns = stamp_ns + self._log_offset_ns
        self._writer.add_message(channel_id, log_ns, data, publish_time=log_ns)


class _SyncedFile:
    """The file of the writer, which can be synced from any thread.

    After a failure, nothing more is written: the content up to it stays readable.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self.failure: OperationError | None = None
        self._written = 0
        self._closing = threading.Lock()
        with convert_io_errors(path):
            self._file = open(path, "xb", buffering=0)  # noqa: SIM115  closed by close()
            sync_folder(path.parent)

    def write(self, data: bytes) -> int:
        """Writes all bytes; raises ``OperationError``, as does each write after a failure."""
        if self.failure is not None:
            raise self.failure
        view = memoryview(data)
        try:
            while len(view):
                view = view[self._file.write(view) :]
        except OSError as error:
            raise self._fail(error) from error
        self._written += len(data)
        return len(data)

    def tell(self) -> int:
        return self._written

    def flush(self) -> None:
        """Nothing is buffered here."""

    def sync(self) -> None:
        with self._closing:
            if not self._file.closed:
                self._sync()

    def close(self) -> None:
        with self._closing:
            self._sync()
            try:
                self._file.close()
            except OSError as error:
                self._fail(error)

    def _sync(self) -> None:
        try:
            os.fsync(self._file.fileno())
        except OSError as error:
            self._fail(error)

    def _fail(self, error: OSError) -> OperationError:
        """Stores the first failure, and returns it."""
        self.failure = self.failure or error_from_os(error, self._path)
        return self.failure


def _pose_message(stamp_ns: int, pose: Sequence[float] | Floats) -> bytes:
    """``foxglove.PoseInFrame`` of a pose (7,); lengths are in metres there."""
    x, y, z, qx, qy, qz, qw = (float(number) for number in pose)
    position = Vector3(x=x / MM_PER_M, y=y / MM_PER_M, z=z / MM_PER_M)
    return PoseInFrame(
        timestamp=_timestamp(stamp_ns),
        frame_id="arm",
        pose=Pose(position=position, orientation=Quaternion(x=qx, y=qy, z=qz, w=qw)),
    ).SerializeToString()


def _timestamp(stamp_ns: int) -> Timestamp:
    seconds, nanos = divmod(stamp_ns, 1_000_000_000)
    return Timestamp(seconds=seconds, nanos=nanos)
