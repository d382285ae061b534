"""The camera's control channel: one program controls it, as long as it keeps asking."""

import contextlib
import socket
import struct
import time
from typing import Protocol

from crenel.loops import Loop
from crenel_hardware.simulator.devices.gige_camera import gvcp
from crenel_hardware.simulator.devices.gige_camera.faults import GigeFaults
from crenel_hardware.simulator.devices.gige_camera.gvcp import (
    GvcpCommand,
    RefusalError,
    Request,
    Status,
)
from crenel_hardware.simulator.devices.gige_camera.registers import (
    CONTROL,
    DISCOVERY_BYTES,
    HEARTBEAT_TIMEOUT,
    TIMESTAMP_CONTROL,
    RegisterMap,
)

Address = tuple[str, int]
_EXCLUSIVE, _CONTROL_BITS = 0b01, 0b11
_OTHER_PROGRAM: Address = ("another program", 0)
_TIMESTAMP_CONTROL = TIMESTAMP_CONTROL.to_bytes(4, "big")
_TICK_S = 0.05
_LONGEST = 1500


class Controlled(Protocol):
    """The rest of the camera, as its control channel sees it."""

    @property
    def is_plugged(self) -> bool:
        """False: nothing is received or answered."""

    def power_on(self) -> None:
        """Starts again, after it was plugged in."""

    def abandon(self) -> None:
        """Called when nobody controls the camera any more."""

    def resend(self, block_id: int, first: int, last: int) -> None:
        """Sends packets of a block again."""


class ControlServer:
    """Answers requests on the standard's port, on a thread of its own.

    Args:
        camera: the rest of the camera.
        registers: what is read and written.
        address: the IP address to listen at; raises ``OSError`` if the port is taken there.
        faults: ``taken`` takes control away.
    """

    def __init__(
        self, camera: Controlled, registers: RegisterMap, address: str, faults: GigeFaults
    ) -> None:
        self._camera, self._registers, self._faults = camera, registers, faults
        self._was_plugged = True
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        try:
            self._socket.bind((address, gvcp.PORT))
        except OSError:
            self._socket.close()
            raise
        self._socket.settimeout(_TICK_S)
        self._latched = 0
        self._holder: Address | None = None
        self._heard_s = 0.0
        self._last: tuple[Address, int, bytes] | None = None
        self._loop = Loop("camera-control", self._answer_next)

    def start(self) -> None:
        self._loop.start()

    def stop(self) -> None:
        """Ends the thread and frees the port."""
        self._loop.stop(None)
        self._socket.close()

    def revoke(self) -> None:
        """Takes control from the program that has it."""
        with self._registers.lock:
            if self._holder is not None:
                self._release()

    def _answer_next(self) -> None:
        self._watch()
        try:
            datagram, sender = self._socket.recvfrom(_LONGEST)
        except OSError:  # nothing came in time, or the last answer reached nobody
            return
        if not self._was_plugged or (request := gvcp.parse(datagram)) is None:
            return
        if self._faults.answered:
            self._faults.answered -= 1
        elif self._faults.unanswered:
            self._faults.unanswered -= 1
            return
        with self._registers.lock:
            answer = self._answer(request, sender)
        if answer is not None and request.wants_answer:
            self._delay_answer(request)
            with contextlib.suppress(OSError):
                self._socket.sendto(answer, sender)

    def _delay_answer(self, request: Request) -> None:
        """Waits before the answer to the command that latches the clock, if that comes late."""
        delays_s = self._faults.latch_delays_s
        is_write = request.command == GvcpCommand.WRITE_REGISTER
        if delays_s and is_write and request.payload.startswith(_TIMESTAMP_CONTROL):
            time.sleep(delays_s[self._latched % len(delays_s)])
            self._latched += 1

    def _watch(self) -> None:
        """Ends the control of a program that is silent, or that another one replaces."""
        with self._registers.lock:
            if not self._camera.is_plugged:
                if self._was_plugged:
                    self._release()
                self._was_plugged = False
                return
            if not self._was_plugged:
                self._was_plugged = True
                self._camera.power_on()
            if (self._holder == _OTHER_PROGRAM) != self._faults.taken:
                self._release()
                if self._faults.taken:
                    self._hold(_OTHER_PROGRAM, _EXCLUSIVE)
            if self._holder in (None, _OTHER_PROGRAM):
                return
            limit_ms = self._registers.number(HEARTBEAT_TIMEOUT)
            if 1000 * (time.monotonic() - self._heard_s) > limit_ms:
                self._release()

    def _hold(self, holder: Address, privilege: int) -> None:
        self._holder, self._heard_s = holder, time.monotonic()
        self._registers.set_number(CONTROL, privilege)

    def _release(self) -> None:
        self._holder = None
        self._registers.set_number(CONTROL, 0)
        self._camera.abandon()

    def _answer(self, request: Request, sender: Address) -> bytes | None:
        """The answer; a request that was repeated is not fulfilled again."""
        if sender == self._holder:
            self._heard_s = time.monotonic()
        if self._last is not None and self._last[:2] == (sender, request.number):
            return self._last[2]
        try:
            answer = gvcp.answer(request, self._fulfil(request, sender))
        except RefusalError as refusal:
            answer = gvcp.answer(request, status=refusal.status)
        if request.command == GvcpCommand.PACKET_RESEND:
            return None  # the packets are the answer
        self._last = (sender, request.number, answer)
        return answer

    def _fulfil(self, request: Request, sender: Address) -> bytes:
        command, payload, registers = request.command, request.payload, self._registers
        if command == GvcpCommand.DISCOVERY:
            return registers.read(0, DISCOVERY_BYTES)
        if command == GvcpCommand.PACKET_RESEND and self._faults.resends:
            if self._holder is not None and sender[0] == self._holder[0]:
                self._camera.resend(*gvcp.resend_range(payload))
            return b""
        if command == GvcpCommand.READ_REGISTER:
            self._require_readable(sender)
            return b"".join(registers.read(at, 4) for at in gvcp.addresses(payload))
        if command == GvcpCommand.READ_MEMORY:
            self._require_readable(sender)
            at, count = gvcp.memory_range(payload)
            return payload[:4] + registers.read(at, count)
        if command == GvcpCommand.WRITE_REGISTER:
            writes = gvcp.assignments(payload)
            for at, data in writes:
                self._write(at, data, sender)
            return struct.pack(">HH", 0, len(writes))
        if command == GvcpCommand.WRITE_MEMORY:
            at, data = gvcp.memory_write(payload)
            self._write(at, data, sender)
            return struct.pack(">HH", 0, len(data))
        raise RefusalError(Status.NOT_IMPLEMENTED)

    def _require_readable(self, sender: Address) -> None:
        exclusive = self._registers.number(CONTROL) & _EXCLUSIVE
        if exclusive and sender != self._holder:
            raise RefusalError(Status.ACCESS_DENIED)

    def _write(self, address: int, data: bytes, sender: Address) -> None:
        if self._holder not in (None, sender):
            raise RefusalError(Status.ACCESS_DENIED)
        if address == CONTROL:
            privilege = int.from_bytes(data, "big") & _CONTROL_BITS
            if privilege:
                self._hold(sender, privilege)
            elif self._holder is not None:
                self._release()
            return
        if self._holder is None:
            raise RefusalError(Status.ACCESS_DENIED)
        self._registers.write(address, data)
