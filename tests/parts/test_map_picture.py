"""A map as squares on the part: where they lie, how many, in which colours, what a tap finds."""

import json
import struct
from pathlib import Path

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.formats.drawings.glb import glb_bytes
from crenel.metrology.colormaps import oklab
from crenel.parts.cad.maths_mesh import mesh_from_corners
from crenel.parts.compare.document_comparison import read_comparison
from crenel.parts.compare.document_part import KeptPart
from crenel.parts.compare.maths_map_colours import (
    GREYS,
    INSIDE,
    OUTSIDE,
    UNSCANNED,
    colour_map,
    light_up,
)
from crenel.parts.compare.maths_squares import (
    LIFTED,
    first_hit_mm,
    group_cells,
    square_corners,
    thin_triangles,
)
from tests.parts.meshes import box_corners, sphere_corners

EDGE = 0.8
SIZE = np.array([20.0, 12.0, 6.0])
EYES = {
    "protan": [[0.152, 1.053, -0.205], [0.115, 0.786, 0.099], [-0.004, -0.048, 1.052]],
    "deutan": [[0.367, 0.861, -0.228], [0.280, 0.673, 0.047], [-0.012, 0.043, 0.969]],
}
"""What eyes without one kind of cone see of light (R, G, B): Machado and others, 2009."""


def grid(size: int) -> tuple[np.ndarray, np.ndarray]:
    """Places and normals of cells on a plane of z = 3, anywhere in their squares."""
    rng = np.random.default_rng(3)
    x, y = np.meshgrid(np.arange(size), np.arange(size), indexing="ij")
    at = EDGE * np.stack([x, y, np.full_like(x, 3.0 / EDGE, dtype=float)], axis=-1).reshape(-1, 3)
    at[:, :2] += rng.uniform(-0.4, 0.4, (len(at), 2)) * EDGE
    return at, np.tile([0.0, 0.0, 1.0], (len(at), 1))


def test_squares_of_a_plane_meet_and_face_outwards() -> None:
    at, normals = grid(5)
    big = np.full(3, 100.0)
    corners = square_corners(at, normals, EDGE, -big, big)
    assert np.allclose(corners[..., 2], 3.0 + LIFTED * EDGE)
    sides = np.unique(np.round(corners[..., :2].reshape(-1, 2) / EDGE, 6), axis=0)
    assert len(sides) == 6 * 6  # neighbours have corners in common
    turned = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 1])
    assert np.allclose(turned, [0.0, 0.0, EDGE**2])
    below = square_corners(at, -normals, EDGE, -big, big)
    turned = np.cross(below[:, 1] - below[:, 0], below[:, 2] - below[:, 1])
    assert np.allclose(turned, [0.0, 0.0, -(EDGE**2)])


def test_squares_lie_on_slopes_and_within_the_part() -> None:
    normal = np.array([[0.6, 0.0, 0.8]])
    at = np.array([[1.6, 0.0, 5.0]])
    low, high = np.array([1.3, -9.0, -9.0]), np.full(3, 9.0)
    corners = square_corners(at, normal, EDGE, low, high)
    off = (corners[0] - at[0]) @ normal[0]
    assert np.allclose(off, LIFTED * EDGE)
    lifted = LIFTED * EDGE * 0.6
    assert corners[0, :, 0].min() == pytest.approx(1.3 + lifted)


def test_of_very_many_cells_the_gravest_is_shown() -> None:
    at, normals = grid(20)
    grave = np.zeros(len(at))
    grave[137] = 1.0
    all_of_them = group_cells(at, normals, grave, EDGE, 400)
    assert len(all_of_them.first) == 400
    assert all_of_them.edge_mm == EDGE
    few = group_cells(at, normals, grave, EDGE, 120)
    assert len(few.first) <= 121
    assert few.edge_mm == 2 * EDGE
    assert 137 in few.first


def test_a_thinned_surface_stays_where_it_was() -> None:
    mesh, _ = mesh_from_corners(sphere_corners(20.0, 160))
    vertices, triangles = thin_triangles(mesh.vertices_mm, mesh.triangles, 4000)
    assert 500 < len(triangles) <= 4000
    assert np.allclose(np.linalg.norm(vertices, axis=1), 20.0, atol=1e-9)
    same, whole = thin_triangles(mesh.vertices_mm, mesh.triangles, 10**6)
    assert same is mesh.vertices_mm
    assert whole is mesh.triangles


def test_a_ray_meets_the_nearest_face() -> None:
    mesh, _ = mesh_from_corners(box_corners(SIZE))
    ahead = np.array([0.0, 0.0, -1.0])
    origin = np.array([4.0, -3.0, 50.0])
    assert first_hit_mm(origin, ahead, mesh.vertices_mm, mesh.triangles) == pytest.approx(47.0)
    beside = np.array([11.0, 0.0, 50.0])
    assert first_hit_mm(beside, ahead, mesh.vertices_mm, mesh.triangles) == np.inf
    behind = np.array([0.0, 0.0, -50.0])
    assert first_hit_mm(behind, ahead, mesh.vertices_mm, mesh.triangles) == np.inf


def test_deviations_have_one_scale_to_both_sides() -> None:
    off = np.array([-200.0, -20.0, 0.0, 20.0, 200.0])
    found = colour_map("deviation", off, np.ones(5), np.zeros(5, np.uint8), (-10.0, 50.0))
    assert (found.low_um, found.high_um) == (-100.0, 100.0)
    assert found.index[2] == pytest.approx((found.index[0] + found.index[4]) / 2, abs=1)
    unknown = colour_map("uncertainty", off, np.full(5, np.nan), np.zeros(5, np.uint8), (-1, 1))
    assert set(unknown.index) == {len(unknown.colours) - 1}
    known = colour_map("uncertainty", off, np.full(5, 4.0), np.zeros(5, np.uint8), (-1, 1))
    assert known.high_um == 8.0  # expanded


def colours_for(eye: str, rgb: np.ndarray) -> np.ndarray:
    """Colours (N, 3) that look to usual eyes as these do to others."""
    share = rgb / 255
    light = np.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4)
    light = np.clip(light @ np.array(EYES[eye]).T, 0, 1)
    bent = np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
    return np.asarray(255 * bent)


def test_undecided_cells_have_two_greys() -> None:
    decisions = np.array([0, 1, 2], np.uint8)
    found = colour_map("significance", np.zeros(3), np.ones(3), decisions, (-1.0, 1.0))
    assert [found.colours[k] for k in found.index] == [INSIDE, OUTSIDE, GREYS[0]]
    assert [found.colours[k] for k in found.other] == [INSIDE, OUTSIDE, GREYS[1]]


@pytest.mark.parametrize("eye", EYES)
def test_decisions_differ_for_colour_blind_eyes(eye: str) -> None:
    colours = np.array([INSIDE, OUTSIDE, *GREYS, UNSCANNED], dtype=float)
    seen = oklab(colours_for(eye, colours))
    for one in range(2):
        apart = np.linalg.norm(np.delete(seen, one, axis=0) - seen[one], axis=1)
        assert apart.min() > 0.09, (one, apart)


def test_light_darkens_little() -> None:
    triangles = box_corners(SIZE)
    colours = np.full((len(triangles), 3), 200, np.uint8)
    lit = light_up(triangles, colours, np.eye(3))
    assert 150 <= lit.min() < lit.max() <= 200
    upper = triangles[:, :, 2].min(axis=1) == 3.0
    assert (lit[upper] > lit[~upper].min()).all()


def test_a_glb_is_whole_and_states_light() -> None:
    corners = 1e-3 * box_corners(SIZE)
    colours = np.tile(np.array([[255, 0, 188]], np.uint8), (len(corners), 1))
    content = glb_bytes(corners, colours)
    magic, version, length = struct.unpack_from("<4sII", content)
    assert (magic, version, length) == (b"glTF", 2, len(content))
    size, kind = struct.unpack_from("<I4s", content, 12)
    assert kind == b"JSON"
    document = json.loads(content[20 : 20 + size])
    binary = content[28 + size :]
    assert len(binary) >= document["buffers"][0]["byteLength"]
    positions, shades = document["accessors"]
    assert positions["count"] == shades["count"] == 3 * len(corners)
    split = document["bufferViews"][1]["byteOffset"]
    places = np.frombuffer(binary[:split], "<f4").reshape(-1, 3, 3)
    assert np.allclose(places, corners)
    light = np.frombuffer(binary, "<u2", 4, split) / 65535
    assert light == pytest.approx([1.0, 0.0, ((188 / 255 + 0.055) / 1.055) ** 2.4, 1.0], abs=1e-4)


@pytest.mark.parametrize("content", [b"", b"PK\3\4 cut", b"no archive"])
def test_a_damaged_map_is_named(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "deviation.zip"
    path.write_bytes(content)
    with pytest.raises(OperationError) as refused:
        read_comparison(path)
    assert refused.value.code == "comparison-damaged"
    assert "deviation.zip is damaged" in refused.value.line


def test_a_kept_part_without_its_file_is_named(tmp_path: Path) -> None:
    with pytest.raises(OperationError):
        KeptPart.of_folder(tmp_path)
