"""Fast decoding of the bytes of a recording.

Decodes the records of an MCAP chunk, and the two kinds of protobuf messages that come by the
thousand per second: joints and stripes. Messages in an unusual form are left to the general
decoders; they are marked by a negative number of joints or points.
"""

import numpy as np
from mcap.exceptions import McapError
from numpy.typing import NDArray

from crenel.metrology.transforms import Floats
from crenel.native.arguments import F64, I64, U8, Array, Function, Integer
from crenel.native.library import CRENEL

Bytes = NDArray[np.uint8]
Table = NDArray[np.int64]

INVALID, MESSAGE = 0, 5
MOST_RECORDS = 1_000_000
"""Maximum number of records in one chunk. The smallest useful record has more than a hundred
bytes."""
MOST_JOINTS = 16
# Columns of a stripe: stamp, width, height, offsets of u, v, intensity, sigma, and of the
# axis' letter (0 where there is none), then the points.
STAMP, WIDTH, HEIGHT, U, V, INTENSITY, SIGMA, AXIS, POINTS = range(9)
STRIPE_COLUMNS = 9
LISTS = {U: np.float64, V: np.float64, INTENSITY: np.float32, SIGMA: np.float32}

_DATA, _RECORDS = Array(U8, "n"), Array(I64, "m", 5)
_count_records = Function(CRENEL, "count_records", _DATA, returns=int)
_find_records = Function(
    CRENEL, "find_records", _DATA, Array(I64, "m", 5, written=True), returns=int
)
_find_joints = Function(
    CRENEL,
    "find_joints",
    _DATA,
    _RECORDS,
    Array(I64, "m", MOST_JOINTS + 1, written=True),
    Array(I64, "m", written=True),
    Array(I64, "m", written=True),
)
_gather_joints = Function(
    CRENEL,
    "gather_joints",
    _DATA,
    Array(I64, "m", MOST_JOINTS + 1),
    Array(F64, "m", "count", written=True),
    returns=int,
)
_find_stripes = Function(
    CRENEL, "find_stripes", _DATA, _RECORDS, Array(I64, "m", STRIPE_COLUMNS, written=True)
)
_gather_list = Function(
    CRENEL,
    "gather_list",
    _DATA,
    Array(I64, "m", STRIPE_COLUMNS),
    Integer(),
    Array(U8, "size", written=True),
    returns=int,
)


def find_records(data: Bytes) -> Table:
    """The records of a chunk (R, 5).

    For each: opcode, channel (of a message, otherwise -1), log time (of a message, otherwise 0),
    position of its content, and length of the content.

    Raises:
        McapError: a record extends beyond the end of the chunk, or has an unknown opcode; or
            there are too many.
    """
    count = _count_records(data)
    if count < 0:
        raise McapError("a record reaches beyond its chunk")
    if count > MOST_RECORDS:
        raise McapError(f"a chunk with {count} records")
    table = np.empty((count, 5), dtype=np.int64)
    _find_records(data, table)
    if (table[:, 0] == INVALID).any():
        raise McapError("no record begins with a zero")
    return table


def find_joints(data: Bytes, messages: Table) -> tuple[Table, Table, Table]:
    """Positions of the joint angles of ``foxglove.JointStates``.

    Args:
        messages: (M, 5) rows of ``find_records``.

    Returns:
        (M, ``MOST_JOINTS`` + 1) the stamp in ns, and the offset of each position; (M,) how
        many joints there are, -1 where the message is left to the general decoder; (M,) a
        number that distinguishes their names from others.
    """
    rows = np.full((len(messages), MOST_JOINTS + 1), -1, dtype=np.int64)
    counts, names = np.empty((2, len(messages)), dtype=np.int64)
    _find_joints(data, messages, rows, counts, names)
    return rows, counts, names


def gather_joints(data: Bytes, rows: Table, count: int) -> Floats:
    """The joint angles (M, count) of ``rows`` of ``find_joints``.

    Raises:
        ValueError: a row does not belong to these bytes.
    """
    positions = np.empty((len(rows), count))
    if not _gather_joints(data, rows, positions):
        raise ValueError("joints reach beyond their bytes")
    return positions


def find_stripes(data: Bytes, messages: Table) -> Table:
    """Positions of the parts of ``crenel.StripeProfile``.

    Args:
        messages: (M, 5) rows of ``find_records``.

    Returns:
        (M, ``STRIPE_COLUMNS``); the number of points is -1 where the message is left to the
        general decoder.
    """
    rows = np.empty((len(messages), STRIPE_COLUMNS), dtype=np.int64)
    _find_stripes(data, messages, rows)
    return rows


def gather_list(data: Bytes, rows: Table, column: int) -> Floats:
    """One list (N,) of all stripes, concatenated, as stored.

    Args:
        rows: (M, ``STRIPE_COLUMNS``) of ``find_stripes``, all with points or none.
        column: ``U``, ``V``, ``INTENSITY`` or ``SIGMA``.

    Raises:
        ValueError: a row does not belong to these bytes.
    """
    numbers = np.empty(int(rows[:, POINTS].sum()), LISTS[column])
    if _gather_list(data, rows, column, numbers.view(np.uint8)) != numbers.nbytes:
        raise ValueError("stripes reach beyond their bytes")
    return numbers
