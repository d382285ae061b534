"""The 3D view for a slow browser: fewer points of the clouds, evenly selected.

viser sends every browser the same data. The names of large cloud nodes contain the tier of their
points (see ``cloud_view``), so that omitting the lowest tiers leaves an even view.
"""

import re
from dataclasses import dataclass

from crenel.api.viewer.frames import Message, pack_frame, unpack_frame

TIER = re.compile(r"-(\d+)$")
POINT_BYTES = 12


@dataclass
class _ViewerNode:
    tier: int
    points: int
    size: float
    """Size of a point in viser's messages."""
    owner: str
    passed: bool = False


class PointLimiter:
    """Relays the frames of one browser, with a limited number of points in large nodes."""

    def __init__(self, most: int) -> None:
        self._most = most
        self._nodes: dict[str, _ViewerNode] = {}
        self._finest = 0
        """The lowest tier that is relayed; it decreases again when all nodes are gone."""

    def filter_frame(self, frame: bytes) -> bytes:
        """The part of a frame of viser's socket that the browser receives."""
        content, arrays = unpack_frame(frame)
        output: list[Message] = []
        for message in content["messages"]:
            instead = self._replacements(message, arrays)
            output += instead
            if not any(one is message for one in instead):
                for index in _indices(message):
                    arrays[index] = b""
        return pack_frame({**content, "messages": output}, arrays)

    def _replacements(self, message: Message, arrays: list[bytes]) -> list[Message]:
        """What the browser receives instead."""
        kind, name = message["type"], str(message.get("name", ""))
        if kind == "PointCloudMessage" and (tier := TIER.search(name)):
            props = message["props"]
            points = len(arrays[props["points"]["__binary_index"]]) // POINT_BYTES
            owner = message.get("owner", "")
            self._nodes[name] = _ViewerNode(int(tier[1]), points, props["point_size"], owner)
            return [*self._coarsen(), *self._add_node(message, name)]
        node = self._nodes.get(name)
        if node is None:
            return [message]
        if kind == "RemoveSceneNodeMessage":
            del self._nodes[name]
            if not self._nodes:
                self._finest = 0
        elif "point_size" in message.get("updates", {}):
            node.size = message["updates"]["point_size"]
            message["updates"]["point_size"] = self._size(node)
        return [message] if node.passed else []

    def _add_node(self, message: Message, name: str) -> list[Message]:
        node = self._nodes[name]
        node.passed = node.tier >= self._finest
        message["props"]["point_size"] = self._size(node)
        return [message] if node.passed else []

    def _coarsen(self) -> list[Message]:
        """Removes tiers until the remaining points are within the limit."""
        before = self._finest
        highest = max(node.tier for node in self._nodes.values())
        while self._finest < highest and self._visible_points() > self._most:
            self._finest += 1
        if self._finest == before:
            return []
        changes: list[Message] = []
        for name, node in self._nodes.items():
            if node.passed and node.tier < self._finest:
                node.passed = False
                changes.append(_message("RemoveSceneNodeMessage", name, node))
            elif node.passed:
                updates = {"point_size": self._size(node)}
                changes.append(_message("SceneNodeUpdateMessage", name, node, updates=updates))
        return changes

    def _visible_points(self) -> int:
        return sum(node.points for node in self._nodes.values() if node.tier >= self._finest)

    def _size(self, node: _ViewerNode) -> float:
        """Factor by which the points are further apart: two tiers double the distance."""
        lowest = min(each.tier for each in self._nodes.values())
        return node.size * float(2.0 ** (max(self._finest - lowest, 0) / 2))


def _message(kind: str, name: str, node: _ViewerNode, **more: object) -> Message:
    return {"type": kind, "name": name, "owner": node.owner, **more}


def _indices(message: Message) -> list[int]:
    """Indices of the arrays to which a message refers."""
    parts = [*message.get("props", {}).values(), *message.get("updates", {}).values()]
    return [part["__binary_index"] for part in parts if isinstance(part, dict)]
