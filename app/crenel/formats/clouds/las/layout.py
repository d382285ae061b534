"""LAS and LAZ (ASPRS LAS 1.4), through laspy and lazrs.

Coordinates are whole tenths of a µm, in mm as everywhere; ``frame`` and
``uncertainty_um`` are extra dimensions; intensity is rounded to whole grey levels.
"""

from pathlib import Path
from types import ModuleType
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from crenel.formats.clouds.optional_library import call_library, load_library
from crenel.formats.clouds.points import POINT, Points
from crenel.formats.clouds.rows import out_of_range_error
from crenel.formats.open_file import open_file
from crenel.messages.message import message, quantity

STEP_MM = 1e-4
FARTHEST_MM = STEP_MM * (2**31 - 1)


class LasLayout:
    """How points are packed: header, record and extra dimensions.

    Raises:
        OperationError: laspy is not installed.
    """

    identifiers = "arm frame, mm", "crenel"
    """The identifiers of the system and the software."""

    def __init__(self, path: Path) -> None:
        self._path, self._laspy = path, load_laspy(path)
        header = self._laspy.LasHeader(point_format=6, version="1.4")
        header.scales, header.offsets = np.full(3, STEP_MM), np.zeros(3)
        header.system_identifier, header.generating_software = self.identifiers
        header.add_extra_dims(
            [
                self._laspy.ExtraBytesParams("frame", np.uint32, "number in the recording"),
                self._laspy.ExtraBytesParams("uncertainty_um", np.float32, "k = 1, of the stripe"),
            ]
        )
        self._header = header

    @property
    def dtype(self) -> "np.dtype[np.void]":
        """The type of a packed point."""
        found: np.dtype[np.void] = self._header.point_format.dtype()
        return found

    def record(self, points: Points) -> Any:
        """Points as laspy writes them; raises ``OperationError`` for one that is too far away."""
        record = self._laspy.ScaleAwarePointRecord.zeros(len(points), header=self._header)
        for axis, name in zip("xyz", "XYZ", strict=True):
            farthest = float(np.abs(points[axis]).max(initial=0.0))
            if not farthest <= FARTHEST_MM:
                why = message("cloud-las-counts-up-to", limit=quantity(FARTHEST_MM, "mm"))
                raise out_of_range_error(self._path, axis, farthest, why)
            record[name] = np.rint(points[axis] / STEP_MM).astype(np.int32)
        record["intensity"] = np.rint(points["intensity"]).clip(0, 65535).astype(np.uint16)
        record["frame"] = points["frame"].astype(np.uint32)
        record["uncertainty_um"] = points["uncertainty_um"]
        return record

    def pack(self, points: Points) -> NDArray[np.void]:
        """Points (N,) of ``dtype``; raises ``OperationError`` as ``record``."""
        packed: NDArray[np.void] = self.record(points).array
        return packed

    def open_writer(self, file: BinaryIO, compressed: bool) -> Any:
        """A writer of laspy to an open file."""
        return self._laspy.open(
            file,
            mode="w",
            header=self._header,
            closefd=False,
            do_compress=compressed,
            laz_backend=self._laspy.LazBackend.LazrsParallel if compressed else None,
        )

    def write_example(self, path: Path) -> None:
        """A compressed file of one point, which other readers of these point formats accept."""
        self._header.global_encoding.wkt = True
        with open(path, "xb") as file, self.open_writer(file, True) as writer:
            writer.write_points(self.record(np.zeros(1, POINT)))

    def count_points(self, path: Path) -> int:
        """How many points a file has by its header; 0 if that is not whole."""
        try:
            with open_file(path) as file, self._laspy.open(file, closefd=False) as reader:
                return int(reader.header.point_count)
        except OSError:
            raise
        except Exception:  # both libraries and the Rust behind them raise their own
            return 0


class LasSink:
    """Appends points to an open file, compressed (LAZ) or not."""

    def __init__(self, path: Path, file: BinaryIO) -> None:
        self._path, self._layout = path, LasLayout(path)
        self._writer = self._layout.open_writer(file, path.suffix.lower() == ".laz")

    def write(self, points: Points) -> None:
        record = self._layout.record(points)
        call_library(self._path, "LazrsError", lambda: self._writer.write_points(record))

    def finish(self) -> None:
        """Completes the compressed data and the header."""
        call_library(self._path, "LazrsError", self._writer.close)


def load_laspy(path: Path) -> ModuleType:
    """The library; raises ``OperationError`` where it or its compression is not installed."""
    load_library(path, "lazrs")
    return load_library(path, "laspy")
