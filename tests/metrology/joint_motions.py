"""Motions of a hand-held arm, and its encoders' readings of them."""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.arm.joint_plausibility import PlausibilityFilter
from crenel.metrology.arm.kinematics import Arm, Joint, Tip
from crenel.metrology.transforms import Floats

MS = 1_000_000
NOISE_RAD = 1e-5
ARM = Arm(
    "arm",
    "A-1",
    tuple(
        Joint(f"J{i + 1}", 100.0, 0.0, 0.0, 0.0, limits_rad=(-3.0, 3.0), encoder_sd_rad=NOISE_RAD)
        for i in range(6)
    ),
    Tip(0.0, 0.0, 0.0, 6.0),
)
FINE_S = 1e-4


@dataclass(frozen=True)
class Sample:
    stamp_ns: int
    joints_rad: tuple[float, ...]


@dataclass(frozen=True)
class Judged:
    judge: PlausibilityFilter[Sample]
    passed: NDArray[np.bool_]
    """(N,) whether each reading passed."""


def read(q_rad: Floats, bits: int = 22, noise_rad: float = NOISE_RAD, seed: int = 1) -> Floats:
    """What encoders of 2 to the power of ``bits`` counts say of angles (N, n)."""
    step_rad = 2 * np.pi / 2**bits
    noise = np.random.default_rng(seed).normal(0.0, noise_rad, q_rad.shape)
    return np.asarray(np.rint((q_rad + noise) / step_rad) * step_rad)


def samples(q_rad: Floats, rate_hz: float, stamps_s: Floats | None = None) -> list[Sample]:
    at_s = np.arange(len(q_rad)) / rate_hz if stamps_s is None else stamps_s
    stamps_ns = np.rint(at_s * 1e9).astype(np.int64).tolist()
    return [Sample(at, tuple(row)) for at, row in zip(stamps_ns, q_rad.tolist(), strict=True)]


def judged(readings: Iterable[Sample], rate_hz: float = 1000.0, arm: Arm | None = ARM) -> Judged:
    readings = list(readings)
    judge: PlausibilityFilter[Sample] = PlausibilityFilter(6, rate_hz, arm)
    good: list[Sample] = []
    for reading in readings:
        good += judge.filter([reading])
    good += judge.flush()
    assert [one.stamp_ns for one in good] == sorted(one.stamp_ns for one in good)
    kept = {id(one) for one in good}
    return Judged(judge, np.array([id(one) in kept for one in readings]))


def sweep(rate_hz: float, seconds: float = 4.0, rest_s: float = 1.5) -> Floats:
    """(N, 6): all joints at rest, then turning to and fro at 0.57 rad/s at most."""
    t = np.maximum(np.arange(int(seconds * rate_hz)) / rate_hz - rest_s, 0.0)
    return 0.3 * np.sin(0.6 * np.pi * t[:, None] + np.arange(6))


class Motion:
    """Random smooth motion of all joints, on a fine grid of time, that can be disturbed."""

    def __init__(self, seed: int, seconds: float = 3.0) -> None:
        rng = self._rng = np.random.default_rng(seed)
        self.t = np.arange(0.0, seconds, FINE_S)
        frequency = rng.uniform(0.1, 2.5, (6, 4))
        amplitude = np.minimum(0.3, rng.uniform(0.3, 2.4, (6, 4)) / (2 * np.pi * frequency))
        phase = rng.uniform(0, 2 * np.pi, (6, 4))
        waves = amplitude * np.sin(2 * np.pi * frequency * self.t[:, None, None] + phase)
        self._speed = np.gradient(waves.sum(axis=2), FINE_S, axis=0)

    def tremble(self) -> None:
        """The hand's tremor: 4 mrad at 8 to 13 Hz."""
        hz, phase = self._rng.uniform(8, 13, 6), self._rng.uniform(0, 6, 6)
        shaken = 0.004 * np.sin(2 * np.pi * hz * self.t[:, None] + phase)
        self._speed += np.gradient(shaken, FINE_S, axis=0)

    def stop(self, bounces: bool = False) -> None:
        """All joints stop within 0.1 to 3.5 ms, as at a hard stop; or bounce as a tip that
        touches; and go on after a while."""
        for at_s in self._moments():
            share = np.ones(len(self.t))
            at, takes = int(at_s / FINE_S), int(self._rng.choice([1, 5, 10, 20, 35]))
            share[at : at + takes] = np.linspace(1.0, 0.0, takes)
            share[at + takes : at + 3000] = 0.0
            if bounces:
                back, start, flight = self._rng.uniform(0.1, 0.4), at, self._rng.uniform(40, 200)
                share[at : at + 3000] = 0.0
                for k in range(1, 4):
                    count = int(flight * back ** (k - 1))
                    share[start : start + count] = np.linspace(-(back**k), back**k, count)
                    start += count
            share[at + 3000 : at + 5000] = np.linspace(0.0, 1.0, 2000)
            self._speed *= share[:, None]

    def knock(self) -> None:
        """One joint's speed changes by up to 4 rad/s within 0.1 to 3.5 ms."""
        for at_s in self._moments():
            at, takes = int(at_s / FINE_S), int(self._rng.choice([1, 5, 10, 20, 35]))
            share = np.zeros(len(self.t))
            share[at : at + takes] = np.linspace(0.0, 1.0, takes)
            share[at + takes :] = np.exp(-np.arange(len(self.t) - at - takes) * FINE_S / 0.15)
            self._speed[:, self._rng.integers(6)] += self._rng.uniform(-4, 4) * share

    def at(self, stamps_s: Floats) -> Floats:
        """(N, 6) where the joints are."""
        q_rad = np.cumsum(self._speed, axis=0) * FINE_S
        q_rad -= 0.5 * (q_rad.max(axis=0) + q_rad.min(axis=0))
        return np.array([np.interp(stamps_s, self.t, one) for one in q_rad.T]).T

    def _moments(self) -> list[float]:
        """Four of them, at least half a second apart."""
        return [0.3 + 0.6 * k + float(self._rng.uniform(0, 0.1)) for k in range(4)]
