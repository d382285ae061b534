"""Recordings read fast mean what the general decoders say, whatever bytes they hold.

``--hypothesis-profile=long`` tries many more.
"""

import struct
from pathlib import Path

import numpy as np
import pytest
from foxglove.messages import JointState, JointStates, Timestamp
from hypothesis import example, given
from hypothesis import strategies as st
from mcap.exceptions import McapError
from mcap.records import Channel, Message, Schema

from crenel.errors import OperationError
from crenel.formats.recording import wire_format as wire
from crenel.formats.recording.blocks import ChunkRecords, read_profiles
from crenel.formats.recording.decoders import Decoders, JointRecord, StripeRecord
from crenel.formats.recording.stripe_message import STRIPE_SCHEMA, encode_stripe, stripe_descriptors
from crenel.formats.recording.topics import JOINTS_TOPIC, STRIPE_TOPIC
from crenel.metrology.stripe import Stripe

pytestmark = pytest.mark.usefixtures("variant")

JOINTS, STRIPES = 1, 2
NAMES = ("J1",)
ANY_INT = st.integers(-(2**63), 2**63 - 1)


def decoders() -> Decoders:
    """The general ones, for both kinds of messages."""
    found = Decoders(Path("scan.mcap"))
    described = JointStates.get_schema()
    for number, topic, name, data in (
        (JOINTS, JOINTS_TOPIC, described.name, described.data),
        (STRIPES, STRIPE_TOPIC, STRIPE_SCHEMA, stripe_descriptors()),
    ):
        found.schemas[number] = Schema(id=number, data=data, encoding="protobuf", name=name)
        found.channels[number] = Channel(
            id=number, topic=topic, message_encoding="protobuf", metadata={}, schema_id=number
        )
    return found


DECODERS = decoders()


def decoded(channel: int, data: bytes) -> object:
    """What the general decoder says; None where it refuses the message."""
    try:
        return DECODERS.decode(Message(channel, 7, data, 7, 0))
    except OperationError:
        return None


def field(number: int, kind: int, data: bytes) -> bytes:
    """A field of a short message."""
    length = bytes([len(data)]) if kind == 2 else b""
    return bytes([number << 3 | kind]) + length + data


def joints_message() -> bytes:
    joints = [JointState(name=name, position=0.1 * i) for i, name in enumerate(NAMES)]
    return JointStates(timestamp=Timestamp(12, 345), joints=joints).encode()


def stripe_message() -> bytes:
    u, v = np.array([[0.5, 1.5], [9.0, 11.0]])
    return encode_stripe(Stripe(u, v, 2 * v, v / 100), 12_000_000_345, 64, 48)


def doubles(*values: float) -> bytes:
    return struct.pack(f"<{len(values)}d", *values)


STAMPS = [field(1, 2, b"\x08\x0c\x10\x05"), field(1, 2, b"\x10\x07"), field(1, 2, b"")]
ODD = [b"\x00\x00", b"\x7d1234", b"\xfa\x01\x01x", field(1, 0, b"\x05"), field(3, 3, b""), b"\x80"]
NAME, POSITION = field(1, 2, b"J1"), field(2, 1, doubles(0.5))
JOINT_PARTS = [STAMPS[0], field(2, 2, NAME + POSITION)]
OTHER_JOINT_PARTS = [
    *STAMPS,
    *ODD,
    *(
        field(2, 2, inner)
        for inner in (
            POSITION + NAME,
            NAME,
            POSITION,
            field(1, 2, b"J") + field(1, 2, b"1") + POSITION,
            NAME + POSITION + field(2, 1, doubles(-1.5)),
            NAME + POSITION + field(5, 1, doubles(3.0)) + field(6, 2, b"more"),
            NAME + POSITION + ODD[0],
            field(1, 2, b"\xff") + POSITION,
        )
    ),
    joints_message(),
]
SIZE = [field(2, 0, b"\x40"), field(3, 0, b"\x30"), field(2, 0, b"\xff\xff\xff\xff\xff\x01")]
STRIPE_PARTS = [
    STAMPS[0],
    *SIZE[:2],
    *(field(number, 2, doubles(1.5, 2.5)) for number in (4, 5)),
    *(field(number, 2, doubles(number)) for number in (6, 7)),
    field(8, 2, b"v"),
]
OTHER_STRIPE_PARTS = [
    *STAMPS,
    *ODD,
    *SIZE,
    *STRIPE_PARTS,
    *(field(number, 2, bytes(4 * n)) for number in (4, 5, 6, 7) for n in range(5)),
    *(field(8, 2, axis) for axis in (b"u", b"x", b"", b"uv", b"\xc3")),
    stripe_message(),
]


@st.composite
def messages(draw: st.DrawFn, usual: list[bytes], others: list[bytes]) -> bytes:
    """A message in which some parts are others, more or missing; and some bytes, at times."""
    parts = list(usual)
    for _ in range(draw(st.integers(0, 2))):
        at = draw(st.integers(0, len(parts)))
        more = draw(st.lists(st.sampled_from(others), max_size=2))
        parts[at : at + draw(st.integers(0, 1))] = more
    data = bytearray(b"".join(parts))
    for _ in range(draw(st.sampled_from([0, 0, 1, 3]))):
        at, length = draw(st.integers(0, len(data))), draw(st.integers(0, 4))
        data[at : at + length] = draw(st.binary(max_size=4))
    return bytes(data)


def framed(message: bytes) -> tuple[np.ndarray, np.ndarray]:
    """A message in the middle of bytes that are not its own, and its row of the table."""
    data = np.frombuffer(b"\x0a" * 3 + message + b"\x0a" * 3, np.uint8)
    return data, np.array([[wire.MESSAGE, 1, 7, 3, len(message)]])


def with_one_other(usual: list[bytes], others: list[bytes]) -> list[bytes]:
    """All messages in which one part is another, or one more."""
    return [
        b"".join([*usual[:at], other, *usual[at + gone :]])
        for other in others
        for at in range(len(usual) + 1)
        for gone in (0, 1)
    ]


def test_messages_with_one_odd_part_mean_what_the_decoder_says() -> None:
    for message in with_one_other(JOINT_PARTS, OTHER_JOINT_PARTS):
        check_joints(message)
    for message in with_one_other(STRIPE_PARTS, OTHER_STRIPE_PARTS):
        check_stripes(message)


@given(messages(JOINT_PARTS, OTHER_JOINT_PARTS) | st.binary(max_size=60))
def test_joints_are_what_the_decoder_says_or_left_to_it(message: bytes) -> None:
    check_joints(message)


@given(messages(STRIPE_PARTS, OTHER_STRIPE_PARTS) | st.binary(max_size=60))
def test_stripes_are_what_the_decoder_says_or_left_to_it(message: bytes) -> None:
    check_stripes(message)


def check_joints(message: bytes) -> None:
    data, table = framed(message)
    rows, counts, names = wire.find_joints(data, table)
    usual = wire.find_joints(*framed(joints_message()))
    if message in (joints_message(), b"".join(JOINT_PARTS)):
        assert counts[0] == 1
    if counts[0] > 0:
        positions = wire.gather_joints(data, rows, int(counts[0]))
        record = decoded(JOINTS, message)
        if isinstance(record, JointRecord):
            assert record.stamp_ns == rows[0, 0]
            np.testing.assert_array_equal(record.q_rad, positions[0])
        # names are compared with a message's that was decoded
        if (counts[0], names[0]) == (usual[1][0], usual[2][0]):
            assert isinstance(record, JointRecord)
            assert record.names == NAMES


def check_stripes(message: bytes) -> None:
    data, table = framed(message)
    rows = wire.find_stripes(data, table)
    if message in (stripe_message(), b"".join(STRIPE_PARTS)):
        assert rows[0, wire.POINTS] == 2
    if rows[0, wire.POINTS] >= 0:
        record = decoded(STRIPES, message)
        read = read_profiles(ChunkRecords(data.tobytes(), table), rows)
        assert isinstance(record, StripeRecord)
        assert (record.stamp_ns, record.width_px, record.height_px) == (*rows[0, : wire.U],)
        assert record.stripe.axis == read.axis
        for name in ("u", "v", "intensity", "sigma_px"):
            np.testing.assert_array_equal(getattr(record.stripe, name), getattr(read, name))


def records(data: bytes) -> list[list[int]] | None:
    """The table of a chunk, by MCAP's specification; None where a record is not whole."""
    rows, at = [], 0
    while at < len(data):
        if at + 9 > len(data):
            return None
        opcode, length = struct.unpack_from("<BQ", data, at)
        at += 9
        head = 22 if opcode == wire.MESSAGE else 0
        if length < head or at + length > len(data):
            return None
        channel, log_ns = -1, 0
        if head:
            channel, _, log_ns = struct.unpack_from("<HIq", data, at)
        rows.append([opcode, channel, log_ns, at + head, length - head])
        at += length
    return rows


RECORDS = [
    struct.pack("<BQ", opcode, len(content)) + content
    for opcode, content in (
        (3, b"a schema"),
        (wire.MESSAGE, struct.pack("<HIQQ", 1, 2, 2**63 + 5, 6) + b"joints"),
        (99, b""),
        (wire.MESSAGE, bytes(22)),
    )
]
LENGTHS = [struct.pack("<BQ", wire.MESSAGE, length) for length in (0, 21, 2**63 - 1, 2**64 - 1)]


@given(messages(RECORDS, RECORDS + LENGTHS) | st.binary(max_size=60))
@example(bytes(9))
def test_records_stand_where_the_specification_says(data: bytes) -> None:
    expected = records(data)
    if expected is None or any(row[0] == 0 for row in expected):
        with pytest.raises(McapError, match=r"beyond its chunk|begins with a zero"):
            wire.find_records(np.frombuffer(data, np.uint8))
    else:
        table = wire.find_records(np.frombuffer(data, np.uint8))
        np.testing.assert_array_equal(table, np.reshape(expected, (-1, 5)))


@given(st.lists(st.tuples(ANY_INT, ANY_INT), min_size=1, max_size=4))
def test_a_table_of_other_bytes_leads_nowhere(spans: list[tuple[int, int]]) -> None:
    """Messages that a table has outside of the bytes are not read."""
    data = np.frombuffer(joints_message(), np.uint8)
    table = np.array([[wire.MESSAGE, 1, 7, at, length] for at, length in spans], np.int64)
    _, counts, _ = wire.find_joints(data, table)
    stripes = wire.find_stripes(data, table)
    for (at, length), count, row in zip(spans, counts, stripes, strict=True):
        if at < 0 or length < 0 or at + length > len(data):
            assert (count, row[wire.POINTS]) == (-1, -1)


@given(ANY_INT, st.sampled_from([0, 1, 5, 6, 2**61, 2**63 - 1, -1, -(2**63)]), st.integers(0, 9))
def test_lists_are_copied_from_within_the_bytes_only(at: int, points: int, column: int) -> None:
    data, out = np.arange(40, dtype=np.uint8), np.zeros(40, np.uint8)
    row = np.zeros((1, wire.STRIPE_COLUMNS), np.int64)
    row[0, min(column, wire.SIGMA)], row[0, wire.POINTS] = at, points
    filled = wire._gather_list(data, row, column, out)
    size = points * (8 if column in (wire.U, wire.V) else 4)
    if wire.U <= column <= wire.SIGMA and 0 <= size <= 40 and 0 <= at <= 40 - size:
        assert filled == size
        np.testing.assert_array_equal(out[:size], data[at : at + size])
    else:
        assert filled == -1
        assert not out.any()


@pytest.mark.parametrize("at", [-1, 33, 2**63 - 1, -(2**63)])
def test_rows_of_other_bytes_are_refused(at: int) -> None:
    data = np.zeros(40, np.uint8)
    joints = np.full((1, wire.MOST_JOINTS + 1), at)
    with pytest.raises(ValueError, match="joints reach beyond"):
        wire.gather_joints(data, joints, 1)
    stripes = np.array([[0, 1, 1, at, 0, 0, 0, 0, 1]])
    with pytest.raises(ValueError, match="stripes reach beyond"):
        wire.gather_list(data, stripes, wire.U)
