"""The size that a header announces, and that no picture is decoded that is too large."""

import struct
import zlib
from pathlib import Path

import cv2
import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from crenel.errors import OperationError
from crenel.formats import images
from crenel.formats.image_sizes import PNG_SIGNATURE, ImageHeader, read_header
from crenel.formats.images import decode_grey
from tests.present import present
from tests.refusals import refused_as

KINDS = ("png", "jpg", "bmp", "tiff", "pnm", "webp")


def png(width: int, height: int, colour: int = 0, bits: int = 8, data: bytes = b"") -> bytes:
    def chunk(kind: bytes, content: bytes) -> bytes:
        checked = kind + content
        return struct.pack(">I", len(content)) + checked + struct.pack(">I", zlib.crc32(checked))

    head = struct.pack(">IIBBBBB", width, height, bits, colour, 0, 0, 0)
    return PNG_SIGNATURE + chunk(b"IHDR", head) + chunk(b"IDAT", data) + chunk(b"IEND", b"")


def tiff(width: int, height: int, order: str = "<", big: bool = False) -> bytes:
    place = "Q" if big else "I"
    head = (b"II" if order == "<" else b"MM") + struct.pack(f"{order}H", 43 if big else 42)
    head += struct.pack(f"{order}HHQ", 8, 0, 16) if big else struct.pack(f"{order}I", 8)
    tags = [
        struct.pack(f"{order}HH{place}I", tag, 4, 1, value) + bytes(4 if big else 0)
        for tag, value in ((256, width), (257, height))
    ]
    return head + struct.pack(f"{order}{'Q' if big else 'H'}", len(tags)) + b"".join(tags)


LARGE: dict[str, bytes] = {
    "png": png(30_000, 30_000),
    "png of the largest size": png(2**31 - 1, 2**31 - 1),
    "jpeg": b"\xff\xd8\xff\xe0\0\4ab\xff\xff\xc2" + struct.pack(">HBHHB", 11, 8, 65500, 65500, 1),
    "bmp": b"BM" + bytes(12) + struct.pack("<IiiHHI", 40, 2**31 - 1, -(2**31), 1, 8, 1),
    "old bmp": b"BM" + bytes(12) + struct.pack("<IHHHH", 12, 60_000, 60_000, 1, 8),
    "tiff": tiff(30_000, 30_000),
    "tiff of big end first": tiff(30_000, 30_000, ">"),
    "big tiff": tiff(30_000, 30_000, big=True),
    "pgm": b"P5 #\n 32000\n32000 255\n",
    "pbm": b"P4 #x\n 99999 99999\n",
    "webp": b"RIFF\xff\xff\xff\xffWEBPVP8X\n\0\0\0\x10\0\0\0\xff\xff\xff\xff\xff\xff",
}


@pytest.mark.parametrize("name", LARGE)
def test_a_picture_that_is_too_large_is_refused_by_its_size(name: str) -> None:
    with pytest.raises(OperationError) as refused:
        decode_grey(LARGE[name], "a.png")
    assert refused.value.code == "image-too-large"
    assert str(refused.value.what).startswith("a.png has ")
    assert str(refused.value.why) == "at most 100 million are read"


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("colour", [False, True])
@pytest.mark.parametrize("shape", [(1, 1), (30, 41), (257, 1000)])
def test_headers_say_what_decoding_finds(kind: str, colour: bool, shape: tuple[int, int]) -> None:
    picture = np.random.default_rng(0).integers(0, 255, (*shape, 3) if colour else shape)
    done, encoded = cv2.imencode(f".{kind}", picture.astype(np.uint8))
    assert done
    header = present(read_header(encoded.tobytes()))
    found = present(cv2.imdecode(encoded, cv2.IMREAD_UNCHANGED))
    assert (header.height, header.width) == found.shape[:2]
    assert header.channels == (found.shape[2] if found.ndim == 3 else 1)
    assert header.bits == 8


@pytest.mark.parametrize("kind", ["png", "tiff", "pgm"])
def test_sixteen_bit_pictures_are_read(kind: str) -> None:
    picture = np.random.default_rng(1).integers(0, 65535, (30, 41)).astype(np.uint16)
    _, encoded = cv2.imencode(f".{kind}", picture)
    np.testing.assert_array_equal(decode_grey(encoded.tobytes(), "a"), picture)


def test_a_tiff_of_several_pages_is_refused_and_one_with_a_thumbnail_is_read() -> None:
    first, second = np.full((30, 41), 7, np.uint8), np.full((30, 41), 9, np.uint8)
    for more, read in (([second], False), ([second, second], False), ([second[:15, :20]], True)):
        done, encoded = cv2.imencodemulti(".tiff", [first, *more])
        assert done
        if read:
            np.testing.assert_array_equal(decode_grey(encoded.tobytes(), "a.tif"), first)
            continue
        words = ("a.tif has more than one page", "Save each page as a file of its own")
        with refused_as("image-has-pages", *words):
            decode_grey(encoded.tobytes(), "a.tif")


def test_pages_that_follow_in_a_circle_end() -> None:
    _, encoded = cv2.imencode(".tiff", np.full((3, 3), 7, np.uint8))
    raw = bytearray(encoded.tobytes())
    (first,) = struct.unpack_from("<I", raw, 4)
    (count,) = struct.unpack_from("<H", raw, first)
    struct.pack_into("<I", raw, first + 2 + 12 * count, first)
    header = present(read_header(bytes(raw)))
    assert header.more_pages


def test_what_would_be_refused_once_decoded_is_not_decoded(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cv2, "imdecode", None)
    for raw, code in (
        (png(9000, 9000, colour=6, bits=16), "image-too-large"),
        (b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 100000 +X 100000\n", "image-unreadable"),
        (b"P7\nWIDTH 100000\nHEIGHT 100000\nDEPTH 4\n", "image-unreadable"),
        (b"", "image-unreadable"),
    ):
        with refused_as(code):
            decode_grey(raw, "a.png")


def test_a_picture_of_the_largest_size_is_no_refusal_of_it() -> None:
    images._check_header(ImageHeader(10_000, 10_000), "a")
    with pytest.raises(OperationError):
        images._check_header(ImageHeader(10_000, 10_001), "a")


def test_opencv_itself_reads_nothing_larger(tmp_path: Path) -> None:
    raw = np.frombuffer(b"P7\nWIDTH 11000\nHEIGHT 11000\nDEPTH 1\nMAXVAL 255\nENDHDR\n", np.uint8)
    with pytest.raises(cv2.error, match="PIXELS"):
        cv2.imdecode(raw, cv2.IMREAD_UNCHANGED)


STARTS = [*LARGE.values(), tiff(3, 3), png(3, 3), b"P5 3 3 255\n", b"\xff\xd8\xff\xc0"]


@given(st.sampled_from(STARTS), st.integers(0, 80), st.binary(max_size=200))
@example(b"II+\x00\x08\x00\x00\x00\x10\x00\x00\x00\x00\x00\x00\x80", 16, b"")
def test_any_header_announces_a_size_or_none(start: bytes, kept: int, rest: bytes) -> None:
    header = read_header(start[:kept] + rest)
    assert header is None or header.pixels >= 0
