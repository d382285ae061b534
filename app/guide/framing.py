"""Where to hold the sensor for the first picture: the object as it should about lie. Pure."""

from functools import lru_cache

import numpy as np

from app.guide.view import Segment
from app.metrology.camera import Camera, project
from app.metrology.crenellated import Crenellated
from app.metrology.detection.visibility import visible_parts

# From the front and above, so that crests, floors and the front show; the lens of a usual sensor.
ELEVATION_RAD, FOCAL_SHARE = np.radians(55.0), 2.3
# So much of the picture the object takes.
FILLS = 0.68


@lru_cache(maxsize=8)
def first_outline(
    block: Crenellated, width_px: int, height_px: int, upright: bool = True
) -> tuple[Segment, ...]:
    """The block's outline from the front and above, in the middle of the picture.

    It is a guide for the eye: neither lens nor mounting are known before the first calibration.
    ``upright`` is false where the stripe runs down the picture, and the camera lies on its side.
    """
    away = 6.0 * (block.edges_x_mm[-1] - block.edges_x_mm[0])
    for _ in range(3):
        lines = _seen(block, away, width_px, height_px, upright)
        ends = lines.reshape(-1, 2)
        spread = (ends.max(axis=0) - ends.min(axis=0)) / (width_px, height_px)
        away *= float(spread.max()) / FILLS
    lines = _seen(block, away, width_px, height_px, upright)
    ends = lines.reshape(-1, 2)
    shift = np.array([width_px, height_px]) / 2 - (ends.max(axis=0) + ends.min(axis=0)) / 2
    moved = (lines + shift).round(1).tolist()
    return tuple((u0, v0, u1, v1) for (u0, v0), (u1, v1) in moved)


def _seen(
    block: Crenellated, away_mm: float, width_px: int, height_px: int, upright: bool
) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    """(N, 2, 2) ends of the lines that are seen from a distance, in pixels."""
    s, c = float(np.sin(ELEVATION_RAD)), float(np.cos(ELEVATION_RAD))
    rotation = np.array([[1.0, 0.0, 0.0], [0.0, -s, -c], [0.0, c, -s]])
    if not upright:
        rotation = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]) @ rotation
    x = block.edges_x_mm
    middle = np.array(
        [
            (x[0] + x[-1]) / 2,
            (block.front_y_mm + block.back_y_mm) / 2,
            (block.crest_z_mm + block.base_z_mm) / 2,
        ]
    )
    focal = FOCAL_SHARE * width_px
    matrix = np.array(
        [[focal, 0, (width_px - 1) / 2], [0, focal, (height_px - 1) / 2], [0, 0, 1.0]]
    )
    translation = -rotation @ middle + [0.0, 0.0, away_mm]
    camera = Camera(matrix, rotation, translation, width_px, height_px)
    parts = visible_parts(block, camera.centre_mm)
    points = np.array([(part.start_mm, part.end_mm) for part in parts]).reshape(-1, 3)
    return project(camera, points).reshape(-1, 2, 2)
