"""A best fit finds the part, and is refused by name where the scan does not fix it."""

from pathlib import Path

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.metrology.transforms import Floats, apply, rigid, rotation_from_vector
from crenel.parts.cad.evaluate_part import Part, read_part
from crenel.parts.deviation.evaluate_pose import PlacedScan, ScanOnPart, place_by_best_fit
from tests.parts.meshes import box_corners, cylinder_corners, sphere_corners, write_stl

NOISE_MM = 0.012
POINTS = 6000
BOX_MM = np.array([140.0, 100.0, 20.0])


def bracket() -> Floats:
    ribs = [
        box_corners(np.array([30.0, 20.0, 15.0])) + [40.0, -20.0, 17.5],
        box_corners(np.array([20.0, 50.0, 10.0])) + [-50.0, 10.0, 15.0],
    ]
    return np.concatenate([box_corners(BOX_MM), *ribs])


def sample(part: Part, rng: np.random.Generator, least_z: float = -0.5) -> Floats:
    """Points on the faces whose normals are not below."""
    mesh = part.mesh
    areas = mesh.areas_mm2 * (mesh.normals[:, 2] > least_z)
    faces = rng.choice(len(areas), POINTS, p=areas / areas.sum())
    shares = rng.dirichlet(np.ones(3), POINTS)
    on = np.einsum("nc,nci->ni", shares, mesh.corners_mm[faces])
    return np.asarray(on + rng.normal(0.0, NOISE_MM, (POINTS, 3)))


def place(
    tmp_path: Path,
    corners: Floats,
    points: Floats | None = None,
    locked: tuple[str, ...] = (),
    least_z: float = -0.5,
    seed: int = 1,
) -> tuple[PlacedScan, Floats]:
    """A part found in a scan, and where it truly was."""
    rng = np.random.default_rng(seed)
    part = read_part(write_stl(tmp_path / "part.stl", corners), "mm")
    turn = rotation_from_vector(rng.normal(0.0, 1.5, 3))
    T = rigid(turn, rng.normal(0.0, 300.0, 3))
    given = sample(part, rng, least_z) if points is None else points
    scan = ScanOnPart(part, apply(T, given), None, 2.0)
    return place_by_best_fit(scan, locked), T


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_part_is_found_wherever_it_lies(tmp_path: Path, seed: int) -> None:
    placed, T = place(tmp_path, bracket(), seed=seed)
    corners = bracket().reshape(-1, 3)
    off = apply(placed.pose.T_part_arm @ T, corners) - corners
    assert np.abs(off).max() < 0.004
    assert not placed.notes


@pytest.mark.parametrize(
    ("corners", "least_z", "free"),
    [
        (sphere_corners(15.0, 24) + [30.0, 0.0, 0.0], -2.0, ["about x", "about y", "about z"]),
        (cylinder_corners(15.0, 60.0, 24) + [0.0, 5.0, 0.0], -0.5, ["about z through 0.0, 5.0"]),
        (box_corners(BOX_MM), 0.5, ["along", "about"]),
    ],
    ids=["sphere", "cylinder", "plane"],
)
def test_free_motions_are_named(
    tmp_path: Path, corners: Floats, least_z: float, free: list[str]
) -> None:
    with pytest.raises(OperationError) as refused:
        place(tmp_path, corners, least_z=least_z)
    assert refused.value.code == "part-fit-free"
    assert all(one in refused.value.line for one in free)
    assert "Lock " in refused.value.line


def test_a_locked_motion_is_not_asked_for(tmp_path: Path) -> None:
    corners = cylinder_corners(15.0, 60.0, 24)
    placed, _ = place(tmp_path, corners, locked=("rz",))
    assert abs(float(np.median(placed.cells.deviation_mm))) < 0.15  # within its facets


def test_a_second_pose_of_a_symmetric_part_is_shown(tmp_path: Path) -> None:
    placed, _ = place(tmp_path, box_corners(BOX_MM))
    assert any("symmetric" in str(note) for note in placed.notes)


def test_a_mirrored_part_is_refused_with_its_residual(tmp_path: Path) -> None:
    legs = [
        box_corners(np.array([60.0, 10.0, 10.0])) + [30.0, 0.0, 0.0],
        box_corners(np.array([10.0, 40.0, 10.0])) + [0.0, 20.0, 0.0],
        box_corners(np.array([10.0, 10.0, 25.0])) + [0.0, 0.0, 12.0],
    ]
    corners = np.concatenate(legs)
    path = write_stl(tmp_path / "scanned.stl", corners)
    points = sample(read_part(path, "mm"), np.random.default_rng(5), -2.0)
    with pytest.raises(OperationError) as refused:
        place(tmp_path, corners * [-1.0, 1.0, 1.0], points)
    assert refused.value.code == "part-mirrored"
    assert "µm" in refused.value.line


def test_a_scan_of_another_part_is_refused_with_its_residual(tmp_path: Path) -> None:
    points = np.random.default_rng(6).uniform(-1, 1, (POINTS, 3)) * BOX_MM / 2
    with pytest.raises(OperationError) as refused:
        place(tmp_path, bracket(), points)
    assert refused.value.code == "part-fit-poor"
    assert "mm" in refused.value.line


@pytest.mark.parametrize(("factor", "unit"), [(25.4, "inch"), (1000.0, "m")])
def test_a_part_of_another_unit_is_refused_with_the_unit(
    tmp_path: Path, factor: float, unit: str
) -> None:
    path = write_stl(tmp_path / "scanned.stl", bracket())
    points = sample(read_part(path, "mm"), np.random.default_rng(5))
    with pytest.raises(OperationError) as refused:
        place(tmp_path, bracket() / factor, points)
    assert refused.value.code == "part-size-differs"
    assert f"State {unit} as the unit" in refused.value.line
