"""The bench of the live station, for a few seconds at a pace that any machine keeps."""

import pytest

from app.bench.station.live import run, table
from hardware.simulator.devices.fast_simulator import FastStationConfig

pytestmark = [pytest.mark.device, pytest.mark.soak]


def test_a_scan_is_recorded_whole_and_seen_by_its_viewers() -> None:
    pace = FastStationConfig(profiles_hz=20.0, width_px=500, height_px=128)
    found = run(pace, 4.0)
    assert found.frames_lost == found.frames_without_joints == 0
    assert found.frames_recorded > 40
    # a stripe that ends at the picture's border may lack its last columns
    assert found.points >= 0.95 * pace.width_px * found.frames_recorded
    assert 0 < found.age_median_s <= found.age_95_s < 20
    assert found.join_s > 0
    assert found.recording_mb_s > 0
    assert len(table(found)) == 8
