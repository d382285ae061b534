"""A byte stream to an arm, over a serial port or the network.

pyserial's own blocking read returns late (it waits for a full buffer or the timeout) and cannot be
interrupted on every kind of port. If a port has a file descriptor, this module waits on it and
reads without blocking; otherwise (Windows COM ports, ``rfc2217://``) it reads in short intervals.
"""

import contextlib
import errno
import os
import re
import selectors
import socket
import threading
import time
from typing import Protocol, cast

import serial
from serial.tools import list_ports

from crenel.messages.message import Text, join, message
from crenel_hardware.errors import DeviceError

_SLICE_S = 0.05
_CHUNK = 65536
_HOST_AND_PORT = re.compile(r"[\w.-]+:\d{1,5}")
_NETWORK = re.compile(
    r"(socket|rfc2217)://([\w.-]+|\[[\da-f:.]+(%\w+)?\]):\d{1,5}/?(\?[\w=&.]*)?", re.IGNORECASE
)
_COM = re.compile(r"(\\\\\.\\)?COM\d{1,3}", re.IGNORECASE)


class _Port(Protocol):
    timeout: float
    in_waiting: int

    def fileno(self) -> int: ...
    def read(self, size: int) -> bytes: ...
    def write(self, data: bytes) -> int: ...
    def close(self) -> None: ...


class Wire:
    """An open port. One thread reads; ``send`` and ``close`` may come from any other.

    Args:
        url: a device path, a COM port, ``socket://`` or ``rfc2217://``.
        baudrate: for ports that have one.

    Raises:
        DeviceError: if the port cannot be opened, with the reason.
    """

    def __init__(self, url: str, baudrate: int) -> None:
        self._url = url
        self._port = _open_port(url, baudrate)
        self._closed = False
        self._in_use = threading.Lock()
        self._sending = threading.Lock()
        self._wake, self._woken = socket.socketpair()
        self._selector = self._make_selector()

    def receive(self, timeout_s: float) -> bytes:
        """Received bytes, after waiting for the first one; empty after ``timeout_s``.

        Raises ``DeviceError`` if the line is lost or was closed in the meantime.
        """
        with self._in_use:
            if self._closed:
                raise self._line_closed_error()
            try:
                data = self._receive(timeout_s)
            except (OSError, ValueError, TypeError) as error:
                raise DeviceError(self._loss_text(error), message("check-cable-power")) from error
        if not data and self._closed:
            raise self._line_closed_error()
        return data

    def send(self, data: bytes) -> None:
        """Writes to the port, also while another thread reads; raises ``DeviceError`` if it is
        lost."""
        with self._sending:
            if self._closed:
                raise self._line_closed_error()
            try:
                self._port.write(data)
            except serial.SerialTimeoutException:
                pass  # an arm that cannot receive still sends
            except (OSError, ValueError, TypeError) as error:
                raise DeviceError(
                    message("nothing-can-be-sent-to-arm", url=self._url, reason=_reason(error)),
                    message("check-cable-power"),
                ) from error

    def close(self) -> None:
        """Releases the port and ends a waiting ``receive``; idempotent."""
        self._closed = True
        with contextlib.suppress(OSError):
            self._wake.send(b"x")
        with self._in_use, self._sending:
            if self._wake.fileno() < 0:
                return
            if self._selector is not None:
                self._selector.close()
            self._wake.close()
            self._woken.close()
            with contextlib.suppress(OSError):
                self._port.close()

    def _make_selector(self) -> selectors.BaseSelector | None:
        try:
            descriptor = self._port.fileno()
        except (AttributeError, OSError):
            return None
        self._port.timeout = 0
        selector = selectors.DefaultSelector()
        selector.register(descriptor, selectors.EVENT_READ)
        selector.register(self._woken, selectors.EVENT_READ)
        return selector

    def _receive(self, timeout_s: float) -> bytes:
        if self._selector is not None:
            ready = self._selector.select(max(0.0, timeout_s))
            if not ready or self._closed:
                return b""
            return self._port.read(_CHUNK)
        deadline = time.monotonic() + timeout_s
        while True:
            data = self._port.read(max(1, self._port.in_waiting))
            if data or self._closed or time.monotonic() >= deadline:
                return data

    def _loss_text(self, error: Exception) -> Text:
        """With the system's reason; pyserial's own says no more than that the line is gone."""
        if isinstance(error, serial.SerialException) and error.errno is None:
            return message("line-to-arm-gone", url=self._url)
        return message("line-to-arm-lost", url=self._url, reason=_reason(error))

    def _line_closed_error(self) -> DeviceError:
        return DeviceError(message("line-to-arm-closed", url=self._url))


def _check_address(url: str) -> None:
    """Raises ``DeviceError`` unless the url is the address of a device.

    pyserial has further kinds; one of them, ``spy://``, writes to a file that its url names.
    """
    if _NETWORK.fullmatch(url) or _COM.fullmatch(url):
        return
    if "://" in url or not url.isprintable():
        remedy = join([message("check-arm-url"), message("enter-device-address")], " ")
        raise DeviceError(_not_opened_text(url, message("it-is-no-device")), remedy)
    # a link to a device may lie elsewhere
    if not os.path.realpath(url).startswith("/dev/"):
        if os.path.lexists(url):
            raise DeviceError(_not_opened_text(url, message("it-is-no-device")), _list_ports_text())
        raise _no_port_error(url)


def _open_port(url: str, baudrate: int) -> _Port:
    _check_address(url)
    # pyserial's RFC 2217 client refuses a write timeout; only short requests are written.
    write_timeout = None if url.lower().startswith("rfc2217:") else 1.0
    try:
        port = serial.serial_for_url(
            url, baudrate=baudrate, timeout=_SLICE_S, write_timeout=write_timeout, exclusive=True
        )
    except (OSError, ValueError, OverflowError) as error:
        raise _open_error(url, error) from error
    # FTDI converters buffer bytes for 16 ms by default; other ports have no such mode.
    with contextlib.suppress(AttributeError, NotImplementedError, ValueError, OSError):
        port.set_low_latency_mode(True)
    return cast(_Port, port)


def _open_error(url: str, error: Exception) -> DeviceError:
    cause = error.__context__ if isinstance(error.__context__, OSError) else error
    number = getattr(error, "errno", None) or getattr(cause, "errno", None)
    text = str(error)
    if isinstance(cause, socket.gaierror):
        return DeviceError(message("host-not-known", url=url), message("check-arm-url"))
    if number == errno.ENOENT or "FileNotFoundError" in text:
        return _no_port_error(url)
    if number in (errno.EAGAIN, errno.EBUSY):
        return DeviceError(
            message("serial-port-use-another-program", url=url),
            message("close-program-second-station-same-port"),
        )
    if number in (errno.EACCES, errno.EPERM) or "PermissionError" in text:
        return DeviceError(
            message("user-may-not-open-serial-port", url=url),
            message("linux-add-user-group-owns-port"),
        )
    if number == errno.ECONNREFUSED:
        return DeviceError(message("nothing-listens", url=url), message("arms-adapter-running"))
    if isinstance(cause, TimeoutError) or number in (errno.EHOSTUNREACH, errno.ENETUNREACH):
        return DeviceError(message("no-answer-from", url=url), message("check-address-network"))
    remedy = message("check-arm-url") if "://" in url else _list_ports_text()
    return DeviceError(_not_opened_text(url, _reason(error)), remedy)


def _not_opened_text(url: str, reason: Text) -> Text:
    return message("arm-url-cannot-be-opened", url=url, reason=reason)


def _no_port_error(url: str) -> DeviceError:
    remedy = _list_ports_text()
    if _HOST_AND_PORT.fullmatch(url):
        remedy = message("enter-network-address-as", url=f"socket://{url}")
    return DeviceError(message("no-serial-port-named", url=url), remedy)


def _list_ports_text() -> Text:
    names = sorted(port.device for port in list_ports.comports())
    if not names:
        return message("no-serial-port-plugged")
    return message("ports-are", names=", ".join(names))


def _reason(error: Exception) -> str:
    return str(error) or type(error).__name__
