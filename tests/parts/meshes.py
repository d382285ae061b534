"""Meshes for tests: boxes, spheres and cylinders as triangles, and files of them."""

from pathlib import Path

import numpy as np

from crenel.formats.drawings.stl import TRIANGLE
from crenel.metrology.transforms import Floats

HEAD = b"a part".ljust(80)


def box_corners(size_mm: Floats, steps: int = 1) -> Floats:
    """(T, 3, 3) of a box about the origin, each side divided into steps × steps."""
    grid = np.linspace(-0.5, 0.5, steps + 1)
    a, b = np.meshgrid(grid, grid, indexing="ij")
    square = np.stack([a, b, np.full_like(a, 0.5)], axis=-1)
    upper = _grid_triangles(square)
    sides = []
    for axis in range(3):
        turned = np.roll(upper, axis + 1, axis=2)
        sides += [turned, (-turned)[:, ::-1]]
    return np.concatenate(sides) * size_mm


def sphere_corners(radius_mm: float, segments: int) -> Floats:
    """(T, 3, 3) of a sphere about the origin, with its corners on it."""
    turn = 2 * np.pi * np.arange(segments + 1) / segments
    rise = np.pi * np.arange(segments // 2 + 1) / (segments // 2)
    turn[-1], unit = 0.0, np.ones_like
    grid = np.stack(
        [
            np.outer(np.sin(rise), np.cos(turn)),
            np.outer(np.sin(rise), np.sin(turn)),
            np.outer(np.cos(rise), unit(turn)),
        ],
        axis=-1,
    )
    grid[[0, -1], :, :2] = 0.0
    return _grid_triangles(grid * radius_mm)


def cylinder_corners(radius_mm: float, length_mm: float, segments: int) -> Floats:
    """(T, 3, 3) of a cylinder about the z axis, closed by a fan at each end."""
    turn = 2 * np.pi * np.arange(segments + 1) / segments
    turn[-1] = 0.0
    ring = radius_mm * np.column_stack([np.cos(turn), np.sin(turn)])
    rows = [(0.0, 0.5), (1.0, 0.5), (1.0, -0.5), (0.0, -0.5)]
    grid = np.stack(
        [np.column_stack([r * ring, np.full(len(ring), z * length_mm)]) for r, z in rows]
    )
    return _grid_triangles(grid)


def _grid_triangles(grid: Floats) -> Floats:
    """(T, 3, 3) of a grid of points (A, B, 3)."""
    a, b, c, d = grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]
    quads = np.stack([a, b, c, a, c, d], axis=2).reshape(-1, 2, 3, 3)
    return np.concatenate([quads[:, 0], quads[:, 1]])


def stl_bytes(corners: Floats, head: bytes = HEAD, announced: int | None = None) -> bytes:
    """A binary STL."""
    rows = np.zeros(len(corners), TRIANGLE)
    rows["corners"] = corners
    count = len(corners) if announced is None else announced
    return head + np.uint32(count).tobytes() + rows.tobytes()


def stl_text(corners: Floats) -> str:
    """An STL in text."""
    facets = []
    for corner in corners:
        lines = "".join(f"   vertex {x:.6f} {y:.6f} {z:.6f}\n" for x, y, z in corner)
        facets.append(f" facet normal 0 0 0\n  outer loop\n{lines}  endloop\n endfacet\n")
    return f"solid a part\n{''.join(facets)}endsolid a part\n"


def write_stl(path: Path, corners: Floats) -> Path:
    """A binary STL as a file."""
    path.write_bytes(stl_bytes(corners))
    return path
