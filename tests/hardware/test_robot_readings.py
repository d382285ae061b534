"""What is taken from a controller's stream, counted and refused; frames that it does not name."""

import math

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from crenel_hardware.arm.robots.frame_watch import FrameWatch
from crenel_hardware.arm.robots.readings import RobotReading, StreamJudge, WrappingCounter
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import (
    ArmInfo,
    Button,
    ButtonEvent,
    JointSample,
    LinkHealth,
    PoseSample,
)

CYCLE_NS = 4_000_000
JOINTS = ArmInfo("Arm", "", 6, 250.0)
POSES = ArmInfo("Arm", "", 0, 250.0, reports="pose")
ANGLES = (0.1, 0.2, 0.3, 0.4, 0.5, 0.6)
JOINTS_RAD = (0.1, -0.5, 1.0, 0.0, 0.7, 0.2)
UPRIGHT = (0.0, 0.0, 0.0, 1.0)


def joints_at(cycle: int, counted: bool = True, offset_ns: int = 0) -> RobotReading:
    device_ns = cycle * CYCLE_NS + offset_ns
    return RobotReading(device_ns, cycle if counted else None, joints_rad=ANGLES)


class Listener:
    """A judge with a clock of its own: readings arrive one delay after they were taken."""

    def __init__(self, info: ArmInfo = JOINTS) -> None:
        self.health = LinkHealth()
        self.judge = StreamJudge("10.0.0.1", 0.0, info, self.health)
        self.records: list[object] = []

    def hear(self, *readings: RobotReading, arrival_cycle: float | None = None) -> None:
        cycle = readings[-1].device_ns / CYCLE_NS if arrival_cycle is None else arrival_cycle
        self.records += self.judge.accept(readings, int(cycle * CYCLE_NS) + 7_000_000_000)

    @property
    def samples(self) -> list[JointSample]:
        return [record for record in self.records if isinstance(record, JointSample)]


@pytest.mark.parametrize("counted", [True, False])
def test_gaps_are_lost_and_repeated_readings_are_corrupt(counted: bool) -> None:
    listener = Listener()
    for cycle in (1000, 1001, 1001, 1005, 1003, 1006):
        listener.hear(joints_at(cycle, counted), arrival_cycle=max(cycle, 1001))
    assert [sample.sequence for sample in listener.samples] == [0, 1, 5, 6]
    assert (listener.health.received, listener.health.lost, listener.health.corrupt) == (4, 3, 2)


def test_a_clock_that_shows_losses_may_vary_a_little() -> None:
    listener = Listener()
    for cycle in range(100):
        listener.hear(joints_at(cycle, False, offset_ns=(-1) ** cycle * 900_000))
    assert (len(listener.samples), listener.health.lost) == (100, 0)
    assert np.all(np.diff([sample.stamp_ns for sample in listener.samples]) > 0)


def test_a_reader_that_was_held_up_hears_a_burst() -> None:
    listener = Listener()
    listener.hear(joints_at(0))
    listener.hear(*(joints_at(cycle) for cycle in range(1, 5000)), arrival_cycle=5000)
    assert (len(listener.samples), listener.health.lost) == (5000, 0)


@pytest.mark.parametrize("counted", [True, False])
@pytest.mark.parametrize("cycle", [0, 900, 3000, 10_000_000])
def test_a_clock_that_jumps_is_an_error_and_nothing_is_taken(cycle: int, counted: bool) -> None:
    listener = Listener()
    listener.hear(joints_at(1000, counted))
    with pytest.raises(DeviceError, match="has jumped"):
        listener.hear(joints_at(1001, counted), joints_at(cycle, counted), arrival_cycle=1002)
    assert len(listener.samples) == 1


def test_a_count_that_jumps_alone_is_an_error() -> None:
    listener = Listener()
    listener.hear(joints_at(1000))
    with pytest.raises(DeviceError, match="has jumped"):
        listener.hear(RobotReading(1001 * CYCLE_NS, 5000, joints_rad=ANGLES))


def test_a_pause_of_the_controller_is_a_gap() -> None:
    listener = Listener()
    listener.hear(joints_at(1000))
    listener.hear(joints_at(3000))
    assert (len(listener.samples), listener.health.lost) == (2, 1999)


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf, 1e300])
def test_numbers_are_required(value: float) -> None:
    listener = Listener()
    with pytest.raises(DeviceError, match="no numbers"):
        listener.hear(joints_at(1), RobotReading(CYCLE_NS * 2, 2, joints_rad=(*ANGLES[:5], value)))
    assert listener.records == []


@pytest.mark.parametrize("length", [0.0, 0.9, 1.1])
def test_a_unit_quaternion_is_required(length: float) -> None:
    with pytest.raises(DeviceError, match="is no rotation"):
        Listener(POSES).hear(RobotReading(0, 0, quaternion_xyzw=(0.0, 0.0, 0.0, length)))


def test_a_rounded_quaternion_becomes_a_unit_quaternion() -> None:
    listener = Listener(POSES)
    listener.hear(RobotReading(0, 0, quaternion_xyzw=(0.5, 0.5, 0.5, 0.5001)))
    (pose,) = listener.records
    assert isinstance(pose, PoseSample)
    assert np.linalg.norm(pose.quaternion_xyzw) == pytest.approx(1.0, abs=1e-15)


def test_the_latency_comes_off_the_stamp() -> None:
    (early,) = StreamJudge("a", 1000.0, JOINTS, LinkHealth()).accept([joints_at(1)], 0)
    (late,) = StreamJudge("a", 0.0, JOINTS, LinkHealth()).accept([joints_at(1)], 0)
    assert late.stamp_ns - early.stamp_ns == 1_000_000


def test_edges_of_buttons_follow_their_sample() -> None:
    listener = Listener()
    both = frozenset({Button.PRIMARY, Button.UNDO})
    for cycle, pressed in enumerate((both, both, frozenset[Button](), both)):
        listener.hear(RobotReading(cycle * CYCLE_NS, cycle, joints_rad=ANGLES, pressed=pressed))
    assert [type(record) for record in listener.records] == [
        *(JointSample, JointSample, JointSample, ButtonEvent, ButtonEvent),
        *(JointSample, ButtonEvent, ButtonEvent),
    ]
    edges = [record for record in listener.records if isinstance(record, ButtonEvent)]
    assert [edge.pressed for edge in edges] == [False, False, True, True]
    assert {edge.sequence for edge in edges} == {2, 3}


@given(
    st.integers(2, 1 << 32), st.integers(0, 1 << 40), st.lists(st.floats(-0.49, 0.49), max_size=20)
)
@example(modulus=3, start=0, turns=[0.375])
def test_a_counter_goes_on_beyond_its_maximum(modulus: int, start: int, turns: list[float]) -> None:
    values = np.cumsum([start, *(int(turn * modulus) for turn in turns)]).tolist()
    counter = WrappingCounter(modulus)
    unwrapped = [counter.unwrap(value % modulus) for value in values]
    assert np.diff(unwrapped).tolist() == np.diff(values).tolist()
    assert unwrapped[0] == start % modulus


def note(watch: FrameWatch, at_ms: float, x_mm: float, turned_rad: float = 0.0) -> None:
    joints = (JOINTS_RAD[0] + turned_rad, *JOINTS_RAD[1:])
    watch.require_same_frames(round(1e6 * at_ms), joints, ((x_mm, 0.0, 500.0), UPRIGHT))


@pytest.mark.parametrize("cycle_ms", [4, 12])
def test_a_leap_at_rest_shows(cycle_ms: int) -> None:
    watch = FrameWatch("robot")
    for cycle in range(5):
        note(watch, cycle * cycle_ms, 100.0 + 0.01 * (cycle % 2))
    with pytest.raises(DeviceError, match=r"leapt by 2\.0 mm"):
        note(watch, 5 * cycle_ms, 102.0)


@pytest.mark.parametrize("cycle_ms", [4, 12])
def test_a_robot_that_moves_or_rides_on_a_track_does_not_leap(cycle_ms: int) -> None:
    for joint_share in (0.0, 1.0):
        watch = FrameWatch("robot")
        for cycle in range(200):
            passed_s = 1e-3 * cycle_ms * max(0, cycle - 5)
            x_mm = 1e3 * 0.5 * 5.0 * passed_s**2  # 5 m/s2
            note(watch, cycle * cycle_ms, x_mm, joint_share * x_mm / 1500)


def test_nothing_is_known_after_a_gap_or_without_joints() -> None:
    watch = FrameWatch("robot")
    for cycle in range(5):
        note(watch, 4 * cycle, 100.0)
    note(watch, 500, 300.0)
    watch = FrameWatch("robot")
    for cycle in range(5):
        watch.require_same_frames(4_000_000 * cycle, (), ((100.0 * (cycle > 3), 0, 0), UPRIGHT))
