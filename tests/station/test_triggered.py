"""A camera that the simulated arm triggers, through the real driver, under jitter and losses."""

import threading
import time
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from crenel.station.bus import Bus
from crenel.station.devices.rig import Rig
from crenel.station.devices.sensor_device import StationSensor
from crenel.station.pulses.pulse_trigger import TriggerSettings
from crenel_hardware.arm.serial_encoder import SerialEncoderArm
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import (
    ArmDriver,
    ArmRecord,
    Frame,
    JointSample,
    SensorDriver,
    SensorReading,
)
from crenel_hardware.registry import arm_driver
from crenel_hardware.simulator.rendering.triggered_sensor import TriggeredSensor
from crenel_hardware.simulator.station import SimulatedStation, SimulationConfig
from tests.station.conftest import collect_readings, running, until, until_paired

pytestmark = pytest.mark.device

RATE_HZ = 20.0
CONFIG = SimulationConfig(
    triggered=True, jitter_ms=20.0, width_px=320, height_px=256, rate_hz=200.0
)


def noting_arm(url: str, pulses: dict[int, int]) -> ArmDriver:
    """An arm whose pulses are noted: their numbers by the stamp of the reading."""
    driver = arm_driver("serial-encoder", {"url": url})
    read = driver.read

    def read_and_note(timeout_s: float) -> Sequence[ArmRecord]:
        records = read(timeout_s)
        for one in records:
            if isinstance(one, JointSample) and one.pulse is not None:
                pulses[one.stamp_ns] = one.pulse
        return records

    driver.read = read_and_note  # type: ignore[method-assign]
    return driver


class Noted:
    """What arm and camera truly did, whatever the clocks of a busy machine say of it."""

    def __init__(self, simulation: SimulatedStation) -> None:
        self._simulation = simulation
        self.pulses: dict[int, int] = {}
        self.exposed_ns: dict[int, int] = {}
        """When exposures began, by the camera's count."""

    def by_train(self) -> Iterator[tuple[int, int, int]]:
        """The train, the stamp and the number of each pulse."""
        train, before = 0, 0
        for at_ns, pulse in self.pulses.items():
            train += pulse <= before
            before = pulse
            yield train, at_ns, pulse

    def arm(self) -> ArmDriver:
        return noting_arm(self._simulation.arm_url, self.pulses)

    def camera(self) -> SensorDriver:
        sensor = self._simulation.sensor()
        assert isinstance(sensor, TriggeredSensor)
        trigger = sensor.trigger

        def trigger_and_note(at_ns: int) -> None:
            trigger(at_ns)
            self.exposed_ns[sensor._count] = at_ns

        sensor.trigger = trigger_and_note  # type: ignore[method-assign]
        return sensor


@pytest.fixture
def noted(simulation: SimulatedStation) -> Noted:
    return Noted(simulation)


@pytest.fixture
def rig(simulation: SimulatedStation, noted: Noted, tmp_path: Path) -> Iterator[Rig]:
    with running(Rig(Bus(), noted.arm, noted.camera, tmp_path, TriggerSettings(RATE_HZ))) as rig:
        yield rig
        simulation.clear_faults()


def collect(rig: Rig, count: int) -> list[Frame]:
    return [one for one in collect_readings(rig, count) if isinstance(one, Frame)]


def test_arm_and_frames_are_paired(simulation: SimulatedStation, noted: Noted, rig: Rig) -> None:
    """While the arm moves, with 1 % of the frames and of the arm's samples lost."""
    simulation.camera_faults.drop_rate = simulation.arm_faults.drop_rate = 0.01
    until_paired(rig.sensor)
    mover = threading.Thread(target=simulation.operator.hold_over, args=("board", 1))
    mover.start()
    frames = collect(rig, 60)
    simulation.operator.cancel()
    mover.join()
    assert rig.sensor.is_paired
    # the counts of arm and camera go together, without one exception; a busy machine hands frames
    # over so late that the pulses are started once more, which counts them from 1 again
    begins = {one.mid_exposure_ns - half_ns(one): one.sequence for one in frames}
    known = [(train, begins[at] - of) for train, at, of in noted.by_train() if at in begins]
    assert len(known) > 40, "few pulses were lost"
    assert len(set(known)) == len({train for train, _ in known})
    # and each frame is given the joints that the arm truly had
    frames = [one for one in frames if rig.arm.at(one.mid_exposure_ns) is not None]
    read = np.array([rig.arm.at(one.mid_exposure_ns) for one in frames])
    assert np.ptp(read, axis=0).max() > 0.1
    true = simulation.joints(
        np.array([noted.exposed_ns[one.sequence] + half_ns(one) for one in frames])
    )
    # of a lost sample, those beside it tell; with a wrong pulse it would be 0.04 rad off
    assert np.abs(read - true).max() < 1e-2


def half_ns(reading: SensorReading) -> int:
    return round(500 * reading.exposure_us)


@pytest.mark.parametrize("is_refused", [True, False])
def test_pulses_whose_start_is_lost_are_started_again(
    simulation: SimulatedStation, noted: Noted, tmp_path: Path, is_refused: bool
) -> None:
    """The arm does not answer the request, or answers it and sends no pulse."""
    arm = noted.arm()
    assert isinstance(arm, SerialEncoderArm)
    start, starts = arm.start_pulses, list[float]()

    def lose_the_first(rate_hz: float) -> None:
        starts.append(rate_hz)
        if len(starts) > 1:
            start(rate_hz)
        elif is_refused:
            raise DeviceError("the arm does not answer")

    arm.start_pulses = lose_the_first  # type: ignore[method-assign]
    rig = Rig(Bus(), lambda: arm, noted.camera, tmp_path, TriggerSettings(RATE_HZ))
    with running(rig):
        until_paired(rig.sensor)
        assert len(starts) >= 2
        arm.stop_pulses()
        known = len(starts)
        until(lambda: len(starts) > known)
        until_paired(rig.sensor)


def test_a_camera_that_comes_back_is_paired_again(simulation: SimulatedStation, rig: Rig) -> None:
    until_paired(rig.sensor)
    simulation.camera_faults.lost = True
    until(lambda: rig.sensor.reader.link().state.value == "lost")
    simulation.camera_faults.lost = False
    until(lambda: rig.sensor.reader.link().state.value == "connected")
    until_paired(rig.sensor)
    assert len(collect(rig, 5)) >= 5


def test_each_of_two_cameras_is_paired_by_its_own_count(tmp_path: Path) -> None:
    """One pulse starts both exposures; one camera's losses and jitter do not concern the other."""
    delay_us = 500.0
    trigger = TriggerSettings(RATE_HZ, delays_us={"right": delay_us})
    with SimulatedStation(replace(CONFIG, second_sensor=True)) as simulation:
        arm = partial(arm_driver, "serial-encoder", {"url": simulation.arm_url})
        sensors = {"left": simulation.sensor, "right": simulation.second_sensor}
        with running(Rig(Bus(), arm, sensors, tmp_path, trigger)) as rig:
            left, right = rig.sensors.values()
            simulation.camera_faults.drop_rate = 0.1
            until_paired(left, right)
            check_common_pulses(left, right, delay_us)
            # a camera that comes back gets a new start of the pulses, which both are paired by
            simulation.second_camera_faults.lost = True
            until(lambda: right.reader.link().state.value == "lost")
            assert left.is_paired
            simulation.second_camera_faults.lost = False
            until(lambda: right.fresh)
            until_paired(left, right)
            check_common_pulses(left, right, delay_us)


def check_common_pulses(left: StationSensor, right: StationSensor, delay_us: float) -> None:
    """Exposures of one pulse differ by the stated delay alone, although cameras count apart."""
    taps = {sensor: sensor.frames.tap(200) for sensor in (left, right)}
    stamps: dict[StationSensor, list[int]] = {left: [], right: []}

    def have_enough() -> bool:
        for sensor, tap in taps.items():
            stamps[sensor] += [frame.mid_exposure_ns for frame in tap.get(100, 0.1)]
        return min(len(found) for found in stamps.values()) >= 20

    until(have_enough)
    for sensor, tap in taps.items():
        sensor.frames.untap(tap)
    apart_ns = np.subtract.outer(np.array(stamps[right]), np.array(stamps[left]))
    off_ns = np.abs(apart_ns - 1e3 * delay_us).min(axis=1)
    # the partners of some frames were lost, or came before or after the others
    off_ns = off_ns[off_ns < 0.5e9 / RATE_HZ]
    assert len(off_ns) >= 10
    assert off_ns.max() < 1e3


def test_a_camera_without_pulses_is_there_though_silent(tmp_path: Path) -> None:
    with SimulatedStation(CONFIG) as simulation:
        arm = partial(arm_driver, "serial-encoder", {"url": simulation.arm_url})
        with running(Rig(Bus(), arm, simulation.sensor, tmp_path)) as rig:
            until(lambda: rig.sensor.info is not None)
            time.sleep(2.0)
            assert rig.sensor.link().state == "connected"
            assert rig.sensor.frames.latest is None
