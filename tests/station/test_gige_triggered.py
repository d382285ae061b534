"""A camera that the arm triggers, and that changes between pictures and lines: over GigE Vision."""

import threading
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from app.station.bus import Bus
from app.station.devices.rig import Rig
from app.station.pulses.pulse_trigger import TriggerSettings
from hardware.interfaces import Frame, Line, SensorDriver, SensorReading
from hardware.simulator.station import SimulatedStation
from tests.hardware.fake_cameras import ADDRESS
from tests.hardware.test_genicam import require_aravis
from tests.station.conftest import collect_readings, running, until
from tests.station.simulated import USUAL
from tests.station.test_lines import BOTH
from tests.station.test_triggered import half_ns, noting_arm

pytestmark = [pytest.mark.device, pytest.mark.xdist_group("gige")]

RATE_HZ = 20.0


def test_pulses_and_lines_are_paired_exactly_after_each_change(
    bus: Bus, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The camera misses pulses while it is stopped for the change, and does not count them."""
    require_aravis()
    pulses: dict[int, int] = {}
    camera_times_ns: dict[int, int] = {}
    """By the camera's own clock, which is good to a few ms: by sequence."""

    def make_sensor() -> SensorDriver:
        driver = simulation.sensor()
        read = driver.read

        def read_and_note(timeout_s: float) -> SensorReading | None:
            reading = read(timeout_s)
            if reading is not None:
                camera_times_ns[reading.sequence] = reading.mid_exposure_ns
            return reading

        monkeypatch.setattr(driver, "read", read_and_note)
        return driver

    config = replace(
        USUAL, delivers=BOTH, camera="gige", camera_address=ADDRESS, triggered=True, rate_hz=200.0
    )
    with SimulatedStation(config) as simulation:
        arm = partial(noting_arm, simulation.arm_url, pulses)
        rig = Rig(bus, arm, make_sensor, tmp_path, TriggerSettings(RATE_HZ))
        with running(rig):
            until(lambda: rig.sensor.is_paired)
            for lines, kind in ((True, Line), (False, Frame)):
                rig.sensor.want_lines(lines)
                until(lambda kind=kind: isinstance(rig.sensor.frames.newest, kind))  # type: ignore[misc]
                mover = threading.Thread(target=simulation.operator.hold_over, args=("board", 1))
                mover.start()
                readings = collect_readings(rig, 40)
                simulation.operator.cancel()
                mover.join()
                assert all(isinstance(one, kind) for one in readings)
                stamps = np.array([one.mid_exposure_ns for one in readings])
                begins = {one.mid_exposure_ns - half_ns(one): one.pulse or 0 for one in readings}
                offsets = [begins[at] - number for at, number in pulses.items() if at in begins]
                assert len(offsets) == len(readings)
                assert len(set(offsets)) == 1, "the counts of arm and camera go together"
                late_ns = stamps - np.array([camera_times_ns[one.sequence] for one in readings])
                assert abs(np.median(late_ns)) < 0.5e9 / RATE_HZ, "and by the right offset"
