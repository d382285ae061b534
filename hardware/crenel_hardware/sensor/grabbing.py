"""The common part of drivers whose pictures come from a call that blocks.

Such a call (OpenCV's ``grab``) cannot be interrupted, and a picture that nobody fetches grows old
in the system's buffers without a stamp. So a thread of the driver grabs, stamps at once, and keeps
the few newest pictures for ``read``.
"""

import threading
from collections.abc import Callable

from crenel.messages.message import Text, message
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import Delivery, LinkHealth, SensorInfo, SensorReading
from crenel_hardware.sensor.grabber import Grabber
from crenel_hardware.sensor.image_source import ImageSource


class GrabbingSensor:
    """A ``SensorDriver`` whose pictures a thread grabs from an ``ImageSource``.

    It can be switched to lines if its source delivers them.
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
        self._grabber: Grabber | None = None
        self._ending: Grabber | None = None
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
            self._grabber = grabber = Grabber(self._title, source, stop, self._health)
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
            delivers=source.delivers,
            loss_remedy=source.loss_remedy,
            offers=source.offers,
            selected=source.selected,
        )
        return self._info

    def read(self, timeout_s: float) -> SensorReading | None:
        """The next picture or line; None after ``timeout_s``, and after the end of a recording."""
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

    def set_delivery(self, delivery: Delivery) -> None:
        """Has the source send pictures or lines, and waits until it does; idempotent.

        Raises:
            DeviceError: the device is not open, cannot deliver that, or was lost.
        """
        grabber = self._grabber
        if grabber is None:
            raise DeviceError(message("device-not-open", title=self._title))
        if delivery not in grabber.source.delivers:
            raise DeviceError(message("sensor-sends-pictures-alone", title=self._title))
        grabber.switch(delivery)

    def close(self) -> None:
        """Ends a waiting ``open`` or ``read`` and releases the source; idempotent."""
        with self._state:
            self._closings += 1
            grabber, self._grabber, self._info = self._grabber or self._ending, None, None
            self._ending = None
        if grabber is not None:
            grabber.end()

    def _drop(self, grabber: Grabber) -> None:
        """Gives up a grabber without waiting for its end: the loss is to be reported at once."""
        with self._state:
            if self._grabber is grabber:
                self._grabber, self._info, self._ending = None, None, grabber
        grabber.ask_to_stop()
