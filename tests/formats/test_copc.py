"""COPC: an octree that other programs read in part, with every point in it once."""

from pathlib import Path

import laspy
import numpy as np
import pytest

pytest.importorskip("copclib")

import copclib
from laspy.copc import Bounds, CopcReader

from crenel.formats.clouds.files import cloud_writer, read_cloud
from crenel.formats.clouds.las import copc
from crenel.metrology.transforms import Floats

COUNT = 30_000


@pytest.fixture
def table() -> Floats:
    """(N, 6) of a part and a few points far away, by which most places have no points."""
    rng = np.random.default_rng(3)
    points = np.column_stack(
        [rng.uniform(-90, 110, COUNT), rng.uniform(40, 90, COUNT), rng.normal(5, 1, COUNT)]
    )
    points[::3000] += (900.0, -700.0, 300.0)
    intensity = rng.integers(0, 4095, COUNT)
    uncertainty_um = rng.uniform(1, 90, COUNT).astype(np.float32)
    return np.column_stack([points, intensity, uncertainty_um, np.arange(COUNT) // 100])


@pytest.fixture
def path(tmp_path: Path, table: Floats, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Sorted in several runs, and of more nodes than so few points would have."""
    monkeypatch.setattr(copc, "RUN_POINTS", 7_000)
    monkeypatch.setattr(copc, "NODE_POINTS", 300)
    path = tmp_path / "cloud.copc.laz"
    with cloud_writer(path) as cloud:
        for first in range(0, COUNT, 4_000):
            rows = table[first : first + 4_000]
            cloud.write(rows[:, :3], rows[:, 3], rows[:, 4], rows[:, 5])
    assert [entry.name for entry in tmp_path.iterdir()] == [path.name]
    return path


def in_order(rows: Floats) -> Floats:
    """Rows that are the same except for rounding are in the same order."""
    rounded = np.round(rows, 4)
    return rounded[np.lexsort(rounded.T[:3])]


def test_every_point_is_there_once(path: Path, table: Floats) -> None:
    cloud = read_cloud(path)
    columns = (cloud.intensity, cloud.uncertainty_um, cloud.frame)
    assert all(column is not None for column in columns)
    found = in_order(np.column_stack([cloud.points_mm, *map(np.asarray, columns)]))
    np.testing.assert_allclose(found, in_order(table), rtol=0, atol=1.01e-4)


def test_others_read_the_part_that_they_show(path: Path, table: Floats) -> None:
    low, high = np.array([0.0, 50.0, -10.0]), np.array([20.0, 60.0, 20.0])
    inside = np.all((table[:, :3] >= low) & (table[:, :3] <= high), axis=1)
    with CopcReader.open(str(path)) as reader:
        assert reader.header.point_count == COUNT
        part = reader.query(bounds=Bounds(low, high))
        of_levels = [len(reader.query(level=level)) for level in range(5)]
        assert sum(of_levels) == COUNT
        whole = in_order(np.column_stack([part.x, part.y, part.z]))
        frames = np.sort(part.frame)
    np.testing.assert_allclose(whole, in_order(table[inside, :3]), rtol=0, atol=1.01e-4)
    np.testing.assert_array_equal(frames, np.sort(table[inside, 5]))
    assert sorted(of_levels) == of_levels


def test_the_first_level_is_an_even_choice(path: Path, table: Floats) -> None:
    with CopcReader.open(str(path)) as reader:
        coarse = reader.query(level=0)
    # of each stripe about as many
    counts = np.bincount(coarse.frame, minlength=COUNT // 100)
    assert counts.max() - counts.min() <= 2


def test_each_point_lies_within_its_node_and_each_node_has_its_parents(path: Path) -> None:
    with CopcReader.open(str(path)) as opened:
        info = opened.copc_info
    reader = copclib.FileReader(str(path))
    nodes = {(n.key.d, n.key.x, n.key.y, n.key.z): n for n in reader.GetAllNodes()}
    for (level, *place), node in nodes.items():
        points = reader.GetPoints(node)
        edge = 2 * info.halfsize / 2**level
        corner = np.array(info.center) - info.halfsize + edge * np.array(place)
        inside = np.column_stack([points.x, points.y, points.z]) - corner
        assert len(inside) == node.point_count > 0
        assert inside.min() > -1e-9
        assert inside.max() < edge + 1e-9
        assert level == 0 or (level - 1, *(one >> 1 for one in place)) in nodes
    assert sum(node.point_count for node in nodes.values()) == COUNT


def test_a_cloud_without_points_is_whole(tmp_path: Path) -> None:
    with cloud_writer(tmp_path / "empty.copc.laz"):
        pass
    with laspy.open(tmp_path / "empty.copc.laz") as reader:
        assert reader.header.point_count == 0
