"""Where in a sensor's picture the laser's line can be, by its plane and its distances."""

import numpy as np

from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.stripe import LineBounds

BLOCK_PX, STEP_PX = 256, 8
"""Columns that have the same rows; pixels between those whose distance is computed."""
BEYOND, LEAST_BEYOND = 1.0, 0.25
"""How far beyond the calibrated distances the line is looked for, in shares of their range, and at
least in shares of the mean distance: parts are scanned from there, too."""
NEARLY_ALL = 0.9
"""Share of the picture from which on bounds would spare nothing."""


def find_line_bounds(
    camera: Camera, plane: LaserPlane, depth_range_mm: tuple[float, float], axis: str
) -> LineBounds | None:
    """The rows in which a line between the calibrated distances, or somewhat beyond, can be seen.

    Args:
        depth_range_mm: nearest and furthest calibrated distance from the camera.
        axis: along which stripe points are counted, see ``extract_stripe``.

    Returns:
        The rows by blocks of columns (axis v: columns by blocks of rows); None where that is
        nearly the whole picture, or nothing of it.
    """
    near_mm, far_mm = depth_range_mm
    beyond_mm = max(BEYOND * (far_mm - near_mm), LEAST_BEYOND * (near_mm + far_mm) / 2)
    size_px = camera.width_px, camera.height_px
    width, height = size_px if axis == "u" else size_px[::-1]
    along, across = (
        np.append(np.arange(0, size - 1, STEP_PX), size - 1) for size in (width, height)
    )
    first, second = np.meshgrid(along, across)
    uv = np.column_stack([each.ravel() for each in (first, second)]).astype(np.float64)
    points_mm = sensor_points(camera, plane, uv if axis == "u" else uv[:, ::-1])
    away_mm = np.linalg.norm(points_mm - camera.centre_mm, axis=1).reshape(first.shape)
    inside = np.abs(away_mm - (near_mm + far_mm) / 2) <= (far_mm - near_mm) / 2 + beyond_mm
    blocks = -(-width // BLOCK_PX)
    rows = np.zeros((2, blocks), np.int64)
    for block in range(blocks):
        beside = (along >= block * BLOCK_PX - STEP_PX) & (along < (block + 1) * BLOCK_PX + STEP_PX)
        seen = across[inside[:, beside].any(axis=1)]
        if len(seen):
            rows[:, block] = max(seen[0] - STEP_PX, 0), min(seen[-1] + STEP_PX + 1, height)
    share = float((rows[1] - rows[0]).mean()) / height
    if not 0 < share < NEARLY_ALL:
        return None
    return LineBounds(rows[0], rows[1], BLOCK_PX, height, width, axis)
