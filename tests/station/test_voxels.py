"""Which points are shown, and which stay when fewer are to be shown."""

import numpy as np
import pytest

from crenel.metrology.transforms import Floats
from crenel.station.view3d.voxel_lod import SIZES, Voxels

pytestmark = pytest.mark.usefixtures("variant")


def first_of_each(points: Floats, size: float) -> np.ndarray:
    """(N,) whether a point is the first of its cube."""
    first = np.unique(np.floor(points / size), axis=0, return_index=True)[1]
    found = np.zeros(len(points), dtype=bool)
    found[first] = True
    return found


def surface(count: int, seed: int = 3) -> Floats:
    random = np.random.default_rng(seed)
    x, y = random.uniform(-40, 40, (2, count))
    return np.column_stack([x, y, 5 * np.sin(x / 9) + random.normal(0, 0.2, count)])


def test_the_first_point_of_each_cube_is_shown() -> None:
    voxels = Voxels(1.0)
    points = np.array([[0.1, 0.1, 0.1], [0.9, 0.9, 0.9], [-0.1, 0.5, 0.5], [np.nan, 0, 0]])
    assert (voxels.take(points) >= 0).tolist() == [True, False, True, False]
    assert (voxels.take(points) >= 0).tolist() == [False] * 4
    assert voxels.count == 2


@pytest.mark.slow
def test_what_is_left_is_as_if_the_cubes_had_always_been_so_large() -> None:
    """Also of points that come after the cubes have grown, and while the table grows."""
    voxels = Voxels(0.5)
    points = surface(200_000)
    tiers = [voxels.take(part) for part in np.split(points[:120_000], 3)]
    for size in (0.5, 1.0, 2.0):
        assert voxels.size_mm == size
        shown = np.concatenate(tiers) >= voxels.finest
        assert shown.sum() == voxels.count
        np.testing.assert_array_equal(shown, first_of_each(points[:120_000], size))
        voxels.coarsen()
        voxels.coarsen()
    tiers.append(voxels.take(points[120_000:]))
    shown = np.concatenate(tiers) >= voxels.finest
    assert shown.sum() == voxels.count
    np.testing.assert_array_equal(shown, first_of_each(points, voxels.size_mm))


def test_half_a_step_takes_every_other_cube_of_the_finest_away() -> None:
    voxels = Voxels(0.5)
    points = surface(150_000)
    tiers = voxels.take(points)
    finest = voxels.count
    assert voxels.coarsen()
    half = voxels.count
    assert voxels.coarsen()
    assert 0.55 * finest < half < 0.75 * finest
    assert 0.5 * half < voxels.count + (tiers == 1).sum() / 2 < half
    odd = points[tiers == 0]
    assert (np.floor(odd / 0.5).sum(axis=1) % 2 == 1).all()


def test_there_is_an_end_to_growing_and_something_is_left() -> None:
    voxels = Voxels(0.1)
    voxels.take(surface(1000))
    steps = 0
    while voxels.coarsen():
        steps += 1
    assert steps == 2 * SIZES - 1
    assert voxels.size_mm == pytest.approx(0.1 * 2 ** (SIZES - 0.5))


def test_what_is_forgotten_frees_its_space() -> None:
    """The table does not grow with the scan, only with what is shown."""
    voxels = Voxels(0.1)
    for seed in range(30):
        voxels.take(surface(20_000, seed))
        while voxels.count > 10_000:
            voxels.coarsen()
    assert len(voxels._slots) <= 1 << 18
