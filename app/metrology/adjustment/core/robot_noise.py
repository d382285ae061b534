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

from app.metrology.adjustment.core.arm_errors import FlangeMotion
from app.metrology.transforms import (
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
# The noise is estimated again with everything else, as a factor on these standard deviations.
USUAL_FACTOR, LEAST_FACTOR = 1.0, 0.3

# A pose is an outlier if chance alone would cause such a deviation less often than this.
OUTLIER_CHANCE = 1e-5
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
        own = (6 * kept[:, None] + np.arange(6)).ravel()
        return replace(
            self,
            T_arm_flange=self.T_arm_flange[kept],
            T_cam_obj=self.T_cam_obj[kept],
            covariance=self.covariance[np.ix_(own, own)],
        )


@dataclass(frozen=True)
class _NoiseEstimate:
    """The noise (log of standard deviations), and the resulting poses of sensor and object."""

    log_sd: Floats
    X: Floats
    Z: Floats


def estimate_robot_noise(seen: PosePairs, T_flange_cam: Floats, T_arm_obj: Floats) -> RobotNoise:
    """The most likely noise of P poses, from start values (4, 4) of the sensor and the object."""
    estimate = _fit_noise(seen, T_flange_cam, T_arm_obj)
    return RobotNoise(*map(float, np.exp(estimate.log_sd)))


def find_robot_outlier(seen: PosePairs, T_flange_cam: Floats, T_arm_obj: Floats) -> int | None:
    """The pose that is furthest off, if the noise of the others does not explain it.

    It is judged by a fit without it (Fisher's test), so that it cannot affect the fit.
    """
    from scipy.special import fdtri

    count = len(seen.T_arm_flange)
    if count <= FEWEST_OTHERS:
        return None
    estimate = _fit_noise(seen, T_flange_cam, T_arm_obj)
    squares = [_mahalanobis_square(seen, estimate, p, with_fit=False) for p in range(count)]
    worst = int(np.argmax(squares))
    others = np.delete(np.arange(count), worst)
    estimate = _fit_noise(seen.select(others), T_flange_cam, T_arm_obj)
    freedom = 6 * len(others) - 12
    limit = 6 * float(fdtri(6, freedom, 1 - OUTLIER_CHANCE))
    return worst if _mahalanobis_square(seen, estimate, worst, with_fit=True) > limit else None


def _fit_noise(seen: PosePairs, X: Floats, Z: Floats) -> _NoiseEstimate:
    from scipy.optimize import minimize  # slow to import, and needed for robots only

    noise = np.log(USUAL)
    for _ in range(ROUNDS):
        residuals, J, G = _linearise(seen, X, Z)
        found = minimize(
            _negative_log_likelihood,
            noise,
            args=(residuals, J, G, seen.covariance),
            method="Nelder-Mead",
        )
        noise = np.maximum(found.x, np.log(LEAST))
        W = np.linalg.inv(_covariance(noise, G, seen.covariance))
        step = -np.asarray(np.linalg.solve(J.T @ W @ J, J.T @ W @ residuals), np.float64)
        X, Z = np.asarray(X @ se3_exp(step[:6])), np.asarray(se3_exp(step[6:]) @ Z)
    return _NoiseEstimate(noise, X, Z)


def _mahalanobis_square(
    seen: PosePairs, estimate: _NoiseEstimate, pose: int, with_fit: bool
) -> float:
    """Squared deviation of one pose, with 6 degrees of freedom; ``with_fit`` includes the
    uncertainty of the fit to the others with which it is compared."""
    residuals, J, G = _linearise(seen, estimate.X, estimate.Z)
    V = _covariance(estimate.log_sd, G, seen.covariance)
    own = slice(6 * pose, 6 * pose + 6)
    variance = V[own, own]
    if with_fit:
        rest = np.delete(np.arange(len(residuals)), np.r_[own])
        W = np.linalg.inv(V[np.ix_(rest, rest)])
        variance = variance + J[own] @ np.linalg.inv(J[rest].T @ W @ J[rest]) @ J[own].T
    return float(residuals[own] @ np.linalg.solve(variance, residuals[own]))


def _linearise(seen: PosePairs, X: Floats, Z: Floats) -> tuple[Floats, Floats, NoiseSquares]:
    """Residuals (6P,), twists of the object in the camera frame between its poses by the pictures
    and by the robot; derivatives by ``X`` from the right and ``Z`` from the left (6P, 12); and what
    rotation, translation and tilt of each pose do."""
    residuals, rows, by_noise = [], [], []
    centre = apply(Z, seen.middle_mm[None])[0]
    for one, pictured in zip(seen.T_arm_flange, seen.T_cam_obj, strict=True):
        T_cam_arm = inverse(one @ X)
        off = pictured @ inverse(T_cam_arm @ Z)
        residuals.append(np.concatenate([vector_from_rotation(off[:3, :3]), off[:3, 3]]))
        in_cam = adjoint(T_cam_arm)
        rows.append(np.hstack([np.eye(6), -in_cam]))
        of_flange = in_cam @ adjoint(one)
        ways = (of_flange[:, :3], of_flange[:, 3:], in_cam @ _tilts(Z, centre))
        by_noise.append([way @ way.T for way in ways])
    squares = np.swapaxes(np.array(by_noise), 0, 1)
    return np.concatenate(residuals), np.concatenate(rows), squares


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
    L = np.linalg.cholesky(V)
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
