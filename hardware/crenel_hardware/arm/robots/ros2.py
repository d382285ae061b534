"""The ``ros2`` driver: joints or poses that a node of ROS 2 publishes.

``rclpy`` belongs to an installation of ROS 2, in whose environment Crenel must be started; it is no
dependency of Crenel. The driver subscribes to one topic and publishes nothing. In station.toml::

    [arm]
    driver = "ros2"
    topic = "/joint_states"
    kind = "joints"             # sensor_msgs/JointState; or "pose": geometry_msgs/PoseStamped;
                                # or "tf": a chain of tf2_msgs/TFMessage
    joint_names = ["shoulder_pan_joint", "…"]   # for joints: 5 to 7 names, base joint first
    stamps = "header"           # or "arrival", if the messages have no time stamps
    domain_id = 0               # optional: instead of ROS_DOMAIN_ID
    serial_number = "2019-0042" # optional: of this robot, which does not state it
    latency_us = 0              # optional: least time from measuring to arrival here
    timeout_s = 5.0             # how long ``open`` waits for messages

A pose must be that of the flange in the frame of the arm's base, both of which stay the same.
For ``kind = "tf"``, ``parent_frame`` and ``child_frame`` name both; the topics are ``/tf`` and
``/tf_static`` unless ``topic`` names another one, whose name plus ``_static`` is the second.
"""

import importlib
import threading
import time
from collections import deque
from collections.abc import Mapping, Sequence
from typing import Annotated, Any, Literal

from pydantic import Field

from crenel.messages.message import Text, message
from crenel_hardware.arm.robots.readings import RobotReading, require_finite, require_unit
from crenel_hardware.arm.robots.streaming_arm import StreamingArm, UnnumberedOptions, await_readings
from crenel_hardware.arm.robots.transform_chain import FramePlacement, TransformChain
from crenel_hardware.clock import now_ns
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import ArmInfo, LinkHealth
from crenel_hardware.options import Shown, read_options
from crenel_hardware.shared_options import TimeoutSeconds

_FIRST = 20
"""Messages that show the rate."""
_FEWEST_JOINTS = 5
_DEPTH = 1000
"""Messages that may wait for a late reader."""
_TYPES = {
    "joints": ("sensor_msgs.msg", "JointState"),
    "pose": ("geometry_msgs.msg", "PoseStamped"),
    "tf": ("tf2_msgs.msg", "TFMessage"),
}
_TRANSFORMS = "/tf"


class Ros2Options(UnnumberedOptions):
    """Options of the driver in station.toml."""

    title = message("driver-ros2")
    topic: Annotated[str | None, Field(min_length=1), Shown(message("option-topic"))] = None
    kind: Annotated[
        Literal["joints", "pose", "tf"],
        Shown(
            message("option-kind"),
            choices={
                "joints": message("option-choice-joints"),
                "pose": message("option-choice-pose"),
                "tf": message("option-choice-tf"),
            },
        ),
    ]
    parent_frame: Annotated[
        str | None, Field(min_length=1), Shown(message("option-parent-frame"))
    ] = None
    child_frame: Annotated[
        str | None, Field(min_length=1), Shown(message("option-child-frame"))
    ] = None
    joint_names: Annotated[
        list[str],
        Field(max_length=7),
        Shown(message("option-joint-names"), message("option-help-joint-names")),
    ] = Field(default_factory=list)
    stamps: Annotated[
        Literal["header", "arrival"],
        Shown(
            message("option-stamps"),
            choices={
                "header": message("option-choice-header"),
                "arrival": message("option-choice-arrival"),
            },
        ),
    ] = "header"
    domain_id: Annotated[int | None, Field(ge=0, le=232), Shown(message("option-domain-id"))] = None
    timeout_s: TimeoutSeconds = 5.0


def from_options(options: Mapping[str, object]) -> StreamingArm:
    """The driver for an ``[arm]`` table of station.toml; raises ``DeviceError``."""
    checked = read_options(Ros2Options, options, "arm")
    if checked.kind == "joints" and len(checked.joint_names) < _FEWEST_JOINTS:
        raise DeviceError(
            message("station-toml-option-missing", table="arm", key=repr("joint_names")),
            message("ros2-needs-joint-names"),
        )
    if checked.kind == "tf":
        topic = checked.topic or _TRANSFORMS
        parent = _require_option("parent_frame", checked.parent_frame).removeprefix("/")
        child = _require_option("child_frame", checked.child_frame).removeprefix("/")
        if parent == child:
            raise DeviceError(message("ros2-same-frames", frame=child))
        return StreamingArm(
            checked,
            topic,
            lambda: TopicStream(topic, checked, TransformChain(topic, parent, child)),
        )
    topic = _require_option("topic", checked.topic)
    return StreamingArm(checked, topic, lambda: TopicStream(topic, checked))


def _require_option(key: str, value: str | None) -> str:
    if value is None:
        raise DeviceError(message("station-toml-option-missing", table="arm", key=repr(key)))
    return value


class TopicStream:
    """A subscription, spun by the thread that reads. Implements ``ControllerStream``."""

    silence_remedy: Text = message("ros2-check-publisher")

    def __init__(
        self, topic: str, options: Ros2Options, chain: TransformChain | None = None
    ) -> None:
        self._topic, self._options, self._chain = topic, options, chain
        self._lock = threading.Lock()
        self._closed = False
        self._context: Any = None
        self._node: Any = None
        self._executor: Any = None
        self._arrived: deque[tuple[int, Any, bool]] = deque()
        """Arrival, message, and whether it came on the topic of what does not move."""
        self._count = 0
        self._frame: str | None = None

    def start(self, timeout_s: float, health: LinkHealth) -> ArmInfo:
        """Subscribes, and learns the rate from the first messages."""
        self._subscribe()
        first = await_readings(self, _FIRST, timeout_s)
        if len(first) < 2 or first[-1].device_ns <= first[0].device_ns:
            raise self._no_message_error()
        poses = self._options.kind != "joints"
        return ArmInfo(
            name=f"ROS 2 {self._topic}",
            serial_number=self._options.serial_number,
            joint_count=0 if poses else len(self._options.joint_names),
            rate_hz=(len(first) - 1) * 1e9 / (first[-1].device_ns - first[0].device_ns),
            reports="pose" if poses else "joints",
            buttons=frozenset(),
            stamps="device" if self._options.stamps == "header" else "arrival",
        )

    def receive(self, timeout_s: float) -> Sequence[RobotReading]:
        """Readings of the messages that have arrived."""
        deadline = time.monotonic() + timeout_s
        with self._lock:
            while not self._arrived:
                if self._closed or self._executor is None:
                    raise DeviceError(message("robot-link-closed", address=self._topic))
                remaining_s = deadline - time.monotonic()
                self._executor.spin_once(timeout_sec=max(0.0, remaining_s))
                if remaining_s <= 0:
                    break
        found: list[RobotReading] = []
        while self._arrived:
            arrival_ns, received, is_static = self._arrived.popleft()
            if self._chain is not None:
                found += self._chain_readings(self._chain, arrival_ns, received, is_static)
            else:
                found.append(self._reading(arrival_ns, received))
        return found

    def close(self) -> None:
        """Ends the subscription and a waiting ``receive``."""
        self._closed = True
        if self._executor is not None:
            self._executor.wake()
        with self._lock:
            if self._executor is not None:
                self._executor.shutdown(timeout_sec=0.0)
                self._node.destroy_node()
            self._executor = self._node = None
            if self._context is not None:
                self._context.try_shutdown()
                self._context = None

    def _subscribe(self) -> None:
        package, kind = _TYPES[self._options.kind]
        try:
            rclpy = importlib.import_module("rclpy")
            message_type = getattr(importlib.import_module(package), kind)
            executors = importlib.import_module("rclpy.executors")
            qos = importlib.import_module("rclpy.qos")
            signals = importlib.import_module("rclpy.signals")
        except (ImportError, OSError) as error:
            raise DeviceError(
                message("ros2-not-found", reason=error), message("ros2-source-setup")
            ) from error
        options = self._options
        try:
            with self._lock:
                self._context = rclpy.Context()
                rclpy.init(
                    args=[],
                    context=self._context,
                    domain_id=options.domain_id,
                    signal_handler_options=signals.SignalHandlerOptions.NO,
                )
                self._node = rclpy.create_node("crenel_arm", context=self._context)
                self._executor = executors.SingleThreadedExecutor(context=self._context)
                self._executor.add_node(self._node)
                # A reader that asks for less matches reliable and unreliable publishers.
                profile = qos.QoSProfile(
                    depth=_DEPTH, reliability=qos.ReliabilityPolicy.BEST_EFFORT
                )
                self._node.create_subscription(message_type, self._topic, self._note, profile)
                if self._chain is not None:
                    # what does not move was published once, for all who come later
                    kept = qos.QoSProfile(
                        depth=_DEPTH, durability=qos.DurabilityPolicy.TRANSIENT_LOCAL
                    )
                    static = f"{self._topic}_static"
                    self._node.create_subscription(message_type, static, self._note_static, kept)
        except Exception as error:  # rclpy has no common class for what its middleware reports
            raise DeviceError(
                message("ros2-failed", topic=self._topic, reason=error),
                message("correct-option", key="topic"),
            ) from error

    def _note(self, received: Any) -> None:
        self._arrived.append((now_ns(), received, False))

    def _note_static(self, received: Any) -> None:
        self._arrived.append((now_ns(), received, True))

    def _chain_readings(
        self, chain: TransformChain, arrival_ns: int, received: Any, is_static: bool
    ) -> list[RobotReading]:
        """The pose of the child frame after a message, if it has changed."""
        for one in received.transforms:
            moved, turned = one.transform.translation, one.transform.rotation
            rotation = (turned.x, turned.y, turned.z, turned.w)
            position_mm = (1000 * moved.x, 1000 * moved.y, 1000 * moved.z)
            require_finite(self._topic, (*position_mm, *rotation))
            require_unit(self._topic, rotation)
            stamp_ns = 0 if is_static else self._device_ns(arrival_ns, one.header)
            frames = (one.header.frame_id.removeprefix("/"), one.child_frame_id.removeprefix("/"))
            chain.add(*frames, FramePlacement(stamp_ns, position_mm, rotation), is_static)
        placed = chain.pose()
        if placed is None:
            return []
        self._count += 1
        return [
            RobotReading(
                placed.stamp_ns,
                self._count,
                position_mm=placed.position_mm,
                quaternion_xyzw=placed.rotation,
            )
        ]

    def _reading(self, arrival_ns: int, received: Any) -> RobotReading:
        self._count += 1
        device_ns = self._device_ns(arrival_ns, received.header)
        if self._options.kind == "joints":
            return RobotReading(device_ns, self._count, joints_rad=self._joints(received))
        self._require_frame(received.header.frame_id)
        position, q = received.pose.position, received.pose.orientation
        place_mm = (1000 * position.x, 1000 * position.y, 1000 * position.z)
        return RobotReading(
            device_ns, self._count, position_mm=place_mm, quaternion_xyzw=(q.x, q.y, q.z, q.w)
        )

    def _device_ns(self, arrival_ns: int, header: Any) -> int:
        if self._options.stamps == "arrival":
            return arrival_ns
        device_ns = int(header.stamp.sec) * 1_000_000_000 + int(header.stamp.nanosec)
        if device_ns == 0:
            raise DeviceError(
                message("ros2-no-stamp", topic=self._topic), message("ros2-use-arrival")
            )
        return device_ns

    def _joints(self, received: Any) -> tuple[float, ...]:
        angles = dict(zip(received.name, received.position, strict=False))
        missing = [name for name in self._options.joint_names if name not in angles]
        if missing:
            raise DeviceError(
                message("ros2-lacks-joint", topic=self._topic, name=missing[0]),
                message("ros2-joints-are", names=", ".join(received.name)),
            )
        joints = tuple(float(angles[name]) for name in self._options.joint_names)
        require_finite(self._topic, joints)
        return joints

    def _require_frame(self, frame: str) -> None:
        if self._frame is None:
            self._frame = frame
        if frame != self._frame:
            raise DeviceError(
                message(
                    "ros2-frame-changed",
                    topic=self._topic,
                    frame=frame,
                    expected=self._frame,
                ),
                message("opens-again"),
            )

    def _no_message_error(self) -> DeviceError:
        if self._chain is not None and self._chain.has_transforms:
            return self._chain.missing_error()
        package, kind = _TYPES[self._options.kind]
        wanted = f"{package.partition('.')[0]}/msg/{kind}"
        own = self._node.resolve_topic_name(self._topic)
        topics = self._node.get_topic_names_and_types()
        found = [name for name, kinds in topics if wanted in kinds and name != own]
        what = message("ros2-nothing-published", topic=self._topic, kind=wanted)
        if found:
            return DeviceError(what, message("ros2-topics-are", names=", ".join(sorted(found))))
        return DeviceError(what, self.silence_remedy)
