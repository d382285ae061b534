"""The ``abb-egm`` driver: an ABB robot, read by the position stream of Externally Guided Motion.

The RAPID program starts the stream (``EGMStreamStart``, option 689-1 of the controller), which is
read-only; the driver sends nothing. In station.toml::

    [arm]
    driver = "abb-egm"
    address = "192.168.1.60"    # of the controller; packets from elsewhere are ignored
    port = 6510                 # of this computer, as in the controller's UDPUC device
    report = "flange"           # or "joints"
    tool = [0, 0, 120, 1, 0, 0, 0]  # optional: tframe of the active tooldata: mm, q1 … q4
    base = [0, 0, 0, 1, 0, 0, 0]    # optional: the work object's frame in the base frame
    external_axis = "third"     # optional, for joints: the first external axis is the third joint
                                # (robots of seven axes), or "other" (a track, a turntable)
    serial_number = "2019-0042" # optional: of this robot, which does not state it
    latency_us = 0              # optional: least time from measuring to arrival here
    timeout_s = 3.0             # how long ``open`` waits for the controller

Source:
    ABB, "Application manual - Externally Guided Motion". The controller's clock in ``feedBack`` is
    used where it is sent, and the milliseconds of the header otherwise.
"""

from collections.abc import Mapping, Sequence
from math import radians, sqrt
from typing import Annotated, Any, Literal

from pydantic import AfterValidator, Field, FiniteFloat

from crenel.messages.message import Text, message
from crenel_hardware.arm.robots.egm_message import decode_robot
from crenel_hardware.arm.robots.listening import (
    BASE,
    FIRST_PACKETS,
    TOOL,
    ListeningOptions,
    ListeningStream,
    Pose,
)
from crenel_hardware.arm.robots.readings import (
    RobotReading,
    WrappingCounter,
    require_finite,
    require_unit,
)
from crenel_hardware.arm.robots.streaming_arm import StreamingArm, await_readings
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import ArmInfo, LinkHealth
from crenel_hardware.options import Shown, read_options
from crenel_hardware.shared_options import Port

_PORT = 6510
_UNIT_TOLERANCE = 1e-4


def _require_unit(frame: list[float]) -> list[float]:
    if abs(sqrt(sum(value * value for value in frame[3:])) - 1) > _UNIT_TOLERANCE:
        raise ValueError(message("quaternion-must-be-unit"))
    return frame


Frame7 = Annotated[
    list[FiniteFloat], Field(min_length=7, max_length=7), AfterValidator(_require_unit)
]


class AbbEgmOptions(ListeningOptions):
    """Options of the driver in station.toml."""

    title = message("driver-abb-egm")
    port: Port = _PORT
    tool: Annotated[Frame7, TOOL] = Field(default=[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0])
    base: Annotated[Frame7, BASE] = Field(default=[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0])
    external_axis: Annotated[
        Literal["third", "other"] | None,
        Shown(
            message("option-external-axis"),
            message("option-help-external-axis"),
            {
                "third": message("option-choice-third-axis"),
                "other": message("option-choice-other-axis"),
            },
        ),
    ] = None


def from_options(options: Mapping[str, object]) -> StreamingArm:
    """The driver for an ``[arm]`` table of station.toml; raises ``DeviceError``."""
    checked = read_options(AbbEgmOptions, options, "arm")
    return StreamingArm(checked, checked.address, lambda: EgmStream(checked))


class EgmStream(ListeningStream):
    """What the controller sends to one port. Implements ``ControllerStream``."""

    silence_remedy: Text = message("egm-start-stream")

    def __init__(self, options: AbbEgmOptions) -> None:
        unreadable = message("egm-no-egm", address=options.address)
        tool, base = _frame(options.tool), _frame(options.base)
        super().__init__(options, tool, base, unreadable)
        self._sequence, self._time_ms = WrappingCounter(1 << 32), WrappingCounter(1 << 32)
        self._has_clock: bool | None = None
        self._external_axis = options.external_axis

    def start(self, timeout_s: float, health: LinkHealth) -> ArmInfo:
        """Listens, and learns rate and joints from the first packets."""
        self.listen(health)
        first = await_readings(self, FIRST_PACKETS, timeout_s)
        first.sort(key=lambda each: each.device_ns)
        counts = (first[-1].count or 0) - (first[0].count or 0) if first else 0
        if counts < 1:
            raise self.no_data_error()
        rate_hz = counts * 1e9 / max(first[-1].device_ns - first[0].device_ns, 1_000_000)
        return self.info("ABB EGM", len(first[0].joints_rad), rate_hz)

    def decode(self, data: bytes) -> RobotReading | None:
        robot = decode_robot(data)
        return None if robot is None else self._reading(robot)

    def _reading(self, robot: Any) -> RobotReading:
        count = self._sequence.unwrap(robot.header.seqno)
        device_ns = self._device_ns(robot)
        feedback = robot.feedBack
        if not self._sends_poses:
            joints = self._joints_deg(feedback)
            require_finite(self._address, joints)
            if not 5 <= len(joints) <= 7:
                raise self._lack_error("joints")
            return RobotReading(device_ns, count, joints_rad=tuple(map(radians, joints)))
        if not (feedback.cartesian.HasField("pos") and feedback.cartesian.HasField("orient")):
            raise self._lack_error("cartesian")
        pos, orient = feedback.cartesian.pos, feedback.cartesian.orient
        values = (pos.x, pos.y, pos.z, orient.u0, orient.u1, orient.u2, orient.u3)
        joints_rad = tuple(map(radians, feedback.joints.joints))
        return self._pose_reading(device_ns, count, values, joints_rad)

    def _joints_deg(self, feedback: Any) -> list[float]:
        """The arm's joints in their order in the chain: robots of seven axes send the third of them
        as the first external axis.

        Raises:
            DeviceError: an external axis moves or is turned, and nobody said what it is.
        """
        joints, external = list(feedback.joints.joints), list(feedback.externalJoints.joints)
        if self._external_axis == "third":
            if not external:
                raise self._lack_error("externalJoints")
            return [*joints[:2], external[0], *joints[2:]]
        if self._external_axis is None and any(external):
            raise DeviceError(
                message("egm-external-axis", address=self._address),
                message("state-external-axis"),
            )
        return joints

    def _pose_reading(
        self,
        device_ns: int,
        count: int,
        values: tuple[float, ...],
        joints_rad: tuple[float, ...],
    ) -> RobotReading:
        require_finite(self._address, values)
        require_unit(self._address, values[3:])
        self._frames.require_same_frames(device_ns, joints_rad, _frame(values))
        position_mm, orientation = self.flange_of(_frame(values))
        return RobotReading(device_ns, count, position_mm=position_mm, quaternion_xyzw=orientation)

    def _device_ns(self, robot: Any) -> int:
        has_clock = robot.feedBack.HasField("time")
        if self._has_clock is None:
            self._has_clock = has_clock
        if self._has_clock != has_clock:
            raise DeviceError(
                message("robot-clock-jumped", address=self._address),
                message("opens-again"),
            )
        if has_clock:
            clock = robot.feedBack.time
            return int(clock.sec) * 1_000_000_000 + int(clock.usec) * 1000
        return self._time_ms.unwrap(robot.header.tm) * 1_000_000

    def _lack_error(self, name: str) -> DeviceError:
        return DeviceError(
            message("egm-lacks", address=self._address, name=name),
            message("check-what-robot-sends"),
        )


def _frame(values: Sequence[float]) -> Pose:
    """x, y, z in mm and q1 … q4, which is w first, as position and quaternion."""
    x, y, z, w, i, j, k = values
    return (x, y, z), (i, j, k, w)
