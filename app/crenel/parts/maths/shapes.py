"""Ideal features in a frame of their own: distances of points, and their derivatives.

A placed feature is a rigid transform and sizes. In its own frame, a plane is z = 0, and circles,
cylinders, cones and tori turn about z; a slot has its long direction along x and its depth along
z. Distances are positive on the side to which the gradient points: away from an axis, a centre or
a slot's middle, and along the normal of a plane.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.transforms import Floats, nearest_rotation, se3_exp

Kind = Literal["plane", "circle", "cylinder", "cone", "sphere", "torus", "slot"]
RX, RY, RZ, TX, TY, TZ = range(6)
FREE_NAMES = ("turn_x_rad", "turn_y_rad", "turn_z_rad", "shift_x_mm", "shift_y_mm", "shift_z_mm")
LEAST_MM = 1e-9


@dataclass(frozen=True)
class LocalDistance:
    """Signed distances (N,), their gradients (N, 3), and derivatives (N, s) by the sizes."""

    off_mm: Floats
    gradients: Floats
    by_sizes: Floats


@dataclass(frozen=True)
class KindOfShape:
    """What is free of a kind: numbers of its twist in its own frame, and names of its sizes."""

    motions: tuple[int, ...]
    sizes: tuple[str, ...]
    measure: Callable[[Floats, Floats], LocalDistance]

    @property
    def count(self) -> int:
        return len(self.motions) + len(self.sizes)

    @property
    def are_angles(self) -> tuple[bool, ...]:
        """Which of the parameters, motions and sizes, are angles."""
        turns = [motion <= RZ for motion in self.motions]
        return (*turns, *(name.endswith("_rad") for name in self.sizes))

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the parameters, motions in the feature's own frame and sizes."""
        return (*(FREE_NAMES[motion] for motion in self.motions), *self.sizes)


@dataclass(frozen=True)
class Shape:
    """A feature in place.

    ``T`` (4, 4) maps its own frame to the frame of the points. ``sizes`` (s,) are: radius; of a
    cone, the radius at z = 0 and the half angle; of a torus, both radii; of a slot, half its width
    and half the distance of the centres of its ends.
    """

    kind: Kind
    T: Floats
    sizes: Floats

    @property
    def freedom(self) -> KindOfShape:
        return KINDS[self.kind]

    @property
    def origin_mm(self) -> Floats:
        return np.asarray(self.T[:3, 3])

    @property
    def direction(self) -> Floats:
        """(3,) its z axis."""
        return np.asarray(self.T[:3, 2])

    def local(self, points_mm: Floats) -> Floats:
        """Points (N, 3) in its own frame."""
        return np.asarray((points_mm - self.T[:3, 3]) @ self.T[:3, :3])

    def distances(self, points_mm: Floats) -> Floats:
        """Signed distances (N,) of points (N, 3), mm."""
        return self.freedom.measure(self.local(points_mm), self.sizes).off_mm

    def normals(self, points_mm: Floats) -> Floats:
        """Gradients (N, 3) of the distances, of unit length."""
        found = self.freedom.measure(self.local(points_mm), self.sizes)
        return np.asarray(found.gradients @ self.T[:3, :3].T)

    def linearise(self, points_mm: Floats) -> tuple[Floats, Floats, Floats]:
        """Distances (N,), normals (N, 3), and derivatives (N, m) of the distances by the free
        motions in its own frame (rad, mm) and by its sizes."""
        x = self.local(points_mm)
        found = self.freedom.measure(x, self.sizes)
        g = found.gradients
        J = np.empty((len(x), self.freedom.count))
        for column, motion in enumerate(self.freedom.motions):
            if motion >= TX:
                J[:, column] = -g[:, motion - TX]
            else:
                a, b = (motion + 1) % 3, (motion + 2) % 3
                J[:, column] = x[:, b] * g[:, a] - x[:, a] * g[:, b]
        J[:, len(self.freedom.motions) :] = found.by_sizes
        return found.off_mm, np.asarray(g @ self.T[:3, :3].T), J

    def apply_step(self, step: Floats) -> "Shape":
        """The feature after a step (m,) of its free motions and sizes."""
        motions = self.freedom.motions
        twist = np.zeros(6)
        twist[list(motions)] = step[: len(motions)]
        T = self.T @ se3_exp(twist)
        T[:3, :3] = nearest_rotation(T[:3, :3])
        return replace(self, T=T, sizes=self.sizes + step[len(motions) :])

    def move(self, T_new_old: Floats) -> "Shape":
        """The same feature in another frame."""
        return replace(self, T=T_new_old @ self.T)

    def scale(self, factor: float) -> "Shape":
        """The same feature of a part that is larger by a factor, about the origin of the frame."""
        T = self.T.copy()
        T[:3, 3] *= factor
        angles = self.freedom.are_angles[len(self.freedom.motions) :]
        return replace(self, T=T, sizes=self.sizes * np.where(angles, 1.0, factor))

    def centre_on(self, points_mm: Floats) -> "Shape":
        """The same feature, with its frame at the middle of points as far as its kind allows."""
        x = self.local(points_mm).mean(axis=0)
        shift = np.zeros(3)
        sizes = self.sizes
        if self.kind == "plane":
            shift[:2] = x[:2]
        elif self.kind in ("cylinder", "cone"):
            shift[2] = x[2]
        if self.kind == "cone":
            sizes = np.array([sizes[0] + x[2] * np.tan(sizes[1]), sizes[1]])
        T = self.T.copy()
        T[:3, 3] += self.T[:3, :3] @ shift
        return replace(self, T=T, sizes=sizes)


def frame_along(direction: Floats, point_mm: Floats, towards: Floats | None = None) -> Floats:
    """A frame (4, 4) at a point whose z axis has a direction, and whose x axis points as nearly
    ``towards`` another as it can."""
    z = direction / np.linalg.norm(direction)
    x = np.eye(3)[int(np.argmin(np.abs(z)))] if towards is None else np.asarray(towards)
    x = x - z * float(x @ z)
    x = x / np.linalg.norm(x)
    T = np.eye(4)
    T[:3, 0], T[:3, 1], T[:3, 2], T[:3, 3] = x, np.cross(z, x), z, point_mm
    return T


def _plane(x: Floats, sizes: Floats) -> LocalDistance:
    gradients = np.zeros_like(x)
    gradients[:, 2] = 1.0
    return LocalDistance(x[:, 2].copy(), gradients, np.zeros((len(x), 0)))


def _radial(x: Floats) -> tuple[Floats, Floats]:
    """Distances (N,) from the z axis, and directions (N, 3) away from it."""
    away = x.copy()
    away[:, 2] = 0.0
    rho = np.maximum(np.hypot(x[:, 0], x[:, 1]), LEAST_MM)
    return rho, away / rho[:, None]


def _cylinder(x: Floats, sizes: Floats) -> LocalDistance:
    rho, away = _radial(x)
    return LocalDistance(rho - sizes[0], away, np.full((len(x), 1), -1.0))


def _cone(x: Floats, sizes: Floats) -> LocalDistance:
    radius, half = sizes
    rho, away = _radial(x)
    c, s = np.cos(half), np.sin(half)
    gradients = away * c
    gradients[:, 2] = -s
    off = (rho - radius) * c - x[:, 2] * s
    by_half = -(rho - radius) * s - x[:, 2] * c
    return LocalDistance(off, gradients, np.column_stack([np.full(len(x), -c), by_half]))


def _sphere(x: Floats, sizes: Floats) -> LocalDistance:
    rho = np.maximum(np.linalg.norm(x, axis=1), LEAST_MM)
    return LocalDistance(rho - sizes[0], x / rho[:, None], np.full((len(x), 1), -1.0))


def _torus(x: Floats, sizes: Floats) -> LocalDistance:
    rho, away = _radial(x)
    tube = away * (rho - sizes[0])[:, None]
    tube[:, 2] = x[:, 2]
    length = np.maximum(np.linalg.norm(tube, axis=1), LEAST_MM)
    by_major = -(rho - sizes[0]) / length
    by_sizes = np.column_stack([by_major, np.full(len(x), -1.0)])
    return LocalDistance(length - sizes[1], tube / length[:, None], by_sizes)


def _slot(x: Floats, sizes: Floats) -> LocalDistance:
    half_width, half_run = sizes
    end = np.clip(x[:, 0], -half_run, half_run)
    away = x.copy()
    away[:, 0] -= end
    away[:, 2] = 0.0
    rho = np.maximum(np.linalg.norm(away, axis=1), LEAST_MM)
    by_run = np.where(np.abs(x[:, 0]) > half_run, -np.sign(x[:, 0]) * away[:, 0] / rho, 0.0)
    by_sizes = np.column_stack([np.full(len(x), -1.0), by_run])
    return LocalDistance(rho - half_width, away / rho[:, None], by_sizes)


KINDS: dict[Kind, KindOfShape] = {
    "plane": KindOfShape((RX, RY, TZ), (), _plane),
    "circle": KindOfShape((TX, TY), ("radius_mm",), _cylinder),
    "cylinder": KindOfShape((RX, RY, TX, TY), ("radius_mm",), _cylinder),
    "cone": KindOfShape((RX, RY, TX, TY), ("radius_mm", "half_angle_rad"), _cone),
    "sphere": KindOfShape((TX, TY, TZ), ("radius_mm",), _sphere),
    "torus": KindOfShape((RX, RY, TX, TY, TZ), ("radius_mm", "tube_radius_mm"), _torus),
    "slot": KindOfShape((RZ, TX, TY), ("half_width_mm", "half_run_mm"), _slot),
}


def surface_coordinates(shape: Shape, points_mm: Floats) -> Floats:
    """Coordinates (N, 2) or (N, 3) in mm in which equal steps are equal areas of the surface."""
    x = shape.local(points_mm)
    if shape.kind == "plane":
        return np.asarray(x[:, :2])
    if shape.kind in ("sphere", "torus"):
        return x
    around = np.arctan2(x[:, 1], x[:, 0])
    if shape.kind == "slot":
        return np.column_stack([_around_slot(x, shape.sizes), x[:, 2]])
    return np.column_stack([around * shape.sizes[0], x[:, 2]])


def _around_slot(x: Floats, sizes: Floats) -> Floats:
    """The length (N,) along a slot's outline up to each point, from the middle of one side."""
    half_width, half_run = sizes
    right, left = x[:, 0] > half_run, x[:, 0] < -half_run
    turn = np.arctan2(x[:, 1], np.abs(x[:, 0]) - half_run)
    end = np.pi * half_width
    along = np.where(x[:, 1] > 0, x[:, 0], 2 * half_run + end - x[:, 0])
    along = np.where(right, half_run + end / 2 - half_width * turn, along)
    return np.asarray(np.where(left, 3 * half_run + 1.5 * end + half_width * turn, along))


def cells_of(coordinates_mm: Floats, edge_mm: float) -> tuple[NDArray[np.int64], int]:
    """The cell (N,) of each point, counted from 0, in a grid of squares or cubes; and how many."""
    at = np.floor((coordinates_mm - coordinates_mm.min(axis=0)) / edge_mm).astype(np.int64)
    sizes = at.max(axis=0) + 1
    number = at[:, 0]
    for axis in range(1, at.shape[1]):
        number = number * sizes[axis] + at[:, axis]
    _, cell = np.unique(number, return_inverse=True)
    return cell.astype(np.int64), int(cell.max()) + 1


def first_of_cells(coordinates_mm: Floats, edge_mm: float) -> NDArray[np.int64]:
    """The number of the first point of each square or cube of a grid, ascending."""
    cell, count = cells_of(coordinates_mm, edge_mm)
    first = np.full(count, len(cell))
    np.minimum.at(first, cell, np.arange(len(cell)))
    return np.sort(first)
