"""How well poses agree with the pictures of a board if they are taken for something else."""

from dataclasses import dataclass, replace

import numpy as np

from crenel.errors import OperationError
from crenel.metrology.adjustment.block.initial_guess import solve_pnp
from crenel.metrology.adjustment.board.initial_guess import (
    BoardObservation,
    number_corners,
    refuse_other_size,
    size_by_motion,
)
from crenel.metrology.adjustment.core.hand_eye import Mounting, mounting_by_motion
from crenel.metrology.robust import median
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.targets.chessboard import Chessboard, corner_points
from crenel.metrology.transforms import Floats

FEWEST_PAIRS = 4
"""Poses that show a fault: any three agree with something, if not closely."""
FEWEST_CLOSE, CLOSE_MM = 3, 1.0
"""Poses that show that all slipped, and how closely they then place the board: by chance, three
hardly place it within four times as much."""
AGREES_MM = 5.0
"""Poses that are read rightly place the board this closely, by the median."""
NEARLY_ALL = 0.8
"""Share of the poses that then agree."""
MOTION_SHARE = 0.05
"""Poses agree on another size of the board if they scatter by less than this share of their
motion."""


@dataclass(frozen=True)
class SeenBoard:
    """P pictures of a board, by one camera."""

    board: Chessboard
    observations: tuple[BoardObservation, ...]
    camera: Camera

    def ways(self) -> list[Floats]:
        """The poses ``T_cam_obj`` (W, 4, 4) of each picture for each way to number its corners."""
        points, found = corner_points(self.board), []
        for one in self.observations:
            seen = one.detection
            numbers = (seen.number, *seen.other_numbers)
            found.append(
                np.array([solve_pnp(self.camera, points[number], seen.uv_px) for number in numbers])
            )
        return found

    def select(self, pictures: list[int]) -> "SeenBoard":
        chosen = tuple(self.observations[p] for p in pictures)
        return SeenBoard(self.board, chosen, self.camera)

    def mirror(self) -> "SeenBoard":
        """The board by a camera that does not mirror its pictures, if this one does.

        Only its numbers show that a chessboard is mirrored: they run along one side from the other
        end, along the one where the colours of the squares stay as they are.
        """
        columns, rows = self.board.inner_corners
        last_px = self.camera.width_px - 1
        every = np.arange(columns * rows).reshape(rows, columns)
        back = (every[::-1] if columns % 2 and rows % 2 == 0 else every[:, ::-1]).ravel()

        def flip(one: BoardObservation) -> BoardObservation:
            seen = one.detection
            flipped = replace(
                seen,
                uv_px=seen.uv_px * [-1, 1] + [last_px, 0],
                number=back[seen.number],
                other_numbers=tuple(back[other] for other in seen.other_numbers),
            )
            return replace(one, detection=flipped)

        matrix = self.camera.matrix.copy()
        matrix[0, 2] = last_px - matrix[0, 2]
        camera = replace(self.camera, matrix=matrix)
        return SeenBoard(self.board, tuple(map(flip, self.observations)), camera)


def mounting_of(seen: SeenBoard, T_arm_flange: Floats) -> Mounting | None:
    """The mounting by these poses (P, 4, 4); None if they do not even number the corners."""
    points = corner_points(seen.board)
    try:
        numbered = number_corners(seen.observations, seen.board, seen.camera, T_arm_flange)
        kept = [p for p, one in enumerate(numbered) if isinstance(one, BoardObservation)]
        boards = [one.detection for one in numbered if isinstance(one, BoardObservation)]
        T_cam_obj = np.array(
            [solve_pnp(seen.camera, points[one.number], one.uv_px) for one in boards]
        )
        return mounting_by_motion(T_arm_flange[kept], T_cam_obj, seen.board.size_mm)
    except OperationError:
        return None


def agreement(seen: SeenBoard, T_arm_flange: Floats, fewest: int = FEWEST_PAIRS) -> Mounting | None:
    """The mounting by these poses (P, 4, 4), if nearly all agree with the pictures; by few, if
    all do closely."""
    count = len(T_arm_flange)
    mounting = mounting_of(seen, T_arm_flange) if count >= fewest else None
    if mounting is None or not nearly_all_agree(mounting, count):
        return None
    if count < FEWEST_PAIRS and mounting.off_mm.max() > CLOSE_MM:
        return None
    try:
        refuse_other_size(mounting, seen.board)
    except OperationError:
        return None
    return mounting


def nearly_all_agree(mounting: Mounting, count: int) -> bool:
    """Whether nearly all of so many poses agree, and closely."""
    agree = np.sum(~mounting.contradicts)
    return bool(median(mounting.off_mm) <= AGREES_MM and agree >= NEARLY_ALL * count)


def agreement_with_other_size(mounting: Mounting, board: Chessboard) -> Mounting | None:
    """The mounting with the size of the squares that suits the poses best, if nearly all agree
    then, by a small share of their motion."""
    scale = size_by_motion(mounting).scale
    if scale <= 0:
        return None
    # the smaller of arm and board grows, or everything would agree
    poses = scale_translations(mounting.T_arm_flange, max(1.0, 1 / scale))
    boards = scale_translations(mounting.T_cam_obj, max(1.0, scale))
    try:
        resized = mounting_by_motion(poses, boards, board.size_mm * max(1.0, scale))
    except OperationError:
        return None
    places = poses[:, :3, 3]
    motion_mm = float(np.sqrt(np.mean(np.sum((places - places.mean(axis=0)) ** 2, axis=1))))
    if median(resized.off_mm) > MOTION_SHARE * motion_mm:
        return None
    return resized if nearly_all_agree(resized, len(resized.off_mm)) else None


def scale_translations(T: Floats, factor: float) -> Floats:
    """Transforms (P, 4, 4) with their translations in another unit."""
    grown = T.copy()
    grown[:, :3, 3] *= factor
    return grown
