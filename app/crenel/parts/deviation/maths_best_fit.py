"""Where a scanned part lies, by its surface alone: robust best fit of a scan to a mesh."""

from dataclasses import dataclass, replace

import numpy as np

from crenel.metrology.robust import sigma_from_median
from crenel.metrology.transforms import Floats, apply, inverse, nearest_rotation, se3_exp
from crenel.parts.cad.maths_closest import MeshTree
from crenel.parts.cad.maths_smooth import SmoothSurface
from crenel.parts.deviation.maths_face_points import face_points
from crenel.parts.deviation.maths_starts import start_poses
from crenel.parts.maths.datums import MOTION_NAMES

ROUNDS = 60
STILL_MM = 1e-4
"""The fit has ended when the corners of the part move less."""
TUKEY = 4.685
LEAST_SCALE_MM = 1e-3
WEAKEST = 1e-2
"""A motion that changes distances by less, of what the largest does, is left as it is."""
MOST_POINTS = 5000
NEAR_MM = (50.0, 10.0, 3.0)
"""Points farther from the mesh than this are left out, round after round."""
CLOSE_SECOND = 1.2
"""Another pose fits about as well if its mean distance is not larger by this factor."""
CAPPED_MM = 1.0
APART = 0.02
"""Poses are different if they put corners apart by this share of the part's size."""


@dataclass(frozen=True)
class BestFit:
    """A pose of a part by a scan."""

    T_part_arm: Floats
    """(4, 4)"""
    residual_mm: float
    """Median distance of the scan from the mesh."""
    scale_mm: float
    """Robust standard deviation of the distances."""
    within: float
    """The share of the scan that is near the mesh."""
    mean_mm: float
    """Mean distance of the scan, each counted as ``CAPPED_MM`` at most."""
    second: "BestFit | None" = None
    """Another pose that fits about as well, as of a part that is symmetric."""


def best_fit(
    tree: MeshTree,
    surface: SmoothSurface,
    points_mm: Floats,
    start: Floats | None = None,
    locked: tuple[str, ...] = (),
) -> BestFit:
    """The pose in which points (N, 3) of the arm frame are closest to the mesh.

    Args:
        start: (4, 4) about ``T_part_arm``; None: it is looked for.
        locked: names of ``MOTION_NAMES``, part frame, that stay as in the start.
    """
    if start is not None:
        return refine_pose(tree, surface, points_mm, start, locked)
    found = [
        refine_pose(tree, surface, points_mm, one, locked)
        for one in start_poses(tree, surface, points_mm)
    ]
    found.sort(key=lambda one: one.mean_mm)
    best, *others = found
    corners = corners_of_box(tree)
    for other in others:
        moved = apply(other.T_part_arm @ inverse(best.T_part_arm), corners) - corners
        is_apart = np.linalg.norm(moved, axis=1).max() > APART * tree.mesh.diagonal_mm
        if is_apart and other.mean_mm <= CLOSE_SECOND * max(best.mean_mm, STILL_MM):
            return replace(best, second=other)
    return best


def refine_pose(
    tree: MeshTree,
    surface: SmoothSurface,
    points_mm: Floats,
    start: Floats,
    locked: tuple[str, ...] = (),
) -> BestFit:
    """The best fit near a start: plain at first, then by Tukey's weights."""
    T, size = start.copy(), tree.mesh.diagonal_mm
    points_mm = points_mm[:: -(-len(points_mm) // MOST_POINTS)]
    corners, pivot = corners_of_box(tree), tree.mesh.middle_mm
    open_ = [k for k, name in enumerate(MOTION_NAMES) if name not in locked]
    off, within = np.zeros(0), 0.0
    for turn in range(ROUNDS):
        reach = NEAR_MM[min(turn // 4, len(NEAR_MM) - 1)]
        on = face_points(tree, surface, apply(T, points_mm), min(reach, size))
        off, at, normals = on.distance_mm, on.at_mm, on.normals
        within = 1 - on.beyond / len(points_mm)
        if len(off) < len(open_):
            break
        weights = tukey_weights(off) if turn >= 4 else np.ones(len(off))
        J = np.concatenate([np.cross(at - pivot, normals) / size, normals], axis=1)[:, open_]
        step = np.zeros(6)
        step[open_] = -np.linalg.lstsq(
            J * np.sqrt(weights)[:, None], np.sqrt(weights) * off, rcond=WEAKEST
        )[0]
        before = T
        T = move_about(T, pivot, step / np.r_[size, size, size, 1, 1, 1])
        moved = apply(T @ inverse(before), corners) - corners
        if turn >= 4 * len(NEAR_MM) and np.abs(moved).max() < STILL_MM:
            break
    if not len(off):
        return BestFit(T, np.inf, np.inf, 0.0, CAPPED_MM)
    away = np.abs(tree.closest(apply(T, points_mm), CAPPED_MM).distance_mm)
    mean = float(np.where(np.isfinite(away), away, CAPPED_MM).mean())
    return BestFit(T, float(np.median(np.abs(off))), sigma_from_median(np.abs(off)), within, mean)


def move_about(T_part_arm: Floats, pivot_mm: Floats, twist: Floats) -> Floats:
    """The pose after a left twist (rad, mm) about a point (3,) of the part frame."""
    about = np.eye(4)
    about[:3, 3] = pivot_mm
    moved = about @ se3_exp(twist) @ inverse(about) @ T_part_arm
    moved[:3, :3] = nearest_rotation(moved[:3, :3])
    return np.asarray(moved)


def tukey_weights(off_mm: Floats) -> Floats:
    """(N,) of distances, 0 of those far beyond their robust scale."""
    scale = max(sigma_from_median(np.abs(off_mm)), LEAST_SCALE_MM)
    share = np.minimum(np.abs(off_mm) / (TUKEY * scale), 1.0)
    return np.asarray((1 - share**2) ** 2)


def corners_of_box(tree: MeshTree) -> Floats:
    """(8, 3) corners of the box around a mesh."""
    low, high = tree.mesh.low_mm, tree.mesh.high_mm
    return np.array([[(low, high)[k >> i & 1][i] for i in range(3)] for k in range(8)])
