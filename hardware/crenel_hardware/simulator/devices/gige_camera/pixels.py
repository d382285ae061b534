"""Grey pictures and rows of profiles as the bytes of a pixel format.

Source:
    EMVA, GenICam Pixel Format Naming Convention (PFNC) 2.4.
"""

import numpy as np
from numpy.typing import NDArray

RawImage = NDArray[np.uint8] | NDArray[np.uint16]

CODES = {"Mono8": 0x01080001, "Mono10": 0x01100003, "Mono12": 0x01100005, "Mono16": 0x01100007}
"""The formats of the camera, and their values."""
_BITS = {"Mono8": 8, "Mono10": 10, "Mono12": 12, "Mono16": 16}


ROWS_CODE = 0x011000B8
"""The value of Coord3D_C16, the format of profiles."""


def bytes_per_px(code: int) -> int:
    """Bytes that a pixel takes."""
    return (code >> 16 & 0xFF) // 8


def encode(image: RawImage, image_bits: int, code: int) -> bytes:
    """The bytes of an (H, W) image with ``image_bits`` significant bits, low bytes first."""
    name = next(name for name, value in CODES.items() if value == code)
    shift = _BITS[name] - image_bits
    if name == "Mono8":
        return (image >> -shift if shift < 0 else image << shift).astype(np.uint8).tobytes()
    wide = image.astype("<u2")
    return (wide << shift if shift >= 0 else wide >> -shift).astype("<u2").tobytes()
