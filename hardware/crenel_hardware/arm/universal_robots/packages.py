"""The packages of RTDE, protocol version 2.

A package is its size (two bytes, with these), a type (one byte) and a payload; numbers are
big-endian. The host asks for the protocol version, states which variables it wants at which rate,
and starts the stream of data packages. The controller may send text messages in between.

Source:
    Universal Robots, "RTDE guide" (docs.universal-robots.com).
"""

import struct
from collections.abc import Sequence
from dataclasses import dataclass

PORT = 30004
PROTOCOL_VERSION = 2

REQUEST_PROTOCOL_VERSION = 86
GET_CONTROLLER_VERSION = 118
TEXT_MESSAGE = 77
DATA_PACKAGE = 85
SETUP_OUTPUTS = 79
START = 83

NOT_FOUND = "NOT_FOUND"
FORMATS = {
    "BOOL": "?",
    "UINT8": "B",
    "UINT32": "I",
    "UINT64": "Q",
    "INT32": "i",
    "DOUBLE": "d",
    "VECTOR3D": "3d",
    "VECTOR6D": "6d",
    "VECTOR6INT32": "6i",
    "VECTOR6UINT32": "6I",
}
"""The types of variables, as in ``struct``."""

_HEAD = struct.Struct(">HB")


@dataclass(frozen=True, slots=True)
class Package:
    """One package."""

    kind: int
    payload: bytes


class PackageError(ValueError):
    """What arrives is no RTDE."""


def encode_package(kind: int, payload: bytes = b"") -> bytes:
    """The bytes of one package."""
    return _HEAD.pack(_HEAD.size + len(payload), kind) + payload


def encode_version_request() -> bytes:
    """Asks for protocol version 2."""
    return encode_package(REQUEST_PROTOCOL_VERSION, struct.pack(">H", PROTOCOL_VERSION))


def encode_setup(rate_hz: float, names: Sequence[str]) -> bytes:
    """Asks for variables, ``rate_hz`` times a second."""
    return encode_package(SETUP_OUTPUTS, struct.pack(">d", rate_hz) + ",".join(names).encode())


class PackageReader:
    """Splits a stream of bytes, however it arrives, into packages."""

    def __init__(self) -> None:
        self._rest = b""

    def feed(self, data: bytes) -> list[Package]:
        """Packages that ``data`` completes; raises ``PackageError`` for an impossible size."""
        buffer = self._rest + data
        found: list[Package] = []
        at = 0
        while len(buffer) - at >= _HEAD.size:
            size, kind = _HEAD.unpack_from(buffer, at)
            if size < _HEAD.size:
                raise PackageError(f"a package of {size} bytes")
            if len(buffer) - at < size:
                break
            found.append(Package(kind, buffer[at + _HEAD.size : at + size]))
            at += size
        self._rest = buffer[at:]
        return found


@dataclass(frozen=True, slots=True)
class Recipe:
    """Which variables a data package holds, in order."""

    number: int
    names: tuple[str, ...]
    types: tuple[str, ...]

    @property
    def missing(self) -> list[str]:
        """Names of the variables that the controller does not have."""
        return [
            name for name, kind in zip(self.names, self.types, strict=True) if kind == NOT_FOUND
        ]

    def decode(self, payload: bytes) -> dict[str, tuple[float, ...]]:
        """The variables of a data package; raises ``PackageError`` for another recipe or size."""
        layout = struct.Struct(">B" + "".join(FORMATS[kind] for kind in self.types))
        if len(payload) != layout.size or payload[0] != self.number:
            raise PackageError(f"{len(payload)} bytes of recipe {payload[:1].hex()}")
        _, *values = layout.unpack(payload)
        found: dict[str, tuple[float, ...]] = {}
        at = 0
        for name, kind in zip(self.names, self.types, strict=True):
            count = int(FORMATS[kind][:-1] or 1)
            found[name] = tuple(values[at : at + count])
            at += count
        return found


def decode_recipe(payload: bytes, names: Sequence[str]) -> Recipe:
    """The answer to ``encode_setup``; raises ``PackageError`` if it does not fit."""
    types = tuple(payload[1:].decode("ascii", "replace").split(","))
    if not payload or len(types) != len(names):
        raise PackageError(f"{len(types)} types for {len(names)} variables")
    unknown = [kind for kind in types if kind not in FORMATS and kind != NOT_FOUND]
    if unknown:
        raise PackageError(f"type {unknown[0]}")
    return Recipe(payload[0], tuple(names), types)


def decode_text(payload: bytes) -> str:
    """A text message of the controller, with its source."""
    if not payload:
        return ""
    length = payload[0]
    text = payload[1 : 1 + length].decode("utf-8", "replace")
    source = payload[1 + length :]
    if not source:
        return text
    return f"{text} ({source[1 : 1 + source[0]].decode('utf-8', 'replace')})"
