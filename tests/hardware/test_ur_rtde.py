"""The RTDE driver against the simulated robot, and the simulated robot against a client of others.

``ur_rtde`` (the package ``ur-rtde``) reads the simulated robot as well, so that driver and robot do
not merely agree with each other. It always uses port 30004, hence an address of its own.
"""

import json
import socket
import struct
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import ExitStack, closing, suppress

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from crenel_hardware.arm.universal_robots.packages import PackageError, PackageReader, decode_recipe
from crenel_hardware.arm.universal_robots.ur_rtde import from_options
from crenel_hardware.clock import now_ns
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import ArmDriver, ArmRecord, JointSample, PoseSample
from crenel_hardware.registry import arm_driver
from crenel_hardware.simulator.devices import rtde_server
from crenel_hardware.simulator.devices.rtde_server import RobotState, RtdeServer
from tests.hardware.conformance import ArmBench, ArmConformance, FaultyArmBench
from tests.hardware.reading import (
    PATIENT_S,
    loss_of,
    opened,
    read_readings,
    read_samples,
    read_until_lost,
)

pytestmark = pytest.mark.device

STARTED_MODULES = ()  # a client of others
TOOL = (0.02, -0.03, 0.15, 0.4, -0.2, 1.1)
START_NS = now_ns()


def swing(at_ns: int) -> RobotState:
    """A robot whose first joint turns by 0.1 rad a second; its flange goes round."""
    angle = 0.1 * (at_ns - START_NS) / 1e9
    T = np.eye(4)
    T[:3, :3] = Rotation.from_euler("zx", [angle, 0.5]).as_matrix()
    T[:3, 3] = 400 * np.cos(angle), 400 * np.sin(angle), 250.0
    return RobotState(np.array([angle, -0.5, 1.0, -1.5, 2.0, -2.5]), T)


def make_driver(server: RtdeServer, **options: object) -> ArmDriver:
    return arm_driver(
        "ur-rtde", {"address": "127.0.0.1", "port": server.port, "timeout_s": PATIENT_S, **options}
    )


class RtdeBench(FaultyArmBench):
    def __init__(self, server: RtdeServer, report: str) -> None:
        self.server, self.faults, self.report = server, server.faults, report

    def driver(self) -> ArmDriver:
        return make_driver(self.server, report=self.report)

    def contacts(self) -> int:
        return self.server.contacts


@pytest.fixture
def server(monkeypatch: pytest.MonkeyPatch) -> Iterator[RtdeServer]:
    """A controller that makes every package, however late a busy machine lets it."""
    monkeypatch.setattr(rtde_server, "MAKING_NS", rtde_server.CATCH_UP_NS)
    server = RtdeServer(swing, tool_offset=TOOL)
    server.start()
    yield server
    server.stop()


class TestUrRtde(ArmConformance):
    @pytest.fixture(params=["flange", pytest.param("joints", marks=pytest.mark.soak)])
    def bench(self, request: pytest.FixtureRequest, server: RtdeServer) -> ArmBench:
        return RtdeBench(server, request.param)


@pytest.fixture
def driver(server: RtdeServer) -> Iterator[ArmDriver]:
    with opened(make_driver(server)) as driver:
        yield driver


def test_poses_are_of_the_flange_at_their_stamps(server: RtdeServer, driver: ArmDriver) -> None:
    info = driver.open()
    assert (info.reports, info.pose_of, info.rate_hz) == ("pose", "flange", 500.0)
    readings = read_readings(driver, 101)
    for pose in readings:
        assert isinstance(pose, PoseSample)
        T = swing(taken_ns(np.arctan2(*pose.position_mm[1::-1]), pose.stamp_ns)).T_base_flange
        assert pose.position_mm == pytest.approx(T[:3, 3], abs=1e-3)
        turned = Rotation.from_quat(pose.quaternion_xyzw) * Rotation.from_matrix(T[:3, :3]).inv()
        assert turned.magnitude() < 1e-6


def taken_ns(first_joint_rad: float, stamp_ns: int) -> int:
    """When the robot was so; a busy machine may stamp it late, but not early."""
    since_s = (stamp_ns - START_NS) / 1e9
    late_s = float(np.angle(np.exp(1j * (0.1 * since_s - first_joint_rad)))) / 0.1
    assert -0.01 < late_s < 1.0
    return stamp_ns - round(1e9 * late_s)


def test_joints_are_those_of_the_robot(server: RtdeServer) -> None:
    with closing(make_driver(server, report="joints", rate_hz=125)) as driver:
        info = driver.open()
        samples = read_samples(driver, 51)
    assert (info.joint_count, info.rate_hz) == (6, 125.0)
    for sample in samples:
        true = swing(taken_ns(sample.joints_rad[0], sample.stamp_ns))
        assert sample.joints_rad == pytest.approx(true.joints_rad, abs=1e-6)


def test_its_serial_number_is_that_of_the_options(server: RtdeServer) -> None:
    with closing(make_driver(server, serial_number="2019-0042")) as driver:
        assert driver.open().serial_number == "2019-0042"
    with closing(make_driver(server)) as driver:
        assert not driver.open().serial_number


def test_what_is_not_asked_for_needs_not_be_there(server: RtdeServer) -> None:
    server.faults.unknown = frozenset({"tcp_offset"})
    with opened(make_driver(server, report="joints")) as driver:
        assert isinstance(read_readings(driver)[0], JointSample)
    with pytest.raises(DeviceError, match="does not offer tcp_offset"):
        make_driver(server).open()


def test_text_messages_in_between_are_passed_on(server: RtdeServer, driver: ArmDriver) -> None:
    server.say("Low on coffee")
    readings = read_readings(driver, 201)
    assert np.all(np.diff([reading.sequence for reading in readings]) == 1)
    server.faults.robot_mode = 3
    error = loss_of(driver)
    assert "without power" in str(error)
    assert "Low on coffee (RTDE)" in str(error)


def test_a_controller_that_is_too_slow_sends_the_newest(
    driver: ArmDriver, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(rtde_server, "MAKING_NS", 1)
    readings = read_readings(driver, 20)
    assert np.all(np.diff([reading.sequence for reading in readings]) >= 1)


def test_a_changed_tool_is_an_error_and_opening_takes_the_new_one(
    server: RtdeServer, driver: ArmDriver
) -> None:
    read_readings(driver)
    server.tool_offset = (0.0, 0.0, 0.2, 0.0, 0.0, 0.0)
    assert "active tool (TCP)" in str(loss_of(driver).what)
    driver.open()
    pose = read_readings(driver)[0]
    assert isinstance(pose, PoseSample)
    assert pose.position_mm[2] == pytest.approx(250.0)


@pytest.mark.parametrize(
    ("offset", "value", "words"),
    [
        (16, np.nan, "no numbers"),
        (16, np.inf, "no numbers"),
        (40, np.nan, "no numbers"),
        (4, np.nan, "no numbers"),
        (40, 1e300, "impossibly large"),
        (4, 1e7, "clock of the arm"),
        (4, 1.0, "clock of the arm"),
    ],
)
def test_what_cannot_be_true_is_an_error(
    server: RtdeServer, driver: ArmDriver, offset: int, value: float, words: str
) -> None:
    read_readings(driver)
    written = struct.pack(">d", value)
    server.faults.spoil = lambda package: package[:offset] + written + package[offset + 8 :]
    seen: list[ArmRecord] = []
    error = read_until_lost(lambda: seen.extend(driver.read(0.1)))
    assert words in str(error)
    poses = [each for each in seen if isinstance(each, PoseSample)]
    assert all(np.isfinite(pose.position_mm).all() for pose in poses)
    assert np.all(np.diff([pose.stamp_ns for pose in poses]) > 0)


def test_a_damaged_stream_is_an_error(server: RtdeServer, driver: ArmDriver) -> None:
    for damage in (b"\x00\x01\x55", b"\x00\x04\x55\x01", b"\x00\x04\x55\x07"):
        driver.open()
        server.faults.spoil = lambda package, damage=damage: damage  # type: ignore[misc]
        assert "is no RTDE" in str(loss_of(driver))
        server.faults.spoil = lambda package: package


def test_packages_arrive_in_any_pieces(server: RtdeServer) -> None:
    """A proxy passes the stream on byte by byte at first, then in odd pieces."""
    proxy = socket.create_server(("127.0.0.1", 0))

    def relay() -> None:
        near, _ = proxy.accept()
        far = socket.create_connection(("127.0.0.1", server.port))
        threading.Thread(target=pump, args=(near, far, 1), daemon=True).start()
        pump(far, near, 7)

    threading.Thread(target=relay, daemon=True).start()
    options = {"address": "127.0.0.1", "port": proxy.getsockname()[1], "rate_hz": 125}
    with proxy, opened(from_options(options)) as driver:
        readings = read_readings(driver, 51)
    assert np.all(np.diff([reading.sequence for reading in readings]) == 1)


def pump(source: socket.socket, target: socket.socket, piece: int) -> None:
    with source, target, suppress(OSError):  # either end may close
        target.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        while data := source.recv(4096):
            for at in range(0, len(data), piece):
                target.sendall(data[at : at + piece])


def test_what_the_controller_refuses_is_said(server: RtdeServer) -> None:
    address: dict[str, object] = {
        "address": "127.0.0.1",
        "port": server.port,
        "timeout_s": PATIENT_S,
    }
    server.faults.refuses_protocol = True
    assert "version 2 of RTDE" in open_error(address)
    server.faults.refuses_protocol, server.faults.refuses_start = False, True
    assert "refuses to send data" in open_error(address)
    server.faults.refuses_start, server.faults.silent = False, True
    assert "has sent nothing new for 1 s" in open_error({**address, "timeout_s": 1.0})
    server.faults.silent, server.version = False, (3, 15, 8, 0)
    said = open_error({**address, "rate_hz": 500})
    assert "at most 125 Hz, but station.toml states 500 Hz" in said
    with closing(from_options(address)) as driver:
        assert driver.open().rate_hz == 125.0


def test_what_is_no_controller_is_said() -> None:
    with socket.create_server(("127.0.0.1", 0)) as other:
        port = other.getsockname()[1]
        address: dict[str, object] = {"address": "127.0.0.1", "port": port, "timeout_s": 0.5}
        assert "does not answer as RTDE does" in open_error(address)
        with ExitStack() as connections:
            chatter = threading.Thread(target=chat, args=(other, connections), daemon=True)
            chatter.start()
            assert "is no RTDE" in open_error({**address, "timeout_s": PATIENT_S})
            chatter.join()
    assert "No program listens at" in open_error(address)
    assert "no host with the name" in open_error({**address, "address": "no-such-host.invalid"})


def chat(server: socket.socket, connections: ExitStack) -> None:
    """Greets the client that has left and the next one, as another kind of server does."""
    for _ in range(2):
        connection, _ = server.accept()
        connection.sendall(bytes(64))
        connections.enter_context(connection)


def open_error(options: dict[str, object]) -> str:
    with pytest.raises(DeviceError) as caught:
        from_options(options).open()
    return str(caught.value)


def test_a_recipe_that_does_not_fit_is_refused() -> None:
    assert decode_recipe(b"\x01DOUBLE,NOT_FOUND", ["a", "b"]).missing == ["b"]
    for answer in (b"", b"\x01DOUBLE", b"\x01DOUBLE,VECTOR9"):
        with pytest.raises(PackageError):
            decode_recipe(answer, ["a", "b"])
    with pytest.raises(PackageError):
        PackageReader().feed(b"\x00\x02\x55")


READ_BY_OTHERS = """
import json, sys, time
from rtde_receive import RTDEReceiveInterface
client = RTDEReceiveInterface(sys.argv[1], 125.0, ["timestamp", "actual_q", "actual_TCP_pose"])
stamps = set()
deadline = time.monotonic() + 100.0
while len(stamps) < 50 and time.monotonic() < deadline:
    stamps.add(client.getTimestamp())
    time.sleep(0.001)
print(json.dumps([sorted(stamps), client.getActualQ(), client.getActualTCPPose()]))
client.disconnect()
"""
"""A process of its own: the client holds the interpreter while it connects."""


def test_a_client_of_others_reads_the_simulated_robot() -> None:
    pytest.importorskip("rtde_receive")
    still = swing(START_NS + 3_000_000_000)
    server = RtdeServer(lambda at_ns: still, "127.0.30.4", 30004, TOOL)
    server.start()
    try:
        done = subprocess.run(
            [sys.executable, "-c", READ_BY_OTHERS, "127.0.30.4"],
            capture_output=True,
            text=True,
            timeout=240,
            check=True,
        )
        expected = server.values_at(now_ns())
    finally:
        server.stop()
    stamps, joints, pose = json.loads(done.stdout.splitlines()[-1])
    assert len(stamps) == 50
    assert joints == pytest.approx(expected["actual_q"])
    assert pose == pytest.approx(expected["actual_TCP_pose"])
