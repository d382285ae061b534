"""Grey pictures: read from files, of a depth, blurred, and compressed."""

from pathlib import Path
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.metrology.image import Image

Depth = type[np.uint8] | type[np.uint16]


def read_picture(path: Path) -> NDArray[np.uint8]:
    """A picture file of 8 bits as it is stored."""
    return decode_picture(path.read_bytes())


def decode_picture(raw: bytes) -> NDArray[np.uint8]:
    """The picture that a file's bytes hold."""
    picture = cv2.imdecode(np.frombuffer(raw, np.uint8), cv2.IMREAD_UNCHANGED)
    assert picture is not None
    assert picture.dtype == np.uint8
    return picture.astype(np.uint8, copy=False)


def blur(picture: NDArray[np.uint8], sigma_px: float) -> NDArray[np.uint8]:
    """A picture out of focus by so much."""
    return np.asarray(cv2.GaussianBlur(picture, (0, 0), sigma_px), dtype=np.uint8)


def halve(picture: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """A picture of half the size, in which a search takes a quarter of the time."""
    half = cv2.resize(picture, None, fx=0.5, fy=0.5, interpolation=cv2.INTER_AREA)
    return np.asarray(half, np.uint8)


def compressed(picture: NDArray[np.uint8], quality: int) -> NDArray[np.uint8]:
    """A picture as JPEG keeps it, of a quality up to 100."""
    raw = cv2.imencode(".jpg", picture, [cv2.IMWRITE_JPEG_QUALITY, quality])[1]
    return np.asarray(cv2.imdecode(raw, cv2.IMREAD_GRAYSCALE), np.uint8)


def of_depth(levels: NDArray[Any], depth: Depth) -> Image:
    """Whole grey levels as a picture of 8 or 16 bits."""
    return levels.astype(np.uint8) if depth is np.uint8 else levels.astype(np.uint16)
