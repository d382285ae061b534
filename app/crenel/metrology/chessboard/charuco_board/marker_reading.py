"""The markers of ChArUco boards in a picture, as OpenCV reads them."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from cv2.typing import MatLike
from numpy.typing import NDArray

from crenel.metrology.chessboard.charuco_board.charuco_grid import charuco_board
from crenel.metrology.detection.failure_evidence import ImageAnnotation
from crenel.metrology.image import Image, saturation_level
from crenel.metrology.targets.chessboard import Chessboard, Markers
from crenel.metrology.transforms import Floats

# Sizes in which markers are looked for, as shares of the picture's own.
SCALES = (1.0, 2.0, 0.5)
MOST_ENLARGED_PX = 3000
# The smallest marker's outline as a share of the picture's longer side.
LEAST_OUTLINE = 0.01
# Share of a board's corners that needs no other size of the picture.
NEARLY_ALL = 0.7


@dataclass(frozen=True)
class MarkerReading:
    """M markers in a picture by id, each with its corners around it, the printed upper left first.

    ``outlines_px`` are pixels of the picture.
    """

    markers: NDArray[np.int64]  # (M,)
    outlines_px: Floats  # (M, 4, 2)

    @property
    def annotations(self) -> tuple[ImageAnnotation, ...]:
        """The outlines, to draw on the picture."""
        return tuple(
            ImageAnnotation("segment", *one.tolist(), *other.tolist())
            for quad in self.outlines_px
            for one, other in zip(quad, np.roll(quad, -1, axis=0), strict=True)
        )


@dataclass(frozen=True)
class BoardReading(MarkerReading):
    """With the N corners between them, by their number on the board."""

    number: NDArray[np.int64]  # (N,)
    uv_px: Floats  # (N, 2)


def read_board(image: Image, board: Chessboard, markers: Markers, thorough: bool) -> BoardReading:
    """The reading with most corners, of the sizes in which the picture is looked at.

    Args:
        image: (H, W) grey, 8 to 16 bits.
        thorough: also in other sizes than the picture's own.
    """
    detector = cv2.aruco.CharucoDetector(charuco_board(board, markers))
    detector.setDetectorParameters(_parameters())
    columns, rows = board.inner_corners
    best: BoardReading | None = None
    for grey, across in _sizes(image, SCALES if thorough else SCALES[:1]):
        corners, ids, outlines, read = detector.detectBoard(grey)
        uv_px = np.zeros((0, 2)) if corners is None else corners.reshape(-1, 2).astype(np.float64)
        own = np.zeros(0, np.int64) if ids is None else ids.ravel().astype(np.int64)
        number = (rows - 1 - own // columns) * columns + own % columns
        plain = _reading(read, outlines, across)
        reading = BoardReading(
            plain.markers, plain.outlines_px, number, (uv_px + 0.5) * across - 0.5
        )
        if best is None or (len(own), len(outlines)) > (len(best.number), len(best.markers)):
            best = reading
        if len(own) >= NEARLY_ALL * columns * rows:
            break
    assert best is not None
    return best


def read_dictionary(
    image: Image, dictionary: str, scales: tuple[float, ...] = SCALES[:1]
) -> MarkerReading:
    """The most markers of a dictionary that are read in one of several sizes of the picture."""
    known = cv2.aruco.getPredefinedDictionary(getattr(cv2.aruco, dictionary))
    detector = cv2.aruco.ArucoDetector(known, _parameters())
    found = []
    for grey, across in _sizes(image, scales):
        outlines, read, _ = detector.detectMarkers(grey)
        found.append(_reading(read, outlines, across))
    return max(found, key=lambda one: len(one.markers))


def _reading(
    read: MatLike | None, outlines: Sequence[MatLike], across: NDArray[np.float64]
) -> MarkerReading:
    return MarkerReading(
        np.zeros(0, np.int64) if read is None else read.ravel().astype(np.int64),
        (np.array(outlines, np.float64).reshape(-1, 4, 2) + 0.5) * across - 0.5,
    )


def _parameters() -> cv2.aruco.DetectorParameters:
    parameters = cv2.aruco.DetectorParameters()
    parameters.minMarkerPerimeterRate = LEAST_OUTLINE
    return parameters


def _sizes(
    image: Image, scales: tuple[float, ...]
) -> Iterator[tuple[NDArray[np.uint8], NDArray[np.float64]]]:
    """The picture with 8 bits in several sizes, and its own pixels per pixel of each."""
    full = image.astype(np.float64) * (255.0 / saturation_level(image))
    grey = np.clip(full, 0, 255).astype(np.uint8)
    for scale in scales:
        if scale > 1 and scale * max(image.shape) > MOST_ENLARGED_PX:
            continue
        method = cv2.INTER_AREA if scale < 1 else cv2.INTER_CUBIC
        small = cv2.resize(grey, None, fx=scale, fy=scale, interpolation=method)
        sized = np.asarray(small, np.uint8) if scale != 1.0 else grey
        yield sized, np.array(image.shape[::-1]) / np.array(sized.shape[::-1])
