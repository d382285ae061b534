"""The benches of a station, its viewers and its cameras, at paces that any machine keeps."""

import shutil

import pytest

from app.bench.station import camera, live, view, viewers
from hardware.simulator.devices.fast_simulator import FastStationConfig
from tests.hardware.fake_cameras import port_for_this_test

pytestmark = [pytest.mark.device, pytest.mark.soak]
PACE = FastStationConfig(profiles_hz=20.0, width_px=500, height_px=128)


def test_a_scan_is_recorded_whole_and_seen_by_its_viewers() -> None:
    found = live.run(PACE, 4.0)
    assert found.frames_lost == found.frames_without_joints == 0
    assert found.frames_recorded > 40
    # a stripe that ends at the picture's border may lack its last columns
    assert found.points >= 0.95 * PACE.width_px * found.frames_recorded
    assert 0 < found.age_median_s <= found.age_95_s < 20
    assert found.join_s > 0
    assert found.recording_mb_s > 0
    assert len(live.table(found)) == 8


def test_viewers_get_states_pictures_and_points_while_one_takes_nothing() -> None:
    found = viewers.run(PACE, 3, 6.0)
    assert found.states > 20
    assert 0 < found.age_median_s <= found.age_95_s
    assert found.pictures_hz > 0
    assert found.view_mb_s > 0
    assert found.lost_alone == found.lost_watched == 0
    assert len(viewers.table(found)) == 5


def test_a_second_viewer_gets_all_and_the_colours_change() -> None:
    points = 8 * view.PIECE
    found = view.run(points)
    assert found.points == points
    assert 50_000 < found.points_displayed <= points
    assert found.join_s > 0
    assert found.join_mb > 15 * found.points_displayed / 2**20
    assert 0 < found.recolour_s < 60
    assert len(view.table(found)) == 5


def test_what_a_camera_loses_is_counted() -> None:
    if shutil.which(camera.PROGRAM) is None:
        pytest.skip("aravis-tools is not installed")
    with port_for_this_test():
        found = camera.run(3.0, 30.0, 5)
    assert 0 < found.whole < found.sent
    assert found.lost > 0
    assert found.unaccounted == 0
    assert 0 < found.age_median_s <= found.age_99_s
    assert dict(camera.table(found))["neither received nor counted"] == "0"
