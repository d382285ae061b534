"""Where a sphere is touched: its centre by few touches, and the place that each belongs to."""

import numpy as np
import pytest

from app.metrology.performance.articulation import (
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
from app.metrology.performance.pattern import CATCH_DEG, RIM_DEG, pattern_directions

POLE = np.array([0.0, 0.0, 1.0])
CENTRE = np.array([700.0, -120.0, 40.0])
RADIUS_MM = 15.7
PATTERN = pattern_directions(POLE, RIM_DEG)


@pytest.mark.parametrize("count", [1, 2, 3, 4, 25])
def test_the_centre_follows_from_few_touches(count: int) -> None:
    touches = CENTRE + RADIUS_MM * PATTERN[:count]
    assert find_centre(touches, RADIUS_MM, POLE) == pytest.approx(CENTRE, abs=1e-6)


def test_a_first_touch_beside_the_pole_is_made_up_for_by_the_others() -> None:
    aside = np.array([np.sin(np.radians(9.0)), 0.0, np.cos(np.radians(9.0))])
    touches = CENTRE + RADIUS_MM * np.vstack([aside, PATTERN[[5, 9, 14, 20]]])
    assert find_centre(touches, RADIUS_MM, POLE) == pytest.approx(CENTRE, abs=1e-6)


def test_a_touch_belongs_to_the_nearest_free_place_within_reach() -> None:
    touches = CENTRE + RADIUS_MM * PATTERN[[3, 3, 7]]
    found = assign_places(touches, CENTRE, PATTERN, CATCH_DEG)
    assert found.tolist() == [3, -1, 7]
    between = (PATTERN[5] + PATTERN[6]) / np.linalg.norm(PATTERN[5] + PATTERN[6])
    apart_deg = np.degrees(np.arccos(between @ PATTERN[5]))
    at = (CENTRE + RADIUS_MM * between)[None]
    assert assign_places(at, CENTRE, PATTERN, apart_deg - 1.0).tolist() == [-1]
    assert assign_places(at, CENTRE, PATTERN, apart_deg + 1.0)[0] in (5, 6)


def test_the_next_place_is_the_nearest_that_is_free() -> None:
    tip = CENTRE + 40.0 * PATTERN[12]
    assert nearest_free(tip, CENTRE, PATTERN, []) == 12
    assert nearest_free(tip, CENTRE, PATTERN, [12]) != 12
    assert nearest_free(tip, CENTRE, PATTERN, range(25)) == -1


def test_the_articulations_tilt_away_right_towards_the_arm_and_left() -> None:
    towards = -CENTRE
    found = articulation_directions(POLE, towards)
    assert np.linalg.norm(found, axis=1) == pytest.approx(1.0)
    flat = flat_deg(found, POLE, towards)
    expected = [[0, 0], [0, TILT_DEG], [TILT_DEG, 0], [0, -TILT_DEG], [-TILT_DEG, 0]]
    assert flat == pytest.approx(np.array(expected, dtype=float), abs=1e-6)
    assert np.linalg.det(frame_about(POLE, towards)) == pytest.approx(1.0)


@pytest.mark.parametrize("number", range(5))
def test_the_places_of_an_articulation_are_around_its_direction(number: int) -> None:
    towards = -CENTRE
    direction = articulation_directions(POLE, towards)[number]
    places = location_places(direction, POLE, towards)
    assert places[0] == pytest.approx(direction)
    assert places[1:] @ direction == pytest.approx(0.5)
    apart_deg = np.degrees(np.arccos(np.clip(places @ places.T, -1, 1)))[~np.eye(5, dtype=bool)]
    assert apart_deg.min() > LOCATION_CATCH_DEG
