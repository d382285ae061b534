"""The table in which the extraction stands beside its peers."""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np

from crenel.metrology.image import Image
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.triangulation import frame_points
from crenel.metrology.stripe import StripeTracker, extract_stripe
from crenel.metrology.stripe.workspace import PER_FULL_WIDTH
from crenel.progress import Progress
from tests.bench.stripe.frames import HEIGHT, WIDTH, simulate_frame
from tests.bench.stripe.methods import centroid, fit_blurred_parabola

COLUMNS = ("measure", "Crenel", "OpenCV Gauss + parabola", "numpy argmax + centroid")


@dataclass(frozen=True)
class ComparisonRow:
    """One line of the table; the peers' cells may be empty."""

    measure: str
    crenel: str
    opencv: str = ""
    centroid: str = ""


def table(rows: Sequence[ComparisonRow]) -> list[list[str]]:
    return [[row.measure, row.crenel, row.opencv, row.centroid] for row in rows]


POOL, ROUNDS, BURST = 64, 15, 16
REBUILT_FRAMES, REBUILT_TIMES = 100, 60
WIDE_LINES_PX = (20, 50)
DEEPER_BITS = 4
"""Of frames of 12 bits in 16, more than those of 8."""


def speeds(frames: int, progress: Progress) -> list[ComparisonRow]:
    """Frames a second of every method on cold frames, and what follows from it."""
    progress(0.0, "rendering")
    base = [simulate_frame(seed).image for seed in range(min(frames, 8))]
    pool = [np.roll(base[i % len(base)], 17 * i, axis=1) for i in range(POOL)]
    wide = [simulate_frame(1, width_px=width * PER_FULL_WIDTH).image for width in WIDE_LINES_PX]
    deep = [image * np.uint16(1 << DEEPER_BITS) for image in wide]
    camera, plane = make_sensor()
    progress(0.2, "timing")
    once, crenel, opencv, gravity, placed, tracked, *tracked_wide = median_seconds(
        [
            (lambda image: np.max(image), pool),
            (extract_stripe, pool),
            (fit_blurred_parabola, pool),
            (centroid, pool),
            (lambda image: to_points(image, camera, plane), pool),
            *((StripeTracker().extract, _move(image)) for image in (base[1], *wide, *deep)),
        ]
    )
    points = float(np.mean([len(extract_stripe(image).u) for image in pool[:8]]))
    return [
        ComparisonRow("one reading of the frame (np.max)", f"{1 / once:.0f} /s"),
        ComparisonRow(
            "whole-frame extraction", *(f"{1 / s:.0f} /s" for s in (crenel, opencv, gravity))
        ),
        ComparisonRow(
            "share of one reading's rate",
            *(f"{100 * once / s:.1f} %" for s in (crenel, opencv, gravity)),
        ),
        ComparisonRow("with the stripe followed", f"{1 / tracked:.0f} /s"),
        *(
            ComparisonRow(f"the same, {width} px wide at half height{of}", f"{1 / seconds:.0f} /s")
            for (of, width), seconds in zip(
                product(("", ", 12 bits in 16"), WIDE_LINES_PX), tracked_wide, strict=True
            )
        ),
        ComparisonRow("image to points in the arm frame", f"{points / placed / 1e6:.2f} million/s"),
        ComparisonRow(
            "recorded profiles to the arm frame", f"{rebuild_rate() / 1e6:.0f} million/s"
        ),
    ]


def _move(image: Image) -> list[Image]:
    """Frames in which the stripe goes up and down by a few rows each, as over a scanned part."""
    shifts = [round(60 * np.sin(2 * np.pi * i / POOL)) for i in range(POOL)]
    return [np.roll(image, shift, axis=0) for shift in shifts]


def median_seconds(
    methods: Sequence[tuple[Callable[[Image], object], Sequence[Image]]],
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


def make_sensor() -> tuple[Camera, LaserPlane]:
    """A camera with some distortion, and a laser plane before it."""
    matrix = np.array([[2400.0, 0, 640], [0, 2400, 512], [0, 0, 1]])
    distortion = np.array([-0.1, 0.05, 1e-3, -5e-4, 0.0])
    camera = Camera(matrix, np.eye(3), np.zeros(3), WIDTH, HEIGHT, distortion)
    return camera, LaserPlane(np.array([0.0, np.sin(0.6), np.cos(0.6)]), 120.0)


def to_points(image: Image, camera: Camera, plane: LaserPlane) -> object:
    """The points of a frame in the arm frame, at one pose."""
    stripe = extract_stripe(image)
    count = np.array([len(stripe.u)])
    return frame_points(camera, plane, stripe.u, stripe.v, count, np.eye(4)[None])


def rebuild_rate() -> float:
    """Points a second from recorded profiles to the arm frame."""
    camera, plane = make_sensor()
    rng = np.random.default_rng(0)
    total = REBUILT_FRAMES * WIDTH
    u = np.tile(np.arange(WIDTH, dtype=np.float64), REBUILT_FRAMES)
    v = rng.uniform(400, 600, total)
    count = np.full(REBUILT_FRAMES, WIDTH)
    T_arm_sensor = np.tile(np.eye(4), (REBUILT_FRAMES, 1, 1))
    points = np.empty((total, 3))
    spent = []
    for _ in range(REBUILT_TIMES):
        begin = time.perf_counter()
        frame_points(camera, plane, u, v, count, T_arm_sensor, points)
        spent.append(time.perf_counter() - begin)
    return total / float(np.median(spent))
