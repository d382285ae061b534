"""E57 (ASTM E2807), through pye57's binding of libE57Format.

The standard uses metres. ``crenel:frame`` and ``crenel:uncertainty_um`` are an extension, which
other programs ignore.
"""

import uuid
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from crenel.errors import OperationError
from crenel.formats.clouds.optional_library import call_library, first_line, load_library
from crenel.formats.clouds.points import Cloud, Points, cloud_from_columns
from crenel.formats.clouds.rows import format_error
from crenel.formats.file_names import display_path
from crenel.messages.message import message
from crenel.metrology.transforms import Floats
from crenel.units import MM_PER_M

CHUNK_POINTS = 1 << 17
EXTENSION, URI = "crenel", "urn:crenel:e57:1"
AXES = {"cartesianX": "x", "cartesianY": "y", "cartesianZ": "z"}
OPTIONAL_FIELDS = {
    "intensity": "intensity",
    f"{EXTENSION}:frame": "frame",
    f"{EXTENSION}:uncertainty_um": "uncertainty_um",
}
FIELDS = AXES | OPTIONAL_FIELDS
KINDS = {"frame": np.longlong, "x": np.float64, "y": np.float64, "z": np.float64}
"""Types of the library's buffers, which treats a C long as 32 bits; the others are single."""
INVALID = "cartesianInvalidState"
LIMITS = {
    **{field: ("cartesianBounds", f"{field}Minimum", f"{field}Maximum") for field in "xyz"},
    "intensity": ("intensityLimits", "intensityMinimum", "intensityMaximum"),
}


class E57Sink:
    """Appends points to a new file, which the library opens itself."""

    def __init__(self, path: Path, part: Path) -> None:
        pye57 = load_library(path, "pye57")
        self._path = path
        self._e57 = pye57.libe57
        self._file = _call_e57(path, lambda: pye57.E57(str(part), mode="w"))
        self._image = self._file.image_file
        self._image.extensionsAdd(EXTENSION, URI)
        self._arrays = {
            name: np.zeros(CHUNK_POINTS, KINDS.get(field, np.float32))
            for name, field in FIELDS.items()
        }
        self._limits = dict.fromkeys(LIMITS, (np.inf, -np.inf))
        self._scan = self._e57.StructureNode(self._image)
        self._writer = self._open_writer()

    def write(self, points: Points) -> None:
        for first in range(0, len(points), CHUNK_POINTS):
            piece = points[first : first + CHUNK_POINTS]
            for name, field in FIELDS.items():
                values = self._arrays[name][: len(piece)]
                values[:] = piece[field] / MM_PER_M if name in AXES else piece[field]
                if field in LIMITS:
                    low, high = self._limits[field]
                    self._limits[field] = (min(low, values.min()), max(high, values.max()))
            self._write(len(piece))

    def finish(self) -> None:
        """Completes the points, adds their bounds, and closes the file."""
        _call_e57(self._path, self._writer.close)
        boxes = {box: self._e57.StructureNode(self._image) for box, _, _ in LIMITS.values()}
        if np.isfinite(self._limits["x"][0]):
            for field, (box, low, high) in LIMITS.items():
                for name, value in zip((low, high), self._limits[field], strict=True):
                    boxes[box].set(name, self._e57.FloatNode(self._image, float(value)))
            for name, node in boxes.items():
                self._scan.set(name, node)
        _call_e57(self._path, self._file.close)

    def abandon(self) -> None:
        """Closes the file without completing it."""
        self._image.cancel()

    def _open_writer(self) -> Any:  # the binding has no types
        e57, image = self._e57, self._image
        self._scan.set("guid", e57.StringNode(image, f"{{{uuid.uuid4()}}}"))
        self._scan.set("name", e57.StringNode(image, "crenel cloud, arm frame"))
        prototype, buffers = e57.StructureNode(image), e57.VectorSourceDestBuffer()
        for name, field in FIELDS.items():
            if field == "frame":
                node = e57.IntegerNode(image, 0, 0, 2**31 - 1)
            elif field in AXES.values():
                node = e57.FloatNode(image, 0.0, e57.E57_DOUBLE, -1e300, 1e300)
            else:
                node = e57.FloatNode(image, 0.0, e57.E57_SINGLE, -3e38, 3e38)
            prototype.set(name, node)
            buffers.append(
                e57.SourceDestBuffer(image, name, self._arrays[name], CHUNK_POINTS, True, True)
            )
        points = e57.CompressedVectorNode(image, prototype, e57.VectorNode(image, True))
        self._scan.set("points", points)
        self._file.data3d.append(self._scan)
        return points.writer(buffers)

    def _write(self, count: int) -> None:
        _call_e57(self._path, lambda: self._writer.write(count))


def read_e57(path: Path) -> Cloud:
    """Reads the Cartesian points of all scans of an E57 file into one frame, using the poses of the
    scans.

    Raises:
        OperationError: malformed or cut off, or without Cartesian points.
    """
    pye57 = load_library(path, "pye57")
    try:
        with pye57.E57(str(path)) as file:
            scans = [_read_scan(path, pye57.libe57, file, i) for i in range(file.scan_count)]
    except pye57.libe57.E57Exception as error:
        raise format_error(
            path, message("cloud-not-complete-format", format="E57", reason=first_line(error))
        ) from error
    if not scans:
        return cloud_from_columns({axis: np.zeros(0) for axis in "xyz"})
    kept = set.intersection(*(set(scan.columns) for scan in scans))
    columns = {name: np.concatenate([scan.columns[name] for scan in scans]) for name in kept}
    cloud = cloud_from_columns(columns, sum(scan.invalid for scan in scans))
    return replace(cloud, mm_per_unit=MM_PER_M)


@dataclass(frozen=True)
class _Scan:
    columns: dict[str, Floats]
    """(N,) by name, mm, of the valid points."""
    invalid: int


def _read_scan(path: Path, e57: Any, file: Any, index: int) -> _Scan:
    header = file.get_header(index)
    present = [name for name in (*FIELDS, INVALID) if name in header.point_fields]
    if not set(AXES) <= set(present):
        raise OperationError(
            "cloud-not-cartesian",
            message("cloud-scan-number", path=display_path(path), number=index + 1),
            message("cloud-not-cartesian"),
            message("cloud-export-cartesian"),
        )
    buffers, arrays = e57.VectorSourceDestBuffer(), {}
    for name in present:
        arrays[name] = np.zeros(CHUNK_POINTS)
        buffers.append(
            e57.SourceDestBuffer(file.image_file, name, arrays[name], CHUNK_POINTS, True, True)
        )
    reader = header.points.reader(buffers)
    pieces = [np.zeros((0, len(present)))]
    while count := reader.read():
        pieces.append(np.column_stack([arrays[name][:count] for name in present]))
    reader.close()
    columns = dict(zip(present, np.concatenate(pieces).T, strict=True))
    valid = columns.pop(INVALID, np.zeros(len(columns["cartesianX"]))) == 0
    kept = {FIELDS[name]: column[valid] for name, column in columns.items()}
    xyz = np.column_stack([kept[axis] for axis in "xyz"])
    if header.has_pose():
        xyz = file.to_global(xyz, header.rotation, header.translation)
    in_frame = {axis: xyz[:, i] * MM_PER_M for i, axis in enumerate("xyz")}
    return _Scan(kept | in_frame, int((~valid).sum()))


def _call_e57(path: Path, work: Callable[[], Any]) -> Any:
    """Runs a library function on the file; its failure becomes an ``OperationError``."""
    return call_library(path, "E57Exception", work)
