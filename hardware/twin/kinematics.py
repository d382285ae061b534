"""How the simulated arm stands in space: standard Denavit-Hartenberg links, and their inverse.

A link is ``A = Rz(sign q + theta) Tz(d) Tx(a) Rx(alpha)``, followed by what the
workshop got wrong, ``E = T(x, y, z) Rz(rz) Ry(ry) Rx(rx)``.
"""

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from hardware.compiled import kernel

Floats = NDArray[np.float64]
WrongIn = Literal["links", "parameters"]

ROTATION_LEVER_MM = 200.0
"""One radian of orientation weighs as much as this length when poses are compared."""
REACHED_MM = 1e-7
JUMP_RAD = 0.6
"""No joint turns so far between neighbours of a path; it would be another posture."""


class UnreachableError(ValueError):
    """No joint angles within the limits bring the arm to a pose."""


@dataclass(frozen=True)
class Link:
    """One rotary joint and the link behind it, as truly built."""

    a_mm: float
    alpha_rad: float
    d_mm: float
    theta_rad: float = 0.0
    sign: int = 1
    limits_rad: tuple[float, float] = (-3.05, 3.05)
    error_mm_rad: tuple[float, float, float, float, float, float] = (0.0,) * 6
    """x, y, z in mm and rx, ry, rz in rad of the error transform behind the link."""


@dataclass(frozen=True)
class ArmModel:
    """A chain of links with a touch probe; ``tip_mm`` is its sphere's centre on the flange."""

    links: tuple[Link, ...]
    tip_mm: tuple[float, float, float]
    tip_diameter_mm: float
    encoder_sd_rad: float = 1e-5
    name: str = "simulated arm"
    serial_number: str = "TWIN-A1"

    @property
    def joint_count(self) -> int:
        return len(self.links)

    @property
    def dh(self) -> Floats:
        """(n, 5): a, alpha, d, theta, sign of each link."""
        return np.array(
            [[k.a_mm, k.alpha_rad, k.d_mm, k.theta_rad, float(k.sign)] for k in self.links]
        )

    @property
    def errors(self) -> Floats:
        """(n, 4, 4): the error transform behind each link."""
        return np.array([_error_matrix(*k.error_mm_rad) for k in self.links])

    @property
    def limits_rad(self) -> Floats:
        """(n, 2): lowest and highest encoder angle."""
        return np.array([k.limits_rad for k in self.links])


def _error_matrix(x: float, y: float, z: float, rx: float, ry: float, rz: float) -> Floats:
    E = rotation_about("z", rz) @ rotation_about("y", ry) @ rotation_about("x", rx)
    E[:3, 3] = x, y, z
    return E


def rotation_about(axis: str, angle_rad: float) -> Floats:
    """(4, 4) rotation about a coordinate axis, right-handed."""
    c, s = np.cos(angle_rad), np.sin(angle_rad)
    T = np.eye(4)
    i, j = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
    T[i, i], T[i, j], T[j, i], T[j, j] = c, -s, s, c
    return T


def translation(x: float, y: float, z: float) -> Floats:
    """(4, 4) shift."""
    T = np.eye(4)
    T[:3, 3] = x, y, z
    return T


@kernel
def _chain(dh: Floats, errors: Floats, q: Floats) -> tuple[Floats, Floats]:
    """Pose (4, 4) of the flange, and (n, 6) axis and origin of every joint in the arm frame."""
    n = dh.shape[0]
    T = np.eye(4)
    axes = np.empty((n, 6))
    A = np.zeros((4, 4))
    A[3, 3] = 1.0
    for i in range(n):
        a, alpha, d, theta, sign = dh[i, 0], dh[i, 1], dh[i, 2], dh[i, 3], dh[i, 4]
        for k in range(3):
            axes[i, k] = sign * T[k, 2]
            axes[i, 3 + k] = T[k, 3]
        angle = sign * q[i] + theta
        c, s = np.cos(angle), np.sin(angle)
        ca, sa = np.cos(alpha), np.sin(alpha)
        A[0, 0], A[0, 1], A[0, 2], A[0, 3] = c, -s * ca, s * sa, a * c
        A[1, 0], A[1, 1], A[1, 2], A[1, 3] = s, c * ca, -c * sa, a * s
        A[2, 1], A[2, 2], A[2, 3] = sa, ca, d
        T = np.dot(np.dot(T, A), errors[i])
    return T, axes


@kernel
def _chains(dh: Floats, errors: Floats, q: Floats) -> Floats:
    """Flange poses (N, 4, 4) for angles (N, n)."""
    poses = np.empty((q.shape[0], 4, 4))
    for i in range(q.shape[0]):
        T, _ = _chain(dh, errors, q[i])
        poses[i] = T
    return poses


@kernel
def _misfit(T: Floats, target: Floats) -> Floats:
    """(6,): how far the target is from T, in mm, turns weighed by the lever."""
    e = np.empty(6)
    R = np.dot(target[:3, :3].copy(), T[:3, :3].copy().T)
    for k in range(3):
        e[k] = target[k, 3] - T[k, 3]
    wx, wy, wz = R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]
    sine = 0.5 * np.sqrt(wx * wx + wy * wy + wz * wz)
    cosine = 0.5 * (R[0, 0] + R[1, 1] + R[2, 2] - 1.0)
    angle = np.arctan2(sine, cosine)
    scale = 0.5 * angle / sine if sine > 1e-12 else 0.5
    e[3], e[4], e[5] = wx * scale * 200.0, wy * scale * 200.0, wz * scale * 200.0
    return e


@kernel
def _descend(
    dh: Floats, errors: Floats, limits: Floats, start: Floats, target: Floats, steps: int
) -> tuple[Floats, float]:
    """Damped least squares from ``start``; the angles and the norm of what misfits, in mm."""
    n = dh.shape[0]
    q = start.copy()
    T, axes = _chain(dh, errors, q)
    e = _misfit(T, target)
    norm = np.sqrt(np.sum(e * e))
    damping = 1e-2
    J = np.empty((6, n))
    for _ in range(steps):
        if norm < 1e-9 or damping > 1e8:
            break
        for i in range(n):
            ax, ay, az = axes[i, 0], axes[i, 1], axes[i, 2]
            rx, ry, rz = T[0, 3] - axes[i, 3], T[1, 3] - axes[i, 4], T[2, 3] - axes[i, 5]
            J[0, i], J[1, i], J[2, i] = ay * rz - az * ry, az * rx - ax * rz, ax * ry - ay * rx
            J[3, i], J[4, i], J[5, i] = ax * 200.0, ay * 200.0, az * 200.0
        H = np.dot(J.T.copy(), J)
        for i in range(n):
            H[i, i] += damping * 1e2
        dq = np.linalg.solve(H, np.dot(J.T.copy(), e))
        largest = np.max(np.abs(dq))
        if largest > 0.4:
            dq *= 0.4 / largest
        trial = q + dq
        for i in range(n):
            trial[i] = min(max(trial[i], limits[i, 0]), limits[i, 1])
        T2, axes2 = _chain(dh, errors, trial)
        e2 = _misfit(T2, target)
        norm2 = np.sqrt(np.sum(e2 * e2))
        if norm2 < norm:
            q, T, axes, e, norm = trial, T2, axes2, e2, norm2
            damping = max(damping * 0.2, 1e-9)  # solvable in a singular posture, too
        else:
            damping *= 6.0
    return q, norm


def flange_pose(arm: ArmModel, q_rad: Floats) -> Floats:
    """Where the flange truly is, (4, 4), for encoder angles (n,)."""
    return np.asarray(_chain(arm.dh, arm.errors, np.asarray(q_rad, dtype=np.float64))[0])


def flange_poses(arm: ArmModel, q_rad: Floats) -> Floats:
    """Where the flange truly is, (N, 4, 4), for encoder angles (N, n)."""
    return np.asarray(_chains(arm.dh, arm.errors, np.ascontiguousarray(q_rad, dtype=np.float64)))


def tip_centre(arm: ArmModel, q_rad: Floats) -> Floats:
    """(3,) true centre of the probe's sphere in the arm frame."""
    T = flange_pose(arm, q_rad)
    return np.asarray(T[:3, :3] @ np.array(arm.tip_mm) + T[:3, 3])


def follow(arm: ArmModel, targets: Floats, start_rad: Floats) -> Floats:
    """Joint angles (N, n) along a path of flange poses (N, 4, 4), each near the last.

    Raises:
        UnreachableError: the path leaves the arm's reach or its joints' limits.
    """
    dh, errors, limits = arm.dh, arm.errors, arm.limits_rad
    q = np.asarray(start_rad, dtype=np.float64)
    path = np.empty((len(targets), arm.joint_count))
    for i, target in enumerate(targets):
        before = q
        q, misfit = _descend(dh, errors, limits, q, np.ascontiguousarray(target), 60)
        if misfit > REACHED_MM:
            raise UnreachableError(f"point {i} of the path misses by {misfit:.3g} mm")
        if np.max(np.abs(q - before)) > JUMP_RAD:
            raise UnreachableError(f"the arm would have to flip over at point {i} of the path")
        path[i] = q
    return path


def reach(
    arm: ArmModel,
    target: Floats,
    start_rad: Floats,
    rng: np.random.Generator,
    attempts: int = 80,
) -> Floats:
    """Joint angles (n,) for a flange pose (4, 4), tried from ``start_rad`` first, then at random.

    Raises:
        UnreachableError: none was found within the joints' limits.
    """
    dh, errors, limits = arm.dh, arm.errors, arm.limits_rad
    target = np.ascontiguousarray(target, dtype=np.float64)
    seed = np.asarray(start_rad, dtype=np.float64)
    for _ in range(attempts):
        q, misfit = _descend(dh, errors, limits, seed, target, 150)
        if misfit < REACHED_MM:
            return np.asarray(q)
        seed = rng.uniform(limits[:, 0], limits[:, 1])
    raise UnreachableError(f"no joint angles reach {np.round(target[:3, 3], 1).tolist()} mm")


def _with_parameters_off(link: Link, by: Floats) -> Link:
    """A link whose parameters are off along and about x and z, of ``by`` (6,) as of an error."""
    return replace(
        link,
        a_mm=link.a_mm + float(by[0]),
        d_mm=link.d_mm + float(by[2]),
        alpha_rad=link.alpha_rad + float(by[3]),
        theta_rad=link.theta_rad + float(by[5]),
    )


def imperfect(
    arm: ArmModel, rms_um: float, rng: np.random.Generator, wrong_in: WrongIn = "links"
) -> ArmModel:
    """The arm as it really is, with errors that its papers do not know.

    ``rms_um`` is the rms error of the tip over the arm's joint space that is left
    after the best rigid placement of the whole arm. ``wrong_in``: its links, each with an
    error of all six kinds behind it, or the four Denavit-Hartenberg parameters of each.
    """
    if rms_um == 0:
        return arm
    unit = rng.normal(size=(arm.joint_count, 6)) * np.array([1, 1, 1, 3e-3, 3e-3, 3e-3]) * 1e-2
    probe = rng.uniform(0.6 * arm.limits_rad[:, 0], 0.6 * arm.limits_rad[:, 1], (200, len(unit)))

    def with_errors(scale: float) -> ArmModel:
        rows = zip(arm.links, unit * scale, strict=True)
        if wrong_in == "parameters":
            return replace(arm, links=tuple(_with_parameters_off(*row) for row in rows))
        links = []
        for link, row in rows:
            x, y, z, rx, ry, rz = (float(value) for value in row)
            links.append(replace(link, error_mm_rad=(x, y, z, rx, ry, rz)))
        return replace(arm, links=tuple(links))

    def tips(model: ArmModel) -> Floats:
        T = flange_poses(model, probe)
        return np.asarray(T[:, :3, :3] @ np.array(arm.tip_mm) + T[:, :3, 3])

    ideal, off = tips(arm), tips(with_errors(1.0))
    T = rigid_fit(ideal, off)
    left = ideal @ T[:3, :3].T + T[:3, 3] - off
    return with_errors(rms_um * 1e-3 / float(np.sqrt(np.mean(np.sum(left**2, axis=1)))))


def rigid_fit(a: Floats, b: Floats) -> Floats:
    """``T_ba`` (4, 4) that lays points ``a`` (N, 3) best on their partners ``b`` (N, 3)."""
    ca, cb = a.mean(axis=0), b.mean(axis=0)
    U, _, Vt = np.linalg.svd((a - ca).T @ (b - cb))
    flip = np.diag([1.0, 1.0, np.sign(np.linalg.det(U @ Vt))])
    T = np.eye(4)
    T[:3, :3] = (U @ flip @ Vt).T
    T[:3, 3] = cb - T[:3, :3] @ ca
    return T
