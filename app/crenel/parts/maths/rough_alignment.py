"""Where about a part lies: from touches of known features, or from a scan of all of them."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import permutations, product

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import KDTree

from crenel.metrology.transforms import Floats, inverse, nearest_rotation, rigid, se3_exp
from crenel.parts.maths.assignment import Face
from crenel.parts.maths.shapes import first_of_cells

ROUNDS = 40
NEAR_MM = 0.1
"""Touches nearer to their features than this count in full."""
WEAK, WEAKEST = 0.05, 1e-4
"""How much the middle of a feature's touches counts beside their distances from it."""
SURE_MM = 0.3
"""No other place of the part is tried where touches are so near to their features."""
GRID_MM = 2.0
SCAN_GRID_MM = 1.0
COARSE, COARSE_ROUNDS, PROMISING = 6, 12, 4
"""Of all starts, every so many samples are tried for so many rounds, and so many go on with all."""
ICP_ROUNDS = 25
FAR_MM = 5.0
"""A nominal surface much further than this from the scan is not found in it, however far."""
FEWEST = 20
"""Samples that each feature keeps, if it has so many."""
MOST_SAMPLES, MOST_POINTS = 4_000, 40_000


@dataclass(frozen=True)
class TouchedFace:
    """Touches of one feature: centres of the tip (N, 3), arm frame, and where they should lie."""

    face: Face
    centres_mm: Floats
    offset_mm: float


def cube_rotations() -> list[Floats]:
    """The 24 rotations that map the axes onto each other."""
    found = []
    for order in permutations(range(3)):
        for signs in product((1.0, -1.0), repeat=3):
            R = np.zeros((3, 3))
            R[range(3), order] = signs
            if np.linalg.det(R) > 0:
                found.append(R)
    return found


def align_to_touches(touched: Sequence[TouchedFace]) -> tuple[Floats, float]:
    """``T_arm_part`` by touches of features, and the median of their distances from them, mm."""
    middles = np.array([one.centres_mm.mean(axis=0) for one in touched])
    wanted = np.array([_middle(one.face) for one in touched])
    starts = cube_rotations()
    if len(touched) >= 3:
        a, b = middles - middles.mean(axis=0), wanted - wanted.mean(axis=0)
        kabsch = nearest_rotation(a.T @ b)
        starts = [kabsch, *(kabsch @ R for R in starts)] + starts
    best: tuple[float, Floats] | None = None
    for R in starts:
        T = rigid(R, middles.mean(axis=0) - R @ wanted.mean(axis=0))
        T = _descend(touched, wanted, T, WEAK)
        cost = _cost(touched, wanted, T)
        if best is None or cost < best[0]:
            best = cost, T
        if cost < SURE_MM * sum(len(one.centres_mm) for one in touched):
            break
    assert best is not None
    T = _descend(touched, wanted, best[1], WEAKEST)
    off = np.concatenate([_distances(one, T) for one in touched])
    return T, float(np.median(np.abs(off)))


def align_to_scan(faces: Sequence[Face], points_mm: Floats) -> tuple[Floats, float]:
    """``T_arm_part`` by a scan (N, 3) of all features, and the median distance of the nominal
    surfaces from it, mm."""
    scanned, part = _sparse(points_mm), _sample(faces)
    tree = KDTree(scanned)
    few = part.thin(COARSE)
    tried = sorted(
        (_iterate_closest(tree, scanned, few, T, COARSE_ROUNDS) for T in _starts(scanned, part)),
        key=lambda one: one.misfit_mm,
    )
    found = [
        _iterate_closest(tree, scanned, part, one.T_arm_part, ICP_ROUNDS)
        for one in tried[:PROMISING]
    ]
    best = min(found, key=lambda one: one.misfit_mm)
    return best.T_arm_part, best.median_mm


def _starts(scanned_mm: Floats, part: "_Samples") -> list[Floats]:
    """``T_arm_part`` by principal axes in all 24 orders, with centroids or middles together."""
    of_scan, scan_places = principal_axes(scanned_mm)
    of_part, part_places = principal_axes(part.points_mm)
    return [
        rigid(R, at - R @ wanted)
        for R in turns_between(of_part, of_scan)
        for at, wanted in zip(scan_places, part_places, strict=True)
    ]


def principal_axes(points_mm: Floats) -> tuple[Floats, tuple[Floats, Floats]]:
    """Principal axes of points (N, 3), the columns of a rotation (3, 3); the centroid (3,), and
    the middle (3,) of the box along the axes."""
    centroid = points_mm.mean(axis=0)
    off = points_mm - centroid
    axes = np.linalg.svd(off.T @ off)[0]
    axes[:, 2] *= np.linalg.det(axes)
    along = off @ axes
    middle = centroid + axes @ ((along.min(axis=0) + along.max(axis=0)) / 2)
    return axes, (centroid, np.asarray(middle))


def turns_between(axes: Floats, others: Floats) -> list[Floats]:
    """The 24 rotations that take axes to other ones (3, 3) in any order and sense."""
    return [nearest_rotation(others @ R @ axes.T) for R in cube_rotations()]


def _iterate_closest(
    tree: KDTree, scanned_mm: Floats, part: "_Samples", T: Floats, rounds: int
) -> "_Fitted":
    """Meets a scan (N, 3), with its tree, by nominal surfaces, from a start ``T_arm_part``."""
    # each feature weighs the same, or a large face holds the others where they are not
    share = 1 / np.sqrt(np.bincount(part.face_of)[part.face_of])
    for _ in range(rounds):
        p = part.points_mm @ T[:3, :3].T + T[:3, 3]
        n = part.normals @ T[:3, :3].T
        away, nearest = tree.query(p)
        weight = share / (1 + (away / FAR_MM) ** 2)
        off = np.sum((scanned_mm[nearest] - p) * n, axis=1)
        centre = np.average(p, axis=0, weights=weight)
        J = np.concatenate([np.cross(p - centre, n), n], axis=1)
        step = np.linalg.lstsq(weight[:, None] * J, weight * off, rcond=1e-6)[0]
        turn = se3_exp(np.concatenate([step[:3], np.zeros(3)]))[:3, :3]
        T = T.copy()
        T[:3, 3] = turn @ (T[:3, 3] - centre) + centre + step[3:]
        T[:3, :3] = turn @ T[:3, :3]
        if np.abs(step).max() < 1e-5:
            break
    away = tree.query(part.points_mm @ T[:3, :3].T + T[:3, 3])[0]
    # by features: a large face fits in many places, where a small bore does not
    within = np.bincount(part.face_of, np.minimum(away, FAR_MM)) / np.bincount(part.face_of)
    return _Fitted(T, float(within.mean()), float(np.median(away)))


def _descend(touched: Sequence[TouchedFace], wanted: Floats, T: Floats, weak: float) -> Floats:
    """Least squares of distances, with a weak pull of each middle to its place."""
    for _ in range(ROUNDS):
        rows, off = [], []
        T_part_arm = inverse(T)
        for one, at in zip(touched, wanted, strict=True):
            x = one.centres_mm @ T_part_arm[:3, :3].T + T_part_arm[:3, 3]
            g = one.face.shape.normals(x)
            away = one.face.shape.distances(x) - one.offset_mm
            # a touch on the wrong face must not pull the others off theirs
            trust = np.sqrt(NEAR_MM / np.maximum(np.abs(away), NEAR_MM))[:, None]
            rows.append(-trust * np.concatenate([np.cross(x, g), g], axis=1))
            off.append(trust[:, 0] * away)
            middle = x.mean(axis=0)
            pull = np.concatenate([np.cross(middle, np.eye(3)), np.eye(3)], axis=1)
            rows.append(-weak * pull)
            off.append(weak * (middle - at))
        J, r = np.concatenate(rows), np.concatenate(off)
        step = -np.linalg.lstsq(J, r, rcond=1e-9)[0]
        largest = float(np.abs(step[:3]).max())
        if largest > 0.5:
            step *= 0.5 / largest
        T = T @ se3_exp(step)
        if np.abs(step).max() < 1e-9:
            break
    return T


def _cost(touched: Sequence[TouchedFace], wanted: Floats, T: Floats) -> float:
    """How little touches agree with their features: mm off the surfaces, cm off the boxes."""
    total, T_part_arm = 0.0, inverse(T)
    for one, at in zip(touched, wanted, strict=True):
        x = one.centres_mm @ T_part_arm[:3, :3].T + T_part_arm[:3, 3]
        total += float(np.sum(np.abs(_distances(one, T))))
        if one.face.boxes_mm:
            reach = 2 * abs(one.offset_mm) + 1.0
            low = np.min([box[0] for box in one.face.boxes_mm], axis=0) - reach
            high = np.max([box[1] for box in one.face.boxes_mm], axis=0) + reach
            beyond = np.maximum(low - x, 0) + np.maximum(x - high, 0)
            total += float(np.sum(beyond**2)) / 100
        else:
            total += float(np.sum((x.mean(axis=0) - at) ** 2)) / 1000
    return total


def _distances(one: TouchedFace, T: Floats) -> Floats:
    T_part_arm = inverse(T)
    x = one.centres_mm @ T_part_arm[:3, :3].T + T_part_arm[:3, 3]
    return np.asarray(one.face.shape.distances(x) - one.offset_mm)


def _middle(face: Face) -> Floats:
    """(3,) about where the middle of a feature is, part frame."""
    if face.boxes_mm:
        return np.asarray(np.mean([box.mean(axis=0) for box in face.boxes_mm], axis=0))
    shape = face.shape
    along = 0.0 if face.along_mm is None else sum(face.along_mm) / 2
    return np.asarray(shape.origin_mm + along * shape.direction)


@dataclass(frozen=True)
class _Samples:
    """Points (S, 3) of nominal features, normals (S, 3) there, part frame, and whose they are."""

    points_mm: Floats
    normals: Floats
    face_of: NDArray[np.int64]

    def thin(self, stride: int) -> "_Samples":
        """Every so many, but of each feature at least ``FEWEST``, if it has so many."""
        counts = np.bincount(self.face_of)
        kept = [
            at[:: min(stride, max(len(at) // FEWEST, 1))]
            for at in np.split(np.arange(counts.sum()), np.cumsum(counts)[:-1])
        ]
        each = np.concatenate(kept)
        return _Samples(self.points_mm[each], self.normals[each], self.face_of[each])


@dataclass(frozen=True)
class _Fitted:
    """Where nominal surfaces meet a scan, and how far they are from it."""

    T_arm_part: Floats
    misfit_mm: float
    """The mean over the features, each counting the same; what is far counts as ``FAR_MM``."""
    median_mm: float


def _sample(faces: Sequence[Face]) -> _Samples:
    points, normals, counts = [], [], []
    for face in faces:
        x = _grid(face)
        x = x[face.is_within_boxes(x)]
        if len(x):
            points.append(x)
            normals.append(face.shape.normals(x))
            counts.append(len(x))
    face_of = np.repeat(np.arange(len(counts)), counts)
    every = _Samples(np.concatenate(points), np.concatenate(normals), face_of)
    return every.thin(-(-len(face_of) // MOST_SAMPLES))


def _grid(face: Face) -> Floats:
    """Points about ``GRID_MM`` apart on a nominal feature, part frame."""
    shape = face.shape
    if shape.kind == "plane":
        boxes = face.boxes_mm or (np.array([shape.origin_mm - 10, shape.origin_mm + 10]),)
        return np.concatenate([_grid_in_box(face, *box) for box in boxes])
    radius = float(shape.sizes[0]) if len(shape.sizes) else 1.0
    low, high = face.along_mm or (-GRID_MM, GRID_MM)
    if shape.kind in ("sphere", "torus"):
        low, high = -radius, radius
    around = np.linspace(0, 2 * np.pi, max(int(2 * np.pi * radius / GRID_MM), 12), endpoint=False)
    run = np.linspace(low, high, max(int((high - low) / GRID_MM), 3))
    a, z = (one.ravel() for one in np.meshgrid(around, run))
    reach = np.full(len(a), radius)
    if shape.kind == "cone":
        reach = np.abs(z) * np.tan(shape.sizes[1])
    x = np.column_stack([reach * np.cos(a), reach * np.sin(a), z])
    if shape.kind == "slot":
        x[:, 0] += np.where(np.cos(a) >= 0, 1, -1) * shape.sizes[1]
    x = x @ shape.T[:3, :3].T + shape.origin_mm
    return np.asarray(x - shape.normals(x) * shape.distances(x)[:, None])


def _grid_in_box(face: Face, low: Floats, high: Floats) -> Floats:
    axes = [np.arange(a, max(b, a) + 1e-9, GRID_MM) for a, b in zip(low, high, strict=True)]
    x = np.stack([one.ravel() for one in np.meshgrid(*axes)], axis=1)
    x = x - face.shape.normals(x) * face.shape.distances(x)[:, None]
    return np.unique(x.round(6), axis=0)


def _sparse(points_mm: Floats) -> Floats:
    """One point of each small cube, and no more than are needed."""
    some = points_mm[:: -(-len(points_mm) // (10 * MOST_POINTS))]
    chosen = some[first_of_cells(some, SCAN_GRID_MM)]
    return np.asarray(chosen[:: -(-len(chosen) // MOST_POINTS)])
