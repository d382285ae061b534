"""Spheres of a scanned ball bar: found among other things, and how well their centres are known."""

import numpy as np
import pytest

from app.metrology.performance.bar_spheres import LEAST_POINTS, find_spheres, measure_sphere
from app.metrology.performance.gate import SphereGate
from app.metrology.transforms import Floats
from tests.metrology.numerics import on_sphere, unit

RADIUS_MM = 10.0
CENTRES = np.array([[0.0, 0.0, 50.0], [120.0, 30.0, 60.0]])
ALONG = unit(CENTRES[1] - CENTRES[0])
GATE = SphereGate()
CAMERA = np.array([0.0, 0.0, 1.0])


def cap(random: np.random.Generator, half_deg: float, count: int) -> Floats:
    """Unit directions (N, 3) evenly over a cap that looks to the camera."""
    height = random.uniform(np.cos(np.radians(half_deg)), 1.0, count)
    return on_sphere(height, random.uniform(0, 2 * np.pi, count))


def scanned(random: np.random.Generator, half_deg: float = 60.0, sd_mm: float = 0.01) -> Floats:
    """Points (N, 3) on both spheres."""
    caps = [cap(random, half_deg, 3000) for _ in CENTRES]
    radii = RADIUS_MM + sd_mm * random.normal(size=(2, 3000, 1))
    both = zip(CENTRES, radii, caps, strict=True)
    return np.concatenate([centre + r * n for centre, r, n in both])


def test_spheres_are_found_on_a_table_beside_a_rod_and_other_spheres() -> None:
    random = np.random.default_rng(3)
    flat = random.uniform(-60, 180, (20_000, 2))
    table = np.column_stack([flat, 0.02 * random.normal(size=20_000)])
    turn, place = random.uniform(0, np.pi, 4000), random.uniform(8, 115, 4000)
    rod = CENTRES[0] + place[:, None] * ALONG
    rod += 4 * np.column_stack([0 * turn, np.cos(turn), np.sin(turn)])
    other = np.array([60.0, -40.0, 12.0]) + 6.0 * cap(random, 60.0, 3000)
    cloud = np.concatenate([table, rod, other, scanned(random)])
    found = find_spheres(cloud, np.tile(CAMERA, (len(cloud), 1)), 2 * RADIUS_MM)
    assert len(found) == 2
    for centre in CENTRES:
        assert np.min(np.linalg.norm(found - centre, axis=1)) < 0.1


def test_no_spheres_are_found_on_a_plane() -> None:
    random = np.random.default_rng(4)
    plane = np.column_stack([random.uniform(0, 100, (5000, 2)), 0.01 * random.normal(size=5000)])
    assert len(find_spheres(plane, np.tile(CAMERA, (5000, 1)), 2 * RADIUS_MM)) == 0


@pytest.mark.parametrize(("half_deg", "covered"), [(60.0, True), (30.0, True), (18.0, False)])
def test_a_small_cap_does_not_fix_a_centre(half_deg: float, covered: bool) -> None:
    cloud = scanned(np.random.default_rng(5), half_deg)
    frames = np.arange(len(cloud)) // 50
    views = np.tile(CAMERA, (len(cloud), 1))
    found = measure_sphere(cloud, views, frames, 2 * RADIUS_MM, CENTRES[0], ALONG, GATE)
    assert found.points > LEAST_POINTS
    assert found.is_covered == covered


def test_centres_scatter_as_their_normals_say() -> None:
    """The covariance of a fit with a known radius is ``sd² (Σ n nᵀ)⁻¹``."""
    sd_mm, apart = 0.05, []
    for seed in range(60):
        random = np.random.default_rng(seed)
        cloud = scanned(random, 50.0, sd_mm)
        views, frames = np.tile(CAMERA, (len(cloud), 1)), np.arange(len(cloud)) // 50
        scan = (cloud, views, frames, 2 * RADIUS_MM)
        ends = [measure_sphere(*scan, start, ALONG, GATE) for start in CENTRES]
        assert all(one.is_covered for one in ends)
        apart.append(np.linalg.norm(ends[1].centre_mm - ends[0].centre_mm))
    bar_mm = np.linalg.norm(CENTRES[1] - CENTRES[0])
    least_mm = sd_mm / np.sqrt(ends[0].points)
    assert np.mean(apart) == pytest.approx(bar_mm, abs=3 * least_mm)
    # along the bar, which lies across the view, a cap of 50° has about an eighth of n nᵀ
    assert np.std(apart) == pytest.approx(np.sqrt(2 / 0.15) * least_mm, rel=0.35)
