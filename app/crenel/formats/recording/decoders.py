"""The messages of a recording, decoded: readings of the joints, stripes and pictures."""

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol, cast

import numpy as np
from google.protobuf.message import DecodeError
from mcap.exceptions import McapError
from mcap.records import Channel, Schema
from mcap.records import Message as LoggedMessage
from mcap_protobuf.decoder import DecoderFactory

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.images import GreyImage, decode_grey
from crenel.formats.recording.blocks import MOST_DESCRIBED
from crenel.formats.recording.stripe_message import (
    STRIPE_SCHEMA,
    Stamp,
    StripeMessage,
    decode_stripe,
)
from crenel.formats.recording.topics import (
    IMAGE_TOPIC,
    JOINTS_TOPIC,
    POSE_TOPIC,
    STRIPE_TOPIC,
    split_topic,
)
from crenel.messages.message import Text, message
from crenel.messages.validation import exception_text
from crenel.metrology.stripe import Stripe
from crenel.units import MM_PER_M

SCHEMAS = {
    JOINTS_TOPIC: ("foxglove.JointStates",),
    POSE_TOPIC: ("foxglove.PoseInFrame",),
    IMAGE_TOPIC: ("foxglove.RawImage", "foxglove.CompressedImage"),
    STRIPE_TOPIC: (STRIPE_SCHEMA,),
}
GREY_ENCODINGS = {"mono8": np.uint8, "8UC1": np.uint8, "mono16": np.uint16, "16UC1": np.uint16}
LARGEST_MESSAGE = {JOINTS_TOPIC: 64 << 10, POSE_TOPIC: 64 << 10, STRIPE_TOPIC: 4 << 20}
"""Maximum size of one message in bytes; in memory, it is many times as large."""


@dataclass(frozen=True, slots=True)
class JointRecord:
    """One reading of the joints."""

    stamp_ns: int
    names: tuple[str, ...]
    q_rad: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class PoseRecord:
    """One reported pose of the flange."""

    stamp_ns: int
    pose: tuple[float, ...]
    """(7,) position in mm and quaternion x, y, z, w."""


@dataclass(frozen=True, slots=True)
class ImageRecord:
    """One frame; the picture is decoded on access, in the calling thread."""

    stamp_ns: int
    picture: Callable[[], GreyImage]
    """Raises ``OperationError`` if the picture cannot be read."""
    sensor: str = ""
    """Its name; empty if the station has one sensor."""


@dataclass(frozen=True, slots=True)
class StripeRecord:
    """One frame whose stripe was extracted when it was captured."""

    stamp_ns: int
    width_px: int
    height_px: int
    stripe: Stripe
    sensor: str = ""
    """As of ``ImageRecord``."""


Record = JointRecord | PoseRecord | ImageRecord | StripeRecord


class _JointState(Protocol):
    name: str
    position: float


class _StampedMessage(Protocol):
    timestamp: Stamp

    def HasField(self, name: str) -> bool: ...  # noqa: N802 - of an interface by others


class _JointStates(_StampedMessage, Protocol):
    joints: list[_JointState]


class _Vector(Protocol):
    x: float
    y: float
    z: float


class _Quaternion(_Vector, Protocol):
    w: float


class _Pose(Protocol):
    position: _Vector
    orientation: _Quaternion


class _PoseInFrame(_StampedMessage, Protocol):
    pose: _Pose


class _RawImage(_StampedMessage, Protocol):
    width: int
    height: int
    encoding: str
    step: int
    data: bytes


class _CompressedImage(_StampedMessage, Protocol):
    format: str
    data: bytes


class Decoders:
    """Converts messages to records, with the schemas in the file itself."""

    def __init__(self, path: Path) -> None:
        self.schemas: dict[int, Schema] = {}
        self.channels: dict[int, Channel] = {}
        self._path = path
        self._factory = DecoderFactory()
        self._by_channel: dict[int, Callable[[bytes], object]] = {}
        self._described_bytes = 0

    def learn(self, described: Schema | Channel) -> None:
        """Adds a schema or channel; raises ``McapError`` if there are too many."""
        if isinstance(described, Schema):
            known = described.id in self.schemas and self.schemas[described.id] == described
            self.schemas[described.id] = described
            size = len(described.name) + len(described.encoding) + len(described.data)
        else:
            known = described.id in self.channels and self.channels[described.id] == described
            self.channels[described.id] = described
            size = len(described.topic) + len(described.message_encoding)
            size += sum(len(key) + len(value) for key, value in described.metadata.items())
        self._described_bytes += 0 if known else size
        if self._described_bytes > MOST_DESCRIBED:
            raise McapError

    def decode(self, logged: LoggedMessage) -> Record | None:
        """None for unknown topics."""
        channel = self.channels.get(logged.channel_id)
        if channel is None or split_topic(channel.topic)[0] not in SCHEMAS:
            return None
        decoder = self._by_channel.get(channel.id)
        if decoder is None:
            decoder = self._by_channel[channel.id] = self._decoder(channel)
        named = message(
            "recording-message-at",
            path=display_path(self._path),
            topic=channel.topic,
            stamp_ns=logged.log_time,
        )
        size = len(logged.data)
        if size > LARGEST_MESSAGE.get(split_topic(channel.topic)[0], size):
            raise OperationError(
                "recording-message-malformed", named, message("message-too-large", size=size)
            )
        try:
            return self._record(channel, decoder(logged.data), logged.log_time, named)
        except (DecodeError, ValueError) as error:
            raise OperationError(
                "recording-message-malformed", named, exception_text(error)
            ) from error

    def _decoder(self, channel: Channel) -> Callable[[bytes], object]:
        schema = self.schemas.get(channel.schema_id)
        expected = SCHEMAS[split_topic(channel.topic)[0]]
        decoder = None
        if schema is not None and schema.name in expected:
            with suppress(McapError, DecodeError, TypeError):  # a schema that describes nothing
                decoder = self._factory.decoder_for(channel.message_encoding, schema)
        if decoder is None:
            raise OperationError(
                "recording-of-another-type",
                message(
                    "topic-holds",
                    path=display_path(self._path),
                    topic=channel.topic,
                    schema=schema.name if schema else message("without-schema"),
                    encoding=channel.message_encoding,
                ),
                message("protobuf-expected", schemas=", ".join(expected)),
                message("give-recording-as-documented"),
            )
        return decoder

    def _record(self, channel: Channel, decoded: object, log_ns: int, named: Text) -> Record:
        stamp_ns = _stamp_ns(cast(_StampedMessage, decoded), log_ns)
        topic, sensor = split_topic(channel.topic)
        if topic == JOINTS_TOPIC:
            joints = cast(_JointStates, decoded).joints
            return JointRecord(
                stamp_ns,
                tuple(joint.name for joint in joints),
                tuple(joint.position for joint in joints),
            )
        if topic == POSE_TOPIC:
            return PoseRecord(stamp_ns, _pose_mm(cast(_PoseInFrame, decoded)))
        if topic == STRIPE_TOPIC:
            profile = cast(StripeMessage, decoded)
            return StripeRecord(
                stamp_ns, profile.width_px, profile.height_px, decode_stripe(profile), sensor
            )
        if self.schemas[channel.schema_id].name == "foxglove.CompressedImage":
            packed = cast(_CompressedImage, decoded)
            return ImageRecord(stamp_ns, lambda: decode_grey(packed.data, named), sensor)
        raw = cast(_RawImage, decoded)
        return ImageRecord(stamp_ns, lambda: _raw_picture(raw, named), sensor)


def _pose_mm(decoded: _PoseInFrame) -> tuple[float, ...]:
    """(7,) in mm; Foxglove's lengths are in metres."""
    at, turned = decoded.pose.position, decoded.pose.orientation
    position_mm = (at.x * MM_PER_M, at.y * MM_PER_M, at.z * MM_PER_M)
    return (*position_mm, turned.x, turned.y, turned.z, turned.w)


def _stamp_ns(stamped: _StampedMessage, log_ns: int) -> int:
    """The message's own time stamp if it has one, otherwise the time at which it was logged."""
    if not stamped.HasField("timestamp"):
        return log_ns
    return stamped.timestamp.seconds * 1_000_000_000 + stamped.timestamp.nanos


def _raw_picture(raw: _RawImage, named: Text) -> GreyImage:
    kind = GREY_ENCODINGS.get(raw.encoding)
    if kind is None:
        raise OperationError(
            "image-not-grey",
            message("image-encoding", name=named, encoding=repr(raw.encoding)),
            message("grey-encodings-expected", encodings=", ".join(GREY_ENCODINGS)),
        )
    pixel = np.dtype(kind).itemsize
    row = raw.step or raw.width * pixel
    data = raw.data
    if raw.width < 1 or raw.height < 1 or row < raw.width * pixel or len(data) < row * raw.height:
        raise OperationError(
            "image-cut-off",
            message(
                "picture-bytes-do-not-fit",
                name=named,
                bytes=len(data),
                width=raw.width,
                height=raw.height,
                row=row,
            ),
            message("picture-incomplete"),
        )
    rows = np.frombuffer(data, np.uint8, row * raw.height).reshape(raw.height, row)
    packed = np.ascontiguousarray(rows[:, : raw.width * pixel])
    return packed if kind is np.uint8 else packed.view("<u2").astype(np.uint16, copy=False)
