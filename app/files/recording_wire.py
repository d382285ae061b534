"""What a recording's bytes mean, read at the speed of memory.

The records of an MCAP chunk, and the two kinds of protobuf messages that come by the
thousand a second: joints and stripes. What does not look as it is mostly written is left
to the general decoders: every function says so by a negative number.
"""

import numpy as np
from numpy.typing import NDArray

from app.metrology.compiled import kernel

Bytes = NDArray[np.uint8]
Table = NDArray[np.int64]

MESSAGE = 5
MOST_JOINTS = 16
# Columns of a stripe: stamp, width, height, offsets of u, v, intensity, sigma, and of the
# axis' letter (0 where there is none), then the points.
STAMP, WIDTH, HEIGHT, U, V, INTENSITY, SIGMA, AXIS, POINTS = range(9)
STRIPE_COLUMNS = 9


@kernel
def _fixed(data: Bytes, at: int, size: int) -> np.int64:
    value = np.int64(0)
    for i in range(size - 1, -1, -1):
        value = (value << 8) | np.int64(data[at + i])
    return value


@kernel
def _varint(data: Bytes, at: int, end: int) -> tuple[np.int64, int]:
    """A number, and where it ends (-1: nowhere)."""
    value, shift = np.int64(0), 0
    while at < end and shift < 63:
        byte = np.int64(data[at])
        at += 1
        value |= (byte & 127) << shift
        if byte < 128:
            return value, at
        shift += 7
    return np.int64(0), -1


@kernel
def records_in(data: Bytes) -> int:
    """How many MCAP records a chunk holds; -1 where one reaches beyond its end."""
    at, count = 0, 0
    while at < len(data):
        if at + 9 > len(data):
            return -1
        length = int(_fixed(data, at + 1, 8))
        if length < 0 or length > len(data) - at - 9 or (data[at] == 5 and length < 22):
            return -1
        at += 9 + length
        count += 1
    return count


@kernel
def find_records(data: Bytes, table: Table) -> None:
    """Of each record: its opcode, channel (of a message, else -1), log time, first byte, length."""
    at = 0
    for row in table:
        length = int(_fixed(data, at + 1, 8))
        row[0], row[1], row[2], row[3], row[4] = data[at], -1, 0, at + 9, length
        if data[at] == 5:
            row[1] = _fixed(data, at + 9, 2)
            row[2] = _fixed(data, at + 15, 8)
            row[3] += 22
            row[4] -= 22
        at += 9 + length


@kernel
def _skipped(data: Bytes, at: int, end: int, kind: np.int64) -> int:
    """Where an unknown field ends; -1 where it does not."""
    if kind == 0:
        return _varint(data, at, end)[1]
    if kind == 1:
        at += 8
    elif kind == 5:
        at += 4
    elif kind == 2:
        length, at = _varint(data, at, end)
        if at < 0 or length > end - at:
            return -1
        at += int(length)
    else:
        return -1
    return at if at <= end else -1


@kernel
def _stamp(data: Bytes, at: int, end: int) -> np.int64:
    """Nanoseconds of a google.protobuf.Timestamp; -1 where it is none."""
    seconds, nanos = np.int64(0), np.int64(0)
    while at < end:
        tag = data[at]
        value, at = _varint(data, at + 1, end)
        if at < 0 or (tag != 8 and tag != 16):
            return np.int64(-1)
        if tag == 8:
            seconds = value
        else:
            nanos = value
    if seconds < 0 or seconds > 9_000_000_000 or nanos > 999_999_999:
        return np.int64(-1)
    return seconds * 1_000_000_000 + nanos


@kernel
def _stripe_part(data: Bytes, field: int, at: int, size: int, row: Table) -> int:
    """Takes note of a part of a stripe; how many points it has, -1 where it is none of it."""
    if field == 1:
        row[0] = _stamp(data, at, at + size)
        return 0 if row[0] >= 0 else -1
    if field == 8:
        row[7] = data[at] if size == 1 else 0
        return 0 if size == 1 else -1
    width = 8 if field < 6 else 4
    if row[field - 1] or size % width:
        return -1
    row[field - 1] = at
    return size // width


@kernel
def find_stripe(data: Bytes, at: int, length: int, row: Table) -> int:
    """Where the parts of a ``crenel.StripeProfile`` stand; its points, or -1."""
    end = at + length
    row[:] = 0
    row[0] = -1
    counts = np.zeros(4, dtype=np.int64)
    while at < end:
        tag = np.int64(data[at])
        field = int(tag >> 3)
        if tag & 7 == 0 and (field == 2 or field == 3):
            row[field - 1], at = _varint(data, at + 1, end)
        elif tag & 7 == 2 and (field == 1 or (field >= 4 and field <= 8)):
            size, at = _varint(data, at + 1, end)
            if at < 0 or size > end - at:
                return -1
            found = _stripe_part(data, field, at, int(size), row)
            if found < 0:
                return -1
            if field >= 4 and field <= 7:
                counts[field - 4] = found
            at += int(size)
        else:
            return -1
        if at < 0:
            return -1
    if row[0] < 0 or (counts != counts[0]).any():
        return -1
    row[8] = counts[0]
    return int(counts[0])


@kernel
def find_stripes(data: Bytes, messages: Table, rows: Table) -> None:
    """``find_stripe`` of each message; the number of points is -1 where it is none."""
    for i in range(len(messages)):
        if find_stripe(data, messages[i, 3], messages[i, 4], rows[i]) < 0:
            rows[i, 8] = -1


@kernel
def gather(data: Bytes, rows: Table, column: int, size: int, out: Bytes) -> None:
    """Puts one column's bytes of all stripes behind one another."""
    to = 0
    for row in rows:
        length = row[8] * size
        out[to : to + length] = data[row[column] : row[column] + length]
        to += length


@kernel
def _joint(data: Bytes, at: int, end: int, names: np.int64) -> tuple[int, np.int64]:
    """Where a joint's position stands (-1: nowhere), and ``names`` with its name in it."""
    found = -1
    while at < end:
        tag = np.int64(data[at])
        at += 1
        if tag == 10:
            length, at = _varint(data, at, end)
            if at < 0 or length > end - at:
                return -1, names
            for i in range(at, at + int(length)):
                names = (names ^ np.int64(data[i])) * 1099511628211
            at += int(length)
        elif tag == 17 and at + 8 <= end:
            found = at
            at += 8
        else:
            at = _skipped(data, at, end, tag & 7) if tag < 128 else -1
            if at < 0:
                return -1, names
    return found, (names ^ 257) * 1099511628211


@kernel
def find_joints(data: Bytes, at: int, length: int, row: Table) -> tuple[int, np.int64]:
    """Stamp, and where each position stands, of a ``foxglove.JointStates``.

    Returns:
        How many joints there are, or -1; and a number that tells their names apart
        from others.
    """
    end = at + length
    row[0] = -1
    count, names = 0, np.int64(1469598103934665603)
    while at < end:
        tag = data[at]
        size, at = _varint(data, at + 1, end)
        if at < 0 or size > end - at or (tag != 10 and tag != 18):
            return -1, names
        if tag == 10:
            row[0] = _stamp(data, at, at + int(size))
        else:
            found, names = _joint(data, at, at + int(size), names)
            if found < 0 or count >= len(row) - 1:
                return -1, names
            count += 1
            row[count] = found
        at += int(size)
    return (count, names) if row[0] >= 0 else (-1, names)


@kernel
def gather_joints(data: Bytes, rows: Table, count: int, out: Bytes) -> None:
    """Puts the bytes of all positions (8 each) behind one another."""
    to = 0
    for row in rows:
        for i in range(1, count + 1):
            out[to : to + 8] = data[row[i] : row[i] + 8]
            to += 8


@kernel
def find_all_joints(data: Bytes, messages: Table, rows: Table, counts: Table, names: Table) -> None:
    """``find_joints`` of each message."""
    for i in range(len(messages)):
        counts[i], names[i] = find_joints(data, messages[i, 3], messages[i, 4], rows[i])
