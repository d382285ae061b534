"""One thread per device: opens it, reads it, and opens it again after a loss."""

import logging
import threading
import time
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, replace
from enum import StrEnum
from typing import Generic, Protocol, TypeVar

from crenel.errors import reason_sentence, sentence
from crenel.loop_states import note_progress
from crenel.loops import Loop
from crenel.messages.message import Text, join, message, quantity, word
from crenel.station.devices.awake_clock import AWAKE
from crenel.station.devices.losses import NO_LOSSES, LossAlarm, Losses, LossWindow
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import AnswersWhileSilent, LinkHealth

log = logging.getLogger(__name__)

READ_TIMEOUT_S = 0.1
# Data older than this means a lost device, whatever its connection says: longer than a delay on a
# busy machine, and still reported within a second.
FRESH_S = 0.8
# A device that is connected and silent for this long is closed and opened again.
SILENCE_S = 3.0
# A device that may be silent is asked this often whether it is there.
ASK_ALIVE_S = 0.3
# Longer than any driver takes to open a device or to find out that it cannot.
LONGEST_OPENING_S = 60.0
FIRST_BACK_OFF_S = 0.2
LONGEST_BACK_OFF_S = 2.0
RATE_WINDOW_S = 1.0


class LinkState(StrEnum):
    ABSENT = "absent"
    """The station has no such device; one can be chosen."""
    CONNECTED = "connected"
    CONNECTING = "connecting"
    LOST = "lost"
    OFF = "off"


class NoDeviceChosenError(DeviceError):
    """The station has no such device yet."""


@dataclass(frozen=True, slots=True)
class Link:
    """State of a device. Counts include all connections since the start."""

    state: LinkState
    text: Text
    age_s: float | None
    rate_hz: float | None
    received: int
    lost: int
    corrupt: int
    silent: bool = False
    """It answers, but sends no data."""
    losing: bool = False
    """Whether much of the data is lost, or comes later and later, just now."""
    lately: Losses = NO_LOSSES


class Device(Protocol):
    """Methods that every driver has."""

    @property
    def health(self) -> LinkHealth: ...

    def close(self) -> None: ...


D = TypeVar("D", bound=Device)
I_co = TypeVar("I_co")


class DeviceReader(Generic[D, I_co]):
    """Keeps one device open and reads it, in its own thread.

    Args:
        title: the kind of device, e.g. ``arm``: a word in the messages.
        make: returns a new, unopened driver; called for each connection.
        connect: opens the driver, and returns the properties of the device.
        read: reads once, blocking at most ``READ_TIMEOUT_S``; returns the number of records.
        connected: called in the reader's thread after each opening, before the first read.
        longest_gap_s: from the properties of the device, how long it may be silent while it works;
            at least ``FRESH_S``.
        free_running: from the properties, False of a device that sends only at a trigger or a
            change: its silence is no loss while it answers ``is_alive``.
    """

    def __init__(
        self,
        title: str,
        make: Callable[[], D],
        connect: Callable[[D], I_co],
        read: Callable[[D], int],
        connected: Callable[[D, I_co], None],
        longest_gap_s: Callable[[I_co], float] = lambda info: 0.0,
        free_running: Callable[[I_co], bool] = lambda info: True,
    ) -> None:
        self._title = title
        self._make = make
        self._connect = connect
        self._read = read
        self._connected = connected
        self._longest_gap_s = longest_gap_s
        self._free_running = free_running
        self._lock = threading.Lock()
        self._stopping = threading.Event()
        self._back_off_s = FIRST_BACK_OFF_S
        self._woken = threading.Event()
        self._replacement: Callable[[], D] | None = None
        self._loop: Loop | None = None
        self._made: D | None = None
        """The driver that is being opened, or is open."""
        self._driver: D | None = None
        self._info: I_co | None = None
        self._error: Text = ""
        self._ever_connected = self._absent = False
        self._last_data_s: float | None = None
        self._last_answer_s = 0.0
        self._opened_s = 0.0
        self._counted = self._driver_counts = LinkHealth()
        """The counts of earlier connections, and of this one."""
        self._records = 0
        self._arrivals: deque[tuple[float, int]] = deque()
        self._alarm = LossAlarm()
        self._losses = LossWindow()

    def start(self) -> None:
        self._stopping.clear()
        self._loop = Loop(
            f"{self._title}-reader",
            self._use_next,
            ending=self._stopping,
            longest_s=LONGEST_OPENING_S,
        )
        self._loop.start()

    def stop(self) -> None:
        """Ends the thread and closes the device."""
        loop = self._loop
        if loop is not None:
            loop.stop(wake=self._interrupt)
            self._loop = None

    def replace(self, make: Callable[[], D]) -> None:
        """Closes the device and opens another from now on; counts and state begin again."""
        with self._lock:
            self._replacement = make
        self._interrupt()

    @property
    def error(self) -> Text:
        """Why the device cannot be opened, or was lost; empty while it is connected."""
        with self._lock:
            return self._error

    @property
    def driver(self) -> D | None:
        """The open driver; None if there is none."""
        with self._lock:
            return self._driver

    @property
    def info(self) -> I_co | None:
        """Properties of the open device; None if there is none."""
        with self._lock:
            return self._info

    @property
    def fresh(self) -> bool:
        """True while data arrives."""
        return self.link().state is LinkState.CONNECTED

    def link(self) -> Link:
        """The current state; a thread that hangs in its driver does not make it look recent."""
        now = AWAKE.now_s()
        with self._lock:
            age = None if self._last_data_s is None else now - self._last_data_s
            state, text = self._state(age, now)
            health = self._total()
            rate = self._rate(time.monotonic()) if state is LinkState.CONNECTED else None
            losing = state is LinkState.CONNECTED and self._alarm.is_on(now)
            silent = state is LinkState.CONNECTED and not self._is_fresh(age)
            counts = health.received, health.lost, health.corrupt
            self._losses.note(*counts)
            lately = self._losses.over(*counts)
        return Link(state, text, age, rate, *counts, silent, losing, lately)

    def _is_fresh(self, age_s: float | None) -> bool:
        """Whether its data is recent."""
        return age_s is not None and age_s <= self._silence_limit_s(FRESH_S)

    def _state(self, age_s: float | None, now: float) -> tuple[LinkState, Text]:
        title = word(self._title)
        if self._loop is None:
            return LinkState.OFF, message("off", title=title)
        if self._replacement is not None:
            return LinkState.CONNECTING, message("connecting", title=title)
        if self._absent:
            return LinkState.ABSENT, self._error
        if self._driver is None or self._info is None:
            if self._ever_connected:
                return LinkState.LOST, self._error or message("lost-reconnecting", title=title)
            return LinkState.CONNECTING, self._error or message("connecting", title=title)
        fresh_s = self._silence_limit_s(FRESH_S)
        if self._is_fresh(age_s):
            return LinkState.CONNECTED, message("device-connected", title=title)
        if now - self._last_answer_s <= FRESH_S:
            return LinkState.CONNECTED, message("silent-but-there", title=title)
        if now - self._opened_s <= fresh_s:
            return LinkState.CONNECTING, message("waiting-s-first-data", title=title)
        silent_s = age_s if age_s is not None else now - self._opened_s
        return LinkState.LOST, message("no-data", title=title, silent=quantity(silent_s, "s", 1))

    def _total(self) -> LinkHealth:
        """With the counts that the driver gave last: it is asked by the reader's thread alone."""
        return _sum(self._counted, self._driver_counts)

    def _rate(self, now: float) -> float | None:
        """Records per second, from the arrivals of the last second."""
        arrivals = [(at, count) for at, count in self._arrivals if now - at <= RATE_WINDOW_S]
        if len(arrivals) < 2:
            return None
        span = arrivals[-1][0] - arrivals[0][0]
        return sum(count for _, count in arrivals[1:]) / span if span > 0 else None

    def _interrupt(self) -> None:
        """Ends an opening that takes long, and the pause before the next one."""
        self._woken.set()
        with self._lock:
            opening = self._made if self._driver is None else None
        if opening is not None:
            opening.close()

    def _use_next(self) -> None:
        """One connection, and the pause after it."""
        self._woken.clear()
        self._take_replacement()
        if self._use():
            self._back_off_s = FIRST_BACK_OFF_S
        if self._stopping.is_set():
            return
        if self._woken.wait(self._back_off_s):
            self._back_off_s = FIRST_BACK_OFF_S
        else:
            self._back_off_s = min(2 * self._back_off_s, LONGEST_BACK_OFF_S)

    def _take_replacement(self) -> None:
        """Begins with another device, as after a start."""
        with self._lock:
            if self._replacement is None:
                return
            self._make, self._replacement = self._replacement, None
            self._ever_connected, self._error, self._absent = False, "", False
            self._last_data_s, self._last_answer_s = None, 0.0
            self._counted, self._records = LinkHealth(), 0
            self._arrivals.clear()
            self._alarm.clear()

    def _use(self) -> bool:
        """Makes and opens a driver and reads it until it is lost; True if any data arrived."""
        received_before = self._records
        driver: D | None = None
        try:
            driver = self._make()
            with self._lock:
                self._made = driver
            info = self._connect(driver)
            self._note_connection(driver, info)
            self._pump(driver)
        except DeviceError as error:
            self._error = device_error_text(error)
            self._absent = isinstance(error, NoDeviceChosenError)
        except Exception as error:  # an error of a driver must not end the station
            log.exception("the driver of the %s failed", self._title)
            self._error = message("s-driver-failed", title=word(self._title), error=error)
        finally:
            with self._lock:
                if driver is not None and self._driver is not None:
                    with suppress(Exception):  # one that fails may have no counts any more
                        self._driver_counts = replace(driver.health)
                self._counted, self._driver_counts = self._total(), LinkHealth()
                self._driver = self._info = self._made = None
            if driver is not None:
                driver.close()
        return self._records > received_before

    def _note_connection(self, driver: D, info: I_co) -> None:
        self._connected(driver, info)
        with self._lock:
            self._driver, self._info = driver, info
            self._ever_connected = True
            self._error = ""
            self._opened_s = AWAKE.now_s()
            self._arrivals.clear()

    def _pump(self, driver: D) -> None:
        """Reads until the station stops or has another device.

        Raises ``DeviceError`` if the device falls silent.
        """
        while not self._stopping.is_set() and self._replacement is None:
            note_progress()
            count = self._read(driver)
            now, counts = AWAKE.now_s(), replace(driver.health)
            with self._lock:
                self._driver_counts = counts
                self._alarm.note(now, self._total())
            if count:
                self._note(now, time.monotonic(), count)
                continue
            self._ask_alive(driver, now)
            heard_s = max(self._opened_s, self._last_data_s or 0.0, self._last_answer_s)
            if now - heard_s > (silence_s := self._silence_limit_s(SILENCE_S)):
                raise DeviceError(
                    message(
                        "sent-nothing-opening-again",
                        title=word(self._title),
                        silence=quantity(silence_s, "s"),
                    )
                )

    def _ask_alive(self, driver: D, now: float) -> None:
        """Asks a silent device that may be silent whether it is there."""
        if self._info is None or self._free_running(self._info):
            return
        if now - max(self._last_data_s or 0.0, self._last_answer_s) < ASK_ALIVE_S:
            return
        if isinstance(driver, AnswersWhileSilent) and driver.is_alive():
            self._last_answer_s = AWAKE.now_s()

    def _silence_limit_s(self, usual_s: float) -> float:
        """The usual silence, or a longer one that the device states."""
        return usual_s if self._info is None else max(usual_s, self._longest_gap_s(self._info))

    def _note(self, awake_s: float, now: float, count: int) -> None:
        with self._lock:
            self._last_data_s = awake_s
            self._records += count
            self._arrivals.append((now, count))
            while now - self._arrivals[0][0] > RATE_WINDOW_S:
                self._arrivals.popleft()


def device_error_text(error: DeviceError) -> Text:
    """The error as one text: what happened, and what to do."""
    if not error.remedy:
        return reason_sentence(error.what)
    return join([reason_sentence(error.what), sentence(error.remedy)], " ")


def _sum(a: LinkHealth, b: LinkHealth) -> LinkHealth:
    return LinkHealth(
        a.received + b.received, a.lost + b.lost, a.corrupt + b.corrupt, a.late + b.late
    )
