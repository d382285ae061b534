"""A picture of a cloud, for lists and reports: seen from above and in front, shaded."""

from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.formats.clouds.cuts import sample_kept
from crenel.formats.clouds.points import positions_of
from crenel.metrology.colormaps import SCALE, map_colours
from crenel.metrology.transforms import Floats

SMALL_PX, LARGE_PX = 320, 960
"""Widths of the pictures of a list, and of a record's own page and a report."""
HEIGHT_SHARE, MARGIN_SHARE = 0.75, 0.025
"""Shares of the width."""
POINTS_A_PIXEL = 2
"""More are not read: a picture shows no more."""
TURN_RAD, TILT_RAD = np.radians(-35.0), np.radians(38.0)
Pixels = NDArray[np.uint8]
LIGHT = np.array([-0.35, 0.45, 0.82])
"""Towards the light, in the frame of the picture."""
DARKEST = 0.45
CLOSED_SHARE = 0.016
"""Gaps between the points of a surface up to this share of the width are closed."""
JPEG_QUALITY = 88
OUTERMOST_PERCENT = 0.05


def cloud_picture(cloud: Path, width_px: int) -> bytes:
    """A picture as PNG, transparent where there is no point.

    Args:
        cloud: ``cloud.ply`` of a scan.

    Raises:
        OperationError: it is missing, cut off, or written by another program.
    """
    return cv2.imencode(".png", _draw(cloud, width_px))[1].tobytes()


def cloud_photo(cloud: Path) -> tuple[bytes, int, int]:
    """The picture of a report as JPEG on white, with its width and height in pixels.

    Raises:
        OperationError: as ``cloud_picture``.
    """
    drawn = _draw(cloud, LARGE_PX)
    there = drawn[..., 3:] / 255.0
    on_white = np.rint(drawn[..., :3] * there + 255.0 * (1.0 - there)).astype(np.uint8)
    height_px, width_px = on_white.shape[:2]
    options = (cv2.IMWRITE_JPEG_QUALITY, JPEG_QUALITY)
    return cv2.imencode(".jpg", on_white, options)[1].tobytes(), width_px, height_px


def _draw(cloud: Path, width_px: int) -> Pixels:
    """Blue, green, red and opacity (height, width, 4)."""
    size_px = width_px, round(HEIGHT_SHARE * width_px)
    points = sample_kept(cloud, POINTS_A_PIXEL * size_px[0] * size_px[1])
    if not len(points):
        return np.zeros((size_px[1], size_px[0], 4), np.uint8)
    return _shade(_depth_map(positions_of(points) @ _view().T, size_px))


def _view() -> Floats:
    """Rows: to the right, up, and towards the viewer, in the arm frame."""
    c, s = np.cos(TURN_RAD), np.sin(TURN_RAD)
    turned = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    c, s = np.cos(TILT_RAD), np.sin(TILT_RAD)
    return np.asarray(np.array([[1.0, 0.0, 0.0], [0.0, s, c], [0.0, -c, s]]) @ turned)


def _depth_map(seen: Floats, size_px: tuple[int, int]) -> Floats:
    """Height towards the viewer (height, width) of seen points (N, 3), in pixels; NaN where there
    is none."""
    width_px, height_px = size_px
    outer = (OUTERMOST_PERCENT, 100 - OUTERMOST_PERCENT)
    low, high = np.percentile(seen[:, :2], outer, axis=0)
    room = np.array(size_px) - 2 * MARGIN_SHARE * width_px
    px_per_mm = float(np.min(room / np.maximum(high - low, 1e-6)))
    at = np.rint((seen[:, :2] - (low + high) / 2) * px_per_mm).astype(int)
    columns, rows = width_px // 2 + at[:, 0], height_px // 2 - at[:, 1]
    inside = (columns >= 0) & (columns < width_px) & (rows >= 0) & (rows < height_px)
    depth = np.full((height_px, width_px), -np.inf)
    np.maximum.at(depth, (rows[inside], columns[inside]), seen[inside, 2] * px_per_mm)
    closed = cv2.morphologyEx(
        depth.astype(np.float32),
        cv2.MORPH_CLOSE,
        _disc(round(CLOSED_SHARE * width_px)),
        borderType=cv2.BORDER_CONSTANT,
        borderValue=-np.inf,
    )
    return np.where(np.isfinite(closed), closed.astype(float), np.nan)


def _shade(depth: Floats) -> Pixels:
    """Blue, green, red and opacity of each pixel: coloured by height, lit from the left."""
    there = np.isfinite(depth)
    filled = np.where(there, depth, 0.0)
    weight = cv2.GaussianBlur(there.astype(float), (0, 0), 1.2)
    smooth = cv2.GaussianBlur(filled, (0, 0), 1.2) / np.maximum(weight, 1e-9)
    smooth = np.where(there, smooth, 0.0)
    down, right = np.gradient(smooth)
    normals = np.dstack([-right, down, np.ones_like(smooth)])
    normals /= np.linalg.norm(normals, axis=2, keepdims=True)
    light = np.clip(normals @ (LIGHT / np.linalg.norm(LIGHT)), 0.0, 1.0)
    # the height of a pixel in the arm frame, from where it lies in the picture
    up, near = _view()[1:, 2]
    rows = np.arange(len(depth), 0, -1.0)[:, None]
    heights = up * rows + near * smooth
    low, high = np.percentile(heights[there], (1, 99)) if there.any() else (0.0, 1.0)
    colours = map_colours(heights.ravel(), float(low), float(max(high, low + 1)), SCALE)
    lit = colours.reshape(*depth.shape, 3) * (DARKEST + (1 - DARKEST) * light)[..., None]
    return np.dstack([lit[..., ::-1], 255.0 * there]).astype(np.uint8)


def _disc(size_px: int) -> Pixels:
    return np.asarray(cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (size_px, size_px)), np.uint8)
