"""Where a sphere is touched, and its location error over articulations."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from crenel.gauges.sphere.maths_articulation import (
    LOCATION_CATCH_DEG,
    TILT_DEG,
    articulation_directions,
    assign_places,
    find_centre,
    flat_deg,
    frame_about,
    location_places,
    nearest_free,
)
from crenel.gauges.sphere.maths_location import estimate_offset, location_error_mm
from crenel.gauges.sphere.maths_pattern import CATCH_DEG, RIM_DEG, pattern_directions
from tests.metrology.refusals import refusal_of
from tests.uncertainty_ratio import EXACT, ratio_of_rms

CENTRE = np.array([700.0, 100.0, 200.0])
POLE = np.array([0.0, 0.0, 1.0])
SPHERE_AT = np.array([700.0, -120.0, 40.0])
RADIUS_MM = 15.7
PATTERN = pattern_directions(POLE, RIM_DEG)


def articulations(tilt_deg: float) -> np.ndarray:
    """Orientations (5, 3, 3): looking down, and tilted to four sides."""
    down = Rotation.from_euler("x", 180, degrees=True)
    tilts = [("y", 0.0), ("y", tilt_deg), ("y", -tilt_deg), ("x", tilt_deg), ("x", -tilt_deg)]
    turns = [Rotation.from_euler(axis, tilt, degrees=True) for axis, tilt in tilts]
    return np.array([(turn * down).as_matrix() for turn in turns])


def centres(R: np.ndarray, offset_mm: np.ndarray, noise_mm: float, seed: int = 0) -> np.ndarray:
    """Where a sphere seems to be if the matrix is wrong: the true sensor is ``offset`` away."""
    noise = noise_mm * np.random.default_rng(seed).normal(size=(len(R), 3))
    return np.asarray(CENTRE - R @ offset_mm + noise)


@pytest.mark.parametrize("axis", [0, 1, 2])
@pytest.mark.parametrize(("tilt_deg", "least", "most"), [(90, 1.41, 2.0), (45, 1.0, 1.42)])
def test_an_offset_shows_as_an_error(axis: int, tilt_deg: float, least: float, most: float) -> None:
    """50 µm show as 2.0 or 1.41 times as much at 90°, depending on the direction."""
    offset = 0.05 * np.eye(3)[axis]
    found = location_error_mm(centres(articulations(tilt_deg), offset, 0.0))
    assert least * 0.05 - 1e-6 <= found <= most * 0.05 + 1e-6


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_the_offset_is_found_with_its_direction(axis: int) -> None:
    R, offset = articulations(60), 0.05 * np.eye(3)[axis]
    found = estimate_offset(centres(R, offset, 0.003), R)
    np.testing.assert_allclose(found.offset_mm, offset, atol=0.012)
    assert found.is_significant
    assert found.left_mm < 0.02


def test_noise_alone_implies_nothing() -> None:
    R = articulations(60)
    off = [centres(R, np.zeros(3), 0.005, seed) for seed in range(200)]
    claimed = [estimate_offset(one, R).is_significant for one in off]
    assert sum(claimed) < 20


@pytest.mark.slow
def test_the_stated_scatter_of_the_offset_is_true() -> None:
    R = articulations(60)
    found = [estimate_offset(centres(R, np.zeros(3), 0.005, seed), R) for seed in range(500)]
    observed = np.array([one.offset_mm for one in found]).std(axis=0)
    stated = np.sqrt(np.mean([np.diag(one.covariance) for one in found], axis=0))
    for claimed, scatter in zip(stated, observed, strict=True):
        ratio_of_rms(claimed, scatter, len(found)).assert_within(*EXACT, k=2.5)


def test_articulations_from_one_side_tell_nothing() -> None:
    R = np.repeat(articulations(0)[:1], 5, axis=0)
    alike = centres(R, np.zeros(3), 0.005)
    assert refusal_of(estimate_offset, alike, R).code == "articulations-alike"


def test_what_the_arm_itself_scatters_is_not_blamed_on_the_probe_matrix() -> None:
    R, offset = articulations(60), np.array([-0.011, 0.0, 0.0])
    off = centres(R, offset, 0.002)
    assert estimate_offset(off, R).is_significant
    assert not estimate_offset(off, R, arm_sd_mm=0.012).is_significant
    assert estimate_offset(centres(R, 10 * offset, 0.002), R, arm_sd_mm=0.012).is_significant


@pytest.mark.parametrize("count", [1, 2, 3, 4, 25])
def test_the_centre_follows_from_few_touches(count: int) -> None:
    touches = SPHERE_AT + RADIUS_MM * PATTERN[:count]
    assert find_centre(touches, RADIUS_MM, POLE) == pytest.approx(SPHERE_AT, abs=1e-6)


def test_a_first_touch_beside_the_pole_is_made_up_for_by_the_others() -> None:
    aside = np.array([np.sin(np.radians(9.0)), 0.0, np.cos(np.radians(9.0))])
    touches = SPHERE_AT + RADIUS_MM * np.vstack([aside, PATTERN[[5, 9, 14, 20]]])
    assert find_centre(touches, RADIUS_MM, POLE) == pytest.approx(SPHERE_AT, abs=1e-6)


def test_a_touch_belongs_to_the_nearest_free_place_within_reach() -> None:
    touches = SPHERE_AT + RADIUS_MM * PATTERN[[3, 3, 7]]
    found = assign_places(touches, SPHERE_AT, PATTERN, CATCH_DEG)
    assert found.tolist() == [3, -1, 7]
    between = (PATTERN[5] + PATTERN[6]) / np.linalg.norm(PATTERN[5] + PATTERN[6])
    apart_deg = np.degrees(np.arccos(between @ PATTERN[5]))
    at = (SPHERE_AT + RADIUS_MM * between)[None]
    assert assign_places(at, SPHERE_AT, PATTERN, apart_deg - 1.0).tolist() == [-1]
    assert assign_places(at, SPHERE_AT, PATTERN, apart_deg + 1.0)[0] in (5, 6)


def test_the_next_place_is_the_nearest_that_is_free() -> None:
    tip = SPHERE_AT + 40.0 * PATTERN[12]
    assert nearest_free(tip, SPHERE_AT, PATTERN, []) == 12
    assert nearest_free(tip, SPHERE_AT, PATTERN, [12]) != 12
    assert nearest_free(tip, SPHERE_AT, PATTERN, range(25)) == -1


def test_the_articulations_tilt_away_right_towards_the_arm_and_left() -> None:
    towards = -SPHERE_AT
    found = articulation_directions(POLE, towards)
    assert np.linalg.norm(found, axis=1) == pytest.approx(1.0)
    flat = flat_deg(found, POLE, towards)
    expected = [[0, 0], [0, TILT_DEG], [TILT_DEG, 0], [0, -TILT_DEG], [-TILT_DEG, 0]]
    assert flat == pytest.approx(np.array(expected, dtype=float), abs=1e-6)
    assert np.linalg.det(frame_about(POLE, towards)) == pytest.approx(1.0)


@pytest.mark.parametrize("number", range(5))
def test_the_places_of_an_articulation_are_around_its_direction(number: int) -> None:
    towards = -SPHERE_AT
    direction = articulation_directions(POLE, towards)[number]
    places = location_places(direction, POLE, towards)
    assert places[0] == pytest.approx(direction)
    assert places[1:] @ direction == pytest.approx(0.5)
    apart_deg = np.degrees(np.arccos(np.clip(places @ places.T, -1, 1)))[~np.eye(5, dtype=bool)]
    assert apart_deg.min() > LOCATION_CATCH_DEG
