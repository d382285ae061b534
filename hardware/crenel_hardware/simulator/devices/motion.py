"""Where the simulated arm's joints truly are at any moment: smooth paths, holds, a tremor."""

import threading
from collections import deque
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

from crenel_hardware.simulator.devices.kinematics import ArmModel, Floats, flange_pose, follow_poses

KNOTS = 24
FASTEST_RAD_S = 4.0
"""The simulated operator moves no joint faster."""
STORED_PIECES = 16
HALT_S = 0.12
RAMP_S = 0.15


@dataclass(frozen=True)
class JointPath:
    """Joint angles (K, n) at times (K,) in seconds from its start; begins and ends at rest."""

    times_s: Floats
    q_rad: Floats

    @property
    def duration_s(self) -> float:
        return float(self.times_s[-1])


@dataclass(frozen=True)
class _Piece:
    start_ns: int
    end_ns: int
    spline: CubicSpline
    trembles: bool

    @cached_property
    def last_q_rad(self) -> Floats:
        """(n,) where it ends."""
        return np.asarray(self.spline((self.end_ns - self.start_ns) / 1e9))


class Motion:
    """The true joint angles over time. Written by the simulated operator, read by arm and sensor.

    Any thread may ask for a moment of the last seconds or of the near future.
    """

    def __init__(self, q_rad: Floats, tremor_rad: float = 0.0, seed: int = 0) -> None:
        self._lock = threading.Lock()
        self._tremor_rad = tremor_rad
        rng = np.random.default_rng(seed)
        self._tones_hz = rng.uniform(6.0, 11.0, (3, len(q_rad)))
        self._phases = rng.uniform(0.0, 2 * np.pi, (3, len(q_rad)))
        resting = _Piece(0, 0, _spline(np.array([0.0, 1e-3]), np.stack([q_rad, q_rad])), True)
        self._pieces: deque[_Piece] = deque([resting], maxlen=STORED_PIECES)
        self._seen_ns = 0
        """The last moment that somebody has seen: what comes later is open."""

    def play(self, path: JointPath, start_ns: int, trembles: bool = False) -> int:
        """Moves along a path from ``start_ns``, or from when nobody knows yet where the arm is: it
        does not jump if a busy machine is late. Returns when it ends. ``trembles``: once there."""
        spline = _spline(path.times_s, path.q_rad)
        with self._lock:
            start_ns = max(start_ns, self._seen_ns)
            end_ns = start_ns + round(path.duration_s * 1e9)
            self._pieces.append(_Piece(start_ns, end_ns, spline, trembles))
        return end_ns

    def halt(self, now_ns: int) -> None:
        """Comes to rest from wherever it is, without a jerk."""
        with self._lock:
            now_ns = max(now_ns, self._seen_ns)
            piece = self._piece_at(now_ns)
            if now_ns >= piece.end_ns:
                return
            at = (now_ns - piece.start_ns) / 1e9
            q, v = piece.spline(at), piece.spline(at, 1)
            spline = CubicSpline(
                [0.0, HALT_S], np.stack([q, q + v * HALT_S / 3]), bc_type=((1, v), (1, 0 * v))
            )
            end_ns = now_ns + round(HALT_S * 1e9)
            self._pieces.append(_Piece(now_ns, end_ns, spline, piece.trembles))

    def at(self, stamp_ns: int) -> Floats:
        """(n,) true joint angles at a moment."""
        return np.asarray(self.at_all(np.array([stamp_ns]))[0])

    def at_all(self, stamps_ns: NDArray[np.int64]) -> Floats:
        """(N, n) true joint angles at ascending moments."""
        with self._lock:
            self._seen_ns = max(self._seen_ns, int(stamps_ns[-1]))
            pieces = [self._piece_at(int(stamp)) for stamp in (stamps_ns[0], stamps_ns[-1])]
            if pieces[0] is pieces[1]:
                return self._evaluate(pieces[0], stamps_ns)
            return np.concatenate(
                [self._evaluate(self._piece_at(int(t)), t[None]) for t in stamps_ns]
            )

    def is_resting(self, stamp_ns: int) -> bool:
        """Whether the simulated operator moved nothing at that moment (it may have trembled)."""
        with self._lock:
            return stamp_ns >= self._piece_at(stamp_ns).end_ns

    def _piece_at(self, stamp_ns: int) -> _Piece:
        for piece in reversed(self._pieces):
            if piece.start_ns <= stamp_ns:
                return piece
        return self._pieces[0]

    def _evaluate(self, piece: _Piece, stamps_ns: NDArray[np.int64]) -> Floats:
        held_s = (stamps_ns - piece.end_ns) / 1e9
        if held_s[0] >= 0:  # at rest, as most of the time
            q = np.broadcast_to(piece.last_q_rad, (len(stamps_ns), len(piece.last_q_rad)))
        else:
            inside = np.clip(stamps_ns, piece.start_ns, piece.end_ns)
            q = piece.spline((inside - piece.start_ns) / 1e9)
        if piece.trembles and self._tremor_rad > 0:
            t = (stamps_ns / 1e9)[:, None, None]
            shake = np.sin(2 * np.pi * self._tones_hz * t + self._phases).sum(axis=1)
            q = q + self._tremor_rad * np.clip(held_s / RAMP_S, 0.0, 1.0)[:, None] * shake
        return np.asarray(q)


def _spline(times_s: Floats, q_rad: Floats) -> CubicSpline:
    return CubicSpline(times_s, q_rad, bc_type="clamped")


def min_jerk_progress(share: Floats) -> Floats:
    """Least-jerk progress from 0 to 1."""
    return np.asarray(share**3 * (10 - 15 * share + 6 * share**2))


def interpolate_rotation(a: Floats, b: Floats, share: float) -> Floats:
    """(3, 3) rotation a part of the way from one to another."""
    turn = a.T @ b
    w = np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]])
    sine = float(np.linalg.norm(w)) / 2
    angle = float(np.arctan2(sine, (np.trace(turn) - 1) / 2))
    if angle < 1e-9:
        return b
    x, y, z = w / (2 * sine)
    K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    part = angle * share
    return np.asarray(a @ (np.eye(3) + np.sin(part) * K + (1 - np.cos(part)) * K @ K))


def plan_path(arm: ArmModel, poses: Floats, q_rad: Floats, duration_s: float) -> JointPath:
    """A path through flange poses (K, 4, 4) that are even in progress; slowed where too fast.

    Raises:
        UnreachableError: the arm cannot follow.
    """
    q = np.vstack([q_rad, follow_poses(arm, poses[1:], q_rad)])
    times = np.linspace(0.0, duration_s, len(q))
    fastest = float(np.max(np.abs(np.diff(q, axis=0)) / np.diff(times)[:, None]))
    return JointPath(times * max(1.0, fastest / FASTEST_RAD_S), q)


def plan_approach(
    arm: ArmModel,
    q_rad: Floats,
    target: Floats,
    tool_mm: Floats,
    lifts_mm: tuple[Floats, Floats],
    duration_s: float,
) -> JointPath:
    """A path from where the arm is to a flange pose, leading a point of the tool along a curve.

    Args:
        target: (4, 4) flange pose at the end.
        tool_mm: (3,) point of the flange that is led along a Bezier curve.
        lifts_mm: where the curve is drawn to from its beginning and its end, arm frame.

    Raises:
        UnreachableError: the arm cannot follow.
    """
    start = flange_pose(arm, q_rad)
    p0 = start[:3, :3] @ tool_mm + start[:3, 3]
    p3 = target[:3, :3] @ tool_mm + target[:3, 3]
    p1, p2 = p0 + lifts_mm[0], p3 + lifts_mm[1]
    poses = np.tile(np.eye(4), (KNOTS, 1, 1))
    for pose, s in zip(poses, min_jerk_progress(np.linspace(0.0, 1.0, KNOTS)), strict=True):
        r = 1 - s
        point = r**3 * p0 + 3 * r**2 * s * p1 + 3 * r * s**2 * p2 + s**3 * p3
        pose[:3, :3] = interpolate_rotation(start[:3, :3], target[:3, :3], float(s))
        pose[:3, 3] = point - pose[:3, :3] @ tool_mm
    return plan_path(arm, poses, q_rad, duration_s)
