"""The local noise of the laser's line in real pictures, which have no truth.

Along the line, the quadratic trend of every 41 neighbouring points is taken away; what is
left of the middle one, divided by the share of its own noise that the trend leaves it, is
the noise. A picture's figure is the rms of these, a folder's the median of its pictures.
"""

from collections.abc import Sequence
from pathlib import Path

import cv2
import numpy as np

from app.bench.stripe.frames import Grey
from app.bench.stripe.methods import METHODS, Line, Method
from app.bench.stripe.speed import ComparisonRow
from app.errors import OperationError
from app.formats.io_errors import convert_io_errors
from app.metrology.stripe import extract_stripe
from app.metrology.transforms import Floats

WINDOW = 41
SUFFIXES = (".png", ".tif", ".tiff", ".bmp", ".pgm")


def run(folder: Path) -> list[ComparisonRow]:
    """The row of a folder of images; raises ``OperationError`` where none has a line."""
    pictures = [_orient(picture) for picture in _pictures(folder)]
    cells = [_cell(pictures, method) for method in METHODS]
    return [
        ComparisonRow(f"local noise of the line, {folder.name} ({len(pictures)} pictures)", *cells)
    ]


def local_noise_px(line: Line, columns: int) -> float:
    """Rms of a line's points (N,), (N,) about their trend; NaN where no 41 stand together."""
    along, across = line
    places: Floats = np.full(columns, np.nan)
    places[np.rint(along).astype(int)] = across
    basis = np.vander(np.arange(WINDOW) - WINDOW // 2, 3)
    off = np.eye(WINDOW) - basis @ np.linalg.pinv(basis)
    middle = off[WINDOW // 2]
    windows = np.lib.stride_tricks.sliding_window_view(places, WINDOW)
    left = windows[np.isfinite(windows).all(axis=1)] @ middle / np.sqrt(middle[WINDOW // 2])
    return float(np.sqrt(np.mean(left**2))) if len(left) else float("nan")


def _cell(pictures: Sequence[Grey], method: Method) -> str:
    found = [local_noise_px(method(picture), picture.shape[1]) for picture in pictures]
    finite = [noise for noise in found if np.isfinite(noise)]
    return f"{np.median(finite):.3f} px" if finite else "no line"


def _orient(picture: Grey) -> Grey:
    """With the line across its columns: the way round in which it has more points."""
    turned = np.ascontiguousarray(picture.T)
    across, down = (len(extract_stripe(one).u) for one in (picture, turned))
    return picture if across >= down else turned


def _pictures(folder: Path) -> list[Grey]:
    with convert_io_errors(folder):
        files = sorted(path for path in folder.iterdir() if path.suffix.lower() in SUFFIXES)
    pictures = []
    for path in files:
        image = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
        if image is None or image.dtype != np.uint8:
            raise OperationError("image-unreadable", str(path), "it is not a picture of 8 bits")
        if image.ndim == 3:
            if np.ptp(image[..., :3].astype(np.int16), axis=2).any():
                raise OperationError("image-not-grey", str(path), "it is in colour")
            image = image[..., 0]
        pictures.append(np.ascontiguousarray(image, dtype=np.uint8))
    if not pictures:
        raise OperationError("folder-without-pictures", str(folder), "it contains no pictures")
    return pictures
