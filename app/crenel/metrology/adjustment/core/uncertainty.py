"""Uncertainty of points and planes after an adjustment, and its sources.

Small errors of the unknowns are propagated to points of the laser plane, in the flange frame (Eq.
9). All uncertainties are standard uncertainties, k = 1.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.adjustment.core.gauss_newton import AdjustmentResult, free_covariance
from crenel.metrology.adjustment.core.parameters import (
    INTRINSIC,
    LENS,
    MOUNT,
    PLANE,
    SENSOR,
    AdjustmentState,
)
from crenel.metrology.calibration.uncertainty_budget import PROBE_NAMES, BudgetContribution
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane, in_frame, tangents
from crenel.metrology.sensor.projection import PARAMETERS
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.transforms import Floats, adjoint, apply, inverse, pivot_adjoint, skew

# Name of each part of the normal matrix in a budget.
BUDGET = (
    ("contact points", ("contacts",)),
    ("arm encoders", ("encoders",)),
    ("arm geometry", ("links",)),
    ("object certificate", ("certificate",)),
    ("edges and corners", ("edges", "camera")),
    ("stripe", ("stripe",)),
)
# Contribution of a camera and mounting that were calibrated before.
KEPT = "camera and mounting"
PLANE_NAMES = ("plane_a", "plane_b", "plane_offset")
NAMES = (*PARAMETERS, *PLANE_NAMES, *PROBE_NAMES)
LINK_AXES = ("rx", "ry", "rz", "tx", "ty", "tz")
GRID = (13, 9)  # points of the volume across and along the picture
MAP = (33, 25)


@dataclass(frozen=True)
class Volume:
    """Pixels (G, 2) of the measuring volume, and their points (G, 3) in the flange frame."""

    uv_px: Floats
    points_flange_mm: Floats


@dataclass(frozen=True)
class UncertaintyMap:
    """Standard uncertainty ``u_um`` (M,) of the points of pixels ``uv_px`` (M, 2), k = 1.

    ``points_mm`` (M, 3) are in the sensor frame; ``calibrated`` (M,) marks those within
    the depths that the stripe covered, the others are extrapolated.
    """

    uv_px: Floats
    points_mm: Floats
    u_um: Floats
    calibrated: NDArray[np.bool_]


@dataclass(frozen=True)
class PlaneUncertainty:
    """Uncertainty of a plane that faces the sensor in the middle of its volume, from a straight
    sweep.

    ``angle_arcsec`` is about the direction of the sweep, ``offset_um`` in the middle.
    """

    angle_arcsec: float
    offset_um: float


@dataclass(frozen=True)
class CalibrationUncertainty:
    """The uncertainty of an adjustment; without laser lines there is no ``map`` and no ``plane``.

    ``covariance`` (K, K) belongs to ``names``, of ``NAMES`` and ``link_names``: camera and laser
    plane in the sensor frame, a left twist (rad, mm) of ``T_flange_sensor`` about ``pivot_mm`` (3,)
    in the flange frame, and the errors of the arm's links, which were estimated beside them as
    ``links`` (6n,): a twist (rad, mm) behind each link, in its frame. The pose of the camera in the
    sensor frame is a convention, without error. A robot that reports poses has no links.
    """

    rows: tuple[BudgetContribution, ...]
    total_um: float
    volume: Volume
    map: UncertaintyMap | None
    plane: PlaneUncertainty | None
    names: tuple[str, ...]
    covariance: Floats
    pivot_mm: Floats
    links: Floats


def link_names(joint_count: int) -> tuple[str, ...]:
    """The errors of an arm's links, from the base on."""
    return tuple(f"link{n}_{axis}" for n in range(1, joint_count + 1) for axis in LINK_AXES)


def estimate_uncertainty(found: AdjustmentResult, T_cam_sensor: Floats) -> CalibrationUncertainty:
    """Budget, map and covariance of an adjustment.

    Args:
        found: the adjustment.
        T_cam_sensor: (4, 4) the chosen sensor frame.

    Returns:
        Standard uncertainties of points in the flange frame, k = 1, µm: by source, over the
        measuring volume, and over the image. Without lines, the points are those that the pictures
        show at the usual distance of the object, which is taken as known.
    """
    lines = found.problem.has_lines
    volume = measuring_volume(found)
    rows, total_um = point_budget(found, sensor_jacobian(found.state, volume.uv_px))
    pivot = volume.points_flange_mm.mean(axis=0)
    return CalibrationUncertainty(
        rows,
        total_um,
        volume,
        uncertainty_map(found, T_cam_sensor) if lines else None,
        plane_uncertainty(found, volume) if lines else None,
        *_covariance_by_name(found, T_cam_sensor, pivot),
        pivot,
        found.state.links,
    )


def measuring_volume(found: AdjustmentResult) -> Volume:
    """The part of the laser plane that the stripes of all poses covered, as a grid; without
    stripes, what the object covered.

    Returns:
        (G, 2) px and (G, 3) mm in the flange frame.
    """
    seen = np.concatenate(
        [view.stripe_px() for view in found.problem.views]
        if found.problem.has_lines
        else [shape.places for shape, _ in found.linear.rows]
    )
    low, high = seen.min(axis=0), seen.max(axis=0)
    u, v = (np.linspace(a, b, n) for a, b, n in zip(low, high, GRID, strict=True))
    uv = np.column_stack([axis.ravel() for axis in np.meshgrid(u, v)])
    points = apply(found.state.T_flange_cam, _points(found.state, uv))
    there = np.isfinite(points).all(axis=1)
    return Volume(uv[there], points[there])


def covariance_by_source(found: AdjustmentResult) -> dict[str, Floats]:
    """The covariance (U, U) split by source.

    Each kind of observation contributes ``C N C``, with N its part of the normal matrix. Distortion
    is the contribution of an unknown lens; the contribution of the arm's geometry includes the
    uncertain size of its errors.
    """
    N = np.sum(list(found.parts.values()), axis=0)
    known_lens = found.free.copy()
    known_lens[LENS] = False
    C = free_covariance(N, known_lens)
    split = {
        source: C @ np.sum([found.parts[name] for name in names], axis=0) @ C
        for source, names in BUDGET
    }
    split["distortion"] = found.covariance - C
    if found.by_kept is not None:
        split[KEPT] = found.by_kept
    split["arm geometry"] = split["arm geometry"] + found.link_size_covariance
    return split


def sensor_jacobian(state: AdjustmentState, uv_px: Floats) -> Floats:
    """Derivatives of points in the flange frame by camera, laser plane and mounting.

    Args:
        state: point of linearisation.
        uv_px: (G, 2) distorted pixels.

    Returns:
        (G, 3, 17) mm per unit of each parameter: camera, laser plane, mounting.
    """
    in_cam = _points(state, uv_px)
    R = state.T_flange_cam[:3, :3]
    J = np.zeros((len(uv_px), 3, SENSOR.stop))
    for k in range(MOUNT.start):
        h = 1e-3 if k < 4 else 1e-6
        step = np.zeros(SENSOR.stop)
        step[k] = h
        ahead, behind = (_points(state.apply_sensor_step(way * step), uv_px) for way in (1, -1))
        J[:, :, k] = (ahead - behind) / (2 * h) @ R.T
    for g, point in enumerate(in_cam):
        J[g, :, MOUNT] = R @ np.hstack([-skew(point), np.eye(3)])
    return J


def point_budget(
    found: AdjustmentResult, J: Floats
) -> tuple[tuple[BudgetContribution, ...], float]:
    """Standard uncertainty of points with Jacobian (G, 3, S), rms over them, µm: by source, and of
    all sources together."""
    squares = {
        source: _error_squares(J, C[SENSOR, SENSOR])
        for source, C in covariance_by_source(found).items()
    }
    rows = tuple(
        BudgetContribution(source, 1e3 * float(np.sqrt(np.mean(square))))
        for source, square in squares.items()
    )
    total = np.sum(list(squares.values()), axis=0)
    return rows, 1e3 * float(np.sqrt(np.mean(total)))


def uncertainty_map(found: AdjustmentResult, T_cam_sensor: Floats) -> UncertaintyMap:
    """The uncertainty over the picture, wherever rays meet the laser plane at a usable depth."""
    state, camera = found.state, found.state.camera
    u = np.linspace(0, camera.width_px - 1, MAP[0])
    v = np.linspace(0, camera.height_px - 1, MAP[1])
    uv = np.column_stack([axis.ravel() for axis in np.meshgrid(u, v)])
    in_cam = _points(state, uv)
    stripe = np.concatenate([view.stripe_px() for view in found.problem.views])
    depth = _points(state, stripe)[:, 2]
    near, far = float(depth.min()), float(depth.max())
    margin = far - near
    usable = np.isfinite(in_cam).all(axis=1)
    usable &= (in_cam[:, 2] > near - margin) & (in_cam[:, 2] < far + margin)
    uv, in_cam = uv[usable], in_cam[usable]
    J = sensor_jacobian(state, uv)
    u_um = 1e3 * np.sqrt(_error_squares(J, found.uncertainty[SENSOR, SENSOR]))
    calibrated = (in_cam[:, 2] >= near) & (in_cam[:, 2] <= far)
    return UncertaintyMap(uv, apply(inverse(T_cam_sensor), in_cam), u_um, calibrated)


def plane_uncertainty(found: AdjustmentResult, volume: Volume) -> PlaneUncertainty:
    """Uncertainty of angle and offset of a plane across the view of the sensor, from one straight
    sweep."""
    across = plane_across_view(found.state, volume)
    J = np.einsum("i,gik->gk", across.normal, sensor_jacobian(found.state, volume.uv_px))
    line = across.line @ J  # (2, 17)
    C = line @ found.uncertainty[SENSOR, SENSOR] @ line.T
    return PlaneUncertainty(
        float(np.degrees(np.sqrt(C[1, 1])) * 3600), float(1e3 * np.sqrt(C[0, 0]))
    )


@dataclass(frozen=True)
class FacingPlane:
    """A plane in the middle of a volume: its normal (3,), flange frame, and the derivatives
    ``line`` (2, G) of its offset (mm) and slope (rad) by the heights of the volume's points
    (G,)."""

    normal: Floats
    line: Floats


def plane_across_view(state: AdjustmentState, volume: Volume) -> FacingPlane:
    """The plane that faces the sensor: along the stripe, in the middle of the depths."""
    points = volume.points_flange_mm
    middle = points.mean(axis=0)
    along = np.linalg.svd(points - middle)[2][0]  # the volume is wider than deep
    R = state.T_flange_cam[:3, :3]
    normal = R @ np.cross(state.plane.normal, R.T @ along)
    height = (points - middle) @ normal
    level = np.abs(height) < 0.25 * np.ptp(height) + 1e-6
    x = ((points - middle) @ along)[level]
    line = np.zeros((2, len(points)))
    line[:, level] = np.linalg.pinv(np.column_stack([np.ones(len(x)), x]))
    return FacingPlane(normal, line)


def express_in_sensor_frame(
    state: AdjustmentState, T_cam_sensor: Floats
) -> tuple[Camera, LaserPlane, Floats]:
    """Camera, laser plane and ``T_flange_sensor`` in the chosen sensor frame."""
    camera, plane = in_frame(state.camera, state.plane, inverse(T_cam_sensor))
    return camera, plane, state.T_flange_cam @ T_cam_sensor


def _points(state: AdjustmentState, uv_px: Floats) -> Floats:
    return sensor_points(state.camera, state.plane, uv_px)


def _error_squares(J: Floats, covariance: Floats) -> Floats:
    """Squared length (G,) of the errors of points, mm^2."""
    return np.asarray(np.maximum(np.einsum("gik,kl,gil->g", J, covariance, J), 0.0))


def _covariance_by_name(
    found: AdjustmentResult, T_cam_sensor: Floats, pivot_mm: Floats
) -> tuple[tuple[str, ...], Floats]:
    """``NAMES``, without those of the plane where there is none, and ``link_names``, with their
    covariance."""
    of_links = found.linear.at.links
    links = np.arange(of_links.start, of_links.stop)
    names = (*NAMES, *link_names(len(links) // len(LINK_AXES)))
    M = np.zeros((len(names), len(found.uncertainty)))
    M[: len(NAMES), SENSOR] = derivatives_of_names(found.state, T_cam_sensor, pivot_mm)
    M[np.arange(len(NAMES), len(names)), links] = 1.0
    known = [
        k for k, name in enumerate(names) if found.problem.has_lines or name not in PLANE_NAMES
    ]
    covariance = M @ found.uncertainty @ M.T
    return tuple(names[k] for k in known), np.asarray(covariance[np.ix_(known, known)])


def derivatives_of_names(state: AdjustmentState, T_cam_sensor: Floats, pivot_mm: Floats) -> Floats:
    """Derivatives (23, 17) of what ``NAMES`` names by the unknowns of camera, plane and mounting.

    Args:
        T_cam_sensor: (4, 4) the chosen sensor frame.
        pivot_mm: (3,) about which the mounting turns, flange frame.
    """
    R, t = T_cam_sensor[:3, :3], T_cam_sensor[:3, 3]
    M = np.zeros((len(NAMES), SENSOR.stop))
    for own, name in enumerate(INTRINSIC):
        M[NAMES.index(name), own] = 1.0
    n = state.plane.normal
    in_sensor = tangents(R.T @ n) @ R.T
    at = NAMES.index("plane_a")
    M[at : at + 2, PLANE.start : PLANE.start + 2] = in_sensor @ tangents(n).T
    M[at + 2, PLANE.start : PLANE.start + 2] = -tangents(n) @ t
    M[at + 2, PLANE.start + 2] = 1.0
    probe = np.linalg.inv(pivot_adjoint(pivot_mm)) @ adjoint(state.T_flange_cam)
    M[at + 3 :, MOUNT] = probe
    return M
