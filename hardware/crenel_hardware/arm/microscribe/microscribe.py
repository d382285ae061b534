"""The ``microscribe`` driver: a MicroScribe arm with five joints on a serial line.

The arm has no time stamps that a host could use: it is asked for each reading, whose stamp is the
middle between question and answer. The pedals are the buttons *primary* (right or only pedal) and
*undo* (left pedal). In station.toml::

    [arm]
    driver = "microscribe"
    url = "/dev/ttyUSB0"        # or "COM5"
    baudrate = 115200           # the arm finds it by itself
    rate_hz = 250.0             # readings per second
    latency_us = 0              # optional: time from latching to the middle of an answer
    timeout_s = 5.0             # how long ``open`` waits for the arm

The encoders count from the home position, with the stylus in its holder. The driver never sets
this position, since it may connect again while the arm is anywhere. Once after switching on, with
the stylus in its holder, run::

    python -m crenel_hardware.arm.microscribe.microscribe /dev/ttyUSB0
"""

import sys
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from math import pi
from typing import Annotated

from pydantic import Field

from crenel.messages.message import Text, message
from crenel_hardware.arm.microscribe.hci import JOINTS, HciSession
from crenel_hardware.arm.robots.readings import RobotReading, WrappingCounter
from crenel_hardware.arm.robots.streaming_arm import StreamingArm, StreamOptions
from crenel_hardware.arm.wire import Wire
from crenel_hardware.clock import now_ns
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import ArmInfo, Button, LinkHealth
from crenel_hardware.options import read_options
from crenel_hardware.shared_options import RATE, Baudrate, TimeoutSeconds, Url

_BAUDRATE = 115_200
_PEDALS = ((1, Button.PRIMARY), (2, Button.UNDO))
_ANSWER_S = 0.1


class MicroscribeOptions(StreamOptions):
    """Options of the driver in station.toml."""

    title = message("driver-microscribe")
    url: Url
    baudrate: Baudrate = _BAUDRATE
    rate_hz: Annotated[float, Field(ge=20, le=1000), RATE] = 250.0
    timeout_s: TimeoutSeconds = 5.0


def from_options(options: Mapping[str, object]) -> StreamingArm:
    """The driver for an ``[arm]`` table of station.toml; raises ``DeviceError``."""
    checked = read_options(MicroscribeOptions, options, "arm")
    return StreamingArm(checked, checked.url, lambda: HciStream(checked))


class HciStream:
    """Readings of one session, asked for at a constant rate. Implements ``ControllerStream``."""

    silence_remedy: Text = message("switch-arm-off")

    def __init__(self, options: MicroscribeOptions) -> None:
        self._options = options
        self._health = LinkHealth()
        self._wire: Wire | None = None
        self._closed = False
        self._session: HciSession | None = None
        self._counters: list[WrappingCounter] = []
        self._scale: tuple[float, ...] = ()
        self._asked = 0
        self._next_s = 0.0

    def start(self, timeout_s: float, health: LinkHealth) -> ArmInfo:
        """Starts a session, and asks the arm what it is."""
        self._health = health
        self._wire = wire = Wire(self._options.url, self._options.baudrate)
        if self._closed:
            wire.close()
        session = HciSession(wire, self._options.url)
        product = session.sign_on(timeout_s)
        self._session = session
        name, serial_number = session.model_name() or product, session.serial_number()
        counts = session.counts_per_revolution()
        if min(counts) < 2:
            raise DeviceError(
                message(
                    "arm-reports-no-counts-per-revolution",
                    url=self._options.url,
                    joint=counts.index(min(counts)) + 1,
                ),
                message("microscribe-needs-five-joints"),
            )
        self._counters = [WrappingCounter(count) for count in counts]
        self._scale = tuple(2 * pi / count for count in counts)
        return ArmInfo(
            name=f"MicroScribe {name}".strip(),
            serial_number=serial_number,
            joint_count=JOINTS,
            rate_hz=self._options.rate_hz,
            buttons=frozenset(button for _, button in _PEDALS),
            stamps="arrival",
        )

    def receive(self, timeout_s: float) -> Sequence[RobotReading]:
        """The next reading, at its time; none if it is damaged, or due after ``timeout_s``."""
        wire, session = self._wire, self._session
        if wire is None or session is None:
            raise DeviceError(message("arm-not-open", url=self._options.url))
        wait_s = self._next_s - time.monotonic()
        if wait_s > 0:
            wire.receive(min(wait_s, timeout_s))  # nothing comes unasked; ``close`` ends the wait
            if wait_s > timeout_s:
                return []
        self._next_s = max(self._next_s, time.monotonic() - 1.0) + 1 / self._options.rate_hz
        asked_ns = now_ns()
        reading = session.read(_ANSWER_S)
        self._asked += 1
        if reading is None:
            self._health.corrupt += 1
            return []
        joints = tuple(
            counter.unwrap(count) * scale
            for counter, count, scale in zip(
                self._counters, reading.counts, self._scale, strict=True
            )
        )
        pressed = frozenset(button for bit, button in _PEDALS if reading.pedals & bit)
        middle_ns = (asked_ns + now_ns()) // 2
        return [RobotReading(middle_ns, self._asked, joints_rad=joints, pressed=pressed)]

    def close(self) -> None:
        """Ends the session, and releases the port."""
        self._closed = True
        if (session := self._session) is not None:
            with suppress(DeviceError):
                session.end()
        if self._wire is not None:
            self._wire.close()


def set_home(url: str) -> str:
    """Sets the encoders of a MicroScribe to its home position, in which it must be.

    Returns its serial number. Raises ``DeviceError`` if it does not answer.
    """
    wire = Wire(url, _BAUDRATE)
    try:
        session = HciSession(wire, url)
        session.sign_on(5.0)
        session.set_home()
        serial_number = session.serial_number()
        session.end()
        return serial_number
    finally:
        wire.close()


if __name__ == "__main__":
    print(set_home(sys.argv[1]))
