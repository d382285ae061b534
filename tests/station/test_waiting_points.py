"""Points that wait for another thread: whoever makes them never waits, and they stay few."""

import numpy as np
import pytest

from crenel.formats.clouds.points import pack_points
from crenel.gauges.sphere.guide_scans import WaitingPoints
from crenel.station.scan.points import NewPoints


def new_points(*numbers: int) -> NewPoints:
    """Three points of each frame, its camera a metre over them."""
    frames = np.array(numbers)
    points = np.array([[float(number), 0.0, 0.0] for number in np.repeat(frames, 3)])
    records = pack_points(points, np.ones(len(points)), np.ones(len(points)), np.repeat(frames, 3))
    cameras = np.array([[float(number), 0.0, 1000.0] for number in numbers])
    return NewPoints(records, frames, cameras)


def test_what_came_is_taken_once_in_its_order() -> None:
    waiting = WaitingPoints()
    waiting.put(new_points(0, 1))
    waiting.put(new_points(2))
    taken = waiting.take()
    assert [new.records["frame"].tolist() for new in taken] == [[0, 0, 0, 1, 1, 1], [2, 2, 2]]
    assert not waiting.take()


def test_beyond_what_may_wait_points_are_left_out() -> None:
    waiting = WaitingPoints(most_points=6)
    for number in range(4):
        waiting.put(new_points(number))
    assert [new.frames.tolist() for new in waiting.take()] == [[0], [1]]
    waiting.put(new_points(4))
    assert [new.frames.tolist() for new in waiting.take()] == [[4]]


def test_each_point_is_seen_from_the_camera_of_its_frame() -> None:
    new = new_points(5, 9)
    assert new.points_mm[:, 0] == pytest.approx([5, 5, 5, 9, 9, 9])
    assert new.views == pytest.approx(np.tile([0.0, 0.0, 1.0], (6, 1)))
