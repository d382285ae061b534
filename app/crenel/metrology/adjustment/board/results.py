"""The result of each pose, contact point and point in the adjustment on a chessboard."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.adjustment.board.initial_guess import BoardObservation
from crenel.metrology.adjustment.board.surface import corners_at
from crenel.metrology.adjustment.core.gauss_newton import AdjustmentResult
from crenel.metrology.adjustment.core.parameters import pose_scene
from crenel.metrology.adjustment.results.poses import (
    PoseResult,
    pose_offset_um,
    rms,
    stripe_residuals,
    worst_image_points,
)
from crenel.metrology.calibration.findings import WORST_OF_A_KIND, WorstResidual, contact_residual
from crenel.metrology.sensor.camera import project
from crenel.metrology.targets.chessboard import Chessboard, corner_grid
from crenel.metrology.transforms import Floats


@dataclass(frozen=True)
class BoardContacts:
    """Distance of each of N contact points from the board, and which were excluded."""

    residuals_um: Floats
    excluded: NDArray[np.bool_]

    @property
    def rms_um(self) -> float:
        """The rms of the contact points that count."""
        return rms(self.residuals_um[~self.excluded])


def board_pose_results(
    found: AdjustmentResult, seen: Sequence[BoardObservation], board: Chessboard
) -> list[PoseResult]:
    """Results of the poses that were used."""
    by_number = {pose.number: pose for pose in seen}
    results = []
    for p, number in enumerate(found.problem.numbers):
        corners, stripe = found.linear.rows[p]
        kept_corners, kept_stripe = (one.inliers for one in found.weights[p])
        results.append(
            PoseResult(
                number,
                True,
                "",
                rms(corners.residuals[kept_corners]) * np.sqrt(2),
                int(kept_corners.sum()) // 2,
                rms(stripe.residuals[kept_stripe]),
                int(kept_stripe.sum()),
                pose_offset_um(found, p),
                _corner_residuals(found, p, by_number[number], board),
                _corner_positions(by_number[number], board),
                stripe_residuals(stripe, kept_stripe),
            )
        )
    return results


def _corner_residuals(
    found: AdjustmentResult, pose: int, seen: BoardObservation, board: Chessboard
) -> tuple[tuple[str, float, float], ...]:
    """Measured minus projected, by column and row on the board."""
    scene = pose_scene(found.state, found.problem, found.layout, pose)
    at = corners_at(board, found.state.coordinates)[seen.detection.number]
    off = seen.detection.uv_px - project(scene.camera, at)
    return _label_corners(seen, board, off)


def _corner_positions(
    seen: BoardObservation, board: Chessboard
) -> tuple[tuple[str, float, float], ...]:
    return _label_corners(seen, board, seen.detection.uv_px)


def _label_corners(
    seen: BoardObservation, board: Chessboard, values: Floats
) -> tuple[tuple[str, float, float], ...]:
    places = corner_grid(board)[seen.detection.number]
    return tuple(
        (f"corner {column},{row}", float(u), float(v))
        for (column, row), (u, v) in zip(places.tolist(), values, strict=True)
    )


def board_contacts(found: AdjustmentResult) -> BoardContacts | None:
    """The contacts of a session in which the board was probed."""
    rows, touches = found.linear.contact_rows, found.problem.contacts
    if rows is None or touches is None:
        return None
    return BoardContacts(1e3 * rows.residuals_mm, ~touches.inliers)


def board_worst_points(
    found: AdjustmentResult, poses: Sequence[PoseResult], contacts: BoardContacts | None
) -> tuple[WorstResidual, ...]:
    """The worst contact points, corners and line points over all poses."""
    worst: list[WorstResidual] = []
    if contacts is not None:
        off_um = np.abs(contacts.residuals_um)
        worst += [
            contact_residual(int(i), "board", float(off_um[i]))
            for i in np.argsort(-off_um)[:WORST_OF_A_KIND]
        ]
    worst += worst_image_points(found, poses)
    return tuple(worst)
