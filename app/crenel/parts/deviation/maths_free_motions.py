"""Motions of a part that its measured surface does not fix: of a plane, a cylinder, a sphere."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from crenel.metrology.transforms import Floats
from crenel.parts.maths.datums import MOTION_NAMES

LEAST = 1e-4
"""A motion that changes squared distances by less, of what the largest does, is free."""
TURNS = 1e-3
"""A motion whose turn moves the part's edge by less than this, of its shift, is a shift."""
ALONG_AXIS = 0.999


@dataclass(frozen=True)
class FreeMotion:
    """A turn about an axis through a point, or a shift along a direction, part frame."""

    kind: Literal["turn", "shift"]
    direction: Floats
    """(3,) unit."""
    at_mm: Floats
    """(3,) on a turn's axis, closest to the pivot."""

    @property
    def axis(self) -> str:
        """x, y or z where it runs along one; else empty."""
        k = int(np.argmax(np.abs(self.direction)))
        return "xyz"[k] if abs(self.direction[k]) > ALONG_AXIS else ""


def free_motions(
    at_mm: Floats, normals: Floats, pivot_mm: Floats, size_mm: float, locked: Sequence[str] = ()
) -> list[FreeMotion]:
    """The motions that places (N, 3) with normals (N, 3) of the nominal surface leave free.

    Args:
        pivot_mm: (3,) about which the part turns.
        size_mm: of the part, by which turns are compared with shifts.
        locked: names of ``MOTION_NAMES`` that are fixed otherwise.
    """
    rows = np.concatenate([np.cross(at_mm - pivot_mm, normals) / size_mm, normals], axis=1)
    fixed = np.diag([float(name in locked) for name in MOTION_NAMES])
    values, vectors = np.linalg.eigh(rows.T @ rows / max(len(rows), 1) + fixed)
    free = vectors[:, values < LEAST * values[-1]]
    if not free.shape[1]:
        return []
    # combined so that as many as possible are shifts: what is left turns about axes
    _, sizes, ways = np.linalg.svd(free[:3], full_matrices=True)
    turning = np.zeros(free.shape[1], np.bool_)
    turning[: len(sizes)] = sizes >= TURNS
    motions = free @ ways.T
    shifts = _along_axes(motions[3:, ~turning])
    turns = motions[:, turning] / size_mm
    found = [FreeMotion("shift", one, np.zeros(3)) for one in shifts.T]
    for axis in _along_axes(turns[:3]).T:
        _, *shift = np.split(turns @ np.linalg.pinv(turns[:3]) @ axis, 2)
        moved = size_mm * shift[0]
        moved = moved - shifts @ (shifts.T @ moved)
        found.append(FreeMotion("turn", axis, pivot_mm + np.cross(axis, moved)))
    return found


def _along_axes(vectors: Floats) -> Floats:
    """(3, K) unit vectors of the same space as (3, K), along x, y, z where these are in it."""
    count = vectors.shape[1]
    if not count:
        return np.zeros((3, 0))
    basis = np.linalg.svd(vectors, full_matrices=False)[0][:, :count]
    share = np.linalg.norm(basis, axis=1)
    axes = np.flatnonzero(share > ALONG_AXIS)
    return np.eye(3)[:, axes] if len(axes) == count else basis
