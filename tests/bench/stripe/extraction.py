"""Stripe extraction beside its peers: speed on cold frames, and error over the Cramér-Rao bound."""

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np

from crenel.metrology.stripe import extract_stripe
from crenel.metrology.transforms import Floats
from crenel.progress import Progress
from tests.bench.stripe.frames import (
    GRAINS,
    SimulatedFrame,
    simulate_frame,
    simulate_overexposure,
    simulate_reflections,
)
from tests.bench.stripe.methods import METHODS, Method, crenel_line
from tests.bench.stripe.speed import ComparisonRow, speeds

# Farther from the stripe, a point is false.
NEAR_PX = 1.5


@dataclass(frozen=True)
class ExtractionErrors:
    """What a method makes of frames of one kind."""

    over_bound: float
    """Rms of the errors over that of their bounds."""
    pull: float
    """Rms of the error over the deviation stated; NaN for methods that state none."""
    false: float
    """Points a frame that lie on no stripe."""
    missed: float
    """Share of the columns with a stripe but no point of it."""


def run(frames: int, progress: Progress) -> list[ComparisonRow]:
    """Measures everything, with so many frames of each kind for the errors."""
    threads = cv2.getNumThreads()
    cv2.setNumThreads(1)
    try:
        rows = speeds(frames, progress)
        for kind in GRAINS:
            progress(0.4, kind)
            rows += errors_table(kind, frames)
        progress(0.8, "reflections")
        rows += nuisances_table(frames)
        progress(0.9, "overexposed")
        return [*rows, ComparisonRow("saturated patch, rms", f"{saturated_rms_px(frames):.3f} px")]
    finally:
        cv2.setNumThreads(threads)


def measure_errors(frames: Sequence[SimulatedFrame], method: Method) -> ExtractionErrors:
    """A method's points against the truth."""
    error, bound, pull = [], [], []
    false = found = lit = 0
    for frame in frames:
        deviation: Floats | None = None
        if method is crenel_line:
            stripe = extract_stripe(frame.image)
            along, across, deviation = stripe.u, stripe.v, stripe.sigma_px
        else:
            along, across = method(frame.image)
        column = along.astype(int)
        off = across - frame.centre[column]
        near = np.abs(off) < NEAR_PX
        error.append(off[near])
        bound.append(frame.bound[column[near]])
        if deviation is not None:
            pull.append(off[near] / deviation[near])
        false += int((~near).sum())
        found += int(near.sum())
        lit += int(np.isfinite(frame.centre).sum())
    return ExtractionErrors(
        rms(np.concatenate(error)) / rms(np.concatenate(bound)),
        rms(np.concatenate(pull)) if pull else float("nan"),
        false / len(frames),
        1 - found / lit,
    )


def errors_table(kind: str, count: int) -> list[ComparisonRow]:
    """Rms of the error over the bound, and over what is stated, on frames of one kind."""
    frames = [simulate_frame(seed, GRAINS[kind]) for seed in range(count)]
    found = [measure_errors(frames, method) for method in METHODS]
    return [
        ComparisonRow(f"rms error / bound, {kind}", *(f"{one.over_bound:.3f}" for one in found)),
        ComparisonRow(f"rms of error / stated deviation, {kind}", f"{found[0].pull:.3f}"),
    ]


def nuisances_table(count: int) -> list[ComparisonRow]:
    """Points on no stripe, and columns missed, where other things shine."""
    frames = [simulate_reflections(seed) for seed in range(count)]
    found = [measure_errors(frames, method) for method in METHODS]
    what = "a reflection, a lamp's spot, 60 hot pixels"
    return [
        ComparisonRow(f"false points a frame, {what}", *(f"{one.false:.2f}" for one in found)),
        ComparisonRow("missed columns, the same", *(f"{100 * one.missed:.2f} %" for one in found)),
    ]


def saturated_rms_px(count: int) -> float:
    """Rms error in px where a patch of the line is overexposed."""
    errors = []
    for seed in range(count):
        image, centre, height = simulate_overexposure(seed)
        stripe = extract_stripe(image)
        column = stripe.u.astype(int)
        clipped = height[column] > 500
        errors.append((stripe.v - centre[column])[clipped])
    return rms(np.concatenate(errors))


def rms(x: Floats) -> float:
    return float(np.sqrt(np.mean(x**2)))
