"""The KUKA driver against a sender written from KUKA's manual, and against another team's emulator.

The emulator (``RSIPI``) sends one packet in two of its cycles, which no controller does, so that
the conformance suite runs on the sender.
"""

import socket
import subprocess
import sys
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import closing
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import ArmDriver, PoseSample
from crenel_hardware.registry import arm_driver
from tests.bench.station.subprocess_station import free_port
from tests.hardware.conformance import ArmBench, ArmConformance
from tests.hardware.reading import (
    PATIENT_S,
    SILENT_S,
    loss_of,
    opened,
    read_readings,
    read_samples,
    wait_until,
)
from tests.hardware.udp_robot import UdpBench, UdpRobot

pytestmark = pytest.mark.device

STARTED_MODULES = ()  # an emulator of others
TOOL_MM_DEG = (10.0, 20.0, 120.0, 30.0, -20.0, 10.0)
BASE_MM_DEG = (1000.0, 0.0, -200.0, 90.0, 0.0, 0.0)
FIRST_IPOC = 4_208_163_634


def rsi_packet(cycle: int, stamp_ns: int, cycle_ms: int = 4) -> bytes:
    """A document of the controller: the flange goes along x, the joints turn."""
    pose = (500.0 + 0.01 * cycle, -20.0, 350.0, 10.0, 20.0, 30.0)
    axes = "".join(f' A{joint}="{joint + 0.001 * cycle:.4f}"' for joint in range(1, 7))
    places = "".join(f' {key}="{value:.4f}"' for key, value in zip("XYZABC", pose, strict=True))
    return (
        f'<Rob Type="KUKA"><RIst{places} /><AIPos{axes} /><Delay D="0" />'
        f"<IPOC>{FIRST_IPOC + cycle_ms * cycle}</IPOC></Rob>"
    ).encode()


@pytest.fixture
def robot() -> Iterator[UdpRobot]:
    with UdpRobot(free_port(socket.SOCK_DGRAM), 4, rsi_packet) as robot:
        yield robot


def make_driver(robot: UdpRobot, **options: object) -> ArmDriver:
    return arm_driver(
        "kuka-rsi", {"address": "127.0.0.1", "port": robot.port, "timeout_s": PATIENT_S, **options}
    )


class TestKukaRsi(ArmConformance):
    @pytest.fixture(params=["flange", pytest.param("joints", marks=pytest.mark.soak)])
    def bench(self, request: pytest.FixtureRequest, robot: UdpRobot) -> ArmBench:
        return UdpBench(robot, lambda: make_driver(robot, report=request.param, timeout_s=5.0))


def test_joints_and_cycle_are_as_sent(robot: UdpRobot) -> None:
    with closing(make_driver(robot, report="joints")) as driver:
        info = driver.open()
        samples = read_samples(driver, 21)
    assert (info.rate_hz, info.joint_count) == (250.0, 6)
    steps = np.diff([sample.joints_rad[0] for sample in samples])
    assert steps == pytest.approx(np.radians(0.001), abs=1e-5)
    assert samples[0].joints_rad[5] - samples[0].joints_rad[0] == pytest.approx(np.radians(5))


def test_a_cycle_of_12_ms_is_found() -> None:
    packet = partial(rsi_packet, cycle_ms=12)
    with (
        UdpRobot(free_port(socket.SOCK_DGRAM), 12, packet) as robot,
        closing(make_driver(robot)) as driver,
    ):
        assert driver.open().rate_hz == pytest.approx(1000 / 12)


def frame(values: tuple[float, ...]) -> NDArray[np.float64]:
    T = np.eye(4)
    T[:3, 3] = values[:3]
    T[:3, :3] = Rotation.from_euler("ZYX", values[3:], degrees=True).as_matrix()
    return T


def test_tool_and_base_are_taken_out(robot: UdpRobot) -> None:
    with opened(make_driver(robot, tool=list(TOOL_MM_DEG), base=list(BASE_MM_DEG))) as driver:
        pose = read_readings(driver)[0]
    assert isinstance(pose, PoseSample)
    T = frame(BASE_MM_DEG) @ frame((500.0, -20.0, 350.0, 10.0, 20.0, 30.0))
    T = T @ np.linalg.inv(frame(TOOL_MM_DEG))
    # the robot has gone some way along the x axis of its base, which is the arm's y axis
    assert pose.position_mm[0] == pytest.approx(T[0, 3])
    assert pose.position_mm[1] > T[1, 3]
    assert pose.position_mm[2] == pytest.approx(T[2, 3])
    turned = Rotation.from_quat(pose.quaternion_xyzw) * Rotation.from_matrix(T[:3, :3]).inv()
    assert turned.magnitude() < 1e-9


def test_packets_from_elsewhere_are_ignored(robot: UdpRobot) -> None:
    with (
        UdpRobot(robot.port, 4, lambda cycle, stamp_ns: b"<Rob/>", source="127.0.0.9"),
        opened(make_driver(robot)) as driver,
    ):
        read_readings(driver, 51)
        assert driver.health.corrupt == 0


@pytest.mark.parametrize(
    "packet",
    [
        b"",
        b"<Rob>",
        b'<!DOCTYPE Rob [<!ENTITY a "a">]><Rob><IPOC>4</IPOC></Rob>',
        b"<Rob></Rob>",
        b"<Rob><IPOC>now</IPOC></Rob>",
        b"\xff\xfe\x00",
    ],
)
def test_what_is_no_rsi_counts_as_corrupt(robot: UdpRobot, packet: bytes) -> None:
    with opened(make_driver(robot)) as driver:
        robot.spoil = lambda data: packet
        while driver.health.corrupt < 3:
            driver.read(0.1)
        robot.spoil = lambda data: data
        read_readings(driver, 4)


def test_comments_and_names_in_latin_1_are_read(robot: UdpRobot) -> None:
    named = '<!-- Prüfzelle --><Zelle Name="Süd"/></Rob>'.encode("latin-1")
    robot.spoil = lambda data: data.replace(b"</Rob>", named)
    with opened(make_driver(robot)) as driver:
        read_readings(driver, 8)
        assert driver.health.corrupt == 0


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda data: data.replace(b"RIst", b"RSol"), "have no RIst"),
        (lambda data: data.replace(b' A="10.0000"', b""), "have no RIst"),
        (lambda data: data.replace(b"350.0000", b"nan"), "no numbers"),
        (lambda data: data.replace(b"350.0000", b"1e300"), "impossibly large"),
        (lambda data: data.replace(b"350.0000", b"up"), "no numbers"),
        (lambda data: data.replace(b"350.0000", b"1,350.0000"), "no numbers"),
        (lambda data: data.replace(b"350.0000", b"370.0000"), "leapt by 20.0 mm and 0.0°"),
        (lambda data: data.replace(b'"30.0000"', b'"35.0000"'), "leapt by 0.0 mm and 5.0°"),
        (lambda data: data.replace(b"<IPOC>4", b"<IPOC>3"), "has jumped"),
        (lambda data: data.replace(b"<IPOC>4", b"<IPOC>5"), "has jumped"),
    ],
)
def test_what_cannot_be_true_is_an_error(
    robot: UdpRobot, change: Callable[[bytes], bytes], words: str
) -> None:
    with opened(make_driver(robot)) as driver:
        read_readings(driver)
        robot.spoil = change
        assert words in str(loss_of(driver).what)


def test_decimal_commas_are_read(robot: UdpRobot) -> None:
    with opened(make_driver(robot)) as driver:
        robot.spoil = lambda data: data.replace(b"350.0000", b"350,2500")
        read_readings(driver)
        reading = read_readings(driver)[-1]
        assert isinstance(reading, PoseSample)
        assert reading.position_mm[2] == 350.25


def test_what_is_wrong_at_opening_is_said(robot: UdpRobot) -> None:
    robot.spoil = lambda data: b"hello"
    with pytest.raises(DeviceError, match="is no RSI"):
        make_driver(robot, timeout_s=SILENT_S).open()
    robot.spoil = lambda data: data
    with pytest.raises(DeviceError, match=r"comes from 127\.0\.0\.1, not from"):
        make_driver(robot, timeout_s=SILENT_S, address="127.0.0.7").open()
    robot.silent = True
    with pytest.raises(DeviceError, match=f"sends nothing to UDP port {robot.port}"):
        make_driver(robot, timeout_s=0.3).open()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        other.bind(("", robot.port))
        with pytest.raises(DeviceError, match="Another program"):
            make_driver(robot).open()
    with pytest.raises(DeviceError, match="tool = "):
        make_driver(robot, tool=[1.0, 2.0])


EMULATOR = """
import socket, sys, time
class AnyPort(socket.socket):
    def bind(self, address):  # EchoServer binds port 50000, which somebody else may have
        super().bind((address[0], 0))
socket.socket = AnyPort
from RSIPI.rsi_echo_server import EchoServer
server = EchoServer(sys.argv[1], onlysend=True)
server.state["AIPos"] = {f"A{joint}": 10.0 * joint for joint in range(1, 7)}
server.state["RIst"] = dict(X=500.0, Y=-20.0, Z=350.0, A=10.0, B=20.0, C=30.0)
server.start()
print("started", flush=True)
time.sleep(60)
"""
CONFIG = """<ROOT><CONFIG><IP_NUMBER>127.0.0.1</IP_NUMBER><PORT>{port}</PORT>
<SENTYPE>ImFree</SENTYPE><ONLYSEND>TRUE</ONLYSEND></CONFIG><SEND><ELEMENTS>
<ELEMENT TAG="DEF_RIst" TYPE="DOUBLE" INDX="INTERNAL"/>
<ELEMENT TAG="DEF_AIPos" TYPE="DOUBLE" INDX="INTERNAL"/>
</ELEMENTS></SEND><RECEIVE><ELEMENTS/></RECEIVE></ROOT>"""


@pytest.mark.parametrize("report", ["flange", "joints"])
def test_an_emulator_of_others_is_read(tmp_path: Path, report: str) -> None:
    pytest.importorskip("RSIPI", exc_type=ImportError)
    port = free_port(socket.SOCK_DGRAM)
    config = tmp_path / "RSI_EthernetConfig.xml"
    config.write_text(CONFIG.format(port=port))
    options = {"address": "127.0.0.1", "port": port, "report": report, "timeout_s": 60.0}
    driver = arm_driver("kuka-rsi", options)
    with ThreadPoolExecutor(1) as elsewhere:
        opening = elsewhere.submit(driver.open)
        # the emulator gives up soon where nobody listens
        bound = Path("/proc/net/udp")
        wait_until(lambda: f":{port:04X} " in bound.read_text(), "the driver does not listen")
        command = [sys.executable, "-c", EMULATOR, str(config)]
        emulator = subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.DEVNULL)
        try:
            opening.result()
            reading = read_readings(driver)[0]
            driver.close()
        finally:
            emulator.kill()
            emulator.wait()
    if isinstance(reading, PoseSample):
        assert reading.position_mm == pytest.approx((500.0, -20.0, 350.0))
        expected = Rotation.from_euler("ZYX", [10.0, 20.0, 30.0], degrees=True)
        assert (Rotation.from_quat(reading.quaternion_xyzw) * expected.inv()).magnitude() < 1e-9
    else:
        assert reading.joints_rad == pytest.approx(np.radians([10, 20, 30, 40, 50, 60]))
