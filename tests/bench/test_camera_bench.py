"""The bench of an industrial camera, for a few seconds."""

import shutil

import pytest

from app.bench.station.camera import PROGRAM, run, table
from tests.hardware.fake_cameras import port_for_this_test

pytestmark = [pytest.mark.device, pytest.mark.soak]


def test_what_is_lost_is_counted() -> None:
    if shutil.which(PROGRAM) is None:
        pytest.skip("aravis-tools is not installed")
    with port_for_this_test():
        found = run(3.0, 30.0, 5)
    assert 0 < found.whole < found.sent
    assert found.lost > 0
    assert found.unaccounted == 0
    assert 0 < found.age_median_s <= found.age_99_s
    assert dict(table(found))["neither received nor counted"] == "0"
