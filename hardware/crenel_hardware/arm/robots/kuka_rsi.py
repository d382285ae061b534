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
    serial_number = "2019-0042" # optional: of this robot, which does not state it
    latency_us = 0              # optional: least time from measuring to arrival here
    timeout_s = 3.0             # how long ``open`` waits for the controller

Source:
    KUKA, "KUKA.RobotSensorInterface": RIst is the pose of $TOOL in $BASE; A, B and C turn about z,
    y and x; IPOC counts the milliseconds of the controller's interpolation clock.
"""

from collections.abc import Mapping, Sequence
from itertools import pairwise
from math import radians
from typing import Annotated
from xml.etree import ElementTree

from pydantic import Field, FiniteFloat

from crenel.messages.message import Text, message
from crenel.rotations import CONVENTIONS, quaternion_of
from crenel_hardware.arm.robots.listening import (
    BASE,
    FIRST_PACKETS,
    TOOL,
    ListeningOptions,
    ListeningStream,
    Pose,
)
from crenel_hardware.arm.robots.readings import RobotReading, require_finite
from crenel_hardware.arm.robots.streaming_arm import StreamingArm, await_readings
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import ArmInfo, LinkHealth
from crenel_hardware.options import read_options
from crenel_hardware.shared_options import Port

_PORT = 49152
_POSE = ("X", "Y", "Z", "A", "B", "C")
_JOINTS = ("A1", "A2", "A3", "A4", "A5", "A6")
_ELEMENTS = {"flange": ("RIst", _POSE), "joints": ("AIPos", _JOINTS)}
_LONGEST_STAMP = 18
"""Digits; the controller counts milliseconds."""

Frame6 = Annotated[list[FiniteFloat], Field(min_length=6, max_length=6)]


class KukaRsiOptions(ListeningOptions):
    """Options of the driver in station.toml."""

    title = message("driver-kuka-rsi")
    port: Port = _PORT
    tool: Annotated[Frame6, TOOL] = Field(default=[0.0] * 6)
    base: Annotated[Frame6, BASE] = Field(default=[0.0] * 6)


def from_options(options: Mapping[str, object]) -> StreamingArm:
    """The driver for an ``[arm]`` table of station.toml; raises ``DeviceError``."""
    checked = read_options(KukaRsiOptions, options, "arm")
    return StreamingArm(checked, checked.address, lambda: RsiStream(checked))


class RsiStream(ListeningStream):
    """What the controller sends to one port. Implements ``ControllerStream``."""

    silence_remedy: Text = message("kuka-start-rsi")

    def __init__(self, options: KukaRsiOptions) -> None:
        unreadable = message("kuka-no-rsi", address=options.address)
        tool, base = _frame(options.tool), _frame(options.base)
        super().__init__(options, tool, base, unreadable)
        self._element, self._keys = _ELEMENTS[options.report]

    def start(self, timeout_s: float, health: LinkHealth) -> ArmInfo:
        """Listens, and learns the controller's cycle from the first packets."""
        self.listen(health)
        first = await_readings(self, FIRST_PACKETS, timeout_s)
        stamps = sorted({reading.device_ns for reading in first})
        if len(stamps) < 2:
            raise self.no_data_error()
        cycle_ns = min(b - a for a, b in pairwise(stamps))
        return self.info("KUKA RSI", len(_JOINTS), 1e9 / cycle_ns)

    def decode(self, data: bytes) -> RobotReading | None:
        root = _parse(data)
        stamp = root.findtext("IPOC", "").strip() if root is not None else ""
        if root is None or not stamp.isdecimal() or len(stamp) > _LONGEST_STAMP:
            return None
        return self._reading(int(stamp) * 1_000_000, root)

    def _reading(self, device_ns: int, root: ElementTree.Element) -> RobotReading:
        values = self._values(root)
        if not self._sends_poses:
            return RobotReading(device_ns, joints_rad=tuple(map(radians, values)))
        joints = _joints_beside(root)
        self._frames.require_same_frames(device_ns, joints, _frame(values))
        position_mm, orientation = self.flange_of(_frame(values))
        return RobotReading(device_ns, position_mm=position_mm, quaternion_xyzw=orientation)

    def _values(self, root: ElementTree.Element) -> list[float]:
        name, keys = self._element, self._keys
        element = root.find(name)
        if element is None or not all(key in element.attrib for key in keys):
            raise DeviceError(
                message("kuka-lacks-element", address=self._address, name=name),
                message("kuka-add-element", name=name),
            )
        try:
            values = [_number(element.attrib[key]) for key in keys]
        except ValueError:
            values = [float("nan")]
        require_finite(self._address, values)
        return values


def _number(text: str) -> float:
    """A number, also with the decimal comma that some objects of RSI write."""
    return float(text.replace(",", ".") if text.count(",") == 1 and "." not in text else text)


def _joints_beside(root: ElementTree.Element) -> tuple[float, ...]:
    """The joints in rad, if the packet has them beside the pose; else none."""
    element = root.find("AIPos")
    try:
        return (
            () if element is None else tuple(radians(_number(element.attrib[k])) for k in _JOINTS)
        )
    except (KeyError, ValueError):
        return ()


def _parse(data: bytes) -> ElementTree.Element | None:
    """The document of a packet; None of anything else.

    It is in UTF-8, or else in Latin-1, as some controllers write names. Documents that define
    entities are not read.
    """
    try:
        text = data.decode()
    except UnicodeDecodeError:
        text = data.decode("latin-1")
    try:
        return ElementTree.fromstring(text) if "<!DOCTYPE" not in text else None
    except ElementTree.ParseError:
        return None


def _frame(values: Sequence[float]) -> Pose:
    """X, Y, Z in mm and A, B, C in degrees as position and quaternion."""
    x, y, z, a, b, c = values
    return (x, y, z), quaternion_of(CONVENTIONS["kuka"], (radians(a), radians(b), radians(c)))
