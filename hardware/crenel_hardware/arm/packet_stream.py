"""Makes records of the packets of one connection: sequence, time, pulses, buttons, checks."""

from math import hypot, isfinite

from crenel.messages.message import message, rounded
from crenel_hardware.arm.expected_arm import (
    SerialEncoderOptions,
    another_arm_error,
    radians_per_count,
    refuse_other_arm,
    setting_error,
)
from crenel_hardware.arm.packet_reader import PacketReader
from crenel_hardware.arm.protocol import BUTTON_BITS, Hello, PosePacket, PulseAnswer, Sample
from crenel_hardware.device_clock import ClockLead, DeviceClock
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import (
    ArmReading,
    ArmRecord,
    ButtonEvent,
    JointSample,
    LinkHealth,
    PoseSample,
)

SETTLE_S = 0.25
"""Samples are observed for this long before the first is returned, to learn the clock."""
_JUMP_NS = 3_000_000_000
"""A clock that is ahead by more than this of what is possible, or a count that is of the clock, has
been set."""
_UNIT_TOLERANCE = 1e-3
_MOST_BAD_POSES = 50


class PacketStream:
    """Converts the bytes of one connection into records.

    ``hello`` and ``hellos`` are the arm's identification and how often it came; ``answer`` is the
    last answer to a pulse request.
    """

    def __init__(self, options: SerialEncoderOptions, health: LinkHealth) -> None:
        self._options = options
        self._health = health
        self._reader = PacketReader()
        self._clock = DeviceClock()
        self._latency_ns = round(options.latency_us * 1000)
        self._refused = 0
        self._bad_poses = 0
        self._last: Sample | PosePacket | None = None
        self._buttons: int | None = None
        self._sequence = 0
        self._first_ns: int | None = None
        self._scale: tuple[float, ...] = ()
        self._settled = False
        self._was_ready = False
        self._lead = ClockLead()
        self._pulses_run = False
        self._last_pulse = 0
        self._request: int | None = None
        self.hello: Hello | None = None
        self.hellos = 0
        self.answer: PulseAnswer | None = None

    @property
    def is_ready(self) -> bool:
        """Whether the arm has identified itself, and its clock is known if it can be."""
        return self.hello is not None and (self._settled or self.hello.only_changes)

    @property
    def pulses_run(self) -> bool:
        return self._pulses_run

    def expect_answer(self, number: int) -> None:
        """From here until the answer to this request, pulses are those of a former run."""
        self.answer = None
        self._request = number

    def records(self, data: bytes, arrival_ns: int) -> list[ArmRecord]:
        """Records of the packets that ``data`` completes; none before the stream is ready.

        Raises:
            DeviceError: another arm, other joints or frames, no poses, pulses that restarted, or a
                clock or count that jumped.
        """
        records: list[ArmRecord] = []
        for packet in self._reader.feed(data):
            if isinstance(packet, Hello):
                self._greet(packet)
            elif isinstance(packet, PulseAnswer):
                self._take_answer(packet)
            elif self._advance(packet, arrival_ns):
                self._clock.observe(packet.device_us * 1000, arrival_ns)
                self._settle(arrival_ns)
                if self.is_ready:
                    self._was_ready = True
                    self._append(records, packet)
                elif self._was_ready:
                    self._health.received -= 1
                    self._health.lost += 1
                else:
                    self._buttons = packet.buttons
        self._health.corrupt = self._reader.corrupt + self._refused
        return records

    def silence_error(self) -> DeviceError:
        """Why ``open`` gave up."""
        url, reader = self._options.url, self._reader
        if self.hello is not None:
            return DeviceError(
                message("arm-sends-hello-but-no-samples", url=url, name=self.hello.name),
                message("switch-arm-off"),
            )
        if self._last is not None:
            return DeviceError(
                message("arm-sends-samples-but-no-hello", url=url),
                message("firmware-must-answer-hello"),
            )
        if reader.other_version is not None:
            return DeviceError(
                message(
                    "arm-speaks-version-protocol-driver-speaks",
                    url=url,
                    other_version=reader.other_version,
                ),
                message("update-program-arms-firmware"),
            )
        if reader.received_bytes:
            return DeviceError(
                message("bytes-but-no-packet", count=reader.received_bytes, url=url),
                message("check-baud-rate-arm-port-another"),
            )
        return DeviceError(
            message("nothing-came-for", url=url, time=rounded(self._options.timeout_s, "s")),
            message("switch-arm-check-cable-port"),
        )

    def _greet(self, hello: Hello) -> None:
        if self.hello is None:
            refuse_other_arm(self._options, hello)
            self._scale = radians_per_count(self._options, hello)
            self.hello = hello
        elif hello != self.hello:
            raise another_arm_error(self._options.url, hello, self.hello)
        self.hellos += 1

    def _take_answer(self, answer: PulseAnswer) -> None:
        if answer.number != self._request:
            return
        self._request = None
        self.answer = answer
        self._last_pulse = 0
        if answer.done:
            self._pulses_run = answer.rate_hz > 0

    def _advance(self, packet: Sample | PosePacket, arrival_ns: int) -> bool:
        """Checks sequence number and time; False for a repeated sample."""
        last, self._last = self._last, packet
        step = 1
        if last is None:
            self._sequence = packet.sequence - 1
        elif packet.device_us < last.device_us or self._step_from(last, packet) >= 1 << 31:
            if self._pulses_run:
                raise self._pulse_error()
            self._learn_clock_again()
            last = None
        elif (step := self._step_from(last, packet)) == 0:
            self._refused += 1
            return False
        self._require_no_jump(last, packet, step, arrival_ns)
        self._sequence += step
        self._health.received += 1
        self._health.lost += step - 1
        return True

    def _learn_clock_again(self) -> None:
        """After a restart: the first packets may have waited anywhere on their way."""
        self._clock.restart()
        self._settled, self._first_ns, self._lead = False, None, ClockLead()

    def _require_no_jump(
        self, last: Sample | PosePacket | None, packet: Sample | PosePacket, step: int, now_ns: int
    ) -> None:
        """Raises ``DeviceError`` if the packet comes long before its time, or counts far more
        samples than its time has."""
        gain_ns = self._lead.gain_ns(packet.device_us * 1000, now_ns)
        rate_hz = self.hello.rate_hz if self.hello is not None else 0.0
        counted_ns = step * 1e9 / rate_hz if rate_hz else 0.0
        passed_ns = 0 if last is None else (packet.device_us - last.device_us) * 1000
        if gain_ns > _JUMP_NS or counted_ns > passed_ns + _JUMP_NS:
            raise DeviceError(
                message("robot-clock-jumped", address=self._options.url), message("opens-again")
            )

    @staticmethod
    def _step_from(last: Sample | PosePacket, packet: Sample | PosePacket) -> int:
        return (packet.sequence - last.sequence) % (1 << 32)

    def _settle(self, arrival_ns: int) -> None:
        if self._first_ns is None:
            self._first_ns = arrival_ns
        self._settled = self._settled or arrival_ns - self._first_ns >= SETTLE_S * 1e9

    def _append(self, records: list[ArmRecord], packet: Sample | PosePacket) -> None:
        reading = self._joints(packet) if isinstance(packet, Sample) else self._pose(packet)
        if reading is None:
            return
        records.append(reading)
        before = packet.buttons if self._buttons is None else self._buttons
        self._buttons = packet.buttons
        for bit, button in BUTTON_BITS:
            if (packet.buttons ^ before) & bit:
                pressed = bool(packet.buttons & bit)
                records.append(ButtonEvent(self._sequence, reading.stamp_ns, button, pressed))

    def _joints(self, sample: Sample) -> ArmReading:
        if len(sample.counts) != len(self._scale):
            raise DeviceError(
                message(
                    "arm-sends-other-joint-count",
                    url=self._options.url,
                    expected=len(self._scale),
                    count=len(sample.counts),
                ),
                message("firmware-must-send-counts-of-hello"),
            )
        joints = tuple(
            count * scale for count, scale in zip(sample.counts, self._scale, strict=True)
        )
        return JointSample(self._sequence, self._stamp_ns(sample), joints, self._pulse(sample))

    def _pose(self, pose: PosePacket) -> ArmReading | None:
        """None for a packet whose numbers are no pose."""
        hello, url = self.hello, self._options.url
        assert hello is not None
        if not hello.reports_poses:
            raise DeviceError(
                message("arm-announced-joints-sends-poses", url=url),
                message("firmware-must-send-what-hello-announces"),
            )
        if pose.setting != hello.setting:
            raise setting_error(url, pose.setting, hello.setting)
        length = hypot(*pose.quaternion_xyzw)
        finite = all(isfinite(x) for x in (*pose.position_mm, *pose.quaternion_xyzw))
        if not finite or abs(length - 1) > _UNIT_TOLERANCE:
            self._refused += 1
            self._health.received -= 1
            self._bad_poses += 1
            if self._bad_poses >= _MOST_BAD_POSES:
                raise DeviceError(
                    message("arm-sends-no-valid-poses", url=url, count=self._bad_poses),
                    message("bridge-must-send-finite-unit-quaternions"),
                )
            return None
        self._bad_poses = 0
        x, y, z, w = (part / length for part in pose.quaternion_xyzw)
        stamp_ns = self._stamp_ns(pose)
        return PoseSample(
            self._sequence, stamp_ns, pose.position_mm, (x, y, z, w), self._pulse(pose)
        )

    def _stamp_ns(self, packet: Sample | PosePacket) -> int:
        return self._clock.stamp(packet.device_us * 1000) - self._latency_ns

    def _pulse(self, packet: Sample | PosePacket) -> int | None:
        """The packet's pulse in the present run; None for one of a former run."""
        if packet.pulse is None or not self._pulses_run or self._request is not None:
            return None
        if packet.pulse <= self._last_pulse:
            raise self._pulse_error()
        self._last_pulse = packet.pulse
        return packet.pulse

    def _pulse_error(self) -> DeviceError:
        return DeviceError(
            message("arm-counts-pulses-from-start-again", url=self._options.url),
            message("check-arm-power-and-no-second-program"),
        )
