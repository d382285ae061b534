"""The simulated sensor: a camera with a laser line, as a driver.

Frames show the scene as it was at the middle of their exposure, the arm where it
truly was then. Rendering takes its time; a frame that is not ready when the next is
due delays it, as a camera that is read out slowly would. On a machine with little to
spare the frames are far apart, and the sensor is there nevertheless.
"""

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from crenel.messages.message import message
from crenel_hardware.clock import now_ns
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import Frame, LinkHealth, SensorInfo, SensorReading
from crenel_hardware.simulator.devices.kinematics import Floats
from crenel_hardware.simulator.rendering.noise import Detector, RawImage
from crenel_hardware.simulator.rendering.render import QUICK, SMEARED, Renderer
from crenel_hardware.simulator.scene.world import SimulatedScene

EXPOSURE_RANGE_US = (50.0, 20_000.0)
READOUT_NS = 3_000_000
STILL, TREMBLING = 55, 34
"""Rays over a pixel at an edge: while nothing moves at all; and while an operator holds the
sensor and trembles."""
SMEAR_MM = 0.15
"""The sensor's way in one exposure from which on its pictures of the room are smeared."""
LEVER_MM = 130.0
CORE_SHARE = 0.5
"""Rendering takes no more of the machine than this; the frame rate gives way."""
LONGEST_GAP_S = 10.0
"""Pictures are no further apart, however busy the machine; a lost camera says so at once."""
WAKE_S = 0.05
STALE_NS = 300_000_000
"""Frames that nobody asked for this long are forgotten, as in a camera's ring of buffers."""
FIRST_EXPOSURE_US = 5000.0


@dataclass
class Lighting:
    """The light that falls on the scene; set at any time."""

    room: float = 1.0
    """The room's light; 0 is dark, 1 is what the nominal exposure is made for."""
    room_with_laser: bool = False
    """False: the sensor shuts the room's light out while its laser is on (a pair of
    pictures); True: pictures with the laser show both."""


@dataclass
class CameraFaults:
    """What goes wrong with the camera on purpose; set at any time, from any thread."""

    lost: bool = False
    drop_rate: float = 0.0
    """Share of frames that are taken and never delivered, 0 to 1."""


class SharedRenderer:
    """The one renderer of a station, and where its sensor is; drivers take turns."""

    def __init__(
        self,
        make: Callable[[], Renderer],
        sensor_pose: Callable[[int], Floats],
        resting: Callable[[int], bool],
        lamps: Lighting,
        faults: CameraFaults,
    ) -> None:
        self._make, self._sensor_pose, self._is_resting = make, sensor_pose, resting
        self.lighting, self.faults = lamps, faults
        self._lock = threading.Lock()
        self._renderer: Renderer | None = None
        self._last: Floats | None = None

    def prepare(self) -> None:
        """Builds the renderer, which takes a second; before the sensor is opened."""
        with self._lock:
            if self._renderer is None:
                self._renderer = self._make()

    def show(self, scene: SimulatedScene) -> None:
        """Something was set up or put away."""
        with self._lock:
            if self._renderer is not None:
                self._renderer.show(scene)
                self._last = None

    @property
    def detector(self) -> Detector:
        """The detector of the camera; there once prepared."""
        renderer = self._renderer
        assert renderer is not None, "prepare comes first"
        return renderer.detector

    def expose(self, mid_ns: int, exposure_us: float, laser_share: float) -> RawImage:
        """What the camera sees; ``mid_ns`` is the middle of the exposure, ``laser_share`` the part
        of it during which the laser is on, 0 to 1."""
        with self._lock:
            renderer = self._renderer
            assert renderer is not None, "prepare comes first"
            share = exposure_us / renderer.detector.nominal_exposure_us
            shut = 0.0 if self.lighting.room_with_laser else laser_share
            lit = self.lighting.room * (1 - shut)
            T = self._sensor_pose(mid_ns)
            rays = self._rays(T, mid_ns, exposure_us)
            self._last = T
            return renderer.render(T, lit * share, share * laser_share, rays)

    def _rays(self, T: Floats, mid_ns: int, exposure_us: float) -> int:
        """How finely it is worth to render a picture taken at a pose."""
        if self._last is not None and np.array_equal(T, self._last):
            return STILL
        if self._is_resting(mid_ns):
            return TREMBLING
        half_ns = round(exposure_us * 500)
        first, last = self._sensor_pose(mid_ns - half_ns), self._sensor_pose(mid_ns + half_ns)
        way = float(np.linalg.norm(last[:3, 3] - first[:3, 3]))
        turn = float(np.linalg.norm(last[:3, :3] - first[:3, :3])) / np.sqrt(2)
        return SMEARED if way + LEVER_MM * turn > SMEAR_MM else QUICK


def _rest_ns(cost_ns: float) -> float:
    """How long to rest after a picture; the next may well cost as much."""
    return cost_ns * (1 / CORE_SHARE - 1)


class RenderedSensor:
    """What simulated cameras have in common: opening, settings, the laser, their faults."""

    def __init__(self, shared_renderer: SharedRenderer, info: SensorInfo, seed: int) -> None:
        self._shared_renderer, self._info = shared_renderer, info
        self._rng = np.random.default_rng(seed)
        self._health = LinkHealth()
        self._state = threading.Condition()
        self._open = False
        self._exposure_us = FIRST_EXPOSURE_US
        self._laser_on = False

    @property
    def health(self) -> LinkHealth:
        return self._health

    def open(self) -> SensorInfo:
        with self._state:
            self._check_camera()
            if not self._open:
                self._open = True
                self._health = LinkHealth()
                self._begin()
            return self._info

    def set_exposure_us(self, exposure_us: float) -> None:
        low, high = EXPOSURE_RANGE_US
        with self._state:
            self._exposure_us = float(min(max(exposure_us, low), high))
            self._restart_exposure()

    def set_laser(self, on: bool) -> None:
        with self._state:
            if self._laser_on != on:
                self._laser_on = on
                self._restart_exposure()

    def close(self) -> None:
        with self._state:
            self._open = False
            self._laser_on = False
            self._state.notify_all()

    def _begin(self) -> None:
        """The camera has been opened."""

    def _restart_exposure(self) -> None:
        """A setting changed."""

    def _check_camera(self) -> None:
        if self._shared_renderer.faults.lost:
            self._open = False
            raise DeviceError(
                message("simulated-camera-is-lost"), message("turn-fault-switch-camera-lost-off")
            )

    def _check_open(self) -> None:
        if not self._open:
            raise DeviceError(message("simulated-sensor-is-not-open"))
        self._check_camera()


class SimulatedSensor(RenderedSensor):
    """Meets ``SensorDriver``; free-running."""

    def __init__(
        self,
        shared_renderer: SharedRenderer,
        info: SensorInfo,
        rate_hz: float,
        seed: int = 0,
        early_ns: int = 0,
    ) -> None:
        """``early_ns``: by how much its stamps are before the middle of the exposure."""
        super().__init__(shared_renderer, info, seed)
        self._early_ns, self._period_ns = early_ns, 1e9 / rate_hz
        self._sequence = 0
        self._due_ns = 0.0

    def _begin(self) -> None:
        self._sequence = 0
        self._due_ns = float(now_ns())

    def read(self, timeout_s: float) -> SensorReading | None:
        deadline_ns = now_ns() + round(timeout_s * 1e9)
        while True:
            with self._state:
                if not self._wait_for_readout(deadline_ns):
                    return None
                mid_ns, sequence = round(self._due_ns), self._sequence
                exposure_us, laser_on = self._exposure_us, self._laser_on
                self._sequence += 1
            before_s = time.thread_time()
            image = self._shared_renderer.expose(mid_ns, exposure_us, laser_on)
            cost_ns = (time.thread_time() - before_s) * 1e9
            with self._state:
                self._check_open()
                late_ns = now_ns() - mid_ns - exposure_us * 500 - READOUT_NS - self._period_ns
                wait_ns = max(self._period_ns + max(0.0, late_ns), cost_ns + _rest_ns(cost_ns))
                self._due_ns = max(self._due_ns, mid_ns + wait_ns)
                if self._rng.random() < self._shared_renderer.faults.drop_rate:
                    self._health.lost += 1
                    continue
                self._health.received += 1
            stamp_ns = mid_ns - self._early_ns
            return self._deliver(Frame(sequence, stamp_ns, image, exposure_us, laser_on))

    def _deliver(self, frame: Frame) -> SensorReading:
        """What is sent of a frame."""
        return frame

    def _wait_for_readout(self, deadline_ns: int) -> bool:
        """Until the frame that is due has been exposed and read out; False at the deadline."""
        if now_ns() - self._due_ns > STALE_NS:
            self._due_ns = float(now_ns())
        while True:
            self._check_open()
            now = now_ns()
            ready_ns = self._due_ns + self._exposure_us * 500 + READOUT_NS
            if now >= ready_ns:
                return True
            if now >= deadline_ns:
                return False
            self._state.wait(min((min(ready_ns, deadline_ns) - now) / 1e9, WAKE_S))

    def _restart_exposure(self) -> None:
        """The next frame's exposure lies wholly behind a change of its settings."""
        self._due_ns = max(self._due_ns, now_ns() + self._exposure_us * 500)
        self._state.notify_all()
