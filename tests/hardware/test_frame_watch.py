"""Another tool or base frame, of a controller that does not name them."""

import pytest

from hardware.arm.robots.frame_watch import FrameWatch
from hardware.errors import DeviceError

JOINTS_RAD = (0.1, -0.5, 1.0, 0.0, 0.7, 0.2)
UPRIGHT = (0.0, 0.0, 0.0, 1.0)


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
