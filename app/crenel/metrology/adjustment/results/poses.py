"""The result of each pose in the adjustment: how well it fits, or why it was excluded."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from crenel.messages.message import Quantity, Text, message, quantity
from crenel.metrology.adjustment.core.gauss_newton import AdjustmentResult
from crenel.metrology.adjustment.core.hand_eye import Mounting
from crenel.metrology.adjustment.core.observations import BlockObservation
from crenel.metrology.adjustment.core.parameters import pose_scene
from crenel.metrology.calibration.findings import (
    WORST_OF_A_KIND,
    WorstResidual,
    contact_residual,
    corner_text,
)
from crenel.metrology.calibration.observation_model import Rows, with_coordinates
from crenel.metrology.probing.alignment import Alignment
from crenel.metrology.robust import median
from crenel.metrology.sensor.camera import project
from crenel.metrology.targets.crenellated_block import Crenellated, corners
from crenel.metrology.transforms import Floats, inverse

# A pose that contradicts the others fits the readings of another pose if it is closer to it than
# this multiple of the usual distance, and than this.
FITS_TIMES, FITS_MM = 5.0, 1.0
MOST_STRIPE_POINTS = 60
Readings = Literal["angles", "pose"]
"""The arm's readings for a picture: joint angles, or the flange pose of a robot."""
NO_LINE = message("picture-shows-no-laser-line-object")
"""Reason for a pose that was used without its laser line."""


@dataclass(frozen=True)
class PoseResult:
    """One pose: residuals if it was used, ``reason`` if it or its laser line was excluded.

    ``pose_offset_um`` is the distance by which the arm's noise had to move the object for this pose
    to agree; ``corners_px`` are measured minus projected, by name, and ``corners_at_px`` the
    measured positions; ``stripe_off_px`` are evenly spaced points of the stripe (u, v), with their
    distance from the adjusted line.
    """

    number: int
    used: bool
    reason: Text = ""
    edges_rms_px: float = 0.0
    edge_points: int = 0
    stripe_rms_px: float = 0.0
    stripe_points: int = 0
    off_um: float = 0.0
    corners_px: tuple[tuple[str, float, float], ...] = ()
    corners_at_px: tuple[tuple[str, float, float], ...] = ()
    stripe_off_px: tuple[tuple[float, float, float], ...] = ()


def pose_results(
    found: AdjustmentResult, seen: Sequence[BlockObservation], block: Crenellated
) -> list[PoseResult]:
    """Results of the poses that were used."""
    by_number = {pose.number: pose for pose in seen}
    block = with_coordinates(block, found.state.coordinates)
    results = []
    for p, number in enumerate(found.problem.numbers):
        shape, stripe = found.linear.rows[p]
        kept_shape, kept_stripe = (one.inliers for one in found.weights[p])
        results.append(
            PoseResult(
                number,
                True,
                "",
                rms(shape.residuals[kept_shape]),
                int(kept_shape.sum()),
                rms(stripe.residuals[kept_stripe]),
                int(kept_stripe.sum()),
                pose_offset_um(found, p),
                _corner_residuals(found, p, by_number[number], block),
                tuple((c.name, c.u, c.v) for c in by_number[number].detection.corners),
                stripe_residuals(stripe, kept_stripe),
            )
        )
    return results


def stripe_residuals(rows: Rows, kept: NDArray[np.bool_]) -> tuple[tuple[float, float, float], ...]:
    """Evenly spaced points of a stripe that counted, from end to end, and their residuals."""
    own = np.flatnonzero(kept)
    own = own[:: max(1, -(-len(own) // MOST_STRIPE_POINTS))]
    return tuple(
        (round(float(u), 2), round(float(v), 2), round(float(off), 4))
        for (u, v), off in zip(rows.places[own], rows.residuals[own], strict=True)
    )


def outlier_pose_results(
    numbers: Sequence[int], mounting: Mounting, readings: Readings = "angles"
) -> list[PoseResult]:
    """Results of the poses that contradict the others, each with the pose whose readings would fit
    it."""
    T_arm_flange = mounting.T_arm_flange
    usual_mm = median(mounting.off_mm)
    results = []
    for p in map(int, np.flatnonzero(mounting.contradicts)):
        off = _length(mounting.off_mm[p])
        reason = message("puts-object-where-others-put", off=off)
        # the flange pose at which this picture would agree with the others
        wanted = T_arm_flange[p] @ _correction(mounting, p)
        apart = np.linalg.norm(T_arm_flange[:, :3, 3] - wanted[:3, 3], axis=1)
        other = int(np.argmin(apart))
        if apart[other] < min(FITS_TIMES * usual_mm + FITS_MM, apart[p] / 2):
            reason = message(
                "puts-object-fits-other-pose", readings=readings, off=off, other=numbers[other]
            )
        results.append(PoseResult(numbers[p], False, reason))
    return results


def line_exclusion_reason(off_mm: float) -> Text:
    """Result of a pose that was used without its laser line."""
    return message("laser-line-left-out-off-plane", off=_length(off_mm))


def _length(mm: float) -> Quantity:
    return quantity(mm, "mm", 1) if mm >= 1 else quantity(1e3 * mm, "µm")


def block_worst_points(
    found: AdjustmentResult,
    alignment: Alignment,
    features: Sequence[str],
    poses: Sequence[PoseResult],
) -> tuple[WorstResidual, ...]:
    """The worst contact points, corners and stripe points over all poses."""
    contacts = 1e3 * np.abs(alignment.residuals_mm)
    worst = [
        contact_residual(int(i), features[i], float(contacts[i]))
        for i in np.argsort(-contacts)[:WORST_OF_A_KIND]
    ]
    worst += worst_image_points(found, poses)
    return tuple(worst)


def worst_image_points(found: AdjustmentResult, poses: Sequence[PoseResult]) -> list[WorstResidual]:
    """The worst corners and stripe points over all poses."""
    at_corners = [
        (float(np.hypot(u, v)), pose.number, name)
        for pose in poses
        for name, u, v in pose.corners_px
    ]
    worst = [
        WorstResidual(
            "corner",
            message("pose-named", number=number, name=corner_text(name)),
            off,
            "px",
            pose=number,
            corner=name,
        )
        for off, number, name in sorted(at_corners, reverse=True)[:WORST_OF_A_KIND]
    ]
    on_stripe = []
    for number, (_, rows), (_, judgement) in zip(
        found.problem.numbers, found.linear.rows, found.weights, strict=True
    ):
        off_px = np.abs(rows.residuals) * judgement.inliers
        on_stripe += [
            (float(off_px[i]), number, float(rows.places[i, 0]), float(rows.places[i, 1]))
            for i in np.argsort(-off_px)[:WORST_OF_A_KIND]
        ]
    worst += [
        WorstResidual(
            "stripe",
            message("pose-at-pixel", number=number, u=quantity(u), v=quantity(v)),
            off,
            "px",
            None,
            number,
            (u, v),
        )
        for off, number, u, v in sorted(on_stripe, reverse=True)[:WORST_OF_A_KIND]
    ]
    return worst


def rms(values: Floats) -> float:
    """Rms of (N,) values; 0 if there are none."""
    return float(np.sqrt(np.mean(values**2))) if len(values) else 0.0


def pose_offset_um(found: AdjustmentResult, pose: int) -> float:
    """The displacement of the object by the noise of a pose's readings."""
    moves, state = found.problem.motion, found.state
    twist = moves.by_noise[pose] @ state.noise[pose]
    at = state.T_arm_obj[:3, 3]
    return float(1e3 * np.linalg.norm(np.cross(twist[:3], at) + twist[3:]))


def _corner_residuals(
    found: AdjustmentResult, pose: int, seen: BlockObservation, block: Crenellated
) -> tuple[tuple[str, float, float], ...]:
    measured = seen.detection.corners
    if not measured:
        return ()
    at = corners(block)
    scene = pose_scene(found.state, found.problem, found.layout, pose)
    uv = project(scene.camera, np.array([at[corner.name] for corner in measured]))
    return tuple(
        (corner.name, float(corner.u - u), float(corner.v - v))
        for corner, (u, v) in zip(measured, uv, strict=True)
    )


def _correction(mounting: Mounting, pose: int) -> Floats:
    """(4, 4) motion of the flange, in its own frame, that would make a pose agree."""
    X, T_cam_obj, T_arm_flange = (
        mounting.T_flange_cam,
        mounting.T_cam_obj[pose],
        mounting.T_arm_flange[pose],
    )
    wanted = mounting.T_arm_obj @ inverse(X @ T_cam_obj)
    return np.asarray(inverse(T_arm_flange) @ wanted)
