"""A calibrated sensor's line is looked for where its plane and distances show it."""

import numpy as np
import pytest

from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.line_range import find_line_bounds
from crenel.metrology.stripe import LineBounds, StripeTracker, empty_stripe, extract_stripe

WIDTH, HEIGHT = 640, 512
TILT = np.deg2rad(30)
CAMERA = Camera(
    np.array([[1500.0, 0, WIDTH / 2], [0, 1500.0, HEIGHT / 2], [0, 0, 1]]),
    np.array([[1, 0, 0], [0, np.cos(TILT), -np.sin(TILT)], [0, np.sin(TILT), np.cos(TILT)]]),
    np.array([0.0, 0.0, 300.0]),
    WIDTH,
    HEIGHT,
)
PLANE = LaserPlane(np.array([0.0, 1.0, 0.0]), 0.0)
RANGE_MM = (297.0, 303.0)
LINE_ROW, LAMP_ROW = 320.3, 50.0


def bounds_of(axis: str) -> LineBounds:
    found = find_line_bounds(CAMERA, PLANE, RANGE_MM, axis)
    assert found is not None
    return found


def picture(*rows: tuple[float, float], width_px: float = 3.0) -> np.ndarray:
    """Lines at rows, each of a height, on noise."""
    v = np.arange(HEIGHT)[:, None]
    grey = np.random.default_rng(0).normal(12.0, 1.5, (HEIGHT, WIDTH))
    for row, height in rows:
        grey += height * np.exp(-0.5 * ((v - row) / width_px) ** 2)
    return np.clip(np.rint(grey), 0, 255).astype(np.uint8)


def test_what_is_at_the_calibrated_distances_lies_within() -> None:
    bounds = bounds_of("u")
    z_mm = np.linspace(-4.0, 4.0, 41)
    seen = project(CAMERA, np.column_stack([np.zeros(41), np.zeros(41), z_mm]))
    away_mm = np.linalg.norm([0, 0, 1] * z_mm[:, None] - CAMERA.centre_mm, axis=1)
    inside = (away_mm > RANGE_MM[0]) & (away_mm < RANGE_MM[1])
    assert inside.sum() > 10
    allowed = bounds.where()
    u, v = np.rint(seen[inside]).astype(int).T
    assert allowed[v, u].all()
    assert 0.05 < allowed.mean() < 0.9


def test_another_light_beyond_is_no_line() -> None:
    bounds = bounds_of("u")
    allowed = bounds.where()
    assert allowed[round(LINE_ROW)].all()
    assert not allowed[: round(LAMP_ROW) + 10].any()
    both = picture((LINE_ROW, 40.0), (LAMP_ROW, 160.0))
    free, bound = extract_stripe(both), extract_stripe(both, bounds=bounds)
    assert np.abs(free.v - LAMP_ROW).max() < 2
    assert len(bound.u) > 0.99 * WIDTH
    assert np.abs(bound.v - LINE_ROW).max() < 2
    lamp = picture((LAMP_ROW, 160.0))
    assert not len(extract_stripe(lamp, bounds=bounds).u)


@pytest.mark.parametrize("width_px", [3.0, 12.0])
def test_frames_that_follow_one_another_give_the_same(width_px: float) -> None:
    bounds = bounds_of("u")
    tracker = StripeTracker(bounds=bounds)
    for number in range(12):
        image = picture((LINE_ROW + number, 90.0), (LAMP_ROW, 160.0), width_px=width_px)
        found, whole = tracker.extract(image), extract_stripe(image, bounds=bounds)
        assert len(found.u) > 0.98 * WIDTH
        assert np.abs(found.v - (LINE_ROW + number)).max() < 2
        assert np.abs(np.median(found.v) - np.median(whole.v)) < 0.05
    assert len(tracker.extract(picture()).u) == len(empty_stripe("u").u)


def test_bounds_of_another_picture_do_not_count() -> None:
    bounds = bounds_of("u")
    both = picture((LINE_ROW, 40.0), (LAMP_ROW, 160.0))
    smaller = np.ascontiguousarray(both[:, :-64])
    assert np.abs(extract_stripe(smaller, bounds=bounds).v - LAMP_ROW).max() < 2
    turned = np.ascontiguousarray(both.T)
    assert len(extract_stripe(turned, "v", bounds=bounds).v) > 0.9 * WIDTH


def test_the_raw_pixels_of_one_colour_have_half_the_bounds() -> None:
    bounds = bounds_of("u")
    half = bounds.of_cells(2)
    assert half.size_px == (WIDTH // 2, HEIGHT // 2)
    assert (half.where() == bounds.where()[::2, ::2]).mean() > 0.99


def test_a_range_that_fills_the_picture_bounds_nothing() -> None:
    assert find_line_bounds(CAMERA, PLANE, (150.0, 500.0), "u") is None
