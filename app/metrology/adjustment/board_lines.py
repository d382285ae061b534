"""The laser's lines of all pictures against one another: the plane most agree on, and which
lines contradict it."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from app.metrology.adjustment.board_bundle import Bundle
from app.metrology.adjustment.board_view import BoardView, on_sheet
from app.metrology.adjustment.sheet import around_pattern
from app.metrology.frames import Floats
from app.metrology.laser_plane import LaserPlane
from app.metrology.refusal import Refusal

FEWEST_STRIPE_POINTS = 20
# Lines contradict the others beyond this, beyond so many times the sheet's flatness, and
# so many times what is usual among them.
OFF_MM, OFF_FLATNESSES, OFF_TIMES = 0.5, 3.0, 5.0
PLANE_DRAWS, DRAWN_POINTS = 400, 60
AGREEING_TIMES = 4.0
# Angle between the laser's plane and the board below which their line is not to be trusted.
LEAST_LASER_ANGLE_DEG = 8.0
# Lines spread over the plane by this share of their length at least.
LEAST_SPREAD = 0.02


@dataclass(frozen=True)
class Lines:
    """The plane of most lines, in the camera's frame.

    ``off_mm`` (P,) is how far each pose's line lies off it (NaN where there is none), and
    ``uneven_mm`` how far stretches of the lines typically do (standard deviation).
    """

    plane: LaserPlane
    off_mm: Floats
    uneven_mm: float


def lines_of(views: Sequence[BoardView], found: Bundle, numbers: Sequence[int]) -> Lines:
    """The lines where the pictures put the sheet.

    Raises:
        Refusal: fewer than two lines on the board, none that most agree on, all in one
            place, or the laser's plane along the board.
    """
    on_board = [_points(view, found, p) for p, view in enumerate(views)]
    in_cam = [points for points, _ in on_board]
    enough = [p for p, points in enumerate(in_cam) if len(points) >= FEWEST_STRIPE_POINTS]
    if len(enough) < 2:
        raise Refusal(
            "stripe-not-found",
            f"the laser's line lies on the board in {len(enough)} of {len(views)} pictures",
            "one line alone does not fix the laser's plane",
            "let the line cross the board in every picture",
        )
    plane = plane_of_most([in_cam[p] for p in enough])
    _refuse_one_line([in_cam[p] for p in enough], plane)
    _refuse_parallel([found.cameras[p].rotation[:, 2] for p in enough], plane)
    off = np.full(len(views), np.nan)
    of_stretches: list[float] = []
    for p in enough:
        each = in_cam[p] @ plane.normal - plane.offset_mm
        off[p] = float(np.median(each))
        stretch = views[p].stretches(on_board[p][1])
        of_stretches += [abs(float(np.median(each[stretch == k]))) for k in np.unique(stretch)]
    usual = float(np.median(np.abs(off[enough])))
    if usual > max(OFF_MM, OFF_FLATNESSES * views[0].board.flatness_mm):
        raise Refusal(
            "lines-contradict",
            f"the laser's lines of poses {', '.join(map(str, numbers))} lie {usual:.1f} mm off the"
            " plane that suits them best",
            "they do not lie in one plane",
            "check that the laser was not moved against the camera, and that the line seen is"
            " its own and not a reflection",
        )
    return Lines(plane, off, float(np.median(of_stretches)) / 0.6745)


def contradicting_lines(lines: Lines, flatness_mm: float) -> list[int]:
    """Which of the views' lines cannot lie in the plane of the others."""
    seen = np.isfinite(lines.off_mm)
    usual = float(np.median(np.abs(lines.off_mm[seen])))
    limit = max(OFF_MM, OFF_FLATNESSES * flatness_mm, OFF_TIMES * usual)
    return [int(p) for p in np.flatnonzero(seen) if abs(lines.off_mm[p]) > limit]


def _points(view: BoardView, found: Bundle, pose: int) -> tuple[Floats, Floats]:
    """Where a view's line lies on the sheet, (N, 3) in the camera's frame, and its pixels."""
    camera, uv = found.cameras[pose], view.stripe.uv_px
    points = on_sheet(view.board, camera, found.coordinates, uv)
    near = around_pattern(view.board, points)
    return points[near] @ camera.rotation.T + camera.translation_mm, uv[near]


def plane_of_most(per_pose: Sequence[Floats]) -> LaserPlane:
    """The plane of least median distance, of many drawn from three points of two pictures; each
    picture counts alike."""
    rng = np.random.default_rng(0)
    thinned = [points[:: max(1, len(points) // DRAWN_POINTS)] for points in per_pose]
    every = np.concatenate(thinned)
    best, least = LaserPlane(np.array([0.0, 0.0, 1.0]), 0.0), np.inf
    for _ in range(PLANE_DRAWS):
        one, other = rng.choice(len(thinned), 2, replace=False)
        ends = rng.choice(len(thinned[one]), 2, replace=False)
        a, b = thinned[one][ends]
        c = thinned[other][rng.integers(len(thinned[other]))]
        normal = np.cross(b - a, c - a)
        length = float(np.linalg.norm(normal))
        if length < 1e-6:
            continue
        normal = normal / length
        score = float(np.median([np.median(np.abs((p - a) @ normal)) for p in thinned]))
        if score < least:
            best, least = LaserPlane(normal, float(normal @ a)), score
    off = every @ best.normal - best.offset_mm
    near = every[np.abs(off) <= max(AGREEING_TIMES * float(np.median(np.abs(off))), 1e-6)]
    centre = near.mean(axis=0)
    normal = np.linalg.svd(near - centre, full_matrices=False)[2][2]
    normal = normal * np.sign(normal[2] or 1.0)
    return LaserPlane(normal, float(normal @ centre))


def _refuse_one_line(per_pose: Sequence[Floats], plane: LaserPlane) -> None:
    every = np.concatenate(per_pose)
    flat = every - every.mean(axis=0)
    spread = np.linalg.svd(flat - np.outer(flat @ plane.normal, plane.normal), compute_uv=False)
    if spread[1] < LEAST_SPREAD * spread[0]:
        raise Refusal(
            "stripe-one-line",
            "the laser's line lies at one place of its plane in all pictures",
            "one line alone does not fix the laser's plane",
            "take pictures from different distances, or tilted to different sides",
        )


def _refuse_parallel(uprights: Sequence[Floats], plane: LaserPlane) -> None:
    """``uprights`` are the board's normals (3,) in the camera's frame."""
    cosines = np.abs(np.array(uprights) @ plane.normal)
    angle = float(np.median(np.degrees(np.arccos(np.clip(cosines, 0, 1)))))
    if angle < LEAST_LASER_ANGLE_DEG:
        raise Refusal(
            "laser-along-board",
            f"the laser's plane stands {angle:.1f}° to the board (limit"
            f" {LEAST_LASER_ANGLE_DEG:.0f}°)",
            "a plane that is nearly the board's does not meet it in a sharp line",
            "turn the sensor so that the laser falls onto the board from above",
        )
