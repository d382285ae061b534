"""The live picture for the browser: encoded once for all viewers, and described in words."""

import json
import struct
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import asdict, dataclass
from typing import Literal

import cv2
import numpy as np

from crenel.errors import OperationError, sentence
from crenel.findings import Finding
from crenel.formats.settings.mask import Mask
from crenel.formats.settings.scan_settings import AUTOMATIC, ScanSettings
from crenel.loop_states import waiting
from crenel.loops import Loop
from crenel.messages.message import message
from crenel.metrology.detection.image_quality import Image, ImageQuality
from crenel.metrology.image import saturation_level
from crenel.metrology.stripe import Stripe
from crenel.metrology.targets.target import CalibrationTarget
from crenel.station.bus import Bus
from crenel.station.devices.arm_device import StationArm
from crenel.station.devices.sensor_device import StationSensor
from crenel.station.devices.stillness import Stillness
from crenel.station.preview.capture_aids import (
    CaptureAid,
    distance_aid,
    exposure_aid,
    focus_aid,
    framing_aid,
    line_aid,
)
from crenel.station.preview.image_quality import Box, measure_image, saturation, stillness_findings
from crenel.station.preview.line_picture import draw_line
from crenel.station.preview.target_overlay import DetectedCorner, Segment
from crenel.station.preview.target_watch import NO_DETECTION, TargetDetection, TargetWatch
from crenel.station.scan.extraction import Extraction, extraction_by
from crenel.station.working_distance import Band, WorkingRange
from crenel_hardware.clock import now_ns
from crenel_hardware.interfaces import Frame, Line, SensorReading

TOPIC = "preview"
LONGEST_SIDE_PX = 800
JPEG_QUALITY = 75
SHORTEST_PERIOD_S = 1 / 15
UNWATCHED_PERIOD_S = 1.0
"""While nobody watches, what is seen of the object is only said in words."""
WORDS_PERIOD_S = 0.3
STRIPE_POINTS = 200
LINES_PERIOD_S = 2.0
"""Whether there are two lines is looked at so often."""


@dataclass(frozen=True)
class PreviewHeader:
    """Data that accompany a picture; pixels are those of the full frame."""

    seq: int
    width_px: int
    height_px: int
    age_s: float
    stripe: tuple[tuple[float, float], ...]
    corners: tuple[DetectedCorner, ...]
    outline: tuple[Segment, ...]
    saturated_percent: float
    laser_on: bool
    arm_still: bool
    findings: tuple[Finding, ...]
    saturated: tuple[Box, ...] = ()
    band: Band | None = None
    aids: tuple[CaptureAid, ...] = ()


@dataclass(frozen=True)
class PreviewImage:
    """A picture with its header."""

    header: PreviewHeader
    jpeg: bytes

    def to_bytes(self) -> bytes:
        """Length of the header (4 bytes, big-endian), the header as JSON, the JPEG."""
        header = json.dumps(asdict(self.header), ensure_ascii=False).encode()
        return struct.pack(">I", len(header)) + header + self.jpeg


class Preview:
    """Publishes the newest picture: at most 15 per second while someone watches, one while the
    object is searched for and nobody does."""

    def __init__(self, bus: Bus, arm: StationArm, sensor: StationSensor) -> None:
        self._bus = bus
        self._arm = arm
        self._sensor = sensor
        self._objects = TargetWatch()
        self._axis: Literal["u", "v"] = "u"
        self._settings = AUTOMATIC
        self._extraction = Extraction()
        self._viewers = 0
        self._detecting = False
        self._latest: PreviewImage | None = None
        self._lines: tuple[float, tuple[Finding, ...]] = (float("-inf"), ())
        self._words: tuple[float, ImageQuality | None, tuple[Finding, ...]] = (0.0, None, ())
        self._distances: WorkingRange | None = None
        self._watched = threading.Condition()
        self._sequence = 0
        self._shown: tuple[StationSensor, int] = (sensor, -1)
        """The frame of the newest picture."""
        self._ending = threading.Event()
        self._loop: Loop | None = None

    def start(self) -> None:
        self._ending.clear()
        self._objects.start()
        self._loop = Loop("preview", self._show_next, ending=self._ending)
        self._loop.start()

    def stop(self) -> None:
        self._objects.stop()
        if self._loop is not None:
            self._loop.stop(wake=self._wake)
            self._loop = None

    def _wake(self) -> None:
        with self._watched:
            self._watched.notify()

    def use_sensor(self, sensor: StationSensor) -> None:
        """Shows another sensor from now on."""
        self._sensor = sensor

    def add_viewer(self) -> None:
        with self._watched:
            self._viewers += 1
            self._watched.notify()

    def remove_viewer(self) -> None:
        with self._watched:
            self._viewers -= 1

    @contextmanager
    def watch(self) -> Iterator[None]:
        """Pictures are made while at least one such block is open."""
        self.add_viewer()
        try:
            yield
        finally:
            self.remove_viewer()

    def detect(self, item: CalibrationTarget | None) -> None:
        """Searches for the object from now on; None ends the search."""
        self._objects.watch(item)
        with self._watched:
            self._detecting = item is not None
            self._watched.notify()

    @contextmanager
    def resting(self) -> Iterator[None]:
        """The search for the object pauses while such a block is open."""
        self._objects.rest(True)
        try:
            yield
        finally:
            self._objects.rest(False)

    def set_stripe_axis(self, axis: Literal["u", "v"]) -> None:
        self._axis = axis
        self._extraction = extraction_by(self._settings, axis)

    @property
    def extraction(self) -> Extraction:
        """Settings for extracting the stripe that is drawn on the picture."""
        return self._extraction

    @property
    def mask(self) -> Mask | None:
        """The zones of the picture in which nothing is measured."""
        return self._settings.mask

    def set_settings(self, settings: ScanSettings) -> None:
        """Settings for extracting the stripe that is drawn on the picture."""
        self._settings = settings
        self._extraction = extraction_by(settings, self._axis)

    def set_calibration(self, distances: WorkingRange | None) -> None:
        """Sets the source of distances in the picture; None if there is none."""
        self._distances = distances

    def latest(self) -> PreviewImage | None:
        """The newest picture; None before the first."""
        return self._latest

    def _show_next(self) -> None:
        """Publishes the newest picture, if there is another one and somebody wants it."""
        with waiting(), self._watched:
            self._watched.wait_for(
                lambda: self._ending.is_set() or self._detecting or self._viewers > 0
            )
        if self._ending.is_set():
            return
        started_s = time.monotonic()
        sensor, shown = self._sensor, self._shown
        before = shown[1] if shown[0] is sensor else -1
        frame = sensor.frames.wait_newest(_other_than(before), 0.2)
        if frame is None:
            return
        self._shown = (sensor, frame.sequence)
        self._sequence += 1
        self._latest = (
            self._picture(frame, self._sequence)
            if isinstance(frame, Frame)
            else self._line_picture(frame, self._sequence)
        )
        self._bus.publish(TOPIC, self._latest)
        self._rest_since(started_s)

    def _rest_since(self, started_s: float) -> None:
        """Until the next picture is due: at once for a new viewer of one that nobody watched."""
        time.sleep(max(0.0, started_s + SHORTEST_PERIOD_S - time.monotonic()))
        with self._watched:
            self._watched.wait_for(
                lambda: self._ending.is_set() or self._viewers > 0,
                max(0.0, started_s + UNWATCHED_PERIOD_S - time.monotonic()),
            )

    def _picture(self, frame: Frame, sequence: int) -> PreviewImage:
        stripe = self._stripe(frame)
        self._objects.offer(frame, stripe)
        stillness = self._arm.stillness()
        seen = self._current_detection(stillness)
        measures, words = self._measure(frame.image)
        findings = [*stillness_findings(stillness), *words, *self._about_lines(frame)]
        if seen.finding is not None:
            findings.append(seen.finding)
        height, width = frame.image.shape
        percent, boxes = saturation(frame.image)
        distances = self._distances_of(width, height)
        header = PreviewHeader(
            seq=sequence,
            width_px=width,
            height_px=height,
            age_s=(now_ns() - frame.mid_exposure_ns) / 1e9,
            stripe=decimate(stripe),
            corners=seen.corners,
            outline=seen.outline,
            saturated_percent=percent,
            laser_on=frame.laser_on,
            arm_still=stillness.still,
            findings=tuple(findings),
            saturated=boxes,
            band=distances.band if distances is not None else None,
            aids=tuple(self._aids(frame, stripe, seen, measures, distances)),
        )
        return PreviewImage(header, jpeg(frame.image))

    def _line_picture(self, line: Line, sequence: int) -> PreviewImage:
        """The line on a dark ground: of pictures that the sensor keeps to itself, nothing is
        known."""
        stripe = self._line_stripe(line)
        stillness = self._arm.stillness()
        distances = self._distances_of(line.width_px, line.height_px)
        away = distances.stripe_distance(stripe) if distances is not None and stripe else None
        header = PreviewHeader(
            seq=sequence,
            width_px=line.width_px,
            height_px=line.height_px,
            age_s=(now_ns() - line.mid_exposure_ns) / 1e9,
            stripe=decimate(stripe),
            corners=(),
            outline=(),
            saturated_percent=0.0,
            laser_on=line.laser_on,
            arm_still=stillness.still,
            findings=tuple(stillness_findings(stillness)),
            band=distances.band if distances is not None else None,
            aids=() if away is None else (distance_aid(away),),
        )
        return PreviewImage(header, jpeg(draw_line(line)))

    def _line_stripe(self, line: Line) -> Stripe | None:
        if not line.laser_on:
            return None
        try:
            return self._extraction.line_stripe(line)
        except OperationError:
            return None

    def _distances_of(self, width_px: int, height_px: int) -> WorkingRange | None:
        """In pictures of this size; None if the calibration is of another."""
        distances = self._distances
        return distances if distances is not None and distances.fits(width_px, height_px) else None

    def _aids(
        self,
        frame: Frame,
        stripe: Stripe | None,
        seen: TargetDetection,
        measures: ImageQuality | None,
        distances: WorkingRange | None,
    ) -> Iterator[CaptureAid]:
        """For the line if only the line matters, otherwise for the object."""
        if frame.laser_on and not self._detecting:
            if stripe is None:
                return
            yield from some(line_aid(frame.image, stripe))
            away = distances.stripe_distance(stripe) if distances is not None else None
            yield from some(distance_aid(away) if away is not None else None)
            return
        if measures is not None:
            yield exposure_aid(measures)
            yield from some(focus_aid(measures))
        height, width = frame.image.shape
        yield from some(framing_aid(seen.outline, width, height))

    def _current_detection(self, stillness: Stillness) -> TargetDetection:
        """The detection of the object, unless the camera has moved since."""
        seen = self._objects.detection
        if seen is NO_DETECTION or not self._arm.has_moved_since(seen.stamp_ns):
            return seen
        if stillness.still:
            self._objects.forget(seen)
        return NO_DETECTION

    def _about_lines(self, frame: Frame) -> tuple[Finding, ...]:
        """Whether two lines are in the picture, looked at again from time to time."""
        if not frame.laser_on:
            self._lines = (float("-inf"), ())
            return ()
        looked_s, known = self._lines
        if time.monotonic() - looked_s < LINES_PERIOD_S:
            return known
        found: tuple[Finding, ...] = ()
        with suppress(OperationError):
            if self._extraction.sees_two_lines(frame.image):
                remedy = sentence(message("switch-one-laser-off-or-mask-its-place"))
                found = (Finding("attention", message("two-lines-in-this-picture"), remedy),)
        self._lines = (time.monotonic(), found)
        return found

    def _stripe(self, frame: Frame) -> Stripe | None:
        if not frame.laser_on:
            return None
        # while an object is searched for, the complete line is extracted, as for its calibration
        extraction = Extraction(self._axis) if self._detecting else self._extraction
        try:
            return extraction.stripe(frame.image)
        except OperationError:
            return None

    def _measure(self, image: Image) -> tuple[ImageQuality | None, tuple[Finding, ...]]:
        """Measures and renders texts a few times per second: faster, nobody could read them."""
        made_s, measures, words = self._words
        now = time.monotonic()
        if now - made_s > WORDS_PERIOD_S:
            measures, findings = measure_image(image)
            words = tuple(findings)
            self._words = (now, measures, words)
        return measures, words


def some(aid: CaptureAid | None) -> tuple[CaptureAid, ...]:
    """The aid, if there is one."""
    return () if aid is None else (aid,)


def jpeg(image: Image) -> bytes:
    """The picture as JPEG, its longer side at most 800 px."""
    height, width = image.shape
    scale = min(1.0, LONGEST_SIDE_PX / max(height, width))
    small = cv2.resize(
        image, (round(width * scale), round(height * scale)), interpolation=cv2.INTER_AREA
    )
    if image.dtype != np.uint8:
        small = cv2.convertScaleAbs(small, alpha=255.0 / saturation_level(image))
    _, encoded = cv2.imencode(".jpg", small, [cv2.IMWRITE_JPEG_QUALITY, JPEG_QUALITY])
    return encoded.tobytes()


def decimate(stripe: Stripe | None) -> tuple[tuple[float, float], ...]:
    """At most 200 points of a stripe, evenly spaced."""
    if stripe is None or not len(stripe.u):
        return ()
    every = max(1, -(-len(stripe.u) // STRIPE_POINTS))
    u, v = np.round(stripe.u[::every], 1), np.round(stripe.v[::every], 1)
    return tuple(zip(u.tolist(), v.tolist(), strict=True))


def _other_than(sequence: int) -> Callable[[SensorReading], bool]:
    return lambda frame: frame.sequence != sequence
