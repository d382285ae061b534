"""The arm of the rig: its current reading, at a time stamp, and averaged while it is still."""

import math
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import message, quantity
from crenel.metrology.arm.kinematics import AnyArm, flange_poses, tip_centres
from crenel.metrology.arm.reading_interpolation import Stamps
from crenel.metrology.transforms import Floats, vector_from_rotation
from crenel.station.bus import Bus
from crenel.station.devices.device_thread import READ_TIMEOUT_S, DeviceReader
from crenel.station.devices.link_state import QUALITY, DeviceState, device_state
from crenel.station.devices.reading_buffer import (
    ReadingMean,
    ReadingRing,
    ReadingWindow,
    average_readings,
    reading_size,
)
from crenel.station.devices.reading_judge import ReadingJudge
from crenel.station.devices.stillness import UNKNOWN, WINDOW_S, Stillness, stillness
from crenel.station.pulses.pulse_pairing import PulsePairing
from crenel_hardware.clock import now_ns
from crenel_hardware.interfaces import ArmDriver, ArmInfo, ArmReading, ButtonEvent, JointSample

# Packets may arrive late on a busy machine; their time stamps are correct nevertheless.
LATE_S = 0.5
# An arm whose flange has moved by this has left its position: some pixels off.
ELSEWHERE_MM, ELSEWHERE_RAD = 0.5, 0.003
# The distances at which a turn counts as a movement.
REACH_MM, TURN_MM = 1000.0, 150.0
# An arm that sent impossible readings is not trusted for this long.
DOUBTED_S = 1.0


class StationArm:
    """Reads the arm in its own thread; everything else may be called from any thread."""

    def __init__(
        self, bus: Bus, make: Callable[[], ArmDriver], pairings: Sequence[PulsePairing] = ()
    ) -> None:
        """``pairings``: receive the samples that were latched at trigger pulses."""
        self.label = ""
        """What people call it."""
        self._bus = bus
        self._pairings = tuple(pairings)
        self._chosen: AnyArm | None = None
        self._ring: ReadingRing | None = None
        self._judge: ReadingJudge | None = None
        self._keeps_frame = False
        self._newest: ArmReading | None = None
        self._scan_ended_at: ArmReading | None = None
        self.on_button: Callable[[ButtonEvent], None] | None = None
        self.reader: DeviceReader[ArmDriver, ArmInfo] = DeviceReader(
            "arm",
            make,
            lambda driver: driver.open(),
            self._read,
            self._on_connect,
            free_running=lambda info: info.free_running,
        )

    @property
    def info(self) -> ArmInfo | None:
        """Properties of the arm; None while it is not connected."""
        return self.reader.info

    @property
    def fresh(self) -> bool:
        """True while readings arrive."""
        return self.reader.fresh

    @property
    def rejected_count(self) -> int:
        """Number of impossible readings since this arm first connected."""
        return 0 if self._judge is None else self._judge.rejected_count

    @property
    def newest_rejection(self) -> OperationError | None:
        """The error of the newest of them; None if there are none."""
        newest = None if self._judge is None else self._judge.newest
        return None if newest is None else newest.error

    @property
    def rejection_age_s(self) -> float | None:
        """Time since the newest of them."""
        newest = None if self._judge is None else self._judge.newest
        return None if newest is None else (now_ns() - newest.stamp_ns) / 1e9

    def doubt(self) -> OperationError | None:
        """Why the arm's readings are not trusted at present; None while they are plausible."""
        newest = self._judge.newest if self._judge is not None else None
        if newest is None or now_ns() - newest.stamp_ns > DOUBTED_S * 1e9:
            return None
        return newest.error

    def link(self) -> DeviceState:
        """State of the arm; an arm with impossible readings counts as lost, with the reason."""
        link, doubt = self.reader.link(), self.doubt()
        state = device_state(message("arm"), link, self.info, self.label)
        if doubt is None or state.state != "connected":
            return state
        return replace(state, state="lost", quality=QUALITY["lost"], text=doubt.text)

    def set_model(self, arm: AnyArm | None) -> None:
        """The kinematics for judging readings, stillness and the position of the tip."""
        self._chosen = arm
        if self._judge is not None:
            self._judge.set_arm(arm)

    def keep_frame(self, kept: bool) -> None:
        """Whether an arm that begins to report its poses in another frame is held back until it
        returns: the points of a scan lie in one frame."""
        self._keeps_frame = kept
        if self._judge is not None:
            self._judge.keep_frame(kept)

    def latest(self) -> ArmReading | None:
        """The newest sample; None without recent data."""
        return self._newest if self.fresh else None

    def joints_deg(self) -> tuple[float, ...]:
        """The newest joint angles as they are shown; empty without recent data, and of an arm that
        reports poses."""
        newest = self.latest()
        angles = newest.joints_rad if isinstance(newest, JointSample) else ()
        return tuple(round(math.degrees(angle), 2) for angle in angles)

    def tip_mm(self) -> tuple[float, float, float] | None:
        """Tip centre in the arm frame; None while it is unknown, or without a tip."""
        arm, newest = self._model(), self.latest()
        if arm is None or arm.tip is None or newest is None:
            return None
        x, y, z = tip_centres(arm, np.array([newest.reading]))[0]
        return float(x), float(y), float(z)

    def place_mm(self) -> tuple[float, ...] | None:
        """Numbers that change by as many mm as the arm moves and turns at its flange, or for want
        of a model by what it reports, at 1 m; None without recent data."""
        arm, newest = self._model(), self.latest()
        if newest is None:
            return None
        if arm is None:
            return tuple(REACH_MM * value for value in newest.reading)
        T_arm_flange = flange_poses(arm, np.array([newest.reading]))[0]
        points_mm = T_arm_flange[:3, 3] + np.vstack([np.zeros(3), TURN_MM * T_arm_flange[:3, :3].T])
        return tuple(points_mm.ravel().tolist())

    def at(self, stamp_ns: int, wait_s: float = LATE_S) -> Floats | None:
        """The reading (k,) at a time stamp; None if the arm sent none around it."""
        ring = self._ring
        return None if ring is None else ring.at(stamp_ns, wait_s)

    def at_all(self, stamps_ns: Stamps, wait_s: float = LATE_S) -> Floats | None:
        """The same (F, k) at adjacent time stamps (F,), NaN if the arm sent none; None before it
        first connected."""
        ring = self._ring
        return None if ring is None else ring.at_all(stamps_ns, wait_s)

    def window(self, first_ns: int, last_ns: int) -> ReadingWindow | None:
        """The stored samples between two time stamps; None before the arm first connected."""
        ring = self._ring
        return None if ring is None else ring.between(first_ns, last_ns)

    def stillness(self) -> Stillness:
        """How far the arm moved over the last 0.3 s."""
        ring, arm = self._ring, self._model()
        last_ns = ring.last_stamp_ns() if ring else None
        if ring is None or arm is None or last_ns is None or not self.fresh:
            return UNKNOWN
        if (doubt := self.doubt()) is not None:
            return replace(UNKNOWN, text=doubt.text)
        first_ns = last_ns - int(WINDOW_S * 1e9)
        window = ring.between(first_ns, last_ns)
        return stillness(arm, window) if ring.covers(window, first_ns, last_ns) else UNKNOWN

    def has_moved_since(self, stamp_ns: int) -> bool:
        """Whether the arm has moved since a time stamp, so that a picture from then no longer shows
        what the camera sees; False while the arm or its model is missing."""
        arm, newest = self._model(), self.latest()
        if arm is None or newest is None:
            return False
        reading = self.at(stamp_ns, 0.0)
        if reading is None:
            return stamp_ns < newest.stamp_ns
        return _is_elsewhere(arm, reading, np.array(newest.reading))

    def note_scan_end(self) -> None:
        """Nothing is touched where a scan ends: see ``refuse_scan_end``."""
        self._scan_ended_at = self.latest()

    def refuse_scan_end(self, reading: Floats) -> None:
        """Called with the reading (k,) of each contact.

        Raises:
            OperationError: the arm has not moved since a scan ended.
        """
        arm, ended = self._model(), self._scan_ended_at
        if arm is None or ended is None or len(ended.reading) != len(reading):
            return
        if _is_elsewhere(arm, np.array(ended.reading), reading):
            self._scan_ended_at = None
            return
        raise OperationError(
            "where-scan-ended",
            message("arm-is-where-scan-ended"),
            message("nothing-touched-there"),
            message("move-tip-to-object"),
        )

    def average(self, window_s: float = 0.2, until_ns: int | None = None) -> ReadingMean:
        """Mean of the readings over a window in which the arm was still.

        The window ends at ``until_ns`` (by default at the newest sample). For a button press, pass
        its time stamp: pressing moves the arm, so the samples before it count.

        Raises:
            OperationError: ``arm-lost``, ``no-arm-model``, ``joint-implausible``, ``no-joints``,
                or ``arm-moving``.
        """
        doubt = self.doubt() if until_ns is None else None
        if doubt is not None:
            raise doubt
        last_ns = until_ns
        if last_ns is None:
            newest = self.latest()
            last_ns = newest.stamp_ns if newest is not None else now_ns()
        return self.mean_over(last_ns - int(window_s * 1e9), last_ns, "arm-moving")

    def mean_over(self, first_ns: int, last_ns: int, moved_code: str) -> ReadingMean:
        """The mean between two time stamps, if the arm was still between them.

        Raises:
            OperationError: as ``average``, with ``moved_code`` if the arm moved.
        """
        ring, arm = self._ring, self._model()
        if ring is None or not ring.wait_past(last_ns, LATE_S):
            raise OperationError(
                "arm-lost",
                message("arm-sends-no-joint-angles"),
                remedy=message("wait-until-arm-connected-again-nothing"),
            )
        if arm is None:
            raise OperationError(
                "no-arm-model",
                message("no-arm-model-joints-chosen", joint_count=ring.size)
                if ring.kind == "joints"
                else message("no-arm-model-poses-chosen"),
                remedy=message("choose-arm-first-within-sentence"),
            )
        wrong = self._judge.first_between(first_ns, last_ns) if self._judge is not None else None
        if wrong is not None:
            raise wrong.error
        window = ring.between(first_ns, last_ns)
        moved = stillness(arm, window) if ring.covers(window, first_ns, last_ns) else UNKNOWN
        if moved is UNKNOWN:
            raise OperationError(
                "no-joints",
                message(
                    "only-joint-samples-came",
                    count=len(window),
                    duration=quantity((last_ns - first_ns) / 1e9, "s", 2),
                ),
                message("arms-data-has-gap-there"),
                message("repeat-it"),
            )
        if not moved.still:
            raise OperationError(
                moved_code, message("arm-not-held-still"), moved.text, message("hold-still-again")
            )
        return average_readings(window)

    def _model(self) -> AnyArm | None:
        """The arm model, unless the connected arm reports something else."""
        arm, ring = self._chosen, self._ring
        if arm is None or ring is None:
            return None
        fits = (arm.reading_kind, arm.reading_size) == (ring.kind, ring.size)
        return arm if fits else None

    def _on_connect(self, driver: ArmDriver, info: ArmInfo) -> None:
        self._newest = None
        # one ring over reconnections, so that a recording continues
        kind, size = info.reports, reading_size(info)
        if self._ring is None or (self._ring.kind, self._ring.size) != (kind, size):
            self._ring = ReadingRing(info)
            self._judge = None
        if self._judge is None or self._judge.serial_number != info.serial_number:
            self._judge = ReadingJudge(info, self._chosen)
            self._judge.keep_frame(self._keeps_frame)
        # switching off and on restores a joint that slipped
        self._judge.forget_place()

    def _read(self, driver: ArmDriver) -> int:
        records = driver.read(READ_TIMEOUT_S)
        samples = [record for record in records if not isinstance(record, ButtonEvent)]
        if samples:
            self._take(samples)
        for record in records:
            if isinstance(record, ButtonEvent):
                self._bus.call(self._press, record)
        return len(samples)

    def _take(self, samples: Sequence[ArmReading]) -> None:
        """Stores plausible readings: nothing else of the arm is used anywhere."""
        ring, judge = self._ring, self._judge
        if ring is None or judge is None:
            return
        for sample in samples:
            if sample.pulse is not None:
                for pairing in self._pairings:
                    pairing.note_pulse(sample.pulse, sample.stamp_ns)
        good = judge.filter(samples)
        ring.extend(good, judge.judged_ns)
        if good:
            self._newest = good[-1]

    def _press(self, event: ButtonEvent) -> None:
        if self.on_button is not None:
            self.on_button(event)


def _is_elsewhere(arm: AnyArm, before: Floats, after: Floats) -> bool:
    """Whether the flange has left its position between two readings (k,)."""
    then, now = flange_poses(arm, np.array([before, after]))
    moved_mm = np.linalg.norm(now[:3, 3] - then[:3, 3])
    turned_rad = np.linalg.norm(vector_from_rotation(then[:3, :3].T @ now[:3, :3]))
    return bool(moved_mm > ELSEWHERE_MM or turned_rad > ELSEWHERE_RAD)
