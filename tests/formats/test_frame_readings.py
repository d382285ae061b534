"""Readings of the arm beside a cloud."""

from pathlib import Path

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.formats.clouds.frame_readings import READINGS, read_frame_readings, readings_writer


def write(path: Path) -> np.ndarray:
    readings = np.random.default_rng(1).normal(size=(9, 7))
    readings[4, 2] = np.nan
    with readings_writer(path, 7) as file:
        file.append(np.array([12, 13, 17]), 1, readings[:3, :3], readings[:3])
        file.append(0, 0, readings[3:, :3], readings[3:])
    return readings


def test_readings_are_read_as_they_were_written(tmp_path: Path) -> None:
    readings = write(tmp_path / READINGS)
    found = read_frame_readings(tmp_path / READINGS)
    assert found.frame.tolist() == [0, 2, 3, 4, 5, 12, 13, 17]
    assert found.sensor.tolist() == [0, 0, 0, 0, 0, 1, 1, 1]
    np.testing.assert_array_equal(found.readings, readings[[3, 5, 6, 7, 8, 0, 1, 2]])
    rows = found.rows_of(np.array([17, 0, 1, 18, 5]))
    assert rows.tolist() == [7, 0, -1, -1, 4]


@pytest.mark.parametrize("cut", [-1, -300, 40])
def test_a_file_that_is_cut_off_is_refused(tmp_path: Path, cut: int) -> None:
    path = tmp_path / READINGS
    write(path)
    path.write_bytes(path.read_bytes()[:cut])
    with pytest.raises(OperationError):
        read_frame_readings(path)


def test_an_ordinary_cloud_is_refused(tmp_path: Path) -> None:
    from crenel.formats.clouds.files import cloud_writer

    with cloud_writer(tmp_path / "cloud.ply") as cloud:
        cloud.write(np.zeros((3, 3)), np.ones(3), np.ones(3), 0)
    with pytest.raises(OperationError, match="not as Crenel wrote it"):
        read_frame_readings(tmp_path / "cloud.ply")
