"""The serial protocol of the Immersion HCI, the electronics of a MicroScribe.

The host repeats ``IMMC`` until the arm has found the baud rate and echoes it; ``BEGIN`` then starts
a session, and the arm answers with its product's name. In a session, the host sends commands of one
byte; the arm echoes each, and its answer follows. Texts end with 00. The echo of a command that
asks for a reading has bit 7 set; all bytes of the reading have it clear, seven bits of data each.

Source:
    The Immersion SDK 1-2a of 1996 (``HCI.H``, ``HCI.C``), which several public repositories hold.
"""

import time
from dataclasses import dataclass

from crenel.messages.message import message
from crenel_hardware.arm.wire import Wire
from crenel_hardware.errors import DeviceError

JOINTS = 5

_SIGN_ON, _BEGIN = b"IMMC", b"BEGIN"
_HOME, _END_SESSION, _MAXIMA, _MODEL, _SERIAL_NUMBER = 0xC2, 0xC5, 0xC6, 0xCA, 0xCB
_FIVE_ENCODERS = 0x01
_MAXIMA_SIZE, _FIRST_MAXIMUM = 24, 12
_READING_SIZE = 1 + 2 * JOINTS
_SIGN_ON_EVERY_S = 0.05
_QUIET_S = 0.1
_ANSWER_S = 1.0


@dataclass(frozen=True, slots=True)
class HciReading:
    """The state of the arm at one request."""

    pedals: int
    """Bit 0: the right or only pedal; bit 1: the left pedal."""
    counts: tuple[int, ...]
    """(5,) counts of the encoders, 0 to counts per revolution - 1."""


class HciSession:
    """A session over an open line. Every method raises ``DeviceError`` if the line is lost."""

    def __init__(self, wire: Wire, url: str) -> None:
        self._wire, self._url = wire, url
        self._received = b""
        self._is_behind = False
        """An answer was late or damaged: what comes next may be the rest of it."""

    def sign_on(self, timeout_s: float) -> str:
        """Starts a session; returns the name of the product."""
        deadline = time.monotonic() + timeout_s
        heard = b""
        while _SIGN_ON not in heard:
            if time.monotonic() >= deadline:
                raise self._silence_error(heard)
            self._wire.send(bytes([_END_SESSION]) + _SIGN_ON)
            heard = (heard + self._wire.receive(_SIGN_ON_EVERY_S))[-64:]
        self._discard()
        self._wire.send(_BEGIN)
        return self._read_text(deadline + _ANSWER_S)

    def model_name(self) -> str:
        """The model, as stored in the arm."""
        return self._ask_text(_MODEL)

    def serial_number(self) -> str:
        """The serial number, as stored in the arm."""
        return self._ask_text(_SERIAL_NUMBER)

    def counts_per_revolution(self) -> tuple[int, ...]:
        """(5,) of each encoder, base first."""
        self._wire.send(bytes([_MAXIMA]))
        deadline = time.monotonic() + _ANSWER_S
        self._await_echo(_MAXIMA, deadline)
        answer = self._take(_MAXIMA_SIZE, deadline)
        pairs = answer[_FIRST_MAXIMUM : _FIRST_MAXIMUM + 2 * JOINTS]
        return tuple(256 * pairs[at] + pairs[at + 1] + 1 for at in range(0, 2 * JOINTS, 2))

    def set_home(self) -> None:
        """Sets the encoders to the angles of the home position, in which the arm must be."""
        self._wire.send(bytes([_HOME]))
        self._await_echo(_HOME, time.monotonic() + _ANSWER_S)

    def read(self, timeout_s: float) -> HciReading | None:
        """Asks for a reading; None if none arrives, or a damaged one.

        A late answer does not pass for the next one, however late it is: the arm answers in order,
        so that the answer to another question comes after it.
        """
        deadline = time.monotonic() + timeout_s
        self._received = b""
        try:
            if self._is_behind:
                self._wire.send(bytes([_SERIAL_NUMBER]))
                self._await_echo(_SERIAL_NUMBER, deadline)
            self._is_behind = True
            self._wire.send(bytes([_FIVE_ENCODERS]))
            self._await_echo(_FIVE_ENCODERS | 0x80, deadline)
            answer = self._take(_READING_SIZE, deadline)
        except HciSilenceError:
            return None
        if any(byte & 0x80 for byte in answer):
            return None
        self._is_behind = False
        pairs = answer[1:]
        counts = tuple(128 * pairs[at] + pairs[at + 1] for at in range(0, 2 * JOINTS, 2))
        return HciReading(answer[0], counts)

    def end(self) -> None:
        """Ends the session; the arm then waits for a sign-on."""
        self._wire.send(bytes([_END_SESSION]))

    def _discard(self) -> None:
        """Drops what arrives, until the line is quiet."""
        self._received = b""
        while self._wire.receive(_QUIET_S):
            pass

    def _ask_text(self, command: int) -> str:
        self._wire.send(bytes([command]))
        deadline = time.monotonic() + _ANSWER_S
        self._await_echo(command, deadline)
        return self._read_text(deadline)

    def _read_text(self, deadline: float) -> str:
        text = b""
        while (byte := self._take(1, deadline)) != b"\0":
            text += byte
        return text.decode("ascii", "replace").strip()

    def _await_echo(self, echo: int, deadline: float) -> None:
        while self._take(1, deadline)[0] != echo:
            pass

    def _take(self, count: int, deadline: float) -> bytes:
        while len(self._received) < count:
            remaining_s = deadline - time.monotonic()
            if remaining_s <= 0:
                raise HciSilenceError(
                    message("microscribe-stopped-answering", url=self._url),
                    message("switch-arm-off"),
                )
            self._received += self._wire.receive(remaining_s)
        taken, self._received = self._received[:count], self._received[count:]
        return taken

    def _silence_error(self, heard: bytes) -> DeviceError:
        if heard:
            return DeviceError(
                message("microscribe-other-device", url=self._url),
                message("check-baud-rate-arm-port-another"),
            )
        return DeviceError(
            message("microscribe-no-answer", url=self._url), message("switch-arm-check-cable-port")
        )


class HciSilenceError(DeviceError):
    """An answer did not arrive in time."""
