"""The surface on which the points of the 3D view lie: their normals, and how large they are."""

import numpy as np
import pytest

from crenel.station.view3d.surface_look import (
    DARKEST,
    STEEP_DEG,
    UNKNOWN,
    is_steep,
    look_at_surface,
    surface_normals,
)

pytestmark = pytest.mark.usefixtures("variant")


def lines_mm(apart_mm: float, along_mm: float = 0.1, noise_mm: float = 0.0) -> np.ndarray:
    """On a wave along x, in lines across it, as a scan takes them."""
    x, y = np.arange(0, 40 * apart_mm, apart_mm), np.arange(0, 20, along_mm)
    X, Y = (part.ravel() for part in np.meshgrid(x, y, indexing="ij"))
    Z = 4 * np.sin(X / 8) + np.random.default_rng(1).normal(0, noise_mm, len(X))
    return np.column_stack([X, Y, Z]).astype(np.float32)


@pytest.mark.parametrize("apart_mm", [0.1, 0.3, 1.0, 2.0])
def test_lines_of_a_scan_have_the_normals_of_their_surface(apart_mm: float) -> None:
    points = lines_mm(apart_mm, noise_mm=0.005)
    normals, _, _ = surface_normals(points, 0.1)
    true = np.column_stack(
        [-np.cos(points[:, 0] / 8) / 2, np.zeros(len(points)), points[:, 0] ** 0]
    )
    true /= np.linalg.norm(true, axis=1, keepdims=True)
    cosines = np.abs((normals * true).sum(axis=1))
    assert np.mean(normals.any(axis=1)) > 0.98
    assert np.degrees(np.arccos(np.quantile(cosines, 0.05))) < 12


def test_points_of_a_dense_scan_touch_and_those_of_a_thin_one_form_lines() -> None:
    spacing = {
        apart_mm: float(np.median(look_at_surface(lines_mm(apart_mm), 0.1).spacing_mm))
        for apart_mm in (0.1, 0.3, 1.0, 5.0)
    }
    assert spacing[0.1] == pytest.approx(0.1, rel=0.15)
    assert spacing[0.3] == pytest.approx(np.sqrt(0.1 * 0.3), rel=0.3)
    assert 0.2 < spacing[1.0] <= spacing[5.0] < 0.4


def test_what_lies_on_no_surface_is_neither_lit_nor_dark() -> None:
    line = np.column_stack([np.arange(500) / 10, np.zeros((500, 2))]).astype(np.float32)
    cloud = np.random.default_rng(1).uniform(0, 3, (2000, 3)).astype(np.float32)
    for points, share in ((line, 1.0), (cloud, 0.6)):
        brightness = look_at_surface(points, 0.1).brightness
        assert np.mean(brightness == round(255 * UNKNOWN)) >= share
    assert len(look_at_surface(line[:0], 0.1).brightness) == 0
    wave = look_at_surface(lines_mm(1.0), 0.1).brightness
    assert 255 * DARKEST <= wave.min() < wave.max() - 40


@pytest.mark.parametrize(("apart_mm", "few"), [(0.3, False), (2.0, False), (6.0, True)])
def test_lines_far_apart_are_few_points(apart_mm: float, few: bool) -> None:
    assert look_at_surface(lines_mm(apart_mm), 0.1).has_few.mean() == pytest.approx(
        float(few), abs=0.1
    )


def test_a_surface_is_steep_by_the_direction_to_the_camera() -> None:
    tilts = np.radians([0, STEEP_DEG - 2, STEEP_DEG + 2, 180 - STEEP_DEG - 2, 180])
    views = np.column_stack([np.sin(tilts), np.zeros(5), np.cos(tilts)])
    parts = np.rint(127 * views).astype(np.int8)
    up = np.tile(np.array([0, 0, 1], np.float32), (5, 1))
    assert is_steep(up, parts).tolist() == [False, False, True, True, False]
    assert not is_steep(np.zeros_like(up), parts).any()
    assert not is_steep(up, np.zeros_like(parts)).any()
