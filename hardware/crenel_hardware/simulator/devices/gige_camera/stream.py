"""The camera's stream channel: sends pictures when they are due, and packets again on request."""

import contextlib
import socket
import threading
import time
from collections import deque

import numpy as np

from crenel.loop_states import note_progress
from crenel.loops import Loop
from crenel_hardware.clock import now_ns
from crenel_hardware.simulator.devices.gige_camera.faults import GigeFaults
from crenel_hardware.simulator.devices.gige_camera.gvsp import (
    PictureBlock,
    probe_packet,
    unavailable_packet,
)
from crenel_hardware.simulator.devices.gige_camera.gvsp_parts import PartsBlock

Block = PictureBlock | PartsBlock

LINE_BYTES_PER_S = 118e6
"""What Gigabit Ethernet carries."""
_KEPT_BLOCKS = 8
"""Blocks of which packets can be sent again."""
_WAITING_BLOCKS = 4
"""Blocks that wait for the line; what comes beyond is lost."""
_AHEAD_S = 0.001
_WAKE_S = 0.05


class StreamSender:
    """Sends blocks to one receiver, on a thread of its own."""

    def __init__(self, address: str, faults: GigeFaults, seed: int) -> None:
        self._faults = faults
        self._rng = np.random.default_rng(seed)
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.bind((address, 0))
        self.port = int(self._socket.getsockname()[1])
        """The one that packets come from."""
        self._receiver: tuple[str, int] | None = None
        self._waiting: deque[tuple[int, Block]] = deque()
        self._kept: deque[Block] = deque(maxlen=_KEPT_BLOCKS)
        self._line_free_s = 0.0
        self._changed = threading.Condition()
        self._stopping = False
        self._loop = Loop("camera-stream", self._send_next)
        self.lost_packets = 0
        """Packets that got lost on the line on purpose."""

    def start(self) -> None:
        self._loop.start()

    def stop(self) -> None:
        self._loop.stop(None, self._end)
        self._socket.close()

    def _end(self) -> None:
        with self._changed:
            self._stopping = True
            self._changed.notify_all()

    def send_to(self, address: str, port: int) -> None:
        """Sets the receiver; port 0 closes the channel."""
        with self._changed:
            self._receiver = (address, port) if port else None
            if not port:
                self.clear()

    def submit(self, block: Block, due_ns: int) -> None:
        """Sends a block from a host time on, or loses it if too many wait."""
        with self._changed:
            if len(self._waiting) >= _WAITING_BLOCKS:
                return
            self._waiting.append((due_ns, block))
            self._changed.notify_all()

    def clear(self) -> None:
        """Forgets all blocks."""
        with self._changed:
            self._waiting.clear()
            self._kept.clear()

    def send_probe(self, packet_size: int) -> None:
        """Sends one packet of a size that a client wants to try; it arrives, or does not."""
        self._send(probe_packet(packet_size))

    def resend(self, block_id: int, first: int, last: int) -> None:
        """Sends packets of a block once more, or says that they are gone."""
        with self._changed:
            kept = [block for block in self._kept if block.block_id == block_id]
        for number in range(first, min(last, kept[-1].last_packet if kept else first) + 1):
            packet = kept[-1].packet(number) if kept else unavailable_packet(block_id, number)
            self._send_over_line(packet, lost=False)

    def _send_next(self) -> None:
        block = self._next()
        if block is None:
            return
        for number in range(block.last_packet + 1):
            if self._stopping or self._receiver is None:
                break
            packet = block.packet(number)
            self._wait_for_line(len(packet))
            lost = (block.block_id, number) in self._faults.lost_packets
            self._send_over_line(packet, lost)

    def _next(self) -> Block | None:
        """The next block, when it is due; None at the end."""
        with self._changed:
            while not self._stopping:
                note_progress()
                left_s = (self._waiting[0][0] - now_ns()) / 1e9 if self._waiting else _WAKE_S
                if left_s <= 0:
                    _, block = self._waiting.popleft()
                    self._kept.append(block)
                    return block
                self._changed.wait(min(left_s, _WAKE_S))
        return None

    def _wait_for_line(self, size: int) -> None:
        """Until the line has carried what was sent before."""
        now_s = time.monotonic()
        self._line_free_s = max(self._line_free_s, now_s)
        self._line_free_s += size / (self._faults.line_bytes_per_s or LINE_BYTES_PER_S)
        ahead_s = self._line_free_s - now_s
        if ahead_s > _AHEAD_S:
            time.sleep(ahead_s)

    def _send_over_line(self, packet: bytes, lost: bool) -> None:
        """Sends a packet of a block, which gets lost now and then."""
        if lost or self._rng.random() < self._faults.packet_drop_rate:
            self.lost_packets += 1
        else:
            self._send(packet)

    def _send(self, packet: bytes) -> None:
        receiver = self._receiver
        if receiver is not None and not self._faults.unplugged:
            with contextlib.suppress(OSError):
                self._socket.sendto(packet, receiver)
