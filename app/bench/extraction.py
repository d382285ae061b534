"""Stripe extraction beside its peers: speed on cold frames, and error over the Cramér-Rao bound.

Frames are 1280 × 1024 of 8 bits: a Gaussian stripe whose width (standard deviation 1.2 to
4 px), brightness (60 to 250 along the line), slope and bend differ from frame to frame, with
gaps, read noise of 2 grey levels, shot noise of 0.1 per level. Speckle multiplies the light,
with a contrast of 0.15: in grains of a pixel that are alike over four columns, or in round
grains of 4 px. The bound is that of each column's centre beside three more unknowns (height,
width, background), with the pixels' whole covariance known. Times are medians on one thread,
every frame taken anew from a pool larger than the caches, 16 frames by each method in turn.
"""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter

from app.metrology.camera import Camera
from app.metrology.frames import Floats
from app.metrology.laser_plane import LaserPlane
from app.metrology.reconstruct import frame_points
from app.metrology.stripe import extract_stripe
from app.metrology.stripe_band import StripeBand

Grey = NDArray[np.uint8]
Line = tuple[Floats, Floats]
Progress = Callable[[float, str], None]

WIDTH, HEIGHT = 1280, 1024
WIDTHS_PX = (1.2, 2.0, 3.0, 4.0)
READ, GAIN, BASE = 2.0, 0.1, 8.0
CONTRAST = 0.15
# Standard deviation of the grains' outline in rows and columns.
GRAINS = {"plain": None, "speckle": (0.0, 2.0), "speckle, round grains": (2.0, 2.0)}
# Farther from the stripe, a point is false.
NEAR_PX = 1.5
POOL, ROUNDS, BURST = 64, 15, 16
HOT_PIXELS, SPOT_PX = 60, 5.0
SATURATED_PX, SATURATED_HEIGHT, PATCH = 2.5, 1500.0, 300
REBUILT_FRAMES, REBUILT_TIMES = 100, 60
COLUMNS = ("measure", "Crenel", "OpenCV Gauss + parabola", "numpy argmax + centroid")


@dataclass(frozen=True)
class Taken:
    """A frame and its truth: the stripe's row in every column, NaN where there is none."""

    image: Grey
    centre: Floats  # (W,)
    bound: Floats  # (W,) px


@dataclass(frozen=True)
class Errors:
    """What a method makes of frames of one kind."""

    over_bound: float
    """Rms of the errors over that of their bounds."""
    pull: float
    """Rms of the error over the deviation stated; NaN for methods that state none."""
    false: float
    """Points a frame that lie on no stripe."""
    missed: float
    """Share of the columns with a stripe but no point of it."""


@dataclass(frozen=True)
class Measured:
    """One line of the table; the peers' cells may be empty."""

    measure: str
    crenel: str
    opencv: str = ""
    centroid: str = ""


def run(frames: int, progress: Progress) -> list[Measured]:
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
        return [*rows, Measured("saturated patch, rms", f"{saturated(frames):.3f} px")]
    finally:
        cv2.setNumThreads(threads)


def table(rows: Sequence[Measured]) -> list[list[str]]:
    return [[row.measure, row.crenel, row.opencv, row.centroid] for row in rows]


def blurred_parabola(image: Grey) -> Line:
    """Vertex of the parabola through every column's highest pixel after Gaussian blur."""
    smooth = cv2.GaussianBlur(image, (1, 9), sigmaX=0.1, sigmaY=2.0).astype(np.float32)
    along = np.arange(image.shape[1])
    top = np.clip(smooth.argmax(axis=0), 1, image.shape[0] - 2)
    a, b, c = (smooth[top + k, along].astype(np.float64) for k in (-1, 0, 1))
    bend = a - 2 * b + c
    vertex = np.where(bend < 0, 0.5 * (a - c) / np.where(bend < 0, bend, 1.0), 0.0)
    kept = b > 30
    return along[kept].astype(np.float64), (top + np.clip(vertex, -1, 1))[kept]


def centroid(image: Grey) -> Line:
    """Centre of gravity about every column's highest pixel."""
    along = np.arange(image.shape[1])
    top = np.clip(image.argmax(axis=0), 6, image.shape[0] - 7)
    rows = top + np.arange(-6, 7)[:, None]
    window = image[rows, along].astype(np.float64)
    light = np.maximum(window - window.min(axis=0) - 3 * READ, 0.0)
    kept = window[6] > 30
    total = np.maximum(light.sum(axis=0), 1e-9)
    return along[kept].astype(np.float64), ((light * rows).sum(axis=0) / total)[kept]


def crenel_line(image: Grey) -> Line:
    stripe = extract_stripe(image)
    return stripe.u, stripe.v


METHODS: tuple[Callable[[Grey], Line], ...] = (crenel_line, blurred_parabola, centroid)


def taken(seed: int, grains: tuple[float, float] | None = None) -> Taken:
    """A frame of its own width, shape and noise."""
    rng = np.random.default_rng(seed)
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
    return Taken(
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


def judged(frames: Sequence[Taken], method: Callable[[Grey], Line]) -> Errors:
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
    return Errors(
        rms(np.concatenate(error)) / rms(np.concatenate(bound)),
        rms(np.concatenate(pull)) if pull else float("nan"),
        false / len(frames),
        1 - found / lit,
    )


def errors_table(kind: str, count: int) -> list[Measured]:
    """Rms of the error over the bound, and over what is stated, on frames of one kind."""
    frames = [taken(seed, GRAINS[kind]) for seed in range(count)]
    found = [judged(frames, method) for method in METHODS]
    return [
        Measured(f"rms error / bound, {kind}", *(f"{one.over_bound:.3f}" for one in found)),
        Measured(f"rms of error / stated deviation, {kind}", f"{found[0].pull:.3f}"),
    ]


def spoiled(seed: int) -> Taken:
    """A frame with a reflection stripe, in places brighter, a lamp's spot and hot pixels."""
    rng = np.random.default_rng(seed)
    frame = taken(seed)
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
    return Taken(grey, frame.centre, frame.bound)


def nuisances_table(count: int) -> list[Measured]:
    """Points on no stripe, and columns missed, where other things shine."""
    frames = [spoiled(seed) for seed in range(count)]
    found = [judged(frames, method) for method in METHODS]
    what = "a reflection, a lamp's spot, 60 hot pixels"
    return [
        Measured(f"false points a frame, {what}", *(f"{one.false:.2f}" for one in found)),
        Measured("missed columns, the same", *(f"{100 * one.missed:.2f} %" for one in found)),
    ]


def saturated(count: int) -> float:
    """Rms error in px where a patch of the line is overexposed."""
    u = np.arange(WIDTH)
    errors = []
    for seed in range(count):
        rng = np.random.default_rng(seed)
        centre = HEIGHT / 2 + 40 * np.sin(u / 200 + seed) + 0.05 * u
        hill = np.exp(-0.5 * ((u - rng.uniform(400, 900)) / PATCH * 3) ** 2)
        height = 120 + SATURATED_HEIGHT * hill
        light = beam(centre, height, SATURATED_PX)
        grey = BASE + light + rng.standard_normal(light.shape) * np.sqrt(READ**2 + GAIN * light)
        stripe = extract_stripe(np.clip(np.rint(grey), 0, 255).astype(np.uint8))
        column = stripe.u.astype(int)
        clipped = height[column] > 500
        errors.append((stripe.v - centre[column])[clipped])
    return rms(np.concatenate(errors))


def speeds(frames: int, progress: Progress) -> list[Measured]:
    """Frames a second of every method on cold frames, and what follows from it."""
    progress(0.0, "rendering")
    base = [taken(seed).image for seed in range(min(frames, 8))]
    pool = [np.roll(base[i % len(base)], 17 * i, axis=1) for i in range(POOL)]
    # the stripe goes up and down by a few rows a frame, as over a part that is scanned
    moved = [
        np.roll(base[1], round(60 * np.sin(2 * np.pi * i / POOL)), axis=0) for i in range(POOL)
    ]
    band = StripeBand()
    camera, plane = sensor()
    progress(0.2, "timing")
    once, crenel, opencv, gravity, tracked, placed = timed(
        [
            (lambda image: np.max(image), pool),
            (extract_stripe, pool),
            (blurred_parabola, pool),
            (centroid, pool),
            (band.extract, moved),
            (lambda image: to_points(image, camera, plane), pool),
        ]
    )
    points = float(np.mean([len(extract_stripe(image).u) for image in pool[:8]]))
    return [
        Measured("one reading of the frame (np.max)", f"{1 / once:.0f} /s"),
        Measured("whole-frame extraction", *(f"{1 / s:.0f} /s" for s in (crenel, opencv, gravity))),
        Measured(
            "share of one reading's rate",
            *(f"{100 * once / s:.1f} %" for s in (crenel, opencv, gravity)),
        ),
        Measured("with the stripe followed", f"{1 / tracked:.0f} /s"),
        Measured("image to points in the arm frame", f"{points / placed / 1e6:.2f} million/s"),
        Measured("recorded profiles to the arm frame", f"{rebuilt() / 1e6:.0f} million/s"),
    ]


def timed(
    methods: Sequence[tuple[Callable[[Grey], object], Sequence[Grey]]],
) -> list[float]:
    """Median seconds of each method on its frames, the methods in turn, some frames each."""
    for method, images in methods:
        method(images[0])
    spent = np.empty((len(methods), ROUNDS * BURST))
    for start in range(0, ROUNDS * BURST, BURST):
        for m, (method, images) in enumerate(methods):
            for n in range(start, start + BURST):
                image = images[n % len(images)]
                begin = time.perf_counter()
                method(image)
                spent[m, n] = time.perf_counter() - begin
    return [float(median) for median in np.median(spent, axis=1)]


def sensor() -> tuple[Camera, LaserPlane]:
    """A camera with some distortion, and a laser plane before it."""
    matrix = np.array([[2400.0, 0, 640], [0, 2400, 512], [0, 0, 1]])
    distortion = np.array([-0.1, 0.05, 1e-3, -5e-4, 0.0])
    camera = Camera(matrix, np.eye(3), np.zeros(3), WIDTH, HEIGHT, distortion)
    return camera, LaserPlane(np.array([0.0, np.sin(0.6), np.cos(0.6)]), 120.0)


def to_points(image: Grey, camera: Camera, plane: LaserPlane) -> object:
    """The points of a frame in the arm frame, at one pose."""
    stripe = extract_stripe(image)
    first = np.array([0, len(stripe.u)])
    return frame_points(camera, plane, stripe.u, stripe.v, first, np.eye(4)[None])


def rebuilt() -> float:
    """Points a second from recorded profiles, of single precision, to the arm frame."""
    camera, plane = sensor()
    rng = np.random.default_rng(0)
    total = REBUILT_FRAMES * WIDTH
    u = np.tile(np.arange(WIDTH, dtype=np.float32), REBUILT_FRAMES)
    v = rng.uniform(400, 600, total).astype(np.float32)
    first = np.arange(REBUILT_FRAMES + 1) * WIDTH
    T_arm_sensor = np.tile(np.eye(4), (REBUILT_FRAMES, 1, 1))
    points = np.empty((total, 3))
    spent = []
    for _ in range(REBUILT_TIMES):
        begin = time.perf_counter()
        frame_points(camera, plane, u, v, first, T_arm_sensor, points)
        spent.append(time.perf_counter() - begin)
    return total / float(np.median(spent))


def rms(x: Floats) -> float:
    return float(np.sqrt(np.mean(x**2)))
