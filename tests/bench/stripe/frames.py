"""Simulated frames with a laser stripe whose place is known.

They are 1280 × 1024 of 8 bits: a Gaussian stripe whose width (standard deviation 1.2 to 4 px),
brightness (60 to 250 along the line), slope and bend differ from frame to frame, with gaps,
read noise of 2 grey levels, shot noise of 0.1 per level. Speckle multiplies the light, with a
contrast of 0.15: in grains of a pixel that are alike over four columns, or in round grains of
4 px. The bound is that of each column's centre beside three more unknowns (height, width,
background), with the pixels' whole covariance known.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter

from crenel.metrology.transforms import Floats

Grey = NDArray[np.uint8]

WIDTH, HEIGHT = 1280, 1024
WIDTHS_PX = (1.2, 2.0, 3.0, 4.0)
READ, GAIN, BASE = 2.0, 0.1, 8.0
CONTRAST = 0.15
# Standard deviation of the grains' outline in rows and columns.
GRAINS = {"plain": None, "speckle": (0.0, 2.0), "speckle, round grains": (2.0, 2.0)}
HOT_PIXELS, SPOT_PX = 60, 5.0
SATURATED_PX, SATURATED_HEIGHT, PATCH = 2.5, 1500.0, 300


@dataclass(frozen=True)
class SimulatedFrame:
    """A frame and its truth: the stripe's row in every column, NaN where there is none."""

    image: Grey
    centre: Floats  # (W,)
    bound: Floats  # (W,) px


def simulate_frame(
    seed: int, grains: tuple[float, float] | None = None, width_px: float | None = None
) -> SimulatedFrame:
    """A frame of its own shape and noise, and width unless that is given."""
    rng = np.random.default_rng(seed)
    if width_px is None:
        width_px = WIDTHS_PX[seed % len(WIDTHS_PX)]
    u = np.arange(WIDTH)
    bend = rng.uniform(40, 150) * np.sin(u / rng.uniform(180, 500) + rng.uniform(0, 6))
    centre = HEIGHT / 2 + rng.uniform(-80, 80) + bend + rng.uniform(-0.1, 0.1) * u
    height = 155 + 95 * np.sin(u / rng.uniform(60, 200) + rng.uniform(0, 6))
    for begin in rng.integers(50, WIDTH - 100, 2):
        height[begin : begin + rng.integers(10, 40)] = 0
    light = beam(centre, height, width_px)
    grain = 0.0
    if grains is not None:
        field = gaussian_filter(rng.standard_normal(light.shape), grains)
        grain = CONTRAST * field / field.std()
    noise = rng.standard_normal(light.shape) * np.sqrt(READ**2 + GAIN * light)
    grey = BASE + light * (1 + grain) + noise
    image = np.clip(np.rint(grey), 0, 255).astype(np.uint8)
    lit = height > 0
    return SimulatedFrame(
        image,
        np.where(lit, centre, np.nan),
        bounds(centre, np.where(lit, height, np.nan), width_px, grains),
    )


def beam(centre: Floats, height: Floats, width_px: float) -> Floats:
    """(H, W) light of a Gaussian stripe."""
    off = np.arange(HEIGHT)[:, None] - centre
    return np.asarray(height * np.exp(-0.5 * (off / width_px) ** 2))


def bounds(
    centre: Floats, height: Floats, width_px: float, grains: tuple[float, float] | None
) -> Floats:
    """(W,) the Cramér-Rao bound of each column's centre, four unknowns, in px."""
    reach = int(np.ceil(6 * width_px))
    off = np.arange(-reach, reach + 1)
    bound = np.full(len(centre), np.nan)
    alike = np.eye(len(off))
    if grains is not None and grains[0] > 0:
        alike = np.exp(-0.25 * ((off[:, None] - off) / grains[0]) ** 2)
    for i in np.flatnonzero(np.isfinite(height)):
        t = (np.rint(centre[i]) + off - centre[i]) / width_px
        e = np.exp(-0.5 * t * t)
        signal = height[i] * e
        J = np.column_stack([signal * t / width_px, e, signal * t * t, np.ones(len(t))])
        covariance = np.diag(READ**2 + GAIN * signal + 1 / 12)
        if grains is not None:
            covariance = covariance + CONTRAST**2 * np.outer(signal, signal) * alike
        bound[i] = np.sqrt(np.linalg.inv(J.T @ np.linalg.solve(covariance, J))[0, 0])
    return bound


def simulate_reflections(seed: int) -> SimulatedFrame:
    """A frame with a reflection stripe, in places brighter, a lamp's spot and hot pixels."""
    rng = np.random.default_rng(seed)
    frame = simulate_frame(seed)
    u = np.arange(WIDTH)
    begin = int(rng.integers(100, WIDTH - 500))
    lit = np.isfinite(frame.centre) & (u >= begin) & (u < begin + 350)
    below = np.where(np.isfinite(frame.centre), frame.centre, 0) + rng.uniform(60, 120)
    height = np.where(lit, 60 + 60 * np.sin(u / 40), 0)
    light = beam(below, np.maximum(height, 0), 2.0)
    x, y = rng.uniform(100, WIDTH - 100), rng.uniform(40, 150)
    away = np.hypot(u - x, np.arange(HEIGHT)[:, None] - y)
    light = light + 230 * np.exp(-0.5 * (away / SPOT_PX) ** 2)
    grey = np.clip(np.rint(frame.image + light), 0, 255).astype(np.uint8)
    grey[rng.integers(0, HEIGHT, HOT_PIXELS), rng.integers(0, WIDTH, HOT_PIXELS)] = 255
    return SimulatedFrame(grey, frame.centre, frame.bound)


def simulate_overexposure(seed: int) -> tuple[Grey, Floats, Floats]:
    """A frame a patch of whose line is too bright; the line's rows and its height, (W,) each."""
    u = np.arange(WIDTH)
    rng = np.random.default_rng(seed)
    centre = HEIGHT / 2 + 40 * np.sin(u / 200 + seed) + 0.05 * u
    hill = np.exp(-0.5 * ((u - rng.uniform(400, 900)) / PATCH * 3) ** 2)
    height = 120 + SATURATED_HEIGHT * hill
    light = beam(centre, height, SATURATED_PX)
    grey = BASE + light + rng.standard_normal(light.shape) * np.sqrt(READ**2 + GAIN * light)
    return np.clip(np.rint(grey), 0, 255).astype(np.uint8), centre, height
