"""Corners of rendered ChArUco boards against the truth, beside those of OpenCV's detector.

python -m tests.bench charuco [--json]
"""

from collections.abc import Callable
from dataclasses import replace

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.metrology.chessboard.charuco_board.charuco_grid import charuco_board
from crenel.metrology.chessboard.detect_board import detect_board
from crenel.metrology.sensor.camera import project
from crenel.metrology.targets.chessboard import Markers, corner_points
from crenel.metrology.transforms import Floats
from tests.bench.rows import bench_parser, measured_rows, rms
from tests.metrology.boards import BOARD, POSES, Look, picture
from tests.metrology.seen_boards import camera_at

MARKERS = Markers("DICT_4X4_50", 7.5)
CHARUCO = replace(BOARD, markers=MARKERS)
UNLIT = Look(laser=False, board=CHARUCO)
Grey = NDArray[np.uint8]


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
    parser = bench_parser(__doc__)
    with measured_rows(parser.parse_args().json) as rows:
        for name in PICTURES:
            values: dict[str, float] = {}
            for method, off_px in find_corners(name).items():
                every = np.concatenate(off_px)
                values |= {f"{method}, found": len(every), f"{method}, px": rms(every)}
            rows.add(name, values)


def find_corners(name: str) -> dict[str, list[Floats]]:
    """Their deviations from the truth in the pictures of one kind, in px, by method."""
    look, change = PICTURES[name]
    ours, theirs = [], []
    detector = cv2.aruco.CharucoDetector(charuco_board(CHARUCO, MARKERS))
    columns, rows = CHARUCO.inner_corners
    for k, T in enumerate(POSES):
        image = change(picture(T, look, k))
        true = project(camera_at(T), corner_points(CHARUCO))
        found = detect_board(image, CHARUCO)
        ours.append(found.uv_px - true[found.number])
        corners, ids, _, _ = detector.detectBoard(image)
        at = ids.ravel()
        number = (rows - 1 - at // columns) * columns + at % columns
        theirs.append(corners.reshape(-1, 2) - true[number])
    return {"Crenel": ours, "OpenCV": theirs}


if __name__ == "__main__":
    main()
