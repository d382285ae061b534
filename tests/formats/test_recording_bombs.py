"""Recordings that announce, or open to, more than any recording holds are damaged."""

import struct
import tracemalloc
import zlib
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import lz4.frame
import pytest
import zstandard

from crenel.formats.recording.raw import LARGEST_CHUNK, MAGIC
from crenel.formats.recording.reader import STATION_METADATA, length_ns, open_recording
from crenel.formats.recording.stream import read_file_blocks

HEADER, SCHEMA, CHANNEL, MESSAGE, CHUNK, ATTACHMENT, METADATA, DATA_END = 1, 3, 4, 5, 6, 9, 12, 15
FUTURE = 0x7F
MOST_BYTES = 200e6
LARGE = 300 << 20


def record(opcode: int, content: bytes, length: int | None = None) -> bytes:
    return struct.pack("<BQ", opcode, len(content) if length is None else length) + content


def text(words: bytes) -> bytes:
    return struct.pack("<I", len(words)) + words


def chunk(compression: bytes, data: bytes, announced: int, crc: int = 0) -> bytes:
    head = struct.pack("<QQQI", 0, 1, announced, crc) + text(compression)
    return record(CHUNK, head + struct.pack("<Q", len(data)) + data)


def zeros(compressor: zstandard.ZstdCompressor, size: int, known: bool) -> bytes:
    stream = compressor.compressobj(size=size if known else -1)
    parts = [stream.compress(bytes(1 << 20)) for _ in range(size >> 20)]
    return b"".join([*parts, stream.flush()])


def zstd(size: int, announced: int, known: bool = True) -> bytes:
    return chunk(b"zstd", zeros(zstandard.ZstdCompressor(1), size, known), announced)


def lz4_zeros(size: int, announced: int) -> bytes:
    with lz4.frame.LZ4FrameCompressor() as packer:
        parts = [packer.begin(), *(packer.compress(bytes(1 << 20)) for _ in range(size >> 20))]
        parts.append(packer.flush())
    return chunk(b"lz4", b"".join(parts), announced)


def packed(data: bytes) -> bytes:
    return chunk(b"zstd", zstandard.compress(data, 1), len(data), zlib.crc32(data))


def station(reported: bytes = b"Bracket") -> bytes:
    pair = text(b"scan_name") + text(reported)
    return record(METADATA, text(STATION_METADATA.encode()) + struct.pack("<I", len(pair)) + pair)


def schema(number: int, data: bytes) -> bytes:
    content = struct.pack("<H", number) + text(b"a.B") + text(b"protobuf") + text(data)
    return record(SCHEMA, content)


BOMBS: dict[str, Callable[[], bytes]] = {
    "zstd that announces its size": lambda: zstd(LARGE, LARGE),
    "zstd of a smaller chunk": lambda: zstd(LARGE, 1000),
    "zstd that announces no size": lambda: zstd(LARGE, LARGEST_CHUNK, known=False),
    "lz4 that announces its size": lambda: lz4_zeros(LARGE, LARGE),
    "lz4 of a smaller chunk": lambda: lz4_zeros(LARGE, 1000),
    "announced alone": lambda: chunk(b"", b"", 1 << 62),
    "a chunk of zeros": lambda: packed(bytes(LARGEST_CHUNK)),
    "millions of records": lambda: packed(record(FUTURE, b"") * (LARGEST_CHUNK // 9)),
    "a huge schema": lambda: packed(schema(1, bytes(60 << 20))),
    "many schemas": lambda: b"".join(packed(schema(i, bytes(1 << 19))) for i in range(200)),
    "many channels": lambda: packed(record(CHANNEL, b"") * 900_000),
    "a schema of nothing": lambda: packed(record(SCHEMA, b"")),
    "a stretch of zeros": lambda: bytes(1 << 20),
    "a length that overflows": lambda: record(CHUNK, b"", (1 << 64) - 1),
    "a length beyond the end": lambda: record(FUTURE, b"", 1 << 40),
    "many bombs": lambda: zstd(LARGE, LARGE) * 50,
}


@pytest.fixture
def frugal() -> Iterator[None]:
    tracemalloc.start()
    yield
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert most < MOST_BYTES


@pytest.mark.slow
@pytest.mark.parametrize("name", BOMBS)
def test_both_call_bombs_damage(name: str, tmp_path: Path, request: pytest.FixtureRequest) -> None:
    path = tmp_path / "scan.mcap"
    path.write_bytes(MAGIC + record(HEADER, text(b"") + text(b"")) + station() + BOMBS[name]())
    request.getfixturevalue("frugal")
    slow, fast = open_recording(path), open_recording(path)
    assert list(slow.records()) == []
    with ThreadPoolExecutor(2) as pool:
        assert all(not block.frames for block in read_file_blocks(fast, pool, 4))
    assert all("is incomplete or damaged" in str(recording.cut) for recording in (slow, fast))
    assert open_recording(path).station_metadata() == {"scan_name": "Bracket"}
    assert length_ns(path) is None


@pytest.mark.usefixtures("frugal")
@pytest.mark.parametrize("sparse", [False, True])
def test_metadata_is_read_from_the_beginning_alone(sparse: bool, tmp_path: Path) -> None:
    path = tmp_path / "scan.mcap"
    late = record(ATTACHMENT, bytes(1 << 20)) + station()
    path.write_bytes(MAGIC + (b"" if sparse else late))
    if sparse:
        with path.open("r+b") as file:
            file.truncate(1 << 42)
    assert open_recording(path).station_metadata() == {}


@pytest.mark.usefixtures("frugal")
def test_attachments_of_any_size_are_passed_over(tmp_path: Path) -> None:
    path = tmp_path / "scan.mcap"
    before = MAGIC + record(ATTACHMENT, b"", LARGE)
    end = record(DATA_END, bytes(4))
    with path.open("wb") as file:
        file.write(before)
        file.seek(LARGE, 1)
        file.write(station() + end)
    recording = open_recording(path)
    assert list(recording.records()) == []
    assert (recording.cut, recording.station) == ("", {"scan_name": "Bracket"})


@pytest.mark.slow
@pytest.mark.parametrize("compression", [b"", b"zstd", b"lz4"])
def test_a_chunk_as_large_as_is_read_is_read(compression: bytes, tmp_path: Path) -> None:
    path = tmp_path / "scan.mcap"
    data = record(FUTURE, bytes(LARGEST_CHUNK - 9))
    pack = {b"": bytes, b"zstd": zstandard.compress, b"lz4": lz4.frame.compress}[compression]
    whole = chunk(compression, pack(data), len(data), zlib.crc32(data))
    path.write_bytes(MAGIC + whole + record(DATA_END, bytes(4)))
    recording, fast = open_recording(path), open_recording(path)
    assert list(recording.records()) == []
    with ThreadPoolExecutor(1) as pool:
        list(read_file_blocks(fast, pool, 4))
    assert (recording.cut, fast.cut) == ("", "")
    assert recording.bytes_read == fast.bytes_read == path.stat().st_size
