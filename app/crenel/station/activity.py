"""Which activity has the arm: one at a time, visible to everyone.

An activity keeps the arm while its scan runs or its guided session is open. Another one cannot
begin meanwhile: it asks for the end of the present one, by its id. A session that was ended in
this way stays open, without the arm, and asks in its turn before it goes on.
"""

import secrets
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from datetime import datetime
from typing import Literal

from crenel.errors import OperationError
from crenel.findings import Finding
from crenel.messages.message import Text, message
from crenel.station.bus import Bus
from crenel.timestamps import utc_now

TOPIC = "activity"
ActivityKind = Literal[
    "scan", "delay", "calibration", "verification", "performance", "arm", "inspection"
]
TITLES: dict[ActivityKind, Text] = {
    "scan": message("activity-scan"),
    "delay": message("activity-delay"),
    "calibration": message("activity-calibration"),
    "verification": message("activity-verification"),
    "performance": message("activity-performance"),
    "arm": message("activity-arm"),
    "inspection": message("activity-inspection"),
}


@dataclass(frozen=True, slots=True)
class Activity:
    """What has the arm, by whom, and since when."""

    id: str
    kind: ActivityKind
    title: Text
    who: str
    """Who works at it; empty where that is not known, as after a restart."""
    since: str
    """ISO 8601, UTC."""


@dataclass(frozen=True, slots=True)
class ArmUse:
    """The topic ``activity``."""

    activity: Activity | None = None
    """None while nothing has the arm."""
    note: Finding | None = None
    """What the station ended by itself; it stays until the next activity begins."""


class ArmInUseError(OperationError):
    """Another activity has the arm."""

    def __init__(self, activity: Activity) -> None:
        since = f"{datetime.fromisoformat(activity.since):%Y-%m-%d %H:%M}"
        super().__init__(
            "arm-in-use",
            message("arm-is-in-use", title=activity.title),
            message("arm-used-since-by", since=since, who=activity.who)
            if activity.who
            else message("arm-used-since", since=since),
            message("end-it-first"),
        )
        self.activity = activity


class Activities:
    """Gives the arm to one activity at a time; any thread may call it.

    Args:
        who: names the person who has control, or had it last.
    """

    def __init__(self, bus: Bus, who: Callable[[], str]) -> None:
        self._bus, self._who = bus, who
        self._lock = threading.RLock()
        self._is_open: dict[ActivityKind, Callable[[], bool]] = {}
        self._use = ArmUse()
        self._beginning = 0
        """How many acts are under way that may open the present activity."""
        bus.publish(TOPIC, self._use)

    def add(self, kind: ActivityKind, is_open: Callable[[], bool]) -> None:
        """Makes a kind known.

        Args:
            is_open: whether one of this kind is under way; it has the arm no longer than that.
        """
        self._is_open[kind] = is_open

    @property
    def use(self) -> ArmUse:
        """What has the arm now."""
        with self._lock:
            self.release_ended()
            return self._use

    def release_ended(self) -> None:
        """Takes the arm from an activity that has ended by itself, and says so."""
        with self._lock:
            activity = self._use.activity
            if activity is not None and not self._beginning and not self._is_open[activity.kind]():
                self._set(replace(self._use, activity=None))

    @contextmanager
    def using(self, kind: ActivityKind) -> Iterator[None]:
        """Everything that moves, reads or lights for an activity stands in such a block.

        Raises:
            ArmInUseError: another one has the arm.
        """
        with self._lock:
            self._take(kind)
            self._beginning += 1
        try:
            yield
        finally:
            with self._lock:
                self._beginning -= 1
                self.release_ended()

    def resume(self, kind: ActivityKind, since: str) -> None:
        """A session that a restart found open has the arm, unless one has it already."""
        with self._lock:
            if self.use.activity is None:
                self._set(ArmUse(_activity(kind, "", since)))

    def end(self, activity_id: str, stop: Callable[[], None]) -> None:
        """Takes the arm from an activity.

        Args:
            stop: stops what moves, and switches the lasers off.

        Raises:
            ArmInUseError: another one has the arm by now, which nobody has asked about.
        """
        with self._lock:
            activity = self.use.activity
            if activity is None:
                return
            if activity.id != activity_id:
                raise ArmInUseError(activity)
            stop()
            self._set(ArmUse())
        self._bus.event(TOPIC, message("activity-ended", title=activity.title, who=self._who()))

    def note(self, note: Finding) -> None:
        """Says what the station ended by itself."""
        with self._lock:
            self._set(replace(self.use, note=note))

    def _take(self, kind: ActivityKind) -> None:
        activity, who = self.use.activity, self._who()
        if activity is None:
            self._set(ArmUse(_activity(kind, who, utc_now())))
        elif activity.kind != kind:
            raise ArmInUseError(activity)
        elif who and activity.who != who:
            self._set(replace(self._use, activity=replace(activity, who=who)))

    def _set(self, use: ArmUse) -> None:
        if use != self._use:
            self._use = use
            self._bus.publish(TOPIC, use)


def _activity(kind: ActivityKind, who: str, since: str) -> Activity:
    return Activity(secrets.token_hex(8), kind, TITLES[kind], who, since)
