"""The sensors of a running scan: their frames to stripes, their stripes to points."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from crenel.errors import OperationError
from crenel.formats.recording.reader import (
    ARM_DELAY,
    ARM_DELAY_AT,
    ARM_DRIFT,
    SCAN_CALIBRATION,
    SENSOR_SERIAL,
)
from crenel.formats.recording.topics import sensor_key
from crenel.formats.settings.scan_settings import ScanSettings
from crenel.messages.message import message
from crenel.metrology.time_delay.course import NO_DELAY, DelayCourse
from crenel.metrology.transforms import Floats
from crenel.station.devices.arm_device import StationArm
from crenel.station.devices.sensor_device import StationSensor
from crenel.station.scan.extraction import Extraction, extraction_by
from crenel.station.scan.points import PointMaker, ScanCalibration, Show
from crenel.station.scan.recorder import StripeFrame
from crenel.station.scan.scan_speed import ScanSpeed
from crenel_hardware.clock import now_ns
from crenel_hardware.interfaces import Frame, SensorReading

# Frames are worked on so many at a time, where they come faster than the wait for more.
BATCH_FRAMES = 16
# Frames wait to be worked on in so much memory, whatever else the machine is busy with.
WAITING_BYTES = 1 << 28
FEWEST_WAITING, MOST_WAITING = 32, 1024


@dataclass(frozen=True)
class ScanSensor:
    """A sensor to scan with."""

    name: str
    """Empty of the only one."""
    device: StationSensor
    calibration: ScanCalibration


class ScanSource:
    """One sensor of a running scan."""

    def __init__(
        self, arm: StationArm, used: ScanSensor, settings: ScanSettings, show: Show
    ) -> None:
        self.name, self.calibration = used.name, used.calibration
        self.speed = ScanSpeed(arm, settings.blur_limit_mm)
        self.points = PointMaker(used.calibration, show)
        device = used.device
        self.delay = _delay_of(settings, used)
        """As the recording began with."""
        self._device = device
        self._lost_before = device.reader.link().lost
        self._settings = self._own(settings)
        self._extraction = self._by_settings()
        self.tap = device.frames.tap(_queue_length(device))

    @property
    def longest_delay_s(self) -> float:
        """By how much the arm's readings may come later than the frames."""
        return max(self.delay.delay_ns / 1e9, 0.0)

    @property
    def lost_frames(self) -> int:
        """Frames that the sensor lost, and those that found the queue full here."""
        return self.tap.dropped + self._device.reader.link().lost - self._lost_before

    def apply(self, settings: ScanSettings) -> None:
        """Goes on by other settings, but for the delay."""
        self._settings = self._own(settings)
        self._extraction = self._by_settings()
        self.speed.limit_mm = settings.blur_limit_mm

    def metadata(self) -> dict[str, str]:
        """What the recording says of the sensor."""
        named = {
            SCAN_CALIBRATION: self.calibration.id,
            SENSOR_SERIAL: self.calibration.sensor_serial,
            ARM_DELAY: str(round(self.delay.delay_ns)),
        }
        if self.delay.drift_ppm:
            named |= {
                ARM_DELAY_AT: str(self.delay.stamp_ns),
                ARM_DRIFT: str(self.delay.drift_ppm),
            }
        return {sensor_key(key, self.name): value for key, value in named.items()}

    def extract(self, frames: Sequence[SensorReading]) -> list[StripeFrame]:
        """On a worker's thread: the stripes of frames, and those that the sensor found itself.

        Where frames wait for it, the stripe is followed from the first one on.
        """
        extraction = self._extraction
        for frame in frames:
            self._check_size(frame)
        pictures = [frame for frame in frames if isinstance(frame, Frame)]
        band = extraction.band(pictures[0].image) if len(pictures) == BATCH_FRAMES else None
        found = []
        for frame in frames:
            if not isinstance(frame, Frame):
                stripe = extraction.line_stripe(frame)
            else:
                stripe = band.extract(frame.image) if band else extraction.stripe(frame.image)
            height, width = _shape(frame)
            stamp_ns, exposure_us = frame.mid_exposure_ns, frame.exposure_us
            found.append(StripeFrame(stamp_ns, stripe, width, height, exposure_us, self.name))
        return found

    def judge_speed(self, frame: StripeFrame, readings: Floats, frames: int) -> bool:
        """Judges whether the sensor went too fast in the last of some frames; False if unknown."""
        stamp_ns = frame.stamp_ns + self.delay.at_one(frame.stamp_ns)
        before_reading = self.speed.reading_before(stamp_ns)
        if before_reading is None or not len(frame.stripe.u):
            return False
        before, at = self.calibration.sensor_poses(np.stack([before_reading, readings]))
        stripe_mm, spread = self.calibration.points([frame.stripe], np.eye(4)[None])
        poses = (before, at)
        return self.speed.judge(stripe_mm, spread, poses, stamp_ns, frame.exposure_us, frames)

    def end(self) -> None:
        """Takes no more frames."""
        self._device.frames.untap(self.tap)

    def _own(self, settings: ScanSettings) -> ScanSettings:
        """Chooses the sensor that the zones belong to: the one of several in whose picture they
        were drawn."""
        mask = settings.mask
        if not self.name or mask is None or mask.sensor_serial == self.calibration.sensor_serial:
            return settings
        return settings.model_copy(update={"mask": None})

    def _by_settings(self) -> Extraction:
        """As set, where the calibration has the line."""
        calibration = self.calibration
        return extraction_by(self._settings, calibration.stripe_axis, calibration.line_bounds)

    def _check_size(self, frame: SensorReading) -> None:
        """Pixels of another picture would become points in wrong places."""
        camera, shape = self.calibration.camera, _shape(frame)
        if shape != (camera.height_px, camera.width_px):
            raise OperationError(
                "image-size",
                message("sensor-now-sends-pictures-pixels", size=" × ".join(map(str, shape[::-1]))),
                message(
                    "calibration-is-for-pixels", width=camera.width_px, height=camera.height_px
                ),
                message("set-sensor-back-scan-again"),
            )


def check_delay_age(settings: ScanSettings, used: ScanSensor) -> None:
    """Raises ``OperationError`` where the delay drifts and was determined too long ago."""
    _delay_of(settings, used).check_age(np.array([now_ns()]))


def _delay_of(settings: ScanSettings, used: ScanSensor) -> DelayCourse:
    """The delay of the arm's stamps that is set for a sensor."""
    if used.device.is_paired:  # pulses have no delay
        return NO_DELAY
    return settings.delay_of(used.calibration.arm_serial, used.calibration.sensor_serial)


def _shape(frame: SensorReading) -> tuple[int, ...]:
    """Height and width of the picture; more numbers if it is not grey."""
    if isinstance(frame, Frame):
        return frame.image.shape
    return frame.height_px, frame.width_px


def _queue_length(sensor: StationSensor) -> int:
    """How many of its frames may wait, of up to 16 bits."""
    info = sensor.info
    if info is None:
        return FEWEST_WAITING
    frame_bytes = 2 * info.width_px * info.height_px
    return min(max(WAITING_BYTES // frame_bytes, FEWEST_WAITING), MOST_WAITING)
