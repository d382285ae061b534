"""COPC (cloud optimised point cloud 1.0): LAZ as an octree, of which a viewer reads what it shows.

The points are packed as in ``las.py``; copclib compresses and writes the nodes. The bounds of all
points must be known before the first node, and a node's points come from the whole scan. So the
points wait in a temporary file beside the cloud, are sorted there in runs that fit into memory, and
each node collects its points from all runs.
"""

from collections.abc import Iterator
from itertools import product
from pathlib import Path
from tempfile import TemporaryDirectory, TemporaryFile
from typing import Any

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.formats.clouds.las.layout import STEP_MM, LasLayout
from crenel.formats.clouds.optional_library import call_library, load_library
from crenel.formats.clouds.points import Points
from crenel.messages.message import message

POINT_FORMAT = 6
RUN_POINTS = 1 << 20
NODE_POINTS = 60_000
"""The points of a node: about the mean number."""
DEEPEST = 12
BRANCHES = 4
"""Nodes of a level for one of the level above, of a surface."""
GOLDEN = 0.5 * (5.0**0.5 - 1.0)
CELLS = 128
"""Points of a node along an edge, by which viewers estimate its density."""
COORDINATE_BITS = 16

Key = tuple[int, int, int, int]
"""Level, and place along X, Y and Z."""
Nodes = dict[int, list[slice]]
"""Where the points of each node are."""


class CopcSink:
    """Appends points to a cloud whose file is written at the end.

    Args:
        path: of the cloud, for messages.
        part: of the file, which the library opens itself.
    """

    def __init__(self, path: Path, part: Path) -> None:
        self._copclib = load_library(path, "copclib", "copc")
        self._layout = LasLayout(path)
        self._path, self._part = path, part
        self._waiting = TemporaryFile(dir=part.parent)  # noqa: SIM115 - closed at the end
        self._count = 0
        self._low = np.full(3, np.iinfo(np.int64).max)
        self._high = np.full(3, np.iinfo(np.int64).min)

    def write(self, points: Points) -> None:
        """Appends points; raises ``OperationError`` if the format cannot hold them."""
        if not len(points):
            return
        records = self._layout.pack(points)
        steps = _steps(records)
        self._low = np.minimum(self._low, steps.min(axis=0))
        self._high = np.maximum(self._high, steps.max(axis=0))
        self._waiting.write(records.tobytes())
        self._count += len(points)

    def finish(self) -> None:
        """Sorts the points, and writes all nodes."""
        self._waiting.flush()
        writer = self._open_writer()
        if self._count:
            for key, content in self._nodes():
                self._add_node(writer, key, content)
        call_library(self._path, "RuntimeError", writer.Close)
        self._check_size()
        self.abandon()

    def abandon(self) -> None:
        """Removes the points that wait; idempotent."""
        self._waiting.close()

    def _open_writer(self) -> Any:
        vector = self._copclib.Vector3
        with TemporaryDirectory(dir=self._part.parent, prefix=".copc-") as folder:
            # the library describes extra dimensions only as it has read them
            example = Path(folder) / "example.laz"
            self._layout.write_example(example)
            extra = self._copclib.LazReader(str(example)).laz_config.extra_bytes_vlr
        scale, offset = vector([STEP_MM] * 3), vector([0.0] * 3)
        config = self._copclib.CopcConfigWriter(POINT_FORMAT, scale, offset, "", extra)
        header, info = config.las_header, config.copc_info
        header.system_identifier, header.generating_software = self._layout.identifiers
        low, high = (self._low, self._high) if self._count else (np.zeros(3), np.zeros(3))
        header.min, header.max = vector(list(STEP_MM * low)), vector(list(STEP_MM * high))
        half_mm = 0.5 * STEP_MM * self._edge
        info.center_x, info.center_y, info.center_z = STEP_MM * low + half_mm
        info.halfsize, info.spacing = half_mm, 2.0 * half_mm / CELLS
        return self._copclib.FileWriter(str(self._part), config)

    def _add_node(self, writer: Any, key: Key, content: bytes) -> None:
        node = self._copclib.VoxelKey(*key)
        packed = self._copclib.VectorChar(np.frombuffer(content, np.int8))
        call_library(self._path, "RuntimeError", lambda: writer.AddNode(node, packed))

    @property
    def _edge(self) -> int:
        """The edge of the cube about all points, in steps; no point lies on its far sides."""
        return int((self._high - self._low).max()) + 1 if self._count else 1

    def _nodes(self) -> Iterator[tuple[Key, bytes]]:
        """All nodes with their points as they are packed, parents first."""
        size = (self._count,)
        points = np.memmap(self._waiting, self._layout.dtype, "r+", shape=size)
        nodes: Nodes = {}
        for first in range(0, self._count, RUN_POINTS):
            for key, place in self._sort_run(points, first):
                nodes.setdefault(key, []).append(place)
        _fill_parents(nodes)
        for key, places in sorted(nodes.items()):
            yield _place_of(key), b"".join(points[place].tobytes() for place in places)

    def _sort_run(self, points: NDArray[np.void], first: int) -> Iterator[tuple[int, slice]]:
        """Sorts the points of a run by their nodes; each node, and where its points are."""
        unsorted = np.array(points[first : first + RUN_POINTS])
        numbers = np.arange(first, first + len(unsorted))
        levels = _levels(numbers, self._count)
        keys = _node_keys(_steps(unsorted) - self._low, levels, self._edge)
        order = np.argsort(keys, kind="stable")
        points[first : first + len(unsorted)] = unsorted[order]
        names, begins = np.unique(keys[order], return_index=True)
        bounds = first + np.append(begins, len(unsorted))
        for name, begin, end in zip(
            names.tolist(), bounds.tolist(), bounds[1:].tolist(), strict=False
        ):
            yield name, slice(begin, end)

    def _check_size(self) -> None:
        """The library does not notice a disk that is full."""
        found = self._layout.count_points(self._part)
        if found != self._count:
            raise OperationError(
                "cloud-not-written",
                str(self._path),
                message("cloud-disk-took-points", found=found, count=self._count),
                message("cloud-choose-another-location"),
            )


def _steps(records: NDArray[np.void]) -> NDArray[np.int64]:
    """(N, 3) coordinates of packed points, in steps."""
    return np.column_stack([records[axis].astype(np.int64) for axis in "XYZ"])


def _levels(numbers: NDArray[np.int64], count: int) -> NDArray[np.int64]:
    """The level of each point, by its number: of every stretch of a stripe, a share for each level.

    A level has about as many points for each of its nodes as the others; the multiples of the
    golden ratio choose them evenly.
    """
    sizes = BRANCHES ** np.arange(DEEPEST + 1)
    totals = np.cumsum(sizes)
    depth = int(np.searchsorted(totals * NODE_POINTS, count).clip(0, DEEPEST))
    shares = totals[: depth + 1] / totals[depth]
    levels = np.searchsorted(shares, numbers * GOLDEN % 1.0, side="right")
    return np.minimum(levels, depth)


def _node_keys(steps: NDArray[np.int64], levels: NDArray[np.int64], edge: int) -> NDArray[np.int64]:
    """The node of each point as one number, which orders levels first.

    Args:
        steps: (N, 3) from the corner of the cube.
        edge: of the cube, in steps.
    """
    places = (steps << levels[:, None]) // edge
    keys = levels
    for axis in range(3):
        keys = (keys << COORDINATE_BITS) | places[:, axis]
    return keys


def _place_of(key: int) -> Key:
    mask = (1 << COORDINATE_BITS) - 1
    x, y, z = (key >> (COORDINATE_BITS * axis) & mask for axis in (2, 1, 0))
    return key >> (3 * COORDINATE_BITS), x, y, z


def _key_of(place: Key) -> int:
    key = 0
    for part in place:
        key = (key << COORDINATE_BITS) | part
    return key


def _fill_parents(nodes: Nodes) -> None:
    """Gives a point to each node above one that has points: readers come down through them."""
    for key in sorted(nodes, reverse=True):
        level, x, y, z = _place_of(key)
        while level > 0 and key in nodes:
            level, x, y, z = level - 1, x >> 1, y >> 1, z >> 1
            parent = _key_of((level, x, y, z))
            if parent in nodes:
                break
            nodes[parent] = [_take_point(nodes, key)]
            key = parent


def _take_point(nodes: Nodes, key: int) -> slice:
    """Takes a point out of a node, which gets one of a node below if it was the last."""
    first, *others = nodes[key]
    left = slice(first.start + 1, first.stop)
    rest = [left, *others] if left.start < left.stop else others
    level, x, y, z = _place_of(key)
    below = (
        _key_of((level + 1, 2 * x + dx, 2 * y + dy, 2 * z + dz))
        for dx, dy, dz in product((0, 1), repeat=3)
    )
    if rest:
        nodes[key] = rest
    elif (child := next((one for one in below if one in nodes), None)) is not None:
        nodes[key] = [_take_point(nodes, child)]
    else:
        del nodes[key]
    return slice(first.start, first.start + 1)
