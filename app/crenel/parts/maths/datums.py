"""The part's frame from its datums: each fixes what those before it have left free.

The primary datum is met first, by least squares of its own conditions; the next ones within the
motions that remain. A best fit meets all at once.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.metrology.transforms import Floats, inverse, nearest_rotation, se3_exp
from crenel.parts.maths.shapes import Shape

ROUNDS = 30
CLOSE = 1e-11
WEAK = 1e-3
"""A condition that moves the part less than this, for its size, fixes nothing."""
MOTION_NAMES = ("rx", "ry", "rz", "x", "y", "z")


@dataclass(frozen=True)
class Datum:
    """A feature as it should be in the part frame, and as it was measured in the arm frame."""

    nominal: Shape
    measured: Shape


def align_datums(
    stages: Sequence[Sequence[Datum]],
    T_arm_part: Floats,
    size_mm: float,
    locked: Sequence[str] = (),
) -> Floats:
    """``T_arm_part`` that meets stages of datums one after the other.

    Args:
        stages: each is met by least squares within what those before it leave free.
        T_arm_part: (4, 4) start.
        size_mm: of the part; converts rotations.
        locked: names of ``MOTION_NAMES`` that stay as in the start.

    Raises:
        OperationError: ``alignment-free``: a motion stays free.
    """
    T = T_arm_part
    open_motions = np.eye(6)[:, [k for k, name in enumerate(MOTION_NAMES) if name not in locked]]
    scale = np.repeat([1 / size_mm, 1.0], 3)
    for _ in range(ROUNDS):
        step, free = np.zeros(6), open_motions
        for stage in stages:
            rows = [_conditions(one, inverse(T), size_mm) for one in stage]
            J = np.concatenate([J for J, _ in rows]) * scale
            off = np.concatenate([off for _, off in rows]) + J @ step
            U, sizes, Vt = np.linalg.svd(J @ free, full_matrices=True)
            rank = int((sizes > WEAK).sum())
            along = free @ Vt[:rank].T
            step = step - along @ ((U[:, :rank].T @ off) / sizes[:rank])
            free = free @ Vt[rank:].T
        if free.shape[1]:
            raise _freedom_error(free)
        T = T @ se3_exp(scale * step)
        T[:3, :3] = nearest_rotation(T[:3, :3])
        if np.abs(step).max() < CLOSE * size_mm:
            break
    return T


def _conditions(datum: Datum, T_part_arm: Floats, size_mm: float) -> tuple[Floats, Floats]:
    """Conditions (R, 6) by a right twist (rad, mm) of ``T_arm_part``, and how far they are from
    being met (R,), in mm at the part's edge."""
    nominal, found = datum.nominal, datum.measured.move(T_part_arm)
    p, (a, b, n) = nominal.origin_mm, nominal.T[:3, :3].T
    rows: list[Floats] = []
    off: list[float] = []

    def turn(axis: Floats, direction: Floats) -> None:
        rows.append(size_mm * np.concatenate([-np.cross(direction, axis), np.zeros(3)]))
        off.append(size_mm * float(axis @ direction))

    def place(axis: Floats, at_mm: Floats) -> None:
        rows.append(-np.concatenate([np.cross(p, axis), axis]))
        off.append(float(axis @ (at_mm - p)))

    direction = found.direction * np.sign(float(found.direction @ n) or 1.0)
    if nominal.kind in ("plane", "cylinder", "cone", "torus"):
        turn(a, direction)
        turn(b, direction)
    if nominal.kind == "plane":
        along = float((found.origin_mm - p) @ direction) / float(n @ direction)
        place(n, p + along * n)
    elif nominal.kind in ("sphere", "torus"):
        for axis in (a, b, n):
            place(axis, found.origin_mm)
    else:
        at_mm = meet_plane(found, p, n)
        place(a, at_mm)
        place(b, at_mm)
    if nominal.kind == "slot":
        run = found.T[:3, 0] * np.sign(float(found.T[:3, 0] @ a) or 1.0)
        turn(b, run)
    return np.array(rows), np.array(off)


def meet_plane(shape: Shape, point_mm: Floats, normal: Floats) -> Floats:
    """(3,) where a feature's axis meets a plane; the axis' nearest point where it runs along it."""
    d = shape.direction
    rise = float(d @ normal)
    if abs(rise) < 1e-3:
        return np.asarray(shape.origin_mm + d * float((point_mm - shape.origin_mm) @ d))
    return np.asarray(shape.origin_mm + d * (float((point_mm - shape.origin_mm) @ normal) / rise))


def _freedom_error(free: Floats) -> OperationError:
    turns = np.linalg.norm(free[:3], axis=1)
    shifts = np.linalg.norm(free[3:], axis=1)
    axis = "xyz"[int(np.argmax(turns if turns.max() > 0.5 else shifts))]
    kind = "turn" if turns.max() > 0.5 else "shift"
    return OperationError(
        "alignment-free",
        message("part-alignment-leaves-free", kind=kind, axis=axis),
        message("part-datums-do-not-fix-it"),
        message("part-add-datum-or-lock", name=f"r{axis}" if kind == "turn" else axis),
    )
