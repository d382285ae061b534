"""The laser plane from stripes on a block of known place."""

from dataclasses import replace

import numpy as np
import pytest

from crenel.metrology.calibration.findings import stripe_finding
from crenel.metrology.calibration.laser_plane_fit import classify_levels, fit_laser_plane
from crenel.metrology.sensor.camera import Camera, project, rays
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.residual_correlation import neighbours_alike
from crenel.metrology.stripe import Stripe
from crenel.metrology.transforms import Floats
from tests.metrology.builders import BLOCK
from tests.metrology.numerics import unit
from tests.metrology.refusals import refusal_of
from tests.metrology.seen_block import camera_over, laser_plane, simulate_stripe


def tilt_rad(found: LaserPlane, true: LaserPlane) -> float:
    return float(np.linalg.norm(np.cross(found.normal, true.normal)))


def values_of(stripe: Stripe) -> Floats:
    return np.stack([stripe.u, stripe.v, stripe.intensity, stripe.sigma_px])


def appended(stripe: Stripe, uv: Floats) -> Stripe:
    """The stripe with further points (N, 2) of the same deviation."""
    more = np.ones((2, len(uv))) * [[100.0], [stripe.sigma_px[0]]]
    return Stripe(*np.hstack([values_of(stripe), [*uv.T, *more]]))


@pytest.mark.parametrize("azimuth", [-0.3, 0.0, 0.3])
@pytest.mark.parametrize("tilt", [-0.2, 0.02, 0.2])
def test_a_plane_without_noise_is_found_exactly(azimuth: float, tilt: float) -> None:
    camera, plane = camera_over(BLOCK, azimuth), laser_plane(tilt)
    stripe = simulate_stripe(camera, BLOCK, plane, np.random.default_rng(0), 0.0)
    exact = replace(stripe, sigma_px=np.full(len(stripe.u), 0.05))
    fit = fit_laser_plane(camera, BLOCK, exact)
    assert tilt_rad(fit.plane, plane) < 2e-6
    assert fit.rms_mm < 2e-5
    assert {"crest", "floor"} <= set(fit.level[fit.used])


@pytest.mark.parametrize(("noise_px", "quality"), [(0.1, "good"), (3.0, "attention")])
def test_points_far_off_their_plane_are_never_good(noise_px: float, quality: str) -> None:
    camera, rng = camera_over(BLOCK, 0.25), np.random.default_rng(3)
    fit = fit_laser_plane(
        camera, BLOCK, simulate_stripe(camera, BLOCK, laser_plane(), rng, noise_px)
    )
    assert fit.rms_px == pytest.approx(noise_px, rel=0.2)
    assert stripe_finding(len(fit.used), fit.rms_px, 1.0, "check").quality == quality


def test_streaks_on_walls_the_table_and_reflections_do_not_pull_the_plane() -> None:
    camera, plane = camera_over(BLOCK, 0.25), laser_plane()
    rng = np.random.default_rng(3)
    clean = simulate_stripe(camera, BLOCK, plane, rng, 0.1)
    wall_x, y = BLOCK.edges_x_mm[3], plane.offset_mm
    wall = np.column_stack([np.full(60, wall_x), np.full(60, y), np.linspace(1, 15, 60)])
    table = np.column_stack([np.linspace(26, 40, 80), np.full(80, y), np.full(80, -11.0)])
    reflected = np.column_stack([np.linspace(4.6, 7.4, 60), np.full(60, y + 1.2), np.zeros(60)])
    spoiled = appended(clean, project(camera, np.vstack([wall, table, reflected])))
    fit = fit_laser_plane(camera, BLOCK, spoiled)
    alone = fit_laser_plane(camera, BLOCK, clean)
    assert not fit.used[len(clean.u) :].any()
    assert tilt_rad(fit.plane, alone.plane) < 1e-9
    assert np.all(fit.level[len(clean.u) + 60 : len(clean.u) + 140] == "")


def first_met(camera: Camera, uv: Floats) -> list[str]:
    """What each pixel's ray meets first, found by walking along it in small steps."""
    origin, along = rays(camera, uv)
    met = []
    for ray in along:
        depth = (BLOCK.crest_z_mm + 0.5 - origin[2]) / ray[2] + np.arange(0.0, 40.0, 2e-3)
        x, y, z = (origin + depth[:, None] * ray).T
        below_crest = (z < BLOCK.crest_z_mm) & (y > BLOCK.front_y_mm) & (y < BLOCK.back_y_mm)
        merlon = np.searchsorted(BLOCK.edges_x_mm, x) % 2 == 1
        inside = (x > BLOCK.edges_x_mm[0]) & (x < BLOCK.edges_x_mm[-1])
        solid = below_crest & inside & (merlon | (z < BLOCK.floor_z_mm))
        first = int(np.argmax(solid))
        heights = {"crest": BLOCK.crest_z_mm, "floor": BLOCK.floor_z_mm}
        on = [name for name, height in heights.items() if abs(z[first] - height) < 5e-3]
        met.append(on[0] if solid.any() and on else "")
    return met


@pytest.mark.parametrize(("azimuth", "elevation"), [(0.0, 1.0), (0.45, 0.8), (-0.4, 1.3)])
def test_a_pixel_gets_the_level_that_its_ray_meets_first(azimuth: float, elevation: float) -> None:
    camera = camera_over(BLOCK, azimuth, elevation)
    uv = np.random.default_rng(2).uniform([150, 150], [1150, 900], (500, 2))
    level, points = classify_levels(camera, BLOCK, uv)
    met = np.array(first_met(camera, uv))
    assert np.sum(level == "crest") > 60
    assert np.sum(level == "floor") > 30
    np.testing.assert_array_equal(level[level != ""], met[level != ""])
    # nothing is missed but what lies near an edge
    assert np.sum((level == "") & (met != "")) < 0.25 * np.sum(met != "")
    np.testing.assert_allclose(project(camera, points[level != ""]), uv[level != ""], atol=1e-6)


def refused(camera: Camera, stripe: Stripe) -> str:
    return refusal_of(fit_laser_plane, camera, BLOCK, stripe).code


def test_too_little_stripe_is_refused() -> None:
    camera = camera_over(BLOCK)
    stripe = simulate_stripe(camera, BLOCK, laser_plane(), np.random.default_rng(0), 0.1)
    level, _ = classify_levels(camera, BLOCK, stripe.uv_px)

    def only(chosen: np.ndarray[tuple[int, ...], np.dtype[np.bool_]]) -> Stripe:
        return Stripe(*values_of(stripe)[:, chosen])

    assert refused(camera, only(level == "crest")) == "laser-one-level"
    assert refused(camera, only(level == "floor")) == "laser-one-level"
    assert refused(camera, only(np.arange(len(level)) % 60 == 0)) == "stripe-too-short"
    assert refused(camera, only(np.zeros(len(level), dtype=np.bool_))) == "stripe-too-short"


def test_a_plane_through_the_camera_is_refused() -> None:
    camera = camera_over(BLOCK, azimuth=0.0, elevation=1.45)
    toward = camera.centre_mm - np.array([0.0, 0.5, 8.0])
    normal = unit(np.cross(toward, [1.0, 0.0, 0.0]))
    plane = LaserPlane(normal, float(normal @ np.array([0.0, 0.5, 8.0])))
    stripe = simulate_stripe(camera, BLOCK, plane, np.random.default_rng(0), 0.05)
    assert refused(camera, stripe) == "laser-through-camera"


def test_likeness_of_neighbours_is_measured() -> None:
    rng = np.random.default_rng(1)
    white = rng.normal(0, 1, 3000)
    uv = np.column_stack([np.arange(3000.0), np.zeros(3000)])
    assert neighbours_alike(uv, white) < 1.2
    smooth = np.convolve(white, np.ones(4) / 2, mode="same")
    # the sum of the correlations of a moving mean of four is four
    assert neighbours_alike(uv, smooth) == pytest.approx(4, rel=0.2)
