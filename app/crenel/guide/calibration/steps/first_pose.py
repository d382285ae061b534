"""Where to hold the sensor for the first pictures: the object as it should about lie. Pure."""

from functools import lru_cache

import numpy as np

from crenel.guide.common.view import Segment
from crenel.metrology.adjustment.planning.next_pose import PoseDelta
from crenel.metrology.detection.visibility import visible_parts
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.targets.target import CalibrationTarget, board_lines, target_centre, width_mm
from crenel.metrology.transforms import Floats, rotation_from_vector

# A block from the front and above, so that crests, floors and the front show; and the lens of a
# usual sensor.
ELEVATION_RAD, FOCAL_SHARE = np.radians(55.0), 2.3
BLOCK_VIEW = PoseDelta(0.0, -float(90.0 - np.degrees(ELEVATION_RAD)), 0.0, 0.0)
# So much of the picture the object takes.
FILLS = 0.68
STRAIGHT_DOWN = np.diag([1.0, -1.0, -1.0])
"""A camera above the object, its picture's right along X."""
ON_ITS_SIDE = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])


@lru_cache(maxsize=16)
def first_outline(
    item: CalibrationTarget,
    width_px: int,
    height_px: int,
    upright: bool = True,
    view: PoseDelta = BLOCK_VIEW,
) -> tuple[Segment, ...]:
    """The object's outline in the middle of the picture, seen as ``view`` is from straight above.

    It is a guide for the eye: neither lens nor mounting are known before the first calibration.
    ``upright`` is false where the stripe runs down the picture, and the camera lies on its side
    over a block; a board lies any way, and is drawn as it fills the picture best.
    """
    away = 6.0 * width_mm(item)
    rotation = _rotation(view)
    if isinstance(item, Chessboard):
        columns, rows = item.inner_corners
        if (columns >= rows) != (width_px >= height_px):
            rotation = rotation @ ON_ITS_SIDE
    elif not upright:
        rotation = ON_ITS_SIDE @ rotation
    for _ in range(3):
        ends = _project_outline(item, away, width_px, height_px, rotation).reshape(-1, 2)
        spread = (ends.max(axis=0) - ends.min(axis=0)) / (width_px, height_px)
        away *= float(spread.max()) / FILLS
    lines = _project_outline(item, away, width_px, height_px, rotation)
    ends = lines.reshape(-1, 2)
    shift = np.array([width_px, height_px]) / 2 - (ends.max(axis=0) + ends.min(axis=0)) / 2
    moved = (lines + shift).round(1).tolist()
    return tuple((u0, v0, u1, v1) for (u0, v0), (u1, v1) in moved)


def _rotation(view: PoseDelta) -> Floats:
    """(3, 3) from the object to a camera that was swung from straight above."""
    turns = np.radians([-view.tilt_back_deg, view.tilt_right_deg, view.turn_deg])
    return np.asarray(STRAIGHT_DOWN @ rotation_from_vector(turns).T)


def _project_outline(
    item: CalibrationTarget, away_mm: float, width_px: int, height_px: int, rotation: Floats
) -> Floats:
    """(N, 2, 2) ends of the lines that are seen from a distance, in pixels."""
    focal = FOCAL_SHARE * width_px
    matrix = np.array(
        [[focal, 0, (width_px - 1) / 2], [0, focal, (height_px - 1) / 2], [0, 0, 1.0]]
    )
    translation = -rotation @ target_centre(item) + [0.0, 0.0, away_mm]
    camera = Camera(matrix, rotation, translation, width_px, height_px)
    return project(camera, _lines(item, camera).reshape(-1, 3)).reshape(-1, 2, 2)


def _lines(item: CalibrationTarget, camera: Camera) -> Floats:
    """(N, 2, 3) ends of what is drawn: hidden edges of a block are not."""
    if isinstance(item, Chessboard):
        return board_lines(item)
    parts = visible_parts(item, camera.centre_mm)
    return np.array([(part.start_mm, part.end_mm) for part in parts])
