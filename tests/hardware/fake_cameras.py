"""GigE Vision cameras for tests: Aravis's in a process of its own, and what all of them need.

All listen on port 3956, which the standard fixes. Those that may choose have an address of this
process. Aravis's takes 127.0.0.1 alone, so one of them runs at a time, in all processes of a test
run.
"""

import os
import shutil
import signal
import socket
import struct
import subprocess
import threading
import time
from collections.abc import Iterator
from contextlib import AbstractContextManager, closing, contextmanager, suppress
from pathlib import Path

import pytest

STARTED_MODULES = ()  # Aravis
ARAVIS_ADDRESS = "127.0.0.1"
PORT = 3956
READY_S = 120.0
ANSWER_S = 5.0
FIRST_BLOCK_ID = 65401
"""Of Aravis's camera, whose 16-bit block ids soon begin again."""
LAST_BLOCK_ID = 65535
CONTROL_REGISTER = 0x0A00
PACKET_SIZE_REGISTER = 0x0D04
TICK_FREQUENCY_REGISTERS = (0x093C, 0x0940)
_CONTROL = 0b10
_READ, _WRITE = 0x80, 0x82


def own_address(last: int) -> str:
    """An address of this computer that no other process of these tests uses."""
    high, low = divmod(os.getpid(), 1 << 14)
    return f"127.{64 + high % 128}.{low >> 6}.{last + 2 * (low & 63)}"


ADDRESS, SECOND_ADDRESS = own_address(1), own_address(2)


@contextmanager
def port_for_this_test() -> Iterator[None]:
    """Waits until no other test uses the port at 127.0.0.1: who has it for TCP has it for UDP."""
    with socket.socket() as held:
        while True:
            try:
                held.bind((ARAVIS_ADDRESS, PORT))
                break
            except OSError:
                time.sleep(0.05)
        yield


def given_up() -> list[threading.Thread]:
    """What still frees cameras that did not answer; where one answers again, it ends soon."""
    return [one for one in threading.enumerate() if one.name == "giving up a camera"]


def await_freed() -> None:
    for thread in given_up():
        thread.join(READY_S)


class ControlClient:
    """A second client of a camera: plain GVCP packets."""

    def __init__(self, address: str = ADDRESS) -> None:
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.settimeout(ANSWER_S)
        self._socket.connect((address, PORT))
        self._request = 0

    def read(self, address: int) -> int:
        """A register; raises ``OSError`` if nobody answers."""
        return int(struct.unpack(">I", self._ask(_READ, struct.pack(">I", address))[:4])[0])

    def write(self, address: int, value: int) -> None:
        self._ask(_WRITE, struct.pack(">II", address, value))

    def take_control(self) -> None:
        self.write(CONTROL_REGISTER, _CONTROL)
        assert self.read(CONTROL_REGISTER) == _CONTROL

    def leave_control(self) -> None:
        self.write(CONTROL_REGISTER, 0)

    def close(self) -> None:
        self._socket.close()

    def _ask(self, command: int, payload: bytes) -> bytes:
        self._request += 1
        head = struct.pack(">BBHHH", 0x42, 0x01, command, len(payload), self._request)
        self._socket.send(head + payload)
        while True:
            answer = self._socket.recv(256)
            status, _, _, request = struct.unpack_from(">HHHH", answer)
            if request == self._request:
                if status:
                    raise OSError(f"the camera refuses with status {status:#06x}")
                return answer[8:]


class AravisFake(AbstractContextManager["AravisFake"]):
    """``arv-fake-gv-camera`` in a process; killed, it is unplugged."""

    def __init__(self, *arguments: str) -> None:
        program = shutil.which("arv-fake-gv-camera-0.8")
        if program is None:
            pytest.skip("aravis-tools is not installed")
        self._command = [program, "-i", ARAVIS_ADDRESS, *arguments]
        self._process: subprocess.Popen[bytes] | None = None
        self.start()

    def __exit__(self, *_: object) -> None:
        self.stop()

    def start(self) -> None:
        self._process = subprocess.Popen(
            self._command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
        try:
            self._wait_until_ready(self._process)
        except BaseException:
            self.stop()
            raise

    def _wait_until_ready(self, process: subprocess.Popen[bytes]) -> None:
        deadline = time.monotonic() + READY_S
        while time.monotonic() < deadline:
            with closing(ControlClient(ARAVIS_ADDRESS)) as client, suppress(OSError):
                client.read(CONTROL_REGISTER)
                assert process.poll() is None, "another camera has the port"
                return
            time.sleep(0.05)
        raise AssertionError("the fake camera does not answer")

    def stop(self) -> None:
        process, self._process = self._process, None
        if process is not None:
            process.kill()
            process.wait()

    def freeze(self) -> None:
        """Nothing answers any more, and nobody says so."""
        self._signal(signal.SIGSTOP)

    def go_on(self) -> None:
        self._signal(signal.SIGCONT)

    def _signal(self, number: signal.Signals) -> None:
        assert self._process is not None
        self._process.send_signal(number)


_LASER_FEATURES = """
<Integer Name="LineIndex" NameSpace="Custom"><Value>0</Value></Integer>
<Integer Name="OutputIndex" NameSpace="Custom"><Value>0</Value></Integer>
<Boolean Name="UserOutputValue" NameSpace="Standard"><pValue>UserOutputRegister</pValue></Boolean>
"""
_ENUMERATIONS = {
    "LineSelector": ("LineIndex", "Line1", "Line2"),
    "LineMode": ("LineModeRegister", "Input", "Output"),
    "LineSource": ("LineSourceRegister", "ExposureActive", "UserOutput1", "UserOutput2"),
    "UserOutputSelector": ("OutputIndex", "UserOutput1", "UserOutput2"),
}
_REGISTER = """
<IntReg Name="{name}" NameSpace="Custom">
  <Address>{address}</Address><pIndex Offset="4">{index}</pIndex><Length>4</Length>
  <AccessMode>RW</AccessMode><pPort>Device</pPort>
  <Sign>Unsigned</Sign><Endianess>BigEndian</Endianess>
</IntReg>
"""
LINE_MODES, LINE_SOURCES, USER_OUTPUTS = 0x8000, 0x8010, 0x8020
"""Registers of the first line, or the first output; the next one is 4 further."""


def _enumeration(name: str, node: str, *entries: str) -> str:
    listed = "".join(
        f'<EnumEntry Name="{entry}"><Value>{value}</Value></EnumEntry>'
        for value, entry in enumerate(entries)
    )
    head = f'<Enumeration Name="{name}" NameSpace="Standard">'
    return f"{head}{listed}<pValue>{node}</pValue></Enumeration>"


def write_laser_camera(xml: str, path: Path) -> None:
    """A camera description with two lines and two user outputs added, for ``AravisFake -g``."""
    registers = [
        _REGISTER.format(name=name, address=address, index=index)
        for name, address, index in (
            ("LineModeRegister", LINE_MODES, "LineIndex"),
            ("LineSourceRegister", LINE_SOURCES, "LineIndex"),
            ("UserOutputRegister", USER_OUTPUTS, "OutputIndex"),
        )
    ]
    choices = [_enumeration(name, *nodes) for name, nodes in _ENUMERATIONS.items()]
    head, end, tail = xml.rpartition("</RegisterDescription>")
    added = _LASER_FEATURES + "".join(choices + registers)
    path.write_text(head + added + end + tail, "utf-8")
