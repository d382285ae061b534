"""The board on the simulated table, calibrated by its datasheet and held against the truth."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from crenel.guide.calibration.poses.board_views import VIEWS
from crenel.metrology.adjustment.planning.next_pose import pose_delta
from crenel.metrology.sensor.camera import project
from crenel.metrology.transforms import Floats, inverse
from crenel_hardware.simulator.scene.world import (
    Board,
    BoardMarkers,
    SceneObject,
    SimulatedScene,
    shape_rows,
)
from crenel_hardware.simulator.station import SimulationConfig
from tests.metrology.rendered_boards import RenderedBoards, errors_um
from tests.running.usual import usual

pytestmark = pytest.mark.slow


@pytest.fixture(
    scope="module",
    params=usual([None, BoardMarkers()], {1}, pytest.mark.soak),
    ids=["plain", "charuco"],
)
def session(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> RenderedBoards:
    config = SimulationConfig(seed=1, board=Board(markers=request.param))
    session = RenderedBoards(tmp_path_factory.mktemp("simulation"), config)
    assert (session.board.markers is None) == (request.param is None)
    return session


def corner_errors(session: RenderedBoards) -> Iterator[Floats]:
    """(N, 2) of each picture, from where the truth has the corners, all of which are seen."""
    board = session.simulation._board
    for shot, seen in zip(session.shots, session.detections, strict=True):
        found = seen.detection
        assert len(found) == board.inner_corners[0] * board.inner_corners[1]
        row, column = np.divmod(found.number, board.inner_corners[0])
        at = np.column_stack([column * board.square_x_mm, row * board.square_y_mm, 0 * row])
        yield found.uv_px - project(session.camera(shot.T_board_sensor), at)


def test_corners_are_seen_where_they_are(session: RenderedBoards) -> None:
    every = np.concatenate(list(corner_errors(session)))
    assert np.sqrt(np.mean(every**2)) < 0.02
    assert np.abs(every.mean(axis=0)).max() < 0.004


def test_points_are_as_good_as_said(session: RenderedBoards) -> None:
    found = session.calibration
    assert all(pose.used and not pose.reason for pose in found.poses)
    corners = [corner[1:] for pose in found.poses for corner in pose.corners_px]
    assert np.sqrt(np.mean(np.square(corners))) < 0.15
    rms_um = np.sqrt(np.mean(errors_um(session) ** 2))
    assert rms_um < 3 * found.uncertainty.total_um
    assert found.uncertainty.total_um < 60


def test_the_simulated_operator_holds_the_sensor_as_the_views_say(session: RenderedBoards) -> None:
    T_cam_sensor = session.simulation._rig.optics.T_cam_sensor
    holds = [shot.T_board_sensor @ inverse(T_cam_sensor) for shot in session.shots]
    for view, hold in zip(VIEWS, holds[: len(VIEWS)], strict=True):
        done = pose_delta(hold, holds[0], session.board)
        assert abs(done.tilt_right_deg - view.tilt_right_deg) < 8
        assert abs(done.tilt_back_deg - view.tilt_back_deg) < 8
        assert abs(done.turn_deg - view.turn_deg) < 8


def test_a_simulated_board_of_even_rows_is_opencvs_too(tmp_path: Path) -> None:
    marked = Board((6, 5), markers=BoardMarkers("DICT_5X5_100", 0.8))
    session = RenderedBoards(tmp_path, SimulationConfig(seed=2, board=marked), count=3)
    for off in corner_errors(session):
        assert off.shape == (30, 2)
        assert np.abs(off).max() < 0.15


def test_too_many_markers_for_the_simulated_board_are_refused() -> None:
    board = SceneObject("board", Board((11, 9), markers=BoardMarkers()), np.eye(4))
    with pytest.raises(ValueError, match="no room for"):
        shape_rows(SimulatedScene((board,)))
