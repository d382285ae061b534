"""STL: triangles without a unit, binary or as text.

Binary files may begin with "solid", too: the size that their count of triangles makes decides.
"""

import re
from itertools import islice
from pathlib import Path
from typing import BinaryIO

import numpy as np

from crenel.formats.clouds.rows import as_doubles, has_decimal_commas
from crenel.formats.drawings.stl import HEADER, TRIANGLE
from crenel.messages.message import message
from crenel.metrology.transforms import Floats
from crenel.parts.cad.document_triangles import (
    Triangles,
    check_triangle_count,
    mesh_error,
    mesh_truncation_error,
)

HEAD_BYTES = len(HEADER) + 4
TEXT = re.compile(rb"\s*solid\b[^\0]*?(\sfacet\s|\sendsolid\b|$)", re.DOTALL | re.IGNORECASE)
CORNER = re.compile(rb"^[ \t]*vertex[ \t]+([^\n]*)$", re.MULTILINE | re.IGNORECASE)
FACET_END = re.compile(rb"^[ \t]*endfacet\b", re.MULTILINE | re.IGNORECASE)
SOLID_END = re.compile(rb"^[ \t]*endsolid\b", re.MULTILINE | re.IGNORECASE)
LONGEST_QUOTE = 40


def is_stl(path: Path, head: bytes, size: int) -> bool:
    """Whether a file is an STL, by its first bytes, its size and its name."""
    is_named = path.suffix.lower() == ".stl" and b"\0" in head
    return is_named or _is_whole(head, size) or _is_text(head)


def read_stl(path: Path, file: BinaryIO) -> Triangles:
    """Reads an STL; raises ``OperationError`` if it is malformed or cut off."""
    size = file.seek(0, 2)
    file.seek(0)
    head = file.read(1 << 16)
    if not _is_whole(head, size) and _is_text(head):
        file.seek(0)
        return Triangles(_read_text(path, file.read()), "STL")
    if size < HEAD_BYTES:
        raise mesh_error(path, message("mesh-header-is-not-complete"))
    announced, found = _count(head), (size - HEAD_BYTES) // TRIANGLE.itemsize
    if found < announced:
        raise mesh_truncation_error(path, found, announced)
    check_triangle_count(path, announced)
    file.seek(HEAD_BYTES)
    rows = np.fromfile(file, TRIANGLE, announced)
    return Triangles(as_doubles(rows["corners"]), "STL")


def _count(head: bytes) -> int:
    """The number of triangles by the head of a binary file."""
    return int.from_bytes(head[len(HEADER) : HEAD_BYTES], "little")


def _is_whole(head: bytes, size: int) -> bool:
    return len(head) >= HEAD_BYTES and size == HEAD_BYTES + TRIANGLE.itemsize * _count(head)


def _is_text(head: bytes) -> bool:
    return b"\0" not in head and TEXT.match(head) is not None


def _read_text(path: Path, text: bytes) -> Floats:
    """(T, 3, 3) corners."""
    text = text.replace(b"\r\n", b"\n").replace(b"\r", b"\n")
    lines = CORNER.findall(text)
    facets = len(FACET_END.findall(text))
    check_triangle_count(path, facets)
    words = b" ".join(lines).split()
    try:
        numbers = np.array(words, dtype=np.bytes_).astype(np.float64) if words else np.empty(0)
    except ValueError:
        numbers = np.empty(0)
    if len(numbers) != 3 * len(lines) or any(len(line.split()) != 3 for line in lines[-1:]):
        _refuse_line(path, text)
    if len(lines) != 3 * facets or SOLID_END.search(text) is None:
        last = len(text.splitlines())
        raise mesh_error(path, message("mesh-text-ends-early", line=last))
    return numbers.reshape(-1, 3, 3)


def _refuse_line(path: Path, text: bytes) -> None:
    """Raises ``OperationError`` for the first corner that is not three numbers."""
    for found in CORNER.finditer(text):
        cells = found.group(1).decode("ascii", "replace").strip()
        try:
            is_row = len([float(cell) for cell in cells.split()]) == 3
        except ValueError:
            is_row = False
        if not is_row:
            line = 1 + text.count(b"\n", 0, found.start())
            said = "".join(islice(cells, LONGEST_QUOTE))
            if has_decimal_commas(cells):
                raise mesh_error(path, message("mesh-line-decimal-commas", line=line, text=said))
            raise mesh_error(path, message("mesh-line-not-three-numbers", line=line, text=said))
