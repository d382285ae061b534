"""A picture of a line that the sensor found itself."""

import numpy as np
from numpy.typing import NDArray

from crenel_hardware.interfaces import Frame, Line, SensorReading

FAINTEST = 0.4
"""Share of white of the faintest point."""


def draw_line(line: Line) -> NDArray[np.uint8]:
    """(height, width): the points on a dark ground, brighter where the line is."""
    picture = np.zeros((line.height_px, line.width_px), np.uint8)
    if not len(line.u):
        return picture
    usable = np.isfinite(line.u) & np.isfinite(line.v) & np.isfinite(line.intensity)
    columns = np.rint(line.u[usable]).astype(int)
    rows = np.rint(line.v[usable]).astype(int)
    level = np.clip(line.intensity[usable] / max(np.max(line.intensity[usable]), 1e-9), 0.0, 1.0)
    grey = np.round(255 * (FAINTEST + (1 - FAINTEST) * level)).astype(np.uint8)
    for step in (-1, 0, 1):  # wide enough to be seen in a smaller picture
        for column, row in ((columns + step, rows), (columns, rows + step)):
            inside = (column >= 0) & (column < line.width_px) & (row >= 0) & (row < line.height_px)
            picture[row[inside], column[inside]] = grey[inside]
    return picture


def picture_of(reading: SensorReading) -> NDArray[np.uint8] | NDArray[np.uint16]:
    """The image of a frame, or the line drawn."""
    return reading.image if isinstance(reading, Frame) else draw_line(reading)
