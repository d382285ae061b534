"""The ``fanuc`` driver: a FANUC robot, read by the status packets of Stream Motion.

Stream Motion (option J519 or S636 of the controller) sends its status from a start packet on,
whether the robot is commanded or not; this driver sends no command. In station.toml::

    [arm]
    driver = "fanuc"
    address = "192.168.1.40"
    report = "flange"           # the faceplate; or "joints"
    port = 60015
    serial_number = "2019-0042" # optional: of this robot, which does not state it
    latency_us = 0              # optional: least time from measuring to arrival here
    timeout_s = 3.0             # how long ``open`` waits for the controller

Source:
    The packet layouts in FANUC's driver for ROS 2 (``stream_motion/packets.hpp``, Apache-2.0);
    all numbers are big-endian.
"""

import struct
import time
from collections.abc import Mapping, Sequence
from math import radians

from crenel.messages.message import Text, message
from crenel.rotations import CONVENTIONS, quaternion_of
from crenel_hardware.arm.robots.link import ControllerLink
from crenel_hardware.arm.robots.readings import RobotReading, WrappingCounter, require_finite
from crenel_hardware.arm.robots.streaming_arm import RobotOptions, StreamingArm
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import ArmInfo, LinkHealth
from crenel_hardware.options import read_options
from crenel_hardware.shared_options import Port, Report

_PORT = 60015
_OLDEST_VERSION = 3
_STOP, _CAPABILITY, _START = 2, 7, 200
_CAPABILITY_ANSWERS = (7, 8)
_STATUS_SIZES = {202: 388, 204: 416}
_AXES = 6
_ASK_EVERY_S = 0.3

_REQUEST = struct.Struct(">II")
_CAPABILITIES = struct.Struct(">7I")
_STATUS = struct.Struct(">III4xI9f9f")
"""Type, version, sequence, four bytes of state, time stamp in ms; the faceplate's x, y, z in mm and
w, p, r in degrees, padded to nine; the joints in degrees, padded to nine."""


class FanucOptions(RobotOptions):
    """Options of the driver in station.toml."""

    title = message("driver-fanuc")
    port: Port = _PORT
    report: Report = "flange"


def from_options(options: Mapping[str, object]) -> StreamingArm:
    """The driver for an ``[arm]`` table of station.toml; raises ``DeviceError``."""
    checked = read_options(FanucOptions, options, "arm")
    return StreamingArm(checked, checked.address, lambda: StreamMotion(checked))


class StreamMotion:
    """One stream of status packets. Implements ``ControllerStream``."""

    silence_remedy: Text = message("check-robot-network")

    def __init__(self, options: FanucOptions) -> None:
        self._options = options
        self._link = ControllerLink(options.address)
        self._health = LinkHealth()
        self._version = 0
        self._sequence, self._time_ms = WrappingCounter(1 << 32), WrappingCounter(1 << 32)

    def start(self, timeout_s: float, health: LinkHealth) -> ArmInfo:
        """Learns the controller's version and cycle, and starts the stream."""
        self._health = health
        deadline = time.monotonic() + timeout_s
        self._link.connect_udp(self._options.port)
        _, _, _, cycle_ms, _, self._version, tool_pose = self._capabilities(deadline)
        if self._version < _OLDEST_VERSION or not cycle_ms:
            raise DeviceError(
                message("fanuc-old-version", address=self._options.address, version=self._version),
                message("fanuc-update"),
            )
        poses = self._options.report == "flange"
        if poses and tool_pose:
            raise DeviceError(
                message("fanuc-reports-tool", address=self._options.address),
                message("fanuc-report-faceplate"),
            )
        self._await_status(deadline)
        return ArmInfo(
            name=f"FANUC Stream Motion {self._version}",
            serial_number=self._options.serial_number,
            joint_count=0 if poses else _AXES,
            rate_hz=1000 / cycle_ms,
            reports="pose" if poses else "joints",
            buttons=frozenset(),
        )

    def receive(self, timeout_s: float) -> Sequence[RobotReading]:
        """Readings of the status packets that have arrived."""
        found: list[RobotReading] = []
        for data in self._link.receive(timeout_s):
            if _kind(data) in _CAPABILITY_ANSWERS:
                continue  # an answer to a request that was repeated
            if len(data) != _STATUS_SIZES.get(_kind(data)):
                self._health.corrupt += 1
                continue
            found.append(self._reading(data))
        return found

    def close(self) -> None:
        """Stops the stream."""
        self._link.close(_REQUEST.pack(_STOP, self._version) if self._version else b"")

    def _reading(self, data: bytes) -> RobotReading:
        _, _, sequence, stamp_ms, *values = _STATUS.unpack_from(data)
        require_finite(self._options.address, values)
        device_ns = self._time_ms.unwrap(stamp_ms) * 1_000_000
        count = self._sequence.unwrap(sequence)
        if self._options.report == "joints":
            joints = tuple(radians(value) for value in values[9 : 9 + _AXES])
            return RobotReading(device_ns, count, joints_rad=joints)
        x, y, z, w, p, r = values[:6]
        orientation = quaternion_of(CONVENTIONS["fanuc"], (radians(w), radians(p), radians(r)))
        return RobotReading(device_ns, count, position_mm=(x, y, z), quaternion_xyzw=orientation)

    def _capabilities(self, deadline: float) -> tuple[int, ...]:
        request = _CAPABILITIES.pack(_CAPABILITY, _OLDEST_VERSION, 1, 0, 0, 0, 0)
        while time.monotonic() < deadline:
            self._link.send(request)
            for data in self._link.receive(_ASK_EVERY_S):
                if len(data) >= _CAPABILITIES.size and _kind(data) in _CAPABILITY_ANSWERS:
                    return _CAPABILITIES.unpack_from(data)
        raise DeviceError(
            message("fanuc-no-answer", address=self._options.address),
            message("fanuc-check-option"),
        )

    def _await_status(self, deadline: float) -> None:
        while time.monotonic() < deadline:
            self._link.send(_REQUEST.pack(_START, self._version))
            if self.receive(_ASK_EVERY_S):
                return
        raise DeviceError(
            message("fanuc-sends-no-status", address=self._options.address),
            message("fanuc-check-other-client"),
        )


def _kind(data: bytes) -> int:
    return int.from_bytes(data[:4], "big")
