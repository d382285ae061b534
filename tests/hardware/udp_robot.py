"""A controller that sends datagrams to one port of this computer, cycle after cycle."""

import contextlib
import socket
import threading
from collections.abc import Callable

from crenel_hardware.clock import now_ns
from crenel_hardware.interfaces import ArmDriver
from tests.hardware.conformance import FaultyArmBench

AT_ONCE = 50
"""Packets that a robot which was held up makes up for in one go: more would find no room."""


class UdpRobot(contextlib.AbstractContextManager["UdpRobot"]):
    """Sends ``packet(cycle, host-monotonic ns)`` every ``cycle_ms``, from an address of its own.

    Faults, set at any time: ``unplugged``, ``silent``, ``skip`` (cycles that pass without a
    packet), ``repeat`` (sent twice), ``spoil`` (changes a packet).
    """

    def __init__(
        self,
        port: int,
        cycle_ms: int,
        packet: Callable[[int, int], bytes],
        source: str = "127.0.0.1",
    ) -> None:
        self.unplugged = self.silent = False
        self.skip = self.repeat = 0
        self.spoil: Callable[[bytes], bytes] = lambda data: data
        self.start_ns = now_ns()
        self.port, self._cycle_ms, self._packet = port, cycle_ms, packet
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.bind((source, 0))
        self._stopping = threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def __exit__(self, *_: object) -> None:
        self.stop()

    def stop(self) -> None:
        self._stopping.set()
        self._thread.join()
        self._socket.close()

    def _run(self) -> None:
        cycle = 0
        while not self._stopping.wait(0.001):
            due = (now_ns() - self.start_ns) // (self._cycle_ms * 1_000_000)
            for _ in range(min(due - cycle, AT_ONCE)):
                cycle += 1
                self._send(cycle)

    def _send(self, cycle: int) -> None:
        if self.silent or self.unplugged:
            return
        if self.skip:
            self.skip -= 1
            return
        data = self.spoil(self._packet(cycle, self.start_ns + cycle * self._cycle_ms * 1_000_000))
        with contextlib.suppress(OSError):  # nobody listens
            self._socket.sendto(data, ("127.0.0.1", self.port))
            if self.repeat:
                self.repeat -= 1
                self._socket.sendto(data, ("127.0.0.1", self.port))


class UdpBench(FaultyArmBench):
    """A driver that listens to a ``UdpRobot``."""

    def __init__(self, robot: UdpRobot, make: Callable[[], ArmDriver]) -> None:
        self.faults, self._make = robot, make

    def driver(self) -> ArmDriver:
        return self._make()

    def contacts(self) -> None:
        return None
