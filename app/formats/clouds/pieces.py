"""Reads a finished cloud of Crenel in chunks, so that memory stays bounded."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from app.errors import OperationError
from app.formats.clouds.ply import find_vertices
from app.formats.clouds.points import POINT, Points
from app.formats.file_names import display_path
from app.formats.io_errors import convert_io_errors
from app.formats.open_file import open_file
from app.messages.message import message

PIECE = 250_000


def read_cloud_pieces(path: Path) -> Iterator[tuple[Points, float]]:
    """Points of ``cloud.ply`` in frame order, and the share that has been read, 0 to 1.

    Raises:
        OperationError: missing, truncated, or not as the scanner writes it.
    """
    with convert_io_errors(path), open_file(path) as file:
        vertices = find_vertices(path, file)
        if not vertices.is_plain(POINT):
            raise OperationError(
                "cloud-foreign",
                message("cloud-not-as-scan-wrote-it", path=display_path(path)),
                message("rewritten-by-another-program"),
            )
        left = vertices.count
        while left > 0:
            points = np.fromfile(file, POINT, min(PIECE, left))
            if not len(points):
                raise OperationError(
                    "cloud-cut-off",
                    message(
                        "cloud-has-points-of",
                        path=display_path(path),
                        count=vertices.count - left,
                        announced=vertices.count,
                    ),
                    message("file-cut-off"),
                )
            left -= len(points)
            yield points, 1.0 - left / vertices.count
