"""Least-squares fits against solutions with 50 digits."""

from collections.abc import Callable, Iterable, Iterator

import mpmath
import numpy as np
import pytest
from numpy.typing import ArrayLike

from crenel.gauges.plane.maths import least_squares_plane
from crenel.metrology.fitting.cylinder import fit_cylinder, perpendicular_axes
from crenel.metrology.fitting.reference_sphere import least_squares_sphere
from tests.metrology.numerics import unit
from tests.running.usual import usual

pytestmark = pytest.mark.slow

mpmath.mp.dps = 50


def cap(half_angle_deg: float, seed: int, count: int = 60) -> np.ndarray:
    """Points (N, 3) about a cap of a sphere far from the origin, with form and noise."""
    random = np.random.default_rng(seed)
    axis = unit(random.normal(size=3))
    a, b = perpendicular_axes(axis)
    tilt = np.arccos(1 - random.uniform(0, 1, count) * (1 - np.cos(np.radians(half_angle_deg))))
    turn = random.uniform(0, 2 * np.pi, count)
    side = np.cos(turn)[:, None] * a + np.sin(turn)[:, None] * b
    outward = np.cos(tilt)[:, None] * axis + np.sin(tilt)[:, None] * side
    radius = 12.7 + 0.02 * random.normal(size=(count, 1)) + 0.01 * np.cos(3 * turn)[:, None]
    return np.asarray(np.array([700.0, -300.0, 150.0]) + radius * outward)


def exact(values: ArrayLike) -> list[list[mpmath.mpf]]:
    return [[mpmath.mpf(float(x)) for x in row] for row in np.atleast_2d(values)]


def solve_least_squares(
    equations: Callable[[list[mpmath.mpf]], Iterable[tuple[list[mpmath.mpf], mpmath.mpf]]],
    start: list[mpmath.mpf],
    digits: int,
) -> list[mpmath.mpf]:
    """By Gauss-Newton, of the derivatives and the residual of each point at given unknowns."""
    found, count = start, len(start)
    for _ in range(200):
        N, g = mpmath.zeros(count, count), mpmath.zeros(count, 1)
        for j, off in equations(found):
            for p in range(count):
                g[p] -= j[p] * off
                for q in range(count):
                    N[p, q] += j[p] * j[q]
        step = mpmath.lu_solve(N, g)
        found = [one + step[i] for i, one in enumerate(found)]
        if max(abs(step[i]) for i in range(count)) < mpmath.mpf(10) ** -digits:
            return found
    raise AssertionError("the reference did not converge")


def exact_sphere(points: np.ndarray, start: np.ndarray) -> list[mpmath.mpf]:
    """Centre and radius of least squares of radial distances."""
    rows = exact(points)

    def equations(found: list[mpmath.mpf]) -> Iterator[tuple[list[mpmath.mpf], mpmath.mpf]]:
        for row in rows:
            away = [one - centre for one, centre in zip(row, found[:3], strict=True)]
            distance = mpmath.sqrt(sum(one * one for one in away))
            yield [*(-one / distance for one in away), mpmath.mpf(-1)], distance - found[3]

    return solve_least_squares(equations, exact(start)[0], 40)


@pytest.mark.parametrize("half_angle_deg", [20, 35, 60, 90])
@pytest.mark.parametrize("seed", usual([1, 2, 3], 1, pytest.mark.soak))
def test_a_sphere_has_the_digits_of_the_reference(half_angle_deg: float, seed: int) -> None:
    points = cap(half_angle_deg, seed)
    found = least_squares_sphere(points)
    exact = exact_sphere(points, np.append(found.centre_mm, found.diameter_mm / 2))
    for mine, theirs in zip([*found.centre_mm.tolist(), found.diameter_mm / 2], exact, strict=True):
        assert abs(mpmath.mpf(mine) - theirs) < 1e-9


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_plane_has_the_digits_of_the_reference(seed: int) -> None:
    random = np.random.default_rng(seed)
    points = random.uniform(-50, 50, (80, 3)) * [1, 1, 0.0004] + [600.0, 200.0, -40.0]
    found = least_squares_plane(points)
    rows = exact(points)
    middle = [sum(row[i] for row in rows) / len(rows) for i in range(3)]
    M = mpmath.zeros(3, 3)
    for row in rows:
        for p in range(3):
            for q in range(3):
                M[p, q] += (row[p] - middle[p]) * (row[q] - middle[q])
    values, vectors = mpmath.eigsy(M)
    normal = [vectors[i, 0] for i in range(3)]
    assert values[0] < values[1]
    sign = 1 if sum(n * float(m) for n, m in zip(normal, found.normal, strict=True)) > 0 else -1
    for mine, theirs in zip(found.normal.tolist(), normal, strict=True):
        assert abs(mpmath.mpf(mine) - sign * theirs) < 1e-12
    for mine, theirs in zip(found.centre_mm.tolist(), middle, strict=True):
        assert abs(mpmath.mpf(mine) - theirs) < 1e-11


def arc_of_cylinder(arc_deg: float, seed: int, count: int = 300) -> np.ndarray:
    """Points (N, 3) about a strip of a cylinder far from the origin, with form and noise."""
    random = np.random.default_rng(seed)
    axis = unit(random.normal(size=3))
    a, b = perpendicular_axes(axis)
    turn = np.radians(arc_deg) * random.uniform(-0.5, 0.5, count)
    radius = 15.0 + 0.004 * random.uniform(-1, 1, count) + 0.003 * np.cos(9 * turn)
    outward = np.cos(turn)[:, None] * a + np.sin(turn)[:, None] * b
    along = random.uniform(-20, 20, count)
    off_axis = radius[:, None] * outward + along[:, None] * axis
    return np.asarray([700.0, -300.0, 150.0] + off_axis)


def exact_cylinder(
    points: np.ndarray, point: np.ndarray, direction: np.ndarray, radius: float
) -> tuple[list[mpmath.mpf], list[mpmath.mpf], mpmath.mpf]:
    """Point of the axis, direction and radius of least squares of radial distances, by four
    parameters: where it meets the plane across the start's direction, and its inclination."""
    a, b = perpendicular_axes(direction)
    axes = exact([a, b, direction])
    rows = [
        [sum(x * e for x, e in zip(away, one, strict=True)) for one in axes]
        for away in exact(points - point)
    ]

    def equations(found: list[mpmath.mpf]) -> Iterator[tuple[list[mpmath.mpf], mpmath.mpf]]:
        p, q, m, n, r = found
        square = 1 + m * m + n * n
        for x, y, z in rows:
            along = ((x - p) * m + (y - q) * n + z) / square
            away = [x - p - along * m, y - q - along * n, z - along]
            distance = mpmath.sqrt(sum(one * one for one in away))
            u, v = away[0] / distance, away[1] / distance
            yield [-u, -v, -u * along, -v * along, mpmath.mpf(-1)], distance - r

    start = [mpmath.mpf(0)] * 4 + [mpmath.mpf(radius)]
    p, q, m, n, r = solve_least_squares(equations, start, 30)
    length = mpmath.sqrt(1 + m * m + n * n)

    def turned(values: list[mpmath.mpf]) -> list[mpmath.mpf]:
        return [sum(v * e[i] for v, e in zip(values, axes, strict=True)) for i in range(3)]

    return turned([p, q, mpmath.mpf(0)]), turned([m / length, n / length, 1 / length]), r


@pytest.mark.parametrize("arc_deg", [20, 35, 60, 90])
@pytest.mark.parametrize("seed", usual([1, 2, 3], 1, pytest.mark.soak))
def test_a_cylinder_has_the_digits_of_the_reference(arc_deg: float, seed: int) -> None:
    points = arc_of_cylinder(arc_deg, seed)
    found = fit_cylinder(points)
    assert found.used.all()
    start = (found.point_mm, found.direction, found.radius_mm)
    shift, direction, radius = exact_cylinder(points, *start)
    assert abs(mpmath.mpf(found.radius_mm) - radius) < 1e-9
    # the shift of the axis at the fit's own point, across it
    along = sum(s * d for s, d in zip(shift, direction, strict=True))
    for s, d in zip(shift, direction, strict=True):
        assert abs(s - along * d) < 1e-9
    for mine, theirs in zip(found.direction.tolist(), direction, strict=True):
        assert abs(mpmath.mpf(mine) - theirs) < 1e-11
