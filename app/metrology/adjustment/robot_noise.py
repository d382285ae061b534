"""By how much a robot's poses and the pictures disagree, and in what way.

The robot is off by a turn and by a shift of its flange, drawn anew in each pose; and
pictures and robot may disagree in how the object is tilted while they agree on its place:
it rocks, or the pictures' errors look like a tilt. The three standard deviations are the
most likely ones for the poses' residuals (restricted maximum likelihood), which tells how
much each counts.
"""

from dataclasses import dataclass, replace

import numpy as np
from scipy.optimize import minimize

from app.metrology.adjustment.arm_motion import FlangeMotion
from app.metrology.adjustment.twists import about, carried, motion
from app.metrology.frames import Floats, apply, inverse, vector_from_rotation

# What is usual where the poses tell little: turn (rad), shift (mm) and tilt (rad), known to
# this factor (as the standard deviation of a logarithm).
USUAL = np.array([0.2e-3, 0.08, 0.1e-3])
USUAL_LOG_SD = 1.5
LEAST = np.array([1e-6, 1e-3, 1e-6])
ROUNDS = 3
# The noise is told anew with everything else, as a factor on these deviations.
USUAL_FACTOR, LEAST_FACTOR = 1.0, 0.3

ByNoise = list[tuple[Floats, Floats, Floats]]


@dataclass(frozen=True)
class RobotNoise:
    """Standard deviations of one pose: the flange's turn (rad) about each axis and shift (mm)
    along each, and the object's tilt (rad) about its own middle."""

    turn_rad: float
    shift_mm: float
    tilt_rad: float


def robot_noise(
    T_arm_flange: Floats,
    T_cam_obj: Floats,
    covariance: Floats,
    T_flange_cam: Floats,
    T_arm_obj: Floats,
    middle_mm: Floats,
) -> RobotNoise:
    """The most likely noise of P poses.

    Args:
        T_arm_flange, T_cam_obj: (P, 4, 4) by the robot and by the pictures.
        covariance: (6P, 6P) of the pictures' left twists of ``T_cam_obj``.
        T_flange_cam, T_arm_obj: (4, 4), a start.
        middle_mm: (3,) about which the object tilts, in its own frame.
    """
    X, Z = T_flange_cam, T_arm_obj
    noise = np.log(USUAL)
    for _ in range(ROUNDS):
        residuals, J, G = _linearised(T_arm_flange, T_cam_obj, X, Z, middle_mm)
        found = minimize(_unlikely, noise, args=(residuals, J, G, covariance), method="Nelder-Mead")
        noise = np.maximum(found.x, np.log(LEAST))
        W = np.linalg.inv(_covariance(noise, G, covariance))
        step = -np.asarray(np.linalg.solve(J.T @ W @ J, J.T @ W @ residuals), np.float64)
        X, Z = np.asarray(X @ motion(step[:6])), np.asarray(motion(step[6:]) @ Z)
    return RobotNoise(*map(float, np.exp(noise)))


def _linearised(
    A: Floats, B: Floats, X: Floats, Z: Floats, middle_mm: Floats
) -> tuple[Floats, Floats, ByNoise]:
    """Residuals (6P,), twists of the object in the camera's frame by which the pictures put it
    elsewhere than the robot does; by ``X`` from the right and ``Z`` from the left (6P, 12); and
    by turn (6, 3), shift (6, 3) and tilt (6, 2) of each pose."""
    residuals, rows, by_noise = [], [], []
    centre = apply(Z, middle_mm[None])[0]
    for one, seen in zip(A, B, strict=True):
        T_cam_arm = inverse(one @ X)
        off = seen @ inverse(T_cam_arm @ Z)
        residuals.append(np.concatenate([vector_from_rotation(off[:3, :3]), off[:3, 3]]))
        in_cam = carried(T_cam_arm)
        rows.append(np.hstack([np.eye(6), -in_cam]))
        of_flange = in_cam @ carried(one)
        tilt = in_cam @ _tilts(Z, centre)
        by_noise.append((of_flange[:, :3], of_flange[:, 3:], tilt))
    return np.concatenate(residuals), np.concatenate(rows), by_noise


def _tilts(T_arm_obj: Floats, centre_mm: Floats) -> Floats:
    """(6, 2) twists in the arm's frame that tilt the object, about its own x and y."""
    return np.asarray(about(centre_mm)[:, :3] @ T_arm_obj[:3, :2])


def _covariance(log_sd: Floats, by_noise: ByNoise, covariance: Floats) -> Floats:
    V = covariance.copy()
    for p, each in enumerate(by_noise):
        own = slice(6 * p, 6 * p + 6)
        for variance, way in zip(np.exp(2 * log_sd), each, strict=True):
            V[own, own] += variance * way @ way.T
    return V


def _unlikely(
    log_sd: Floats, residuals: Floats, J: Floats, by_noise: ByNoise, covariance: Floats
) -> float:
    """Minus the logarithm of the restricted likelihood, and of what is usual."""
    off = (log_sd - np.log(USUAL)) / USUAL_LOG_SD
    V = _covariance(np.maximum(log_sd, np.log(LEAST)), by_noise, covariance)
    W = np.linalg.inv(V)
    JWJ = J.T @ W @ J
    left = residuals - J @ np.linalg.solve(JWJ, J.T @ W @ residuals)
    square = float(left @ W @ left)
    size = float(np.linalg.slogdet(V)[1] + np.linalg.slogdet(JWJ)[1])
    return 0.5 * (square + size + float(off @ off))


def with_flange_noise(moves: FlangeMotion, noise: RobotNoise) -> FlangeMotion:
    """The robot's motion with its flange's noise in these proportions."""
    return replace(
        moves,
        by_noise=np.array([carried(T) for T in moves.T_arm_flange]).reshape(-1, 6, 6),
        noise_sd=np.repeat([noise.turn_rad, noise.shift_mm], 3),
        usual_factor=USUAL_FACTOR,
        least_factor=LEAST_FACTOR,
    )


def with_noise(
    moves: FlangeMotion, noise: RobotNoise, T_arm_obj: Floats, middle_mm: Floats
) -> FlangeMotion:
    """The same, and with the tilt of the object at ``T_arm_obj`` about its middle."""
    own = with_flange_noise(moves, noise)
    tilts = _tilts(T_arm_obj, apply(T_arm_obj, middle_mm[None])[0])
    return replace(
        own,
        by_noise=np.array([np.hstack([one, tilts]) for one in own.by_noise]),
        noise_sd=np.concatenate([own.noise_sd, np.full(2, noise.tilt_rad)]),
    )
