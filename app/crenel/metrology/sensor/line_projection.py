"""Distances of pixels from the images of straight lines, with all derivatives."""

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.projection import COUNT
from crenel.metrology.transforms import Floats
from crenel.native.arguments import F64, Array, Function
from crenel.native.library import CRENEL

_across = Function(
    CRENEL,
    "across_lines",
    Array(F64, "n", 2),
    Array(F64, "n", 3),
    Array(F64, "n", 3),
    Array(F64, 3, 4),
    Array(F64, 9),
    Array(F64, "n", written=True),
    Array(F64, "n", 2, written=True),
    Array(F64, "n", "columns", written=True),
    Array(F64, "n", 3, written=True),
    Array(F64, "n", written=True),
)


def add_ends(
    J: Floats, by_points: Floats, shares: Floats, ends: NDArray[np.int64], first: int
) -> None:
    """Adds to J (N, P) the derivatives of the residuals by the coordinates of the lines' ends.

    ``ends`` (N, 2, 3) numbers these coordinates, which begin at column ``first``; the others as
    returned by ``across_lines``.
    """
    row, share = np.arange(len(J))[:, None], shares[:, None]
    J[row, first + ends[:, 0]] += by_points * (1 - share)
    J[row, first + ends[:, 1]] += by_points * share


def across_lines(
    camera: Camera, uv_px: Floats, start: Floats, along: Floats, columns: int = COUNT
) -> tuple[Floats, Floats, Floats, Floats, Floats]:
    """Distances of pixels (N, 2) from the images of the lines ``start + share along`` (N, 3).

    Each at the share at which its ray is closest to the line.

    Returns:
        (N,) distances in px, residuals; (N, 2) unit normals of the lines' images; their
        derivatives (N, columns) by the camera's parameters, zero beyond these, and (N, 3) by
        the lines' points; (N,) the shares.
    """
    K = camera.matrix
    pose = np.column_stack([camera.rotation, camera.translation_mm])
    lens = np.array([K[0, 0], K[1, 1], K[0, 2], K[1, 2], *camera.distortion])
    count = len(uv_px)
    off, normals, J = np.empty(count), np.empty((count, 2)), np.empty((count, columns))
    by_points, shares = np.empty((count, 3)), np.empty(count)
    _across(uv_px, start, along, pose, lens, off, normals, J, by_points, shares)
    return off, normals, J, by_points, shares
