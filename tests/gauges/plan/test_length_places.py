"""Places of a standard of length within the reach, and the spheres of a scanned ball bar."""

from dataclasses import replace

import numpy as np
import pytest

from crenel.gauges.judgement.maths_length_scatter import (
    find_loose_places,
    find_rocking_places,
    repeat_scatter_um,
)
from crenel.gauges.length.maths_bar_spheres import LEAST_POINTS, find_spheres, measure_sphere
from crenel.gauges.plan.maths_gate import SphereGate
from crenel.gauges.plan.maths_length_places import ArmReach, arm_reach, propose_places
from crenel.gauges.plan.maths_lengths import (
    PLACES,
    REPEATS,
    CalibratedLength,
    MeasuredLength,
    summarise_lengths,
)
from crenel.metrology.arm.kinematics import Arm, Joint, RobotArm, Tip
from crenel.metrology.transforms import Floats
from tests.metrology.numerics import on_sphere, unit

REACH = ArmReach(np.array([0.0, 0.0, 320.0]), 1379.0, known=True)
RADIUS_MM = 10.0
CENTRES = np.array([[0.0, 0.0, 50.0], [120.0, 30.0, 60.0]])
ALONG = unit(CENTRES[1] - CENTRES[0])
GATE = SphereGate()
CAMERA = np.array([0.0, 0.0, 1.0])


@pytest.mark.parametrize("bar_mm", [50.0, 400.0, 900.0, 1100.0])
def test_every_place_is_within_the_reach_and_clear_of_table_and_arm(bar_mm: float) -> None:
    places = propose_places(REACH, bar_mm)
    bars = places[:, :1] + np.linspace(0, 1, 50)[:, None] * (places[:, 1:] - places[:, :1])
    assert np.linalg.norm(places[:, 1] - places[:, 0], axis=1) == pytest.approx(bar_mm)
    assert np.linalg.norm(bars - REACH.shoulder_mm, axis=2).max() < 0.86 * REACH.radius_mm
    assert np.linalg.norm(bars[:, :, :2], axis=2).min() > 0.19 * REACH.radius_mm
    assert bars[:, :, 2].min() > 50


def test_the_directions_cover_the_volume() -> None:
    ends = propose_places(REACH, 400.0)
    directions = (ends[:, 1] - ends[:, 0]) / 400.0
    up = np.abs(directions[:, 2])
    assert up[:3] == pytest.approx(0)
    assert up[3] == pytest.approx(1)
    assert up[4:6] == pytest.approx(np.sqrt(0.5))
    assert up[6] == pytest.approx(np.sqrt(1 / 3))
    between = np.abs(directions @ directions.T) - np.eye(PLACES)
    assert np.degrees(np.arccos(between.max())) > 20
    near, far = (np.linalg.norm(ends[i].mean(axis=0)[:2]) for i in (1, 2))
    assert far > 1.4 * near


def test_an_arm_without_known_links_has_a_usual_reach() -> None:
    assert not arm_reach(RobotArm("Robot", "R-1")).known
    joints = tuple(Joint(f"J{i}", 0.0, 0.0, 0.0, 0.0) for i in range(6))
    without = arm_reach(Arm("Arm", "A-1", joints, Tip(0.0, 0.0, 0.0, 4.0)))
    assert not without.known
    assert without.radius_mm > 0


def lengths(sd_um: float, rocks: dict[int, float] | None = None) -> list[MeasuredLength]:
    random = np.random.default_rng(3)
    nominal = CalibratedLength(300.0, 0.5, 0.0)
    return [
        MeasuredLength(
            place,
            repeat,
            nominal,
            300.0 + 1e-3 * (rocks or {}).get(place, sd_um) * float(random.normal()),
        )
        for place in range(1, PLACES + 1)
        for repeat in range(1, REPEATS + 1)
        for _ in range(5)
    ]


def test_scatter_is_that_of_the_repeats() -> None:
    found = repeat_scatter_um(lengths(10.0, {3: 200.0}))
    assert found[3] == pytest.approx(200, rel=0.5)
    assert all(found[place] == pytest.approx(10, rel=0.5) for place in (1, 2, 4, 5, 6, 7))


def test_a_place_in_which_the_standard_rocks_is_found() -> None:
    assert not find_rocking_places(lengths(10.0))
    (found,) = find_rocking_places(lengths(10.0, {3: 200.0}))
    assert found.place == 3
    assert found.expected_um == pytest.approx(10, rel=0.5)
    # by the touches themselves, also where it rocks everywhere
    assert len(find_rocking_places(lengths(200.0), touches_um=10.0)) == PLACES
    assert not find_rocking_places(lengths(5.0), touches_um=0.1)  # too little to show


def of_five(sd_um: float, rocks: dict[int, float]) -> list[MeasuredLength]:
    """The same of a standard of five lengths."""
    found = lengths(sd_um, rocks)
    return [
        replace(
            one,
            nominal=replace(one.nominal, length_mm=100.0 * (1 + number % 5)),
            measured_mm=one.measured_mm - 300.0 + 100.0 * (1 + number % 5),
        )
        for number, one in enumerate(found)
    ]


@pytest.mark.parametrize("many", [4, 5])
def test_a_gauge_that_rocks_in_most_places_is_found_by_the_steady_ones(many: int) -> None:
    rocking = dict.fromkeys(range(1, many + 1), 300.0)
    found = find_rocking_places(of_five(10.0, rocking))
    assert [one.place for one in found] == list(rocking)
    assert all(one.expected_um < 40 for one in found)


def test_places_that_scatter_differently_do_not_rock() -> None:
    near_and_far = {1: 40.0, 2: 40.0, 3: 40.0, 4: 40.0, 5: 15.0}
    assert not find_rocking_places(of_five(10.0, near_and_far))


def test_without_limits_the_largest_error_counts() -> None:
    values = lengths(10.0)
    worst = summarise_lengths(values, [np.inf] * len(values)).worst
    assert abs(worst.error_um) == max(abs(one.error_um) for one in values)


def test_placements_far_from_the_arm_are_not_loose_by_chance() -> None:
    """Two spheres of four touches each, far ones with twice the scatter of near ones."""
    random = np.random.default_rng(9)
    named = 0
    for _ in range(500):
        sd_um = np.linspace(10.0, 20.0, 20)
        scatter_um = sd_um * np.sqrt(random.chisquare(2, 20) / 2)
        named += bool(find_loose_places(dict(enumerate(scatter_um.tolist(), 1))))
    assert named <= 2
    (found,) = find_loose_places({1: 5.0, 2: 5.0, 3: 90.0, 4: 4.0, 5: 6.0})
    assert found.place == 3
    assert not find_loose_places({1: 5.0, 2: 90.0})
    assert len(find_loose_places({1: 95.0, 2: 90.0}, steady_um=5.0)) == 2
    assert not find_loose_places({1: 9.0, 2: 0.1, 3: 0.1, 4: 0.1, 5: 0.1})  # too little to show


def cap(random: np.random.Generator, half_deg: float, count: int) -> Floats:
    """Unit directions (N, 3) evenly over a cap that looks to the camera."""
    height = random.uniform(np.cos(np.radians(half_deg)), 1.0, count)
    return on_sphere(height, random.uniform(0, 2 * np.pi, count))


def scanned(random: np.random.Generator, half_deg: float = 60.0, sd_mm: float = 0.01) -> Floats:
    """Points (N, 3) on both spheres."""
    caps = [cap(random, half_deg, 3000) for _ in CENTRES]
    radii = RADIUS_MM + sd_mm * random.normal(size=(2, 3000, 1))
    both = zip(CENTRES, radii, caps, strict=True)
    return np.concatenate([centre + r * n for centre, r, n in both])


def test_spheres_are_found_on_a_table_beside_a_rod_and_other_spheres() -> None:
    random = np.random.default_rng(3)
    flat = random.uniform(-60, 180, (20_000, 2))
    table = np.column_stack([flat, 0.02 * random.normal(size=20_000)])
    turn, place = random.uniform(0, np.pi, 4000), random.uniform(8, 115, 4000)
    rod = CENTRES[0] + place[:, None] * ALONG
    rod += 4 * np.column_stack([0 * turn, np.cos(turn), np.sin(turn)])
    other = np.array([60.0, -40.0, 12.0]) + 6.0 * cap(random, 60.0, 3000)
    cloud = np.concatenate([table, rod, other, scanned(random)])
    found = find_spheres(cloud, np.tile(CAMERA, (len(cloud), 1)), 2 * RADIUS_MM)
    assert len(found) == 2
    for centre in CENTRES:
        assert np.min(np.linalg.norm(found - centre, axis=1)) < 0.1


def test_no_spheres_are_found_on_a_plane() -> None:
    random = np.random.default_rng(4)
    plane = np.column_stack([random.uniform(0, 100, (5000, 2)), 0.01 * random.normal(size=5000)])
    assert len(find_spheres(plane, np.tile(CAMERA, (5000, 1)), 2 * RADIUS_MM)) == 0


@pytest.mark.parametrize(("half_deg", "covered"), [(60.0, True), (30.0, True), (18.0, False)])
def test_a_small_cap_does_not_fix_a_centre(half_deg: float, covered: bool) -> None:
    cloud = scanned(np.random.default_rng(5), half_deg)
    frames = np.arange(len(cloud)) // 50
    views = np.tile(CAMERA, (len(cloud), 1))
    found = measure_sphere(cloud, views, frames, 2 * RADIUS_MM, CENTRES[0], ALONG, GATE)
    assert found.points > LEAST_POINTS
    assert found.is_covered == covered


@pytest.mark.slow
def test_centres_scatter_as_their_normals_say() -> None:
    """The covariance of a fit with a known radius is ``sd² (Σ n nᵀ)⁻¹``."""
    sd_mm, apart = 0.05, []
    for seed in range(60):
        random = np.random.default_rng(seed)
        cloud = scanned(random, 50.0, sd_mm)
        views, frames = np.tile(CAMERA, (len(cloud), 1)), np.arange(len(cloud)) // 50
        scan = (cloud, views, frames, 2 * RADIUS_MM)
        ends = [measure_sphere(*scan, start, ALONG, GATE) for start in CENTRES]
        assert all(one.is_covered for one in ends)
        apart.append(np.linalg.norm(ends[1].centre_mm - ends[0].centre_mm))
    bar_mm = np.linalg.norm(CENTRES[1] - CENTRES[0])
    least_mm = sd_mm / np.sqrt(ends[0].points)
    assert np.mean(apart) == pytest.approx(bar_mm, abs=3 * least_mm)
    # along the bar, which lies across the view, a cap of 50° has about an eighth of n nᵀ
    assert np.std(apart) == pytest.approx(np.sqrt(2 / 0.15) * least_mm, rel=0.35)
