"""The driver for ROS 2 against a node of ROS 2 in a process of its own.

It needs ``rclpy``, from an installation of ROS 2 or the wheels ``ros-kilted-rclpy[fastrtps]``,
``ros-kilted-sensor-msgs`` and ``ros-kilted-geometry-msgs``, in an environment of its own. The tests
of transforms also need ``tf2_msgs``, of which there is no wheel.
"""

import os
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from crenel_hardware.arm.robots.readings import RobotReading
from crenel_hardware.arm.robots.ros2 import Ros2Options, TopicStream
from crenel_hardware.arm.robots.transform_chain import TransformChain
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import ArmDriver, PoseSample
from crenel_hardware.registry import arm_driver
from tests.hardware.conformance import ArmBench, ArmConformance
from tests.hardware.reading import loss_of, read_readings, read_until, select_readings

pytestmark = [
    pytest.mark.device,
    pytest.mark.filterwarnings("ignore:module 'sre_:DeprecationWarning"),  # of rclpy's parser
]

PUBLISHER = Path(__file__).parent / "ros2_publisher.py"
NAMES = ["joint_a", "joint_b", "joint_c", "joint_d", "joint_e", "joint_f"]
OPTIONS: dict[str, dict[str, object]] = {
    "joints": {"topic": "/bench/joints", "kind": "joints", "joint_names": NAMES},
    "pose": {"topic": "/bench/pose", "kind": "pose"},
    "tf": {"kind": "tf", "parent_frame": "base", "child_frame": "tool"},
}


def test_without_ros_the_remedy_is_its_setup_file(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "rclpy", None)
    with pytest.raises(DeviceError) as caught:
        arm_driver("ros2", OPTIONS["pose"]).open()
    assert "ROS 2 is not installed here" in str(caught.value.what)
    assert "setup.bash" in str(caught.value.remedy)


def test_joints_need_names() -> None:
    with pytest.raises(DeviceError, match="'joint_names' is missing"):
        arm_driver("ros2", {"topic": "/joint_states", "kind": "joints"})
    with pytest.raises(DeviceError, match="kind = 'twist' cannot be used"):
        arm_driver("ros2", {"topic": "/twist", "kind": "twist"})


def test_transforms_need_two_frames() -> None:
    with pytest.raises(DeviceError, match="'child_frame' is missing"):
        arm_driver("ros2", {"kind": "tf", "parent_frame": "base"})
    with pytest.raises(DeviceError, match="are both base"):
        arm_driver("ros2", {"kind": "tf", "parent_frame": "/base", "child_frame": "base"})
    with pytest.raises(DeviceError, match="'topic' is missing"):
        arm_driver("ros2", {"kind": "pose"})


def transform(parent: str, child: str, stamp_ms: int, x_m: float, qz: float = 0.0) -> Any:
    """A ``geometry_msgs/TransformStamped``, as the driver reads it."""
    stamp = SimpleNamespace(sec=1, nanosec=1_000_000 * stamp_ms)
    placed = SimpleNamespace(
        translation=SimpleNamespace(x=x_m, y=0.0, z=0.0),
        rotation=SimpleNamespace(x=0.0, y=0.0, z=qz, w=(1 - qz * qz) ** 0.5),
    )
    header = SimpleNamespace(frame_id=parent, stamp=stamp)
    return SimpleNamespace(header=header, child_frame_id=child, transform=placed)


def test_messages_of_transforms_become_poses() -> None:
    """The middleware is left out: there is no wheel of the messages' type."""
    options = Ros2Options.model_validate({**OPTIONS["tf"], "timeout_s": 1.0})
    chain = TransformChain("/tf", "base", "tool")
    stream = TopicStream("/tf", options, chain)

    def receive(*transforms: Any, is_static: bool = False) -> list[RobotReading]:
        held = SimpleNamespace(transforms=transforms)
        return stream._chain_readings(chain, 0, held, is_static)

    assert receive(transform("/flange", "/tool", 0, 0.1), is_static=True) == []
    (reading,) = receive(transform("base", "flange", 5, 0.5, qz=0.6))
    assert reading.device_ns == 1_005_000_000
    # 100 mm along the turned x axis: cos = 1 - 2 * 0.36, sin = 2 * 0.6 * 0.8
    assert reading.position_mm == pytest.approx((500 + 28, 96, 0))
    assert reading.quaternion_xyzw == pytest.approx((0, 0, 0.6, 0.8))
    with pytest.raises(DeviceError, match="no numbers"):
        receive(transform("base", "flange", 6, float("nan")))
    long = transform("base", "flange", 7, 0.5)
    long.transform.rotation.w = 1.1
    with pytest.raises(DeviceError, match=r"1\.1"):
        receive(long)


class Ros2Bench(ArmBench):
    counts_losses = False

    def __init__(self, kind: str) -> None:
        self.kind = kind
        self._process: subprocess.Popen[str] | None = None
        self.plug_in()

    def driver(self) -> ArmDriver:
        return arm_driver("ros2", OPTIONS[self.kind])

    def contacts(self) -> None:
        return None

    def plug_in(self) -> None:
        command = [sys.executable, str(PUBLISHER)]
        self._process = subprocess.Popen(command, stdin=subprocess.PIPE, text=True)

    def unplug(self) -> None:
        if self._process is not None:
            self._process.kill()
            self._process.communicate()
            self._process = None

    def command(self, word: str) -> None:
        assert self._process is not None
        assert self._process.stdin is not None
        self._process.stdin.write(f"{word}\n")
        self._process.stdin.flush()

    def silence(self, silent: bool) -> None:
        self.command("silent" if silent else "loud")


@pytest.fixture(params=["joints", "pose", "tf"])
def bench(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Iterator[Ros2Bench]:
    pytest.importorskip("rclpy")
    if request.param == "tf":
        pytest.importorskip("tf2_msgs")
    monkeypatch.setenv("ROS_DOMAIN_ID", str(100 + os.getpid() % 100))
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")
    bench = Ros2Bench(request.param)
    yield bench
    bench.unplug()


class TestRos2(ArmConformance):
    pass


def test_readings_are_as_published(bench: Ros2Bench) -> None:
    driver = bench.driver()
    info = driver.open()
    assert info.rate_hz == pytest.approx(250, rel=0.2)
    reading = read_readings(driver)[0]
    if isinstance(reading, PoseSample):
        assert reading.position_mm == pytest.approx((500.0, -250.0, 125.0))
        assert reading.quaternion_xyzw == pytest.approx((0.6, 0.0, 0.0, 0.8))
    else:
        assert reading.joints_rad == pytest.approx((0.1, 0.0, 0.2, 0.4, 0.3, 0.5))
    driver.close()


@pytest.mark.parametrize("word", ["nan", "unstamped", "moved", "short", "earlier"])
def test_what_cannot_be_used_is_an_error(bench: Ros2Bench, word: str) -> None:
    if bench.kind == "tf":
        pytest.skip("transforms are tested without the middleware")
    of_one_kind = {"moved": "pose", "short": "joints"}
    if of_one_kind.get(word, bench.kind) != bench.kind:
        pytest.skip("the other kind of message")
    driver = bench.driver()
    driver.open()
    bench.command(word)
    error = loss_of(driver)
    assert {
        "nan": "no numbers",
        "unstamped": "no time stamps",
        "moved": "in the frame elsewhere instead of base",
        "short": "no joint joint_b",
        "earlier": "has jumped",
    }[word] in str(error.what)


def test_stamps_of_arrival_need_no_time_in_the_message(bench: Ros2Bench) -> None:
    driver = arm_driver("ros2", {**OPTIONS[bench.kind], "stamps": "arrival"})
    assert driver.open().stamps == "arrival"
    bench.command("unstamped")
    before = time.monotonic_ns()
    read_until(
        driver, lambda got: any(r.stamp_ns > before + 200_000_000 for r in select_readings(got))
    )
    driver.close()


def test_a_wrong_topic_lists_those_that_are_there(bench: Ros2Bench) -> None:
    wrong = {**OPTIONS[bench.kind], "topic": "/bench/nothing", "timeout_s": 5.0}
    with pytest.raises(DeviceError) as caught:
        arm_driver("ros2", wrong).open()
    assert "Nothing is published on /bench/nothing" in str(caught.value.what)
    assert str(OPTIONS[bench.kind].get("topic", "/tf")) in str(caught.value.remedy)
    with pytest.raises(DeviceError, match="refuses the subscription"):
        arm_driver("ros2", {**wrong, "topic": "no topic!"}).open()
