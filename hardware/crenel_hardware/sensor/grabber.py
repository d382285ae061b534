"""The thread that grabs from one source, and keeps the few newest pictures for a reader."""

import logging
import threading
from collections import deque
from concurrent.futures import Future

import cv2

from crenel.loops import start_worker
from crenel.messages.message import Text, message, rounded
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import Delivery, Frame, Line, LinkHealth, SensorReading
from crenel_hardware.sensor.image_source import (
    EndOfRecordingError,
    GrabbedImage,
    GreyImage,
    ImageSource,
    LinePoints,
    NoImage,
)

log = logging.getLogger(__name__)
_JOIN_S = 5.0
_SWITCH_WITHIN_S = 15.0


class Grabber:
    """Grabs from one source until it ends, is lost, or has to stop; its reader opens it again."""

    def __init__(
        self, title: Text, source: ImageSource, stop: threading.Event, health: LinkHealth
    ) -> None:
        self._thread: threading.Thread | None = None
        self.wanted_exposure_us: float | None = None
        self._title = title
        self.source = source
        self._stop_asked = stop
        self._health = health
        self._queue: deque[SensorReading] = deque()
        self._switches: deque[tuple[Delivery, Future[None]]] = deque()
        self._changed = threading.Condition()
        self._error: DeviceError | None = None
        self._ended = False
        self._shape: tuple[int, ...] | None = None
        self._next_sequence = 0

    def size_px(self, within_s: float) -> tuple[int, int]:
        """Width and height, of the first picture unless the source waits for a trigger."""
        if not self.source.free_running and self.source.size_px is not None:
            return self.source.size_px
        with self._changed:
            self._changed.wait_for(self._has_news, within_s)
            if self._queue and isinstance(first := self._queue[0], Frame):
                height_px, width_px = first.image.shape
                return width_px, height_px
            raise self._silence_error(
                DeviceError(
                    message(
                        "gave-no-picture-within", title=self._title, time=rounded(within_s, "s")
                    ),
                    self.source.no_picture_remedy,
                )
            )

    def take(self, timeout_s: float) -> SensorReading | None:
        """The oldest that waits, or None after ``timeout_s``; raises ``DeviceError``."""
        with self._changed:
            self._changed.wait_for(
                lambda: self._queue or self._error or self._stop_asked.is_set(), timeout_s
            )
            if self._stop_asked.is_set():
                raise DeviceError(message("device-closed", title=self._title))
            if self._queue:
                self._changed.notify_all()
                return self._queue.popleft()
            if self._error is not None:
                raise self._error
            return None

    def switch(self, delivery: Delivery) -> None:
        """Has the source deliver pictures or lines, and waits until it does.

        Raises ``DeviceError`` if the source refuses, and goes on as before, or is lost.
        """
        done: Future[None] = Future()
        with self._changed:
            if self._ended or self._stop_asked.is_set():
                raise self._error or DeviceError(message("device-closed", title=self._title))
            self._switches.append((delivery, done))
        try:
            done.result(_SWITCH_WITHIN_S)
        except TimeoutError as error:
            raise DeviceError(
                message("sensor-does-not-switch", title=self._title), message("open-again")
            ) from error

    def start(self) -> None:
        self._thread = start_worker(f"grabbing {self._title!s}", self._run)

    def ask_to_stop(self) -> None:
        with self._changed:
            self._stop_asked.set()
            self._changed.notify_all()

    def end(self) -> None:
        self.ask_to_stop()
        if self._thread is not None:
            self._thread.join(_JOIN_S)

    def _run(self) -> None:
        lost: DeviceError | None = None
        try:
            while not self._stop_asked.is_set():
                self._apply_settings()
                picture = self.source.grab()
                if isinstance(picture, GrabbedImage):
                    self._enqueue(picture, self._number(picture))
                elif picture is NoImage.DAMAGED:
                    self._health.corrupt += 1
                    self._next_sequence += 1
                elif picture is NoImage.LATE:
                    self._health.late += 1
        except EndOfRecordingError:
            pass
        except DeviceError as error:
            lost = error
        except BaseException as error:  # its reader opens the device again, whatever it was
            if not isinstance(error, cv2.error):
                log.exception("grabbing from %s failed", self._title)
            lost = DeviceError(
                message("device-failed", title=self._title, error=str(error)), message("open-again")
            )
        finally:
            self._finish(lost)
            self.source.release()

    def _apply_settings(self) -> None:
        """What other threads have asked for."""
        if (exposure_us := self.wanted_exposure_us) is not None:
            self.wanted_exposure_us = None
            self.source.set_exposure_us(exposure_us)
        while self._switches:
            delivery, done = self._switches[0]
            refusal = self.source.set_delivery(delivery)
            self._switches.popleft()
            if refusal is None:
                done.set_result(None)
            else:
                done.set_exception(refusal)

    def _number(self, picture: GrabbedImage) -> int:
        """The sequence number of the next picture; counts those that the device lost before it."""
        sequence = self._next_sequence
        if picture.sequence is not None and picture.sequence > sequence:
            self._health.lost += picture.sequence - sequence
            sequence = picture.sequence
        self._next_sequence = sequence + 1
        return sequence

    def _enqueue(self, picture: GrabbedImage, sequence: int) -> None:
        reading = self._read(picture, sequence)
        with self._changed:
            if self.source.waits:
                self._changed.wait_for(
                    lambda: len(self._queue) < self.source.queue_length or self._stop_asked.is_set()
                )
            elif len(self._queue) >= self.source.queue_length:
                self._queue.popleft()
                self._health.lost += 1
            self._queue.append(reading)
            self._health.received += 1
            self._health.late += picture.late
            self._changed.notify_all()

    def _read(self, picture: GrabbedImage, sequence: int) -> SensorReading:
        """The picture or line as ``read`` returns it."""
        image = picture.image
        if isinstance(image, LinePoints):
            return Line(
                sequence,
                picture.mid_exposure_ns,
                image.u,
                image.v,
                image.intensity,
                image.sigma_px,
                *image.size_px,
                picture.exposure_us,
                picture.laser_on,
                picture.pulse,
            )
        self._require_shape(image)
        return Frame(
            sequence,
            picture.mid_exposure_ns,
            image,
            picture.exposure_us,
            laser_on=picture.laser_on,
            full_scale=picture.full_scale,
            pulse=picture.pulse,
        )

    def _require_shape(self, image: GreyImage) -> None:
        """Raises ``DeviceError`` if this is not the size of the first picture."""
        shape = image.shape
        if shape != (self._shape or shape):
            assert self._shape is not None
            raise DeviceError(
                message(
                    "picture-size-changed",
                    title=self._title,
                    width=self._shape[1],
                    height=self._shape[0],
                    new_width=shape[1],
                    new_height=shape[0],
                ),
                message("all-pictures-one-sensor-must-have"),
            )
        self._shape = shape

    def _finish(self, error: DeviceError | None) -> None:
        with self._changed:
            self._error, self._ended = error, True
            waiting = list(self._switches)
            self._switches.clear()
            self._changed.notify_all()
        for _, done in waiting:
            closed = DeviceError(message("device-closed", title=self._title))
            done.set_exception(error or closed)

    def _has_news(self) -> bool:
        return bool(self._queue) or self._ended or self._stop_asked.is_set()

    def _silence_error(self, silence: DeviceError) -> DeviceError:
        if self._stop_asked.is_set():
            return DeviceError(message("device-closed-while-opening", title=self._title))
        return self._error or silence
