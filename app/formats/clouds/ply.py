"""The PLY format, as far as clouds need it: any order of scalar vertex properties is read."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

import numpy as np

from app.errors import OperationError
from app.formats.clouds.axis_names import cloud_of_axes, find_named_axes
from app.formats.clouds.points import POINT, Cloud, Points
from app.formats.clouds.rows import (
    COUNT_WIDTH,
    as_doubles,
    format_error,
    read_binary_rows,
    read_text_rows,
    truncation_error,
)
from app.formats.file_names import display_path
from app.messages.message import message
from app.metrology.transforms import Floats

TYPES = {
    **dict.fromkeys(("char", "int8"), "i1"),
    **dict.fromkeys(("uchar", "uint8"), "u1"),
    **dict.fromkeys(("short", "int16"), "i2"),
    **dict.fromkeys(("ushort", "uint16"), "u2"),
    **dict.fromkeys(("int", "int32"), "i4"),
    **dict.fromkeys(("uint", "uint32"), "u4"),
    **dict.fromkeys(("float", "float32"), "f4"),
    **dict.fromkeys(("double", "float64"), "f8"),
}
ORDERS = {"binary_little_endian": "<", "binary_big_endian": ">", "ascii": "="}
LONGEST_HEADER = 1000
WRITE_TYPES = {"f8": "double", "f4": "float", "i4": "int"}


class PlySink:
    """Appends points, binary little-endian, to an open file."""

    def __init__(self, file: BinaryIO) -> None:
        self._file = file
        self._points = 0
        file.write(_header(0))

    def write(self, points: Points) -> None:
        self._file.write(np.ascontiguousarray(points).data)
        self._points += len(points)

    def finish(self) -> None:
        """Puts the final count into the header."""
        self._file.seek(0)
        self._file.write(_header(self._points))


def read_ply(path: Path, file: BinaryIO, columns: Sequence[str] | None = None) -> Cloud:
    """Reads a PLY's vertices; raises ``OperationError`` if malformed or cut off.

    Args:
        columns: the properties of x, y and z, if the user names them.
    """
    vertices = find_vertices(path, file)
    names = list(vertices.layout.names or ())
    axes = find_named_axes(path, names, columns)
    return cloud_of_axes(read_vertices(path, file, vertices), names, axes)


@dataclass(frozen=True)
class Vertices:
    """Where the vertices stand in a file."""

    ascii: bool
    count: int
    layout: np.dtype[np.void]
    bytes_before: int
    """Of other elements' data between header and vertices."""
    lines_before: int
    """The same in lines, for ascii."""


def find_vertices(path: Path, file: BinaryIO) -> Vertices:
    """Reads the header and leaves the file at its end; raises ``OperationError`` if malformed."""
    file.seek(0)
    words = [line.split() for line in _header_lines(path, file)]
    formats = [line[1] for line in words if line[:1] == ["format"] and len(line) > 1]
    if not formats or formats[0] not in ORDERS:
        raise format_error(path, message("cloud-no-ply-format"))
    order = ORDERS[formats[0]]
    bytes_before = lines_before = 0
    for name, count, properties in _elements(path, words):
        lists = [field for kind, field in properties if kind == "list"]
        if lists and name == "vertex":
            raise OperationError(
                "cloud-malformed",
                display_path(path),
                message("cloud-points-have-list", name=lists[0]),
                message("cloud-export-without-property", name=lists[0]),
            )
        if not count and name != "vertex":
            continue  # it takes no bytes
        if lists:
            raise format_error(path, message("cloud-element-has-lists", name=name))
        if len({field for _, field in properties}) < len(properties):
            raise format_error(path, message("cloud-element-repeats-property", name=name))
        layout = np.dtype([(field, order + TYPES[kind]) for kind, field in properties])
        if name == "vertex":
            return Vertices(formats[0] == "ascii", count, layout, bytes_before, lines_before)
        bytes_before += count * layout.itemsize
        lines_before += count
    raise format_error(path, message("cloud-no-element-vertex"))


def read_vertices(path: Path, file: BinaryIO, vertices: Vertices) -> dict[str, Floats]:
    """The vertices' properties (N,) by name; the file stands at its header's end."""
    if vertices.ascii:
        return _read_ascii(path, file, vertices)
    start = file.tell() + vertices.bytes_before
    table = read_binary_rows(path, file, start, vertices.layout, vertices.count)
    return {name: as_doubles(table[name]) for name in vertices.layout.names or ()}


def _header(count: int) -> bytes:
    """The header, of one length whatever the count: a comment takes up the slack."""
    digits = str(count)
    lines = [
        "ply",
        "format binary_little_endian 1.0",
        "comment crenel cloud: mm, arm frame " + "." * (COUNT_WIDTH - len(digits)),
        f"element vertex {digits}",
        *(f"property {WRITE_TYPES[POINT[name].str[1:]]} {name}" for name in POINT.names or ()),
        "end_header",
    ]
    return ("\n".join(lines) + "\n").encode()


def _header_lines(path: Path, file: BinaryIO) -> list[str]:
    lines: list[str] = []
    for _ in range(LONGEST_HEADER):
        line = file.readline(4096)
        if not line:
            break
        lines.append(line.decode("latin-1").strip())
        if lines[-1] == "end_header":
            return lines
    raise format_error(path, message("cloud-header-does-not-end"))


def _elements(path: Path, words: list[list[str]]) -> list[tuple[str, int, list[tuple[str, str]]]]:
    """Elements up to the vertices: name, count, and (type, name) of each property."""
    elements: list[tuple[str, int, list[tuple[str, str]]]] = []
    for line in words:
        if line[:1] == ["element"]:
            if len(line) != 3 or not line[2].isdecimal():
                raise format_error(
                    path, message("cloud-header-contains", line=repr(" ".join(line)))
                )
            elements.append((line[1], int(line[2]), []))
        elif line[:1] == ["property"]:
            known = len(line) >= 3 and (line[1] in TYPES or line[1] == "list")
            if not elements or not known:
                raise format_error(
                    path, message("cloud-header-contains", line=repr(" ".join(line)))
                )
            elements[-1][2].append((line[1], line[-1]))
    return elements


def _read_ascii(path: Path, file: BinaryIO, vertices: Vertices) -> dict[str, Floats]:
    names = vertices.layout.names or ()
    for _ in range(vertices.lines_before):
        if not file.readline():
            raise truncation_error(path, 0, vertices.count)
    table = read_text_rows(path, file, len(names), vertices.count)
    return {name: table[:, i] for i, name in enumerate(names)}
