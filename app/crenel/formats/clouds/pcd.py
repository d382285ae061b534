"""PCD, the Point Cloud Library's format: written as binary; read as binary, compressed, ascii.

Coordinates are floats, since the library's own readers take nothing else for x, y, z.
"""

import struct
from collections.abc import Sequence
from pathlib import Path
from typing import BinaryIO

import numpy as np

from crenel.errors import OperationError
from crenel.formats.clouds.axis_names import cloud_of_axes, find_named_axes
from crenel.formats.clouds.points import Cloud, Points
from crenel.formats.clouds.rows import (
    COUNT_WIDTH,
    as_doubles,
    distinct_names,
    format_error,
    out_of_range_error,
    read_binary_rows,
    read_text_rows,
    text_lines,
    truncation_error,
)
from crenel.formats.file_names import display_path
from crenel.messages.message import message, quantity
from crenel.metrology.transforms import Floats
from crenel.native.arguments import U8, Array, Function
from crenel.native.library import CRENEL

RECORD = np.dtype(
    [
        ("x", "<f4"),
        ("y", "<f4"),
        ("z", "<f4"),
        ("intensity", "<f4"),
        ("uncertainty_um", "<f4"),
        ("frame", "<i4"),
    ]
)
FARTHEST_MM = 2.0**14
"""A float's step is below 1 µm up to here."""
LONGEST_HEADER = 100
FIRST_WORDS = ("VERSION", "FIELDS", "COLUMNS")
FILLER = "_"
"""The name of a field that only fills up the row."""
KINDS = {"F": "f", "I": "i", "U": "u"}
MOST_EXPANDED = 88
"""Bytes that a byte of compressed data can stand for: three stand for 264."""

_expand_lzf = Function(
    CRENEL, "expand_lzf", Array(U8, "size"), Array(U8, "wanted", written=True), returns=int
)


class PcdSink:
    """Appends points to an open file."""

    def __init__(self, path: Path, file: BinaryIO) -> None:
        self._path = path
        self._file = file
        self._points = 0
        file.write(_header(0))

    def write(self, points: Points) -> None:
        for axis in "xyz":
            farthest = float(np.abs(points[axis]).max(initial=0.0))
            if farthest > FARTHEST_MM:
                why = message("cloud-pcd-rounds-beyond", limit=quantity(FARTHEST_MM, "mm"))
                raise out_of_range_error(self._path, axis, farthest, why)
        self._file.write(points.astype(RECORD).tobytes())
        self._points += len(points)

    def finish(self) -> None:
        """Puts the final count into the header."""
        self._file.seek(0)
        self._file.write(_header(self._points))


def is_pcd(head: bytes) -> bool:
    """Whether a file begins like a PCD: with its mark in a comment, or a line of its header."""
    for line in head.decode("latin-1").splitlines():
        words = line.upper().split()
        if line.startswith("#") and ".PCD" in words:
            return True
        if words and not line.startswith("#"):
            return words[0] in FIRST_WORDS and len(words) > 1
    return False


def read_pcd(path: Path, file: BinaryIO, columns: Sequence[str] | None = None) -> Cloud:
    """Reads a PCD from its start; raises ``OperationError`` if malformed or cut off.

    Args:
        columns: the fields of x, y and z, if the user names them.
    """
    fields = _header_fields(path, file)
    names = distinct_names(fields.get("FIELDS", fields.get("COLUMNS", [])))
    counts = fields.get("COUNT", ["1"] * len(names))
    try:
        if not {"TYPE", "SIZE"} & set(fields):  # as before version .6
            fields |= {"TYPE": ["F"] * len(names), "SIZE": ["4"] * len(names)}
        kinds = [
            KINDS[kind.upper()] + str(int(size))
            for kind, size in zip(fields["TYPE"], fields["SIZE"], strict=True)
        ]
        layout = np.dtype(
            [
                (name, "<" + kind, (int(count),))
                for name, kind, count in zip(names, kinds, counts, strict=True)
                if int(count) != 0  # such a field takes no bytes
            ]
        )
        count = _point_count(fields)
        data = fields["DATA"][0].lower()
    except (KeyError, ValueError, TypeError, IndexError) as error:
        raise format_error(path, message("cloud-header-is-invalid", reason=str(error))) from error
    names = list(layout.names or ())
    axes = find_named_axes(path, names, columns)
    readers = {
        "binary": _read_binary,
        "ascii": _read_ascii,
        "binary_compressed": _read_compressed,
    }
    if data in readers:
        return cloud_of_axes(readers[data](path, file, layout, count), names, axes)
    raise OperationError(
        "cloud-compressed",
        display_path(path),
        message("cloud-data-of-unknown-kind", kind=data),
        message("cloud-export-binary-pcd"),
    )


def _point_count(fields: dict[str, list[str]]) -> int:
    """By the line POINTS, which old files lack, or by width and height."""
    if "POINTS" in fields:
        return int(fields["POINTS"][0])
    return int(fields["WIDTH"][0]) * int(fields["HEIGHT"][0])


def _read_binary(
    path: Path, file: BinaryIO, layout: np.dtype[np.void], count: int
) -> dict[str, Floats]:
    table = read_binary_rows(path, file, file.tell(), layout, count)
    return {name: as_doubles(table[name][:, 0]) for name in layout.names or ()}


def _read_compressed(
    path: Path, file: BinaryIO, layout: np.dtype[np.void], count: int
) -> dict[str, Floats]:
    """Field after field, each of all points, as PCL compresses them."""
    sizes = file.read(8)
    if len(sizes) < 8:
        raise truncation_error(path, 0, count)
    size, wanted = struct.unpack("<II", sizes)
    kept = [name for name in layout.names or () if name.split("#")[0] != FILLER]
    if FILLER in (layout.names or ()) and wanted == count * sum(layout[n].itemsize for n in kept):
        layout = np.dtype([(name, layout[name]) for name in kept])  # as PCL's own reader has it
    if wanted != count * layout.itemsize or wanted > MOST_EXPANDED * size:
        raise format_error(
            path, message("cloud-bytes-do-not-match-points", bytes=wanted, points=count)
        )
    packed = np.frombuffer(file.read(size), np.uint8)
    if len(packed) < size:
        raise truncation_error(path, count * len(packed) // max(size, 1), count)
    expanded = np.empty(wanted, np.uint8)
    if not _expand_lzf(packed, expanded):
        raise format_error(path, message("cloud-cannot-be-expanded"))
    columns, at = {}, 0
    for name in layout.names or ():
        kind = layout[name]
        end = at + count * kind.itemsize
        field = expanded[at:end].view(kind.base).reshape(count, *kind.shape)
        columns[name], at = as_doubles(field[:, 0]), end
    return columns


def _read_ascii(
    path: Path, file: BinaryIO, layout: np.dtype[np.void], count: int
) -> dict[str, Floats]:
    names = layout.names or ()
    widths = [layout[name].shape[0] for name in names]
    table = read_text_rows(path, text_lines(file), sum(widths), count)
    firsts = np.cumsum([0, *widths])
    return {name: table[:, firsts[i]] for i, name in enumerate(names)}


def _header_fields(path: Path, file: BinaryIO) -> dict[str, list[str]]:
    """Each line's words by its first; the file is left behind the line DATA."""
    file.seek(0)
    fields: dict[str, list[str]] = {}
    for _ in range(LONGEST_HEADER):
        line = file.readline(4096)
        words = line.decode("latin-1").split()
        if words and not words[0].startswith("#"):
            fields[words[0].upper()] = words[1:]
        if not line or "DATA" in fields:
            break
    if not fields.get("DATA"):
        raise format_error(path, message("cloud-header-does-not-end"))
    return fields


def _header(count: int) -> bytes:
    """The header, of one length whatever the count: a comment takes up the slack."""
    digits = str(count)
    names = RECORD.names or ()
    kinds = [RECORD[name] for name in names]
    lines = [
        "# .PCD v0.7 - crenel cloud: mm, arm frame " + "." * 2 * (COUNT_WIDTH - len(digits)),
        "VERSION 0.7",
        f"FIELDS {' '.join(names)}",
        f"SIZE {' '.join(str(kind.itemsize) for kind in kinds)}",
        f"TYPE {' '.join(kind.kind.upper() for kind in kinds)}",
        f"COUNT {' '.join('1' for _ in names)}",
        f"WIDTH {digits}",
        "HEIGHT 1",
        "VIEWPOINT 0 0 0 1 0 0 0",
        f"POINTS {digits}",
        "DATA binary",
    ]
    return ("\n".join(lines) + "\n").encode()
