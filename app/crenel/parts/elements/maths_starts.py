"""Shapes that a sampled surface may be: found among other surfaces, and ranked.

Shapes through a few points with their normals are compared by how much of the surface lies on
them (Schnabel, Wahl and Klein, 2007).
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.transforms import Floats
from crenel.parts.elements.maths_surface_sample import SurfaceSample
from crenel.parts.maths.shapes import Kind, Shape, frame_along

ELEMENTS: tuple[Kind, ...] = ("plane", "cylinder", "sphere", "cone")
"""The simplest first."""
TRIALS = {"plane": 250, "sphere": 400, "cylinder": 700, "cone": 700}
MOST_TURNED_COS = 0.9
"""A surface belongs to a shape if its normal is that of the shape within 26 degrees."""
LARGEST_RADIUS = 3.0
"""Times the extent of the points."""
CURVED = 1.5
"""A plane through the points of a round shape lies so many times further off them."""
FEWEST = 12
REFINED = 4
LEAST_SINE, LEAST_CONE_SINE, LEAST_VOLUME = 0.1, 0.02, 1e-3
"""Normals that differ less give no axis, and no apex."""
LEAST_CONE_RAD, MOST_CONE_RAD = 0.03, 1.45
AS_GOOD = 0.92
"""A simpler shape with this share of the best one's surface is preferred."""
PLANE_SHARE = 0.25
"""A plane with this share of the surface is not what a round shape begins from."""


@dataclass(frozen=True)
class CandidateShapes:
    """T shapes of a kind: a point (T, 3) and a direction (T, 3) of each, its radius (T,) there, and
    its half angle (T,)."""

    kind: Kind
    points_mm: Floats
    directions: Floats
    radii_mm: Floats
    half_rad: Floats

    def select(self, kept: NDArray[np.int64] | NDArray[np.bool_]) -> "CandidateShapes":
        """Some of them."""
        some = (self.points_mm, self.directions, self.radii_mm, self.half_rad)
        return CandidateShapes(self.kind, *(one[kept] for one in some))

    def shape(self, number: int) -> Shape:
        """One of them."""
        sizes = {"plane": [], "cone": [self.radii_mm[number], self.half_rad[number]]}
        own = np.array(sizes.get(self.kind, [self.radii_mm[number]]))
        return Shape(self.kind, frame_along(self.directions[number], self.points_mm[number]), own)

    def belonging(self, points_mm: Floats, normals: Floats, tolerance_mm: float) -> Floats:
        """(T, N) how much points (N, 3) with normals (N, 3) lie on each shape, 0 to 1."""
        middle = points_mm.mean(axis=0)
        p, o, d = points_mm - middle, self.points_mm - middle, self.directions
        along = d @ p.T - np.sum(d * o, axis=1)[:, None]
        turned = d @ normals.T
        if self.kind == "plane":
            off, facing = along, turned
        else:
            square = np.sum(p**2, axis=1) - 2 * o @ p.T + np.sum(o**2, axis=1)[:, None]
            outward = np.sum(p * normals, axis=1) - o @ normals.T
            if self.kind != "sphere":
                square, outward = square - along**2, outward - along * turned
            rho = np.sqrt(np.maximum(square, 1e-12))
            off, facing = rho - self.radii_mm[:, None], outward / rho
            if self.kind == "cone":
                c, s = np.cos(self.half_rad)[:, None], np.sin(self.half_rad)[:, None]
                off, facing = off * c - along * s, facing * c - turned * s
        on = np.maximum(1 - (off / tolerance_mm) ** 2, 0.0)
        return np.asarray(on * (np.abs(facing) > MOST_TURNED_COS))


@dataclass(frozen=True)
class FoundShape:
    """A shape, and how much of the sampled surface lies on it, 0 to 1."""

    shape: Shape
    share: float


def find_shape(kind: Kind, sample: SurfaceSample, rng: np.random.Generator) -> FoundShape | None:
    """The shape of a kind with most of the surface; None if there is none."""
    if len(sample.points_mm) < FEWEST:
        return None
    candidates = _FIND[kind](sample, _bases(kind, sample, rng))
    best, share = _best(sample, candidates)
    if share * len(sample.points_mm) < FEWEST:
        return None
    own = candidates.select(np.array([best]))
    if kind != "plane" and not _is_curved(own, sample):
        return None
    return FoundShape(own.shape(0), share)


def rank_shapes(sample: SurfaceSample, rng: np.random.Generator) -> list[FoundShape]:
    """Shapes of all kinds, the likeliest first: the simplest of those that are about as good."""
    found = [one for kind in ELEMENTS if (one := find_shape(kind, sample, rng)) is not None]
    if not found:
        return []
    most = max(one.share for one in found)
    first = next(one for one in found if one.share >= AS_GOOD * most)
    others = sorted((one for one in found if one is not first), key=lambda one: -one.share)
    return [first, *others]


def _bases(kind: Kind, sample: SurfaceSample, rng: np.random.Generator) -> NDArray[np.int64]:
    """Numbers (T, k) of the points that shapes go through: of round ones, not of a large plane."""
    some = np.arange(len(sample.points_mm))
    if kind != "plane":
        planes = _planes(sample, _bases("plane", sample, rng))
        best, share = _best(sample, planes)
        if share > PLANE_SHARE:
            own = planes.select(np.array([best]))
            on = own.belonging(sample.points_mm, sample.normals, sample.tolerance_mm)[0] > 0
            if (~on).sum() >= FEWEST:
                some = some[~on]
    size = {"plane": 1, "sphere": 2, "cylinder": 2, "cone": 3}[kind]
    return np.asarray(some[rng.integers(0, len(some), (TRIALS[kind], size))])


def _best(sample: SurfaceSample, candidates: CandidateShapes) -> tuple[int, float]:
    """The number of the best candidate, by a part of the sample and then by all of it, and the
    share of the surface that lies on it; 0 without any."""
    if not len(candidates.radii_mm):
        return 0, 0.0
    few = slice(0, len(sample.points_mm), 4)
    tolerance = sample.tolerance_mm
    roughly = candidates.belonging(sample.points_mm[few], sample.normals[few], tolerance)
    ranked = np.argsort(-roughly.mean(axis=1))[:REFINED]
    best = candidates.select(ranked).belonging(sample.points_mm, sample.normals, tolerance)
    shares = best.mean(axis=1)
    return int(ranked[np.argmax(shares)]), float(shares.max())


def _is_curved(found: CandidateShapes, sample: SurfaceSample) -> bool:
    """Whether the points of the only candidate lie on it rather than on a plane."""
    on = found.belonging(sample.points_mm, sample.normals, sample.tolerance_mm)[0] > 0
    points = sample.points_mm[on]
    flat = np.sqrt(np.linalg.eigvalsh(np.cov(points.T))[0])
    rms = np.sqrt(np.mean(found.shape(0).distances(points) ** 2))
    return bool(flat > CURVED * rms)


def _planes(sample: SurfaceSample, bases: NDArray[np.int64]) -> CandidateShapes:
    own, none = bases[:, 0], np.zeros(len(bases))
    return CandidateShapes("plane", sample.points_mm[own], sample.normals[own], none, none)


def _spheres(sample: SurfaceSample, bases: NDArray[np.int64]) -> CandidateShapes:
    (p, q), (n, m) = _pairs(sample, bases)
    # where the two normals come nearest to each other
    gap, across = q - p, np.sum(n * m, axis=1)
    room = np.maximum(1 - across**2, 1e-6)
    s = (np.sum(gap * n, axis=1) - across * np.sum(gap * m, axis=1)) / room
    t = (across * np.sum(gap * n, axis=1) - np.sum(gap * m, axis=1)) / room
    centres = (p + s[:, None] * n + q + t[:, None] * m) / 2
    radii = (np.linalg.norm(p - centres, axis=1) + np.linalg.norm(q - centres, axis=1)) / 2
    up = np.tile([0.0, 0.0, 1.0], (len(centres), 1))
    return _of_size(CandidateShapes("sphere", centres, up, radii, np.zeros(len(radii))), sample)


def _cylinders(sample: SurfaceSample, bases: NDArray[np.int64]) -> CandidateShapes:
    (p, q), (n, m) = _pairs(sample, bases)
    directions = np.cross(n, m)
    lengths = np.linalg.norm(directions, axis=1)
    good = lengths > LEAST_SINE
    p, q, n, m, lengths = p[good], q[good], n[good], m[good], lengths[good]
    directions = directions[good] / lengths[:, None]
    # across the axis, both normals meet on it: p + s n = q + t m
    s = np.sum(np.cross(q - p, m) * directions, axis=1) / lengths
    points = p + s[:, None] * n
    away = q - points
    away -= np.sum(away * directions, axis=1)[:, None] * directions
    radii = (np.abs(s) + np.linalg.norm(away, axis=1)) / 2
    found = CandidateShapes("cylinder", points, directions, radii, np.zeros(len(radii)))
    return _of_size(found, sample)


def _cones(sample: SurfaceSample, bases: NDArray[np.int64]) -> CandidateShapes:
    p, n = sample.points_mm[bases], sample.normals[bases]
    axes = np.cross(n[:, 0] - n[:, 1], n[:, 1] - n[:, 2])
    lengths = np.linalg.norm(axes, axis=1)
    good = (lengths > LEAST_CONE_SINE) & (np.abs(np.linalg.det(n)) > LEAST_VOLUME)
    p, n = p[good], n[good]
    axes = axes[good] / lengths[good, None]
    apexes = np.linalg.solve(n, np.sum(n * p, axis=2)[:, :, None])[:, :, 0]
    along = np.sum(axes * (p.mean(axis=1) - apexes), axis=1)
    axes, along = np.where(along[:, None] < 0, -axes, axes), np.abs(along)
    half = np.abs(np.arcsin(np.clip(np.sum(axes * n.mean(axis=1), axis=1), -1, 1)))
    points = apexes + along[:, None] * axes
    found = CandidateShapes("cone", points, axes, along * np.tan(half), half)
    return _of_size(found.select((half > LEAST_CONE_RAD) & (half < MOST_CONE_RAD)), sample)


def _pairs(
    sample: SurfaceSample, bases: NDArray[np.int64]
) -> tuple[tuple[Floats, Floats], tuple[Floats, Floats]]:
    first, second = bases.T
    points, normals = sample.points_mm, sample.normals
    return (points[first], points[second]), (normals[first], normals[second])


def _of_size(found: CandidateShapes, sample: SurfaceSample) -> CandidateShapes:
    """Those that are neither noise nor nearly a plane."""
    radii = found.radii_mm
    large = radii > 2 * sample.tolerance_mm
    return found.select(large & (radii < LARGEST_RADIUS * sample.extent_mm))


_FIND: dict[Kind, Callable[[SurfaceSample, NDArray[np.int64]], CandidateShapes]] = {
    "plane": _planes,
    "sphere": _spheres,
    "cylinder": _cylinders,
    "cone": _cones,
}
