"""A browser's side of the 3D view: keeps the scene's nodes as the server sends them."""

import contextlib
from collections.abc import Callable, Iterator
from typing import Any

import msgspec
import numpy as np
import pytest
import zstandard
from websockets.sync.client import connect

from crenel.station.view3d.scene import Scene
from tests.bench.station.viewer_client import PROTOCOL

DTYPES = {"<f4": np.float32, "<u4": np.uint32, "|u1": np.uint8}


class Viewer:
    def __init__(self, scene: Scene, through: Callable[[bytes], bytes] = bytes) -> None:
        self._through = through
        self.nodes: dict[str, dict[str, Any]] = {}
        self.messages: dict[str, dict[str, Any]] = {}
        """The last message of each kind that is about no node."""
        self._socket = connect(
            f"ws://127.0.0.1:{scene.port}",
            additional_headers=scene.key,
            subprotocols=[PROTOCOL],
            max_size=None,
            compression=None,
        )
        self.pose_camera((3, 3, 3), (0, 0, 0))

    def close(self) -> None:
        self._socket.close()

    def pose_camera(self, position: Any, look_at: Any) -> None:
        """Sends where the user looks from, as a browser does at its start and when it moves."""
        message = {
            "type": "ViewerCameraMessage",
            "wxyz": (1.0, 0.0, 0.0, 0.0),
            "position": [float(x) for x in position],
            "look_at": [float(x) for x in look_at],
            "up_direction": (0.0, 0.0, 1.0),
            "fov": 0.7,
            "near": 0.01,
            "far": 50.0,
            "image_height": 750,
            "image_width": 1100,
        }
        self._socket.send(msgspec.msgpack.encode(message))

    def listen(self, quiet_s: float = 0.3) -> "Viewer":
        """Takes what comes, until nothing has come for a while."""
        with contextlib.suppress(TimeoutError):
            while True:
                packet = self._socket.recv(timeout=quiet_s)
                assert isinstance(packet, bytes)
                for message in unpack(self._through(packet)):
                    self._take(message)
        return self

    def _take(self, message: dict[str, Any]) -> None:
        kind, name = message["type"], message.get("name")
        if name is None:
            self.messages[kind] = message
        elif kind == "RemoveSceneNodeMessage":
            for node in [node for node in self.nodes if f"{node}/".startswith(f"{name}/")]:
                del self.nodes[node]
        elif kind == "SceneNodeUpdateMessage":
            self.nodes[name]["props"] |= message["updates"]
        elif "props" in message:
            self.nodes[name] = message
        elif name in self.nodes:
            self.nodes[name][kind] = message

    def position_mm(self, name: str) -> np.ndarray:
        """Where a node is in its parent; the origin unless sent."""
        reported = self.nodes[name].get("SetPositionMessage", {"position": (0.0, 0.0, 0.0)})
        return 1e3 * np.array(reported["position"])

    def wxyz(self, name: str) -> np.ndarray:
        reported = self.nodes[name].get("SetOrientationMessage", {"wxyz": (1.0, 0.0, 0.0, 0.0)})
        return np.array(reported["wxyz"])

    def clouds(self) -> dict[str, np.ndarray]:
        """Points (N, 3) of each node of the cloud, in mm of the arm frame."""
        origin = self.position_mm("/cloud") if "/cloud" in self.nodes else 0.0
        return {
            name: 1e3 * node["props"]["points"].reshape(-1, 3).astype(float) + origin
            for name, node in self.nodes.items()
            if name.startswith("/cloud/")
        }


@pytest.fixture
def viewer(scene: Scene) -> Iterator[Viewer]:
    with contextlib.closing(Viewer(scene)) as connected:
        yield connected


def unpack(packet: bytes) -> list[dict[str, Any]]:
    """The messages of a packet: zstd-compressed msgpack, then its arrays, 8-byte aligned."""
    compressed = int.from_bytes(packet[8:16], "little")
    body = zstandard.ZstdDecompressor().decompress(packet[16 : 16 + compressed])
    window = msgspec.msgpack.decode(body)
    arrays, at = [], 16 + compressed
    for length in window["binaryBufferLengths"]:
        at += -at % 8
        arrays.append(packet[at : at + length])
        at += length

    def filled(value: Any) -> Any:
        if isinstance(value, dict):
            if "__binary_index" in value:
                return np.frombuffer(arrays[value["__binary_index"]], DTYPES[value["dtype"]])
            return {key: filled(each) for key, each in value.items()}
        return [filled(each) for each in value] if isinstance(value, list) else value

    return [filled(message) for message in window["messages"]]
