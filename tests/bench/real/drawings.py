"""Pictures of the bench with what was found in them, for people to look at."""

from pathlib import Path

import cv2
import numpy as np

from crenel.formats.atomic_write import write_atomically
from crenel.formats.images import to_8_bits
from crenel.metrology.transforms import Floats
from tests.bench.real.lines import PictureResult

POINT, MISSED, FALSE = (60, 200, 60), (60, 60, 255), (0, 220, 255)
"""Green, red and yellow, in OpenCV's order."""
RADIUS_PX = 2


def write_drawing(folder: Path, result: PictureResult) -> None:
    """Writes a picture with Crenel's points in green, false ones in yellow, and in red where the
    peers have a line that Crenel misses."""
    canvas = cv2.cvtColor(to_8_bits(result.turned), cv2.COLOR_GRAY2BGR)
    for column in np.flatnonzero(np.isfinite(result.rows) & ~result.false):
        canvas[round(float(result.rows[column])), column] = POINT
    _draw(canvas, result.rows, result.false, FALSE)
    _draw(canvas, result.peer_rows, result.missed, MISSED)
    upright = canvas if result.axis == "u" else cv2.transpose(canvas)
    folder.mkdir(parents=True, exist_ok=True)
    encoded = cv2.imencode(".png", upright)[1]
    write_atomically(folder / f"{result.name}, {result.axis}.png", encoded.tobytes())


def _draw(
    canvas: cv2.typing.MatLike,
    rows: Floats,
    columns: np.typing.NDArray[np.bool_],
    colour: tuple[int, int, int],
) -> None:
    for column in np.flatnonzero(columns):
        at = (int(column), round(float(rows[column])))
        cv2.circle(canvas, at, RADIUS_PX, colour, -1)
