"""Pixel formats of industrial cameras: known bytes, and packing that a test does the slow way."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from crenel_hardware.sensor.genicam.pixel_formats import FORMATS, PixelFormat, decode, format_of

MONO = [name for name in FORMATS if name.startswith("Mono")]
RAW = [name for name in FORMATS if name.startswith("Bayer")]


def pack(values: list[int], pixel_format: PixelFormat) -> bytes:
    """The bytes of a run of pixels, bit by bit."""
    bits = pixel_format.bits
    match pixel_format.packing:
        case "bytes":
            return bytes(values)
        case "words":
            return b"".join(value.to_bytes(2, "little") for value in values)
        case "lsb":
            number = sum(value << bits * index for index, value in enumerate(values))
            return number.to_bytes(-(-bits * len(values) // 8), "little")
        case "gige":
            low, packed = bits - 8, bytearray()
            for first, second in zip(values[::2], [*values[1::2], 0], strict=False):
                between = first % (1 << low) | second % (1 << low) << 4
                packed += bytes((first >> low, between, second >> low))
            return bytes(packed)[: -(-12 * len(values) // 8)]


def as_array(data: bytes) -> NDArray[np.uint8]:
    return np.frombuffer(data, np.uint8)


def decoded(
    data: NDArray[np.uint8], pixel_format: PixelFormat, width: int, height: int, padding: int = 0
) -> NDArray[np.integer]:
    image = decode(data, pixel_format, width, height, padding)
    assert image is not None
    return image


@pytest.mark.parametrize(
    ("name", "data", "pixels"),
    [
        ("Mono8", "00 7f ff 01", [0, 127, 255, 1]),
        ("Mono10", "ff03 0100 0002 0000", [1023, 1, 512, 0]),
        ("Mono12", "ff0f 0100 0008 0000", [4095, 1, 2048, 0]),
        ("Mono14", "ff3f 0100 0020 0000", [16383, 1, 8192, 0]),
        ("Mono16", "ffff 0100 0080 0000", [65535, 1, 32768, 0]),
        # high bits, the low bits of both, high bits
        ("Mono10Packed", "ff 03 00  00 30 80", [1023, 0, 0, 515]),
        ("Mono12Packed", "ff 0f 00  12 53 46", [4095, 0, 0x123, 0x465]),
        # four pixels of 10 bits from the lowest bit on: 1, 2, 4, 1023
        ("Mono10p", "01 08 40 c0 ff", [1, 2, 4, 1023]),
        ("Mono12p", "23 61 45  ff 0f 80", [0x123, 0x456, 0xFFF, 0x800]),
    ],
)
def test_known_bytes(name: str, data: str, pixels: list[int]) -> None:
    pixel_format = FORMATS[name]
    image = decoded(as_array(bytes.fromhex(data)), pixel_format, 4, 1)
    assert image.tolist() == [pixels]
    assert image.dtype == (np.uint8 if pixel_format.bits == 8 else np.uint16)
    assert image.max() <= pixel_format.full_scale


@given(st.data())
def test_every_grey_and_raw_format_gives_its_pixels(data: st.DataObject) -> None:
    pixel_format = FORMATS[data.draw(st.sampled_from(MONO + RAW))]
    width, height = data.draw(st.integers(1, 9)), data.draw(st.integers(1, 5))
    level = st.integers(0, pixel_format.full_scale)
    pixels = data.draw(st.lists(level, min_size=width * height, max_size=width * height))
    image = decoded(as_array(pack(pixels, pixel_format)), pixel_format, width, height)
    assert image.reshape(-1).tolist() == pixels
    assert decode(as_array(pack(pixels, pixel_format)[:-1]), pixel_format, width, height) is None


@given(st.data(), st.integers(1, 7))
def test_padded_lines_begin_at_a_byte(data: st.DataObject, padding: int) -> None:
    pixel_format = FORMATS[data.draw(st.sampled_from(MONO))]
    width, height = data.draw(st.integers(1, 9)), data.draw(st.integers(1, 5))
    level = st.integers(0, pixel_format.full_scale)
    row = st.lists(level, min_size=width, max_size=width)
    rows = data.draw(st.lists(row, min_size=height, max_size=height))
    lines = (bytes(padding) + b"").join(pack(row, pixel_format) for row in rows)
    image = decoded(as_array(lines), pixel_format, width, height, padding)
    assert image.tolist() == rows


def test_colours_become_blue_green_red() -> None:
    data = as_array(bytes([1, 2, 3, 4, 5, 6]))
    assert decoded(data, FORMATS["RGB8"], 2, 1).tolist() == [[[3, 2, 1], [6, 5, 4]]]
    assert decoded(data, FORMATS["BGR8"], 2, 1).tolist() == [[[1, 2, 3], [4, 5, 6]]]


def test_a_picture_does_not_share_the_cameras_memory() -> None:
    for pixel_format in FORMATS.values():
        memory = np.zeros(4 * 2 * 6, np.uint8)
        image = decoded(memory, pixel_format, 4, 2)
        memory[:] = 255
        assert image.max() == 0, pixel_format.name


def test_values_of_the_naming_convention_say_the_size_and_are_known() -> None:
    for name, pixel_format in FORMATS.items():
        assert format_of(pixel_format.code) is pixel_format, name
        channels = 1 if pixel_format.channels is None else 3
        assert pixel_format.stored_bits >= channels * pixel_format.bits
    assert len({one.code for one in FORMATS.values()}) == len(FORMATS)
    assert format_of(0x01100041) is None
