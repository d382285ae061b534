"""Simulated passes over a plate, by a hand or a robot, with clocks that differ as stated.

The true time is the camera's until a clock jumps. Stamps of the arm are later by the delay, which
grows by the drift; at the jump, the arm's or the camera's clock is set. Where the stamps are those
of arrival, they are late by times that vary.
"""

from dataclasses import dataclass, field

import numpy as np
from scipy.spatial.transform import Rotation

from crenel.metrology.arm.reading_interpolation import interpolate_readings
from crenel.metrology.time_delay.course import PPM
from crenel.metrology.time_delay.plane_pass import PlanePass
from crenel.metrology.transforms import Floats

AT_S = 1000.0
POINTS, HALF_LINE_MM, RANGE_MM = 60, 12.0, 100.0
NORMAL = np.array([0.02, -0.03, 1.0]) / np.linalg.norm([0.02, -0.03, 1.0])
GAP_LIMIT_NS = 25_000_000
APART_S = 20e-6
"""Between the stamps of readings that arrive at once."""
LEAD_S = 0.4
"""Of the arm's readings before the first frame, and behind the last one."""


@dataclass(frozen=True)
class PlannedJump:
    """A clock is set at a true time."""

    at_s: float
    change_s: float
    """Of the delay: the arm's clock is set forward by it, or the camera's back."""
    of_camera: bool = False


@dataclass(frozen=True)
class Lateness:
    """By how much the arm's stamps are late beyond the delay, where they are those of arrival."""

    packet_s: float = 0.0
    """Mean of the random part of each packet; packets arrive in order."""
    readings: int = 1
    """Of a packet, which are stamped one after the other when it arrives."""
    wander_s: float = 0.0
    """Amplitude of a slow wandering."""
    wander_hz: float = 0.0

    def wandering_s(self, true_s: Floats) -> Floats:
        """(N,) the slow part at true times."""
        return np.asarray(self.wander_s * np.sin(2 * np.pi * self.wander_hz * true_s))

    def of_packets_s(self, read_s: Floats, seed: int) -> Floats:
        """(N,) the rest, of readings at increasing times (N,) that arrive in order."""
        number = np.arange(len(read_s))
        last = np.minimum(number - number % self.readings + self.readings - 1, len(read_s) - 1)
        random = np.random.default_rng([seed, 1])
        late_s = self.packet_s * random.exponential(size=len(read_s))
        arrival_s = np.maximum.accumulate((read_s + late_s)[last])
        return np.asarray(arrival_s + APART_S * (number % self.readings) - read_s)


@dataclass(frozen=True)
class PassPlan:
    """How a pass is made, and its clocks."""

    seed: int
    delay_s: float = 0.0
    """At the beginning."""
    drift_ppm: float = 0.0
    jumps: tuple[PlannedJump, ...] = ()
    seconds: float = 20.0
    frames_hz: float = 25.0
    readings_hz: float = 250.0
    point_sd_mm: float = 0.01
    arm_sd_mm: float = 0.02
    bent_mm: float = 0.01
    """Error of the calibration over the height."""
    at_rest: bool = False
    lateness: Lateness = Lateness()
    movement: Floats = field(default_factory=lambda: np.zeros((0, 3)))
    """(S, 3) amplitude in mm, frequency in Hz and phase of waves across the plate."""

    def read_s(self) -> Floats:
        """(N,) true times of the readings."""
        return np.arange(-LEAD_S, self.seconds + LEAD_S, 1 / self.readings_hz)

    def lateness_at_s(self, true_s: Floats) -> Floats:
        """(N,) by how much stamps are late at true times, in the mean of packets."""
        of_packets_s = self.lateness.of_packets_s(self.read_s(), self.seed)
        return float(of_packets_s.mean()) + self.lateness.wandering_s(true_s)

    def delay_at_s(self, true_s: Floats) -> Floats:
        """(N,) the delay at true times, relative to the camera's stamps, without lateness."""
        found = self.delay_s + PPM * self.drift_ppm * true_s
        for jump in self.jumps:
            found = found + jump.change_s * (true_s >= jump.at_s)
        return found

    def camera_stamps_s(self, true_s: Floats) -> Floats:
        """(N,) stamps that the camera gives."""
        found = true_s.copy()
        for jump in self.jumps:
            found -= jump.change_s * (true_s >= jump.at_s) * jump.of_camera
        return found


def simulate_pass(plan: PassPlan) -> PlanePass:
    """The frames and the arm's poses of a pass, with noise."""
    random = np.random.default_rng(plan.seed)
    taken_s = np.arange(0.0, plan.seconds, 1 / plan.frames_hz)
    taken_s += random.uniform(0, 1e-3)
    read_s = plan.read_s()
    readings = _readings(plan, read_s)
    readings[:, :3] += plan.arm_sd_mm * random.normal(size=(len(readings), 3))
    camera_s = plan.camera_stamps_s(taken_s)
    late_s = plan.lateness.of_packets_s(read_s, plan.seed) + plan.lateness.wandering_s(read_s)
    arm_s = plan.camera_stamps_s(read_s) + plan.delay_at_s(read_s) + late_s
    points = _line_points(plan, taken_s, random)
    frames, samples = np.argsort(camera_s, kind="stable"), np.argsort(arm_s, kind="stable")
    arm_ns, readings = _stamps_ns(arm_s[samples]), readings[samples]
    return PlanePass(
        _stamps_ns(camera_s[frames]),
        np.arange(len(frames) + 1) * POINTS,
        points[frames].reshape(-1, 3),
        np.full(len(frames) * POINTS, plan.point_sd_mm),
        lambda at_ns: _poses(interpolate_readings("joints", arm_ns, readings, at_ns, GAP_LIMIT_NS)),
    )


def _stamps_ns(seconds: Floats) -> "np.ndarray[tuple[int], np.dtype[np.int64]]":
    return np.round(1e9 * (AT_S + seconds)).astype(np.int64)


def _readings(plan: PassPlan, true_s: Floats) -> Floats:
    """(N, 6) place in mm and turns in rad of the sensor."""
    t = np.zeros_like(true_s) if plan.at_rest else true_s
    amplitude, hertz, phase = plan.movement.T[:, :, None]
    across = (amplitude * np.sin(2 * np.pi * hertz * t + phase)).sum(axis=0)
    along = 25 * np.sin(2 * np.pi * t / plan.seconds + 0.3) + 6 * np.sin(1.1 * t)
    turns = (0.03 * np.sin(1.7 * t), 0.02 * np.sin(1.2 * t + 1), 0.02 * np.cos(0.9 * t))
    return np.column_stack([0 * t, along, across, *turns])


def _poses(readings: Floats) -> Floats:
    T = np.tile(np.eye(4), (len(readings), 1, 1))
    T[:, :3, :3] = Rotation.from_euler("xyz", np.nan_to_num(readings[:, 3:])).as_matrix()
    T[:, :3, 3] = readings[:, :3]
    T[~np.isfinite(readings).all(axis=1)] = np.nan
    return T


def _line_points(plan: PassPlan, true_s: Floats, random: np.random.Generator) -> Floats:
    """(F, POINTS, 3) in the sensor frame, which looks down its z at the plate."""
    T = _poses(_readings(plan, true_s))
    across = np.linspace(-HALF_LINE_MM, HALF_LINE_MM, POINTS)
    n = np.einsum("fji,j->fi", T[:, :3, :3], NORMAL)
    height = -RANGE_MM - T[:, :3, 3] @ NORMAL
    down = (height[:, None] - n[:, :1] * across) / n[:, 2:]
    down += plan.bent_mm * np.sin((down + RANGE_MM) / 6 + 1)
    down += plan.point_sd_mm * random.normal(size=down.shape)
    return np.stack([np.broadcast_to(across, down.shape), 0 * down, down], axis=2)
