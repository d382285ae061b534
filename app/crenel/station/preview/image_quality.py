"""Saturated parts of a picture, for drawing on it."""

import numpy as np

from crenel.errors import OperationError
from crenel.findings import Finding, capital
from crenel.messages.message import message
from crenel.metrology.detection.image_quality import (
    Image,
    ImageQuality,
    measure_image_quality,
    quality_findings,
)
from crenel.metrology.image import saturation_level
from crenel.station.devices.stillness import Stillness

CELL_PX = 16
# Number of clipped pixels that make a cell: one or two hot pixels do not.
LEAST = 6
MOST_BOXES = 300
Box = tuple[int, int, int, int]
"""Left, top, width, height in pixels."""


def saturation(image: Image) -> tuple[float, tuple[Box, ...]]:
    """The share of saturated pixels in percent, and their positions as boxes, joined along rows."""
    clipped = image >= saturation_level(image)
    count = int(np.count_nonzero(clipped))
    percent = 100.0 * count / image.size
    if count < LEAST:
        return percent, ()
    rows, columns = (size // CELL_PX for size in image.shape)
    whole = clipped[: rows * CELL_PX, : columns * CELL_PX]
    cells = whole.reshape(rows, CELL_PX, columns, CELL_PX).sum(axis=(1, 3)) >= LEAST
    edges = np.diff(cells.astype(np.int8), axis=1, prepend=0, append=0)
    starts, ends = np.argwhere(edges == 1), np.argwhere(edges == -1)
    boxes = [
        (int(left) * CELL_PX, int(row) * CELL_PX, int(right - left) * CELL_PX, CELL_PX)
        for (row, left), (_, right) in zip(starts, ends, strict=True)
    ]
    return percent, tuple(boxes[:MOST_BOXES])


def image_findings(image: Image) -> list[Finding]:
    """Exposure, saturation and sharpness as findings; empty if all is well."""
    return measure_image(image)[1]


def measure_image(image: Image) -> tuple[ImageQuality | None, list[Finding]]:
    """The same with the measures; a picture that is not grey has none."""
    try:
        measures = measure_image_quality(image)
    except OperationError as error:
        return None, [error_finding(error)]
    return measures, [
        Finding("attention", capital(finding.text), capital(finding.remedy))
        for finding in quality_findings(measures)
    ]


def error_finding(error: OperationError) -> Finding:
    """An error as a finding."""
    text = capital(error.what)
    if error.why:
        text = message("finding-what-and-why", what=error.what, why=error.why)
    return Finding("attention", text, capital(error.remedy))


def stillness_findings(stillness: Stillness) -> list[Finding]:
    """Asks the operator to hold still if the arm moves; empty if it is still."""
    return [] if stillness.still else [Finding("attention", stillness.text, message("hold-still"))]
