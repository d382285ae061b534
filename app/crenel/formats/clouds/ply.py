"""The PLY format, as far as clouds need it: vertices with any properties are read."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import BinaryIO

import numpy as np

from crenel.formats.clouds.axis_names import cloud_of_axes, find_named_axes
from crenel.formats.clouds.ply_elements import (
    Element,
    Property,
    read_binary_element,
    read_text_element,
)
from crenel.formats.clouds.points import POINT, Cloud, Points
from crenel.formats.clouds.rows import COUNT_WIDTH, distinct_names, format_error
from crenel.messages.message import message
from crenel.metrology.transforms import Floats

TYPES = {
    **dict.fromkeys(("char", "int8"), "i1"),
    **dict.fromkeys(("uchar", "uint8"), "u1"),
    **dict.fromkeys(("short", "int16"), "i2"),
    **dict.fromkeys(("ushort", "uint16"), "u2"),
    **dict.fromkeys(("int", "int32"), "i4"),
    **dict.fromkeys(("uint", "uint32"), "u4"),
    **dict.fromkeys(("float", "float32"), "f4"),
    **dict.fromkeys(("int64", "long"), "i8"),
    **dict.fromkeys(("uint64", "ulong"), "u8"),
    **dict.fromkeys(("double", "float64"), "f8"),
}
ORDERS = {"binary_little_endian": "<", "binary_big_endian": ">", "ascii": "="}
LONGEST_HEADER, LONGEST_LINE = 1000, 4096
WRITE_TYPES = {"f8": "double", "f4": "float", "i4": "int"}


class PlySink:
    """Appends points, or other vertices of a ``layout``, binary little-endian, to an open file."""

    def __init__(
        self,
        file: BinaryIO,
        layout: "np.dtype[np.void]" = POINT,
        comment: str = "crenel cloud: mm, arm frame",
    ) -> None:
        self._file = file
        self._layout, self._comment = layout, comment
        self._points = 0
        file.write(self._header())

    def write(self, points: Points) -> None:
        self._file.write(np.ascontiguousarray(points).data)
        self._points += len(points)

    def finish(self) -> None:
        """Puts the final count into the header."""
        self._file.seek(0)
        self._file.write(self._header())

    def _header(self) -> bytes:
        """The header, of one length whatever the count: a comment takes up the slack."""
        digits, layout = str(self._points), self._layout
        lines = [
            "ply",
            "format binary_little_endian 1.0",
            f"comment {self._comment} " + "." * (COUNT_WIDTH - len(digits)),
            f"element vertex {digits}",
            *(f"property {WRITE_TYPES[layout[one].str[1:]]} {one}" for one in layout.names or ()),
            "end_header",
        ]
        return ("\n".join(lines) + "\n").encode()


def read_ply(path: Path, file: BinaryIO, columns: Sequence[str] | None = None) -> Cloud:
    """Reads a PLY's vertices; raises ``OperationError`` if malformed or cut off.

    Args:
        columns: the properties of x, y and z, if the user names them.
    """
    vertices = find_vertices(path, file)
    names = vertices.element.names
    axes = find_named_axes(path, names, columns)
    return cloud_of_axes(read_vertices(path, file, vertices), names, axes)


@dataclass(frozen=True)
class Vertices:
    """Where the vertices stand in a file."""

    order: str
    """The order of the bytes; ``=``: the file is text."""
    element: Element
    before: tuple[Element, ...]
    """Other elements between header and vertices."""

    @property
    def count(self) -> int:
        """The number of points."""
        return self.element.count

    def is_plain(self, layout: "np.dtype[np.void]") -> bool:
        """Whether the header is followed by binary rows of this layout and nothing else."""
        return (
            not (self.before or self.element.has_lists)
            and self.element.layout(self.order) == layout
        )


def find_vertices(path: Path, file: BinaryIO) -> Vertices:
    """Reads the header and leaves the file at its end; raises ``OperationError`` if malformed."""
    file.seek(0)
    words = [line.split() for line in _header_lines(path, file)]
    formats = [line[1] for line in words if line[:1] == ["format"] and len(line) > 1]
    if not formats or formats[0] not in ORDERS:
        raise format_error(path, message("cloud-no-ply-format"))
    before: list[Element] = []
    for element in _elements(path, words):
        if element.name == "vertex":
            return Vertices(ORDERS[formats[0]], element, tuple(before))
        if element.count:
            before.append(element)
    raise format_error(path, message("cloud-no-element-vertex"))


def read_vertices(path: Path, file: BinaryIO, vertices: Vertices) -> dict[str, Floats]:
    """The vertices' properties (N,) by name, without lists; the file stands at its header's end."""
    if vertices.order == "=":
        return read_text_element(path, file, vertices.before, vertices.element)
    return read_binary_element(path, file, vertices.before, vertices.element, vertices.order)


def _header_lines(path: Path, file: BinaryIO) -> list[str]:
    """Its lines, which end with LF, CR LF, or as the format was first described, CR."""
    lines: list[str] = []
    for _ in range(LONGEST_HEADER):
        line = _header_line(file)
        if not line:
            break
        lines.append(line.decode("latin-1").strip())
        if lines[-1] == "end_header":
            return lines
    raise format_error(path, message("cloud-header-does-not-end"))


def _header_line(file: BinaryIO) -> bytes:
    start = file.tell()
    line = file.readline(LONGEST_LINE)
    first, sign, rest = line.partition(b"\r")
    if sign and rest.strip(b"\r\n"):
        file.seek(start + len(first) + 1)
        return first + sign
    return line


def _elements(path: Path, words: list[list[str]]) -> list[Element]:
    """The elements with their properties, in the order of the file."""
    found: list[tuple[str, int, list[Property]]] = []
    for line in words:
        said = format_error(path, message("cloud-header-contains", line=repr(" ".join(line))))
        if line[:1] == ["element"]:
            if len(line) != 3 or not line[2].isdecimal():
                raise said
            found.append((line[1], int(line[2]), []))
        elif line[:1] == ["property"]:
            if not found or (one := _property(line[1:])) is None:
                raise said
            found[-1][2].append(one)
    return [
        Element(name, count, _distinct(path, name, properties)) for name, count, properties in found
    ]


def _property(words: list[str]) -> Property | None:
    """From its line; None if it is none."""
    if len(words) == 2 and words[0] in TYPES:
        return Property(words[1], TYPES[words[0]])
    if len(words) == 4 and words[0] == "list" and {*words[1:3]} <= set(TYPES):
        count_kind = TYPES[words[1]]
        return Property(words[3], TYPES[words[2]], count_kind) if count_kind[0] != "f" else None
    return None


def _distinct(path: Path, element: str, properties: list[Property]) -> tuple[Property, ...]:
    """With a number behind names that repeat others; raises ``OperationError`` for coordinates."""
    names = [one.name for one in properties]
    if any(names.count(axis) > 1 for axis in "xyz"):
        raise format_error(path, message("cloud-element-repeats-property", name=element))
    return tuple(
        replace(one, name=name) for one, name in zip(properties, distinct_names(names), strict=True)
    )
