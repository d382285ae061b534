"""What becomes of finished clouds: merged, compared, drawn, and read in parts."""

from pathlib import Path

import cv2
import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.formats.clouds.files import cloud_writer
from crenel.formats.clouds.pieces import StoredCloud, read_cloud_pieces
from crenel.formats.clouds.points import Points, pack_points
from crenel.workflows.clouds.cloud_picture import (
    HEIGHT_SHARE,
    LARGE_PX,
    SMALL_PX,
    cloud_photo,
    cloud_picture,
)
from crenel.workflows.clouds.compare_clouds import LocalPlanes, read_places
from crenel.workflows.clouds.merge_clouds import merge_clouds
from tests.present import present

COUNT = 40_000
FRAMES = 100


def write_cloud(
    folder: Path,
    seed: int,
    lift_mm: float = 0.0,
    shift_mm: float = 0.0,
    stripes_mm: float = 0.0,
    sigma_mm: float = 0.01,
) -> Path:
    """A gently waved plate of 80 × 60 mm, lifted and shifted, its points on stripes if wanted."""
    rng = np.random.default_rng(seed)
    x, y = rng.uniform(0, 80, COUNT), rng.uniform(0, 60, COUNT)
    if stripes_mm:
        x = np.rint(x / stripes_mm) * stripes_mm
    z = 2 * np.sin(x / 12) * np.cos(y / 15) + lift_mm + rng.normal(0, sigma_mm, COUNT)
    frames = np.sort(rng.integers(0, FRAMES, COUNT))
    folder.mkdir()
    with cloud_writer(folder / "cloud.ply") as writer:
        ones = np.ones(COUNT)
        places = np.column_stack([300 + x + shift_mm, y, z])
        writer.append(pack_points(places, 80 * ones, 4 * ones, frames))
    return folder / "cloud.ply"


def read_all(path: Path) -> Points:
    return np.concatenate([points for points, _ in read_cloud_pieces(path)])


@pytest.mark.parametrize("stripes_mm", [0.0, 0.5, 1.5])
@pytest.mark.parametrize(("lift_mm", "shift_mm"), [(0.0, 0.0), (0.05, 0.0), (-0.03, 40.0)])
def test_a_planted_deviation_is_found_with_its_sign(
    tmp_path: Path, lift_mm: float, shift_mm: float, stripes_mm: float
) -> None:
    """What the reference does not reach is left out and counted. A shift along the plate keeps its
    form where that is flat alone, so that the mean of a shifted cloud is not compared."""
    first = write_cloud(tmp_path / "a", 1, stripes_mm=stripes_mm)
    other = write_cloud(tmp_path / "b", 2, lift_mm, shift_mm, stripes_mm)
    planes = LocalPlanes(read_places(first, COUNT))
    found = planes.summarise(planes.distances(read_places(other, COUNT // 2)))
    assert found.share_beside == pytest.approx(shift_mm / 80, abs=0.04)
    assert found.p95_um >= found.rms_um
    if not shift_mm:
        assert found.mean_um == pytest.approx(1e3 * lift_mm, abs=3.0)
        assert found.rms_um == pytest.approx(np.hypot(1e3 * lift_mm, 11), abs=6.0)
        assert found.flatness_um < 25


def test_clouds_that_cannot_be_compared_are_refused(tmp_path: Path) -> None:
    places_mm = read_places(write_cloud(tmp_path / "a", 1), COUNT)
    planes = LocalPlanes(places_mm)
    with pytest.raises(OperationError, match="lie on the other scan"):
        planes.summarise(planes.distances(places_mm + 500))
    with pytest.raises(OperationError, match="are needed"):
        LocalPlanes(places_mm[:50])


def test_a_merged_cloud_has_all_points_and_frames_that_go_on(tmp_path: Path) -> None:
    first, other = (write_cloud(tmp_path / name, seed) for name, seed in (("a", 1), ("b", 2)))
    merged = tmp_path / "merged.ply"
    shares: list[float] = []
    parts = merge_clouds(
        [(first, FRAMES), (other, FRAMES)], merged, lambda share, _: shares.append(share)
    )
    assert [(one.points, one.first_frame) for one in parts] == [(COUNT, 0), (COUNT, FRAMES)]
    assert shares == sorted(shares)
    assert shares[-1] == 1.0
    before = [read_all(path) for path in (first, other)]
    before[1]["frame"] += FRAMES
    np.testing.assert_array_equal(read_all(merged), np.concatenate(before))
    # it grows in its own place
    merge_clouds([(merged, 2 * FRAMES), (first, FRAMES)], merged)
    assert StoredCloud(merged).count == 3 * COUNT


def test_a_cloud_is_read_in_parts(tmp_path: Path) -> None:
    cloud = StoredCloud(write_cloud(tmp_path / "a", 1))
    points = read_all(tmp_path / "a" / "cloud.ply")
    for frame in (0.0, 17.0, 17.5, FRAMES):
        assert cloud.find_frame(frame) == int(np.searchsorted(points["frame"], frame))
    sample = cloud.sample(5_000)
    assert 4_000 < len(sample) <= 5_000
    assert np.ptp(sample["x"]) > 75
    np.testing.assert_array_equal(cloud.sample(2 * COUNT), points)


@pytest.mark.parametrize("width_px", [SMALL_PX, LARGE_PX])
def test_a_picture_shows_the_cloud_and_nothing_else(tmp_path: Path, width_px: int) -> None:
    path = write_cloud(tmp_path / "a", 1)
    picture = present(
        cv2.imdecode(np.frombuffer(cloud_picture(path, width_px), np.uint8), cv2.IMREAD_UNCHANGED)
    )
    assert picture.shape == (HEIGHT_SHARE * width_px, width_px, 4)
    there = picture[..., 3] > 0
    assert 0.3 < there.mean() < 0.8
    assert not there[[0, -1]].any()
    assert not there[:, [0, -1]].any()
    # one surface without holes
    assert cv2.connectedComponents((~there).astype(np.uint8))[0] == 2
    assert len(np.unique(picture[there][:, :3], axis=0)) > 100
    jpeg, width_px, height_px = cloud_photo(path)
    assert present(cv2.imdecode(np.frombuffer(jpeg, np.uint8), cv2.IMREAD_COLOR)).shape == (
        height_px,
        width_px,
        3,
    )
