"""The surface of a chessboard: the true positions of its corners, and how it bends.

Its coordinates are the width and height of the pattern (mm), the amplitudes (mm) of a few smooth
shapes in which it bends, the misprint (mm) of each corner, and its individual height (mm): paper is
not as smooth as the shapes.

The bend is a smooth random surface, a Gaussian process with the board's flatness as its standard
deviation and ``SMOOTH_SHARE`` of the pattern as its correlation length. Its shapes are the
principal ones (Karhunen-Loeve) of the surface around the pattern, so that their amplitudes are
independent. The plane part of each shape over the pattern is removed: it is the pose of the board.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.adjustment.core.observations import TargetPrior
from crenel.metrology.targets.chessboard import Chessboard, corner_grid, corner_points
from crenel.metrology.transforms import Floats

EXTENT = slice(0, 2)
LEAST_MM = 1e-6
# How far around the pattern the surface is described, in squares; the correlation length as a share
# of the pattern's diagonal; and the factor by which nodes are closer than that.
AROUND_SQUARES = 4.0
SMOOTH_SHARE, NODES_PER_LENGTH = 0.5, 2.0
# Shapes are kept until they explain this share of the variance.
VARIANCE_SHARE = 0.995
# Height of individual corners as a share of the smooth bend.
DENTS_SHARE = 0.25


@dataclass(frozen=True)
class BendModes:
    """K smooth shapes: ``exp(-d^2 / 2 l^2)`` about the nodes of a grid, X within Y, summed with
    ``weights`` (M, K), minus a plane (3, K) over 1, x and y."""

    nodes_x_mm: Floats
    nodes_y_mm: Floats
    length_mm: float
    weights: Floats
    planes: Floats

    def bells(self, xy_mm: Floats) -> tuple[Floats, Floats]:
        """Factors of the kernels along x (N, X) and y (N, Y)."""
        return _bells(*self._away(xy_mm))

    def by_strength(self, xy_mm: Floats) -> Floats:
        """Heights (N, K) of each shape at positions (N, 2)."""
        along_x, along_y = self.bells(xy_mm)
        bells = (along_y[:, :, None] * along_x[:, None, :]).reshape(len(xy_mm), len(self.weights))
        flat = np.column_stack([np.ones(len(xy_mm)), xy_mm]) @ self.planes
        return np.asarray(bells @ self.weights - flat)

    def heights(self, strengths: Floats, xy_mm: Floats) -> Floats:
        """Height (N,) of all shapes together at positions (N, 2)."""
        along_x, along_y = self.bells(xy_mm)
        plane = self.planes @ strengths
        height = np.sum((along_y @ self._at_nodes(strengths)) * along_x, axis=1)
        return np.asarray(height - plane[0] - xy_mm @ plane[1:])

    def slopes(self, strengths: Floats, xy_mm: Floats) -> Floats:
        """Slopes (N, 2) of all shapes together along x and y."""
        away_x, away_y = self._away(xy_mm)
        along_x, along_y = _bells(away_x, away_y)
        at_nodes, plane = self._at_nodes(strengths), self.planes @ strengths
        by_x = np.sum((along_y @ at_nodes) * along_x * away_x, axis=1)
        by_y = np.sum(((along_y * away_y) @ at_nodes) * along_x, axis=1)
        return np.asarray(-np.column_stack([by_x, by_y]) / self.length_mm - plane[1:])

    def _away(self, xy_mm: Floats) -> tuple[Floats, Floats]:
        """From the nodes along x (N, X) and y (N, Y), in correlation lengths."""
        x = (xy_mm[:, :1] - self.nodes_x_mm) / self.length_mm
        return x, (xy_mm[:, 1:] - self.nodes_y_mm) / self.length_mm

    def _at_nodes(self, strengths: Floats) -> Floats:
        return np.asarray((self.weights @ strengths).reshape(len(self.nodes_y_mm), -1))


def _bells(away_x: Floats, away_y: Floats) -> tuple[Floats, Floats]:
    return np.exp(-0.5 * away_x**2), np.exp(-0.5 * away_y**2)


@dataclass(frozen=True)
class SurfacePoints:
    """The surface at N positions: slopes (N, 2) along x and y, and derivatives (N, K) of the
    heights by the amplitudes of the shapes."""

    slope: Floats
    by_bend: Floats


@lru_cache(maxsize=8)
def bend_modes(board: Chessboard) -> BendModes:
    """The shapes in which a board's surface may bend, each with variance 1 at its maximum."""
    length = SMOOTH_SHARE * board.size_mm
    margin = AROUND_SQUARES * board.square_mm
    span = board.extent_mm + 2 * margin
    counts = np.ceil(span / length * NODES_PER_LENGTH).astype(np.int64) + 1
    x, y = (np.linspace(-margin, -margin + s, n) for s, n in zip(span, counts, strict=True))
    nodes = np.column_stack([axis.ravel() for axis in np.meshgrid(x, y)])
    apart = np.sum((nodes[:, None] - nodes) ** 2, axis=2) / length**2
    variances, principal = np.linalg.eigh(np.exp(-0.5 * apart))
    variances, principal = variances[::-1], principal[:, ::-1]
    count = int(np.searchsorted(np.cumsum(variances), VARIANCE_SHARE * variances.sum())) + 1
    weights = np.asarray(principal[:, :count] / np.sqrt(variances[:count]), np.float64)
    plain = BendModes(x, y, length, weights, np.zeros((3, count)))
    corners = corner_points(board)[:, :2]
    terms = np.column_stack([np.ones(len(corners)), corners])
    planes = np.asarray(np.linalg.pinv(terms) @ plain.by_strength(corners), np.float64)
    return BendModes(x, y, length, weights, planes)


def bend_slice(board: Chessboard) -> slice:
    """Indices of the amplitudes of the shapes among the coordinates."""
    return slice(EXTENT.stop, EXTENT.stop + bend_modes(board).weights.shape[1])


def coordinate_groups(board: Chessboard) -> tuple[slice, slice, slice]:
    """Indices of the bend, the misprints and the individual heights; each group has one standard
    deviation."""
    count, bend = len(corner_grid(board)), bend_slice(board)
    prints = slice(bend.stop, bend.stop + 2 * count)
    return bend, prints, slice(prints.stop, prints.stop + count)


def board_prior(board: Chessboard) -> TargetPrior:
    """The certificate as a prior: extents and corners with its standard uncertainty, flat to its
    flatness."""
    count, bend = len(corner_grid(board)), bend_slice(board)
    names = ("extent_x", "extent_y", *(f"bend:{k}" for k in range(bend.stop - bend.start)))
    names += tuple(f"print_x:{k}" for k in range(count))
    names += tuple(f"print_y:{k}" for k in range(count))
    names += tuple(f"dent:{k}" for k in range(count))
    values = np.zeros(len(names))
    values[EXTENT] = board.extent_mm
    sd = np.full(len(names), max(board.standard_uncertainty_mm, LEAST_MM))
    sd[bend] = max(board.flatness_mm, LEAST_MM)
    sd[-count:] = max(DENTS_SHARE * board.flatness_mm, LEAST_MM)
    return TargetPrior(names, values, sd)


def evaluate_surface(board: Chessboard, coordinates: Floats, xy_mm: Floats) -> SurfacePoints:
    """The bent surface at positions (N, 2) in the board frame."""
    own = bend_modes(board)
    slopes = own.slopes(coordinates[bend_slice(board)], xy_mm)
    return SurfacePoints(slopes, own.by_strength(xy_mm))


def surface_height_mm(board: Chessboard, coordinates: Floats, xy_mm: Floats) -> Floats:
    """Heights (N,) of the bent surface at positions (N, 2) in the board frame."""
    return bend_modes(board).heights(coordinates[bend_slice(board)], xy_mm)


def corners_at(board: Chessboard, coordinates: Floats) -> Floats:
    """(N, 3) true positions of the corners in the board frame."""
    share = corner_grid(board) / (np.array(board.inner_corners) - 1)
    print_x, print_y, dent = coordinates[bend_slice(board).stop :].reshape(3, len(share))
    xy = share * coordinates[EXTENT] + np.column_stack([print_x, print_y])
    return np.column_stack([xy, surface_height_mm(board, coordinates, xy) + dent])


def around_pattern(board: Chessboard, points_mm: Floats) -> NDArray[np.bool_]:
    """Mask of the points (N, 3) where the surface is described."""
    beyond = np.maximum(-points_mm[:, :2], points_mm[:, :2] - board.extent_mm)
    return np.asarray((beyond < AROUND_SQUARES * board.square_mm).all(axis=1))
