"""Serves the poses and buttons of a FARO arm to Crenel over TCP. Not tried on a device.

For Windows, with the arm's own USB driver and FARO Manager running; see README.md. It needs Python
and ``pythonnet``, nothing of Crenel. The calls of the driver's .NET assemblies are all in
``FaroSource``; everything else is tested. The bytes are those of ``crenel_hardware.arm.protocol``.

    python faro_bridge.py --angles zyx --port 7431
    python faro_bridge.py --simulate            # a moving pose without any device
"""

import argparse
import contextlib
import itertools
import math
import queue
import socket
import struct
import sys
import threading
import time
import zlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass

HELLO, POSE = 2, 3
HELLO_REQUEST = bytes.fromhex("A75C0181002F1A1BDC")
POSES, OF_TOOL, ARRIVAL, ONLY_CHANGES = 1, 2, 4, 8
BUTTON_HOLD = 5  # samples that a button keeps its state, so that a lost packet hides no press
WAITING_PACKETS = 2000  # what a client may leave unread; more is lost to it


def packet(kind: int, payload: bytes) -> bytes:
    body = bytes([2, kind, len(payload)]) + payload
    return b"\xa7\x5c" + body + struct.pack("<I", zlib.crc32(body))


@dataclass(frozen=True)
class Identity:
    """What the bridge says about the arm; constant while it runs."""

    name: str
    serial_number: str
    rate_hz: float
    properties: int = POSES | OF_TOOL
    buttons: int = 0b111
    setting: int = 1

    def hello(self) -> bytes:
        head = struct.pack(
            "<BIBBIII",
            *(0, round(self.rate_hz * 1000), self.properties, self.buttons, self.setting, 0, 0),
        )
        texts = (self.name.encode(), self.serial_number.encode(), b"faro_bridge 1")
        return packet(HELLO, head + struct.pack("<32s16s16s", *texts))


class PoseServer:
    """Sends every pose to every client, and answers hello requests."""

    def __init__(self, identity: Identity, host: str = "", port: int = 7431) -> None:
        self.identity = identity
        self.requests = 0
        self._sequence = 0
        self._buttons, self._held = 0, 0
        self._clients: dict[socket.socket, queue.Queue[bytes]] = {}
        self._lock = threading.Lock()
        self._server = socket.create_server((host, port))
        self.port = self._server.getsockname()[1]
        self._start(self._accept)

    def publish(
        self,
        position_mm: Sequence[float],
        quaternion_xyzw: Sequence[float],
        buttons: int,
        device_us: int,
    ) -> None:
        """One pose of the tool in the arm's base frame, at a time on the device's clock."""
        self._held += 1
        # an arm at rest that sends only changes might send no update after that of a release
        hold = 1 if self.identity.properties & ONLY_CHANGES else BUTTON_HOLD
        if buttons != self._buttons and self._held >= hold:
            self._buttons, self._held = buttons, 0
        head = (self._sequence, device_us, self._buttons, self.identity.setting)
        self._sequence = (self._sequence + 1) % (1 << 32)
        data = packet(POSE, struct.pack("<IQBI7d", *head, *position_mm, *quaternion_xyzw))
        with self._lock:
            waiting = list(self._clients.values())
        for client in waiting:
            if client.qsize() < WAITING_PACKETS:
                client.put(data)

    def skip(self) -> None:
        """A pose was measured, but is not known or not valid."""
        self._sequence = (self._sequence + 1) % (1 << 32)

    def close(self) -> None:
        """Ends every connection; idempotent."""
        with self._lock:
            clients = list(self._clients)
        for end in (self._server, *clients):
            # shutdown wakes the threads that wait in accept and recv
            with contextlib.suppress(OSError):
                end.shutdown(socket.SHUT_RDWR)
            end.close()

    @staticmethod
    def _start(work: Callable[..., None], *arguments: object) -> None:
        threading.Thread(target=work, args=arguments, daemon=True).start()

    def _accept(self) -> None:
        while True:
            try:
                client, _ = self._server.accept()
            except OSError:
                return
            client.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            waiting: queue.Queue[bytes] = queue.Queue()
            with self._lock:
                self._clients[client] = waiting
            self._start(self._send, client, waiting)
            self._start(self._listen, client, waiting)

    def _send(self, client: socket.socket, waiting: "queue.Queue[bytes]") -> None:
        try:
            while data := waiting.get():
                client.sendall(data)
        except OSError:
            pass
        finally:
            self._drop(client)

    def _listen(self, client: socket.socket, waiting: "queue.Queue[bytes]") -> None:
        heard = b""
        try:
            while data := client.recv(4096):
                heard += data
                asked = heard.count(HELLO_REQUEST)
                heard = heard.replace(HELLO_REQUEST, b"")[-64:]
                self.requests += asked
                if asked:
                    waiting.put(self.identity.hello())
        except OSError:
            pass
        finally:
            waiting.put(b"")
            self._drop(client)

    def _drop(self, client: socket.socket) -> None:
        with self._lock:
            self._clients.pop(client, None)
        client.close()


def multiply(a: Sequence[float], b: Sequence[float]) -> tuple[float, float, float, float]:
    """Product of two quaternions x, y, z, w."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return (
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    )


def quaternion_from_angles(
    angles_rad: Sequence[float], order: str
) -> tuple[float, float, float, float]:
    """x, y, z, w of successive rotations about the axes that ``order`` names.

    The first angle belongs to the first axis. Each rotation is about an axis of the frame that the
    rotations before it have turned: "zyx" is ``Rz(A) Ry(B) Rx(C)``.
    """
    turned = (0.0, 0.0, 0.0, 1.0)
    for angle, axis in zip(angles_rad, order, strict=True):
        half = [0.0, 0.0, 0.0, math.cos(angle / 2)]
        half["xyz".index(axis)] = math.sin(angle / 2)
        turned = multiply(turned, half)
    return turned


Update = tuple[Sequence[float], Sequence[float], int, float]
"""Position in mm, angles A, B, C as reported, buttons, time stamp as reported."""


class FaroSource:
    """The arm's USB driver, through its .NET assemblies. Not tried on a device."""

    def __init__(self, folder: str, take: Callable[[Update], None]) -> None:
        import os

        import clr  # of pythonnet

        os.add_dll_directory(folder)
        sys.path.insert(0, folder)
        clr.AddReference(os.path.join(folder, "FaroArm.Interfaces.dll"))
        clr.AddReference(os.path.join(folder, "FaroArm.Net.dll"))
        from FaroArm import FaroArmInterfaceFactory

        self._take = take
        self._manager = FaroArmInterfaceFactory().CreateIFaroArmManager()
        self._manager.Connect()
        self._arm = self._manager.GetFirstDetectedFaroArm()
        if self._arm is None:
            raise SystemExit("No arm was found. Is FARO Manager running, and does it show the arm?")
        self.name = f"FARO {getattr(self._arm, 'ModelName', '') or 'arm'}"
        self.serial_number = str(getattr(self._arm, "SerialNumber", "") or "")
        self._handler = self._on_update  # the driver keeps only a weak hold of it
        self._arm.FaroArmUpdate += self._handler
        self._arm.EnableFaroArmUpdates(True)

    def _on_update(self, sender: object, event: object) -> None:
        u = event.FaroArmUpdate  # type: ignore[attr-defined]
        self._take(((u.X, u.Y, u.Z), (u.A, u.B, u.C), int(u.Buttons), float(u.TimeStamp)))

    def close(self) -> None:
        self._arm.EnableFaroArmUpdates(False)
        self._arm.FaroArmUpdate -= self._handler
        self._manager.Disconnect()


class SimulatedSource:
    """A pose that swings, at 100 Hz, to try the way to the station without a device."""

    name, serial_number = "Simulated FARO arm", "SIM-1"

    def __init__(self, take: Callable[[Update], None]) -> None:
        self._ended = threading.Event()
        threading.Thread(target=self._run, args=(take,), daemon=True).start()

    def _run(self, take: Callable[[Update], None]) -> None:
        for number in itertools.count():
            if self._ended.wait(0.01):
                return
            angle = 0.5 * math.sin(number / 100)
            where = (600.0, 100.0 * math.sin(angle), 300.0)
            take((where, (math.degrees(angle), 0.0, 0.0), 0, number * 10.0))

    def close(self) -> None:
        self._ended.set()


class Bridge:
    """Makes poses of updates; serves them as soon as the rate is known."""

    def __init__(self, options: argparse.Namespace) -> None:
        self._options = options
        self._server: PoseServer | None = None
        self._start_ns = time.monotonic_ns()
        self.updates = 0

    def take(self, update: Update) -> None:
        """One update of the driver, on the driver's thread."""
        self.updates += 1
        server, options = self._server, self._options
        if server is None:
            return
        position, angles, buttons, stamp = update
        if not all(math.isfinite(number) for number in (*position, *angles)):
            server.skip()
            return
        device_us = (time.monotonic_ns() - self._start_ns) // 1000
        if options.stamp_unit_s is not None:
            device_us = round(stamp * options.stamp_unit_s * 1e6)
        radians = angles if options.radians else [math.radians(angle) for angle in angles]
        server.publish(
            position, quaternion_from_angles(radians, options.angles), buttons & 0b111, device_us
        )

    def serve(self, name: str, serial_number: str) -> PoseServer:
        """Counts updates for two seconds to know their rate, then serves."""
        options, before = self._options, self.updates
        rate_hz = options.rate
        if rate_hz is None:
            time.sleep(2.0)
            rate_hz = max(1.0, round((self.updates - before) / 2.0))
        properties = POSES | OF_TOOL
        properties |= ARRIVAL if options.stamp_unit_s is None else 0
        properties |= ONLY_CHANGES if options.only_changes else 0
        identity = Identity(name, serial_number, rate_hz, properties, setting=options.setting)
        self._server = PoseServer(identity, options.host, options.port)
        return self._server


def read_options(arguments: Sequence[str] | None = None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, allow_abbrev=False)
    parser.add_argument("--driver", default=r"C:\Program Files\Common Files\FARO Shared")
    parser.add_argument("--host", default="", help="address to listen at; default: all")
    parser.add_argument("--port", type=int, default=7431)
    parser.add_argument("--angles", default="zyx", help="axes of A, B, C, as in zyx or zyz")
    parser.add_argument("--radians", action="store_true", help="A, B, C are in radians")
    parser.add_argument("--stamp-unit-s", type=float, help="TimeStamp in units of so many seconds")
    parser.add_argument("--rate", type=float, help="updates per second; default: counted")
    parser.add_argument("--only-changes", action="store_true", help="an arm at rest sends nothing")
    parser.add_argument("--setting", type=int, default=1, help="another one for another probe")
    parser.add_argument("--simulate", action="store_true", help="a moving pose without a device")
    options = parser.parse_args(arguments)
    if len(options.angles) != 3 or set(options.angles) - set("xyz"):
        parser.error("--angles names three axes, as in zyx")
    return options


def main() -> None:
    options = read_options()
    bridge = Bridge(options)
    source: FaroSource | SimulatedSource
    if options.simulate:
        source = SimulatedSource(bridge.take)
    else:
        source = FaroSource(options.driver, bridge.take)
    server = bridge.serve(source.name, source.serial_number)
    print(
        f"{source.name} {source.serial_number}: {server.identity.rate_hz:g} poses per second "
        f"at port {server.port}",
        flush=True,
    )
    try:
        while True:
            time.sleep(1.0)
    except KeyboardInterrupt:
        pass
    finally:
        source.close()
        server.close()


if __name__ == "__main__":
    main()
