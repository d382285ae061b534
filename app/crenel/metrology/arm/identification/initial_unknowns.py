"""Where the adjustment of an arm begins: places, frames and markers as the given arm has them."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.messages.message import join, message
from crenel.metrology.arm.identification.observations import BASE, TIP, StackedObservations
from crenel.metrology.arm.identification.parameters import (
    Indices,
    PoseJacobian,
    pose_jacobian,
)
from crenel.metrology.arm.identification.unknowns import Unknowns
from crenel.metrology.arm.kinematics import Arm, Tip, flange_poses, tip_centres
from crenel.metrology.fitting.plane_sphere import fit_sphere
from crenel.metrology.robust import median
from crenel.metrology.transforms import (
    Floats,
    nearest_rotation,
    rigid_fits,
)

DRAWS, PAIRS, POSES = 200, 4, 8
"""Sets of points that are tried, and how many determine a frame, or a frame with a marker."""
NEAR = 3.0
"""Points within this multiple of the typical distance lie in the right frame."""
TYPICAL = 0.4
"""Share of the points that lie in the right frame at least: those of another may be mixed in."""


def initial_unknowns(arm: Arm, data: StackedObservations) -> Unknowns:
    """The given arm, with the centre of each place where most of its points have it, and frames
    and markers where most coordinates have them.

    Where nothing but coordinates was measured, the tip may lie anywhere on the flange.
    """
    markers = data.coordinates.markers
    offsets = [arm.tip.centre_mm if one.offset_mm is None else one.offset_mm for one in markers]
    at = Unknowns(
        arm,
        _centres(arm, data),
        0.0,
        np.zeros(len(data.bar_names)),
        np.tile(np.eye(4), (len(data.coordinates.frames), 1, 1)),
        np.array(offsets).reshape(-1, 3),
        np.tile(np.eye(3), (len(markers), 1, 1)),
    )
    at = align_frames(data, _with_markers(data, at))
    return _with_rotations(data, at)


def align_frames(data: StackedObservations, at: Unknowns) -> Unknowns:
    """Each instrument's frame where most of its points lie at their markers."""
    found = data.coordinates
    predicted = marker_points(data, at)
    frames = at.T_arm_frames.copy()
    for i, name in enumerate(found.frames):
        if name != BASE:
            mine = found.frame_of == i
            frames[i] = align_frame(predicted[mine], found.points_mm[mine])
    return replace(at, T_arm_frames=frames)


def align_frame(predicted_mm: Floats, measured_mm: Floats) -> Floats:
    """``T_arm_frame`` (4, 4) by which most measured points (m, 3) lie at the predicted ones, or
    the identity where points determine none."""
    if len(measured_mm) < 3:
        return np.eye(4)

    def fit(own: Indices) -> tuple[Floats, Floats]:
        T = rigid_fits(predicted_mm[own], measured_mm[own])
        moved = measured_mm @ T[:, :3, :3].mT + T[:, None, :3, 3]
        return T, np.linalg.norm(moved - predicted_mm, axis=2)

    return _fit_most(fit, len(measured_mm), PAIRS, np.eye(4))


def align_marker(poses: PoseJacobian, measured_mm: Floats) -> Floats:
    """(3,) change of a marker's place in the flange frame, by its points (m, 3) in a frame.

    Linear in frame and place as long as the rotation is any matrix, which is then the one of the
    nearest rotation.
    """
    middle = measured_mm.mean(axis=0)
    size = max(float(np.linalg.norm(measured_mm - middle, axis=1).max()), 1e-9)
    points = (measured_mm - middle) / size
    shift = np.broadcast_to(np.eye(3), (len(points), 3, 3))
    by_matrix = np.einsum("ij,nk->nijk", np.eye(3), points).reshape(-1, 3, 9)
    linear = np.concatenate([by_matrix, shift, -poses.rotations], axis=2)

    def fit(own: Indices) -> tuple[Floats, Floats]:
        sets = len(own)
        free = _least_squares(linear[own].reshape(sets, -1, 15), poses.tips_mm[own])
        turned = points @ nearest_rotation(free[:, :9].reshape(-1, 3, 3)).mT * size
        left = poses.tips_mm - turned
        own_left = np.take_along_axis(left, own[:, :, None], axis=1)
        rest = _least_squares(linear[own, :, 9:].reshape(sets, -1, 6), own_left)
        distances = np.linalg.norm(left - np.einsum("mij,sj->smi", linear[:, :, 9:], rest), axis=2)
        return rest[:, 3:], distances

    return _fit_most(fit, len(points), POSES, np.zeros(3))


def _least_squares(design: Floats, values: Floats) -> Floats:
    """(S, n) solutions of least length of systems (S, r, n), each with r values (S, ..., 3)."""
    flat = values.reshape(len(design), -1, 1)
    return np.asarray(np.linalg.pinv(design, rcond=1e-9) @ flat)[:, :, 0]


def _fit_most(
    fit: Callable[[Indices], tuple[Floats, Floats]], count: int, drawn: int, otherwise: Floats
) -> Floats:
    """What most of the points agree on, by fits of a few of them.

    Args:
        fit: of sets of points (S, n); it returns what is found by each, and the distances (S, m)
            of all points, NaN where a set determines nothing.
        drawn: number of points that determine a fit.
        otherwise: returned if no fit is possible.
    """
    rng = np.random.default_rng(0)
    sets = np.stack([rng.choice(count, min(drawn, count), replace=False) for _ in range(DRAWS)])
    found, distances = fit(sets)
    typical = np.quantile(distances, TYPICAL, axis=1)
    if np.isnan(typical).all():
        return otherwise
    best = int(np.nanargmin(typical))
    near = np.flatnonzero(distances[best] < NEAR * typical[best])
    if len(near) <= drawn:
        return np.asarray(found[best])
    all_near, distances = fit(near[None])
    return np.asarray(found[best] if np.isnan(distances).any() else all_near[0])


def _centres(arm: Arm, data: StackedObservations) -> Floats:
    tips = tip_centres(arm, data.q_rad)
    centres = np.empty((len(data.places), 3))
    for i, place in enumerate(data.places):
        points = tips[place.rows]
        if place.diameter_mm is None:
            centres[i] = np.median(points, axis=0)
            continue
        try:
            centres[i] = fit_sphere(points).centre_mm
        except OperationError as refusal:
            what = join([place.label, refusal.what], ": ")
            raise OperationError(
                refusal.code, what, refusal.why, message("touch-more-sphere")
            ) from refusal
    return centres


def _with_markers(data: StackedObservations, at: Unknowns) -> Unknowns:
    """Each unknown marker on the flange, by the frame that has most points of it."""
    found = data.coordinates
    offsets, arm = at.offsets_mm.copy(), at.arm
    for k, marker in enumerate(found.markers):
        mine = found.marker_of == k
        frame = int(np.argmax(np.bincount(found.frame_of[mine])))
        own = mine & (found.frame_of == frame)
        is_free = marker.is_estimated or (marker.name == TIP and not data.touches)
        if not is_free or own.sum() < POSES:
            continue
        poses = pose_jacobian(at.arm_with(k, marker), found.q_rad[own])
        change = align_marker(poses, found.points_mm[own])
        if marker.name == TIP:
            x, y, z = (float(one) for one in arm.tip.centre_mm + change)
            arm = replace(arm, tip=Tip(x, y, z, arm.tip.diameter_mm))
        else:
            offsets[k] += change
    return replace(at, arm=arm, offsets_mm=offsets)


def marker_points(data: StackedObservations, at: Unknowns) -> Floats:
    """(M, 3) where the arm has the marker of each coordinate, arm frame."""
    found = data.coordinates
    predicted = np.empty((len(found.q_rad), 3))
    for k, marker in enumerate(found.markers):
        mine = found.marker_of == k
        predicted[mine] = tip_centres(at.arm_with(k, marker), found.q_rad[mine])
    return predicted


def _with_rotations(data: StackedObservations, at: Unknowns) -> Unknowns:
    """Each marker's rotation in the flange frame as most of its poses have it."""
    found = data.coordinates
    rotations = at.R_flange_markers.copy()
    for k, marker in enumerate(found.markers):
        mine = (found.marker_of == k) & found.has_rotation
        if not marker.has_rotation or not mine.any():
            continue
        R_arm_flange = flange_poses(at.arm, found.q_rad[mine])[:, :3, :3]
        R_arm_marker = at.T_arm_frames[found.frame_of[mine]][:, :3, :3] @ found.rotations[mine]
        rotations[k] = _typical_rotation(np.swapaxes(R_arm_flange, 1, 2) @ R_arm_marker)
    return replace(at, R_flange_markers=rotations)


def _typical_rotation(rotations: Floats) -> Floats:
    """The mean (3, 3) of the half of rotations (m, 3, 3) closest to one in their middle."""
    some = rotations[:: max(1, len(rotations) // DRAWS)]
    apart = np.linalg.norm(some[:, None] - rotations[None], axis=(2, 3))
    central = apart[int(np.argmin(np.median(apart, axis=1)))]
    near: NDArray[np.bool_] = central <= median(central)
    return nearest_rotation(rotations[near].mean(axis=0))
