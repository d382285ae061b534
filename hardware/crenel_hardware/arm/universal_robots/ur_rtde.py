"""The ``ur-rtde`` driver: a robot of Universal Robots, read by RTDE.

Nothing is written to the robot, and it needs no program, no option and no setting: every controller
serves RTDE. In station.toml::

    [arm]
    driver = "ur-rtde"
    address = "192.168.1.30"
    report = "flange"           # or "joints"
    rate_hz = 500.0             # optional: at most 125 on a CB3, 500 on an e-Series (the default)
    port = 30004
    serial_number = "2019-0042" # optional: of this robot, which does not state it
    latency_us = 0              # optional: least time from measuring to arrival here
    timeout_s = 3.0             # how long ``open`` waits for the controller

``report = "flange"`` reads the pose of the active tool and takes the active tool's offset from it;
``report = "joints"`` reads the joints' encoders.
"""

import logging
import struct
import time
from collections.abc import Iterator, Mapping, Sequence
from typing import Annotated

from pydantic import Field

from crenel.messages.message import Text, message, rounded
from crenel.rotations import CONVENTIONS, Quaternion, Vector, quaternion_of
from crenel_hardware.arm.robots.link import ControllerLink
from crenel_hardware.arm.robots.readings import RobotReading, require_finite
from crenel_hardware.arm.robots.streaming_arm import RobotOptions, StreamingArm
from crenel_hardware.arm.robots.tool_frames import (
    flange_behind_tool,
)
from crenel_hardware.arm.universal_robots import packages
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import ArmInfo, LinkHealth
from crenel_hardware.options import read_options
from crenel_hardware.shared_options import RATE, Port, Report

log = logging.getLogger(__name__)

_POSE = ("timestamp", "robot_mode", "actual_TCP_pose", "tcp_offset")
_JOINTS = ("timestamp", "robot_mode", "actual_q")
_POWERED = 4
"""The lowest ``robot_mode`` with power on the joints; below it, angles are not measured."""
_E_SERIES = 5
"""The first major version with 500 Hz."""
_OFFSET_TOLERANCE = 1e-9
"""In metres and radians."""
_Values = Mapping[str, tuple[float, ...]]


class UrRtdeOptions(RobotOptions):
    """Options of the driver in station.toml."""

    title = message("driver-ur-rtde")
    port: Port = packages.PORT
    report: Report = "flange"
    rate_hz: Annotated[float | None, Field(ge=50, le=500), RATE] = None


def from_options(options: Mapping[str, object]) -> StreamingArm:
    """The driver for an ``[arm]`` table of station.toml; raises ``DeviceError``."""
    checked = read_options(UrRtdeOptions, options, "arm")
    return StreamingArm(checked, checked.address, lambda: RtdeStream(checked))


class RtdeStream:
    """One RTDE connection. Implements ``ControllerStream``."""

    silence_remedy: Text = message("check-robot-network")

    def __init__(self, options: UrRtdeOptions) -> None:
        self._options = options
        self._link = ControllerLink(options.address)
        self._reader = packages.PackageReader()
        self._names = _POSE if options.report == "flange" else _JOINTS
        self._recipe = packages.Recipe(0, (), ())
        self._tool: tuple[float, ...] | None = None
        self._said = ""

    def start(self, timeout_s: float, health: LinkHealth) -> ArmInfo:
        """Negotiates version, rate and variables, and starts the stream."""
        options, deadline = self._options, time.monotonic() + timeout_s
        self._link.connect_tcp(options.port, timeout_s)
        version = self._ask(packages.encode_version_request(), deadline)
        if version[:1] != b"\x01":
            raise self._error(
                message("ur-does-not-speak-rtde-2", address=self._options.address),
                message("ur-update-polyscope"),
            )
        software = self._controller_version(deadline)
        fastest_hz = 500.0 if software[0] >= _E_SERIES else 125.0
        rate_hz = options.rate_hz or fastest_hz
        if rate_hz > fastest_hz:
            raise DeviceError(
                message(
                    "ur-rate-too-high",
                    address=options.address,
                    rate=rounded(rate_hz, "Hz"),
                    fastest=rounded(fastest_hz, "Hz"),
                ),
                message("correct-option", key="rate_hz"),
            )
        self._set_up(rate_hz, deadline)
        if self._ask(packages.encode_package(packages.START), deadline)[:1] != b"\x01":
            raise self._error(
                message("ur-refuses-start", address=self._options.address),
                message("restart-robot-controller"),
            )
        poses = options.report == "flange"
        return ArmInfo(
            name=f"Universal Robots {'.'.join(str(part) for part in software[:3])}",
            serial_number=options.serial_number,
            joint_count=0 if poses else 6,
            rate_hz=rate_hz,
            reports="pose" if poses else "joints",
            buttons=frozenset(),
        )

    def receive(self, timeout_s: float) -> Sequence[RobotReading]:
        """Readings of the data packages that have arrived."""
        return [self._reading(values) for values in self._data(self._packages(timeout_s))]

    def close(self) -> None:
        """Closes the connection, which ends the stream."""
        self._link.close()

    def _packages(self, timeout_s: float) -> list[packages.Package]:
        try:
            return [
                package
                for data in self._link.receive(timeout_s)
                for package in self._reader.feed(data)
            ]
        except packages.PackageError as error:
            raise self._no_rtde_error(error) from error

    def _data(self, found: Sequence[packages.Package]) -> Iterator[_Values]:
        for package in found:
            if package.kind == packages.TEXT_MESSAGE:
                self._note_text(package.payload)
            elif package.kind == packages.DATA_PACKAGE:
                try:
                    yield self._recipe.decode(package.payload)
                except packages.PackageError as error:
                    raise self._no_rtde_error(error) from error

    def _reading(self, values: _Values) -> RobotReading:
        for numbers in values.values():
            require_finite(self._options.address, numbers)
        if values["robot_mode"][0] < _POWERED:
            raise self._error(
                message("ur-arm-off", address=self._options.address), message("ur-switch-on")
            )
        device_ns = round(values["timestamp"][0] * 1e9)
        if self._options.report == "joints":
            return RobotReading(device_ns, joints_rad=values["actual_q"])
        tool = values["tcp_offset"]
        if self._tool is None:
            self._tool = tool
        elif any(abs(a - b) > _OFFSET_TOLERANCE for a, b in zip(tool, self._tool, strict=True)):
            raise self._error(
                message("ur-tool-changed", address=self._options.address), message("ur-keep-tool")
            )
        position_mm, quaternion = flange_pose(values["actual_TCP_pose"], tool)
        return RobotReading(device_ns, position_mm=position_mm, quaternion_xyzw=quaternion)

    def _ask(self, request: bytes, deadline: float) -> bytes:
        """The payload of the answer, which has the request's type."""
        self._link.send(request)
        while (remaining_s := deadline - time.monotonic()) > 0:
            for package in self._packages(remaining_s):
                if package.kind == packages.TEXT_MESSAGE:
                    self._note_text(package.payload)
                elif package.kind == request[2]:
                    return package.payload
        raise self._error(
            message("ur-no-answer", address=self._options.address),
            message("check-address-and-port"),
        )

    def _controller_version(self, deadline: float) -> tuple[int, ...]:
        payload = self._ask(packages.encode_package(packages.GET_CONTROLLER_VERSION), deadline)
        if len(payload) != 16:
            raise self._no_rtde_error("version")
        return struct.unpack(">4I", payload)

    def _set_up(self, rate_hz: float, deadline: float) -> None:
        payload = self._ask(packages.encode_setup(rate_hz, self._names), deadline)
        try:
            self._recipe = packages.decode_recipe(payload, self._names)
        except packages.PackageError as error:
            raise self._no_rtde_error(error) from error
        if missing := self._recipe.missing:
            raise self._error(
                message("ur-has-not", address=self._options.address, names=", ".join(missing)),
                message("ur-update-polyscope"),
            )

    def _note_text(self, payload: bytes) -> None:
        self._said = packages.decode_text(payload)
        log.warning("The robot at %s says: %s", self._options.address, self._said)

    def _error(self, what: Text, remedy: Text) -> DeviceError:
        if self._said:
            what = message("robot-said", text=what, said=self._said)
        return DeviceError(what, remedy)

    def _no_rtde_error(self, reason: object) -> DeviceError:
        return self._error(
            message("ur-no-rtde", address=self._options.address, reason=str(reason)),
            message("check-address-and-port"),
        )


def flange_pose(
    tool_pose: Sequence[float], tool_offset: Sequence[float]
) -> tuple[Vector, Quaternion]:
    """``T_base_flange`` of UR's poses: x, y, z in metres and a rotation vector in radians.

    Args:
        tool_pose: ``actual_TCP_pose``, the tool in the base frame.
        tool_offset: ``tcp_offset``, the tool in the flange frame.

    Returns:
        Position in mm and quaternion of the flange in the base frame.
    """
    (tool_mm, tool), (offset_mm, offset) = _split(tool_pose), _split(tool_offset)
    return flange_behind_tool(tool_mm, tool, offset_mm, offset)


def _split(pose: Sequence[float]) -> tuple[Vector, Quaternion]:
    x, y, z, rx, ry, rz = pose
    return (1000 * x, 1000 * y, 1000 * z), quaternion_of(
        CONVENTIONS["universal-robots"], (rx, ry, rz)
    )
