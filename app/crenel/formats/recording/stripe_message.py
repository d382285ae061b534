"""The stripe of one frame as a message: topic ``/sensor/stripe``.

Protocol Buffers, as the schema in every recording has it::

    syntax = "proto3";
    package crenel;
    message StripeProfile {
      google.protobuf.Timestamp timestamp = 1;  // middle of the exposure
      uint32 width_px = 2;                      // of the image the stripe came from
      uint32 height_px = 3;
      repeated double u = 4;                    // column of each point, distorted pixels
      repeated double v = 5;                    // row
      repeated float intensity = 6;             // grey levels over the background
      repeated float sigma_px = 7;              // standard deviation across the stripe
      string axis = 8;                          // "u": a point a column, "v": a point a row
    }

The four lists are of one length. ``timestamp`` is on the clock of the recording's
joint samples.
"""

from collections.abc import MutableSequence
from functools import cache
from typing import Protocol, cast

import numpy as np
from google.protobuf import message_factory, timestamp_pb2
from google.protobuf.descriptor_pb2 import FieldDescriptorProto, FileDescriptorProto
from google.protobuf.descriptor_pb2 import FileDescriptorSet as DescriptorSet
from google.protobuf.descriptor_pool import DescriptorPool

from crenel.messages.message import message
from crenel.metrology.stripe import Stripe
from crenel.metrology.transforms import Floats

STRIPE_SCHEMA = "crenel.StripeProfile"
NUMBERS = {"u": 4, "v": 5, "intensity": 6, "sigma_px": 7}
LENGTH_DELIMITED = 2


class Stamp(Protocol):
    """``google.protobuf.Timestamp``"""

    seconds: int
    nanos: int


class StripeMessage(Protocol):
    """The message above, as the library builds it from its description."""

    timestamp: Stamp
    width_px: int
    height_px: int
    u: MutableSequence[float]
    v: MutableSequence[float]
    intensity: MutableSequence[float]
    sigma_px: MutableSequence[float]
    axis: str

    def SerializeToString(self) -> bytes: ...  # noqa: N802 - of an interface by others


def stripe_descriptors() -> bytes:
    """The schema in the form required by MCAP: a serialized ``FileDescriptorSet``."""
    files = DescriptorSet(file=[_timestamp_file(), _stripe_file()])
    return files.SerializeToString()


def encode_stripe(stripe: Stripe, stamp_ns: int, width_px: int, height_px: int) -> bytes:
    """One frame's stripe as the bytes of a message.

    Concatenated messages are one message, and packed numbers are the bytes of their array (Protocol
    Buffers encoding), so the lists need not pass through Python.
    """
    profile = cast(StripeMessage, _message_class()())
    profile.timestamp.seconds, profile.timestamp.nanos = divmod(stamp_ns, 1_000_000_000)
    profile.width_px, profile.height_px = width_px, height_px
    profile.axis = stripe.axis
    return b"".join(
        (
            profile.SerializeToString(),
            *_pack_numbers("u", stripe.u, "<f8"),
            *_pack_numbers("v", stripe.v, "<f8"),
            *_pack_numbers("intensity", stripe.intensity, "<f4"),
            *_pack_numbers("sigma_px", stripe.sigma_px, "<f4"),
        )
    )


def _pack_numbers(field: str, values: Floats, kind: str) -> tuple[bytes, ...]:
    """A list of numbers: number and length of its field, then the numbers; empty for none."""
    if not len(values):
        return ()
    data = values.astype(kind, copy=False).tobytes()
    return _varint(NUMBERS[field] << 3 | LENGTH_DELIMITED) + _varint(len(data)), data


def _varint(value: int) -> bytes:
    """Seven bits per byte, the lowest first; the eighth bit says that more follow."""
    coded = bytearray()
    while value > 0x7F:
        coded.append(value & 0x7F | 0x80)
        value >>= 7
    coded.append(value)
    return bytes(coded)


def decode_stripe(profile: StripeMessage) -> Stripe:
    """The points of a message; raises ``ValueError`` if its lists differ in length."""
    stripe = Stripe(
        np.array(profile.u, dtype=np.float64),
        np.array(profile.v, dtype=np.float64),
        np.array(profile.intensity, dtype=np.float64),
        np.array(profile.sigma_px, dtype=np.float64),
        profile.axis or "u",
    )
    lengths = {len(stripe.u), len(stripe.v), len(stripe.intensity), len(stripe.sigma_px)}
    if len(lengths) > 1:
        raise ValueError(message("lists-stripe-differ-length"))
    return stripe


@cache
def _message_class() -> type:
    pool = DescriptorPool()
    pool.Add(_timestamp_file())
    pool.Add(_stripe_file())
    return message_factory.GetMessageClass(pool.FindMessageTypeByName(STRIPE_SCHEMA))


def _timestamp_file() -> FileDescriptorProto:
    file = FileDescriptorProto()
    timestamp_pb2.DESCRIPTOR.CopyToProto(file)
    return file


def _stripe_file() -> FileDescriptorProto:
    file = FileDescriptorProto(
        name="crenel/StripeProfile.proto",
        package="crenel",
        syntax="proto3",
        dependency=["google/protobuf/timestamp.proto"],
    )
    one, many = FieldDescriptorProto.LABEL_OPTIONAL, FieldDescriptorProto.LABEL_REPEATED
    fields = (
        ("timestamp", one, FieldDescriptorProto.TYPE_MESSAGE),
        ("width_px", one, FieldDescriptorProto.TYPE_UINT32),
        ("height_px", one, FieldDescriptorProto.TYPE_UINT32),
        ("u", many, FieldDescriptorProto.TYPE_DOUBLE),
        ("v", many, FieldDescriptorProto.TYPE_DOUBLE),
        ("intensity", many, FieldDescriptorProto.TYPE_FLOAT),
        ("sigma_px", many, FieldDescriptorProto.TYPE_FLOAT),
        ("axis", one, FieldDescriptorProto.TYPE_STRING),
    )
    described = file.message_type.add(name="StripeProfile")
    for number, (name, label, kind) in enumerate(fields, start=1):
        field = described.field.add(name=name, number=number, label=label, type=kind)
        if kind == FieldDescriptorProto.TYPE_MESSAGE:
            field.type_name = ".google.protobuf.Timestamp"
    return file
