"""Bundle adjustment of the pictures of one board: lens, views and surface, from corners alone.

It needs neither arm nor laser, and provides the start values of the complete adjustment.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from crenel.metrology.adjustment.board.observations import BoardView
from crenel.metrology.adjustment.board.surface import board_prior, coordinate_groups
from crenel.metrology.adjustment.core.linearise import camera_prior
from crenel.metrology.adjustment.core.observations import TargetPrior
from crenel.metrology.calibration.observation_model import BLOCK
from crenel.metrology.robust import sigma_from_median
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.projection import COUNT, step_camera
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.transforms import Floats

# Parameters of ``PARAMETERS`` that all pictures share (fx, fy, u0, v0, k1, k2), those of each
# picture, and the part of the prior of the shared ones that applies here.
COMMON = np.array([0, 1, 2, 3, 10, 11])
PER_POSE = np.arange(4, 10)
OF_PRIOR = np.array([0, 1, 2, 3, 4, 5])
ROUNDS = 12
CONVERGED_PX = 1e-3
# Minimum scatter of corners, and the number of standard deviations beyond which one is excluded.
LEAST_SCATTER_PX, OUTLIER_SIGMAS = 0.02, 4.5


@dataclass(frozen=True)
class Bundle:
    """The camera in each of P poses, with the board frame as sensor frame; the coordinates of the
    surface, with standard deviations as certified or larger; the scatter of corners in each picture
    (P,), as rms of one coordinate; and the covariance (6P, 6P) of the left twists (rad, mm) of
    ``T_cam_obj``."""

    cameras: tuple[Camera, ...]
    surface_prior: TargetPrior
    scatter_px: Floats
    covariance: Floats

    @property
    def coordinates(self) -> Floats:
        return self.surface_prior.coordinates


def adjust_bundle(views: Sequence[BoardView], cameras: Sequence[Camera]) -> Bundle:
    """The most likely lens, views and surface for the corners of all views.

    Args:
        cameras: start values, one per view; they differ in the pose only.
    """
    prior = board_prior(views[0].board)
    none = np.zeros(len(views))
    found = Bundle(tuple(cameras), prior, none + np.inf, np.diag(np.tile(none, 6)))
    for _ in range(ROUNDS):
        before, found = found, _gauss_newton_step(views, found, prior)
        if np.max(np.abs(found.scatter_px - before.scatter_px)) < CONVERGED_PX:
            break
    return found


def _gauss_newton_step(views: Sequence[BoardView], at: Bundle, prior: TargetPrior) -> Bundle:
    """One Gauss-Newton iteration; the standard deviations of the surface are estimated again."""
    certified, sd, board = prior.coordinates, at.surface_prior.sd, views[0].board
    shared, common = len(COMMON) + len(certified), np.arange(len(COMMON))
    surface_rows = np.arange(len(COMMON), shared)
    count = shared + len(PER_POSE) * len(views)
    N, g = np.zeros((count, count)), np.zeros(count)
    normed, scatter = [], np.zeros(len(views))
    for p, (view, camera) in enumerate(zip(views, at.cameras, strict=True)):
        rows = view.corner_rows(camera, at.surface_prior.coordinates)
        J, r = np.zeros((len(rows.residuals), count)), rows.residuals
        J[:, : len(COMMON)] = rows.jacobian[:, COMMON]
        J[:, len(COMMON) : shared] = rows.jacobian[:, BLOCK]
        J[:, _pose_slice(shared, p)] = rows.jacobian[:, PER_POSE]
        scatter[p] = max(sigma_from_median(np.abs(r)), LEAST_SCATTER_PX)
        kept = np.abs(r) < OUTLIER_SIGMAS * scatter[p]
        N += J[kept].T @ J[kept] / scatter[p] ** 2
        g += J[kept].T @ r[kept] / scatter[p] ** 2
        normed.append(r[kept] / scatter[p])
    camera_weight, pull = camera_prior(at.cameras[0])
    N[np.ix_(common, common)] += camera_weight[np.ix_(OF_PRIOR, OF_PRIOR)]
    g[common] += pull[OF_PRIOR]
    N[surface_rows, surface_rows] += sd**-2.0
    g[surface_rows] += (at.surface_prior.coordinates - certified) / sd**2
    scale = np.diag(N) ** -0.5
    C = np.linalg.inv(N * np.outer(scale, scale)) * np.outer(scale, scale)
    step = -C @ g
    # share of the surface's unknowns that the pictures determined, not the certificate
    determined_count = float(np.sum(1 - np.diag(C)[surface_rows] / sd**2))
    r = np.concatenate(normed)
    degrees = max(len(r) - len(COMMON) - len(PER_POSE) * len(views) - determined_count, 1)
    factor = float(np.sqrt(r @ r / degrees))
    coordinates = at.surface_prior.coordinates + step[surface_rows]
    variances = np.minimum(factor**2 * np.diag(C)[surface_rows], sd**2)
    return Bundle(
        tuple(_step_camera(camera, step, shared, p) for p, camera in enumerate(at.cameras)),
        replace(
            prior,
            coordinates=coordinates,
            sd=_estimate_surface_sd(board, coordinates - certified, variances, prior.sd, sd),
        ),
        np.maximum(factor * scatter, LEAST_SCATTER_PX),
        factor**2 * C[shared:, shared:],
    )


def _estimate_surface_sd(
    board: Chessboard, off: Floats, variances: Floats, certified: Floats, sd: Floats
) -> Floats:
    """Standard deviations (B,) of the surface coordinates: those of the certificate for each group,
    unless the pictures show that they are larger (Foerstner)."""
    deviations = certified.copy()
    for group in coordinate_groups(board):
        least, now = certified[group], float(sd[group][0])
        determined = float(np.sum(1 - variances[group] / now**2))
        square = float(off[group] @ off[group] + least[0] ** 2)
        deviations[group] = np.maximum(least, np.sqrt(square / (determined + 1)))
    return deviations


def _pose_slice(shared: int, pose: int) -> slice:
    """Indices of the unknowns of one pose; they follow the shared ones."""
    return slice(shared + len(PER_POSE) * pose, shared + len(PER_POSE) * (pose + 1))


def _step_camera(camera: Camera, step: Floats, shared: int, pose: int) -> Camera:
    own_step = np.zeros(COUNT)
    own_step[COMMON] = step[: len(COMMON)]
    own_step[PER_POSE] = step[_pose_slice(shared, pose)]
    return step_camera(camera, own_step)


def with_identity_pose(camera: Camera) -> Camera:
    """The camera with its own frame as sensor frame."""
    return replace(camera, rotation=np.eye(3), translation_mm=np.zeros(3))
