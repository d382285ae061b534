"""Least-squares fits against solutions with 50 digits."""

import mpmath
import numpy as np
import pytest

from app.metrology.fitting.cylinder import perpendicular_axes
from app.metrology.performance.plane import least_squares_plane
from app.metrology.performance.sphere import least_squares_sphere

mpmath.mp.dps = 50


def cap(half_angle_deg: float, seed: int, count: int = 60) -> np.ndarray:
    """Points (N, 3) about a cap of a sphere far from the origin, with form and noise."""
    random = np.random.default_rng(seed)
    axis = random.normal(size=3)
    axis /= np.linalg.norm(axis)
    a, b = perpendicular_axes(axis)
    tilt = np.arccos(1 - random.uniform(0, 1, count) * (1 - np.cos(np.radians(half_angle_deg))))
    turn = random.uniform(0, 2 * np.pi, count)
    side = np.cos(turn)[:, None] * a + np.sin(turn)[:, None] * b
    outward = np.cos(tilt)[:, None] * axis + np.sin(tilt)[:, None] * side
    radius = 12.7 + 0.02 * random.normal(size=(count, 1)) + 0.01 * np.cos(3 * turn)[:, None]
    return np.asarray(np.array([700.0, -300.0, 150.0]) + radius * outward)


def exact_sphere(points: np.ndarray, start: np.ndarray) -> list[mpmath.mpf]:
    """Centre and radius of least squares of radial distances, by Newton with 50 digits."""
    rows = [[mpmath.mpf(float(x)) for x in point] for point in points]
    found = [mpmath.mpf(float(x)) for x in start]
    for _ in range(60):
        N, g = mpmath.zeros(4, 4), mpmath.zeros(4, 1)
        for x, y, z in rows:
            away = [x - found[0], y - found[1], z - found[2]]
            distance = mpmath.sqrt(sum(one * one for one in away))
            j = [-one / distance for one in away] + [mpmath.mpf(-1)]
            r = distance - found[3]
            for p in range(4):
                g[p] -= j[p] * r
                for q in range(4):
                    N[p, q] += j[p] * j[q]
        step = mpmath.lu_solve(N, g)
        found = [one + step[i] for i, one in enumerate(found)]
        if max(abs(step[i]) for i in range(4)) < mpmath.mpf(10) ** -40:
            return found
    raise AssertionError("the reference did not converge")


@pytest.mark.parametrize("half_angle_deg", [20, 35, 60, 90])
@pytest.mark.parametrize("seed", [1, 2, 3])
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
    rows = [[mpmath.mpf(float(x)) for x in point] for point in points]
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
