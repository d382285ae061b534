"""The arm's angles between its samples."""

import numpy as np

from app.metrology.arm.reading_interpolation import interpolate_readings

STAMPS_NS = np.array([1_000, 2_000, 3_000, 9_000])
Q_RAD = np.array([[0.0, 3.1], [0.2, -3.1], [0.4, -3.0], [1.0, -2.0]])
GAP_NS = 2_000


def test_a_stamp_between_two_samples_lies_on_the_line_between_them() -> None:
    found = interpolate_readings("joints", STAMPS_NS, Q_RAD, np.array([2_250, 2_000]), GAP_NS)
    np.testing.assert_allclose(found, [[0.25, -3.075], [0.2, -3.1]], atol=1e-12)


def test_a_joint_that_passes_the_half_turn_is_followed_the_short_way() -> None:
    ((_, q2),) = interpolate_readings("joints", STAMPS_NS, Q_RAD, np.array([1_500]), GAP_NS)
    np.testing.assert_allclose(np.exp(1j * q2), -1.0, atol=1e-12)


def test_outside_the_samples_and_in_gaps_there_is_nothing() -> None:
    found = interpolate_readings("joints", STAMPS_NS, Q_RAD, np.array([999, 9_001, 4_000]), GAP_NS)
    assert np.isnan(found).all()
    assert np.isfinite(interpolate_readings("joints", STAMPS_NS, Q_RAD, STAMPS_NS, GAP_NS)).all()


def test_without_samples_there_is_nothing() -> None:
    found = interpolate_readings("joints", STAMPS_NS[:0], Q_RAD[:0], np.array([1_000]), GAP_NS)
    assert found.shape == (1, 2)
    assert np.isnan(found).all()
