"""The bench of many viewers, with a few of them for a few seconds."""

import pytest

from app.bench.station.viewers import run, table
from hardware.simulator.devices.fast_simulator import FastStationConfig

pytestmark = [pytest.mark.device, pytest.mark.soak]


def test_viewers_get_states_pictures_and_points_while_one_takes_nothing() -> None:
    found = run(FastStationConfig(profiles_hz=20.0, width_px=500, height_px=128), 3, 6.0)
    assert found.states > 20
    assert 0 < found.age_median_s <= found.age_95_s
    assert found.pictures_hz > 0
    assert found.view_mb_s > 0
    assert found.lost_alone == found.lost_watched == 0
    assert len(table(found)) == 5
