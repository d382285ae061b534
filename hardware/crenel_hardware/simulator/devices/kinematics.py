"""How the simulated arm stands in space: standard Denavit-Hartenberg links, and their inverse.

A link is ``A = Rz(sign q + theta) Tz(d) Tx(a) Rx(alpha)``, followed by what the
workshop got wrong, ``E = T(x, y, z) Rz(rz) Ry(ry) Rx(rx)``.
"""

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from crenel.native.arguments import F64, Array, Function, Integer, Real
from crenel_hardware.simulator.native import SIMULATOR

Floats = NDArray[np.float64]
ErrorSource = Literal["links", "parameters"]

SOLVED_MM = 1e-7
"""Norm of what a pose misses, a radian of orientation weighing as much as 200 mm."""
MAX_JOINTS = 16
JUMP_RAD = 0.6
"""No joint turns so far between neighbours of a path; it would be another posture."""


ARM = (Array(F64, "n", 5), Array(F64, "n", 4, 4))
_flange_poses = Function(
    SIMULATOR, "flange_poses", *ARM, Array(F64, "N", "n"), Array(F64, "N", 4, 4, written=True)
)
_follow = Function(
    SIMULATOR,
    "follow",
    *ARM,
    Array(F64, "n", 2),
    Array(F64, "n"),
    Array(F64, "N", 4, 4),
    Array(F64, "N", "n", written=True),
    Array(F64, "N", written=True),
    Real(),
    Real(),
    Integer(),
    returns=int,
)


class UnreachableError(ValueError):
    """No joint angles within the limits bring the arm to a pose."""


@dataclass(frozen=True)
class ArmLink:
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

    links: tuple[ArmLink, ...]
    tip_mm: tuple[float, float, float]
    tip_diameter_mm: float
    encoder_sd_rad: float = 1e-5
    name: str = "simulated arm"
    serial_number: str = "TWIN-A1"

    def __post_init__(self) -> None:
        if len(self.links) > MAX_JOINTS:
            raise ValueError(f"an arm may have {MAX_JOINTS} joints, not {len(self.links)}")

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


def flange_pose(arm: ArmModel, q_rad: Floats) -> Floats:
    """Where the flange truly is, (4, 4), for encoder angles (n,)."""
    return np.asarray(flange_poses(arm, np.asarray(q_rad)[None])[0])


def flange_poses(arm: ArmModel, q_rad: Floats) -> Floats:
    """Where the flange truly is, (N, 4, 4), for encoder angles (N, n)."""
    poses = np.empty((len(q_rad), 4, 4))
    _flange_poses(arm.dh, arm.errors, np.ascontiguousarray(q_rad, dtype=np.float64), poses)
    return poses


def tip_centre(arm: ArmModel, q_rad: Floats) -> Floats:
    """(3,) true centre of the probe's sphere in the arm frame."""
    return np.asarray(tip_centres(arm, q_rad[None])[0])


def tip_centres(arm: ArmModel, q_rad: Floats) -> Floats:
    """(N, 3) the same for encoder angles (N, n)."""
    T = flange_poses(arm, q_rad)
    return np.asarray(T[:, :3, :3] @ np.array(arm.tip_mm) + T[:, :3, 3])


def follow_poses(arm: ArmModel, targets: Floats, start_rad: Floats) -> Floats:
    """Joint angles (N, n) along a path of flange poses (N, 4, 4), each near the last.

    Raises:
        UnreachableError: the path leaves the arm's reach or its joints' limits.
    """
    path, misfits_mm = _descend(arm, targets, start_rad, JUMP_RAD, 60)
    i = len(path)
    if i == len(targets):
        return path
    if misfits_mm[i] <= SOLVED_MM:
        raise UnreachableError(f"the arm would have to flip over at point {i} of the path")
    raise UnreachableError(f"point {i} of the path misses by {misfits_mm[i]:.3g} mm")


def solve_joints(
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
    limits = arm.limits_rad
    start = start_rad
    for _ in range(attempts):
        path, _ = _descend(arm, target[None], start, np.inf, 150)
        if len(path):
            return np.asarray(path[0])
        start = rng.uniform(limits[:, 0], limits[:, 1])
    raise UnreachableError(f"no joint angles reach {np.round(target[:3, 3], 1).tolist()} mm")


def _descend(
    arm: ArmModel, targets: Floats, start_rad: Floats, jump_rad: float, steps: int
) -> tuple[Floats, Floats]:
    """Joint angles (M, n) for flange poses (N, 4, 4), up to the first that is not reached from the
    one before, and what of each is missed (N,) mm; further ones are not filled."""
    path, misfits_mm = np.empty((len(targets), arm.joint_count)), np.empty(len(targets))
    reached = _follow(
        arm.dh,
        arm.errors,
        arm.limits_rad,
        np.ascontiguousarray(start_rad, dtype=np.float64),
        np.ascontiguousarray(targets, dtype=np.float64),
        path,
        misfits_mm,
        SOLVED_MM,
        jump_rad,
        steps,
    )
    return path[:reached], misfits_mm


def _offset_parameters(link: ArmLink, by: Floats) -> ArmLink:
    """A link whose parameters are off along and about x and z, of ``by`` (6,) as of an error."""
    return replace(
        link,
        a_mm=link.a_mm + float(by[0]),
        d_mm=link.d_mm + float(by[2]),
        alpha_rad=link.alpha_rad + float(by[3]),
        theta_rad=link.theta_rad + float(by[5]),
    )


def perturb_arm(
    arm: ArmModel, rms_um: float, rng: np.random.Generator, wrong_in: ErrorSource = "links"
) -> ArmModel:
    """The arm as it really is, with errors that its datasheet does not state.

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
            return replace(arm, links=tuple(_offset_parameters(*row) for row in rows))
        links = []
        for link, row in rows:
            x, y, z, rx, ry, rz = (float(value) for value in row)
            links.append(replace(link, error_mm_rad=(x, y, z, rx, ry, rz)))
        return replace(arm, links=tuple(links))

    ideal, off = tip_centres(arm, probe), tip_centres(with_errors(1.0), probe)
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
