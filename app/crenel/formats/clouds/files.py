"""Clouds: written in chunks and read, in the format given by the file's name."""

import codecs
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.formats.atomic_write import atomic_file, atomic_path
from crenel.formats.clouds.e57 import E57Sink, read_e57
from crenel.formats.clouds.foreign.arrays import is_array, read_arrays
from crenel.formats.clouds.foreign.meshes import (
    is_obj,
    is_off,
    is_stl,
    read_obj,
    read_off,
    read_stl,
)
from crenel.formats.clouds.foreign.other_files import refuse_other_files
from crenel.formats.clouds.foreign.ptx import is_ptx, read_ptx
from crenel.formats.clouds.las.copc import CopcSink
from crenel.formats.clouds.las.layout import LasSink
from crenel.formats.clouds.las.reader import read_las
from crenel.formats.clouds.pcd import PcdSink, is_pcd, read_pcd
from crenel.formats.clouds.ply import PlySink, read_ply
from crenel.formats.clouds.points import (
    POINT,
    Cloud,
    Points,
    PointSink,
    leave_out_unmeasured,
    pack_points,
    scale_cloud,
)
from crenel.formats.clouds.xyz import XyzSink, read_xyz
from crenel.formats.file_names import display_path
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.open_file import open_file
from crenel.messages.message import Text, message, rounded
from crenel.metrology.transforms import Floats

SUFFIXES = (".ply", ".pcd", ".e57", ".xyz", ".las", ".laz")
COPC = ".copc.laz"
"""End of the name of a LAZ that has an octree."""
FORMS = (*(suffix.lstrip(".") for suffix in SUFFIXES), COPC.lstrip("."))
"""The forms of clouds by their names: what stands behind the first point."""
LAS = ("laspy", "lazrs")
LIBRARIES = {"e57": ("pye57",), "las": LAS, "laz": LAS, "copc.laz": (*LAS, "copclib")}
HEAD_BYTES = 1 << 16
"""By which the format of a file is found."""
CHUNK_POINTS = 1 << 16
"""Minimum number of points passed to a format at a time."""
FARTHEST_MM = 1e7
"""An arm measures no points further away than this."""

__all__ = ["POINT", "SUFFIXES", "Cloud", "CloudWriter", "cloud_writer", "pack_points", "read_cloud"]


class CloudWriter:
    """Appends points to an open cloud; see ``cloud_writer``."""

    def __init__(self, sink: PointSink) -> None:
        self._sink = sink
        self._waiting: list[Points] = []
        self._waiting_count = 0
        self.points = 0

    def write(
        self,
        points_mm: Floats,
        intensity: Floats,
        uncertainty_um: Floats,
        frame: int | Floats | NDArray[np.int64],
    ) -> None:
        """Appends points (N, 3); rows with NaN are left out.

        Args:
            intensity: (N,) of the stripe.
            uncertainty_um: (N,) k = 1, see ``metrology.reconstruct``.
            frame: frame number, one for all points or (N,).
        """
        self.append(pack_points(points_mm, intensity, uncertainty_um, frame))

    def append(self, points: Points) -> None:
        """Appends finite points (N,) of ``POINT``."""
        if not len(points):
            return
        self.points += len(points)
        self._waiting.append(points)
        self._waiting_count += len(points)
        if self._waiting_count >= CHUNK_POINTS:
            self._write_pending()

    def finish(self) -> None:
        """Completes the file."""
        if self._waiting:
            self._write_pending()
        self._sink.finish()

    def _write_pending(self) -> None:
        one = self._waiting[0] if len(self._waiting) == 1 else np.concatenate(self._waiting)
        self._waiting, self._waiting_count = [], 0
        self._sink.write(one)


@contextmanager
def cloud_writer(path: Path) -> Iterator[CloudWriter]:
    """A cloud to which points are appended; the file appears when it is complete.

    Only some chunks are in memory at a time, whatever the size of the cloud.

    Raises:
        OperationError: its suffix is none of ``SUFFIXES``, the format's library is not
            installed, the format cannot hold a point, or the file cannot be written.
    """
    suffix = check_suffix(path)
    is_octree = path.name.lower().endswith(COPC)
    if suffix == ".e57" or is_octree:
        with atomic_path(path) as part:
            sink = CopcSink(path, part) if is_octree else E57Sink(path, part)
            try:
                writer = CloudWriter(sink)
                yield writer
                writer.finish()
            except BaseException:
                sink.abandon()
                raise
        return
    with atomic_file(path) as file:
        if suffix == ".ply":
            writer = CloudWriter(PlySink(file))
        elif suffix == ".pcd":
            writer = CloudWriter(PcdSink(path, file))
        elif suffix == ".xyz":
            writer = CloudWriter(XyzSink(path, file))
        else:
            writer = CloudWriter(LasSink(path, file))
        yield writer
        writer.finish()


def check_suffix(path: Path) -> str:
    """The format given by the name of a cloud; raises ``OperationError`` for an unknown one."""
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES:
        raise OperationError(
            "cloud-format",
            display_path(path),
            message("cloud-formats", suffixes=", ".join(SUFFIXES)),
            message("cloud-name-proposal", name=path.with_suffix(".ply").name),
        )
    return suffix


def read_cloud(
    path: Path, columns: Sequence[str] | None = None, mm_per_unit: float | None = None
) -> Cloud:
    """Reads a cloud, whatever its name: every format that is written, and those in ``foreign``.

    Points that are none, such as deleted or repeated ones, are left out and counted.

    Args:
        columns: names (or in text, numbers from 1) of the columns of x, y and z; by default,
            they are found by their names.
        mm_per_unit: of the numbers in the file; by default as the file states it, or the standard
            of its format, else mm.

    Raises:
        OperationError: missing, cut off, malformed, or without points; or the library of the format
            is not installed.
    """
    with convert_io_errors(path), open_file(path) as file:
        found = _read_points(path, file, columns)
    cloud = leave_out_unmeasured(found if mm_per_unit is None else scale_cloud(found, mm_per_unit))
    if not len(cloud.points_mm):
        left_out = cloud.left_out.deleted + cloud.left_out.missing
        why = message("cloud-points-none-measured", points=left_out)
        raise OperationError(
            "cloud-empty",
            display_path(path),
            why if left_out else message("cloud-has-no-points"),
            message("scan-gauge-again"),
        )
    largest = float(
        np.max(np.abs(cloud.points_mm), initial=0.0, where=np.isfinite(cloud.points_mm))
    )
    if largest > FARTHEST_MM:
        raise OperationError(
            "cloud-too-far",
            message("has-coordinate", path=display_path(path), coordinate=f"{largest:.3g} mm"),
            message("arm-measures-within", farthest=rounded(FARTHEST_MM / 1000, "m")),
            message("give-cloud-millimetres"),
        )
    return cloud


def _read_points(path: Path, file: BinaryIO, columns: Sequence[str] | None) -> Cloud:
    """All points of a file, in the format by its first bytes."""
    size = file.seek(0, 2)
    file.seek(0)
    head = file.read(HEAD_BYTES)
    if head.removeprefix(codecs.BOM_UTF8)[:4].rstrip() == b"ply":
        return read_ply(path, file, columns)
    if is_array(head):
        return read_arrays(path, file, columns)
    if (read := _reader_of_fixed_columns(path, head, size)) is None:
        refuse_other_files(path, head)
        return (read_pcd if is_pcd(head) else read_xyz)(path, file, columns)
    if columns is not None:
        raise OperationError(
            "cloud-columns-fixed", display_path(path), message("cloud-columns-are-fixed-give-none")
        )
    return read(path, file)


def _reader_of_fixed_columns(
    path: Path, head: bytes, size: int
) -> Callable[[Path, BinaryIO], Cloud] | None:
    """The reader of a format that fixes where x, y and z are; None: the file is of none of them."""
    if head.startswith(b"ASTM-E57"):
        return lambda path, file: read_e57(path)
    if head.startswith(b"LASF"):
        return read_las
    if is_stl(head, size):
        return read_stl
    if is_off(head):
        return read_off
    if is_ptx(head):
        return read_ptx
    return read_obj if is_obj(path, head) else None


@dataclass(frozen=True)
class WritableFormat:
    """A format, by the end of a file's name."""

    form: str
    why_not: Text
    """What to install for it; empty: it can be written."""


def cloud_formats() -> list[WritableFormat]:
    """All formats, with what keeps this installation from writing them."""
    return [WritableFormat(form, _why_not(form)) for form in FORMS]


def _why_not(form: str) -> Text:
    if all(find_spec(name) is not None for name in LIBRARIES.get(form, ())):
        return ""
    extra = "copc" if form == "copc.laz" else "clouds"
    return message("cloud-install-package", command=f"pip install 'crenel[{extra}]'")
