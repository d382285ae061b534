"""Rigid transforms against scipy's rotations and against themselves."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from app.errors import OperationError
from app.metrology.transforms import (
    apply,
    inverse,
    nearest_rotation,
    rigid,
    rigid_fit,
    rotation_from_vector,
    vector_from_rotation,
)

vectors = st.lists(st.floats(-3.0, 3.0), min_size=3, max_size=3).map(np.array)


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
