"""Controllers that send datagrams to a port of this computer, and expect no answer."""

from collections.abc import Sequence
from typing import TypeAlias

from crenel.messages.message import Text, message
from crenel.rotations import Quaternion, Vector
from crenel_hardware.arm.robots.frame_watch import FrameWatch
from crenel_hardware.arm.robots.link import ControllerLink
from crenel_hardware.arm.robots.readings import RobotReading
from crenel_hardware.arm.robots.streaming_arm import RobotOptions
from crenel_hardware.arm.robots.tool_frames import flange_behind_tool, place_in_arm
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import ArmInfo, LinkHealth
from crenel_hardware.options import Shown
from crenel_hardware.shared_options import Port, Report

FIRST_PACKETS = 10
"""They show the cycle."""
Pose: TypeAlias = tuple[Vector, Quaternion]
"""Position in mm and orientation."""


TOOL = Shown(message("option-tool"), message("option-help-tool"))
BASE = Shown(message("option-base"), message("option-help-base"))


class ListeningOptions(RobotOptions):
    """Options of such a controller; a driver states its usual port."""

    port: Port
    report: Report = "flange"


class ListeningStream:
    """What a controller sends to one port. A subclass decodes it, and implements
    ``ControllerStream``.

    Args:
        options: of the driver.
        tool: pose of the tool in the flange frame.
        base: pose in the arm's frame of the frame in which the tool's pose is sent.
        unreadable: says that packets come that are not this controller's.
    """

    silence_remedy: Text

    def __init__(self, options: ListeningOptions, tool: Pose, base: Pose, unreadable: Text) -> None:
        self._address, self._port, self._unreadable = options.address, options.port, unreadable
        self._serial_number = options.serial_number
        self._sends_poses = options.report == "flange"
        self._link = ControllerLink(options.address)
        self._health = LinkHealth()
        self._tool, self._base = tool, base
        self._frames = FrameWatch(options.address)

    def listen(self, health: LinkHealth) -> None:
        """From here on packets are received; those that cannot be read count in ``health``."""
        self._health = health
        self._link.listen_udp(self._port)

    def receive(self, timeout_s: float) -> Sequence[RobotReading]:
        """Readings of the packets that have arrived."""
        found: list[RobotReading] = []
        for data in self._link.receive(timeout_s):
            reading = self.decode(data)
            if reading is None:
                self._health.corrupt += 1
            else:
                found.append(reading)
        return found

    def decode(self, data: bytes) -> RobotReading | None:
        """The reading of a packet, None of anything else; raises ``DeviceError`` if it lacks what
        is to be read."""
        raise NotImplementedError

    def close(self) -> None:
        """Stops listening; the controller goes on."""
        self._link.close()

    def info(self, name: str, joint_count: int, rate_hz: float) -> ArmInfo:
        """What the controller is; ``joint_count`` counts where it sends joints."""
        return ArmInfo(
            name=name,
            serial_number=self._serial_number,
            joint_count=0 if self._sends_poses else joint_count,
            rate_hz=rate_hz,
            reports="pose" if self._sends_poses else "joints",
            buttons=frozenset(),
        )

    def flange_of(self, tool: Pose) -> Pose:
        """The flange in the arm's frame, of the tool's pose as it is sent."""
        return flange_behind_tool(*place_in_arm(*self._base, *tool), *self._tool)

    def no_data_error(self) -> DeviceError:
        """Why ``start`` has no readings."""
        if self._health.corrupt:
            return DeviceError(self._unreadable, self.silence_remedy)
        if sender := self._link.other_sender:
            return DeviceError(
                message(
                    "robot-sends-not-from-address",
                    address=self._address,
                    sender=sender,
                    port=str(self._port),
                ),
                message("correct-option", key="address"),
            )
        return DeviceError(
            message("robot-sends-nothing-to-port", address=self._address, port=str(self._port)),
            self.silence_remedy,
        )
