"""What the drivers have in common whose pictures come from a call that blocks.

Such a call (OpenCV's ``grab``) cannot be interrupted, and a picture that nobody
fetches grows old in the system's buffers without a stamp. So a thread of the driver's
own grabs, stamps at once, and keeps the few newest pictures for ``read``.
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
    GreyImage,
    ImageSource,
)

_QUEUE_LENGTH = 4
_JOIN_S = 5.0


class GrabbingSensor:
    """A sensor without a laser switch whose pictures a thread grabs. Meets ``SensorDriver``.

    The laser is taken to be wired on.

    Args:
        title: the device in words, for errors.
        connect: opens the source; given an event that is set when it shall stop.
        first_within_s: how long ``open`` waits for the first picture.
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
        self._info: SensorInfo | None = None
        self._health = LinkHealth()

    @property
    def health(self) -> LinkHealth:
        return self._health

    def open(self) -> SensorInfo:
        """Connects and waits for the first picture, which ``read`` will give.

        Open already, it does nothing. Raises ``DeviceError``.
        """
        with self._state:
            if self._grabber is not None and self._info is not None:
                return self._info
            closings = self._closings
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
            image = grabber.first_image(self._first_within_s)
        except DeviceError:
            self._drop(grabber)
            raise
        self._info = SensorInfo(
            name=source.name,
            serial_number=source.serial_number,
            width_px=image.shape[1],
            height_px=image.shape[0],
            exposure_range_us=source.exposure_range_us,
            has_laser_switch=False,
        )
        return self._info

    def read(self, timeout_s: float) -> Frame | None:
        """The next picture; None after ``timeout_s``, and ever after a recording's end."""
        grabber = self._grabber
        if grabber is None:
            raise DeviceError(message("device-not-open", title=self._title))
        try:
            return grabber.take(timeout_s)
        except DeviceError:
            self._drop(grabber)
            raise

    def set_exposure_us(self, exposure_us: float) -> None:
        """Clipped to the range; without effect where the exposure cannot be set."""
        grabber, info = self._grabber, self._info
        if grabber is not None and info is not None:
            shortest, longest = info.exposure_range_us
            if shortest < longest:
                grabber.wanted_exposure_us = min(max(exposure_us, shortest), longest)

    def set_laser(self, on: bool) -> None:
        """Without effect: there is no switch."""

    def close(self) -> None:
        """Ends a waiting ``open`` or ``read`` and releases the source; idempotent."""
        with self._state:
            self._closings += 1
            grabber, self._grabber, self._info = self._grabber, None, None
        if grabber is not None:
            grabber.end()

    def _drop(self, grabber: "_Grabber") -> None:
        with self._state:
            if self._grabber is grabber:
                self._grabber, self._info = None, None
        grabber.end()


class _Grabber(threading.Thread):
    """Grabs from one source until it ends, is lost, or has to stop."""

    def __init__(
        self, title: Text, source: ImageSource, stop: threading.Event, health: LinkHealth
    ) -> None:
        super().__init__(name=f"grabbing {title!s}", daemon=True)
        self.wanted_exposure_us: float | None = None
        self._title = title
        self._source = source
        self._stop_asked = stop
        self._health = health
        self._queue: deque[Frame] = deque()
        self._changed = threading.Condition()
        self._error: DeviceError | None = None
        self._ended = False
        self._shape: tuple[int, ...] | None = None

    def first_image(self, within_s: float) -> GreyImage:
        with self._changed:
            self._changed.wait_for(self._has_news, within_s)
            if self._queue:
                return self._queue[0].image
            raise self._silence_error(
                DeviceError(
                    message(
                        "gave-no-picture-within", title=self._title, time=rounded(within_s, "s")
                    ),
                    message("check-cable-no-other-program-uses"),
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

    def end(self) -> None:
        with self._changed:
            self._stop_asked.set()
            self._changed.notify_all()
        self.join(_JOIN_S)

    def run(self) -> None:
        sequence = 0
        try:
            while not self._stop_asked.is_set():
                if (exposure_us := self.wanted_exposure_us) is not None:
                    self.wanted_exposure_us = None
                    self._source.set_exposure_us(exposure_us)
                picture = self._source.grab()
                if picture is None:
                    self._health.corrupt += 1
                else:
                    self._enqueue(picture, sequence)
                sequence += 1
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
            self._source.release()

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
            sequence, picture.mid_exposure_ns, picture.image, picture.exposure_us, laser_on=True
        )
        with self._changed:
            if self._source.waits:
                self._changed.wait_for(
                    lambda: len(self._queue) < _QUEUE_LENGTH or self._stop_asked.is_set()
                )
            elif len(self._queue) == _QUEUE_LENGTH:
                self._queue.popleft()
                self._health.lost += 1
            self._queue.append(frame)
            self._health.received += 1
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
