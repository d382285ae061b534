"""The closest point of a mesh is that of all triangles, and its sign that of the side."""

import numpy as np
import pytest

from crenel.metrology.transforms import Floats
from crenel.native.library import CRENEL
from crenel.parts.cad.maths_closest import MeshTree
from crenel.parts.cad.maths_mesh import PartMesh, mesh_from_corners
from tests.parts.meshes import box_corners, cylinder_corners, sphere_corners

NM = 1e-6
LARGE_MM = 5e3


def distances_by_every_triangle(mesh: PartMesh, points_mm: Floats) -> Floats:
    """(N,) by the plane of each triangle where the point is above it, else by its three sides."""
    a, b, c = (mesh.corners_mm[None, :, k] for k in range(3))
    p = points_mm[:, None]
    across = np.cross(b - a, c - a)
    n = across / np.linalg.norm(across, axis=2, keepdims=True)
    sides = [(a, b), (b, c), (c, a)]
    inside = np.ones((len(points_mm), len(mesh.triangles)), np.bool_)
    for start, end in sides:
        inside &= np.einsum("ptk,ptk->pt", np.cross(end - start, p - start), n + 0 * p) >= 0
    off = np.abs(np.einsum("ptk,ptk->pt", p - a, n + 0 * p))
    nearest = np.where(inside, off, np.inf)
    for start, end in sides:
        along = end - start
        share = np.einsum("ptk,ptk->pt", p - start, along + 0 * p) / np.sum(along**2, axis=2)
        foot = start + np.clip(share, 0, 1)[:, :, None] * along
        nearest = np.minimum(nearest, np.linalg.norm(p - foot, axis=2))
    return np.asarray(nearest.min(axis=1))


def random_triangles(rng: np.random.Generator, count: int) -> Floats:
    """Triangles of very different sizes and shapes, needles among them."""
    first = rng.uniform(-50, 50, (count, 1, 3))
    sides = rng.normal(size=(count, 2, 3)) * 10 ** rng.uniform(-3, 1.5, (count, 2, 1))
    return np.concatenate([first, first + sides], axis=1)


@pytest.mark.parametrize("variant", CRENEL.variants)
@pytest.mark.parametrize("count", [1, 7, 8, 9, 63, 65, 513])
def test_it_is_as_close_as_the_closest_of_all_triangles(variant: str, count: int) -> None:
    rng = np.random.default_rng(count)
    mesh, _ = mesh_from_corners(random_triangles(rng, count) + LARGE_MM)
    points = rng.uniform(-80, 80, (300, 3)) + LARGE_MM
    near = mesh.corners_mm.mean(axis=1)[rng.integers(0, count, 200)] + rng.normal(0, 0.02, (200, 3))
    points = np.concatenate([points, near, mesh.vertices_mm[:50]])
    with CRENEL.using(variant):
        found = MeshTree(mesh).closest(points)
    true = distances_by_every_triangle(mesh, points)
    assert np.abs(np.abs(found.distance_mm) - true).max() < NM
    assert np.abs(np.linalg.norm(points - found.at_mm, axis=1) - true).max() < NM
    on_its_face = distances_by_every_triangle(
        PartMesh(mesh.vertices_mm, mesh.triangles[found.faces[:1]]), points[:1]
    )
    assert abs(on_its_face[0] - true[0]) < NM


def test_what_is_beyond_the_band_is_left_out_and_the_rest_is_as_without_it() -> None:
    mesh, _ = mesh_from_corners(box_corners(np.array([140.0, 100.0, 20.0]), 4))
    points = np.random.default_rng(2).uniform(-80, 80, (3000, 3))
    tree = MeshTree(mesh)
    everywhere, near = tree.closest(points), tree.closest(points, 2.0)
    within = np.abs(everywhere.distance_mm) < 2.0
    assert 0 < within.sum() < len(points)
    assert (near.found == within).all()
    assert np.array_equal(near.distance_mm[within], everywhere.distance_mm[within])
    assert np.isnan(near.at_mm[~within]).all()


def test_scattered_points_have_the_same_closest_ones_as_ordered_ones() -> None:
    mesh, _ = mesh_from_corners(sphere_corners(30.0, 40))
    tree, rng = MeshTree(mesh), np.random.default_rng(7)
    ordered = np.column_stack([np.linspace(-40, 40, 4000), *rng.uniform(-5, 5, (2, 4000))])
    mixed = rng.permutation(4000)
    one, other = tree.closest(ordered), tree.closest(ordered[mixed])
    assert np.allclose(other.distance_mm, one.distance_mm[mixed], atol=NM, rtol=0)
    assert np.allclose(other.at_mm, one.at_mm[mixed], atol=1e-3)


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_a_point_that_is_no_number_has_no_closest_one(bad: float) -> None:
    mesh, _ = mesh_from_corners(box_corners(np.ones(3)))
    found = MeshTree(mesh).closest(np.array([[bad, 0.0, 0.0], [0.0, 0.0, 1.0]]), 2.0)
    assert found.faces[0] == -1
    assert found.distance_mm[1] == pytest.approx(0.5)


def test_the_sign_is_right_at_sharp_edges_and_corners() -> None:
    """A thin wedge, at whose edge the normal of the nearest face alone would often be wrong."""
    corners = cylinder_corners(10.0, 20.0, 5)
    corners[:, :, 1] *= 0.1
    mesh, _ = mesh_from_corners(corners)
    rng = np.random.default_rng(3)
    points = rng.uniform(-1.5, 1.5, (20_000, 3)) * [10.0, 1.0, 10.0]
    low = mesh.normals @ points.T - np.sum(mesh.normals * mesh.corners_mm[:, 0], axis=1)[:, None]
    is_outside = (low > 0).any(axis=0)  # of a convex part
    clear = np.abs(low).min(axis=0) > NM
    found = MeshTree(mesh).closest(points)
    assert ((found.distance_mm > 0) == is_outside)[clear].all()


def test_the_sign_is_right_in_a_bore() -> None:
    shell = np.concatenate([sphere_corners(20.0, 24), sphere_corners(10.0, 24)[:, ::-1]])
    mesh, _ = mesh_from_corners(shell)
    found = MeshTree(mesh).closest(np.array([[5.0, 0, 0], [15.0, 1, 2], [25.0, 0, 0]]))
    assert (np.sign(found.distance_mm) == [1, -1, 1]).all()
