"""A simulated GigE Vision camera, which shows pictures that somebody else makes.

It has its own clock, which no client knows: another zero, and a rate that is slightly off. Pictures
carry the time at which their exposure began, exactly; they arrive much later, when they have been
made, but never earlier than a constant delay after the end of the exposure.
"""

import socket
from collections.abc import Callable

from crenel.messages.message import message
from crenel_hardware.clock import now_ns
from crenel_hardware.errors import DeviceError
from crenel_hardware.simulator.devices.gige_camera.control import ControlServer
from crenel_hardware.simulator.devices.gige_camera.exposing import (
    ExposureLoop,
    LaserLine,
    TakenExposure,
)
from crenel_hardware.simulator.devices.gige_camera.faults import GigeFaults
from crenel_hardware.simulator.devices.gige_camera.gvcp import PORT
from crenel_hardware.simulator.devices.gige_camera.gvsp import LAST_BLOCK_ID, OVERHEAD, PictureBlock
from crenel_hardware.simulator.devices.gige_camera.gvsp_parts import IMAGE_2D, BlockPart, PartsBlock
from crenel_hardware.simulator.devices.gige_camera.pixels import RawImage, bytes_per_px, encode
from crenel_hardware.simulator.devices.gige_camera.profile_features import (
    EXTRACTION,
    PICTURE,
    SOURCE,
)
from crenel_hardware.simulator.devices.gige_camera.profiles import FindLine, ProfileBuffer
from crenel_hardware.simulator.devices.gige_camera.registers import (
    CAPABILITY,
    PACKET_SIZE,
    SOURCE_PORT,
    STREAM_ADDRESS,
    STREAM_PORT,
    TICKS_PER_S,
    TIMESTAMP,
    TIMESTAMP_CONTROL,
    CameraIdentity,
    RegisterMap,
    capability,
)
from crenel_hardware.simulator.devices.gige_camera.stream import Block, StreamSender

LASER_LINE, TRIGGER_LINE = "Line2", "Line1"
"""The output that the laser is connected to, and the input for the arm's pulses."""
DELAY_MS = 60.0
"""From the end of an exposure to its first packet."""
DRIFT = 30e-6
"""By how much the camera's clock is fast."""
_CLOCK_ZERO_NS = 77_000_000_000
_LINE1, _SOFTWARE = 0, 1
_PROBE, _SIZE_BITS = 1 << 31, 0xFFFF
_LATCH, _RESET = 0b10, 0b01

TakePicture = Callable[[int, float, float], RawImage]
"""An image (H, W) of the whole sensor: from the middle of the exposure in host-monotonic ns, the
exposure in µs, and the share of it during which the laser was on."""


class GigeCamera:
    """Serves one client at a time between ``start`` and ``stop``.

    Args:
        identity: its address, serial number and size.
        take_picture: makes the pictures.
        image_bits: significant bits of those pictures.
        delay_ms: from the end of an exposure to its first packet, at least.
        first_block_id: of each acquisition.
        has_power: False: as unplugged.
        find_line: finds the laser line, in a camera that also sends profiles.
    """

    def __init__(
        self,
        identity: CameraIdentity,
        take_picture: TakePicture,
        image_bits: int = 8,
        delay_ms: float = DELAY_MS,
        first_block_id: int = 1,
        seed: int = 0,
        has_power: Callable[[], bool] = lambda: True,
        find_line: FindLine | None = None,
    ) -> None:
        self._has_power = has_power
        self.identity, self.faults = identity, GigeFaults()
        self._take_picture, self._image_bits = take_picture, image_bits
        self._delay_ns, self._first_block_id = round(1e6 * delay_ms), first_block_id
        self._seed = seed
        self._registers = RegisterMap(identity)
        self._profiles = None if find_line is None else ProfileBuffer(self._registers, find_line)
        self.laser = LaserLine(self._registers, LASER_LINE)
        self._born_ns = now_ns()
        self.blocks = 0
        """Pictures taken since the start, whether or not they arrived."""
        self._control: ControlServer | None = None
        self._sender: StreamSender | None = None
        self._exposures: ExposureLoop | None = None

    def start(self) -> None:
        """Listens at the camera's address; raises ``DeviceError`` if its port is taken there."""
        if self._control is not None:
            return
        address = self.identity.address
        self._sender = sender = StreamSender(address, self.faults, self._seed)
        self._exposures = ExposureLoop(self._registers, self.laser, self._take, self._stop_pictures)
        try:
            self._control = ControlServer(self, self._registers, address, self.faults)
        except OSError as error:
            sender.start()
            sender.stop()
            raise DeviceError(
                message("udp-port-in-use", port=str(PORT)), message("close-program-with-port")
            ) from error
        self._connect_registers()
        self.power_on()
        sender.start()
        self._exposures.start_thread()
        self._control.start()

    def stop(self) -> None:
        """Ends its threads; idempotent."""
        if self._control is None or self._exposures is None or self._sender is None:
            return
        self._exposures.stop()
        self._control.stop()
        self._exposures.end_thread()
        self._sender.stop()
        self._control = self._exposures = self._sender = None

    @property
    def is_plugged(self) -> bool:
        return self._has_power() and not self.faults.unplugged

    @property
    def packets_lost(self) -> int:
        """Packets that got lost on the line on purpose, since the start."""
        return 0 if self._sender is None else self._sender.lost_packets

    def revoke_control(self) -> None:
        """Takes control from the program that has it."""
        if self._control is not None:
            self._control.revoke()

    def trigger(self, at_ns: int) -> None:
        """A rising edge at Line1."""
        if self._exposures is not None:
            self._exposures.trigger(at_ns, _LINE1)

    def power_on(self) -> None:
        """All settings as at power-on, and a clock that begins again."""
        self._born_ns = now_ns()
        self._registers.reset()
        assert self._sender is not None
        self._registers.set_number(SOURCE_PORT, self._sender.port)
        self._sender.send_to("", 0)
        self.laser.note()

    def abandon(self) -> None:
        """Nobody controls the camera any more."""
        self._stop_pictures()
        self._registers.set_number(STREAM_PORT, 0)
        self._open_stream(0)

    def resend(self, block_id: int, first: int, last: int) -> None:
        """Sends packets of a block again, if they are still there."""
        if self._sender is not None:
            self._sender.resend(block_id, first, last)

    def _connect_registers(self) -> None:
        registers = self._registers
        at = registers.address_of
        registers.before_read |= {
            CAPABILITY: lambda: capability(self.faults.resends),
            at("PayloadSize"): self._payload_bytes,
            at("LineStatus", 1): lambda: int(self.laser.is_on),
        }
        registers.after_write |= {
            TIMESTAMP_CONTROL: self._control_clock,
            STREAM_PORT: self._open_stream,
            STREAM_ADDRESS: lambda _: self._open_stream(registers.number(STREAM_PORT)),
            PACKET_SIZE: self._set_packet_size,
            at("AcquisitionStart"): lambda _: self._start_pictures(),
            at("AcquisitionStop"): lambda _: self._stop_pictures(),
            at("TriggerSoftware"): lambda _: self._trigger_by_software(),
        }
        if self._profiles is not None:
            registers.before_read[at("Width", EXTRACTION)] = lambda: registers.integer(
                "Width", SOURCE
            )
        switches = [("LineMode", 1), ("LineSource", 1), ("UserOutputValue", 0)]
        for name, index in [*switches, ("UserOutputValue", 1)]:
            registers.after_write[at(name, index)] = lambda _: self.laser.note()

    def _ticks(self, at_ns: int) -> int:
        """The camera's clock at a host-monotonic time."""
        since_ns = (at_ns - self._born_ns) * (1 + DRIFT) + _CLOCK_ZERO_NS
        return round(since_ns * TICKS_PER_S / 1e9)

    def _control_clock(self, value: int) -> None:
        if value & _RESET:
            self._born_ns = now_ns() + _CLOCK_ZERO_NS
        if value & _LATCH:
            ticks = self._ticks(now_ns())
            self._registers.set_number(TIMESTAMP, ticks >> 32)
            self._registers.set_number(TIMESTAMP + 4, ticks & 0xFFFFFFFF)

    def _payload_bytes(self) -> int:
        registers = self._registers
        index = EXTRACTION if registers.sends_profiles else PICTURE
        _, _, width_px, height_px = registers.region(index)
        per_px = bytes_per_px(registers.integer("PixelFormat", index))
        if registers.sends_profiles and self._profiles is not None:
            per_px += self._profiles.sends_brightness
        return width_px * height_px * per_px

    def _open_stream(self, port: int) -> None:
        assert self._sender is not None
        receiver = self._registers.read(STREAM_ADDRESS, 4)
        self._sender.send_to(socket.inet_ntoa(receiver), port & 0xFFFF)

    def _set_packet_size(self, value: int) -> None:
        size = min(max(value & _SIZE_BITS, 576), 16_000) & ~3
        self._registers.set_number(PACKET_SIZE, value & ~_PROBE & ~_SIZE_BITS | size)
        if value & _PROBE and self._sender is not None:
            self._sender.send_probe(size)

    def _start_pictures(self) -> None:
        if self._exposures is not None and not self._registers.is_acquiring:
            self._registers.is_acquiring = True
            if self._profiles is not None:
                self._profiles.clear()
            self._exposures.start()

    def _stop_pictures(self) -> None:
        self._registers.is_acquiring = False
        if self._exposures is not None:
            self._exposures.stop()

    def _trigger_by_software(self) -> None:
        if self._exposures is not None:
            self._exposures.trigger(now_ns(), _SOFTWARE)

    def _take(self, exposure: TakenExposure) -> None:
        image = self._take_picture(exposure.mid_ns, exposure.exposure_us, exposure.laser_share)
        registers, sender = self._registers, self._sender
        if sender is None or not registers.is_acquiring or not self.is_plugged:
            return
        parts = self._parts(image)
        if not parts:
            return
        self.blocks += 1
        number = self._first_block_id - 1 + self._number(exposure) - 1
        index = EXTRACTION if registers.sends_profiles else PICTURE
        ticks, region = self._ticks(exposure.start_ns), registers.region(index)
        size = max(registers.number(PACKET_SIZE) & _SIZE_BITS, OVERHEAD + 540)
        block: Block
        if len(parts) == 1:
            block_id, code = number % LAST_BLOCK_ID + 1, parts[0].pixel_format
            block = PictureBlock(block_id, ticks, code, region, parts[0].data, size)
        else:
            block = PartsBlock(number + 1, ticks, region, parts, size)
        sender.submit(block, exposure.end_ns + self._delay_ns)

    def _parts(self, image: RawImage) -> tuple[BlockPart, ...] | None:
        """What is sent of an image; None of a profile whose buffer is not full."""
        registers = self._registers
        if self._profiles is not None and registers.sends_profiles:
            return self._profiles.add(image)
        x, y, width_px, height_px = registers.region()
        code = registers.integer("PixelFormat")
        part = image[y : y + height_px, x : x + width_px]
        return (BlockPart(IMAGE_2D, code, encode(part, self._image_bits, code)),)

    def _number(self, exposure: TakenExposure) -> int:
        """The number of the block that an exposure completes, from 1."""
        registers = self._registers
        profiles = registers.integer("Height", EXTRACTION) if registers.sends_profiles else 1
        return -(-exposure.number // profiles)
