"""Images: read and checked to the last byte, one grey channel each; written losslessly."""

import struct
import zlib
from pathlib import Path
from typing import cast

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.formats.atomic_write import write_atomically
from crenel.formats.file_names import display_path
from crenel.formats.image_sizes import PNG_SIGNATURE, ImageHeader, foreign_kind, read_header
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.open_file import read_bounded
from crenel.messages.message import Text, message
from crenel.metrology.bayer import CELL_PX, BayerPlane
from crenel.metrology.channel import Channel, describe_channel, is_grey, select_channel
from crenel.metrology.colour import Colours
from crenel.metrology.image import saturation_level

GreyImage = NDArray[np.uint8] | NDArray[np.uint16]
"""(height, width)"""

MOST_PIXELS = 100_000_000
"""The most pixels of a picture, all channels together."""


def read_grey(path: Path, channel: Channel | None = None) -> GreyImage:
    """Reads an image of 8 or 16 bits a channel: PNG, TIFF, BMP, PGM or JPEG.

    Args:
        channel: by which a colour picture becomes grey, and a raw one the picture of half its
            size that the pixels of one colour are. Pictures whose channels are all equal are
            grey without it.

    Raises:
        OperationError: missing, no image, damaged or cut off, in colour while the laser's
            colour is not known or a raw picture is expected, of several pages, or of more than
            ``MOST_PIXELS``.
    """
    return select_grey(read_image(path), display_path(path), channel)


def read_grey_to_show(path: Path, channel: Channel | None = None) -> GreyImage:
    """The same in the size of the file, for people to look at."""
    grey = read_grey(path, channel)
    if isinstance(channel, BayerPlane):
        return cast(GreyImage, np.repeat(np.repeat(grey, CELL_PX, axis=0), CELL_PX, axis=1))
    return grey


def read_colours(path: Path) -> Colours | None:
    """All channels (H, W, 3 or more) of a colour picture; None of a grey one.

    Raises:
        OperationError: as ``read_grey``.
    """
    picture = read_image(path)
    return None if is_grey(picture) else picture


def read_image(path: Path) -> Colours:
    """The picture as it is in the file, (H, W) or (H, W, channels).

    Raises:
        OperationError: as ``read_grey``.
    """
    return decode_image(_read_file(path), display_path(path))


def channel_text(path: Path, channel: Channel | None) -> Text:
    """What of a picture ``read_grey`` takes, in words."""
    return message("channel-grey") if channel is None else describe_grey(read_image(path), channel)


def describe_grey(picture: Colours, channel: Channel | None) -> Text:
    """What of a picture ``select_grey`` takes, in words."""
    if channel is None or (is_grey(picture) and not isinstance(channel, BayerPlane)):
        return message("channel-grey")
    return describe_channel(channel)


def decode_grey(raw: bytes, named: Text, channel: Channel | None = None) -> GreyImage:
    """Decodes an image file's bytes; ``named`` is what an error calls it."""
    return select_grey(decode_image(raw, named), named, channel)


def select_grey(picture: Colours, named: Text, channel: Channel | None = None) -> GreyImage:
    """The grey picture of one as in its file, as ``read_grey``; ``named``: as ``decode_grey``."""
    grey = select_channel(picture, channel)
    if grey is None:
        raise _not_raw(named) if isinstance(channel, BayerPlane) else _in_colour(named)
    return grey


def _read_file(path: Path) -> bytes:
    with convert_io_errors(path):
        return read_bounded(path)


def decode_image(raw: bytes, named: Text) -> Colours:
    """The picture as it is in the file (H, W) or (H, W, channels); ``named`` is what an error calls
    it.

    Raises:
        OperationError: as ``read_grey``.
    """
    if raw.startswith(PNG_SIGNATURE):
        _check_png(raw, named)
    header = read_header(raw)
    if header is None:
        raise _no_image(raw, named)
    _check_header(header, named)
    try:
        image = cv2.imdecode(np.frombuffer(raw, np.uint8), cv2.IMREAD_UNCHANGED)
    except cv2.error:  # larger than OpenCV can read
        image = None
    if image is None:
        raise _no_image(raw, named)
    if image.dtype not in (np.uint8, np.uint16):
        raise _not_so_deep(named, str(image.dtype))
    return cast(Colours, image)


def _check_header(header: ImageHeader, named: Text) -> None:
    """Raises ``OperationError`` for what would be decoded only to be refused, or is too large:
    a file of a megabyte may open to gigabytes."""
    if header.pixels * header.channels > MOST_PIXELS:
        raise OperationError(
            "image-too-large",
            message("image-has-pixels", name=named, width=header.width, height=header.height),
            message("most-pixels-read", millions=MOST_PIXELS // 1000000),
            message("give-cameras-own-picture"),
        )
    if header.more_pages:
        raise OperationError(
            "image-has-pages",
            message("image-has-pages", name=named),
            message("one-picture-per-file"),
            message("save-pages-apart"),
        )
    if header.bits > 16:
        raise _not_so_deep(named, message("bits-per-pixel", bits=header.bits))


def _no_image(raw: bytes, named: Text) -> OperationError:
    kind = foreign_kind(raw)
    if kind:
        why = message("picture-of-kind-that-is-not-read", kind=kind)
        return OperationError("image-kind", named, why, message("save-as-png-tiff-or-jpeg"))
    why = message("no-image-or-cut-off") if raw else message("empty")
    return OperationError("image-unreadable", named, why, message("restore-take-picture-again"))


def _in_colour(named: Text) -> OperationError:
    return OperationError(
        "image-in-colour",
        message("image-in-colour", name=named),
        message("laser-colour-not-known"),
        message("state-laser-colour"),
    )


def _not_raw(named: Text) -> OperationError:
    return OperationError(
        "image-not-raw",
        message("image-in-colour", name=named),
        message("raw-bayer-has-one-channel"),
        message("give-raw-or-without-bayer"),
    )


def _not_so_deep(named: Text, held: Text) -> OperationError:
    return OperationError(
        "image-depth", message("image-has-depth", name=named, depth=held), message("bits-expected")
    )


def to_8_bits(image: GreyImage) -> NDArray[np.uint8]:
    """The image (height, width) with its full scale at 255, to be shown."""
    return np.asarray(cv2.convertScaleAbs(image, alpha=255.0 / saturation_level(image)), np.uint8)


def write_png(path: Path, image: GreyImage) -> None:
    """Writes a grey image (height, width) as PNG, atomically."""
    done, encoded = cv2.imencode(".png", image, [cv2.IMWRITE_PNG_COMPRESSION, 1])
    if not done:
        raise OperationError(
            "image-unwritable", display_path(path), message("picture-cannot-be-encoded")
        )
    write_atomically(path, encoded.tobytes())


def image_size(path: Path) -> tuple[int, int]:
    """Width and height in pixels from the header of a picture, without decoding it.

    Raises:
        OperationError: missing, or no picture.
    """
    raw = _read_file(path)  # some kinds have their header at the end
    header = read_header(raw)
    if header is None:
        raise _no_image(raw, display_path(path))
    return header.width, header.height


def _check_png(raw: bytes, named: Text) -> None:
    """Walks through the chunks: decoders fill missing parts of a damaged file with black."""
    at = len(PNG_SIGNATURE)
    while at + 12 <= len(raw):
        (length,) = struct.unpack_from(">I", raw, at)
        kind = raw[at + 4 : at + 8]
        end = at + 8 + length
        if end + 4 > len(raw):
            break
        (expected,) = struct.unpack_from(">I", raw, end)
        if zlib.crc32(memoryview(raw)[at + 4 : end]) != expected:
            raise OperationError(
                "image-damaged",
                message("checksum-wrong-at-byte", name=named, byte=at),
                message("file-damaged"),
                message("restore-take-picture-again"),
            )
        if kind == b"IEND":
            return
        at = end + 4
    raise OperationError(
        "image-cut-off",
        message("image-ends-after-bytes", name=named, bytes=len(raw)),
        message("file-cut-off"),
        message("restore-take-picture-again"),
    )
