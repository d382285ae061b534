"""Reads the register that says which program controls a GigE Vision camera.

Source:
    AIA, GigE Vision 2.0, sections 14 (errors), 17.1 (READREG), 28.4 (control channel privilege).
"""

import socket
import struct
from itertools import count

_GVCP_PORT = 3956
_KEY, _ACKNOWLEDGE = 0x42, 0x01
_READ_REGISTER, _READ_REGISTER_ACK = 0x0080, 0x0081
_CONTROL_REGISTER = 0x0A00
_EXCLUSIVE, _CONTROLLED = 0b01, 0b11
_TRIES, _TRY_S = 3, 0.15
_PATIENT_TRIES = 5


class ControlRegister:
    """The register, read through a socket of its own: any program may ask a camera for it.

    Aravis waits up to 3 s for an answer; this knows after half a second.
    """

    def __init__(self, address: str) -> None:
        self._requests = count(1)
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.settimeout(_TRY_S)
        try:
            self._socket.connect((address, _GVCP_PORT))
        except OSError:
            self._socket.close()
            raise

    def read(self, tries: int = _TRIES) -> int | None:
        """The value, not 0 while a program controls the camera; None if nothing answers.

        A camera that refuses to answer is controlled by a program that lets no other read it.
        """
        requests: set[int] = set()
        for _ in range(tries):
            request = next(self._requests) % 0xFFFF + 1
            requests.add(request)
            head = (_KEY, _ACKNOWLEDGE, _READ_REGISTER, 4, request, _CONTROL_REGISTER)
            try:
                self._socket.send(struct.pack(">BBHHHI", *head))
                while True:
                    # a slow camera answers the first request during the second try
                    value = _value(self._socket.recv(64), requests)
                    if value is not None:
                        return value & _CONTROLLED
            except OSError:  # no answer in time, or the system knows that nobody is there
                continue
        return None

    def close(self) -> None:
        self._socket.close()


def _value(answer: bytes, requests: set[int]) -> int | None:
    """The value in the answer to one of the requests; None of another packet."""
    if len(answer) < 8:
        return None
    status, command, _, of = struct.unpack_from(">HHHH", answer)
    if command != _READ_REGISTER_ACK or of not in requests:
        return None
    if status != 0:  # the answer has no value
        return _EXCLUSIVE
    return int.from_bytes(answer[8:12], "big") if len(answer) >= 12 else None


def read_control(address: str) -> int | None:
    """The register of the camera at an address, as of ``ControlRegister.read``.

    It waits up to 0.8 s: a camera that was just plugged in, or whose line is busy, answers late.

    Raises ``socket.gaierror`` for what is neither an IP address nor the name of a host.
    """
    try:
        register = ControlRegister(address)
    except socket.gaierror:
        raise
    except OSError:  # no network
        return None
    try:
        return register.read(_PATIENT_TRIES)
    finally:
        register.close()
