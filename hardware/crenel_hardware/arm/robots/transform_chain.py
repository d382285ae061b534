"""The pose of one frame in another from the transforms between them, as ROS 2 publishes them.

A transform places a child frame in its parent; every frame has one parent, so that the frames are
trees. A chain from one frame to another leads up to the frame that both descend from, and down.
Transforms that move have times of their own: the pose belongs to the newest time that all of them
have reached, each interpolated there.

Source:
    ROS Enhancement Proposal 105 (frames); tf2_msgs/msg/TFMessage; on /tf_static, transforms that
    hold at all times.
"""

from bisect import bisect_right
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from math import sqrt
from operator import attrgetter

from crenel.messages.message import message, quantity
from crenel.rotations import Quaternion, Vector, multiply
from crenel_hardware.arm.robots.tool_frames import rotate
from crenel_hardware.errors import DeviceError

_KEPT = 500
STALE_NS = 1_000_000_000
"""A transform of the chain that is older than another by this has stopped."""


@dataclass(frozen=True, slots=True)
class FramePlacement:
    """``T_parent_child`` at a time."""

    stamp_ns: int
    position_mm: Vector
    rotation: Quaternion


IDENTITY = FramePlacement(0, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))


@dataclass
class _Link:
    """From a frame to its parent."""

    parent: str
    is_static: bool
    placements: deque[FramePlacement]

    def at(self, stamp_ns: int) -> FramePlacement:
        """At a time, between the two placements around it; the nearest one outside of them."""
        held = list(self.placements)
        after = bisect_right(held, stamp_ns, key=attrgetter("stamp_ns"))
        if self.is_static or after == len(held):
            return held[-1]
        if after == 0:
            return held[0]
        return _interpolate(held[after - 1], held[after], stamp_ns)


class TransformChain:
    """The frames between a base and a tool.

    Args:
        topic: for messages.
        base: the frame in which poses are wanted.
        tool: the frame whose pose is wanted.
    """

    def __init__(self, topic: str, base: str, tool: str) -> None:
        self._topic, self._base, self._tool = topic, base, tool
        self._links: dict[str, _Link] = {}
        self._used: tuple[str, ...] | None = None
        self._newest_ns: int | None = None

    def add(
        self, parent: str, child: str, placement: FramePlacement, is_static: bool = False
    ) -> None:
        """Notes a transform. One that was overtaken by a newer one is left out.

        Raises:
            DeviceError: a frame of the chain has another parent than before.
        """
        link = self._links.get(child)
        if link is not None and link.parent != parent and child in (self._used or ()):
            raise DeviceError(
                message(
                    "ros2-parent-changed",
                    topic=self._topic,
                    frame=child,
                    parent=parent,
                    expected=link.parent,
                ),
                message("opens-again"),
            )
        if link is None or link.parent != parent or link.is_static != is_static:
            link = self._links[child] = _Link(parent, is_static, deque(maxlen=_KEPT))
        if is_static:
            link.placements.clear()
        elif link.placements and placement.stamp_ns <= link.placements[-1].stamp_ns:
            if link.placements[-1].stamp_ns - placement.stamp_ns < STALE_NS:
                return
            # the clock was set back: whoever takes the poses refuses the jump
            link.placements.clear()
            self._newest_ns = None
        link.placements.append(placement)

    def pose(self) -> FramePlacement | None:
        """``T_base_tool`` at the newest common time; None if there is nothing newer than before.

        Raises:
            DeviceError: a transform of the chain has stopped.
        """
        chain = self._chain()
        if chain is None:
            return None
        up, down = chain
        self._used = (*up, *down)
        moving = [name for name in self._used if not self._links[name].is_static]
        newest = {name: self._links[name].placements[-1].stamp_ns for name in moving}
        if not newest:
            return None
        slowest = min(newest, key=newest.__getitem__)
        stamp_ns = newest[slowest]
        if (behind_ns := max(newest.values()) - stamp_ns) > STALE_NS:
            raise self._stale_error(slowest, behind_ns)
        if self._newest_ns is not None and stamp_ns <= self._newest_ns:
            return None
        self._newest_ns = stamp_ns
        T_top_base, T_top_tool = (self._compose(names, stamp_ns) for names in (down, up))
        return _multiply(_invert(T_top_base), T_top_tool, stamp_ns)

    @property
    def has_transforms(self) -> bool:
        """Whether anything has been noted."""
        return bool(self._links)

    def missing_error(self) -> DeviceError:
        """Why there is no pose: frames that are not known, or are not connected, or stand still."""
        frames = sorted(
            {name for child, link in self._links.items() for name in (child, link.parent)}
        )
        chain = self._chain()
        values = {"topic": self._topic, "base": self._base, "tool": self._tool}
        if chain is not None:
            return DeviceError(message("ros2-nothing-of-chain-moves", **values))
        return DeviceError(
            message("ros2-no-chain", **values),
            message("ros2-frames-are", names=", ".join(frames) or "–"),
        )

    def _stale_error(self, child: str, behind_ns: int) -> DeviceError:
        return DeviceError(
            message(
                "ros2-transform-stale",
                topic=self._topic,
                parent=self._links[child].parent,
                child=child,
                behind=quantity(behind_ns / 1e9, "s", 1),
            ),
            message("ros2-check-transform-node"),
        )

    def _ancestors(self, frame: str) -> list[str]:
        """A frame and all above it."""
        names = [frame]
        while (link := self._links.get(names[-1])) is not None and link.parent not in names:
            names.append(link.parent)
        return names

    def _chain(self) -> tuple[list[str], list[str]] | None:
        """The frames below the common one, from the tool up and from the base up."""
        over_tool, over_base = self._ancestors(self._tool), self._ancestors(self._base)
        common = next((name for name in over_tool if name in over_base), None)
        if common is None or self._tool == self._base:
            return None
        return over_tool[: over_tool.index(common)], over_base[: over_base.index(common)]

    def _compose(self, names: Sequence[str], stamp_ns: int) -> FramePlacement:
        """``T_top_frame`` from the links of a frame and those above it."""
        placed = IDENTITY
        for name in names:
            placed = _multiply(self._links[name].at(stamp_ns), placed, stamp_ns)
        return placed


def _multiply(a: FramePlacement, b: FramePlacement, stamp_ns: int) -> FramePlacement:
    x, y, z = rotate(a.rotation, b.position_mm)
    position_mm = (a.position_mm[0] + x, a.position_mm[1] + y, a.position_mm[2] + z)
    return FramePlacement(stamp_ns, position_mm, multiply(a.rotation, b.rotation))


def _invert(a: FramePlacement) -> FramePlacement:
    x, y, z, w = a.rotation
    back = (-x, -y, -z, w)
    px, py, pz = rotate(back, a.position_mm)
    return FramePlacement(a.stamp_ns, (-px, -py, -pz), back)


def _interpolate(a: FramePlacement, b: FramePlacement, stamp_ns: int) -> FramePlacement:
    """Between two placements: linear, and of the rotation by its normalized quaternion, since
    they are milliseconds apart."""
    share = (stamp_ns - a.stamp_ns) / (b.stamp_ns - a.stamp_ns)
    sign = 1.0 if sum(p * q for p, q in zip(a.rotation, b.rotation, strict=True)) >= 0 else -1.0
    mixed = [
        (1 - share) * p + share * sign * q for p, q in zip(a.rotation, b.rotation, strict=True)
    ]
    length = sqrt(sum(value * value for value in mixed))
    x, y, z = (
        (1 - share) * p + share * q for p, q in zip(a.position_mm, b.position_mm, strict=True)
    )
    qx, qy, qz, qw = (value / length for value in mixed)
    return FramePlacement(stamp_ns, (x, y, z), (qx, qy, qz, qw))
