"""Silence is measured by a clock that stands while the whole program stands."""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator

import pytest

from tests.station.conftest import until

pytestmark = pytest.mark.device

SCRIPT = """
import sys, time
from app.station.devices.awake_clock import AWAKE
begin_s, awake_s = time.monotonic(), AWAKE.now_s()
for line in sys.stdin:
    print(time.monotonic() - begin_s, AWAKE.now_s() - awake_s, flush=True)
"""


def seconds(process: subprocess.Popen[str]) -> tuple[float, float]:
    """Wall-clock and awake seconds of a process."""
    assert process.stdin is not None
    assert process.stdout is not None
    process.stdin.write("\n")
    process.stdin.flush()
    wall_s, awake_s = process.stdout.readline().split()
    return float(wall_s), float(awake_s)


@pytest.fixture
def process() -> Iterator[subprocess.Popen[str]]:
    command = [sys.executable, "-c", SCRIPT]
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as running:
        seconds(running)
        yield running


def test_it_stands_while_the_program_is_stopped(process: subprocess.Popen[str]) -> None:
    os.kill(process.pid, signal.SIGSTOP)
    time.sleep(1.5)
    os.kill(process.pid, signal.SIGCONT)
    wall_s, awake_s = seconds(process)
    assert wall_s >= 1.5
    assert awake_s <= wall_s - 1.0


def test_it_goes_on_while_the_program_runs(process: subprocess.Popen[str]) -> None:
    until(lambda: seconds(process)[1] >= 0.5)
    wall_s, awake_s = seconds(process)
    assert awake_s <= wall_s + 0.05
