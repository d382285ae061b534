"""Cells of a surface as squares to look at, and the surface beneath with fewer triangles."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.transforms import Floats

LIFTED = 0.1
"""Of a cell's edge: by so much its square is above the surface, which would else shine through."""
Indices = NDArray[np.int64]


@dataclass(frozen=True)
class CellGroups:
    """Cells, several of which may be shown as one square."""

    first: Indices
    """(S,) the cell that each square shows: the gravest of its own."""
    edge_mm: float
    """Of the squares."""


def group_cells(
    at_mm: Floats, normals: Floats, grave: Floats, edge_mm: float, most: int
) -> CellGroups:
    """Which cells are shown, so that there are not more squares than ``most``.

    Args:
        at_mm: (C, 3) places.
        normals: (C, 3) unit.
        grave: (C,) of several cells in one square, the one with the largest is shown.
        edge_mm: of the cells.
    """
    shown, edge = np.arange(len(at_mm)), edge_mm
    order = np.argsort(-grave, kind="stable")
    while len(shown) > most:
        edge *= 2
        _, first = np.unique(_square_keys(at_mm[order], normals[order], edge), return_index=True)
        shown = np.sort(order[first])
    return CellGroups(shown, edge)


def square_corners(
    at_mm: Floats, normals: Floats, edge_mm: float, low_mm: Floats, high_mm: Floats
) -> Floats:
    """(C, 4, 3) corners, anticlockwise from outside, of squares on the tangent planes of cells.

    Args:
        at_mm: (C, 3) places of the cells, of the grid of ``surface_cells``.
        normals: (C, 3) unit, outwards.
        low_mm: (3,) and ``high_mm`` (3,): of the part, beyond which no corner is.
    """
    rows = np.arange(len(at_mm))
    axis = np.argmax(np.abs(normals), axis=1)
    centre = edge_mm * np.floor(at_mm / edge_mm + 0.5)
    corners = np.repeat(centre[:, None], 4, axis=1)
    first, second = (axis + 1) % 3, (axis + 2) % 3
    for k, (a, b) in enumerate(((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5))):
        corners[rows, k, first] += a * edge_mm
        corners[rows, k, second] += b * edge_mm
    corners = np.clip(corners, low_mm, high_mm)
    corners[rows, :, axis] = at_mm[rows, axis][:, None]
    off = np.einsum("cki,ci->ck", corners - at_mm[:, None], normals)
    corners[rows, :, axis] -= off / normals[rows, axis][:, None]
    is_inward = normals[rows, axis] < 0
    corners[is_inward] = corners[is_inward, ::-1]
    return np.asarray(corners + LIFTED * edge_mm * normals[:, None])


def thin_triangles(
    vertices_mm: Floats, triangles: NDArray[np.int32], most: int
) -> tuple[Floats, NDArray[np.int32]]:
    """The surface with at most so many triangles, by joining vertices that are near each other."""
    edge = float(np.linalg.norm(np.ptp(vertices_mm, axis=0))) / 1000
    thin_vertices, thin = vertices_mm, triangles
    while len(thin) > most:
        cubes = np.floor((vertices_mm - vertices_mm.min(axis=0)) / edge).astype(np.int64)
        _, first, number = np.unique(cubes, axis=0, return_index=True, return_inverse=True)
        corners = number.ravel()[triangles]
        a, b, c = corners.T
        thin = corners[(a != b) & (b != c) & (c != a)].astype(np.int32)
        thin_vertices, edge = vertices_mm[first], 1.5 * edge
    return thin_vertices, thin


def first_hit_mm(
    origin_mm: Floats, direction: Floats, vertices_mm: Floats, triangles: NDArray[np.int32]
) -> float:
    """How far along a ray the first triangle is, seen from either side; infinite without one.

    Source:
        T. Moeller, B. Trumbore, Fast, minimum storage ray/triangle intersection, J. Graphics
        Tools 2 (1997) 21-28.
    """
    a, b, c = (vertices_mm[triangles[:, k]] for k in range(3))
    one, other = b - a, c - a
    across = np.cross(direction, other)
    size = np.einsum("ti,ti->t", one, across)
    with np.errstate(divide="ignore", invalid="ignore"):
        away = origin_mm - a
        u = np.einsum("ti,ti->t", away, across) / size
        turned = np.cross(away, one)
        v = turned @ direction / size
        far = np.einsum("ti,ti->t", other, turned) / size
        is_hit = (u >= 0) & (v >= 0) & (u + v <= 1) & (far > 0)
    return float(far[is_hit].min(initial=np.inf))


def _square_keys(at_mm: Floats, normals: Floats, edge_mm: float) -> Indices:
    """(C,) one number for all cells of a square of this edge, facing one way."""
    rows = np.arange(len(at_mm))
    axis = np.argmax(np.abs(normals), axis=1)
    is_inward = normals[rows, axis] < 0
    at = np.floor(at_mm / edge_mm + 0.5).astype(np.int64)
    at -= at.min(axis=0)
    width = at.max(axis=0) + 1
    key = 2 * axis + is_inward
    for k in range(3):
        key = key * width[k] + at[:, k]
    return np.asarray(key, dtype=np.int64)
