"""The simulated sensor when its camera finds the line itself, as cameras with such a circuit do.

Per column, the centre of gravity of the pixels around the brightest one. No code is shared with
the station's own extraction.
"""

import numpy as np
from numpy.typing import NDArray

from crenel.messages.message import message
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import Delivery, Frame, Line, SensorInfo, SensorReading
from crenel_hardware.simulator.rendering.noise import Detector, RawImage
from crenel_hardware.simulator.rendering.sensor import SharedRenderer, SimulatedSensor

REACH_PX = 5
"""Pixels to each side of the brightest one."""
THRESHOLD_DN = 20.0
"""Above the dark level, in 8-bit digits; a fainter column has no point."""
NOISE_FLOOR = 4.0
"""Pixels count from so many standard deviations of the read noise above the dark level."""
SPECKLE_SHARE = 0.5
"""The share of contrast times width by which speckle moves the centre, in standard deviations."""


class LineSensor(SimulatedSensor):
    """Meets ``SensorDriver`` and ``DeliversLines``."""

    def __init__(
        self,
        shared_renderer: SharedRenderer,
        info: SensorInfo,
        rate_hz: float,
        seed: int = 0,
        early_ns: int = 0,
    ) -> None:
        super().__init__(shared_renderer, info, rate_hz, seed, early_ns)
        self._delivery = _first_delivery(info)

    def set_delivery(self, delivery: Delivery) -> None:
        with self._state:
            self._check_open()
            if delivery not in self._info.delivers:
                raise DeviceError(message("simulated-sensor-cannot-deliver"))
            self._delivery = delivery

    def close(self) -> None:
        super().close()
        self._delivery = _first_delivery(self._info)

    def _deliver(self, frame: Frame) -> SensorReading:
        if self._delivery == "picture":
            return frame
        return find_line(frame, self._shared_renderer.detector)


def find_line(frame: Frame, detector: Detector) -> Line:
    """Centres of gravity of the columns that are bright somewhere, and their deviations."""
    image, scale = frame.image, 2.0 ** (detector.bits - 8)
    height, width = image.shape
    brightest = image.argmax(axis=0)
    columns = np.arange(width)
    peak = image[brightest, columns] - scale * detector.dark_dn
    lit = (peak >= scale * THRESHOLD_DN) & (brightest >= REACH_PX)
    lit &= brightest < height - REACH_PX
    columns, first, peak = columns[lit], brightest[lit] - REACH_PX, peak[lit]
    offsets = np.arange(2 * REACH_PX + 1.0)[:, None]
    light = image[first + offsets.astype(int), columns] / scale - detector.dark_dn
    light[light < NOISE_FLOOR * detector.read_dn] = 0.0
    total = light.sum(axis=0)
    centre = (offsets * light).sum(axis=0) / total
    moment = (offsets - centre) ** 2
    noise = detector.read_dn**2 + detector.shot_dn * light
    noise_px = np.sqrt((moment * noise).sum(axis=0)) / total
    width_px = np.sqrt((moment * light).sum(axis=0) / total)
    speckle_px = SPECKLE_SHARE * detector.speckle_contrast * width_px
    return Line(
        frame.sequence,
        frame.mid_exposure_ns,
        columns.astype(np.float64),
        first + centre,
        peak.astype(np.float64),
        np.hypot(noise_px, speckle_px),
        width,
        height,
        frame.exposure_us,
        frame.laser_on,
        frame.pulse,
    )


def find_profile(
    image: RawImage, detector: Detector
) -> tuple[NDArray[np.float64], NDArray[np.uint8]]:
    """(W,) the row of the line in each column of an image (H, W), NaN without a line; and (W,) its
    brightness in 8-bit digits."""
    line = find_line(Frame(0, 0, image, 1.0, laser_on=True), detector)
    rows, brightness = np.full(image.shape[1], np.nan), np.zeros(image.shape[1], np.uint8)
    rows[line.u.astype(int)] = line.v
    grey = line.intensity / 2.0 ** (detector.bits - 8)
    brightness[line.u.astype(int)] = np.rint(grey).clip(0, 255).astype(np.uint8)
    return rows, brightness


def _first_delivery(info: SensorInfo) -> Delivery:
    """What it sends after it was opened."""
    return "picture" if "picture" in info.delivers else "line"
