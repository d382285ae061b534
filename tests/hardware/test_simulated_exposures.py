"""When the simulated GigE camera exposes, without a network."""

import sys
import threading
from collections.abc import Iterator

import pytest

from crenel_hardware.simulator.devices.gige_camera.exposing import ExposureLoop, LaserLine
from crenel_hardware.simulator.devices.gige_camera.registers import CameraIdentity, RegisterMap

STARTS = 3_000


@pytest.fixture(autouse=True)
def often() -> Iterator[None]:
    """Threads take turns far more often than usual, so that each meets the other everywhere."""
    usual_s = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    yield
    sys.setswitchinterval(usual_s)


def test_registers_that_start_and_stop_it_never_wait_for_each_other() -> None:
    registers = RegisterMap(CameraIdentity("127.0.0.1", "G-1", 64, 48, rate_hz=1_000.0))
    taken = threading.Event()
    exposures = ExposureLoop(
        registers,
        LaserLine(registers, "Line1"),
        lambda exposure: taken.set(),
        finished=lambda: None,
    )
    exposures.start_thread()

    def control() -> None:
        for _ in range(STARTS):
            with registers.lock:  # as while the camera answers a client
                exposures.start()
            with registers.lock:
                exposures.stop()

    client = threading.Thread(target=control, daemon=True)
    client.start()
    client.join(240.0)
    assert not client.is_alive()
    taken.clear()
    exposures.start()
    assert taken.wait(240.0)
    exposures.end_thread()
