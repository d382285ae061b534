"""The records of an MCAP file, and what its chunks open to: bounded, whatever a file announces.

What is larger than anything a recording has is damage, like a wrong checksum.
"""

import os
import struct
import zlib
from collections.abc import Iterator, Mapping
from io import BytesIO
from typing import BinaryIO

import lz4.frame
import zstandard
from mcap.data_stream import ReadDataStream
from mcap.exceptions import EndOfFile, InvalidMagic, McapError, RecordLengthLimitExceeded
from mcap.opcode import Opcode
from mcap.records import (
    Channel,
    Chunk,
    DataEnd,
    Footer,
    McapRecord,
    Message,
    Metadata,
    Schema,
    Statistics,
)
from mcap.stream_reader import CRCValidationError

MAGIC = b"\x89MCAP0\r\n"
"""A recording begins with it, and a whole one ends with it, too."""
LARGEST_CHUNK = 64 << 20
"""Bytes that a chunk opens to. Crenel's own have 1 MiB and a picture, usual ones 1 to 16 MiB."""
LARGEST_RECORD = LARGEST_CHUNK + (1 << 20)
"""Bytes of a record in the file: packing makes what cannot be packed a little larger."""
LARGEST_DESCRIPTION = 1 << 20
"""Bytes of a schema, a channel or what describes the whole recording."""
LARGEST_WINDOW = 128 << 20
"""Bytes that zstd may look back."""
HEAD = struct.Struct("<BQ")
FOOTER_BYTES = HEAD.size + 20
INVALID = 0
"""No record has this opcode; a stretch of zeros would be millions of them."""
NOTHING: Mapping[int, int] = {}
PARSED = {
    Opcode.SCHEMA: Schema.read,
    Opcode.CHANNEL: Channel.read,
    Opcode.CHUNK: Chunk.read,
    Opcode.METADATA: Metadata.read,
    Opcode.STATISTICS: Statistics.read,
    Opcode.DATA_END: DataEnd.read,
    Opcode.FOOTER: Footer.read,
}
DAMAGE = (
    EndOfFile,
    CRCValidationError,
    InvalidMagic,
    McapError,
    struct.error,
    zlib.error,
    zstandard.ZstdError,
    RuntimeError,  # what lz4 raises on damaged data
    UnicodeDecodeError,
    MemoryError,  # a length that was damaged; what is read at a time is small
    OverflowError,  # one that no machine could hold
)


def raw_records(
    file: BinaryIO, largest: int = LARGEST_RECORD, skipped: Mapping[int, int] = NOTHING
) -> Iterator[McapRecord]:
    """The records from where a file stands, chunks unopened, up to its footer or its end.

    What is of no use here, such as attachments and indices, is passed over unread.

    Args:
        largest: bytes of a record that is read.
        skipped: where parts begin that are passed over, with their lengths in bytes.

    Raises:
        what ``DAMAGE`` names: where the file is cut off or damaged.
    """
    at = file.tell()
    size = file.seek(0, os.SEEK_END)
    file.seek(at)
    while True:
        while skipped and (length := skipped.get(file.tell(), 0)):
            file.seek(length, os.SEEK_CUR)
        opcode, length = HEAD.unpack(read_exactly(file, HEAD.size))
        if opcode == INVALID:
            raise McapError("no record begins with a zero")
        if file.tell() + length > size:
            raise EndOfFile
        if opcode != Opcode.MESSAGE and opcode not in PARSED:
            file.seek(length, os.SEEK_CUR)
            continue
        if length > largest:
            raise RecordLengthLimitExceeded(opcode, length, largest)
        record = parse_records(opcode, read_exactly(file, length))
        yield record
        if isinstance(record, Footer):
            if read_exactly(file, len(MAGIC)) != MAGIC:
                raise InvalidMagic("at its end")
            return


def parse_records(opcode: int, content: bytes) -> McapRecord:
    """A record by what it holds; its kind is one of ``PARSED``, or a message.

    Raises:
        what ``DAMAGE`` names.
    """
    if opcode not in (Opcode.MESSAGE, Opcode.CHUNK) and len(content) > LARGEST_DESCRIPTION:
        raise RecordLengthLimitExceeded(opcode, len(content), LARGEST_DESCRIPTION)
    stream = ReadDataStream(BytesIO(content))
    if opcode == Opcode.MESSAGE:
        message: McapRecord = Message.read(stream, len(content))
        return message
    record: McapRecord = PARSED[Opcode(opcode)](stream)
    return record


def summary_statistics(file: BinaryIO) -> Statistics | None:
    """What a recording's end states of all of it; None where it does not.

    Raises:
        what ``DAMAGE`` names.
    """
    end = os.fstat(file.fileno()).st_size - len(MAGIC)
    file.seek(max(end - FOOTER_BYTES, 0))
    footer = next(raw_records(file))
    if not isinstance(footer, Footer) or not 0 < footer.summary_start < end:
        return None
    file.seek(footer.summary_start)
    found = (one for one in raw_records(file) if isinstance(one, Statistics))
    return next(found, None)


def decompress(chunk: Chunk) -> bytes:
    """What a chunk opens to, checked; never more than it announces, nor than ``LARGEST_CHUNK``.

    Raises:
        what ``DAMAGE`` names.
    """
    announced = chunk.uncompressed_size
    if announced > LARGEST_CHUNK:
        raise McapError(f"a chunk of {announced} bytes")
    if chunk.compression == "zstd":
        data = _unpack_zstd(chunk.data, announced)
    elif chunk.compression == "lz4":
        data = _unpack_lz4(chunk.data, announced)
    elif chunk.compression == "":
        data = chunk.data
    else:
        raise McapError(f"compression {chunk.compression}")
    if len(data) > announced:
        raise McapError(f"a chunk of {announced} bytes decompresses to more")
    if chunk.uncompressed_crc:
        found = zlib.crc32(data)
        if found != chunk.uncompressed_crc:
            raise CRCValidationError(chunk.uncompressed_crc, found, chunk)
    return data


def _unpack_zstd(data: bytes, announced: int) -> bytes:
    stated = zstandard.get_frame_parameters(data).content_size
    if stated not in (announced, zstandard.CONTENTSIZE_UNKNOWN):
        raise McapError(f"a chunk of {announced} bytes decompresses to {stated}")
    opener = zstandard.ZstdDecompressor(max_window_size=LARGEST_WINDOW)
    return opener.decompress(data, max_output_size=announced)


def _unpack_lz4(data: bytes, announced: int) -> bytes:
    opener = lz4.frame.LZ4FrameDecompressor()
    opened: bytes = opener.decompress(data, max_length=announced + 1)  # the end mark is behind it
    if not opener.eof:
        raise McapError(f"a chunk of {announced} bytes is incomplete, or decompresses to more")
    return opened


def read_exactly(file: BinaryIO, length: int) -> bytes:
    """So many bytes; raises ``EndOfFile`` if there are fewer."""
    content = file.read(length)
    if len(content) < length:
        raise EndOfFile
    return content
