"""The plane or sphere gauge in a scanned cloud: detected, fitted and checked for completeness."""

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import KDTree

from crenel.errors import OperationError
from crenel.gauges.quick.maths.errors import NominalSphere
from crenel.gauges.quick.maths.figure_uncertainty import rms_sd, zone_sd
from crenel.gauges.quick.maths.gauge_gate import UnfilteredForm, plane_form, sphere_form
from crenel.messages.limits import beside_limit
from crenel.messages.message import message, quantity, rounded
from crenel.metrology.fitting.plane_sphere import PlaneFit, SphereFit, draw_samples, finite_points
from crenel.metrology.fitting.shape import MeasuredShape, measure_shape
from crenel.metrology.transforms import Floats

LEAST_POINTS = 500
LEAST_WIDTH_MM = 8.0
"""Minimum width of a plane's cloud in its narrower direction (four standard deviations)."""
LEAST_CAP_RAD = float(np.deg2rad(35.0))
"""Minimum angle of a sphere's cloud, from its middle to its rim."""
ROUGHEST_MM = 0.5
"""Rms of a cloud about its shape above which it is not of that shape."""
OTHER_RADIUS_MM, OTHER_RADIUS_SHARE = 0.4, 0.03
"""A radius that is off by this belongs to another sphere."""
NEAR_MM = 1.0
NEIGHBOURHOOD = 2.5
"""Radii about the nominal centre within which a sphere is looked for first."""
SAME_PLACE_MM = 0.05
SHARE_IN_ZONE = 0.95


@dataclass(frozen=True)
class GaugeCloud:
    """The part of a cloud that belongs to the gauge."""

    shape: MeasuredShape
    points: int
    """Number of points in the cloud, whatever they show."""
    used: int
    form_mm: float
    """Width of the narrowest zone about the shape that holds 95 % of the points used."""
    unfiltered: UnfilteredForm
    """The form of all points of the geometric gate."""
    points_mm: Floats
    """(N, 3) points of the fit, arm frame."""
    gate_mm: Floats
    """(M, 3) all points of the geometric gate."""
    gate_frame: NDArray[np.int64]
    """(M,) their frames."""
    rms_sd_mm: float
    """Standard uncertainty of the rms, k = 1, by the scatter of the points."""
    form_sd_mm: float
    width_mm: float | None = None
    """The width of a plane's cloud in its narrower direction."""


def fit_gauge_plane(
    points_mm: Floats, frame: NDArray[np.int64], seen_from_mm: Floats | None = None
) -> GaugeCloud:
    """The plane gauge in a scanned cloud.

    Frames at the position of an earlier frame are excluded, so that a pause of the operator has no
    weight.

    Args:
        points_mm: (N, 3), arm frame; NaN points are never used.
        frame: (N,) frame number of each point, in order of time.
        seen_from_mm: (3,) a place of the sensor, on the outside of the plane.

    Returns:
        The fitted plane with its covariance (k = 1), and the width of the zone that contains
        95 % of the points used, and of all points in the gate.

    Raises:
        OperationError: ``too-few-points``, ``points-on-a-line``; ``cloud-too-small``, also for a
            strip that is too narrow; ``another-gauge``.
    """
    points, frames = _usable(points_mm, frame)
    found = measure_shape("plane", points, frames, seen_from_mm)
    assert isinstance(found.fit, PlaneFit)
    _refuse_rough(found.fit.rms_mm, "plane")
    inside = points[found.fit.used]
    width = plane_width_mm(inside)
    if width < LEAST_WIDTH_MM:
        raise OperationError(
            "cloud-too-small",
            message("cloud-strip-wide", width=quantity(width, "mm", 1)),
            message("plane-needs-both-directions", width=rounded(LEAST_WIDTH_MM, "mm")),
            message("pass-over-more-gauge"),
        )
    all_points, finite = finite_points(points_mm, 4, "gauge")
    unfiltered = plane_form(all_points, found.fit, inside)
    gate = (all_points[unfiltered.inside], frame[finite][unfiltered.inside])
    return _assemble_cloud(found, points, len(points_mm), unfiltered, gate, width)


def fit_gauge_sphere(points_mm: Floats, frame: NDArray[np.int64], radius_mm: float) -> GaugeCloud:
    """The sphere gauge of known radius in a scanned cloud, which may also show other things.

    Frames at the position of an earlier frame are excluded, so that a pause of the operator has no
    weight.

    Args:
        points_mm: (N, 3), arm frame; NaN points are never used.
        frame: (N,) frame number of each point, in order of time.
        radius_mm: from the certificate; it is used to detect the sphere, not for the fit.

    Returns:
        The fitted sphere with its covariance (k = 1), and the width of the zone that contains
        95 % of the points used, and of all points in the gate.

    Raises:
        OperationError: ``too-few-points``; ``cloud-too-small``, also for a cap that is too small;
            ``another-gauge``.
    """
    points, frames = _usable(points_mm, frame)
    near = _near_sphere(points, radius_mm)
    if int(near.sum()) < LEAST_POINTS:
        raise _no_sphere_error(radius_mm)
    points, frames = points[near], frames[near]
    try:
        found = measure_shape("sphere", points, frames)
    except OperationError as refusal:
        raise _no_sphere_error(radius_mm) from refusal
    fit = found.fit
    assert isinstance(fit, SphereFit)
    if sphere_is_other(fit.radius_mm, radius_mm):
        raise OperationError(
            "another-gauge",
            message("scanned-sphere-has-diameter", diameter=quantity(2 * fit.radius_mm, "mm", 2)),
            message("chosen-gauge-has", diameter=quantity(2 * radius_mm, "mm", 2)),
            message("choose-gauge-scanned"),
        )
    cap = cap_angle_rad(points[fit.used], fit.centre_mm)
    if cap < LEAST_CAP_RAD:
        raise OperationError(
            "cloud-too-small",
            message("cloud-shows-cap-sphere", angle=quantity(np.rad2deg(cap), "°")),
            message("least-middle-needed", angle=quantity(np.rad2deg(LEAST_CAP_RAD), "°")),
            message("pass-over-several-sides"),
        )
    _refuse_rough(fit.rms_mm, "sphere")
    all_points, finite = finite_points(points_mm, 4, "gauge")
    unfiltered = sphere_form(all_points, fit, radius_mm)
    gate = (all_points[unfiltered.inside], frame[finite][unfiltered.inside])
    return _assemble_cloud(found, points, len(points_mm), unfiltered, gate)


def find_spheres(points_mm: Floats, nominal: NominalSphere) -> Iterator[NDArray[np.bool_]]:
    """Where a sphere of known radius may be in a cloud that shows larger things too.

    Args:
        points_mm: (N, 3) without NaN.
        nominal: the sphere is looked for about its centre first, then everywhere.

    Returns:
        (N,) the points near the sphere on which most lie, for each of the places.
    """
    away = np.linalg.norm(points_mm - nominal.centre_mm, axis=1)
    about = away < NEIGHBOURHOOD * nominal.radius_mm
    for part in (about, np.ones(len(points_mm), dtype=np.bool_)):
        if int(part.sum()) < LEAST_POINTS:
            continue
        found = np.zeros(len(points_mm), dtype=np.bool_)
        with suppress(OperationError):
            found[part] = _near_sphere(points_mm[part], nominal.radius_mm)
            yield found


def sphere_is_other(radius_mm: float, nominal_mm: float) -> bool:
    """Whether a radius is too far off its nominal to be of the same sphere."""
    return abs(radius_mm - nominal_mm) > max(OTHER_RADIUS_MM, OTHER_RADIUS_SHARE * nominal_mm)


def plane_width_mm(points_mm: Floats) -> float:
    """Width of a plane's points (N, 3) in their narrower direction: four standard deviations."""
    return 4 * float(np.sqrt(max(np.linalg.eigvalsh(np.cov(points_mm.T))[1], 0.0)))


def cap_angle_rad(points_mm: Floats, centre_mm: Floats) -> float:
    """Angle of the cap of a sphere that its points (N, 3) cover, from its middle to its rim."""
    outward = points_mm - centre_mm
    outward /= np.linalg.norm(outward, axis=1)[:, None]
    middle = outward.mean(axis=0)
    length = max(float(np.linalg.norm(middle)), 1e-9)
    return float(np.quantile(np.arccos(np.clip(outward @ middle / length, -1, 1)), 0.98))


def _assemble_cloud(
    found: MeasuredShape,
    points: Floats,
    of: int,
    unfiltered: UnfilteredForm,
    gate: tuple[Floats, NDArray[np.int64]],
    width_mm: float | None = None,
) -> GaugeCloud:
    off = found.distances(points[found.fit.used])
    parameters = 3 if isinstance(found.fit, PlaneFit) else 4
    return GaugeCloud(
        found,
        of,
        len(off),
        zone_mm(off),
        unfiltered,
        points,
        *gate,
        rms_sd(off, parameters),
        zone_sd(off, zone_mm),
        width_mm,
    )


def zone_mm(off_mm: Floats) -> float:
    """Width of the narrowest zone that contains 95 % of the distances.

    Args:
        off_mm: (N,) signed distances from the shape, N >= 1.

    Source:
        Like ``D95%`` of ISO 10360-8.

    Example:
        >>> zone_mm(np.array([*np.linspace(0.0, 1.0, 95), 9.0, 9.0, 9.0, 9.0, 9.0]))
        1.0
    """
    ordered = np.sort(off_mm)
    held = max(int(np.ceil(SHARE_IN_ZONE * len(ordered))), 1)
    return float(np.min(ordered[held - 1 :] - ordered[: len(ordered) - held + 1]))


def _usable(points_mm: Floats, frame: NDArray[np.int64]) -> tuple[Floats, NDArray[np.int64]]:
    points, finite = finite_points(points_mm, 4, "gauge")
    frames = frame[finite]
    once = _first_visits(points, frames)
    points, frames = points[once], frames[once]
    if len(points) < LEAST_POINTS:
        raise OperationError(
            "cloud-too-small",
            message("cloud-has-points", points=len(points)),
            message("least-needed", least=LEAST_POINTS),
            message("pass-stripe-slowly-over-gauge"),
        )
    return points, frames


def _first_visits(points: Floats, frame: NDArray[np.int64]) -> NDArray[np.bool_]:
    """(N,) the points of frames at positions where no earlier frame was.

    If the operator rests at the end of a pass, that one line would have more weight than everything
    passed before. The position of a frame is given by the means of the two halves of its points.
    """
    order = np.argsort(frame, kind="stable")
    _, first, of, count = np.unique(
        frame[order], return_index=True, return_inverse=True, return_counts=True
    )
    half = 2 * (np.arange(len(order)) - first[of]) // count[of]
    group = 2 * of + half
    held = np.maximum(np.bincount(group, minlength=2 * len(count)), 1)
    sums = [np.bincount(group, points[order, axis], 2 * len(count)) for axis in range(3)]
    place = (np.stack(sums, axis=1) / held[:, None]).reshape(len(count), 6)
    _, kept = np.unique(np.floor(place / SAME_PLACE_MM), axis=0, return_index=True)
    once = np.zeros(len(frame), dtype=np.bool_)
    once[order] = np.isin(of, kept)
    return once


def _refuse_rough(rms_mm: float, shape: str) -> None:
    if rms_mm > ROUGHEST_MM:
        rms, roughest = beside_limit(rms_mm, ROUGHEST_MM, "mm", 2)
        raise OperationError(
            "another-gauge",
            message("cloud-no-points-lie-rms-off", shape=shape, rms=rms),
            message("up-to-taken-one", rms=roughest),
            message("scan-gauge-chosen-nothing-beside"),
        )


def _near_sphere(points: Floats, radius_mm: float) -> NDArray[np.bool_]:
    """(N,) the points near the sphere of this radius on which most points lie.

    Every three points have two spheres of a given radius through them. Three points within a radius
    of each other belong to the sphere together far more often than three arbitrary ones.
    """
    sample, seeds = draw_samples(points, 1)
    rng = np.random.default_rng(0)
    about = KDTree(sample).query_ball_point(seeds[:, 0], radius_mm)
    threes = sample[[[*rng.choice(near, 3)] for near in about]]
    a, b, c = threes[:, 0], threes[:, 1], threes[:, 2]
    u, v = b - a, c - a
    normal = np.cross(u, v)
    area = np.sum(normal**2, axis=1)
    proper = area > 1e-6
    a, u, v, normal, area = a[proper], u[proper], v[proper], normal[proper], area[proper]
    to_middle = (
        np.sum(u**2, axis=1)[:, None] * np.cross(v, normal)
        - np.sum(v**2, axis=1)[:, None] * np.cross(u, normal)
    ) / (2 * area[:, None])
    rise2 = radius_mm**2 - np.sum(to_middle**2, axis=1)
    fits = rise2 > 0
    if not fits.any():
        raise _no_sphere_error(radius_mm)
    rise = np.sqrt(rise2[fits] / area[fits])[:, None] * normal[fits]
    middles = a[fits] + to_middle[fits]
    centres = np.concatenate([middles + rise, middles - rise])
    tolerance = 0.25 * NEAR_MM
    within = [
        int(np.sum(np.abs(np.linalg.norm(sample - one, axis=1) - radius_mm) < tolerance))
        for one in centres
    ]
    best = centres[int(np.argmax(within))]
    return np.asarray(np.abs(np.linalg.norm(points - best, axis=1) - radius_mm) < NEAR_MM)


def _no_sphere_error(radius_mm: float) -> OperationError:
    return OperationError(
        "another-gauge",
        message("there-no-sphere-diameter-cloud", diameter=quantity(2 * radius_mm, "mm", 2)),
        message("points-not-on-sphere"),
        message("scan-gauge-chosen"),
    )
