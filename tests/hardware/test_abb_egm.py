"""The ABB driver against packets that another team's definition of the messages encodes, and that
another team's client (``ABBRobotEGM``) reads as well."""

import math
import socket
from collections.abc import Callable, Iterator
from contextlib import closing
from operator import attrgetter
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from crenel_hardware.arm.robots.egm_message import decode_robot
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import ArmDriver, JointSample, PoseSample
from crenel_hardware.registry import arm_driver
from tests.bench.station.subprocess_station import free_port
from tests.hardware.conformance import ArmBench, ArmConformance
from tests.hardware.reading import PATIENT_S, SILENT_S, loss_of, opened, read_readings, read_samples
from tests.hardware.udp_robot import UdpBench, UdpRobot

egm_pb2 = pytest.importorskip("ABBRobotEGM._egm_protobuf.egm_pb2")

pytestmark = pytest.mark.device

JOINTS_DEG = (10.0, -20.0, 30.0, -40.0, 50.0, -60.0)
POSITION_MM = (500.0, -20.0, 350.0)
TURN = Rotation.from_euler("xyz", [10.0, 20.0, 30.0], degrees=True)
FIRST_SEQUENCE = (1 << 32) - 200
EPOCH_S = 1_760_000_000


def robot_message(cycle: int, has_clock: bool = True) -> Any:
    """A message of the stream; the sequence and the milliseconds wrap soon after the start."""
    robot = egm_pb2.EgmRobot()
    robot.header.seqno = (FIRST_SEQUENCE + cycle) % (1 << 32)
    robot.header.tm = (FIRST_SEQUENCE + 4 * cycle) % (1 << 32)
    robot.header.mtype = 2
    robot.feedBack.joints.joints.extend(JOINTS_DEG)
    pose, (x, y, z, w) = robot.feedBack.cartesian, TURN.as_quat()
    pose.pos.x, pose.pos.y, pose.pos.z = POSITION_MM
    pose.orient.u0, pose.orient.u1, pose.orient.u2, pose.orient.u3 = w, x, y, z
    pose.euler.x, pose.euler.y, pose.euler.z = 1.0, 2.0, 3.0
    if has_clock:
        robot.feedBack.time.sec = EPOCH_S + 4 * cycle // 1000
        robot.feedBack.time.usec = 4 * cycle % 1000 * 1000
    robot.motorState.state = 1
    robot.rapidExecState.state = 2
    return robot


def egm_packet(cycle: int, stamp_ns: int) -> bytes:
    return bytes(robot_message(cycle).SerializeToString())


@pytest.fixture
def robot() -> Iterator[UdpRobot]:
    with UdpRobot(free_port(socket.SOCK_DGRAM), 4, egm_packet) as robot:
        yield robot


def make_driver(robot: UdpRobot, **options: object) -> ArmDriver:
    return arm_driver(
        "abb-egm", {"address": "127.0.0.1", "port": robot.port, "timeout_s": PATIENT_S, **options}
    )


class TestAbbEgm(ArmConformance):
    @pytest.fixture(params=["flange", pytest.param("joints", marks=pytest.mark.soak)])
    def bench(self, request: pytest.FixtureRequest, robot: UdpRobot) -> ArmBench:
        return UdpBench(robot, lambda: make_driver(robot, report=request.param, timeout_s=5.0))


def test_a_client_of_others_reads_the_same(robot: UdpRobot) -> None:
    egm = pytest.importorskip("ABBRobotEGM")
    with egm.EGM(robot.port) as client:
        received, state = client.receive_from_robot(5.0)
    assert received
    with opened(make_driver(robot)) as driver:
        pose = read_readings(driver)[0]
    assert isinstance(pose, PoseSample)
    place, turn = state.cartesian.pos, state.cartesian.orient
    assert pose.position_mm == pytest.approx((place.x, place.y, place.z))
    assert pose.quaternion_xyzw == pytest.approx((turn.u1, turn.u2, turn.u3, turn.u0))
    with closing(make_driver(robot, report="joints")) as driver:
        assert driver.open().rate_hz == pytest.approx(250.0)
        sample = read_samples(driver)[0]
    assert sample.joints_rad == pytest.approx(np.radians(state.joint_angles))


def test_tool_and_base_are_taken_out(robot: UdpRobot) -> None:
    tool, base = [0.0, 0.0, 120.0, 0.8, 0.6, 0.0, 0.0], [100.0, 0.0, 0.0, 0.6, 0.0, 0.0, 0.8]
    with opened(make_driver(robot, tool=tool, base=base)) as driver:
        pose = read_readings(driver)[0]
    assert isinstance(pose, PoseSample)
    T_base_tool = frame([*POSITION_MM, *np.roll(TURN.as_quat(), 1)])
    T = frame(base) @ T_base_tool @ np.linalg.inv(frame(tool))
    assert pose.position_mm == pytest.approx(T[:3, 3])
    turned = Rotation.from_quat(pose.quaternion_xyzw) * Rotation.from_matrix(T[:3, :3]).inv()
    assert turned.magnitude() < 1e-9


def frame(values: list[float]) -> NDArray[np.float64]:
    T = np.eye(4)
    T[:3, 3] = values[:3]
    T[:3, :3] = Rotation.from_quat(np.roll(values[3:], -1)).as_matrix()
    return T


def test_the_header_counts_the_milliseconds_where_there_is_no_clock() -> None:
    def packet(cycle: int, stamp_ns: int) -> bytes:
        return bytes(robot_message(cycle, has_clock=False).SerializeToString())

    with (
        UdpRobot(free_port(socket.SOCK_DGRAM), 4, packet) as robot,
        opened(make_driver(robot)) as driver,
    ):
        readings = read_readings(driver, 101)
    steps_ms = np.diff([reading.stamp_ns for reading in readings]) / 1e6
    assert np.median(steps_ms) == pytest.approx(4.0, abs=0.5)
    assert np.all(np.diff([reading.sequence for reading in readings]) == 1)


def change_message(change: Callable[[Any], None]) -> Callable[[bytes], bytes]:
    def spoil(data: bytes) -> bytes:
        robot = egm_pb2.EgmRobot.FromString(data)
        change(robot)
        return bytes(robot.SerializeToString())

    return spoil


def change_field(path: str, change: Callable[[Any], Any]) -> Callable[[Any], None]:
    parent, _, name = path.rpartition(".")
    return lambda robot: setattr(attrgetter(parent)(robot), name, change(attrgetter(path)(robot)))


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (change_field("feedBack.cartesian.pos.x", lambda x: math.nan), "no numbers"),
        (
            change_field("feedBack.cartesian.pos.z", lambda z: z + 20.0),
            "another tool or base frame is active",
        ),
        (change_field("feedBack.cartesian.orient.u0", lambda u0: 1.5), "is no rotation"),
        (lambda robot: robot.feedBack.ClearField("cartesian"), "have no cartesian"),
        (lambda robot: robot.feedBack.ClearField("time"), "has jumped"),
        (change_field("feedBack.time.sec", lambda sec: sec + 3600), "has jumped"),
        (change_field("header.seqno", lambda seqno: 1_000_000_000), "has jumped"),
        (change_field("header.seqno", lambda seqno: FIRST_SEQUENCE), "has jumped"),
    ],
)
def test_what_cannot_be_true_is_an_error(
    robot: UdpRobot, change: Callable[[Any], None], words: str
) -> None:
    with opened(make_driver(robot)) as driver:
        read_readings(driver)
        robot.spoil = change_message(change)
        assert words in str(loss_of(driver).what)


def test_joints_of_another_count_are_an_error(robot: UdpRobot) -> None:
    with opened(make_driver(robot, report="joints")) as driver:
        robot.spoil = change_message(lambda message: message.feedBack.joints.joints.append(1.0))
        assert "announced 6 joints, but sends 7" in str(loss_of(driver).what)


def joints_deg(driver: ArmDriver) -> NDArray[np.float64]:
    reading = read_readings(driver)[-1]
    assert isinstance(reading, JointSample)
    return np.rad2deg(reading.joints_rad)


def test_the_axis_beside_six_is_the_third_of_seven_or_none_of_the_arm(robot: UdpRobot) -> None:
    def turn(message: Any) -> None:
        message.feedBack.externalJoints.joints.extend([77.0, 0.0])

    robot.spoil = change_message(turn)
    with opened(make_driver(robot, report="joints", external_axis="third")) as driver:
        found = joints_deg(driver)
    np.testing.assert_allclose(found, [*JOINTS_DEG[:2], 77.0, *JOINTS_DEG[2:]])
    with opened(make_driver(robot, report="joints", external_axis="other")) as driver:
        np.testing.assert_allclose(joints_deg(driver), JOINTS_DEG)
    with pytest.raises(DeviceError, match='Set external_axis to "third"'):
        make_driver(robot, report="joints").open()
    robot.spoil = lambda data: data
    with pytest.raises(DeviceError, match="have no externalJoints"):
        make_driver(robot, report="joints", external_axis="third").open()


def test_what_is_no_egm_counts_as_corrupt(robot: UdpRobot) -> None:
    with opened(make_driver(robot)) as driver:
        robot.spoil = lambda data: data[:40]
        assert "has sent only packets that cannot be read" in str(loss_of(driver).what)
        assert driver.health.corrupt > 3
    with pytest.raises(DeviceError, match="is no EGM"):
        make_driver(robot, timeout_s=SILENT_S).open()
    robot.silent = True
    with pytest.raises(DeviceError, match="sends nothing to UDP port"):
        make_driver(robot, timeout_s=0.3).open()
    assert decode_robot(b"") is None
    assert decode_robot(b"\x00") is None


def test_a_tool_that_is_no_pose_is_refused(robot: UdpRobot) -> None:
    with pytest.raises(DeviceError, match="must be a unit quaternion"):
        make_driver(robot, tool=[0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0])
    with pytest.raises(DeviceError, match="tool = "):
        make_driver(robot, tool=[0.0] * 6)
