"""The laser lines of all pictures compared with each other: their plane, the offsets of whole lines
from it, and lines that contradict the others."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import message, quantity
from crenel.metrology.adjustment.board.bundle import Bundle
from crenel.metrology.adjustment.board.observations import BoardView, intersect_surface
from crenel.metrology.adjustment.board.straight_line import mask_straight_piece
from crenel.metrology.adjustment.board.surface import around_pattern
from crenel.metrology.adjustment.core.gauss_newton import AdjustmentResult
from crenel.metrology.adjustment.core.observations import AdjustmentProblem
from crenel.metrology.robust import median
from crenel.metrology.sensor.laser_plane import LaserPlane, tangents
from crenel.metrology.transforms import Floats

# Lines of which the laser's plane follows, and points of each.
FEWEST_LINES, FEWEST_STRIPE_POINTS = 2, 20
# A line contradicts the others if it is off by more than this, by more than this multiple of the
# board's flatness, and by more than this number of standard deviations of the lines that agree.
OFF_MM, OFF_FLATNESSES, OFF_TIMES = 0.5, 3.0, 4.0
AGREEING_ROUNDS = 8
# Contradicting lines are excluded if they are at most this share of all lines, or if the others
# agree so closely that chance would cause such an offset less often than this.
MISTAKES_SHARE, CHANCE = 0.2, 1e-3
# Offset (mm) and rotation (rad) of whole lines from their plane: usual values, the factor of one
# standard deviation of these either way, and the values considered, as multiples.
USUAL_SCATTER, USUAL_WITHIN = np.array([0.05, 1e-3]), 5.0
SIZES = np.geomspace(0.1, 100.0, 121)
THROUGH_ROUNDS = 15
PLANE_DRAWS, DRAWN_POINTS = 400, 60
AGREEING_TIMES = 4.0
# Angle between laser plane and board below which a line is not trusted.
LEAST_LASER_ANGLE_DEG = 8.0
# Lines must spread over the plane by at least this share of their length.
LEAST_SPREAD = 0.02


@dataclass(frozen=True)
class LaserLines:
    """The lines of P poses and the laser plane before the adjustment.

    ``off_mm`` (P,) is the distance of each line from the plane of most lines (NaN without a line);
    ``counting`` are the poses whose lines are used. Of the lines that are further off than the
    scatter of the others explains, ``excluded`` are few, or the others agree closely (Student's
    test). ``contradicting`` are the remaining ones, or the last ones of a recording: the position
    of the laser is then unknown, and all lines count.
    ``laser_moved`` says that they are too many to be mistakes, excluded or not. ``plane`` is the
    plane of all lines that count, in the camera frame; ``scatter_mm`` and ``scatter_rad`` are the
    standard deviations of the offset and rotation of whole lines from it. Where no line is to
    count, there is no plane.
    """

    plane: LaserPlane | None
    off_mm: Floats
    counting: tuple[int, ...]
    excluded: tuple[int, ...]
    contradicting: tuple[int, ...]
    laser_moved: bool
    scatter_mm: float
    scatter_rad: float


NO_LINES = LaserLines(None, np.zeros(0), (), (), (), False, 0.0, 0.0)


def fit_laser_lines(
    views: Sequence[BoardView], found: Bundle, numbers: Sequence[int]
) -> LaserLines:
    """The lines at the positions where the pictures put the surface of the board.

    Raises:
        OperationError: fewer than two lines on the board, no plane that most
            agree on, all lines in one place, or a laser plane along the board.
    """
    in_cam = [_line_points(view, found, p) for p, view in enumerate(views)]
    enough = [p for p, points in enumerate(in_cam) if len(points) >= FEWEST_STRIPE_POINTS]
    refuse_few_lines(len(enough), len(views))
    plane = fit_majority_plane([in_cam[p] for p in enough])
    _refuse_one_line([in_cam[p] for p in enough], plane)
    _refuse_parallel([found.cameras[p].rotation[:, 2] for p in enough], plane)
    off = _offsets(in_cam, enough, plane)
    usual = median(np.abs(off[enough]))
    if usual > _least_off_mm(views[0].board.flatness_mm):
        raise OperationError(
            "lines-contradict",
            message(
                "laser-lines-off-their-plane",
                poses=", ".join(map(str, numbers)),
                usual=quantity(usual, "mm", 1),
            ),
            message("they-do-not-lie-in-one-plane"),
            message("check-laser-not-moved-and-no-reflection"),
        )
    off, out, apart = _find_contradictions(in_cam, enough, plane, views[0].board.flatness_mm)
    counting = [p for p in enough if p not in out]
    moved = not _is_minority([*out, *apart], enough)
    plane, (scatter_mm, scatter_rad) = _fit_plane_and_scatter([in_cam[p] for p in counting], moved)
    return LaserLines(plane, off, tuple(counting), out, apart, moved, scatter_mm, scatter_rad)


def refuse_few_lines(lines: int, pictures: int) -> None:
    """Refuses pictures of which too few show a line on the board; raises ``OperationError``."""
    if lines >= FEWEST_LINES:
        return
    raise OperationError(
        "stripe-not-found",
        message("lasers-line-lies-board-pictures", enough=lines, views=pictures),
        message("plane-needs-lines", fewest=FEWEST_LINES),
        message("let-line-cross-board-in-more-pictures", more=FEWEST_LINES - lines),
    )


def _least_off_mm(flatness_mm: float) -> float:
    """Distances that contradict nothing."""
    return max(OFF_MM, OFF_FLATNESSES * flatness_mm)


def _is_minority(far: Sequence[int], seen: Sequence[int]) -> bool:
    """Whether lines are so few among all lines that they are mistakes."""
    return len(far) <= MISTAKES_SHARE * len(seen)


def _offsets(in_cam: Sequence[Floats], poses: Sequence[int], plane: LaserPlane) -> Floats:
    """(P,) median distance of each pose's points from a plane; NaN for other poses."""
    off = np.full(len(in_cam), np.nan)
    for p in poses:
        off[p] = median(in_cam[p] @ plane.normal - plane.offset_mm)
    return off


def _find_contradictions(
    in_cam: Sequence[Floats], seen: Sequence[int], plane: LaserPlane, flatness_mm: float
) -> tuple[Floats, tuple[int, ...], tuple[int, ...]]:
    """Distance of each line from the plane of the lines that agree (P,), and the lines that cannot
    lie in it: few enough to exclude, or too many.

    Starting with the better half of the lines, the plane is fitted to those that agree with it. How
    closely they agree follows from their offsets and rotations, in their usual proportion.
    """
    from scipy.special import stdtrit  # slow to import, and needed for boards only

    off = _offsets(in_cam, seen, plane)
    agreeing = sorted(seen, key=lambda p: abs(float(off[p])))[: len(seen) // 2 + 1]
    for _ in range(AGREEING_ROUNDS):
        before = set(agreeing)
        through = [in_cam[p] for p in agreeing]
        plane = _least_squares_plane(through)
        off = _offsets(in_cam, seen, plane)
        free = max(2 * len(agreeing) - 3, 1)
        square = float(np.sum((_off_plane(through, plane)[0] / USUAL_SCATTER) ** 2))
        usual = float(USUAL_SCATTER[0] * np.sqrt(square / free))
        limit = max(_least_off_mm(flatness_mm), OFF_TIMES * usual)
        agreeing = [p for p in seen if abs(float(off[p])) <= limit]
        if set(agreeing) == before:
            break
    far = tuple(p for p in seen if p not in agreeing)
    if _is_minority(far, seen):
        return off, far, ()
    expected = usual * _prediction_factors(through, [in_cam[p] for p in far], plane)
    clear = np.abs(off[list(far)]) > stdtrit(free, 1 - CHANCE / 2) * expected
    last = far == tuple(seen[-len(far) :])  # the laser may still be in this position
    left_out = 2 * len(far) < len(seen) and bool(clear.all()) and not last
    return (off, far, ()) if left_out else (off, (), far)


def _prediction_factors(
    agreeing: Sequence[Floats], others: Sequence[Floats], plane: LaserPlane
) -> Floats:
    """(K,) prediction of the offset of each other line by a plane through the lines that agree: its
    standard deviation as a multiple of theirs."""
    by_plane = _off_plane(agreeing, plane)[1] * (USUAL_SCATTER[0] / USUAL_SCATTER)[:, None]
    C = np.linalg.inv(np.einsum("lki,lkj->ij", by_plane, by_plane))
    place = _off_plane(others, plane)[1][:, 0]
    return np.asarray(np.sqrt(1 + np.einsum("li,ij,lj->l", place, C, place)))


def _line_points(view: BoardView, found: Bundle, pose: int) -> Floats:
    """(N, 3) points of the straight piece of a view's line on the surface, in the camera frame."""
    camera = found.cameras[pose]
    points = intersect_surface(view.board, camera, found.coordinates, view.stripe.uv_px)
    points = points[around_pattern(view.board, points)]
    points = points[mask_straight_piece(points, _least_off_mm(view.board.flatness_mm))]
    return np.asarray(points @ camera.rotation.T + camera.translation_mm)


def _fit_plane_and_scatter(per_pose: Sequence[Floats], moved: bool) -> tuple[LaserPlane, Floats]:
    """The plane that fits all lines best, each with its own offset and rotation, and the standard
    deviations of these (mm, rad), estimated from the lines themselves.

    A laser that ``moved`` also turned, so that the ends of its lines are as far off as their
    middles: no direction is then trusted more than the offsets.
    """
    plane = _least_squares_plane(per_pose)
    scatter = USUAL_SCATTER
    half_mm = median([_half_length(points) for points in per_pose])
    for _ in range(THROUGH_ROUNDS):
        off, by_plane = _off_plane(per_pose, plane)  # (L, 2), (L, 2, 3)
        weight = scatter**-2.0
        C = np.linalg.inv(np.einsum("lki,k,lkj->ij", by_plane, weight, by_plane))
        step = -C @ np.einsum("lki,k,lk->i", by_plane, weight, off)
        left = off + by_plane @ step
        fitted = np.einsum("lki,ij,lkj->k", by_plane, C, by_plane) * weight
        scatter = _estimate_scatter(np.sum(left**2, axis=0), len(off) - fitted)
        if moved:
            scatter[1] = max(scatter[1], scatter[0] / half_mm)
        plane = plane.apply_step(step)
    return plane, scatter


def line_scatter(found: AdjustmentResult) -> Floats:
    """Assumed standard deviations (mm, rad) of whole lines from their plane."""
    view = next(view for view in found.problem.views if isinstance(view, BoardView))
    return np.array([view.line_off_mm, view.line_off_rad])


def with_line_scatter(problem: AdjustmentProblem, scatter: Floats) -> AdjustmentProblem:
    """The problem with these standard deviations (mm, rad) of whole lines from their plane."""
    off_mm, off_rad = scatter.tolist()
    views = [
        replace(view, line_off_mm=off_mm, line_off_rad=off_rad)
        for view in problem.views
        if isinstance(view, BoardView)
    ]
    return replace(problem, views=tuple(views))


def estimate_line_scatter(found: AdjustmentResult) -> Floats:
    """The same two standard deviations (mm, rad) after an adjustment in which the lines also
    contributed to the bend of the board: residual offset and rotation of each line, compared with
    the part that the adjustment did not determine (Foerstner)."""
    square, free = np.zeros(2), np.zeros(2)
    for scene, (_, rows), (_, judgement) in zip(
        found.linear.scenes, found.linear.rows, found.weights, strict=True
    ):
        if rows.shared is None:
            continue
        kept = judgement.inliers
        own = np.linalg.pinv(rows.shared[kept])  # in standard deviations
        J = own @ rows.jacobian[kept] @ scene.by_unknowns
        square += (own @ rows.residuals[kept]) ** 2
        free += np.maximum(1 - np.einsum("ku,uw,kw->k", J, found.covariance, J), 0.0)
    return _estimate_scatter(square * line_scatter(found) ** 2, free)


def _estimate_scatter(squares: Floats, free: Floats) -> Floats:
    """The standard deviation (mm, rad) of values with the sums of squares ``squares`` (2,) and
    ``free`` (2,) degrees of freedom.

    A sensor at rest scatters far less than usual, a moving laser far more: before any data, only
    the order of magnitude is known (a log-normal prior). The expected logarithm is returned, so
    that one or two lines stay near the usual value.
    """
    sizes = SIZES[:, None] * USUAL_SCATTER
    by_usual = -((np.log(SIZES) / np.log(USUAL_WITHIN)) ** 2)[:, None] / 2
    log = by_usual - free * np.log(sizes) - squares / (2 * sizes**2)
    weight = np.exp(log - log.max(axis=0))
    return np.asarray(np.exp(np.sum(weight * np.log(sizes), axis=0) / weight.sum(axis=0)))


def _half_length(points_mm: Floats) -> float:
    """Distance from the middle of a line (N, 3) at which its points have the same weight as all
    together."""
    away = points_mm - points_mm.mean(axis=0)
    return float(np.sqrt(np.mean(np.sum(away**2, axis=1))))


def _off_plane(per_pose: Sequence[Floats], plane: LaserPlane) -> tuple[Floats, Floats]:
    """Distance (mm) of each line's middle from a plane and rotation (rad) of the line out of it (L,
    2), and their derivatives by the plane's tilts and offset (L, 2, 3)."""
    off, by_plane = [], []
    for points in per_pose:
        middle = points.mean(axis=0)
        along = np.linalg.svd(points - middle, full_matrices=False)[2][0]
        off.append([middle @ plane.normal - plane.offset_mm, along @ plane.normal])
        across = tangents(plane.normal)
        by_plane.append([[*(across @ middle), -1.0], [*(across @ along), 0.0]])
    return np.array(off), np.array(by_plane)


def _least_squares_plane(per_pose: Sequence[Floats]) -> LaserPlane:
    """Weights such that each picture counts equally."""
    centre = np.mean([points.mean(axis=0) for points in per_pose], axis=0)
    spread = np.sum([(p - centre).T @ (p - centre) / len(p) for p in per_pose], axis=0)
    normal = np.asarray(np.linalg.eigh(spread)[1][:, 0], dtype=np.float64)
    normal = normal * (np.sign(normal[2]) or 1.0)
    return LaserPlane(normal, float(normal @ centre))


def fit_majority_plane(per_pose: Sequence[Floats]) -> LaserPlane:
    """The plane of least median distance, among many planes through three points of two pictures;
    each picture counts equally."""
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
        score = median([median(np.abs((p - a) @ normal)) for p in thinned])
        if score < least:
            best, least = LaserPlane(normal, float(normal @ a)), score
    off = every @ best.normal - best.offset_mm
    near = every[np.abs(off) <= max(AGREEING_TIMES * median(np.abs(off)), 1e-6)]
    centre = near.mean(axis=0)
    normal = np.linalg.svd(near - centre, full_matrices=False)[2][2]
    normal = normal * np.sign(normal[2] or 1.0)
    return LaserPlane(normal, float(normal @ centre))


def _refuse_one_line(per_pose: Sequence[Floats], plane: LaserPlane) -> None:
    every = np.concatenate(per_pose)
    flat = every - every.mean(axis=0)
    spread = np.linalg.svd(flat - np.outer(flat @ plane.normal, plane.normal), compute_uv=False)
    if spread[1] < LEAST_SPREAD * spread[0]:
        raise OperationError(
            "stripe-one-line",
            message("lasers-line-lies-one-place-plane"),
            message("one-line-alone-does-fix-lasers"),
            message("take-pictures-different-distances-tilted-different"),
        )


def _refuse_parallel(uprights: Sequence[Floats], plane: LaserPlane) -> None:
    """``uprights`` are the board's normals (3,) in the camera's frame."""
    cosines = np.abs(np.array(uprights) @ plane.normal)
    angle = median(np.degrees(np.arccos(np.clip(cosines, 0, 1))))
    if angle < LEAST_LASER_ANGLE_DEG:
        raise OperationError(
            "laser-along-board",
            message(
                "lasers-plane-stands-board-limit",
                angle=quantity(angle, "°", 1),
                least_laser_angle_deg=quantity(LEAST_LASER_ANGLE_DEG, "°"),
            ),
            message("laser-plane-does-not-cross-board-sharply"),
            message("turn-sensor-so-laser-falls-onto"),
        )
