"""A simulated robot of Universal Robots, as a client of its Real-Time Data Exchange sees it.

Written from the RTDE guide alone; it shares no code with the driver. What the robot does is a
function of time, so that any simulated motion can be shown through it.
"""

import contextlib
import socket
import struct
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from crenel_hardware.clock import now_ns
from crenel_hardware.simulator.devices.device_thread import ThreadedDevice

Floats = NDArray[np.float64]

WAITING_BYTES = 65_536
"""What a client that does not read may leave waiting; the controller then skips packages."""
CATCH_UP_NS = 5_000_000_000
"""A server that was not scheduled for longer than this loses what it should have sent."""
MAKING_NS = 200_000_000
"""Packages are made for about so long at once; a machine with too little to spare makes the newest,
and is not silent meanwhile."""
TYPES = {
    "timestamp": "DOUBLE",
    "actual_q": "VECTOR6D",
    "actual_TCP_pose": "VECTOR6D",
    "tcp_offset": "VECTOR6D",
    "robot_mode": "INT32",
    "safety_mode": "INT32",
}
RUNNING, NORMAL = 7, 1


@dataclass(frozen=True)
class RobotState:
    """Where a robot is."""

    joints_rad: Floats
    """(6,) joint angles."""
    T_base_flange: Floats
    """(4, 4), mm."""


@dataclass
class RtdeFaults:
    """What goes wrong on purpose; set at any time, from any thread."""

    unplugged: bool = False
    """No connection is accepted, and those that exist are cut."""
    silent: bool = False
    """Connections stay, and no data package is sent."""
    skip: int = 0
    """So many of the next data packages are not sent."""
    robot_mode: int = RUNNING
    unknown: frozenset[str] = frozenset()
    """Variables that this controller does not know."""
    refuses_protocol: bool = False
    refuses_start: bool = False
    clock_offset_s: float = 0.0
    """The controller's clock is off by this from now on."""
    spoil: Callable[[bytes], bytes] = field(default=lambda package: package)
    """Changes a data package before it is sent."""


class RtdeServer(ThreadedDevice):
    """Serves any number of clients on a thread of its own between ``start`` and ``stop``.

    Args:
        state_at: the robot at a host-monotonic time in ns.
        host: address to listen at.
        port: 0 takes any free one.
        tool_offset: the active tool in the flange frame, x, y, z in metres and a rotation vector.
        version: major, minor, bugfix and build of the controller's software.

    ``port`` is the port it listens at, ``contacts`` counts the packages that clients sent.
    """

    def __init__(
        self,
        state_at: Callable[[int], RobotState],
        host: str = "127.0.0.1",
        port: int = 0,
        tool_offset: tuple[float, ...] = (0.0,) * 6,
        version: tuple[int, int, int, int] = (5, 12, 0, 0),
    ) -> None:
        self.tool_offset, self.version = tool_offset, version
        self.faults = RtdeFaults()
        self.contacts = 0
        self._state_at = state_at
        self._host, self.port = host, port
        self._listener: socket.socket | None = None
        self._clients: list[_Client] = []
        self._born_ns = now_ns() - 77_000_000_000
        self._said: list[bytes] = []
        self._cost_ns = 1.0
        super().__init__("simulated-robot")
        self._plug_in()

    def _release(self) -> None:
        self._unplug()

    def say(self, text: str, source: str = "RTDE") -> None:
        """Sends a text message to every client."""
        payload = b"".join(bytes([len(one)]) + one for one in (text.encode(), source.encode()))
        self._said.append(_package(77, payload + b"\x02"))

    def values_at(self, at_ns: int) -> dict[str, tuple[float, ...]]:
        """Every variable of the robot at a host-monotonic time."""
        state = self._state_at(at_ns)
        T_flange_tool = np.eye(4)
        T_flange_tool[:3, 3] = np.multiply(self.tool_offset[:3], 1000.0)
        T_flange_tool[:3, :3] = Rotation.from_rotvec(self.tool_offset[3:]).as_matrix()
        T = state.T_base_flange @ T_flange_tool
        pose = (*(T[:3, 3] / 1000.0), *Rotation.from_matrix(T[:3, :3]).as_rotvec())
        return {
            "timestamp": ((at_ns - self._born_ns) / 1e9 + self.faults.clock_offset_s,),
            "actual_q": tuple(state.joints_rad.tolist()),
            "actual_TCP_pose": tuple(float(value) for value in pose),
            "tcp_offset": self.tool_offset,
            "robot_mode": (self.faults.robot_mode,),
            "safety_mode": (NORMAL,),
        }

    def _serve(self) -> None:
        if self.faults.unplugged:
            self._unplug()
            return
        self._plug_in()
        self._accept()
        said, self._said = self._said, []
        for client in list(self._clients):
            try:
                self._talk(client, b"".join(said))
            except OSError:
                client.connection.close()
                self._clients.remove(client)

    def _plug_in(self) -> None:
        if self._listener is None:
            self._listener = socket.create_server((self._host, self.port))
            self._listener.setblocking(False)
            self.port = self._listener.getsockname()[1]

    def _unplug(self) -> None:
        for client in self._clients:
            client.connection.close()
        self._clients.clear()
        if self._listener is not None:
            self._listener.close()
            self._listener = None

    def _accept(self) -> None:
        assert self._listener is not None
        with contextlib.suppress(OSError):  # none waits, or the process has no file left for it
            connection, _ = self._listener.accept()
            connection.setblocking(False)
            connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            self._clients.append(_Client(connection))

    def _talk(self, client: "_Client", said: bytes) -> None:
        for kind, payload in client.requests():
            self.contacts += 1
            client.outbox += self._answer(client, kind, payload)
        client.outbox += said
        if client.started:
            client.outbox += self._data(client)
        client.flush()

    def _answer(self, client: "_Client", kind: int, payload: bytes) -> bytes:
        match kind:
            case 86:  # protocol version
                fits = payload == b"\x00\x02" and not self.faults.refuses_protocol
                return _package(kind, bytes([fits]))
            case 118:  # version of the controller's software
                return _package(kind, struct.pack(">4I", *self.version))
            case 79:  # set-up of outputs
                client.rate_hz = float(struct.unpack_from(">d", payload)[0])
                client.names = payload[8:].decode().rstrip(",").split(",")
                types = [self._type(name) for name in client.names]
                return _package(kind, b"\x01" + ",".join(types).encode())
            case 83:  # start
                client.started = not self.faults.refuses_start
                client.start_ns, client.taken = now_ns(), 0
                return _package(kind, bytes([client.started]))
            case 80:  # pause
                client.started = False
                return _package(kind, b"\x01")
        return b""

    def _type(self, name: str) -> str:
        return "NOT_FOUND" if name in self.faults.unknown else TYPES.get(name, "NOT_FOUND")

    def _data(self, client: "_Client") -> bytes:
        period_ns, now = 1e9 / client.rate_hz, now_ns()
        due = int((now - client.start_ns) / period_ns) + 1
        if now - client.start_ns - client.taken * period_ns > CATCH_UP_NS:
            client.taken = due - 1
        affordable = max(int(MAKING_NS / self._cost_ns), 1)
        made, first = b"", max(client.taken, due - affordable)
        for number in range(first, due):
            if self.faults.skip:
                self.faults.skip -= 1
            elif not self.faults.silent and len(client.outbox) < WAITING_BYTES:
                values = self.values_at(client.start_ns + round(number * period_ns))
                made += self.faults.spoil(_data_package(client.names, values))
        client.taken = due
        if due > first:
            self._cost_ns = max((now_ns() - now) / (due - first), 1.0)
        return made


class _Client:
    """One connection."""

    def __init__(self, connection: socket.socket) -> None:
        self.connection = connection
        self.rate_hz, self.names, self.started = 125.0, list[str](), False
        self.start_ns, self.taken = 0, 0
        self.outbox = b""
        self._inbox = b""

    def requests(self) -> list[tuple[int, bytes]]:
        """Type and payload of each package that arrived; raises ``OSError`` at the end."""
        with contextlib.suppress(BlockingIOError):
            data = self.connection.recv(4096)
            if not data:
                raise ConnectionResetError
            self._inbox += data
        found = []
        while len(self._inbox) >= 3 and len(self._inbox) >= (size := _size(self._inbox)):
            found.append((self._inbox[2], self._inbox[3:size]))
            self._inbox = self._inbox[size:]
        return found

    def flush(self) -> None:
        """Sends as much as the connection takes."""
        with contextlib.suppress(BlockingIOError):
            self.outbox = self.outbox[self.connection.send(self.outbox) :]


def _size(inbox: bytes) -> int:
    return max(3, int.from_bytes(inbox[:2], "big"))


def _package(kind: int, payload: bytes) -> bytes:
    return struct.pack(">HB", 3 + len(payload), kind) + payload


def _data_package(names: list[str], values: dict[str, tuple[float, ...]]) -> bytes:
    payload = b"\x01"
    for name in names:
        layout = {"DOUBLE": ">d", "VECTOR6D": ">6d", "INT32": ">i"}[TYPES[name]]
        payload += struct.pack(layout, *values[name])
    return _package(85, payload)
