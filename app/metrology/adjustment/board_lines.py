"""The laser's lines of all pictures against one another: their plane, how far whole lines lie
off it, and which contradict the others."""

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
# A larger share of the lines than this that contradict the others are no mistakes.
MISTAKES_SHARE = 0.2
LEAST_SCATTER_MM = 0.01
PLANE_DRAWS, DRAWN_POINTS = 400, 60
AGREEING_TIMES = 4.0
# Angle between the laser's plane and the board below which their line is not to be trusted.
LEAST_LASER_ANGLE_DEG = 8.0
# Lines spread over the plane by this share of their length at least.
LEAST_SPREAD = 0.02


@dataclass(frozen=True)
class Lines:
    """What the lines of P poses say of the laser's plane before the adjustment.

    ``off_mm`` (P,) is how far each line lies off the plane of most (NaN where there is no
    line). Of those further off than the others explain, ``left_out`` are too few to be more
    than mistakes; ``apart`` are more: the laser moved, nobody knows which of them are right,
    and all count. ``plane`` is that of all that count, in the camera's frame, and
    ``scatter_mm`` the standard deviation by which whole lines lie off it.
    """

    plane: LaserPlane
    off_mm: Floats
    left_out: tuple[int, ...]
    apart: tuple[int, ...]
    scatter_mm: float


def lines_of(views: Sequence[BoardView], found: Bundle, numbers: Sequence[int]) -> Lines:
    """The lines where the pictures put the sheet.

    Raises:
        Refusal: fewer than two lines on the board, none that most agree on, all in one
            place, or the laser's plane along the board.
    """
    in_cam = [_points(view, found, p) for p, view in enumerate(views)]
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
    off = _offsets(in_cam, enough, plane)
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
    out, apart = _contradicting(off, views[0].board.flatness_mm)
    counting = [p for p in enough if p not in out]
    plane = _through([in_cam[p] for p in counting])
    again = _offsets(in_cam, counting, plane)[counting]
    scatter = float(np.sqrt(np.sum(again**2) / max(len(again) - 3, 1)))
    return Lines(plane, off, out, apart, max(scatter, LEAST_SCATTER_MM))


def _offsets(in_cam: Sequence[Floats], poses: Sequence[int], plane: LaserPlane) -> Floats:
    """(P,) median distance of each pose's points from a plane; NaN of other poses."""
    off = np.full(len(in_cam), np.nan)
    for p in poses:
        off[p] = float(np.median(in_cam[p] @ plane.normal - plane.offset_mm))
    return off


def _contradicting(off_mm: Floats, flatness_mm: float) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """Lines that cannot lie in the plane of the others: few enough to leave out, or too many."""
    seen = np.isfinite(off_mm)
    usual = float(np.median(np.abs(off_mm[seen])))
    limit = max(OFF_MM, OFF_FLATNESSES * flatness_mm, OFF_TIMES * usual)
    far = tuple(int(p) for p in np.flatnonzero(seen) if abs(off_mm[p]) > limit)
    return (far, ()) if len(far) <= MISTAKES_SHARE * seen.sum() else ((), far)


def _points(view: BoardView, found: Bundle, pose: int) -> Floats:
    """(N, 3) where a view's line lies on the sheet, in the camera's frame."""
    camera = found.cameras[pose]
    points = on_sheet(view.board, camera, found.coordinates, view.stripe.uv_px)
    points = points[around_pattern(view.board, points)]
    return np.asarray(points @ camera.rotation.T + camera.translation_mm)


def _through(per_pose: Sequence[Floats]) -> LaserPlane:
    """The plane of least squares; each picture counts alike."""
    centre = np.mean([points.mean(axis=0) for points in per_pose], axis=0)
    spread = np.sum([(p - centre).T @ (p - centre) / len(p) for p in per_pose], axis=0)
    normal = np.asarray(np.linalg.eigh(spread)[1][:, 0], dtype=np.float64)
    normal = normal * (np.sign(normal[2]) or 1.0)
    return LaserPlane(normal, float(normal @ centre))


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
