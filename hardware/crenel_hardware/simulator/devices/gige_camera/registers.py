"""The camera's memory: the registers of the standard, those of its features, its description.

Source:
    AIA, GigE Vision 2.0, section 28 (bootstrap registers).
"""

import socket
import struct
import threading
from collections.abc import Callable
from dataclasses import dataclass

from crenel_hardware.simulator.devices.gige_camera.description import describe
from crenel_hardware.simulator.devices.gige_camera.feature import Feature
from crenel_hardware.simulator.devices.gige_camera.features import BASE, camera_features
from crenel_hardware.simulator.devices.gige_camera.gvcp import RefusalError, Status
from crenel_hardware.simulator.devices.gige_camera.pixels import ROWS_CODE
from crenel_hardware.simulator.devices.gige_camera.profile_features import EXTRACTION, PROFILES

MANUFACTURER, MODEL, VERSION = "Crenel", "Simulated GigE camera", "1"
DESCRIPTION_AT = 0x100000
DISCOVERY_BYTES = 0xF8
"""The registers from 0 on that a camera sends to who looks for cameras."""
_BOOTSTRAP_BYTES = 0x1000
_FEATURE_BYTES = 0x1000

CAPABILITY = 0x0934
_SERIAL_AND_NAME, _WRITE_MEMORY, _SEVERAL_AT_ONCE, _RESEND = 0xC0000000, 0x2, 0x1, 0x4
HEARTBEAT_TIMEOUT = 0x0938
TICK_FREQUENCY = 0x093C
TIMESTAMP_CONTROL, TIMESTAMP = 0x0944, 0x0948
CONTROL = 0x0A00
STREAM_PORT, PACKET_SIZE, PACKET_DELAY, STREAM_ADDRESS, SOURCE_PORT = (
    0x0D00,
    0x0D04,
    0x0D08,
    0x0D18,
    0x0D1C,
)
STREAM_CAPABILITY, STREAM_CONFIGURATION, MULTIPART = 0x0D20, 0x0D24, 0x40
"""Whether blocks may have several parts, and whether they have; of GigE Vision 2.1."""
_WRITABLE = {
    0x00E8: 16,
    HEARTBEAT_TIMEOUT: 4,
    TIMESTAMP_CONTROL: 4,
    CONTROL: 4,
    STREAM_PORT: 4,
    PACKET_SIZE: 4,
    PACKET_DELAY: 4,
    STREAM_ADDRESS: 4,
    STREAM_CONFIGURATION: 4,
}
"""Registers of the standard that a client may write, with their bytes."""
HEARTBEAT_TIMEOUT_MS = 3000
TICKS_PER_S = 125_000_000
FIRST_PACKET_SIZE = 1500


@dataclass(frozen=True)
class CameraIdentity:
    """What a camera says of itself."""

    address: str
    """Its IP address."""
    serial_number: str
    width_px: int
    height_px: int
    rate_hz: float
    """Pictures per second at power-on."""
    fewest_profiles: int | None = None
    """How many profiles it puts at least into a buffer; None of a camera that sends pictures
    alone."""
    sends_parts: bool = True
    """Whether a buffer with profiles may also have their brightness."""


class RegisterMap:
    """Reads and writes the camera's memory; any thread may use it."""

    def __init__(self, identity: CameraIdentity) -> None:
        self._features = camera_features(
            identity.width_px, identity.height_px, identity.rate_hz, identity.fewest_profiles
        )
        self._addresses = {feature.name: at for at, feature in self._features.items()}
        self.lock = threading.RLock()
        self.is_acquiring = False
        """While pictures are taken, some features are locked."""
        self.before_read: dict[int, Callable[[], int]] = {}
        """By address: what gives the present value of a register (4 bytes)."""
        self.after_write: dict[int, Callable[[int], None]] = {}
        """By address: what is to be done with a value that was written."""
        self._description = describe(self._features).encode()
        self._description += bytes(-len(self._description) % 4)
        self._identity = identity
        self.reset()

    def reset(self) -> None:
        """As at power-on."""
        with self.lock:
            self._bootstrap = _bootstrap(self._identity, len(self._description))
            self._own = bytearray(_FEATURE_BYTES)
            self.is_acquiring = False
            for at, feature in self._features.items():
                for index, value in enumerate(feature.initial):
                    size = len(_encode(feature, value))
                    start = at - BASE + index * size
                    self._own[start : start + size] = _encode(feature, value)

    def read(self, address: int, count: int) -> bytes:
        """Bytes of the memory; raises ``RefusalError``."""
        with self.lock:
            for at in range(address, address + count, 4):
                if (refresh := self.before_read.get(at)) is not None:
                    self._set(at, struct.pack(">I", refresh() & 0xFFFFFFFF))
            memory, start = self._memory(address, count)
            return bytes(memory[start : start + count])

    def write(self, address: int, data: bytes) -> None:
        """Writes one register; raises ``RefusalError``."""
        with self.lock:
            if address >= BASE:
                self._check_feature(address, data)
            elif _WRITABLE.get(address) != len(data):
                known = address + len(data) <= _BOOTSTRAP_BYTES
                raise RefusalError(Status.WRITE_PROTECT if known else Status.INVALID_ADDRESS)
            self._set(address, data)
            if (then := self.after_write.get(address)) is not None:
                then(int.from_bytes(data[-4:], "big"))

    def number(self, address: int) -> int:
        """The value of a register of the standard."""
        return int.from_bytes(self.read(address, 4), "big")

    def set_number(self, address: int, value: int) -> None:
        with self.lock:
            self._set(address, struct.pack(">I", value))

    def address_of(self, name: str, index: int = 0) -> int:
        """Where a feature is; ``index`` is the value of its selector."""
        at = self._addresses[name]
        return at + index * len(_encode(self._features[at], 0))

    def integer(self, name: str, index: int = 0) -> int:
        """The value of a feature that is not a float."""
        return self.number(self.address_of(name, index))

    def has(self, name: str) -> bool:
        """Whether the camera has a feature."""
        return name in self._addresses

    @property
    def sends_profiles(self) -> bool:
        """Whether the camera is set to profiles."""
        return self.has("DeviceScanType") and self.integer("DeviceScanType") == PROFILES

    def region(self, index: int = 0) -> tuple[int, int, int, int]:
        """Offsets x and y, width and height in px of an entry of ``RegionSelector``."""
        x, y, width_px, height_px = (
            self.integer(name, index) for name in ("OffsetX", "OffsetY", "Width", "Height")
        )
        return x, y, width_px, height_px

    def real(self, name: str) -> float:
        """The value of a float."""
        return float(struct.unpack(">d", self.read(self.address_of(name), 8))[0])

    def _set(self, address: int, data: bytes) -> None:
        memory, start = self._memory(address, len(data))
        assert isinstance(memory, bytearray)
        memory[start : start + len(data)] = data

    def _memory(self, address: int, count: int) -> tuple[bytearray | bytes, int]:
        memories: tuple[tuple[int, bytearray | bytes], ...] = (
            (0, self._bootstrap),
            (BASE, self._own),
            (DESCRIPTION_AT, self._description),
        )
        for start, memory in memories:
            if start <= address and address + count <= start + len(memory):
                return memory, address - start
        raise RefusalError(Status.INVALID_ADDRESS)

    def _check_feature(self, address: int, data: bytes) -> None:
        """Raises ``RefusalError`` unless this is a value that the feature may have now."""
        feature, index = self._feature_at(address)
        if not feature.writable:
            raise RefusalError(Status.WRITE_PROTECT)
        if feature.locked and self.is_acquiring:
            raise RefusalError(Status.ACCESS_DENIED)
        if len(data) != len(_encode(feature, 0)):
            raise RefusalError(Status.INVALID_PARAMETER)
        if feature.kind == "float":
            (value,) = struct.unpack(">d", data)
        else:
            value = int.from_bytes(data, "big")
        if feature.kind == "enumeration":
            allowed = value in feature.entries.values()
            if feature.name == "PixelFormat":  # rows are those of profiles alone
                allowed &= (value == ROWS_CODE) == (index == EXTRACTION)
        else:
            allowed = feature.least <= value <= self._most(feature, index)
            allowed &= feature.kind != "integer" or value % feature.step == 0
        if not allowed:
            raise RefusalError(Status.INVALID_PARAMETER)

    def _feature_at(self, address: int) -> tuple[Feature, int]:
        """A feature, and which entry of its selector this is."""
        for at, feature in self._features.items():
            size = len(_encode(feature, 0))
            if address in range(at, at + size * len(feature.initial), size):
                return feature, (address - at) // size
        raise RefusalError(Status.INVALID_ADDRESS)

    def _most(self, feature: Feature, index: int) -> float:
        if not feature.limit:
            return feature.most
        whole, part = feature.limit.split(" - ")
        return self.integer(whole) - self.integer(part, index)


def _encode(feature: Feature, value: float) -> bytes:
    return struct.pack(">d", value) if feature.kind == "float" else struct.pack(">I", int(value))


def _bootstrap(identity: CameraIdentity, description_bytes: int) -> bytearray:
    """The registers of the standard at power-on."""
    memory = bytearray(_BOOTSTRAP_BYTES)

    def put(address: int, *values: int) -> None:
        struct.pack_into(f">{len(values)}I", memory, address, *values)

    def put_text(address: int, text: str, most: int) -> None:
        memory[address : address + most] = text.encode()[: most - 1].ljust(most, b"\0")

    ip = int.from_bytes(socket.inet_aton(identity.address), "big")
    put(0x0000, 0x00020000, 0x80000001)  # version 2.0; big-endian, texts in UTF-8
    put(0x0008, 0x0200, ip)  # a locally administered MAC address
    put(0x0010, 0x7, 0x5)
    put(0x0024, ip)
    put(0x0034, 0xFF000000)
    put_text(0x0048, MANUFACTURER, 32)
    put_text(0x0068, MODEL, 32)
    put_text(0x0088, VERSION, 32)
    put_text(0x00A8, "simulated", 48)
    put_text(0x00D8, identity.serial_number, 16)
    place = f"Local:crenel.xml;{DESCRIPTION_AT:x};{description_bytes:x}"
    put_text(0x0200, place, 512)
    put(0x0600, 1)
    put(0x0670, 1000)  # Mbit/s
    put(0x0904, 1)
    put(HEARTBEAT_TIMEOUT, HEARTBEAT_TIMEOUT_MS)
    put(TICK_FREQUENCY, TICKS_PER_S >> 32, TICKS_PER_S & 0xFFFFFFFF)
    put(PACKET_SIZE, FIRST_PACKET_SIZE)
    if identity.fewest_profiles is not None and identity.sends_parts:
        put(STREAM_CAPABILITY, MULTIPART)
    return memory


def capability(resends: bool) -> int:
    """The value of the register that says which commands the camera knows."""
    return _SERIAL_AND_NAME | _WRITE_MEMORY | _SEVERAL_AT_ONCE | (_RESEND if resends else 0)
