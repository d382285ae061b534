"""The laser plane from a stripe on the levels of the block."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.metrology.robust import sigma_from_median
from crenel.metrology.sensor.camera import Camera, rays
from crenel.metrology.sensor.laser_plane import LaserPlane, meet_levels, refuse_edge_on
from crenel.metrology.stripe import (
    ANYWHERE,
    LaserAlone,
    LineSearch,
    Stripe,
    concatenate_stripes,
)
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.transforms import Floats

# Stripe points closer than this to an edge of their face may mix light from both sides.
EDGE_MARGIN_PX = 6.0
# Minimum number of points on each level, and minimum angle between line of sight and laser plane.
FEWEST_ON_A_LEVEL = 20
# The level of pixels is looked up once per square of this many pixels.
LEVEL_STEP_PX = 4
# Points with residuals beyond this many standard deviations are not light of the direct stripe.
OUTLIER_SIGMAS = 4.0


@dataclass(frozen=True)
class LaserPlaneFit:
    """The plane, and the use of each stripe point (N,).

    ``level`` is ``crest``, ``floor`` or empty where the point lies on neither, and
    ``points_mm`` (N, 3) is where on the level its ray ends, NaN elsewhere;
    ``used`` marks those of a level that agree with the plane; ``residuals_mm`` are
    their signed distances from it, NaN off the levels; ``rms_px`` is as seen in the image.
    """

    plane: LaserPlane
    rms_mm: float
    used: NDArray[np.bool_]
    level: NDArray[np.str_]
    points_mm: Floats
    residuals_mm: Floats
    rms_px: float


def classify_levels(
    camera: Camera, block: Crenellated, uv_px: Floats
) -> tuple[NDArray[np.str_], Floats]:
    """The level of the block that the camera sees at each pixel, and the point on it.

    Args:
        camera: with the sensor frame equal to the object frame.
        block: the block by its certificate.
        uv_px: (N, 2) distorted pixels.

    Returns:
        (N,) ``crest`` or ``floor`` where the ray of the pixel meets that face first, at least
        ``EDGE_MARGIN_PX`` from its edges, otherwise empty; and (N, 3) mm in the object frame, NaN
        if the level is empty.
    """
    origin, along = rays(camera, uv_px)
    margin_share = EDGE_MARGIN_PX / float(min(camera.matrix[0, 0], camera.matrix[1, 1]))
    edges = np.asarray(block.edges_x_mm)
    entry_x = _entry_x(block, origin, along)
    level = np.full(len(along), "", dtype="<U5")
    points = np.full((len(along), 3), np.nan)
    for name, z, left, right in (
        ("crest", block.crest_z_mm, edges[0::2], edges[1::2]),
        ("floor", block.floor_z_mm, edges[1:-1:2], edges[2::2]),
    ):
        hit = meet_levels(camera, uv_px, z)
        margin = margin_share * np.linalg.norm(hit - origin, axis=1)
        inside = (along[:, 2] * (z - origin[2]) > 0) & (origin[2] > z)
        inside &= hit[:, 1] > block.front_y_mm + margin
        inside &= hit[:, 1] < block.back_y_mm - margin
        # a ray into a groove must clear the merlons on both sides of it
        nearest, furthest = hit[:, 0], hit[:, 0]
        if name == "floor":
            nearest, furthest = np.minimum(nearest, entry_x), np.maximum(furthest, entry_x)
        between = (nearest[:, None] > left + margin[:, None]) & (
            furthest[:, None] < right - margin[:, None]
        )
        inside &= between.any(axis=1)
        level[inside], points[inside] = name, hit[inside]
    return level, points


def stripe_on_levels(
    camera: Camera,
    block: Crenellated,
    picture: LaserAlone,
    axis: str,
    search: LineSearch = ANYWHERE,
) -> Stripe:
    """The stripe on the crests, then on the floors, each extracted separately.

    One peak per column is not sufficient if the camera is rotated relative to the stripe: a column
    may then cross a crest and a floor. Table and walls are excluded.

    Args:
        camera: with the sensor frame equal to the object frame.
        block: the block by its certificate.
        picture: (H, W) with the stripe on it.
        axis: as in ``extract_stripe``.
        search: what is said of the line.

    Returns:
        Points of both levels, with heights in grey levels; none if the picture shows no stripe on
        the block.

    Raises:
        OperationError: as ``extract_stripe``.
    """
    height, width = picture.image.shape
    rows, columns = np.mgrid[0:height:LEVEL_STEP_PX, 0:width:LEVEL_STEP_PX]
    coarse = np.column_stack([columns.ravel(), rows.ravel()]) + (LEVEL_STEP_PX - 1) / 2
    level = classify_levels(camera, block, coarse)[0].reshape(rows.shape)
    level = level.repeat(LEVEL_STEP_PX, axis=0).repeat(LEVEL_STEP_PX, axis=1)[:height, :width]
    found = [search.extract(picture, axis, level == name) for name in ("crest", "floor")]
    return picture.in_levels(concatenate_stripes(found))


def _entry_x(block: Crenellated, origin: Floats, along: Floats) -> Floats:
    """x (N,) at which rays enter the block's bounding box, through its top, front or back."""
    with np.errstate(divide="ignore", invalid="ignore"):
        to_top = (block.crest_z_mm - origin[2]) / along[:, 2]
        at_y = np.where(along[:, 1] > 0, block.front_y_mm, block.back_y_mm)
        to_side = (at_y - origin[1]) / along[:, 1]
    return np.asarray(origin[0] + np.fmax(to_top, to_side) * along[:, 0])


def fit_laser_plane(
    camera: Camera, block: Crenellated, stripe: Stripe, plane: LaserPlane | None = None
) -> LaserPlaneFit:
    """The laser plane through the points of the stripe on crests and floors.

    The ray of each point is intersected with the level that it hits; one plane is fitted to both
    levels, weighted by the standard deviations of the points. Reflections inside the grooves, and
    the stripe on walls and table, are excluded.

    Args:
        camera: with the sensor frame equal to the object frame.
        block: the block by its certificate.
        stripe: from ``stripe_on_levels``.
        plane: a known plane (from ``fit_camera``): the points are judged against it, and it is
            returned unchanged.

    Returns:
        The plane in the object frame, and the residual of each point.

    Raises:
        OperationError: ``stripe-too-short``, ``laser-one-level`` or ``laser-through-camera``.
    """
    level, points = classify_levels(camera, block, stripe.uv_px)
    on = level != ""
    X, own = points[on], level[on]
    _require_both(own, len(on))
    per_px = _shift_per_pixel(camera, stripe, on, X)
    per_sigma = per_px * stripe.sigma_px[on, None]
    if plane is None:
        plane = _refine_plane(_least_median_plane(X, own, per_sigma), X, per_sigma)
    kept = _agreeing(plane, X, per_sigma)
    _require_both(own[kept], len(on))
    refuse_edge_on(plane, X[kept] - camera.centre_mm)
    residuals = X @ plane.normal - plane.offset_mm
    used = on.copy()
    used[on] = kept
    over_all = np.full(len(on), np.nan)
    over_all[on] = residuals
    return LaserPlaneFit(
        plane,
        float(np.sqrt(np.mean(residuals[kept] ** 2))),
        used,
        level,
        points,
        over_all,
        float(np.sqrt(np.mean((residuals[kept] / (per_px[kept] @ plane.normal)) ** 2))),
    )


def agreeing_levels(
    camera: Camera, block: Crenellated, stripe: Stripe, plane: LaserPlane
) -> NDArray[np.str_]:
    """The level (N,) of each stripe point that agrees with a known plane, otherwise empty."""
    level, points = classify_levels(camera, block, stripe.uv_px)
    on = level != ""
    if on.any():
        per_sigma = _shift_per_pixel(camera, stripe, on, points[on]) * stripe.sigma_px[on, None]
        level[np.flatnonzero(on)[~_agreeing(plane, points[on], per_sigma)]] = ""
    return level


def _require_both(level: NDArray[np.str_], found: int) -> None:
    """Refuses a stripe that does not show enough of crests and floors."""
    count = {name: int(np.sum(level == name)) for name in ("crest", "floor")}
    if min(count.values()) >= FEWEST_ON_A_LEVEL:
        return
    if max(count.values()) < FEWEST_ON_A_LEVEL:
        raise OperationError(
            "stripe-too-short",
            message(
                "points-laser-stripe-lie-object-levels",
                points=sum(count.values()),
                found=found,
                least=FEWEST_ON_A_LEVEL,
            ),
            message("laser-off-too-weak-does-cross"),
            message("check-laser-exposure-sensors-stripe-axis"),
        )
    missing = min(count, key=lambda name: count[name])
    raise OperationError(
        "laser-one-level",
        message("laser-stripe-shows-points-s", count=count[missing], missing=missing),
        message("stripe-one-level-alone-does-fix"),
        message("place-sensor-so-stripe-crosses-crests"),
    )


def _shift_per_pixel(
    camera: Camera, stripe: Stripe, on: NDArray[np.bool_], points: Floats
) -> Floats:
    """Motion of the points (n, 3) on their level, in mm, for one pixel across the stripe."""
    uv, z = stripe.uv_px[on], points[:, 2]
    ahead = meet_levels(camera, uv + 0.5 * stripe.across, z)
    return ahead - meet_levels(camera, uv - 0.5 * stripe.across, z)


def _least_median_plane(points: Floats, level: NDArray[np.str_], per_sigma: Floats) -> LaserPlane:
    """The plane of least median residual on both levels, among many planes through three points.

    Correct if more than half of the points of each level are the direct stripe.
    """
    rng = np.random.default_rng(0)
    own = {name: np.flatnonzero(level == name) for name in ("crest", "floor")}
    chosen = []
    for draw in range(300):
        pair, single = ("crest", "floor") if draw % 2 else ("floor", "crest")
        chosen.append([*rng.choice(own[pair], 2, replace=False), rng.choice(own[single])])
    first, second, third = points[np.array(chosen).T]
    normals = np.cross(second - first, third - first)
    length = np.linalg.norm(normals, axis=1)
    sound = length >= 1e-6
    if not sound.any():
        return LaserPlane(np.array([0.0, 1.0, 0.0]), 0.0)
    normals = normals[sound] / length[sound, None]
    offsets = (first[sound] * normals).sum(axis=1)
    off = np.abs(normals @ points.T - offsets[:, None])
    off /= np.maximum(np.abs(normals @ per_sigma.T), 1e-9)
    best = int(np.argmin(sum(np.median(off[:, rows], axis=1) for rows in own.values())))
    return LaserPlane(normals[best], float(offsets[best]))


def _agreeing(plane: LaserPlane, points: Floats, per_sigma: Floats) -> NDArray[np.bool_]:
    """Points (n,) within the limit, measured by their own scatter if that is larger."""
    off = points @ plane.normal - plane.offset_mm
    off /= np.maximum(np.abs(per_sigma @ plane.normal), 1e-9)
    spread = max(sigma_from_median(np.abs(off)), 1.0)
    return np.asarray(np.abs(off) < OUTLIER_SIGMAS * spread)


def _refine_plane(plane: LaserPlane, points: Floats, per_sigma: Floats) -> LaserPlane:
    """Weighted least squares on the points that agree."""
    before = np.zeros(len(points), dtype=np.bool_)
    for _ in range(20):
        kept = _agreeing(plane, points, per_sigma)
        if np.array_equal(kept, before):
            break
        before = kept
        weight = np.maximum(np.abs(per_sigma[kept] @ plane.normal), 1e-9) ** -2.0
        centre = weight @ points[kept] / weight.sum()
        spread_out = (points[kept] - centre) * np.sqrt(weight)[:, None]
        normal = np.linalg.svd(spread_out, full_matrices=False)[2][2]
        normal *= np.sign(normal @ plane.normal)
        plane = LaserPlane(normal, float(normal @ centre))
    return plane
