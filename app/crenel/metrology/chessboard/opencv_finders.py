"""OpenCV's finders of chessboards, for the pictures in which ours finds no whole board."""

from collections.abc import Iterator

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.metrology.chessboard.lattice import Lattice, complete_lattice
from crenel.metrology.chessboard.saddle_points import Saddles, drop_duplicates, phases_at
from crenel.metrology.image import Image, saturation_level
from crenel.metrology.transforms import Floats

# Of the distance between corners: the ring on which bright and dark squares are distinguished.
RING_SHARE, LEAST_RING_PX = 0.3, 2.0
# In a large picture of something else the finders take very long.
LONGER_SIDE_PX = 1300
CLASSIC = cv2.CALIB_CB_ADAPTIVE_THRESH | cv2.CALIB_CB_NORMALIZE_IMAGE | cv2.CALIB_CB_FAST_CHECK


def find_by_opencv(
    image: Image, inner_corners: tuple[int, int], saddles: Saddles
) -> Iterator[tuple[Saddles, Lattice]]:
    """A grid by each of OpenCV's finders that finds one of the size (columns, rows).

    The second finder runs only if the grid of the first does not do.

    The finders may take a part of a larger board for the whole, so that the grids go on among
    the ``saddles`` as far as these do.
    """
    grey = _reduce(image)
    across = np.array(image.shape[::-1]) / np.array(grey.shape[::-1])
    columns, rows = inner_corners
    for find, flags in (
        (cv2.findChessboardCornersSB, cv2.CALIB_CB_NORMALIZE_IMAGE),
        (cv2.findChessboardCorners, CLASSIC),
    ):
        found, corners = find(grey, inner_corners, None, flags)
        if not found:
            continue
        uv_px = (corners.reshape(-1, 2).astype(np.float64) + 0.5) * across - 0.5
        steps = np.linalg.norm(np.diff(uv_px.reshape(rows, columns, 2), axis=1), axis=2)
        ring_px = max(LEAST_RING_PX, RING_SHARE * float(steps.min()))
        both = drop_duplicates(
            np.concatenate([uv_px, saddles.uv_px]),
            np.concatenate([phases_at(image, uv_px, ring_px), saddles.phase]),
        )
        lattice = {(k % columns, k // columns): k for k in range(columns * rows)}
        yield both, complete_lattice(both, lattice)


def _reduce(image: Image) -> NDArray[np.uint8]:
    """The picture with 8 bits, and no larger than the finders can take."""
    grey: Floats = np.asarray(image, np.float64) * (255.0 / saturation_level(image))
    scale = min(1.0, LONGER_SIDE_PX / max(image.shape))
    if scale < 1:
        grey = np.asarray(cv2.resize(grey, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA))
    return np.clip(grey, 0, 255).astype(np.uint8)
