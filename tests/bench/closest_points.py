"""The exact closest point of a mesh beside libigl, which is installed for this alone (libigl).

One thread, one run, the same 190,000 triangles of a wavy body and the same points, 20 µm off it: in
the order of a scan, and shuffled. The tree is also built of a million triangles.
"""

import os
import time
from collections.abc import Callable

os.environ["IGL_NUM_THREADS"] = "1"

import numpy as np

from crenel.metrology.transforms import Floats
from crenel.parts.cad.maths_closest import MeshTree
from crenel.parts.cad.maths_mesh import PartMesh, mesh_from_corners
from tests.bench.rows import bench_parser, measured_rows

POINTS, TURNS = 200_000, 5
AWAY_MM = 0.02


def wavy_body(around: int, radius_mm: float = 40.0) -> Floats:
    """(T, 3, 3) of about 2 × around² triangles."""
    turn = np.linspace(0, 2 * np.pi, around + 1)
    rise = np.linspace(0.02, np.pi - 0.02, around + 1)
    u, v = np.meshgrid(turn, rise)
    r = radius_mm * (1 + 0.1 * np.sin(5 * u) * np.sin(v) ** 2 + 0.05 * np.cos(7 * v))
    grid = np.stack([r * np.cos(u) * np.sin(v), r * np.sin(u) * np.sin(v), r * np.cos(v)], axis=-1)
    a, b, c, d = grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]
    return np.concatenate([np.stack(t, axis=2).reshape(-1, 3, 3) for t in ((a, b, c), (a, c, d))])


def points_of_scan(mesh: PartMesh, rng: np.random.Generator) -> Floats:
    """Points in lines along the triangles."""
    faces = np.arange(POINTS) * len(mesh.triangles) // POINTS
    shares = rng.dirichlet(np.ones(3), POINTS)
    on = np.einsum("nc,nci->ni", shares, mesh.corners_mm[faces])
    return np.asarray(on + rng.normal(0.0, AWAY_MM, on.shape))


def best_seconds(run: Callable[[], object]) -> float:
    """Of the processor, the shortest of a few turns: other programs do not count."""
    seconds = []
    for _ in range(TURNS):
        began = time.process_time()
        run()
        seconds.append(time.process_time() - began)
    return min(seconds)


def main() -> None:
    given = bench_parser(__doc__).parse_args()
    import igl

    rng = np.random.default_rng(1)
    mesh, _ = mesh_from_corners(wavy_body(308))
    tree = MeshTree(mesh)
    scan = points_of_scan(mesh, rng)
    faces = mesh.triangles.astype(np.int64)
    with measured_rows(given.json) as rows:
        for name, points in (("in order", scan), ("shuffled", rng.permutation(scan))):
            found = tree.closest(points, 2.0)
            square, *_ = igl.point_mesh_squared_distance(points, mesh.vertices_mm, faces)
            off = np.abs(np.sqrt(square) - np.abs(found.distance_mm))

            def by_igl(points: Floats = points) -> None:
                igl.point_mesh_squared_distance(points, mesh.vertices_mm, faces)

            def by_tree(points: Floats = points) -> None:
                MeshTree(mesh).closest(points, 2.0)

            other, own = best_seconds(by_igl), best_seconds(by_tree)
            rows.add(
                f"{len(mesh.triangles)} triangles, {name}",
                {
                    "us a point": 1e6 * own / POINTS,
                    "igl us a point": 1e6 * other / POINTS,
                    "times as fast": other / own,
                    "differs nm": 1e6 * float(off.max()),
                },
            )
        large, _ = mesh_from_corners(wavy_body(708))
        _ = large.corners_mm, large.edges, large.edge_normals, large.vertex_normals
        seconds = best_seconds(lambda: MeshTree(large))
        rows.add(f"tree of {len(large.triangles)} triangles", {"s": seconds})


if __name__ == "__main__":
    main()
