"""What white noise makes of the figures, against its known expectations."""

import numpy as np
import pytest

from app.metrology.performance.enclosing_sphere import smallest_enclosing_sphere
from app.metrology.performance.pattern import pattern_directions
from app.metrology.performance.sphere import dispersion_mm, least_squares_sphere

DRAWS = 3_000
"""``crenel bench performance`` draws 10 000."""
POLE = np.array([0.0, 0.0, 1.0])


@pytest.fixture(scope="module")
def noisy() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Forms, centres and radii of 25 points with radial noise of 1 µm, in µm."""
    random = np.random.default_rng(1)
    directions = pattern_directions(POLE)
    forms, centres, radii = [], [], []
    for _ in range(DRAWS):
        found = least_squares_sphere(directions * (12.5 + 1e-3 * random.normal(size=(25, 1))))
        forms.append(1e3 * found.form_mm)
        centres.append(1e3 * found.centre_mm)
        radii.append(1e3 * (found.diameter_mm / 2 - 12.5))
    return np.array(forms), np.array(centres), np.array(radii)


def test_the_form_of_25_points(noisy: tuple[np.ndarray, np.ndarray, np.ndarray]) -> None:
    """The range of 25 deviations about a known centre is 3.931 standard deviations; the fit takes
    four of the 25 degrees of freedom."""
    random = np.random.default_rng(2)
    about_known = np.ptp(random.normal(size=(DRAWS, 25)), axis=1).mean()
    assert about_known == pytest.approx(3.931, rel=0.02)
    directions = pattern_directions(POLE)
    J = np.column_stack([directions, np.ones(25)])
    hat = J @ np.linalg.inv(J.T @ J) @ J.T
    fitted = np.ptp(random.normal(size=(DRAWS, 25)) @ (np.eye(25) - hat), axis=1).mean()
    assert noisy[0].mean() == pytest.approx(fitted, rel=0.02)
    assert noisy[0].mean() == pytest.approx(3.66, rel=0.02)


def test_centre_and_radius_of_25_points(noisy: tuple[np.ndarray, np.ndarray, np.ndarray]) -> None:
    np.testing.assert_allclose(noisy[1].std(axis=0), [0.354, 0.354, 0.546], rtol=0.04)
    assert noisy[2].std() == pytest.approx(0.328, rel=0.04)


def test_dispersion_of_many_points() -> None:
    """95 % of a normal distribution lie within 3.92 standard deviations."""
    random = np.random.default_rng(3)
    found = [dispersion_mm(random.normal(size=20_000)) for _ in range(200)]
    assert np.mean(found) == pytest.approx(3.915, rel=0.01)


@pytest.mark.slow
def test_the_sphere_about_five_centres() -> None:
    # a thousand leave 0.7 % in the mean and 1.3 % in the quantile
    random = np.random.default_rng(4)
    found = [smallest_enclosing_sphere(random.normal(size=(5, 3))).diameter_mm for _ in range(1000)]
    assert np.mean(found) == pytest.approx(3.65, rel=0.02)
    assert np.quantile(found, 0.95) == pytest.approx(5.05, rel=0.04)


@pytest.mark.parametrize("count", range(1, 8))
def test_the_enclosing_sphere_holds_all_and_none_is_smaller(count: int) -> None:
    """Against a minimum over many trial centres."""
    random = np.random.default_rng(count)
    points = random.normal(size=(count, 3))
    found = smallest_enclosing_sphere(points)
    away = np.linalg.norm(points - found.centre_mm, axis=1)
    assert away.max() <= found.diameter_mm / 2 + 1e-9
    near = found.centre_mm + 0.05 * random.normal(size=(2000, 3))
    largest = np.linalg.norm(points[None] - near[:, None], axis=2).max(axis=1)
    assert largest.min() >= found.diameter_mm / 2 - 1e-9
