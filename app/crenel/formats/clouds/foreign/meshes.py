"""Meshes as clouds of their vertices: OBJ, STL and OFF.

A vertex that several triangles have in common, and that STL repeats for each, is one point.
"""

import re
from pathlib import Path
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from crenel.formats.clouds.points import Cloud
from crenel.formats.clouds.rows import (
    as_doubles,
    format_error,
    read_binary_rows,
    read_text_rows,
    text_lines,
)
from crenel.formats.drawings.stl import HEADER, TRIANGLE
from crenel.messages.message import message
from crenel.metrology.transforms import Floats

STL_HEAD = len(HEADER) + 4
OFF = re.compile(rb"\s*(ST|C|N)*(OFF)(?=\s)")
OBJ_LINE = re.compile(rb"^[ \t]*v[ \t]+(.*)$", re.MULTILINE)
OBJ_BEGINNING = re.compile(rb"(\s|#.*\n)*(v|vn|vt|g|o|s|mtllib|usemtl)[ \t]")
STL_CORNER = re.compile(rb"^[ \t]*vertex[ \t]+(.*)$", re.MULTILINE | re.IGNORECASE)
STL_TEXT = re.compile(rb"\s*solid\b.*\s+facet\s", re.DOTALL | re.IGNORECASE)


def is_obj(path: Path, head: bytes) -> bool:
    """Whether a file begins like a Wavefront OBJ."""
    has_vertices = path.suffix.lower() == ".obj" or OBJ_LINE.search(head) is not None
    return has_vertices and OBJ_BEGINNING.match(head) is not None and b"\0" not in head


def is_off(head: bytes) -> bool:
    """Whether a file begins like an OFF in text."""
    return OFF.match(head) is not None and b"\0" not in head


def is_stl(head: bytes, size: int) -> bool:
    """Whether a file of so many bytes is an STL, in text or binary."""
    if len(head) >= STL_HEAD and size == STL_HEAD + TRIANGLE.itemsize * _count(head):
        return True
    return STL_TEXT.match(head) is not None and b"\0" not in head


def read_obj(path: Path, file: BinaryIO) -> Cloud:
    """Reads an OBJ's vertices; raises ``OperationError`` for one that has no three numbers."""
    file.seek(0)
    joined = re.sub(rb"\\\r?\n", b" ", file.read())
    return Cloud(_read_vertices(path, OBJ_LINE.findall(joined.replace(b"\r", b"\n"))))


def read_off(path: Path, file: BinaryIO) -> Cloud:
    """Reads an OFF's vertices; raises ``OperationError`` if malformed or cut off."""
    file.seek(0)
    plain = (line.partition(b"#")[0] for line in text_lines(file))
    lines = (line for line in plain if line.strip())
    counts = OFF.sub(b"", next(lines) + b" ").split() or next(lines, b"").split()
    if not counts or not counts[0].isdigit():
        raise format_error(path, message("cloud-header-does-not-end"))
    return Cloud(read_text_rows(path, lines, 3, int(counts[0])))


def read_stl(path: Path, file: BinaryIO) -> Cloud:
    """Reads the corners of an STL's triangles; raises ``OperationError`` if malformed."""
    size = file.seek(0, 2)
    file.seek(0)
    head = file.read(STL_HEAD)
    if size == STL_HEAD + TRIANGLE.itemsize * _count(head):
        triangles = read_binary_rows(path, file, STL_HEAD, TRIANGLE, _count(head))
        return Cloud(_distinct_rows(as_doubles(triangles["corners"]).reshape(-1, 3)))
    text = head + file.read()
    corners = _read_vertices(path, STL_CORNER.findall(text.replace(b"\r", b"\n")))
    return Cloud(_distinct_rows(corners))


def _count(head: bytes) -> int:
    """The number of triangles by the head of a binary STL."""
    return int.from_bytes(head[len(HEADER) : STL_HEAD], "little")


def _read_vertices(path: Path, lines: list[bytes]) -> Floats:
    """(N, 3) from the numbers behind the word that marks a vertex."""
    return read_text_rows(path, iter(lines), 3, len(lines))


def _distinct_rows(corners: Floats) -> NDArray[np.float64]:
    return np.unique(corners, axis=0)
