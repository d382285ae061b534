"""The pixel formats that the driver understands, and how they become pictures.

Source:
    EMVA, GenICam Pixel Format Naming Convention (PFNC) 2.4 with its list of 32-bit values; AIA,
    GigE Vision 2.0, section 27 for the formats named ``Packed``.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal, cast

import numpy as np
from numpy.typing import NDArray

from crenel_hardware.sensor.grey import BayerPattern
from crenel_hardware.sensor.image_source import GreyImage

Bytes = NDArray[np.uint8]
Packing = Literal["bytes", "words", "lsb", "gige"]
"""One byte per pixel; two bytes, the low one first; a string of bits from the lowest bit on (names
with ``p``); pairs of pixels in three bytes (names with ``Packed``)."""


@dataclass(frozen=True, slots=True)
class PixelFormat:
    """One pixel format."""

    name: str
    code: int
    """Its 32-bit value in PFNC; bits 16 to 23 are the size of a pixel in bits."""
    bits: int
    """Significant bits of a pixel, or of a channel of a colour format."""
    packing: Packing
    bayer: BayerPattern | None = None
    channels: Literal["RGB", "BGR"] | None = None

    @property
    def full_scale(self) -> int:
        """The largest value of a pixel."""
        return (1 << self.bits) - 1

    @property
    def stored_bits(self) -> int:
        """Bits per pixel in the data."""
        return self.code >> 16 & 0xFF


_PATTERNS: dict[str, BayerPattern] = {"GR": "GRBG", "RG": "RGGB", "GB": "GBRG", "BG": "BGGR"}


def _bayer_formats() -> Iterable[PixelFormat]:
    codes: list[tuple[str, int, Packing, tuple[int, int, int, int]]] = [
        ("8", 8, "bytes", (0x01080008, 0x01080009, 0x0108000A, 0x0108000B)),
        ("10", 10, "words", (0x0110000C, 0x0110000D, 0x0110000E, 0x0110000F)),
        ("12", 12, "words", (0x01100010, 0x01100011, 0x01100012, 0x01100013)),
        ("16", 16, "words", (0x0110002E, 0x0110002F, 0x01100030, 0x01100031)),
        ("10Packed", 10, "gige", (0x010C0026, 0x010C0027, 0x010C0028, 0x010C0029)),
        ("12Packed", 12, "gige", (0x010C002A, 0x010C002B, 0x010C002C, 0x010C002D)),
        ("10p", 10, "lsb", (0x010A0056, 0x010A0058, 0x010A0054, 0x010A0052)),
        ("12p", 12, "lsb", (0x010C0057, 0x010C0059, 0x010C0055, 0x010C0053)),
    ]
    for suffix, bits, packing, values in codes:
        for (letters, pattern), code in zip(_PATTERNS.items(), values, strict=True):
            yield PixelFormat(f"Bayer{letters}{suffix}", code, bits, packing, bayer=pattern)


FORMATS: dict[str, PixelFormat] = {
    one.name: one
    for one in (
        PixelFormat("Mono8", 0x01080001, 8, "bytes"),
        PixelFormat("Mono10", 0x01100003, 10, "words"),
        PixelFormat("Mono12", 0x01100005, 12, "words"),
        PixelFormat("Mono14", 0x01100025, 14, "words"),
        PixelFormat("Mono16", 0x01100007, 16, "words"),
        PixelFormat("Mono10Packed", 0x010C0004, 10, "gige"),
        PixelFormat("Mono12Packed", 0x010C0006, 12, "gige"),
        PixelFormat("Mono10p", 0x010A0046, 10, "lsb"),
        PixelFormat("Mono12p", 0x010C0047, 12, "lsb"),
        PixelFormat("RGB8", 0x02180014, 8, "bytes", channels="RGB"),
        PixelFormat("BGR8", 0x02180015, 8, "bytes", channels="BGR"),
        *_bayer_formats(),
    )
}
"""By name. Those that a driver chooses by itself come first."""
_BY_CODE = {one.code: one for one in FORMATS.values()}


def format_of(code: int) -> PixelFormat | None:
    """The format with a value of PFNC; None if the driver does not understand it."""
    return _BY_CODE.get(code)


def decode(
    data: Bytes, pixel_format: PixelFormat, width_px: int, height_px: int, padding: int = 0
) -> GreyImage | None:
    """The picture in the data of one image, as (height, width), or (height, width, 3) BGR.

    Args:
        data: (n,) bytes as they arrived.
        padding: bytes after each line. Without padding, a packed line may begin within a byte.

    Returns:
        A new array; None if there are too few bytes.
    """
    pixels = width_px * height_px
    if padding:
        line = -(-width_px * pixel_format.stored_bits // 8)
        if data.size < (line + padding) * height_px - padding:
            return None
        lines = np.zeros((height_px, line + padding), np.uint8)
        held = data[: lines.size]
        lines.reshape(-1)[: held.size] = held
        per_line = [_unpack(each[:line], pixel_format, width_px) for each in lines]
        return cast(GreyImage, _shape(np.stack(per_line), pixel_format, width_px, height_px))
    size = -(-pixels * pixel_format.stored_bits // 8)
    if data.size < size:
        return None
    values = _unpack(data[:size], pixel_format, pixels)
    return cast(GreyImage, _shape(values, pixel_format, width_px, height_px))


def _shape(
    values: NDArray[np.generic], pixel_format: PixelFormat, width_px: int, height_px: int
) -> NDArray[np.generic]:
    if pixel_format.channels is None:
        return values.reshape(height_px, width_px)
    colours = values.reshape(height_px, width_px, 3)
    return colours[..., ::-1].copy() if pixel_format.channels == "RGB" else colours


def _unpack(data: Bytes, pixel_format: PixelFormat, pixels: int) -> NDArray[np.generic]:
    """The values of one run of pixels, as a new array."""
    match pixel_format.packing, pixel_format.bits:
        case "bytes", _:
            return data.copy()
        case "words", _:
            return data.view("<u2").astype(np.uint16)
        case "gige", bits:
            return _unpack_pairs(data, bits - 8, pixels)
        case "lsb", 10:
            return _unpack_groups(data, 5, 4, 10, pixels)
        case _:
            return _unpack_groups(data, 3, 2, 12, pixels)


def _unpack_pairs(data: Bytes, low_bits: int, pixels: int) -> NDArray[np.uint16]:
    """``Mono10Packed`` and its like: the high byte of two pixels, and their low bits between."""
    groups = _in_groups(data, 3)
    low = groups[:, 1]
    mask = (1 << low_bits) - 1
    first = groups[:, 0] << low_bits | low & mask
    second = groups[:, 2] << low_bits | low >> 4 & mask
    return np.stack((first, second), axis=1).reshape(-1)[:pixels]


def _unpack_groups(
    data: Bytes, group_bytes: int, group_pixels: int, bits: int, pixels: int
) -> NDArray[np.uint16]:
    """``Mono10p`` and its like: each pixel takes the next bits, the lowest bit first."""
    groups = _in_groups(data, group_bytes)
    values = np.empty((len(groups), group_pixels), np.uint16)
    for index in range(group_pixels):
        byte, bit = divmod(index * bits, 8)
        low = groups[:, byte] >> bit
        values[:, index] = (low | groups[:, byte + 1] << (8 - bit)) & (1 << bits) - 1
    return values.reshape(-1)[:pixels]


def _in_groups(data: Bytes, size: int) -> NDArray[np.uint16]:
    """(n, size) bytes as 16-bit numbers, the last group filled with zeros."""
    groups = np.zeros((-(-data.size // size), size), np.uint16)
    groups.reshape(-1)[: data.size] = data
    return groups
