"""Silence is measured by a clock that stands while the whole program stands."""

import os
import signal
import subprocess
import sys
import time

import pytest

pytestmark = pytest.mark.device

SCRIPT = """
import sys, time
from app.station.devices.awake_clock import AWAKE
begin_s, awake_s = time.monotonic(), AWAKE.now_s()
print("ready", flush=True)
sys.stdin.readline()
print(time.monotonic() - begin_s, AWAKE.now_s() - awake_s, flush=True)
"""


def seconds(stopped_s: float, awake_s: float) -> tuple[float, float]:
    """Wall-clock and awake seconds of a process that is stopped for some of them."""
    process = subprocess.Popen(
        [sys.executable, "-c", SCRIPT], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )
    assert process.stdout is not None
    assert process.stdin is not None
    with process:
        assert process.stdout.readline() == "ready\n"
        time.sleep(awake_s)
        if stopped_s:
            os.kill(process.pid, signal.SIGSTOP)
            time.sleep(stopped_s)
            os.kill(process.pid, signal.SIGCONT)
        process.stdin.write("\n")
        process.stdin.flush()
        wall_s, running_s = process.stdout.readline().split()
    return float(wall_s), float(running_s)


def test_it_stands_while_the_program_is_stopped() -> None:
    wall_s, awake_s = seconds(stopped_s=1.5, awake_s=0.5)
    assert wall_s >= 2.0
    assert awake_s <= wall_s - 1.0


def test_it_goes_on_while_the_program_runs() -> None:
    wall_s, awake_s = seconds(stopped_s=0.0, awake_s=1.0)
    assert 0.5 <= awake_s <= wall_s + 0.05
