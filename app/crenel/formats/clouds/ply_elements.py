"""The elements of a PLY: rows of numbers, among which there may be lists of any length."""

import struct
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from crenel.formats.clouds.rows import (
    as_doubles,
    format_error,
    read_binary_rows,
    read_text_rows,
    text_lines,
    truncation_error,
)
from crenel.messages.message import message
from crenel.metrology.transforms import Floats


@dataclass(frozen=True)
class Property:
    """One property of an element."""

    name: str
    kind: str
    """The kind of its number, or of each number of its list, as numpy has it."""
    count_kind: str | None = None
    """The kind of the number that states the length of its list; None: it is no list."""


@dataclass(frozen=True)
class Element:
    """So many rows of the same properties."""

    name: str
    count: int
    properties: tuple[Property, ...]

    @property
    def has_lists(self) -> bool:
        """Whether its rows may differ in length."""
        return any(one.count_kind is not None for one in self.properties)

    @property
    def names(self) -> tuple[str, ...]:
        """The names of its properties that are no lists."""
        return tuple(one.name for one in self.properties if one.count_kind is None)

    def layout(self, order: str) -> "np.dtype[np.void]":
        """The layout of a row without its lists, in the byte order ``<`` or ``>``."""
        plain = [(one.name, order + one.kind) for one in self.properties if one.count_kind is None]
        return np.dtype(plain)


def read_binary_element(
    path: Path, file: BinaryIO, before: Sequence[Element], element: Element, order: str
) -> dict[str, Floats]:
    """The numbers (N,) of an element by name; the file stands at the end of its header.

    Raises:
        OperationError: cut off, or a list of a length below zero.
    """
    start = file.tell()
    if not (element.has_lists or any(one.has_lists for one in before)):
        start += sum(one.count * one.layout(order).itemsize for one in before)
        table = read_binary_rows(path, file, start, element.layout(order), element.count)
        return {name: as_doubles(table[name]) for name in element.names}
    data, at = file.read(), 0
    for one in before:
        at = int(_find_numbers(path, data, at, one, order)[-1, 0])
    starts = _find_numbers(path, data, at, element, order)[:-1]
    content = np.frombuffer(data, np.uint8)
    columns = {}
    plain = [one for one in element.properties if one.count_kind is None]
    for i, number in enumerate(plain):
        kind = np.dtype(order + number.kind)
        gathered = content[starts[:, i, None] + np.arange(kind.itemsize)]
        columns[number.name] = as_doubles(gathered.view(kind)[:, 0])
    return columns


def read_text_element(
    path: Path, file: BinaryIO, before: Sequence[Element], element: Element
) -> dict[str, Floats]:
    """As ``read_binary_element``, of a file in text, with one row a line."""
    rows = text_lines(file)
    for _ in islice(rows, sum(one.count for one in before)):
        pass
    if not element.has_lists:
        table = read_text_rows(path, rows, len(element.names), element.count)
        return {name: table[:, i] for i, name in enumerate(element.names)}
    lines = list(islice(rows, element.count))
    if len(lines) < element.count:
        raise truncation_error(path, len(lines), element.count)
    table = np.array([_leave_out_lists(path, line, element) for line in lines])
    table = table.reshape(len(lines), len(element.names))
    return {name: table[:, i] for i, name in enumerate(element.names)}


def _find_numbers(
    path: Path, data: bytes, at: int, element: Element, order: str
) -> NDArray[np.int64]:
    """(N + 1, numbers) positions in the data of the numbers of all rows, and of a row after them.

    The first column of the last row is where the element ends.
    """
    steps: list[tuple[struct.Struct | None, int]] = []
    for one in element.properties:
        counter = None if one.count_kind is None else struct.Struct(_struct(order, one.count_kind))
        steps.append((counter, np.dtype(one.kind).itemsize))
    shortest = sum(size if counter is None else counter.size for counter, size in steps)
    if at + element.count * shortest > len(data):
        raise truncation_error(path, (len(data) - at) // max(shortest, 1), element.count)
    width = max(len(element.names), 1)
    found = np.empty((element.count + 1, width), np.int64)
    for row in range(element.count):
        places = []
        for counter, size in steps:
            if counter is None:
                places.append(at)
                at += size
                continue
            if at + counter.size > len(data):
                raise truncation_error(path, row, element.count)
            (length,) = counter.unpack_from(data, at)
            if length < 0:
                raise format_error(path, message("cloud-list-below-zero", row=row + 1))
            at += counter.size + length * size
        if at > len(data):
            raise truncation_error(path, row, element.count)
        if places:
            found[row] = places
    found[-1] = at
    return found


def _struct(order: str, kind: str) -> str:
    return order + np.dtype(kind).char


def _leave_out_lists(path: Path, line: bytes, element: Element) -> list[float]:
    """The numbers of a row in text that are in no list."""
    words, at, row = line.split(), 0, []
    try:
        for one in element.properties:
            if one.count_kind is None:
                row.append(float(words[at]))
                at += 1
            else:
                at += 1 + int(words[at])
    except (ValueError, IndexError) as error:
        said = repr(line.decode("latin-1").strip()[:60])
        raise format_error(path, message("cloud-row-is-not-complete", line=said)) from error
    return row
