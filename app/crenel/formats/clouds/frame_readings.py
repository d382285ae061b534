"""``readings.ply`` beside a scan's ``cloud.ply``: where sensor and arm were at each frame.

With it, and with the calibration, the errors of each point are known without its recording.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.formats.atomic_write import atomic_file
from crenel.formats.clouds.ply import PlySink, find_vertices
from crenel.formats.file_names import display_path
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.open_file import open_file
from crenel.messages.message import message
from crenel.metrology.transforms import Floats

READINGS = "readings.ply"
COMMENT = "crenel readings: mm, arm frame"
FIXED = [("x", "<f8"), ("y", "<f8"), ("z", "<f8"), ("frame", "<i4"), ("sensor", "<i4")]


@dataclass(frozen=True)
class FrameReadings:
    """The readings of the arm at F frames, by ascending number."""

    frame: NDArray[np.int64]
    """(F,) number of each in the scan, as the points of the cloud have it."""
    sensor: NDArray[np.int64]
    """(F,) number of its sensor, in the order of their names."""
    readings: Floats
    """(F, k) as the arm states them: angles in rad, or numbers of a pose."""

    def rows_of(self, frames: NDArray[np.int64]) -> NDArray[np.int64]:
        """(K,) rows of frames (K,) by their numbers; -1 of those that are not there."""
        if not len(self.frame):
            return np.full(len(frames), -1)
        at = np.minimum(np.searchsorted(self.frame, frames), len(self.frame) - 1)
        return np.where(self.frame[at] == frames, at, -1)


class ReadingsWriter:
    """Appends frames to an open file; see ``readings_writer``."""

    def __init__(self, file: BinaryIO, size: int) -> None:
        self._layout = np.dtype([*FIXED, *((f"reading{k}", "<f8") for k in range(1, size + 1))])
        self._sink = PlySink(file, self._layout, COMMENT)

    def append(
        self, first: int | NDArray[np.int64], sensor: int, places_mm: Floats, readings: Floats
    ) -> None:
        """Appends frames (F,) of one sensor; those without a reading are left out.

        Args:
            first: number of the first of consecutive frames, or of each of them.
            places_mm: (F, 3) origin of the sensor frame.
            readings: (F, k)
        """
        known = np.isfinite(readings).all(axis=1)
        numbers = first + np.arange(len(readings)) if isinstance(first, int) else first
        rows = np.zeros(int(known.sum()), self._layout)
        for axis, name in enumerate("xyz"):
            rows[name] = places_mm[known, axis]
        rows["frame"], rows["sensor"] = numbers[known], sensor
        for k in range(readings.shape[1]):
            rows[f"reading{k + 1}"] = readings[known, k]
        self._sink.write(rows)

    def finish(self) -> None:
        """Completes the file."""
        self._sink.finish()


@contextmanager
def readings_writer(path: Path, size: int) -> Iterator[ReadingsWriter]:
    """A file to which frames are appended, each with so many numbers; it appears when it is
    complete.

    Raises:
        OperationError: it cannot be written.
    """
    with atomic_file(path) as file:
        writer = ReadingsWriter(file, size)
        yield writer
        writer.finish()


def read_frame_readings(path: Path) -> FrameReadings:
    """Reads the file.

    Raises:
        OperationError: missing, cut off, or not as Crenel writes it.
    """
    with convert_io_errors(path), open_file(path) as file:
        vertices = find_vertices(path, file)
        layout = vertices.element.layout("<")
        names = layout.names or ()
        size = len(names) - len(FIXED)
        expected = np.dtype([*FIXED, *((f"reading{k}", "<f8") for k in range(1, size + 1))])
        rows = np.fromfile(file, layout, vertices.count) if layout == expected else None
    if rows is None or len(rows) < vertices.count or not vertices.is_plain(layout):
        raise OperationError(
            "readings-damaged",
            message("cloud-readings-are-damaged", path=display_path(path)),
            remedy=message("cloud-rebuild-for-readings"),
        )
    order = np.argsort(rows["frame"], kind="stable")
    rows = rows[order]
    readings = np.column_stack([rows[name] for name in names[len(FIXED) :]])
    return FrameReadings(rows["frame"].astype(np.int64), rows["sensor"].astype(np.int64), readings)
