"""Devices that fail in every step of the flow come back, and nothing that was taken is lost."""

from dataclasses import replace
from unittest.mock import patch

import pytest

from crenel.guide.calibration.automatic import simulated_operator
from tests.bench.faults.devices import FAILURES, run, table
from tests.bench.faults.served import HALF

pytestmark = [pytest.mark.device, pytest.mark.soak]

STEPS = ("devices", "setup", "touch", "capture", "review", "scan")


def test_failing_devices_are_reported_and_come_back_and_nothing_is_lost() -> None:
    # the calibration is only taken to its end
    with patch.object(simulated_operator, "POSES", 2):
        found = run(config=replace(HALF, width_px=320, height_px=256, frames_hz=5.0))
    assert [(row.step, row.failure) for row in found] == [
        (step, failure.name) for step in STEPS for failure in FAILURES
    ]
    assert all(row.intact and row.untrue == 0 for row in found), table(found)
    assert all(row.reported_s > 0 and row.back_s > 0 for row in found)
