"""Devices that fail in every step of the flow come back, and nothing that was taken is lost."""

import pytest

from app.bench.faults.devices import FAILURES, run, table
from app.bench.faults.served import HALF

pytestmark = pytest.mark.slow

STEPS = ("devices", "setup", "touch", "capture", "review", "scan")


def test_failing_devices_are_reported_and_come_back_and_nothing_is_lost() -> None:
    found = run(config=HALF)
    assert [(row.step, row.failure) for row in found] == [
        (step, failure.name) for step in STEPS for failure in FAILURES
    ]
    assert all(row.intact for row in found), table(found)
    assert all(row.reported_s > 0 and row.back_s > 0 for row in found)
