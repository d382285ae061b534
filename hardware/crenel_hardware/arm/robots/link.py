"""Network links to a controller: a TCP stream or datagrams, with a wait that ``close`` ends."""

import contextlib
import errno
import selectors
import socket
import threading

from crenel.messages.message import message
from crenel_hardware.errors import DeviceError

_CHUNK = 65536
_RECEIVE_BUFFER = 1 << 20


class ControllerLink:
    """A socket, opened by one of ``connect_tcp``, ``connect_udp`` and ``listen_udp``.

    One thread receives; ``close`` may come from any other.

    Args:
        address: host name or IP address of the controller.
    """

    def __init__(self, address: str) -> None:
        self.address = address
        self._lock = threading.Lock()
        self._closed = False
        self._socket: socket.socket | None = None
        self._peer = ""
        self._target = ""
        self.other_sender = ""
        """Who sent the newest datagram that came from elsewhere; empty if none did."""
        self._wake, self._woken = socket.socketpair()

    def connect_tcp(self, port: int, timeout_s: float) -> None:
        """Raises ``DeviceError`` with the reason if the controller does not accept."""
        try:
            connection = socket.create_connection((self.address, port), timeout_s)
        except OSError as error:
            raise self._connect_error(port, error) from error
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._adopt(connection)

    def connect_udp(self, port: int) -> None:
        """Datagrams go to and come from this port of the controller alone."""
        host = self._resolve(port)
        self._target = f"{self.address}:{port}"
        made = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        try:
            made.connect((host, port))
        except OSError as error:
            made.close()
            raise self._connect_error(port, error) from error
        self._adopt(made)

    def listen_udp(self, port: int) -> None:
        """Hears what the controller sends to this port of this computer."""
        self._peer = self._resolve(port)
        made = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        try:
            made.bind(("", port))
        except OSError as error:
            made.close()
            if error.errno == errno.EADDRINUSE:
                raise DeviceError(
                    message("udp-port-in-use", port=str(port)), message("close-program-with-port")
                ) from error
            raise DeviceError(
                message("udp-port-cannot-be-opened", port=str(port), reason=_reason(error)),
                message("choose-another-port"),
            ) from error
        self._adopt(made)

    def receive(self, timeout_s: float) -> list[bytes]:
        """What has arrived, after waiting for the first of it: one piece of a stream or every
        datagram; empty after ``timeout_s``.

        Raises ``DeviceError`` if the controller closed the connection, or ``close`` was called.
        """
        with self._lock:
            if self._closed or self._socket is None:
                raise self._link_closed_error()
            with selectors.DefaultSelector() as selector:
                selector.register(self._socket, selectors.EVENT_READ)
                selector.register(self._woken, selectors.EVENT_READ)
                selector.select(max(0.0, timeout_s))
            if self._closed:
                raise self._link_closed_error()
            try:
                if self._socket.type == socket.SOCK_STREAM:
                    return self._receive_stream(self._socket)
                return self._receive_datagrams(self._socket)
            except OSError as error:
                raise self._link_lost_error(error) from error

    def send(self, data: bytes) -> None:
        """Raises ``DeviceError`` if the connection is lost."""
        with self._lock:
            if self._closed or self._socket is None:
                raise self._link_closed_error()
            try:
                self._socket.sendall(data)
            except OSError as error:
                raise self._link_lost_error(error) from error

    def close(self, farewell: bytes = b"") -> None:
        """Ends a waiting ``receive``, and sends ``farewell`` first if it is open; idempotent."""
        self._closed = True
        with contextlib.suppress(OSError):
            self._wake.send(b"x")
        with self._lock:
            if farewell and self._socket is not None:
                with contextlib.suppress(OSError):
                    self._socket.send(farewell)
            for end in (self._socket, self._wake, self._woken):
                if end is not None:
                    end.close()

    def _receive_stream(self, connection: socket.socket) -> list[bytes]:
        try:
            data = connection.recv(_CHUNK)
        except BlockingIOError:
            return []
        if not data:
            raise DeviceError(
                message("robot-closed-connection", address=self.address),
                message("check-robot-on-and-not-too-many-clients"),
            )
        return [data]

    def _receive_datagrams(self, made: socket.socket) -> list[bytes]:
        found: list[bytes] = []
        with contextlib.suppress(BlockingIOError):
            while True:
                data, (sender, _) = made.recvfrom(_CHUNK)
                if self._peer in ("", sender):
                    found.append(data)
                else:
                    self.other_sender = sender
        return found

    def _adopt(self, made: socket.socket) -> None:
        made.setblocking(False)
        with contextlib.suppress(OSError):
            made.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, _RECEIVE_BUFFER)
        with self._lock:
            if self._closed:
                made.close()
                raise self._link_closed_error()
            self._socket = made

    def _resolve(self, port: int) -> str:
        try:
            return socket.gethostbyname(self.address)
        except OSError as error:
            raise self._connect_error(port, error) from error

    def _connect_error(self, port: int, error: OSError) -> DeviceError:
        where = f"{self.address}:{port}"
        if isinstance(error, socket.gaierror):
            return DeviceError(
                message("robot-host-not-known", address=self.address),
                message("correct-option", key="address"),
            )
        if error.errno == errno.ECONNREFUSED:
            return DeviceError(
                message("robot-no-program-listens", where=where), message("check-robot-interface")
            )
        if isinstance(error, TimeoutError) or error.errno in (
            errno.EHOSTUNREACH,
            errno.ENETUNREACH,
        ):
            return DeviceError(
                message("robot-does-not-answer", where=where), message("check-robot-network")
            )
        return DeviceError(
            message("robot-cannot-be-reached", where=where, reason=_reason(error)),
            message("check-robot-network"),
        )

    def _link_closed_error(self) -> DeviceError:
        return DeviceError(message("robot-link-closed", address=self.address))

    def _link_lost_error(self, error: OSError) -> DeviceError:
        if error.errno == errno.ECONNREFUSED:  # the answer to a datagram
            return DeviceError(
                message("robot-no-program-listens", where=self._target),
                message("check-robot-interface"),
            )
        return DeviceError(
            message("robot-link-lost", address=self.address, reason=_reason(error)),
            message("check-robot-network"),
        )


def _reason(error: OSError) -> str:
    return error.strerror or str(error) or type(error).__name__
