"""Tries devices: one at a time, for a limited time, and only while somebody looks."""

import threading
import time
from dataclasses import dataclass

from crenel.loops import Loop
from crenel.messages.message import Text, message, quantity
from crenel.station.bus import Bus
from crenel.station.devices.arm_device import StationArm
from crenel.station.devices.rig import Rig
from crenel.station.devices.sensor_device import StationSensor
from crenel.station.preview.line_picture import picture_of
from crenel.station.preview.preview import jpeg
from crenel.station.setup.drivers import arm_factory, sensor_factory
from crenel.station.setup.trial_view import TrialSubject, TrialView, view_arm, view_sensor

LONGEST_S = 180.0
AWAY_S = 6.0
"""A trial that nobody looks at ends after this time: the browser was closed."""
LOOK_S = 0.2


@dataclass
class _Trial:
    """A device that was opened by its driver, or one of the station's own."""

    number: int
    subject: TrialSubject
    arm: StationArm | None
    sensor: StationSensor | None
    began_s: float
    looked_s: float
    ended: Text = ""

    def open(self) -> None:
        device = self.arm or self.sensor
        if device is not None and not self.subject.in_use:
            device.reader.start()

    def close(self, why: Text) -> None:
        """Closes the device, unless it is the station's; idempotent."""
        if self.ended:
            return
        self.ended = why
        if self.subject.in_use:
            return
        if self.sensor is not None:
            self.sensor.laser_off()
        device = self.arm or self.sensor
        if device is not None:
            device.reader.stop()

    def view(self) -> TrialView:
        if self.arm is not None:
            return view_arm(self.number, self.subject, self.arm, self.ended)
        assert self.sensor is not None
        return view_sensor(self.number, self.subject, self.sensor, self.ended)


class DeviceTrials:
    """One trial at a time; a new one ends the one before. Methods may be called from any thread."""

    def __init__(self, rig: Rig, longest_s: float = LONGEST_S, away_s: float = AWAY_S) -> None:
        self._rig = rig
        self._longest_s, self._away_s = longest_s, away_s
        self._lock = threading.Lock()
        self._trial: _Trial | None = None
        self._number = 0
        self._watch: Loop | None = None

    def start(self, subject: TrialSubject) -> TrialView:
        """Opens a device, or looks at it if the station uses it."""
        with self._lock:
            self._end(message("another-device-is-tried"))
            self._number += 1
            now_s = time.monotonic()
            arm, sensor = self._devices(subject)
            trial = self._trial = _Trial(self._number, subject, arm, sensor, now_s, now_s)
            trial.open()
            if self._watch is None:
                self._watch = Loop("device-trial", self._end_when_over, LOOK_S)
                self._watch.start()
        return trial.view()

    def view(self) -> TrialView | None:
        """The present trial, or the last one; whoever looks keeps it going."""
        trial = self._trial
        if trial is None:
            return None
        trial.looked_s = time.monotonic()
        return trial.view()

    def picture(self) -> bytes | None:
        """The newest picture, or the newest line drawn, as JPEG, its longer side at most 800 px.

        None if no camera is tried, or it has sent no picture yet.
        """
        trial = self._trial
        latest = trial.sensor.frames.newest if trial is not None and trial.sensor else None
        return None if latest is None else jpeg(picture_of(latest))

    def stop(self) -> None:
        """Ends the trial and forgets it; idempotent."""
        with self._lock:
            self._end(message("trial-was-ended"))
            self._trial = None

    def close(self) -> None:
        """Ends the trial and its watch, at the end of the station."""
        if self._watch is not None:
            self._watch.stop()
        self.stop()

    def _devices(self, subject: TrialSubject) -> tuple[StationArm | None, StationSensor | None]:
        if subject.kind == "arm":
            make_arm = arm_factory(subject.driver, subject.options)
            return (self._rig.arm if subject.in_use else StationArm(Bus(), make_arm)), None
        make = sensor_factory(subject.driver, subject.options)
        return None, (
            self._rig.sensors[subject.sensor] if subject.in_use else StationSensor(Bus(), make)
        )

    def _end(self, why: Text) -> None:
        if self._trial is not None:
            self._trial.close(why)

    def _end_when_over(self) -> None:
        """Ends a trial that takes too long, or that nobody looks at any more."""
        trial = self._trial
        if trial is None or trial.ended:
            return
        now_s = time.monotonic()
        over: Text = ""
        if now_s - trial.looked_s > self._away_s:
            over = message("trial-nobody-looked")
        elif now_s - trial.began_s > self._longest_s:
            over = message("trial-takes-too-long", limit=quantity(self._longest_s / 60, "min"))
        if over:
            with self._lock:
                trial.close(over)
