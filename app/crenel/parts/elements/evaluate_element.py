"""An element fitted to picked points: found among them, fitted, and known with what it shares."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import block_diag
from scipy.spatial import cKDTree

from crenel.errors import OperationError
from crenel.messages.message import Text, message
from crenel.metrology.fitting.shape import parameter_covariance
from crenel.metrology.transforms import Floats
from crenel.parts.elements.evaluate_errors import (
    KnownPoints,
    PickedPoints,
    UnknownErrors,
    find_errors,
)
from crenel.parts.elements.maths_figures import turn_outward
from crenel.parts.elements.maths_starts import find_shape, rank_shapes
from crenel.parts.elements.maths_surface_sample import sample_surface
from crenel.parts.evaluate_folder import StationKnowledge
from crenel.parts.maths.feature_fit import (
    FeaturePoints,
    FittedFeature,
    adjust_shape,
    cell_weights,
    fit_feature,
    fit_shape,
)
from crenel.parts.maths.knowledge import Knowledge, MeasuredFeature, join_features
from crenel.parts.maths.shapes import Kind, Shape

CELL_MM = 0.8
"""Edge of the cells of a surface that weigh the same."""
BAND_TOLERANCES = 2.0
"""Points within so many tolerances of a shape may be on it."""
EDGE_MM, EDGE_SHARE = 0.7, 0.05
"""Points so near to other surfaces, or so near for the extent of the shape, are left out."""
MOST_OTHERS = 20_000
LEAST_POINTS = 20


@dataclass(frozen=True)
class UnusedPoints:
    """Points that were picked but not fitted, by the rule that left them out."""

    other_surface: int
    edge: int
    outlier: int


@dataclass(frozen=True)
class BarePoints:
    """Points of which only the frames are known."""

    points_mm: Floats
    frame: NDArray[np.int64]

    def select(self, kept: NDArray[np.int64]) -> "BarePoints":
        """Some of the points."""
        return BarePoints(self.points_mm[kept], self.frame[kept])


@dataclass(frozen=True)
class KnownElement:
    """What makes an element err: its derivatives, its station, and the keys of its frames."""

    fitted: FittedFeature
    station: StationKnowledge
    keys: NDArray[np.int64]
    """(K,) of the frames of ``fitted.sums``."""


@dataclass(frozen=True)
class MeasuredElement:
    """An element of the least squares, in the arm frame."""

    shape: Shape
    as_shown: Shape
    """The same through the points as the cloud has them, without what ``links`` put right."""
    known: KnownElement | None
    why_scatter: Text
    """Why only the scatter is known; empty if more is."""
    scatter: Floats | None
    """(m, m) covariance by the scatter of the points alone; None of too few frames."""
    second: Kind | None
    """What else it may be, where its kind was not given."""
    off_mm: Floats
    """(N,) residuals of the points used."""
    used_mm: Floats
    """(N, 3) as the cloud has them."""
    left_out: UnusedPoints

    @property
    def knowledge(self) -> Knowledge | None:
        """What is known of the element alone; None if nothing is."""
        return join_elements([self])


def measure_element(
    kind: Kind | None,
    picked: PickedPoints,
    front: NDArray[np.bool_],
    viewer_mm: Floats,
) -> MeasuredElement:
    """Fits an element to the points under a rectangle.

    Args:
        kind: None: the likeliest.
        front: (N,) whether each point is on the surface in front, where the element is looked for.
        viewer_mm: (3,) from where the surface is seen.

    Raises:
        OperationError: the points show no such element, or do not determine it.
    """
    rng = np.random.default_rng(0)
    sample = sample_surface(picked.points_mm[front], viewer_mm, rng)
    if kind is None:
        ranked = rank_shapes(sample, rng)
    else:
        found = find_shape(kind, sample, rng)
        ranked = [] if found is None else [found]
    if not ranked:
        raise _not_found(message("element-no-shape-stands-out"))
    shape = turn_outward(ranked[0].shape)
    band_mm = BAND_TOLERANCES * sample.tolerance_mm
    kept, edge = _on_shape(shape, picked.points_mm, front, band_mm)
    if len(kept) < LEAST_POINTS:
        raise _not_found(message("element-has-few-points"))
    points = picked.select(kept)
    second = ranked[1].shape.kind if len(ranked) > 1 else None
    others = len(picked.frame) - len(kept) - edge
    try:
        return _fit_known(shape, points, second, find_errors(points), (others, edge))
    except UnknownErrors as unknown:
        return _fit_bare(shape, points, second, unknown.why, (others, edge))


def _on_shape(
    shape: Shape, points_mm: Floats, front: NDArray[np.bool_], band_mm: float
) -> tuple[NDArray[np.int64], int]:
    """The numbers of points that may be on a shape, away from other surfaces; and how many are
    left out as too near to these."""
    near = np.abs(shape.distances(points_mm)) <= band_mm
    if shape.kind == "plane":  # what is behind it may be another one
        near &= front
    kept, others = np.flatnonzero(near), np.flatnonzero(~near & front)
    if not len(others) or not len(kept):
        return kept, 0
    stride = -(-len(others) // MOST_OTHERS)
    edge_mm = min(EDGE_MM, EDGE_SHARE * float(np.ptp(points_mm[kept], axis=0).max()))
    tree = cKDTree(points_mm[others[::stride]])
    away = tree.query(points_mm[kept], distance_upper_bound=edge_mm)[0]
    inside = kept[~np.isfinite(away)]
    if 2 * len(inside) < len(kept):
        return kept, 0
    return inside, len(kept) - len(inside)


def _fit_known(
    start: Shape,
    points: PickedPoints,
    second: Kind | None,
    known: KnownPoints,
    left_out: tuple[int, int],
) -> MeasuredElement:
    errors = known.errors
    fitted = fit_feature(
        start.kind, start, FeaturePoints(errors, np.zeros(len(points.frame))), CELL_MM
    )
    used = points.points_mm[fitted.used]
    shape = fitted.shape
    as_shown = shape
    if np.abs(errors.points_mm[fitted.used] - used).max(initial=0.0) > 0:
        frames = errors.frame[fitted.used]
        shown = FeaturePoints(BarePoints(used, frames), np.zeros(len(used)))
        as_shown = adjust_shape(start.kind, shape, shown, cell_weights(fitted.cell))
    keys = known.keys[fitted.sums.frames]
    return MeasuredElement(
        shape,
        as_shown,
        KnownElement(fitted, known.station, keys),
        "",
        fitted.scatter,
        second,
        fitted.off_mm,
        used,
        UnusedPoints(*left_out, fitted.outliers),
    )


def _fit_bare(
    start: Shape,
    points: PickedPoints,
    second: Kind | None,
    why: Text,
    left_out: tuple[int, int],
) -> MeasuredElement:
    bare = FeaturePoints(BarePoints(points.points_mm, points.keys), np.zeros(len(points.frame)))
    found = fit_shape(start.kind, start, bare, CELL_MM)
    used = points.points_mm[found.used]
    off, _, J = found.shape.linearise(used)
    root = np.sqrt(cell_weights(found.cell))
    frames = points.keys[found.used]
    scatter = parameter_covariance(J * root[:, None], off * root, frames)
    outliers = len(points.frame) - len(used)
    return MeasuredElement(
        found.shape,
        found.shape,
        None,
        why,
        scatter,
        second,
        off,
        used,
        UnusedPoints(*left_out, outliers),
    )


def join_elements(elements: Sequence[MeasuredElement]) -> Knowledge | None:
    """What is known of elements together: with all that they share, or else their scatter alone.

    None if not even that is known.
    """
    known = [one.known for one in elements if one.known is not None]
    if len(known) == len(elements) and all(one.station is known[0].station for one in known):
        keys = np.unique(np.concatenate([one.keys for one in known]))
        features = []
        for one in known:
            frames = np.searchsorted(keys, one.keys)
            sums = replace(one.fitted.sums, frames=frames)
            features.append(MeasuredFeature(replace(one.fitted, sums=sums), 0, False))
        shared = known[0].station.shared
        assert shared is not None
        return join_features(features, shared)
    scatters = [one.scatter for one in elements if one.scatter is not None]
    if len(scatters) < len(elements):
        return None
    total = np.asarray(block_diag(*scatters))
    return Knowledge(tuple(one.shape for one in elements), {"scatter": total})


def why_only_scatter(elements: Sequence[MeasuredElement]) -> Text:
    """Why only the scatter of elements together is known; empty if more is."""
    for one in elements:
        if one.known is None:
            return one.why_scatter
    stations = [one.known.station for one in elements if one.known is not None]
    if all(one is stations[0] for one in stations):
        return ""
    return message("element-points-of-several-calibrations")


def _not_found(why: Text) -> OperationError:
    return OperationError("element-not-found", why, remedy=message("element-pick-more-of-it"))
