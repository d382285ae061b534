"""The simulated sensor when the arm triggers it: one exposure per pulse, counted by the camera.

Frames are stamped when they arrive, late and unevenly, as over a busy network. Their counts tell
which triggers they belong to, and which frames were lost.
"""

from collections import deque

from crenel_hardware.clock import now_ns
from crenel_hardware.interfaces import Frame, SensorInfo
from crenel_hardware.simulator.rendering.sensor import RenderedSensor, SharedRenderer

STORED_TRIGGERS = 4
"""Exposures that wait for their picture; what comes beyond is lost, as in a full camera."""
TRANSPORT_NS = 30_000_000
WAKE_S = 0.05


class TriggeredSensor(RenderedSensor):
    """Meets ``SensorDriver`` and ``AnswersWhileSilent``.

    Args:
        jitter_ms: frames arrive by up to this earlier or later than usual.
    """

    def __init__(
        self, shared_renderer: SharedRenderer, info: SensorInfo, jitter_ms: float, seed: int = 0
    ) -> None:
        super().__init__(shared_renderer, info, seed)
        self._jitter_ms = jitter_ms
        self._count = int(self._rng.integers(1, 5000))
        self._triggers: deque[tuple[int, int, float, bool]] = deque()
        self._last_arrival_ns = 0

    def _begin(self) -> None:
        self._triggers.clear()

    def trigger(self, at_ns: int) -> None:
        """A pulse on the camera's input; called by the arm."""
        with self._state:
            self._count += 1
            if not self._open:
                return
            if len(self._triggers) == STORED_TRIGGERS:
                self._triggers.popleft()
                self._health.lost += 1
            self._triggers.append((self._count, at_ns, self._exposure_us, self._laser_on))
            self._state.notify_all()

    def is_alive(self) -> bool:
        return not self._shared_renderer.faults.lost

    def read(self, timeout_s: float) -> Frame | None:
        with self._state:
            self._state.wait_for(lambda: self._triggers or not self._open, timeout_s)
            self._check_open()
            if not self._triggers:
                return None
            count, at_ns, exposure_us, laser_on = self._triggers.popleft()
        image = self._shared_renderer.expose(
            at_ns + round(500 * exposure_us), exposure_us, laser_on
        )
        if self._rng.random() < self._shared_renderer.faults.drop_rate:
            self._health.lost += 1
            return None
        self._wait_for_transport(at_ns)
        self._health.received += 1
        arrival_ns = max(now_ns(), self._last_arrival_ns + 1)
        self._last_arrival_ns = arrival_ns
        return Frame(count, arrival_ns, image, exposure_us, laser_on, pulse=count)

    def _wait_for_transport(self, at_ns: int) -> None:
        late_ns = TRANSPORT_NS + 1e6 * self._rng.uniform(-self._jitter_ms, self._jitter_ms)
        with self._state:
            while self._open and (left_ns := at_ns + late_ns - now_ns()) > 0:
                self._state.wait(min(left_ns / 1e9, WAKE_S))
            self._check_open()
