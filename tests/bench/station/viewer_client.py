"""A viewer of the 3D view that reads its socket and keeps the time, in its own process."""

import contextlib
import multiprocessing
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from multiprocessing.connection import Connection
from typing import Any

import msgspec
import numpy as np
import viser
import zstandard
from websockets.sync.client import connect
from websockets.typing import Subprotocol

from crenel.metrology.transforms import Floats
from tests.bench.station.subprocess_station import stuck_error

PROTOCOL = Subprotocol(f"viser-v{viser.__version__}")
PATIENCE_S = 120.0
POLL_S = 0.05
CLOUD = "/cloud"


@dataclass(frozen=True)
class ViewerReport:
    """What came: the age (s) of the oldest new point of each update, and when all was there."""

    ages_s: Floats
    complete_s: float
    bytes: int
    coloured_at_s: float
    """By the monotonic clock; NaN where so many points were not given other colours."""


@contextlib.contextmanager
def watch_view(
    address: str,
    signed_in: Mapping[str, str],
    start_ns: int,
    turn_rad_s: float,
    until_whole: bool = False,
    coloured: int = 0,
) -> Iterator[Callable[[], ViewerReport]]:
    """A viewer from now on. What it yields ends it, and returns what it saw.

    Args:
        signed_in: the header of a browser that is signed in.
        start_ns, turn_rad_s: of the sweep: a point's azimuth shows when it was taken.
        until_whole: it ends by itself once it has all that was shown before it came.
        coloured: it ends by itself once so many points were given other colours.
    """
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe()
    arguments = (theirs, address, signed_in, start_ns, turn_rad_s, until_whole, coloured)
    process = context.Process(target=_watch, args=arguments, daemon=True)
    process.start()
    theirs.close()
    if not ours.poll(PATIENCE_S):
        raise stuck_error("the viewer does not connect")
    ours.recv()

    def watched() -> ViewerReport:
        if not (until_whole or coloured):
            ours.send("enough")
        if not ours.poll(PATIENCE_S):
            raise stuck_error("the viewer did not get the whole picture")
        found: ViewerReport = ours.recv()
        return found

    try:
        yield watched
    finally:
        process.kill()
        process.join()


def _watch(
    pipe: Connection,
    address: str,
    signed_in: Mapping[str, str],
    start_ns: int,
    turn_rad_s: float,
    until_whole: bool,
    coloured: int,
) -> None:
    pipe.send("ready")
    began_s = time.monotonic()
    seen = _PointAges(start_ns, turn_rad_s, coloured)
    with connect(
        address,
        additional_headers=signed_in,
        subprotocols=[PROTOCOL],
        max_size=None,
        compression=None,
    ) as socket:
        while not (pipe.poll() or (until_whole and seen.complete) or seen.coloured_at_s):
            with contextlib.suppress(TimeoutError):
                data = socket.recv(POLL_S)
                seen.take(time.monotonic_ns(), bytes(data) if isinstance(data, bytes) else b"")
        # closing waits for the station, up to ten seconds where much is on its way
        whole_s = time.monotonic() - began_s
    pipe.send(
        ViewerReport(np.array(seen.ages_s), whole_s, seen.bytes, seen.coloured_at_s or float("nan"))
    )


class _PointAges:
    """How old new points were when they came, and whether all the old ones have come."""

    def __init__(self, start_ns: int, turn_rad_s: float, coloured: int) -> None:
        self.ages_s: list[float] = []
        self.complete = False
        """All that was shown before it came is there."""
        self.bytes = 0
        self.coloured_at_s = 0.0
        self._uncoloured = coloured
        self._start_ns, self._turn_rad_s = start_ns, turn_rad_s
        self._origin_m = np.zeros(3)
        self._newest_rad = -np.inf

    def take(self, now_ns: int, data: bytes) -> None:
        self.bytes += len(data)
        for message in _messages(data):
            name = str(message.get("name", ""))
            if message["type"] == "ReplayDoneMessage":
                self.complete = True
            elif message["type"] == "SetPositionMessage" and name == CLOUD:
                self._origin_m = np.array(message["position"])
            elif message["type"] == "PointCloudMessage" and name.startswith(CLOUD):
                points = np.frombuffer(message["props"]["points"], np.float32).reshape(-1, 3)
                self._note(now_ns, points + self._origin_m)
            elif (
                self.complete and name.startswith(CLOUD) and "colors" in message.get("updates", ())
            ):
                self._note_colours(len(message["updates"]["colors"]) // 3)

    def _note_colours(self, points: int) -> None:
        left = self._uncoloured
        self._uncoloured -= points
        if left > 0 >= self._uncoloured:
            self.coloured_at_s = time.monotonic()

    def _note(self, now_ns: int, points_m: Floats) -> None:
        azimuth = np.arctan2(points_m[:, 1], points_m[:, 0])
        new = azimuth[azimuth > self._newest_rad]
        if not len(new):
            return
        taken_ns = self._start_ns + (float(new.min()) + np.pi) / self._turn_rad_s * 1e9
        if np.isfinite(self._newest_rad):
            self.ages_s.append((now_ns - taken_ns) / 1e9)
        self._newest_rad = float(new.max())


def _messages(data: bytes) -> list[dict[str, Any]]:
    """What is in one frame of viser's socket: packed messages, then their arrays."""
    packed_bytes = int.from_bytes(data[8:16], "little")
    inner = zstandard.ZstdDecompressor().decompress(
        data[16 : 16 + packed_bytes], int.from_bytes(data[:8], "little")
    )
    frame = msgspec.msgpack.decode(inner)
    at, arrays = 16 + packed_bytes, []
    for length in frame["binaryBufferLengths"]:
        at += -at % 8
        arrays.append(data[at : at + length])
        at += length
    for message in frame["messages"]:
        for part in (message.get("props", {}), message.get("updates", {})):
            for key, value in part.items():
                if isinstance(value, dict) and "__binary_index" in value:
                    part[key] = arrays[value["__binary_index"]]
    return list(frame["messages"])
