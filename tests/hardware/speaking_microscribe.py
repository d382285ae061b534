"""A MicroScribe at the far end of a line, written from the Immersion SDK's description alone."""

import time

from tests.hardware.speaking_arm import Line, SpeakingDevice

COUNTS = 8000
HOME_COUNTS = (0, 100, 200, 300, 400)


class FakeMicroscribe(SpeakingDevice):
    """Answers on a thread of its own. ``counts`` and ``pedals`` are what it reports.

    Faults: ``silent`` (hears nothing), ``skip`` (requests that get no answer), ``damage`` (answers
    with bit 7 set in the payload), ``late_s`` (answers so late), ``no_encoder`` (the maximum of
    one encoder is 0).
    """

    def __init__(self, line: Line, baud_rounds: int = 2) -> None:
        self.counts = [10, 20, 30, 40, 50]
        self.pedals = self.damage = self.heard = 0
        self.late_s = 0.0
        self.no_encoder = False
        self._rounds = baud_rounds
        self._unheard = baud_rounds
        self._inbox = b""
        self._in_session = False
        super().__init__(line, 0.0003)

    def unplug(self) -> None:
        super().unplug()
        with self._lock:
            self._in_session, self._inbox = False, b""

    def work(self) -> None:
        data = self.line.read()
        self.heard += len(data)
        if not self.silent:
            self._inbox += data
            while self._inbox and self._step():
                pass

    def _step(self) -> bool:
        """Takes one command from the inbox; False if it is not complete."""
        if not self._in_session:
            return self._listen()
        command, self._inbox = self._inbox[0], self._inbox[1:]
        texts = {0xC8: b"MicroScribe", 0xCA: b"G2X", 0xCB: b"MS-1234", 0xC9: b"MSCR"}
        if command == 0xC5:
            self._in_session, self._unheard = False, self._rounds
        elif command in texts:
            self.line.write(bytes([command]) + texts[command] + b"\0")
        elif command == 0xC2:
            self.counts = list(HOME_COUNTS)
            self.line.write(bytes([command]))
        elif command == 0xC6:
            self.line.write(bytes([command]) + self._maxima())
        elif command < 0x40:
            self._answer(command)
        return True

    def _listen(self) -> bool:
        """Before a session: echoes the sign-on once it has found the baud rate."""
        if (at := self._inbox.find(b"BEGIN")) >= 0:
            self._inbox, self._in_session = self._inbox[at + 5 :], True
            self.line.write(b"MSCR1-1C\0")
            return True
        if (at := self._inbox.find(b"IMMC")) < 0:
            return False
        self._inbox = self._inbox[at + 4 :]
        self._unheard -= 1
        if self._unheard < 0:
            self.line.write(b"IMMC")
        return True

    def _maxima(self) -> bytes:
        largest = [COUNTS - 1] * 6
        if self.no_encoder:
            largest[2] = 0
        return bytes(12) + b"".join(value.to_bytes(2, "big") for value in largest)

    def _answer(self, command: int) -> None:
        if self.skip:
            self.skip -= 1
            return
        number = {0: 0, 1: 5, 2: 7, 3: 6}[command & 3]
        counts = (self.counts + [0, 0])[:number]
        payload = bytes([self.pedals & 0x7F])
        if command & 0x20:
            payload += bytes(2)
        payload += b"".join(bytes([count >> 7 & 0x7F, count & 0x7F]) for count in counts)
        if self.damage:
            self.damage -= 1
            payload = payload[:-1] + b"\xff"
        if self.late_s:
            time.sleep(self.late_s)
        self.line.write(bytes([command | 0x80]) + payload)
