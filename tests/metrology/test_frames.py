"""Rigid transforms against scipy's rotations, and planes and spheres that are fitted."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from crenel.errors import OperationError
from crenel.metrology.fitting.plane_sphere import fit_plane, fit_sphere
from crenel.metrology.transforms import (
    apply,
    inverse,
    nearest_rotation,
    rigid,
    rigid_fit,
    rotation_from_vector,
    vector_from_rotation,
)
from tests.metrology.numerics import unit

vectors = st.lists(st.floats(-3.0, 3.0), min_size=3, max_size=3).map(np.array)
seeds = st.integers(0, 10**6)


@given(vectors)
def test_rotation_vectors_agree_with_scipy(vector: np.ndarray) -> None:
    expected = Rotation.from_rotvec(vector).as_matrix()
    np.testing.assert_allclose(rotation_from_vector(vector), expected, atol=1e-12)


@given(vectors)
def test_a_rotation_vector_survives_the_round_trip(vector: np.ndarray) -> None:
    rotation = rotation_from_vector(vector)
    again = rotation_from_vector(vector_from_rotation(rotation))
    np.testing.assert_allclose(again, rotation, atol=1e-9)


@given(vectors, vectors)
def test_the_inverse_undoes_a_transform(turn: np.ndarray, shift: np.ndarray) -> None:
    T = rigid(rotation_from_vector(turn), 100 * shift)
    points = np.array([[1.0, 2.0, 3.0], [-40.0, 5.0, 600.0]])
    np.testing.assert_allclose(apply(inverse(T), apply(T, points)), points, atol=1e-9)
    stack = np.stack([T, inverse(T)])
    np.testing.assert_allclose(apply(stack, points)[1], apply(inverse(T), points)[1], atol=1e-9)


@settings(max_examples=30)
@given(vectors, vectors, st.integers(0, 1000))
def test_a_rigid_fit_finds_the_transform(turn: np.ndarray, shift: np.ndarray, seed: int) -> None:
    T_ab = rigid(rotation_from_vector(turn), 50 * shift)
    b = np.random.default_rng(seed).normal(0, 30, (12, 3))
    np.testing.assert_allclose(rigid_fit(apply(T_ab, b), b), T_ab, atol=1e-8)


def test_a_rigid_fit_never_mirrors() -> None:
    b = np.random.default_rng(1).normal(0, 10, (20, 3))
    T_ab = rigid_fit(b * [1, 1, -1], b)
    assert np.linalg.det(T_ab[:3, :3]) == pytest.approx(1.0)


def test_a_rigid_fit_of_points_on_a_line_is_refused() -> None:
    line = np.outer(np.arange(5.0), [1.0, 2.0, 3.0])
    with pytest.raises(OperationError, match="one line"):
        rigid_fit(line, line)
    with pytest.raises(OperationError, match="at least three"):
        rigid_fit(line[:2], line[:2])


def test_the_nearest_rotation_is_proper() -> None:
    rng = np.random.default_rng(3)
    for _ in range(20):
        rotation = nearest_rotation(rng.normal(size=(3, 3)))
        np.testing.assert_allclose(rotation @ rotation.T, np.eye(3), atol=1e-12)
        assert np.linalg.det(rotation) == pytest.approx(1.0)


def test_a_refusal_reads_as_one_line() -> None:
    refusal = OperationError("a-code", "the file ended early.", "the power failed", "Scan again.")
    assert str(refusal) == "the file ended early: the power failed. Scan again."
    assert "\n" not in str(refusal)


def plane_points(rng: np.random.Generator, n: int, noise_mm: float) -> tuple[np.ndarray, ...]:
    normal = unit(rng.normal(size=3))
    offset = float(rng.uniform(-500, 500))
    points = rng.uniform(-30, 30, (n, 3))
    points += np.outer(offset - points @ normal + rng.normal(0, noise_mm, n), normal)
    return points, normal, np.array(offset)


def sphere_points(
    rng: np.random.Generator, n: int, noise_mm: float, cap: float = 0.0
) -> tuple[np.ndarray, np.ndarray, float]:
    centre, radius = rng.uniform(-400, 400, 3), float(rng.uniform(8, 30))
    away = unit(rng.normal(size=(n, 3)))
    away[:, 2] = np.where(away[:, 2] < cap, -away[:, 2], away[:, 2])
    return centre + away * (radius + rng.normal(0, noise_mm, n))[:, None], centre, radius


@settings(max_examples=30, deadline=None)
@given(seeds)
def test_exact_points_give_the_exact_plane(seed: int) -> None:
    points, normal, offset = plane_points(np.random.default_rng(seed), 50, 0.0)
    fit = fit_plane(points)
    sign = np.sign(fit.normal @ normal)
    np.testing.assert_allclose(sign * fit.normal, normal, atol=1e-9)
    assert sign * fit.offset_mm == pytest.approx(float(offset), abs=1e-7)


@settings(max_examples=30, deadline=None)
@given(seeds)
def test_exact_points_give_the_exact_sphere(seed: int) -> None:
    points, centre, radius = sphere_points(np.random.default_rng(seed), 80, 0.0)
    fit = fit_sphere(points)
    np.testing.assert_allclose(fit.centre_mm, centre, atol=1e-7)
    assert fit.radius_mm == pytest.approx(radius, abs=1e-7)


def test_a_third_of_outliers_does_not_move_the_plane() -> None:
    rng = np.random.default_rng(1)
    points, normal, offset = plane_points(rng, 3000, 0.01)
    offsets = rng.uniform(-30, 30, (1500, 3)) + 40 * normal * rng.uniform(0.2, 1, (1500, 1))
    cloud = np.vstack([points, points[:1500] + offsets])
    fit = fit_plane(cloud)
    angle = np.degrees(np.arccos(min(1.0, abs(fit.normal @ normal)))) * 3600
    assert angle < 20
    assert abs(abs(fit.offset_mm) - abs(float(offset))) < 0.02
    assert fit.used[:3000].mean() > 0.99
    assert fit.used[3000:].mean() < 0.01
    assert fit.rms_mm == pytest.approx(0.01, rel=0.1)


def test_a_table_under_the_sphere_does_not_move_it() -> None:
    rng = np.random.default_rng(2)
    points, centre, radius = sphere_points(rng, 4000, 0.01, cap=0.1)
    table = np.column_stack([rng.uniform(-30, 30, (1500, 2)), np.full(1500, -radius - 5)]) + centre
    fit = fit_sphere(np.vstack([points, table]))
    np.testing.assert_allclose(fit.centre_mm, centre, atol=0.004)
    assert fit.radius_mm == pytest.approx(radius, abs=0.004)
    assert fit.used[4000:].sum() == 0


def test_nan_points_are_never_used() -> None:
    points, _, _ = plane_points(np.random.default_rng(3), 100, 0.01)
    points[::7] = np.nan
    fit = fit_plane(points)
    assert not fit.used[::7].any()
    assert np.isfinite(fit.rms_mm)


def test_what_fixes_no_shape_is_refused() -> None:
    rng = np.random.default_rng(4)
    with pytest.raises(OperationError, match="2 usable points"):
        fit_plane(np.zeros((2, 3)))
    with pytest.raises(OperationError, match="one line"):
        fit_plane(np.outer(np.arange(20.0), [1.0, 1.0, 0.0]))
    with pytest.raises(OperationError, match="3 usable points"):
        fit_sphere(rng.normal(size=(3, 3)))
    with pytest.raises(OperationError, match="plane"):
        fit_sphere(np.column_stack([rng.normal(size=(50, 2)), np.zeros(50)]))
