"""The size of an image from its header, without decoding it."""

import re
import struct
from collections.abc import Callable, Iterator
from dataclasses import dataclass

PNG_SIGNATURE = b"\x89PNG\r\n\x1a\n"
JPEG_SIGNATURE = b"\xff\xd8\xff"
PNG_CHANNELS = {2: 3, 3: 3, 4: 2, 6: 4}
"""By colour type; a palette counts as colours."""
JPEG_SIZES = frozenset(range(0xC0, 0xD0)) - {0xC4, 0xC8, 0xCC}
"""JPEG markers that are followed by the size."""
JPEG_BARE = frozenset(range(0xD0, 0xD9)) | {0x01, 0xFF}
"""JPEG markers without content, and fill bytes between markers."""
BMP_CORE = 12
PNM = re.compile(rb"P([1-6])((?:\s+|#[^\n]*\n)+)(\d{1,9})((?:\s+|#[^\n]*\n)+)(\d{1,9})")
PNM_HEAD = 4096
SUBFILE, WIDTH, HEIGHT, BITS, SAMPLES = 254, 256, 257, 258, 277
REDUCED, MASK = 1, 4
"""Bits of ``SUBFILE``: a smaller copy of another page, or its transparency."""
MOST_TAGS, MOST_PAGES = 1000, 100
TIFF_TYPES = {1: "B", 3: "H", 4: "I", 16: "Q"}


FOREIGN_KINDS: tuple[tuple[bytes, str], ...] = (
    (rb"GIF8[79]a", "GIF"),
    (rb"....ftyp(?:heic|heix|hevc|heim|heis|mif1|msf1)", "HEIC"),
    (rb"....ftypavif", "AVIF"),
    (rb"\0\0\0\x0cjP  |\xff\x4f\xff\x51", "JPEG 2000"),
    (rb"II\*\0....CR|....ftypcrx|FUJIFILMCCD-RAW", "RAW"),
    (rb"%PDF-", "PDF"),
)
"""How files of pictures begin that are not read."""


@dataclass(frozen=True)
class ImageHeader:
    """Size in pixels, number of channels, bits per channel, and whether other pictures follow, as
    far as the header states them."""

    width: int
    height: int
    channels: int = 1
    bits: int = 8
    more_pages: bool = False

    @property
    def pixels(self) -> int:
        return self.width * self.height


def read_header(raw: bytes) -> ImageHeader | None:
    """What the header states; None for files that are not images, or not of a supported kind."""
    for signatures, read in KINDS:
        if raw.startswith(signatures):
            try:
                return read(raw)
            except (struct.error, IndexError, OverflowError):  # the file ends before that position
                return None
    return None


def foreign_kind(raw: bytes) -> str | None:
    """The kind of a picture that is not read; None for what is not known to be one.

    Example:
        >>> foreign_kind(b"GIF89a"), foreign_kind(b"BM")
        ('GIF', None)
    """
    kinds = (kind for start, kind in FOREIGN_KINDS if re.match(start, raw, re.DOTALL))
    return next(kinds, None)


def _png(raw: bytes) -> ImageHeader | None:
    length, kind, width, height, bits, colour = struct.unpack_from(
        ">I4sIIBB", raw, len(PNG_SIGNATURE)
    )
    if length != 13 or kind != b"IHDR":
        return None
    return ImageHeader(width, height, PNG_CHANNELS.get(colour, 1), bits)


def _jpeg(raw: bytes) -> ImageHeader | None:
    at = 2
    while True:
        at = raw.find(b"\xff", at)
        if at < 0:
            return None
        marker = raw[at + 1]
        if marker in JPEG_BARE:
            at += 1 if marker == 0xFF else 2
            continue
        (length,) = struct.unpack_from(">H", raw, at + 2)
        if marker in JPEG_SIZES:
            bits, height, width, channels = struct.unpack_from(">BHHB", raw, at + 4)
            return ImageHeader(width, height, channels, bits)
        if marker == 0xDA or length < 2:  # the picture itself, before its size
            return None
        at += 2 + length


def _bmp(raw: bytes) -> ImageHeader | None:
    (head,) = struct.unpack_from("<I", raw, 14)
    if head == BMP_CORE:
        width, height, _, bits = struct.unpack_from("<HHHH", raw, 18)
    else:
        width, height, _, bits = struct.unpack_from("<iiHH", raw, 18)
    return ImageHeader(abs(width), abs(height), max(1, bits // 8) if bits > 16 else 1)


def _pnm(raw: bytes) -> ImageHeader | None:
    found = PNM.match(raw[:PNM_HEAD])
    if found is None:
        return None
    channels = 3 if found[1] in b"36" else 1
    return ImageHeader(int(found[3]), int(found[5]), channels)


def _webp(raw: bytes) -> ImageHeader | None:
    """Always decoded in colour."""
    kind = raw[12:16]
    if raw[8:12] != b"WEBP":
        return None
    if kind == b"VP8X":
        return ImageHeader(_three_bytes(raw, 24) + 1, _three_bytes(raw, 27) + 1, 3)
    if kind == b"VP8L":
        (packed,) = struct.unpack_from("<I", raw, 21)
        return ImageHeader((packed & 0x3FFF) + 1, (packed >> 14 & 0x3FFF) + 1, 3)
    if kind == b"VP8 ":
        width, height = struct.unpack_from("<HH", raw, 26)
        return ImageHeader(width & 0x3FFF, height & 0x3FFF, 3)
    return None


def _three_bytes(raw: bytes, at: int) -> int:
    return int(raw[at]) | raw[at + 1] << 8 | raw[at + 2] << 16


def _tiff(raw: bytes) -> ImageHeader | None:
    """Size of the first picture, which is the one that is read, and whether others follow."""
    pages = _tiff_pages(raw)
    first = next(pages)
    if WIDTH not in first or HEIGHT not in first:
        return None
    more = any(_is_alike(first, page) for page in pages)
    return ImageHeader(
        first[WIDTH], first[HEIGHT], first.get(SAMPLES, 1), first.get(BITS, 1), more_pages=more
    )


def _is_alike(first: dict[int, int], page: dict[int, int]) -> bool:
    """Whether a page is a picture like the first, and no thumbnail or mask of it."""
    marked = page.get(SUBFILE, 0) & (REDUCED | MASK)
    return not marked and all(page.get(tag) == first[tag] for tag in (WIDTH, HEIGHT))


def _tiff_pages(raw: bytes) -> Iterator[dict[int, int]]:
    """The integer tags of every page, each with its first value; a damaged page ends them."""
    order = "<" if raw[:2] == b"II" else ">"
    big = struct.unpack_from(f"{order}H", raw, 2)[0] == 43
    place_kind = "Q" if big else "I"
    (at,) = struct.unpack_from(f"{order}{place_kind}", raw, 8 if big else 4)
    page, at = _tiff_page(raw, order, big, at)
    yield page
    for _ in range(MOST_PAGES):
        if not at:
            return
        try:
            page, at = _tiff_page(raw, order, big, at)
        except (struct.error, OverflowError):
            return
        if not page:
            return
        yield page


def _tiff_page(raw: bytes, order: str, big: bool, at: int) -> tuple[dict[int, int], int]:
    """The tags of the page at a position, and the position of the next one, 0 after the last."""
    count_kind, place_kind, size = ("Q", "Q", 20) if big else ("H", "I", 12)
    (count,) = struct.unpack_from(f"{order}{count_kind}", raw, at)
    start = at + struct.calcsize(count_kind)
    tags: dict[int, int] = {}
    for entry in range(start, start + min(count, MOST_TAGS) * size, size):
        tag, kind, values = struct.unpack_from(f"{order}HH{place_kind}", raw, entry)
        letter = TIFF_TYPES.get(kind)
        if letter is None or tag not in (SUBFILE, WIDTH, HEIGHT, BITS, SAMPLES):
            continue
        value_at = entry + 4 + struct.calcsize(place_kind)
        if values * struct.calcsize(letter) > struct.calcsize(place_kind):
            (value_at,) = struct.unpack_from(f"{order}{place_kind}", raw, value_at)
        tags.setdefault(tag, struct.unpack_from(f"{order}{letter}", raw, value_at)[0])
    try:
        (following,) = struct.unpack_from(f"{order}{place_kind}", raw, start + count * size)
    except (struct.error, OverflowError):  # nothing needs what follows the first page
        following = 0
    return tags, following


KINDS: tuple[tuple[tuple[bytes, ...], Callable[[bytes], ImageHeader | None]], ...] = (
    ((PNG_SIGNATURE,), _png),
    ((JPEG_SIGNATURE,), _jpeg),
    ((b"BM",), _bmp),
    ((b"II*\0", b"MM\0*", b"II+\0", b"MM\0+"), _tiff),
    ((b"RIFF",), _webp),
    (tuple(b"P%d" % number for number in range(1, 7)), _pnm),
)
"""Signatures of the supported kinds, and the readers of their headers."""
