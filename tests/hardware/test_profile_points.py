"""Profiles as they arrive, and the points of the line that become of them."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from crenel_hardware.sensor.genicam.profiles.profile_points import (
    COORDINATES,
    FLOAT_SIGMA_PX,
    INTENSITY,
    UNKNOWN_SIGMA_PX,
    Brightness,
    ProfileFormat,
    estimate_sigma_px,
    line_points,
)
from tests.present import present

C16, C32F, C8 = (COORDINATES[f"Coord3D_{name}"][0] for name in ("C16", "C32f", "C8"))
MONO8, MONO12 = 0x01080001, 0x01100005
SIXTEENTHS = ProfileFormat(1 / 16, -2.0, 0.0, (6, 100), 0.25)


def as_bytes(numbers: NDArray[np.generic]) -> NDArray[np.uint8]:
    return np.frombuffer(numbers.tobytes(), np.uint8)


def test_known_bytes() -> None:
    """The low byte first; 0 is no point, and 65535 is a row outside the picture."""
    data = bytes.fromhex("0000 2000 2100 ffff 1800 0f00")
    points = present(line_points(np.frombuffer(data, np.uint8), C16, SIXTEENTHS))
    assert points.u.tolist() == [1.0, 2.0, 4.0]
    assert points.v.tolist() == [0.0, 0.0625, -0.5]
    assert points.sigma_px.tolist() == [0.25] * 3
    assert points.intensity.tolist() == [INTENSITY] * 3
    assert points.size_px == (6, 100)


def test_floats_and_bytes() -> None:
    profile = ProfileFormat(1.0, 0.0, -1.0, (5, 100), 0.1)
    floats = np.array([np.nan, -1.0, 20.25, np.inf, 99.75], "<f4")
    points = present(line_points(as_bytes(floats), C32F, profile))
    assert (points.u.tolist(), points.v.tolist()) == ([2.0], [20.25])
    points = present(line_points(np.array([0, 1, 99, 100, 255], np.uint8), C8, profile))
    assert points.v.tolist() == [0.0, 1.0, 99.0]


def test_a_camera_without_an_invalid_number_has_a_point_in_every_column() -> None:
    profile = replace(SIXTEENTHS, invalid=None, offset_px=0.0)
    points = present(line_points(np.zeros(12, np.uint8), C16, profile))
    assert points.v.tolist() == [0.0] * 6


def test_too_few_bytes_are_no_line() -> None:
    assert line_points(np.zeros(11, np.uint8), C16, SIXTEENTHS) is None


def test_the_brightness_beside_the_rows_is_the_intensity() -> None:
    data = as_bytes(np.array([0, 64, 64, 0, 64, 64], "<u2"))
    grey = np.arange(10, 70, 10)
    for code, kind, level in ((MONO8, "u1", [20, 30, 50, 60]), (MONO12, "<u2", [20, 30, 50, 60])):
        points = line_points(data, C16, SIXTEENTHS, Brightness(as_bytes(grey.astype(kind)), code))
        assert present(points).intensity.tolist() == level
    for short_or_unknown in (Brightness(np.zeros(5, np.uint8), MONO8), Brightness(data, 0x1234)):
        points = present(line_points(data, C16, SIXTEENTHS, short_or_unknown))
        assert points.intensity.tolist() == [INTENSITY] * 4


@given(st.lists(st.integers(0, 65_535), min_size=1, max_size=40))
def test_points_are_in_order_and_in_the_picture(numbers: list[int]) -> None:
    profile = ProfileFormat(1 / 16, -2.0, 0.0, (len(numbers), 1000), None)
    points = present(line_points(as_bytes(np.array(numbers, "<u2")), C16, profile))
    assert np.all(np.diff(points.u) > 0)
    assert np.all((points.v >= -0.5) & (points.v < 999.5))
    assert np.all(points.sigma_px > 0)
    back = np.rint((points.v + 2.0) * 16).astype(int)
    assert back.tolist() == [numbers[int(column)] for column in points.u]


@pytest.mark.parametrize("noise_px", [0.03, 0.1, 0.4])
def test_the_scatter_of_a_bent_line_with_steps_is_its_noise(noise_px: float) -> None:
    random = np.random.default_rng(3)
    u = np.delete(np.arange(1500.0), range(700, 760))
    smooth = 300 + 0.2 * u + 2e-4 * (u - 700) ** 2 + 40.0 * (u > 900)
    v = smooth + random.normal(0.0, noise_px, len(u))
    v[random.random(len(u)) < 0.01] = 5.0
    step_px = 1 / 16
    found = estimate_sigma_px(u, np.rint(v / step_px) * step_px, step_px)
    # an outlier is in four differences
    assert found == pytest.approx(np.hypot(noise_px, step_px / np.sqrt(12)), rel=0.15)


def test_the_deviation_is_never_less_than_that_of_rounding() -> None:
    u = np.arange(100.0)
    assert estimate_sigma_px(u, np.full(100, 7.0), 0.5) == pytest.approx(0.5 / np.sqrt(12))
    assert estimate_sigma_px(u, np.full(100, 7.0), 0.0) == FLOAT_SIGMA_PX
    for few in (0, 3, 41):
        assert estimate_sigma_px(u[:few], u[:few], 0.5) == UNKNOWN_SIGMA_PX
    assert estimate_sigma_px(20 * u, u, 0.5) == UNKNOWN_SIGMA_PX
