"""Corners of rendered ChArUco boards against the truth, beside those of OpenCV's detector.

python -m tests.bench.charuco
"""

from collections.abc import Callable
from dataclasses import dataclass, field, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from app.metrology.chessboard.charuco_grid import charuco_board
from app.metrology.chessboard.detect_board import detect_board
from app.metrology.sensor.camera import project
from app.metrology.targets.chessboard import Markers, corner_points
from app.metrology.transforms import Floats
from tests.metrology.boards import BOARD, POSES, Look, picture
from tests.metrology.seen_boards import camera_at

MARKERS = Markers("DICT_4X4_50", 7.5)
CHARUCO = replace(BOARD, markers=MARKERS)
UNLIT = Look(laser=False, board=CHARUCO)
Grey = NDArray[np.uint8]


@dataclass
class Corners:
    """Deviations from the truth of all corners found, px."""

    off_px: list[Floats] = field(default_factory=list)

    def __str__(self) -> str:
        every = np.concatenate(self.off_px)
        return f"{len(every):>5}{np.sqrt(np.mean(every**2)):>8.3f}"


def compress(image: Grey) -> Grey:
    """The picture as JPEG of quality 20."""
    _, coded = cv2.imencode(".jpg", image, [cv2.IMWRITE_JPEG_QUALITY, 20])
    return np.asarray(cv2.imdecode(coded, cv2.IMREAD_GRAYSCALE), np.uint8)


PICTURES: dict[str, tuple[Look, Callable[[Grey], Grey]]] = {
    "blur 1 px, noise 1": (UNLIT, lambda image: image),
    "noise 8": (replace(UNLIT, noise=8.0), lambda image: image),
    "blur 2 px": (replace(UNLIT, blur_px=2.0), lambda image: image),
    "JPEG, quality 20": (UNLIT, compress),
}


def main() -> None:
    detector = cv2.aruco.CharucoDetector(charuco_board(CHARUCO, MARKERS))
    columns, rows = CHARUCO.inner_corners
    print(f"{'of ' + str(len(POSES) * columns * rows) + ' corners':<20}  Crenel, px   OpenCV, px")
    for name, (look, change) in PICTURES.items():
        ours, theirs = Corners(), Corners()
        for k, T in enumerate(POSES):
            image = change(picture(T, look, k))
            true = project(camera_at(T), corner_points(CHARUCO))
            found = detect_board(image, CHARUCO)
            ours.off_px.append(found.uv_px - true[found.number])
            corners, ids, _, _ = detector.detectBoard(image)
            at = ids.ravel()
            number = (rows - 1 - at // columns) * columns + at % columns
            theirs.off_px.append(corners.reshape(-1, 2) - true[number])
        print(f"{name:<20}{ours}{theirs}")


if __name__ == "__main__":
    main()
