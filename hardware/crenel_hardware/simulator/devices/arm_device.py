"""The simulated arm as its cable sees it: encoders or poses, buttons, pulses, its own clock."""

import threading
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from crenel_hardware.clock import now_ns
from crenel_hardware.interfaces import Button
from crenel_hardware.simulator.devices.arm_packets import (
    POSE,
    SAMPLE,
    PulseRequest,
    RequestReader,
    hello_packet,
    pose_payload,
    pulse_answer_packet,
    reading_packet,
    sample_payload,
)
from crenel_hardware.simulator.devices.device_thread import ThreadedDevice
from crenel_hardware.simulator.devices.motion import Motion
from crenel_hardware.simulator.devices.ports import DevicePort
from crenel_hardware.simulator.devices.trigger_pulses import RATES_HZ, TriggerPulses

Floats = NDArray[np.float64]
SETTING = 1
"""The number of tool and coordinate system of the poses."""
BUTTON_BIT = {Button.PRIMARY: 1, Button.UNDO: 2, Button.BACK: 4}
CATCH_UP_NS = 5_000_000_000
"""A device that was not scheduled for longer than this loses what it should have taken."""


@dataclass(frozen=True)
class Encoders:
    """How the joints are measured, and what the device says of itself."""

    rate_hz: float = 1000.0
    counts_per_revolution: int = 1 << 22
    noise_rad: float = 1e-5
    drift: float = 2.3e-5
    """How much faster the device's clock runs than the host's."""
    name: str = "Simulated arm"
    serial_number: str = "TWIN-A1"
    firmware: str = "1.0.0"


@dataclass
class ArmFaults:
    """What goes wrong with the arm on purpose; set at any time, from any thread.

    Rates are shares of packets, 0 to 1.
    """

    drop_rate: float = 0.0
    """Samples taken and never sent."""
    corrupt_rate: float = 0.0
    """Samples sent with a wrong byte."""
    garbage_rate: float = 0.0
    """Samples with random bytes before them."""
    late_rate: float = 0.0
    """Samples that hold up the line for ``late_s``; what follows waits behind them."""
    late_s: float = 0.1
    stalled: bool = False
    """The arm goes on measuring, and sends nothing."""
    unplugged: bool = False
    """The arm's line is gone; it comes back at the same address."""
    frozen_joint: int | None = None
    """Its encoder says what it said when this was set, again and again."""
    odd_joint: int | None = None
    """Its encoder is off by ``odd_rad`` in one of every ``odd_every`` samples."""
    odd_rad: float = 0.0
    odd_every: int = 1

    @property
    def are_by_chance(self) -> bool:
        """Whether something happens to a share of the packets."""
        return max(self.drop_rate, self.corrupt_rate, self.garbage_rate, self.late_rate) > 0

    def clear(self) -> None:
        """Everything works again."""
        for name, value in ArmFaults().__dict__.items():
            setattr(self, name, value)


class ArmDevice(ThreadedDevice):
    """Runs on a thread of its own between ``start`` and ``stop``.

    Args:
        flange_poses: (N, 4, 4) for joint angles (N, n); the arm then reports poses, which a
            controller computes from its encoders.
        on_pulse: is called with the moment of each trigger pulse.

    ``requests`` counts the hellos that clients asked for.
    """

    def __init__(
        self,
        motion: Motion,
        line: DevicePort,
        encoders: Encoders,
        faults: ArmFaults,
        seed: int = 0,
        flange_poses: Callable[[Floats], Floats] | None = None,
        on_pulse: Callable[[int], None] = lambda stamp_ns: None,
    ) -> None:
        self.requests = 0
        self._flange_poses = flange_poses
        self._pulses, self._on_pulse = TriggerPulses(), on_pulse
        self._motion, self._line, self._encoders, self._faults = motion, line, encoders, faults
        self._rng = np.random.default_rng(seed)
        self._joints = len(motion.at(now_ns()))
        self._buttons: deque[tuple[int, int]] = deque([(0, 0)], maxlen=64)
        self._button_lock = threading.Lock()
        self._born_ns = now_ns() - int(self._rng.integers(1, 4_000)) * 1_000_000_000
        self._sequence = int(self._rng.integers(0, 1 << 31))
        self._outbox: deque[tuple[int, bytes]] = deque()
        self._start_ns, self._taken = now_ns(), 0
        self._free_ns = 0
        self._requests = RequestReader()
        super().__init__("simulated-arm")
        self._skip = 0
        self._frozen_count: int | None = None

    def _release(self) -> None:
        self._line.release()

    def press(self, button: Button, pressed: bool, at_ns: int | None = None) -> None:
        """A button goes down or up, now or at a moment to come (none may be earlier)."""
        with self._button_lock:
            bits = self._buttons[-1][1]
            bits = bits | BUTTON_BIT[button] if pressed else bits & ~BUTTON_BIT[button]
            self._buttons.append((at_ns or now_ns(), bits))

    def skip(self, count: int) -> None:
        """The next samples are taken and not sent."""
        self._skip += count

    def _bits_at(self, stamp_ns: int) -> int:
        with self._button_lock:
            return next((bits for at, bits in reversed(self._buttons) if at <= stamp_ns), 0)

    def _begin(self) -> None:
        self._start_ns, self._taken = now_ns(), 0

    def _serve(self) -> None:
        if self._faults.unplugged:
            self._line.unplug()
        else:
            self._line.plug_in()
        self._answer(self._line.poll())
        period_ns = 1e9 / self._encoders.rate_hz
        start_ns, taken, now = self._start_ns, self._taken, now_ns()
        due = int((now - start_ns) / period_ns) + 1  # those latched by now
        if now - start_ns - taken * period_ns > CATCH_UP_NS:
            self._sequence += due - taken
            taken = due
        stamps = start_ns + np.rint(np.arange(taken, due) * period_ns).astype(np.int64)
        self._taken = max(due, taken)
        pulses = self._pulses.due(now)
        for stamp, _ in pulses:
            self._on_pulse(stamp)
        moments = [(stamp, None) for stamp in stamps.tolist()] + pulses
        if moments:
            self._take(sorted(moments, key=lambda moment: moment[0]))
        self._send_due(now)

    def _take(self, moments: list[tuple[int, int | None]]) -> None:
        """Latches the encoders at moments, some of them those of trigger pulses."""
        q = self._motion.at_all(np.array([stamp for stamp, _ in moments], dtype=np.int64))
        q = q + self._rng.normal(0.0, self._encoders.noise_rad, q.shape)
        per_rad = self._encoders.counts_per_revolution / (2 * np.pi)
        rows = np.rint(q * per_rad).astype(int).tolist()
        first, self._sequence = self._sequence + 1, self._sequence + len(rows)
        for i, row in enumerate(rows):
            self._apply_encoder_faults(row, first + i)
        poses = self._poses(np.array(rows) / per_rad)
        chances = self._draw_chances(len(moments))
        for i, (stamp, pulse) in enumerate(moments):
            sequence = first + i
            device_us = int((stamp - self._born_ns) * (1 + self._encoders.drift) / 1000)
            buttons = self._bits_at(stamp)
            if poses is None:
                kind, payload = SAMPLE, sample_payload(sequence, device_us, buttons, rows[i])
            else:
                kind, payload = POSE, pose_payload(sequence, device_us, buttons, SETTING, poses[i])
            self._dispatch(reading_packet(kind, payload, pulse), stamp, chances[i])

    def _draw_chances(self, count: int) -> list[list[float]]:
        """Four numbers from 0 to 1 for each sample, one for each kind of fault."""
        if not self._faults.are_by_chance:
            return [[1.0] * 4] * count
        chances: list[list[float]] = self._rng.random((count, 4)).tolist()
        return chances

    def _poses(self, q_rad: Floats) -> list[list[float]] | None:
        """Positions and quaternions, as the arm's controller computes them."""
        if self._flange_poses is None:
            return None
        T = self._flange_poses(q_rad)
        quaternions = Rotation.from_matrix(T[:, :3, :3]).as_quat()
        return [[*p, *q] for p, q in zip(T[:, :3, 3].tolist(), quaternions.tolist(), strict=True)]

    def _apply_encoder_faults(self, counts: list[int], sequence: int) -> None:
        """Makes of the encoders' counts what lying ones say."""
        faults, frozen = self._faults, self._faults.frozen_joint
        if frozen is None:
            self._frozen_count = None
        else:
            self._frozen_count = (
                counts[frozen] if self._frozen_count is None else self._frozen_count
            )
            counts[frozen] = self._frozen_count
        if faults.odd_joint is not None and sequence % faults.odd_every == 0:
            per_rad = self._encoders.counts_per_revolution / (2 * np.pi)
            counts[faults.odd_joint] += round(faults.odd_rad * per_rad)

    def _dispatch(self, made: bytes, stamp_ns: int, chance: list[float]) -> None:
        """Lets a sample go, or what the faults leave of it.

        Args:
            chance: four numbers from 0 to 1, one for each kind of fault.
        """
        faults = self._faults
        if self._skip > 0:
            self._skip -= 1
            return
        if faults.stalled or chance[0] < faults.drop_rate:
            return
        if chance[1] < faults.corrupt_rate:
            at = int(self._rng.integers(2, len(made)))
            made = made[:at] + bytes([made[at] ^ 0x55]) + made[at + 1 :]
        if chance[2] < faults.garbage_rate:
            made = self._rng.bytes(int(self._rng.integers(1, 40))) + made
        if chance[3] < faults.late_rate:
            self._free_ns = max(self._free_ns, stamp_ns + round(faults.late_s * 1e9))
        self._outbox.append((max(self._free_ns, stamp_ns), made))

    def _send_due(self, now: int) -> None:
        ready = b""
        while self._outbox and self._outbox[0][0] <= now:
            ready += self._outbox.popleft()[1]
        if ready:
            self._line.send(ready)

    def _answer(self, said: bytes) -> None:
        hellos, requests = self._requests.feed(said)
        self.requests += hellos
        if self._faults.stalled:
            return
        if hellos:
            self._outbox.append((now_ns(), self._hello()))
        for request in requests:
            self._outbox.append((now_ns(), self._set_pulses(request)))

    def _hello(self) -> bytes:
        encoders, poses = self._encoders, self._flange_poses is not None
        counts = [] if poses else [encoders.counts_per_revolution] * self._joints
        texts = (encoders.name, encoders.serial_number, encoders.firmware)
        return hello_packet(counts, encoders.rate_hz, texts, SETTING if poses else 0, RATES_HZ)

    def _set_pulses(self, request: PulseRequest) -> bytes:
        done = self._pulses.set(request, now_ns())
        return pulse_answer_packet(request.number, done, self._pulses.rate_hz)
