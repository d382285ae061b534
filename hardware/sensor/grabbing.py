"""The common part of drivers whose pictures come from a call that blocks.

Such a call (OpenCV's ``grab``) cannot be interrupted, and a picture that nobody fetches grows old
in the system's buffers without a stamp. So a thread of the driver grabs, stamps at once, and keeps
the few newest pictures for ``read``.
"""

import threading
from collections import deque
from collections.abc import Callable

import cv2

from app.messages.message import Text, message, rounded
from hardware.errors import DeviceError
from hardware.interfaces import Frame, LinkHealth, SensorInfo
from hardware.sensor.image_source import (
    EndOfRecordingError,
    GrabbedImage,
    ImageSource,
    NoImage,
)

_JOIN_S = 5.0


class GrabbingSensor:
    """A ``SensorDriver`` whose pictures a thread grabs from an ``ImageSource``.

    A laser without a switch is taken to be wired on.

    Args:
        title: the device in words, for errors.
        connect: opens the source; its argument is an event that is set when the source must stop.
        first_within_s: how long ``open`` waits for the first picture of a source that does not
            wait for a trigger.
    """

    def __init__(
        self, title: Text, connect: Callable[[threading.Event], ImageSource], first_within_s: float
    ) -> None:
        self._title = title
        self._connect = connect
        self._first_within_s = first_within_s
        self._state = threading.Lock()
        self._closings = 0
        self._grabber: _Grabber | None = None
        self._ending: _Grabber | None = None
        self._info: SensorInfo | None = None
        self._health = LinkHealth()

    @property
    def health(self) -> LinkHealth:
        return self._health

    def open(self) -> SensorInfo:
        """Connects and waits for the first picture, which ``read`` returns; if it is open, it does
        nothing. Raises ``DeviceError``."""
        with self._state:
            if self._grabber is not None and self._info is not None:
                return self._info
            closings = self._closings
            ending, self._ending = self._ending, None
        if ending is not None:
            ending.end()
        stop = threading.Event()
        source = self._connect(stop)
        with self._state:
            if self._closings != closings:
                source.release()
                raise DeviceError(message("device-closed-while-opening", title=self._title))
            self._health = LinkHealth()
            self._grabber = grabber = _Grabber(self._title, source, stop, self._health)
            grabber.start()
        try:
            width_px, height_px = grabber.size_px(self._first_within_s)
        except DeviceError:
            self._drop(grabber)
            raise
        self._info = SensorInfo(
            name=source.name,
            serial_number=source.serial_number,
            width_px=width_px,
            height_px=height_px,
            exposure_range_us=source.exposure_range_us,
            has_laser_switch=source.has_laser_switch,
            longest_gap_s=source.longest_gap_s,
            stamps=source.stamps,
            stamp_at=source.stamp_at,
            free_running=source.free_running,
            loss_remedy=source.loss_remedy,
        )
        return self._info

    def read(self, timeout_s: float) -> Frame | None:
        """The next picture; None after ``timeout_s``, and always after the end of a recording."""
        grabber = self._grabber
        if grabber is None:
            raise DeviceError(message("device-not-open", title=self._title))
        try:
            return grabber.take(timeout_s)
        except DeviceError:
            self._drop(grabber)
            raise

    def is_alive(self) -> bool:
        """Whether the device answers, as its source states; False if it is not open."""
        grabber = self._grabber
        return grabber is not None and grabber.source.is_alive()

    def set_exposure_us(self, exposure_us: float) -> None:
        """Clipped to the range; without effect if the exposure cannot be set."""
        grabber, info = self._grabber, self._info
        if grabber is not None and info is not None:
            shortest, longest = info.exposure_range_us
            if shortest < longest:
                grabber.wanted_exposure_us = min(max(exposure_us, shortest), longest)

    def set_laser(self, on: bool) -> None:
        """Without effect if there is no switch, or the device is not open."""
        grabber = self._grabber
        if grabber is not None and grabber.source.has_laser_switch:
            grabber.source.set_laser(on)

    def close(self) -> None:
        """Ends a waiting ``open`` or ``read`` and releases the source; idempotent."""
        with self._state:
            self._closings += 1
            grabber, self._grabber, self._info = self._grabber or self._ending, None, None
            self._ending = None
        if grabber is not None:
            grabber.end()

    def _drop(self, grabber: "_Grabber") -> None:
        """Gives up a grabber without waiting for its end: the loss is to be reported at once."""
        with self._state:
            if self._grabber is grabber:
                self._grabber, self._info, self._ending = None, None, grabber
        grabber.ask_to_stop()


class _Grabber(threading.Thread):
    """Grabs from one source until it ends, is lost, or has to stop."""

    def __init__(
        self, title: Text, source: ImageSource, stop: threading.Event, health: LinkHealth
    ) -> None:
        super().__init__(name=f"grabbing {title!s}", daemon=True)
        self.wanted_exposure_us: float | None = None
        self._title = title
        self.source = source
        self._stop_asked = stop
        self._health = health
        self._queue: deque[Frame] = deque()
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
            if self._queue:
                height_px, width_px = self._queue[0].image.shape
                return width_px, height_px
            raise self._silence_error(
                DeviceError(
                    message(
                        "gave-no-picture-within", title=self._title, time=rounded(within_s, "s")
                    ),
                    self.source.no_picture_remedy,
                )
            )

    def take(self, timeout_s: float) -> Frame | None:
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

    def ask_to_stop(self) -> None:
        with self._changed:
            self._stop_asked.set()
            self._changed.notify_all()

    def end(self) -> None:
        self.ask_to_stop()
        self.join(_JOIN_S)

    def run(self) -> None:
        try:
            while not self._stop_asked.is_set():
                if (exposure_us := self.wanted_exposure_us) is not None:
                    self.wanted_exposure_us = None
                    self.source.set_exposure_us(exposure_us)
                picture = self.source.grab()
                if isinstance(picture, GrabbedImage):
                    self._enqueue(picture, self._number(picture))
                elif picture is NoImage.DAMAGED:
                    self._health.corrupt += 1
                    self._next_sequence += 1
                elif picture is NoImage.LATE:
                    self._health.late += 1
        except EndOfRecordingError:
            self._finish(None)
        except DeviceError as error:
            self._finish(error)
        except cv2.error as error:
            self._finish(
                DeviceError(
                    message("device-failed", title=self._title, error=error), message("open-again")
                )
            )
        finally:
            self.source.release()

    def _number(self, picture: GrabbedImage) -> int:
        """The sequence number of the next picture; counts those that the device lost before it."""
        sequence = self._next_sequence
        if picture.sequence is not None and picture.sequence > sequence:
            self._health.lost += picture.sequence - sequence
            sequence = picture.sequence
        self._next_sequence = sequence + 1
        return sequence

    def _enqueue(self, picture: GrabbedImage, sequence: int) -> None:
        shape = picture.image.shape
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
        frame = Frame(
            sequence,
            picture.mid_exposure_ns,
            picture.image,
            picture.exposure_us,
            laser_on=picture.laser_on,
            full_scale=picture.full_scale,
            pulse=picture.pulse,
        )
        with self._changed:
            if self.source.waits:
                self._changed.wait_for(
                    lambda: len(self._queue) < self.source.queue_length or self._stop_asked.is_set()
                )
            elif len(self._queue) == self.source.queue_length:
                self._queue.popleft()
                self._health.lost += 1
            self._queue.append(frame)
            self._health.received += 1
            self._health.late += picture.late
            self._changed.notify_all()

    def _finish(self, error: DeviceError | None) -> None:
        with self._changed:
            self._error, self._ended = error, True
            self._changed.notify_all()

    def _has_news(self) -> bool:
        return bool(self._queue) or self._ended or self._stop_asked.is_set()

    def _silence_error(self, silence: DeviceError) -> DeviceError:
        if self._stop_asked.is_set():
            return DeviceError(message("device-closed-while-opening", title=self._title))
        return self._error or silence
