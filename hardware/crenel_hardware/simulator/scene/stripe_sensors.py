"""Stripe sensors of every size, drawn at random, as makers state them and as they are built."""

from dataclasses import dataclass

import numpy as np

from crenel_hardware.simulator.scene.camera import (
    LightPlane,
    Optics,
    camera_looking_at,
    light_plane_through,
    to_pixels,
)

SHAPES = ((4, 3), (5, 4), (16, 10), (1, 1), (2, 1))
"""Long to short side of a picture."""
LINE_PX, LINE_SHARE = 1.6, 2.5e-4
"""Half the laser's width: in pixels, and as a share of the stand-off, which focusing allows."""


@dataclass(frozen=True)
class SensorNumbers:
    """What a sensor's maker states. The stripe has one point a column where its axis is "u"."""

    field_of_view_mm: float
    standoff_mm: float
    depth_of_field_mm: float
    width_px: int
    height_px: int
    stripe_axis: str
    angle_deg: float

    @property
    def pixels_along(self) -> int:
        """Pixels along the stripe."""
        return self.width_px if self.stripe_axis == "u" else self.height_px


def draw_sensor_numbers(rng: np.random.Generator) -> SensorNumbers:
    """A sensor of 30 to 400 mm stand-off and 0.3 to 12 megapixels."""
    standoff_mm = float(np.exp(rng.uniform(np.log(30.0), np.log(400.0))))
    field_mm = max(float(standoff_mm * rng.uniform(0.3, 0.6)), 14.0)
    pixels = float(np.exp(rng.uniform(np.log(0.3e6), np.log(12e6))))
    long, short = SHAPES[int(rng.integers(len(SHAPES)))]
    along = 8 * round(np.sqrt(pixels * long / short) / 8)
    across = 8 * round(along * short / long / 8)
    axis = "u" if rng.uniform() < 0.7 else "v"
    width, height = (along, across) if axis == "u" else (across, along)
    return SensorNumbers(
        round(field_mm, 1),
        round(standoff_mm, 1),
        round(field_mm * float(rng.uniform(0.25, 0.6)), 1),
        width,
        height,
        axis,
        round(float(rng.uniform(22.0, 38.0)), 1),
    )


def build_stripe_sensor(
    numbers: SensorNumbers, rng: np.random.Generator
) -> tuple[Optics, LightPlane]:
    """A sensor as assembled: everything is off its numbers a little, and the lens distorts.

    The laser shines along -z of the sensor frame, whose origin is at the stand-off, and the
    camera looks at that from -y.
    """
    unit = numbers.standoff_mm / 100.0
    aside_mm = numbers.standoff_mm * np.tan(np.radians(numbers.angle_deg))
    eye = np.array([0.0, -aside_mm, numbers.standoff_mm]) + unit * rng.normal(0.0, 1.0, 3)
    quarter = 0.0 if numbers.stripe_axis == "u" else np.pi / 2
    roll_rad = quarter + float(rng.normal(0.0, 0.005))
    target = 0.3 * unit * rng.normal(0.0, 1.0, 3)
    T = camera_looking_at(eye, target, np.array([1.0, 0.0, 0.0]), roll_rad)
    focal_px = numbers.pixels_along * float(np.linalg.norm(eye)) / numbers.field_of_view_mm
    focal_px *= 1 + float(rng.normal(0.0, 0.005))
    off_px = rng.normal(0.0, 0.006, 2) * numbers.pixels_along
    optics = Optics(
        numbers.width_px,
        numbers.height_px,
        focal_px,
        focal_px * (1 + 2e-4 * float(rng.normal())),
        (numbers.width_px - 1) / 2 + float(off_px[0]),
        (numbers.height_px - 1) / 2 + float(off_px[1]),
        (float(rng.uniform(-0.08, -0.01)), 0.0, 0.0, 0.0, 0.0),
        T,
    )
    pixel_mm = numbers.field_of_view_mm / numbers.pixels_along
    normal = np.array([0.0, 1.0, 0.0]) + 0.01 * rng.normal(0.0, 1.0, 3)
    emitter = np.array([0.0, 0.0, numbers.standoff_mm])
    light = light_plane_through(
        normal,
        0.2 * unit * rng.normal(0.0, 1.0, 3),
        emitter,
        max(LINE_PX * pixel_mm, LINE_SHARE * numbers.standoff_mm),
    )
    return optics, light


def range_truth(
    numbers: SensorNumbers, optics: Optics, light: LightPlane
) -> tuple[np.ndarray, np.ndarray]:
    """A grid over the measuring range: pixels (G, 2), and where their light fell (G, 3), mm."""
    half = numbers.field_of_view_mm / 2, numbers.depth_of_field_mm / 2
    x, z = (np.linspace(-side, side, count) for side, count in zip(half, (13, 9), strict=True))
    grid_x, grid_z = (axis.ravel() for axis in np.meshgrid(x, z))
    n = light.normal
    y = (light.offset_mm - n[0] * grid_x - n[2] * grid_z) / n[1]
    points = np.column_stack([grid_x, y, grid_z])
    pixels = to_pixels(optics, points)
    size = np.array([optics.width_px, optics.height_px])
    inside = np.all((pixels > -0.5) & (pixels < size - 0.5), axis=1)
    return pixels[inside], points[inside]
