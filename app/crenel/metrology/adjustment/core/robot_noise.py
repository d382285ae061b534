"""The amount and kind of disagreement between the poses of a robot and the pictures.

The robot has an error in rotation and translation of its flange, independent in each pose. Pictures
and robot may also disagree in the tilt of the object while they agree on its position: the object
rocks, or the errors of the pictures look like a tilt. The three standard deviations are the most
likely ones for the residuals of the poses (restricted maximum likelihood); the weights follow from
them.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.adjustment.core.arm_errors import FlangeMotion
from crenel.metrology.transforms import (
    Floats,
    adjoint,
    apply,
    inverse,
    pivot_adjoint,
    se3_exp,
    vector_from_rotation,
)

# Usual values if the poses contain little information: rotation (rad), translation (mm) and tilt
# (rad), known to this factor (as the standard deviation of a logarithm).
USUAL = np.array([0.2e-3, 0.08, 0.1e-3])
USUAL_LOG_SD = 1.5
LEAST = np.array([1e-6, 1e-3, 1e-6])
ROUNDS = 3
# Of the logarithms of the standard deviations, which few poses determine to a tenth at best.
LOG_TOLERANCE = 1e-3
CURVATURE_STEP = 0.1
# The noise is estimated again with everything else, as a factor on these standard deviations.
USUAL_FACTOR, LEAST_FACTOR = 1.0, 0.3

# A pose is an outlier if chance alone would cause such a deviation less often than this. Robots err
# less evenly than chance does: alike in poses that are alike.
OUTLIER_CHANCE, LEAST_CHANCE = 1e-6, 1e-300
NORMAL_DEVIATES = np.linspace(-8.0, 8.0, 161)
FEWEST_OTHERS = 4

NoiseSquares = Floats
"""(3, P, 6, 6): the covariance of each pose by rotation, translation and tilt of variance 1."""


@dataclass(frozen=True)
class RobotNoise:
    """Standard deviations of one pose: rotation (rad) of the flange about each axis, translation
    (mm) along each, and tilt (rad) of the object about its own middle."""

    turn_rad: float
    shift_mm: float
    tilt_rad: float


@dataclass(frozen=True)
class PosePairs:
    """P poses of a robot, and the corresponding poses by the pictures.

    ``T_arm_flange`` and ``T_cam_obj`` (P, 4, 4) come from the robot and from the pictures;
    ``covariance`` (6P, 6P) is that of the pictures' left twists of ``T_cam_obj``. The object tilts
    about ``middle_mm`` (3,), in the object frame.
    """

    T_arm_flange: Floats
    T_cam_obj: Floats
    covariance: Floats
    middle_mm: Floats

    def select(self, kept: NDArray[np.int64]) -> "PosePairs":
        own = _rows_of(kept)
        return replace(
            self,
            T_arm_flange=self.T_arm_flange[kept],
            T_cam_obj=self.T_cam_obj[kept],
            covariance=self.covariance[np.ix_(own, own)],
        )


@dataclass(frozen=True)
class NoiseEstimate:
    """The noise (3,), as logarithms of its standard deviations, and the resulting poses of sensor
    and object, ``T_flange_cam`` and ``T_arm_obj`` (4, 4)."""

    log_sd: Floats
    X: Floats
    Z: Floats

    @property
    def noise(self) -> RobotNoise:
        return RobotNoise(*map(float, np.exp(self.log_sd)))


def estimate_robot_noise(seen: PosePairs, X: Floats, Z: Floats) -> NoiseEstimate:
    """The most likely noise of P poses, from start values (4, 4) of the sensor and the object."""
    from scipy.optimize import minimize  # slow to import, and needed for robots only

    noise = np.log(USUAL)
    for _ in range(ROUNDS):
        residuals, J, G = _linearise(seen, X, Z)
        found = minimize(
            _negative_log_likelihood,
            noise,
            args=(residuals, J, G, seen.covariance),
            method="Nelder-Mead",
            options={"xatol": LOG_TOLERANCE, "fatol": LOG_TOLERANCE},
        )
        noise = np.maximum(found.x, np.log(LEAST))
        W = np.linalg.inv(_covariance(noise, G, seen.covariance))
        step = -np.asarray(np.linalg.solve(J.T @ W @ J, J.T @ W @ residuals), np.float64)
        X, Z = np.asarray(X @ se3_exp(step[:6])), np.asarray(se3_exp(step[6:]) @ Z)
    return NoiseEstimate(noise, X, Z)


def find_robot_outlier(seen: PosePairs, estimate: NoiseEstimate) -> int | None:
    """The pose that is furthest off the estimate by all, if the noise of the others does not
    explain it.

    It is judged by a fit without it (Fisher's test), so that it cannot affect the fit.
    """
    count = len(seen.T_arm_flange)
    if count <= FEWEST_OTHERS:
        return None
    worst = int(np.argmax(_mahalanobis_squares(seen, estimate)))
    others = np.delete(np.arange(count), worst)
    estimate = estimate_robot_noise(seen.select(others), estimate.X, estimate.Z)
    log_covariance = _log_sd_covariance(seen.select(others), estimate)
    return worst if _excess(seen, estimate, log_covariance, others, worst) > 1 else None


def find_predicted_pose(
    seen: PosePairs, agree: NDArray[np.bool_], T_flange_cam: Floats, T_arm_obj: Floats
) -> int | None:
    """Finds the pose, among those that do not agree (P,), that those that do predict best, if it
    lies within what they can predict; None if none does.

    Few poses tilted alike know little of one that is tilted otherwise; a minority knows nothing.
    """
    others = np.flatnonzero(agree)
    if len(others) < max(FEWEST_OTHERS, len(agree) / 2) or agree.all():
        return None
    estimate = estimate_robot_noise(seen.select(others), T_flange_cam, T_arm_obj)
    log_covariance = _log_sd_covariance(seen.select(others), estimate)
    excess = {
        p: _excess(seen, estimate, log_covariance, others, p)
        for p in map(int, np.flatnonzero(~agree))
    }
    best = min(excess, key=lambda p: excess[p])
    return best if excess[best] <= 1 else None


def _excess(
    seen: PosePairs,
    estimate: NoiseEstimate,
    log_covariance: Floats,
    others: NDArray[np.int64],
    pose: int,
) -> float:
    """How far a pose is from where others predict it, beyond 1 if chance alone does not explain it.

    The others tell little of a noise that hardly shows in their own views: the standard deviation
    of the prediction has one of its own, and its logarithm is taken as normal.
    """
    from scipy.special import chdtrc

    residuals, J, G = _linearise(seen, estimate.X, estimate.Z)
    rows, own = _rows_of(others), _rows_of(np.array([pose]))
    V = _covariance(estimate.log_sd, G, seen.covariance)
    W = np.linalg.inv(V[np.ix_(rows, rows)])
    gain = J[own] @ np.linalg.solve(J[rows].T @ W @ J[rows], J[rows].T @ W)
    variance = V[np.ix_(own, own)] + gain @ V[np.ix_(rows, rows)] @ gain.T
    direction = np.linalg.solve(variance, residuals[own])
    square = float(residuals[own] @ direction)
    by_noise = np.exp(2 * estimate.log_sd) * [
        _variance_along(direction, gain, one, others, pose) for one in G
    ]
    spread = by_noise @ log_covariance @ by_noise
    times = np.exp(2 * np.sqrt(spread) / square * NORMAL_DEVIATES)
    chance = float(chdtrc(6, square / times) @ np.exp(-0.5 * NORMAL_DEVIATES**2))
    chance /= float(np.exp(-0.5 * NORMAL_DEVIATES**2).sum())
    return float(np.log(max(chance, LEAST_CHANCE)) / np.log(OUTLIER_CHANCE))


def _variance_along(
    direction: NDArray[np.floating],
    gain: Floats,
    blocks: Floats,
    others: NDArray[np.int64],
    pose: int,
) -> float:
    """The variance of a prediction along a direction, by the noise of each pose (P, 6, 6)."""
    back = (gain.T @ direction).reshape(len(others), 6)
    own = float(direction @ blocks[pose] @ direction)
    return own + float(np.einsum("pi,pij,pj->", back, blocks[others], back))


def _log_sd_covariance(seen: PosePairs, estimate: NoiseEstimate) -> Floats:
    """(3, 3) of the logarithms of the standard deviations, by the curvature of their likelihood."""
    given = (*_linearise(seen, estimate.X, estimate.Z), seen.covariance)
    steps = CURVATURE_STEP * np.eye(3)
    at = np.array(
        [
            [
                [
                    _negative_log_likelihood(estimate.log_sd + a * one + b * other, *given)
                    for a, b in ((1, 1), (1, -1), (-1, 1), (-1, -1))
                ]
                for other in steps
            ]
            for one in steps
        ]
    )
    curvature = (at @ [1, -1, -1, 1]) / (4 * CURVATURE_STEP**2)
    sizes, axes = np.linalg.eigh((curvature + curvature.T) / 2)
    # as the prior alone knows them, at least
    return np.asarray(axes @ np.diag(1 / np.maximum(sizes, USUAL_LOG_SD**-2)) @ axes.T)


def _rows_of(poses: NDArray[np.int64]) -> NDArray[np.int64]:
    return (6 * poses[:, None] + np.arange(6)).ravel()


def _mahalanobis_squares(seen: PosePairs, estimate: NoiseEstimate) -> Floats:
    """(P,) squared deviation of each pose from a fit to all, with 6 degrees of freedom."""
    residuals, _, G = _linearise(seen, estimate.X, estimate.Z)
    poses = np.arange(len(seen.T_arm_flange))
    V = _covariance(estimate.log_sd, G, seen.covariance)
    own = V.reshape(len(poses), 6, len(poses), 6)[poses, :, poses, :]
    off = residuals.reshape(-1, 6)
    return np.asarray(np.sum(off * np.linalg.solve(own, off[..., None])[..., 0], axis=1))


def _linearise(seen: PosePairs, X: Floats, Z: Floats) -> tuple[Floats, Floats, NoiseSquares]:
    """Residuals (6P,), twists of the object in the camera frame between its poses by the pictures
    and by the robot; derivatives by ``X`` from the right and ``Z`` from the left (6P, 12); and what
    rotation, translation and tilt of each pose do."""
    centre = apply(Z, seen.middle_mm[None])[0]
    T_cam_arm = inverse(seen.T_arm_flange @ X)
    off = seen.T_cam_obj @ inverse(T_cam_arm @ Z)
    residuals = np.concatenate([vector_from_rotation(off[:, :3, :3]), off[:, :3, 3]], axis=1)
    in_cam = adjoint(T_cam_arm)
    rows = np.concatenate([np.broadcast_to(np.eye(6), in_cam.shape), -in_cam], axis=2)
    of_flange = in_cam @ adjoint(seen.T_arm_flange)
    ways = (of_flange[..., :3], of_flange[..., 3:], in_cam @ _tilts(Z, centre))
    return residuals.ravel(), rows.reshape(-1, 12), np.array([way @ way.mT for way in ways])


def _tilts(T_arm_obj: Floats, centre_mm: Floats) -> Floats:
    """(6, 2) twists in the arm frame that tilt the object about its own x and y."""
    return np.asarray(pivot_adjoint(centre_mm)[:, :3] @ T_arm_obj[:3, :2])


def _covariance(log_sd: Floats, by_noise: NoiseSquares, covariance: Floats) -> Floats:
    """That of the residuals (6P, 6P): of the pictures, and by the noise of each pose."""
    V = covariance.copy()
    poses = len(covariance) // 6
    own = np.arange(poses)
    blocks = V.reshape(poses, 6, poses, 6)
    blocks[own, :, own, :] += np.tensordot(np.exp(2 * log_sd), by_noise, axes=1)
    return V


def _negative_log_likelihood(
    log_sd: Floats, residuals: Floats, J: Floats, by_noise: NoiseSquares, covariance: Floats
) -> float:
    """Negative logarithm of the restricted likelihood, including the prior."""
    off = (log_sd - np.log(USUAL)) / USUAL_LOG_SD
    V = _covariance(np.maximum(log_sd, np.log(LEAST)), by_noise, covariance)
    try:
        L = np.linalg.cholesky(V)
    except np.linalg.LinAlgError:
        return np.inf  # so large that the pictures' own covariance is lost beside it
    white = np.linalg.solve(L, np.column_stack([J, residuals]))
    # the factor of [J r]ᵀ V⁻¹ [J r]: of J first, and the residuals that J leaves last
    R = np.linalg.qr(white, mode="r")
    sizes = np.abs(np.diag(R))
    size = 2 * float(np.log(np.diag(L)).sum() + np.log(sizes[:-1]).sum())
    return 0.5 * (float(sizes[-1]) ** 2 + size + float(off @ off))


def with_flange_noise(moves: FlangeMotion, noise: RobotNoise) -> FlangeMotion:
    """The motion of the robot with the noise of its flange in these proportions."""
    return replace(
        moves,
        by_noise=np.array([adjoint(T) for T in moves.T_arm_flange]).reshape(-1, 6, 6),
        noise_sd=np.repeat([noise.turn_rad, noise.shift_mm], 3),
        usual_factor=USUAL_FACTOR,
        least_factor=LEAST_FACTOR,
    )


def robot_motion_at(moves: FlangeMotion, T_arm_flange: Floats) -> FlangeMotion:
    """A robot's motion, with the noise of ``with_noise`` in it, for other poses (P, 4, 4)."""
    tilts = moves.by_noise[0][:, 6:]
    return replace(
        moves,
        T_arm_flange=T_arm_flange,
        by_links=np.zeros((len(T_arm_flange), 6, moves.by_links.shape[2])),
        by_noise=np.array([np.hstack([adjoint(T), tilts]) for T in T_arm_flange]),
    )


def with_noise(
    moves: FlangeMotion, noise: RobotNoise, T_arm_obj: Floats, middle_mm: Floats
) -> FlangeMotion:
    """The same, including the tilt of the object at ``T_arm_obj`` about its middle."""
    own = with_flange_noise(moves, noise)
    tilts = _tilts(T_arm_obj, apply(T_arm_obj, middle_mm[None])[0])
    return replace(
        own,
        by_noise=np.array([np.hstack([one, tilts]) for one in own.by_noise]),
        noise_sd=np.concatenate([own.noise_sd, np.full(2, noise.tilt_rad)]),
    )
