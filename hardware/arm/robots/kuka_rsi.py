"""The ``kuka-rsi`` driver: a KUKA robot, read by the Robot Sensor Interface (RSI).

The controller sends an XML document each cycle, and expects no answer if ``ONLYSEND`` is ``TRUE``
in its Ethernet configuration; the driver sends nothing. In station.toml::

    [arm]
    driver = "kuka-rsi"
    address = "192.168.1.50"    # of the controller; packets from elsewhere are ignored
    port = 49152                # of this computer, as in the Ethernet configuration
    report = "flange"           # from RIst; or "joints", from AIPos
    tool = [0, 0, 120, 0, 0, 0] # optional: $TOOL, as X, Y, Z in mm and A, B, C in degrees
    base = [0, 0, 0, 0, 0, 0]   # optional: $BASE in the robot's root frame, the same way
    latency_us = 0              # optional: least time from measuring to arrival here
    timeout_s = 3.0             # how long ``open`` waits for the controller

Source:
    KUKA, "KUKA.RobotSensorInterface": RIst is the pose of $TOOL in $BASE; A, B and C turn about z,
    y and x; IPOC counts the milliseconds of the controller's interpolation clock.
"""

from collections.abc import Mapping, Sequence
from itertools import pairwise
from math import radians
from typing import Annotated, Literal
from xml.etree import ElementTree

from pydantic import Field, FiniteFloat

from app.messages.message import Text, message
from hardware.arm.robots.link import ControllerLink
from hardware.arm.robots.readings import RobotReading, require_finite
from hardware.arm.robots.rotations import (
    Quaternion,
    Vector,
    axis_angles_quaternion,
    flange_behind_tool,
    place_in_arm,
)
from hardware.arm.robots.streaming_arm import RobotOptions, StreamingArm, await_readings
from hardware.errors import DeviceError
from hardware.interfaces import ArmInfo, LinkHealth
from hardware.options import read_options

_PORT = 49152
_POSE = ("X", "Y", "Z", "A", "B", "C")
_JOINTS = ("A1", "A2", "A3", "A4", "A5", "A6")
_ELEMENTS = {"flange": ("RIst", _POSE), "joints": ("AIPos", _JOINTS)}
_FIRST = 10
"""Packets that show the cycle."""

Frame6 = Annotated[list[FiniteFloat], Field(min_length=6, max_length=6)]


class KukaRsiOptions(RobotOptions):
    """Options of the driver in station.toml."""

    port: int = Field(default=_PORT, ge=1, le=65535)
    report: Literal["flange", "joints"] = "flange"
    tool: Frame6 = Field(default=[0.0] * 6)
    base: Frame6 = Field(default=[0.0] * 6)


def from_options(options: Mapping[str, object]) -> StreamingArm:
    """The driver for an ``[arm]`` table of station.toml; raises ``DeviceError``."""
    checked = read_options(KukaRsiOptions, options, "arm")
    return StreamingArm(checked, checked.address, lambda: RsiStream(checked))


class RsiStream:
    """What the controller sends to one port. Implements ``ControllerStream``."""

    silence_remedy: Text = message("kuka-start-rsi")

    def __init__(self, options: KukaRsiOptions) -> None:
        self._options = options
        self._link = ControllerLink(options.address)
        self._health = LinkHealth()
        self._tool, self._base = _frame(options.tool), _frame(options.base)

    def start(self, timeout_s: float, health: LinkHealth) -> ArmInfo:
        """Listens, and learns the controller's cycle from the first packets."""
        self._health = health
        self._link.listen_udp(self._options.port)
        first = await_readings(self, _FIRST, timeout_s)
        stamps = sorted({reading.device_ns for reading in first})
        if len(stamps) < 2:
            raise self._no_data_error()
        cycle_ns = min(b - a for a, b in pairwise(stamps))
        poses = self._options.report == "flange"
        return ArmInfo(
            name="KUKA RSI",
            serial_number="",
            joint_count=0 if poses else len(_JOINTS),
            rate_hz=1e9 / cycle_ns,
            reports="pose" if poses else "joints",
            buttons=frozenset(),
        )

    def receive(self, timeout_s: float) -> Sequence[RobotReading]:
        """Readings of the packets that have arrived."""
        found: list[RobotReading] = []
        for data in self._link.receive(timeout_s):
            root = _parse(data)
            stamp = root.findtext("IPOC") if root is not None else None
            if root is None or stamp is None or not stamp.strip().isdecimal():
                self._health.corrupt += 1
                continue
            found.append(self._reading(int(stamp) * 1_000_000, root))
        return found

    def close(self) -> None:
        """Stops listening; the controller goes on."""
        self._link.close()

    def _reading(self, device_ns: int, root: ElementTree.Element) -> RobotReading:
        values = self._values(root)
        if self._options.report == "joints":
            return RobotReading(device_ns, joints_rad=tuple(map(radians, values)))
        tool_mm, tool = place_in_arm(*self._base, *_frame(values))
        position_mm, orientation = flange_behind_tool(tool_mm, tool, *self._tool)
        return RobotReading(device_ns, position_mm=position_mm, quaternion_xyzw=orientation)

    def _values(self, root: ElementTree.Element) -> list[float]:
        name, keys = _ELEMENTS[self._options.report]
        element = root.find(name)
        if element is None or not all(key in element.attrib for key in keys):
            raise DeviceError(
                message("kuka-lacks-element", address=self._options.address, name=name),
                message("kuka-add-element", name=name),
            )
        try:
            values = [float(element.attrib[key]) for key in keys]
        except ValueError:
            values = [float("nan")]
        require_finite(self._options.address, values)
        return values

    def _no_data_error(self) -> DeviceError:
        if self._health.corrupt:
            return DeviceError(
                message("kuka-no-rsi", address=self._options.address), self.silence_remedy
            )
        return DeviceError(
            message(
                "robot-sends-nothing-to-port",
                address=self._options.address,
                port=str(self._options.port),
            ),
            self.silence_remedy,
        )


def _parse(data: bytes) -> ElementTree.Element | None:
    """The document of a packet; None of anything else. Documents that define entities are not
    read."""
    if b"<!" in data:
        return None
    try:
        return ElementTree.fromstring(data)
    except ElementTree.ParseError:
        return None


def _frame(values: Sequence[float]) -> tuple[Vector, Quaternion]:
    """X, Y, Z in mm and A, B, C in degrees as position and quaternion."""
    x, y, z, a, b, c = values
    return (x, y, z), axis_angles_quaternion(radians(c), radians(b), radians(a))
