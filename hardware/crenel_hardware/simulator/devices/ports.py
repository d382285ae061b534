"""The far end of the arm's cable: a TCP port or a pseudo-terminal that a driver can open."""

import contextlib
import os
import socket
import tempfile
from pathlib import Path
from typing import Protocol

WAITING_BYTES = 16_384
"""What a client that does not read may leave waiting; more is lost to it."""


class DevicePort(Protocol):
    """One thread polls and sends; nothing blocks."""

    url: str

    def plug_in(self) -> None:
        """Makes the address reachable; idempotent."""

    def unplug(self) -> None:
        """Cuts every connection and makes the address vanish; idempotent."""

    def release(self) -> None:
        """Unplugs for good and leaves nothing behind; idempotent."""

    def poll(self) -> bytes:
        """Takes in new clients; what any of them said since."""

    def send(self, packet: bytes) -> None:
        """To every client, whole or not at all."""


class TcpPort:
    """Serves any number of clients at one port, which stays the same when plugged in again."""

    def __init__(self, host: str, port: int) -> None:
        self._host, self._port = host, port
        self._listener: socket.socket | None = None
        self._clients: dict[socket.socket, bytearray] = {}
        self.url = ""
        self.plug_in()

    def plug_in(self) -> None:
        """See ``DevicePort``; raises ``OSError`` when the port is taken."""
        if self._listener is not None:
            return
        listener = socket.socket()
        try:
            listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            listener.bind((self._host, self._port))
            listener.listen()
        except OSError:
            listener.close()
            raise
        listener.setblocking(False)
        self._listener = listener
        self._port = listener.getsockname()[1]
        self.url = f"socket://{self._host}:{self._port}"

    def unplug(self) -> None:
        if self._listener is not None:
            self._listener.close()
            self._listener = None
        for client in self._clients:
            client.close()
        self._clients.clear()

    def release(self) -> None:
        self.unplug()

    def poll(self) -> bytes:
        if self._listener is None:
            return b""
        with contextlib.suppress(OSError):  # none waits, or the process has no file left for it
            client, _ = self._listener.accept()
            client.setblocking(False)
            client.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            self._clients[client] = bytearray()
        said = b""
        for client in list(self._clients):
            try:
                data = client.recv(4096)
            except BlockingIOError:
                continue
            except OSError:
                data = b""
            if not data:
                client.close()
                del self._clients[client]
            said += data
        return said

    def send(self, packet: bytes) -> None:
        for client, waiting in self._clients.items():
            if len(waiting) <= WAITING_BYTES:
                waiting += packet
            with contextlib.suppress(OSError):
                del waiting[: client.send(waiting)]


class PtyPort:
    """A pseudo-terminal behind a path that stays the same when plugged in again."""

    def __init__(self) -> None:
        self._path = Path(tempfile.mkdtemp(prefix="crenel-arm-")) / "arm"
        self.url = str(self._path)
        self._ends: tuple[int, int] | None = None
        self._waiting = bytearray()
        self.plug_in()

    def plug_in(self) -> None:
        if self._ends is not None:
            return
        import tty

        own, other = os.openpty()
        try:
            tty.setraw(other)
            os.set_blocking(own, False)
            self._path.unlink(missing_ok=True)
            self._path.symlink_to(os.ttyname(other))
        except OSError:
            os.close(own)
            os.close(other)
            raise
        self._ends = (own, other)

    def unplug(self) -> None:
        if self._ends is None:
            return
        self._path.unlink(missing_ok=True)
        for end in self._ends:
            os.close(end)
        self._ends = None
        self._waiting.clear()

    def release(self) -> None:
        self.unplug()
        with contextlib.suppress(FileNotFoundError):
            self._path.parent.rmdir()

    def poll(self) -> bytes:
        if self._ends is None:
            return b""
        try:
            return os.read(self._ends[0], 4096)
        except OSError:
            return b""

    def send(self, packet: bytes) -> None:
        if self._ends is None:
            return
        if len(self._waiting) <= WAITING_BYTES:
            self._waiting += packet
        with contextlib.suppress(OSError):
            del self._waiting[: os.write(self._ends[0], self._waiting)]
