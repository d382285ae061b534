"""The article's gauge figures on clouds whose errors are known."""

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.gauges.quick.maths.errors import (
    NominalPlane,
    NominalSphere,
    angle_between_rad,
    check_plane,
    check_sphere,
    compute_repeatability,
)
from crenel.gauges.quick.maths.figure_budget import combine_budget, spread_statistics
from crenel.gauges.quick.maths.figure_uncertainty import fit_uncertainty
from crenel.metrology.transforms import Floats, rotation_from_vector
from tests.metrology.numerics import unit

ARCSEC = np.pi / 180 / 3600


def flat(rng: np.random.Generator, normal: Floats, point: Floats) -> Floats:
    cloud = rng.uniform(-20, 20, (500, 3))
    return np.asarray(cloud - np.outer(cloud @ normal, normal) + point)


def test_a_tilted_and_raised_plane_is_measured() -> None:
    rng = np.random.default_rng(1)
    normal = np.array([0.0, 0.0, 1.0])
    tilted = rotation_from_vector(np.array([230 * ARCSEC, 0.0, 0.0])) @ normal
    point = np.array([400.0, 100.0, 130.0])
    cloud = flat(rng, tilted, point + [0, 0, 0.1])
    check = check_plane(cloud, NominalPlane(point, normal))
    assert check.angle_arcsec == pytest.approx(230, abs=0.01)
    # the cloud's centre lies a little beside the pivot, so the tilt adds its share
    lift_um = (check.fit.centre_mm - point) @ normal * 1e3
    assert lift_um == pytest.approx(100, abs=2)
    assert check.offset_um == pytest.approx(lift_um, abs=1e-3)
    assert check.z_error_um == pytest.approx(-lift_um, abs=1e-3)


def test_the_sign_of_a_normal_does_not_matter() -> None:
    rng = np.random.default_rng(2)
    normal = np.array([0.6, 0.0, 0.8])
    cloud = flat(rng, normal, np.array([10.0, 20.0, 30.5]))
    one = check_plane(cloud, NominalPlane(np.array([10.0, 20.0, 30.0]), normal))
    other = check_plane(cloud, NominalPlane(np.array([10.0, 20.0, 30.0]), -normal))
    assert one.angle_arcsec == pytest.approx(0, abs=1e-3)
    assert one.offset_um == pytest.approx(400, abs=1e-3)
    assert other.offset_um == pytest.approx(-400, abs=1e-3)
    assert one.z_error_um == pytest.approx(other.z_error_um, abs=1e-6)


def test_a_standing_plane_has_no_error_along_z() -> None:
    rng = np.random.default_rng(3)
    normal = np.array([1.0, 0.0, 0.0])
    cloud = flat(rng, normal, np.array([5.0, 0.0, 0.0]))
    check = check_plane(cloud, NominalPlane(np.array([4.9, 0.0, 0.0]), normal))
    assert check.z_error_um is None
    assert check.offset_um == pytest.approx(100, abs=1e-3)


def test_small_angles_keep_their_digits() -> None:
    normal = unit([0.3, -0.5, 0.81])
    across = unit(np.cross(normal, [1.0, 0.0, 0.0]))
    turned = rotation_from_vector(1e-7 * across) @ normal
    assert angle_between_rad(normal, turned) == pytest.approx(1e-7, rel=1e-6)
    assert angle_between_rad(normal, -turned) == pytest.approx(1e-7, rel=1e-6)


def test_a_sphere_is_compared_with_its_nominal() -> None:
    rng = np.random.default_rng(4)
    away = unit(rng.normal(size=(1000, 3)))
    centre = np.array([100.0, 200.0, 300.0])
    nominal = NominalSphere(centre + [0.03, 0.04, 0.0], 12.75)
    check = check_sphere(centre + 12.7 * away, nominal)
    assert check.radius_error_um == pytest.approx(50, abs=0.01)
    assert check.centre_error_um == pytest.approx(50, abs=0.01)
    assert check_sphere(centre + 12.7 * away).radius_error_um is None


def test_the_spread_over_clouds() -> None:
    found = compute_repeatability([1.0, 2.0, 6.0])
    assert (found.mean, found.range) == (3.0, 5.0)
    assert found.standard_deviation == pytest.approx(np.sqrt(7))
    with pytest.raises(OperationError, match="at least two"):
        compute_repeatability([1.0])


@pytest.mark.parametrize("clouds", [2, 3, 5, 12])
def test_few_clouds_state_what_their_scatter_may_be(clouds: int) -> None:
    rng = np.random.default_rng(3)
    hits = 0
    for _ in range(1000):
        values = rng.normal(0, 1, clouds).tolist()
        found = spread_statistics(values, [{"gauge": 0.0}] * clouds)["standard_deviation"]
        hits += abs(found.value - 1) <= combine_budget(found.budget)
    assert hits / 1000 == pytest.approx(0.9545, abs=4 * 0.0066)


@pytest.mark.slow
@pytest.mark.parametrize("cap_deg", [5.0, 20.0, 90.0])
def test_a_fit_scatters_as_it_states(cap_deg: float) -> None:
    rng = np.random.default_rng(1)
    radii, stated = [], []
    for _ in range(40):
        cos = rng.uniform(np.cos(np.deg2rad(cap_deg)), 1, 800)
        around = rng.uniform(0, 2 * np.pi, 800)
        sin = np.sqrt(1 - cos**2)
        outward = np.column_stack([sin * np.cos(around), sin * np.sin(around), cos])
        points = (9.5 + rng.normal(0, 0.01, (800, 1))) * outward
        fit = check_sphere(points).fit
        found = fit_uncertainty(fit, points[fit.used], None)
        assert found is not None
        radii.append(fit.radius_mm)
        stated.append(found.sd(3, 3))
    assert 0.8 < np.mean(stated) / np.std(radii, ddof=1) < 1.6
