"""The laser lines on the block in several poses: the plane of most lines, and lines off it."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import message, quantity
from crenel.metrology.adjustment.block.initial_guess import express_in_camera_frame
from crenel.metrology.adjustment.core.gauss_newton import AdjustmentResult, solve_adjustment
from crenel.metrology.adjustment.core.observations import AdjustmentProblem, BlockObservation
from crenel.metrology.adjustment.outliers.poses import find_worst_outlier
from crenel.metrology.adjustment.results.stripes import off_plane_mm
from crenel.metrology.calibration.findings import AGREEING
from crenel.metrology.calibration.laser_plane_fit import fit_laser_plane
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.transforms import Floats, apply

# A line that is closer to the plane than this is never an outlier.
OUTLIER_LINE_MM = 0.05
FEWEST_LINES = 3
# Lines further than this from their best common plane do not share a plane.
HOPELESS_MM = 0.5


def fit_common_plane(
    seen: Sequence[BlockObservation],
    block: Crenellated,
    camera: Camera,
    T_cam_obj: Floats,
    plane: LaserPlane,
) -> tuple[LaserPlane, dict[int, float]]:
    """The plane, in the camera frame, in which the laser lines of most poses lie.

    A line on crests and floors determines a plane by itself; the plane that fits most other lines
    best is chosen. Lines that do not lie in a plane by themselves do not vote if others do: they
    come from the picture of another pose, or from reflections.

    Args:
        camera: its own frame as sensor frame.
        T_cam_obj: (P, 4, 4) block pose in each view.
        plane: returned if fewer than two poses show a line.

    Returns:
        The plane, and the distance in mm of lines that are far off it, by pose number.

    Raises:
        OperationError: ``lines-contradict`` if there is no such plane.
    """
    lines = {
        pose.number: _fit_line(pose, block, camera, T)
        for pose, T in zip(seen, T_cam_obj, strict=True)
    }
    shown = {number: line for number, line in lines.items() if line is not None}
    if len(shown) < 2:
        return plane, {}
    reliable = {number: line for number, line in shown.items() if line.share >= AGREEING} or shown
    plane = min((line.plane for line in reliable.values()), key=lambda k: _score_plane(reliable, k))
    off_mm = {number: line.off_mm(plane) for number, line in shown.items()}
    far = {number: off for number, off in off_mm.items() if off > HOPELESS_MM}
    if len(reliable) > 1 and 2 * len(reliable.keys() & far) >= len(reliable):
        most_mm = max(off_mm[number] for number in reliable)
        raise OperationError(
            "lines-contradict",
            message(
                "lasers-lines-poses-lie-up-off",
                poses=", ".join(map(str, reliable)),
                most=quantity(most_mm, "mm", 1),
            ),
            message("half-them-more-contradicting-others-none"),
            message("check-each-laser-picture-own-pose-no-reflection"),
        )
    return plane, far


@dataclass(frozen=True)
class _LaserLine:
    """One line: its points (N, 3), its plane, and the share of points that lie in that plane."""

    in_cam: Floats
    plane: LaserPlane
    share: float

    def off_mm(self, plane: LaserPlane) -> float:
        """Rms distance of the points from a plane."""
        return float(np.sqrt(np.mean((self.in_cam @ plane.normal - plane.offset_mm) ** 2)))


def _score_plane(lines: Mapping[int, _LaserLine], plane: LaserPlane) -> tuple[int, float]:
    """The number of lines far off a plane, and the joint distance (mm) of the others from it."""
    off = np.array([line.off_mm(plane) for line in lines.values()])
    near = off[off <= HOPELESS_MM]
    return len(off) - len(near), float(np.sum(near))


def _fit_line(
    pose: BlockObservation, block: Crenellated, camera: Camera, T: Floats
) -> _LaserLine | None:
    placed = replace(camera, rotation=T[:3, :3], translation_mm=T[:3, 3])
    try:
        fit = fit_laser_plane(placed, block, pose.stripe)
    except OperationError:
        return None
    share = float(fit.used.sum() / max(int((fit.level != "").sum()), 1))
    return _LaserLine(
        apply(T, fit.points_mm[fit.used]), express_in_camera_frame(placed, fit.plane)[1], share
    )


def line_offsets_mm(found: AdjustmentResult) -> Floats:
    """(P,) distance of each pose's line from the laser plane; NaN without a line."""
    off = [off_plane_mm(stripe) for _, stripe in found.linear.rows]
    return np.array([abs(np.nanmedian(one)) if np.isfinite(one).any() else np.nan for one in off])


def remove_outlier_lines(found: AdjustmentResult) -> tuple[AdjustmentResult, dict[int, float]]:
    """Adjusts without the lines that lie off the plane of the others, worst first.

    Fewer than half of all lines are excluded; their poses stay. Also returns the distance (mm) of
    these lines from the plane, by pose number.
    """
    outliers_mm: dict[int, float] = {}
    off_mm = line_offsets_mm(found)
    total = int(np.isfinite(off_mm).sum())
    while np.isfinite(off_mm).sum() >= FEWEST_LINES and 2 * (len(outliers_mm) + 1) < total:
        worst = find_worst_outlier(off_mm, OUTLIER_LINE_MM)
        if worst is None:
            break
        outliers_mm[found.problem.numbers[worst]] = float(off_mm[worst])
        found = solve_adjustment(without_lines(found.problem, outliers_mm), found.state)
        off_mm = line_offsets_mm(found)
    return found, outliers_mm


def without_lines(problem: AdjustmentProblem, numbers: Collection[int]) -> AdjustmentProblem:
    """The problem without the laser lines of these poses; the poses stay."""
    views = tuple(
        view.without_line() if number in numbers else view
        for number, view in zip(problem.numbers, problem.views, strict=True)
    )
    return replace(problem, views=views)
