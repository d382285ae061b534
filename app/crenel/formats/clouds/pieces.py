"""Reads a finished cloud of Crenel in pieces, so that memory stays bounded."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from crenel.errors import OperationError
from crenel.formats.clouds.ply import find_vertices
from crenel.formats.clouds.points import POINT, Points
from crenel.formats.file_names import display_path
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.open_file import open_file
from crenel.messages.message import message

PIECE = 250_000
RUN = 64
"""Points of a sample that follow each other in the file: each run is one access."""


class StoredCloud:
    """The points of ``cloud.ply``, in the order of their frames; only what is asked for is read."""

    def __init__(self, path: Path) -> None:
        """Reads the header.

        Raises:
            OperationError: missing, or not as the scanner writes it.
        """
        self._path = path
        with convert_io_errors(path), open_file(path) as file:
            vertices = find_vertices(path, file)
            self._begin = file.tell()
        if not vertices.is_plain(POINT):
            raise OperationError(
                "cloud-foreign",
                message("cloud-not-as-scan-wrote-it", path=display_path(path)),
                message("rewritten-by-another-program"),
            )
        self.count: int = vertices.count

    def read(self, *runs: tuple[int, int]) -> Points:
        """The points of some runs, each by its first number and how many there are.

        Raises:
            OperationError: missing, or cut off.
        """
        with convert_io_errors(self._path), open_file(self._path) as file:
            parts = []
            for first, count in runs:
                file.seek(self._begin + first * POINT.itemsize)
                parts.append(np.fromfile(file, POINT, count))
                if len(parts[-1]) < count:
                    raise OperationError(
                        "cloud-cut-off",
                        message(
                            "cloud-has-points-of",
                            path=display_path(self._path),
                            count=first + len(parts[-1]),
                            announced=self.count,
                        ),
                        message("file-cut-off"),
                    )
        if len(parts) == 1:
            return parts[0]  # most of them, of up to PIECE points: they are not copied
        return np.concatenate(parts) if parts else np.zeros(0, POINT)

    def sample(self, most: int) -> Points:
        """At most so many points, evenly from the whole file."""
        if self.count <= most:
            return self.read((0, self.count))
        bounds = np.linspace(0, self.count, max(most // RUN, 1) + 1).astype(int)
        room = np.maximum(np.diff(bounds) - RUN, 0)
        # not at equal distances: these could be those of the stripes
        starts = bounds[:-1] + np.random.default_rng(0).integers(0, room + 1)
        return self.read(*((int(start), min(RUN, self.count - int(start))) for start in starts))

    def find_frame(self, frame: float) -> int:
        """The number of the first point of this frame, or of the first one after it."""
        low, high = 0, self.count
        while low < high:
            middle = (low + high) // 2
            if self.read((middle, 1))["frame"][0] < frame:
                low = middle + 1
            else:
                high = middle
        return low


def read_cloud_pieces(path: Path) -> Iterator[tuple[Points, float]]:
    """Points of ``cloud.ply`` in frame order, and the share that has been read, 0 to 1.

    Raises:
        OperationError: missing, truncated, or not as the scanner writes it.
    """
    cloud = StoredCloud(path)
    for first in range(0, cloud.count, PIECE):
        points = cloud.read((first, min(PIECE, cloud.count - first)))
        yield points, (first + len(points)) / cloud.count
