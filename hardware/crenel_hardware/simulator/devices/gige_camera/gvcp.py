"""Packets of the GigE Vision control protocol, as a camera reads and answers them.

Source:
    AIA, GigE Vision 2.0, sections 13 to 19 (control protocol) and 21 (status codes).
"""

import struct
from dataclasses import dataclass
from enum import IntEnum

PORT = 3956
"""Fixed by the standard."""
KEY = 0x42
MOST_BYTES = 540
"""The most that a control packet carries after its header."""
_HEAD = struct.Struct(">BBHHH")
_ACKNOWLEDGE = 0x01


class GvcpCommand(IntEnum):
    """Requests; the number of an answer is one higher."""

    DISCOVERY = 0x0002
    PACKET_RESEND = 0x0040
    READ_REGISTER = 0x0080
    WRITE_REGISTER = 0x0082
    READ_MEMORY = 0x0084
    WRITE_MEMORY = 0x0086


class Status(IntEnum):
    """How a request ended."""

    SUCCESS = 0x0000
    NOT_IMPLEMENTED = 0x8001
    INVALID_PARAMETER = 0x8002
    INVALID_ADDRESS = 0x8003
    WRITE_PROTECT = 0x8004
    BAD_ALIGNMENT = 0x8005
    ACCESS_DENIED = 0x8006


class RefusalError(Exception):
    """A request that the camera does not fulfil."""

    def __init__(self, status: Status) -> None:
        super().__init__(status.name)
        self.status = status


@dataclass(frozen=True, slots=True)
class Request:
    """One request of a client."""

    command: int
    number: int
    """Chosen by the client, returned in the answer; never 0."""
    wants_answer: bool
    payload: bytes


def parse(datagram: bytes) -> Request | None:
    """The request in a datagram; None if it is not one."""
    if len(datagram) < _HEAD.size:
        return None
    key, flags, command, length, number = _HEAD.unpack_from(datagram)
    payload = datagram[_HEAD.size :]
    if key != KEY or number == 0 or length > MOST_BYTES or len(payload) < length:
        return None
    return Request(command, number, bool(flags & _ACKNOWLEDGE), payload[:length])


def answer(request: Request, payload: bytes = b"", status: Status = Status.SUCCESS) -> bytes:
    """The datagram that answers a request."""
    head = struct.pack(">HHHH", status, request.command + 1, len(payload), request.number)
    return head + payload


def addresses(payload: bytes) -> list[int]:
    """The addresses that READREG asks for; raises ``RefusalError``."""
    return [address for (address,) in struct.iter_unpack(">I", _whole(payload, 4))]


def assignments(payload: bytes) -> list[tuple[int, bytes]]:
    """Addresses and values (4 bytes) of WRITEREG; raises ``RefusalError``."""
    return list(struct.iter_unpack(">I4s", _whole(payload, 8)))


def memory_range(payload: bytes) -> tuple[int, int]:
    """Address and number of bytes of READMEM; raises ``RefusalError``."""
    if len(payload) != 8:
        raise RefusalError(Status.INVALID_PARAMETER)
    address, count = struct.unpack(">IxxH", payload)
    if not 0 < count <= MOST_BYTES - 4 or count % 4:
        raise RefusalError(Status.BAD_ALIGNMENT)
    return address, count


def memory_write(payload: bytes) -> tuple[int, bytes]:
    """Address and bytes of WRITEMEM; raises ``RefusalError``."""
    if len(payload) < 8 or len(payload) % 4:
        raise RefusalError(Status.BAD_ALIGNMENT)
    return int.from_bytes(payload[:4], "big"), payload[4:]


def resend_range(payload: bytes) -> tuple[int, int, int]:
    """Block id, first and last packet of PACKETRESEND; raises ``RefusalError``."""
    if len(payload) < 12:
        raise RefusalError(Status.INVALID_PARAMETER)
    if len(payload) == 20:  # of a block id of 64 bits
        first, last, block_id = struct.unpack_from(">IIQ", payload, 4)
        return block_id, first, last
    _, block_id, first, last = struct.unpack_from(">HHII", payload)
    return block_id, first & 0xFFFFFF, last & 0xFFFFFF


def _whole(payload: bytes, size: int) -> bytes:
    if not payload or len(payload) % size:
        raise RefusalError(Status.INVALID_PARAMETER)
    return payload
