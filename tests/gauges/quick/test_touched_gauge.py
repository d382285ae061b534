"""A gauge's place by the probe, its part of a scanned cloud, and what touches show of the tip."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.special import stdtrit
from scipy.stats import norm

from crenel.errors import OperationError
from crenel.gauges.quick.maths.probed_gauge import fit_probed_plane, fit_probed_sphere
from crenel.gauges.quick.maths.scanned_gauge import (
    GaugeCloud,
    fit_gauge_plane,
    fit_gauge_sphere,
    zone_mm,
)
from crenel.gauges.quick.maths.tip_check import check_tip
from crenel.metrology.arm.kinematics import Arm, Tip, flange_pose, tip_centres
from crenel.metrology.fitting.cylinder import perpendicular_axes
from crenel.metrology.fitting.deviation_map import MOST_OUTLIERS, deviation_map, find_outliers
from crenel.metrology.fitting.plane_sphere import PlaneFit, SphereFit
from crenel.metrology.fitting.shape import measure_shape
from crenel.metrology.fitting.touched_shape import refuse_doubt
from crenel.metrology.probing.reachable import off_sphere_mm
from tests.guide.builders import REST_RAD, reach_tip
from tests.metrology.builders import six_axis_arm
from tests.metrology.numerics import on_sphere, unit
from tests.refusals import refused_as
from tests.uncertainty_ratio import ratio_of_deviations

RNG = np.random.default_rng(7)


@pytest.fixture(scope="module")
def arm() -> Arm:
    return six_axis_arm(encoder_sd_rad=1e-6)


def touching(arm: Arm, tips_mm: np.ndarray) -> np.ndarray:
    return np.array([reach_tip(arm, tip, REST_RAD) for tip in tips_mm])


def test_a_touched_plane_lies_a_tips_radius_beneath_and_faces_the_arm(arm: Arm) -> None:
    normal = unit([0.1, -0.2, 1.0])
    middle = tip_centres(arm, REST_RAD[None])[0]
    arm_side = float(normal @ -(flange_pose(arm, REST_RAD)[:3, :3] @ arm.tip.centre_mm))
    normal *= np.sign(arm_side)
    a = unit(np.cross(normal, [1.0, 0.0, 0.0]))
    b = np.cross(normal, a)
    places = np.array([(-20, -15), (20, 15), (-20, 15), (20, -15), (0, 3)])
    found = fit_probed_plane(arm, touching(arm, middle + places @ np.stack([a, b])))
    assert arm_side != 0
    assert found.nominal.normal == pytest.approx(normal, abs=1e-6)
    assert found.nominal.offset_mm == pytest.approx(normal @ middle - 3.0, abs=1e-6)
    assert found.rms_mm < 1e-6
    assert found.height_sd_mm(middle + 100 * a) > found.height_sd_mm(middle)


def test_touches_on_a_line_fix_no_plane(arm: Arm) -> None:
    middle = tip_centres(arm, REST_RAD[None])[0]
    q = touching(arm, middle + np.outer(np.linspace(-20, 20, 5), [1.0, 0.0, 0.0]))
    with pytest.raises(OperationError, match="one line"):
        fit_probed_plane(arm, q)
    with pytest.raises(OperationError, match="at least 4"):
        fit_probed_plane(arm, q[:3])


def test_one_of_four_points_is_off_a_plane_and_nothing_tells_which(arm: Arm) -> None:
    middle = tip_centres(arm, REST_RAD[None])[0]
    places = np.array(
        [(-20, -15, 0), (20, 15, 0), (-20, 15, 0), (20, -15, 3), (0, 9, 0), (9, 0, 0)]
    )
    few = fit_probed_plane(arm, touching(arm, middle + places[:4]))
    assert not few.outliers.any()
    with refused_as("contact-off-unknown-which", "At least one of the points 1, 2, 3, 4 is off"):
        refuse_doubt(few.doubtful)
    found = fit_probed_plane(arm, touching(arm, middle + places))
    assert np.flatnonzero(found.outliers).tolist() == [3]
    assert found.rms_mm < 1e-4


@pytest.mark.slow
def test_the_stated_uncertainty_of_a_touched_sphere_is_how_it_scatters(arm: Arm) -> None:
    centre = tip_centres(arm, REST_RAD[None])[0]
    outward = on_sphere(np.linspace(1.0, 0.1, 9), 2.4 * np.arange(9))
    off, stated = [], []
    for _ in range(60):
        tips = centre + (13.0 + RNG.normal(0, 0.01, 9))[:, None] * outward
        found = fit_probed_sphere(arm, touching(arm, tips), 10.0)
        off.append(found.nominal.centre_mm - centre)
        stated.append(np.sqrt(np.trace(found.covariance)))
        assert abs(found.radius_mm - 10.0) < 6 * found.radius_sd_mm
    scatter = np.linalg.norm(off, axis=1)
    # stated by Student's distribution of five degrees of freedom: twice it holds 95 %
    student = float(stdtrit(5, norm.cdf(2))) / 2
    ratio_of_deviations(np.array(stated), scatter).assert_within(student, student)


def test_one_ring_about_a_sphere_fixes_no_centre(arm: Arm) -> None:
    centre = tip_centres(arm, REST_RAD[None])[0]
    turn = np.linspace(0, 2 * np.pi, 7)[:-1]
    ring = centre + 13.0 * on_sphere(np.zeros(6), turn)
    with pytest.raises(OperationError, match="ring"):
        fit_probed_sphere(arm, touching(arm, ring), 10.0)


def sphere_scan(radius_mm: float, on_it: int, beside: int) -> tuple[np.ndarray, np.ndarray]:
    height = RNG.uniform(0.1, 1.0, on_it)
    outward = on_sphere(height, RNG.uniform(0, 2 * np.pi, on_it))
    ball = outward * (radius_mm + RNG.normal(0, 0.01, on_it))[:, None]
    x, y = RNG.uniform(-40, 40, beside), RNG.uniform(-40, 40, beside)
    points = np.vstack([ball, np.column_stack([x, y, np.full(beside, -20.0)])])
    return points, RNG.integers(0, 60, len(points))


@pytest.mark.parametrize("beside", [12000, 30000, 60000])
def test_a_sphere_is_found_though_it_may_be_a_twentieth_of_the_cloud(beside: int) -> None:
    found = fit_gauge_sphere(*sphere_scan(12.7, 3000, beside), 12.7)
    assert found.points == 3000 + beside
    assert found.used > 2800
    assert isinstance(found.shape.fit, SphereFit)
    assert found.shape.fit.radius_mm == pytest.approx(12.7, abs=0.003)
    assert found.form_mm == pytest.approx(4 * 0.0098, rel=0.05)


@pytest.mark.parametrize(
    ("radius_mm", "points", "said"),
    [
        (10.0, sphere_scan(12.7, 3000, 0), "diameter of 25.[34]|no sphere of 20.00"),
        (12.7, sphere_scan(12.7, 200, 100), "300 points"),
        (12.7, sphere_scan(500.0, 3000, 0), "no sphere of 25.40"),
    ],
)
def test_another_gauge_or_too_small_a_cloud_is_named(
    radius_mm: float, points: tuple[np.ndarray, np.ndarray], said: str
) -> None:
    with pytest.raises(OperationError, match=said):
        fit_gauge_sphere(*points, radius_mm)


def test_a_cap_is_too_little_of_a_sphere() -> None:
    points, frame = sphere_scan(12.7, 20000, 0)
    top = points[:, 2] > 11.5
    with pytest.raises(OperationError, match="cap of 2"):
        fit_gauge_sphere(points[top], frame[top], 12.7)


def test_a_strip_is_too_little_of_a_plane_and_a_bowl_is_none() -> None:
    x, y = RNG.uniform(-20, 20, 4000), RNG.uniform(-20, 20, 4000)
    frame = RNG.integers(0, 50, 4000)
    flat = np.column_stack([x, y, RNG.normal(0, 0.01, 4000)])
    assert fit_gauge_plane(flat, frame).used > 3900
    with pytest.raises(OperationError, match="strip"):
        fit_gauge_plane(flat * [1.0, 0.05, 1.0], frame)
    with pytest.raises(OperationError, match="not a plane"):
        fit_gauge_plane(np.column_stack([x, y, 0.02 * (x**2 + y**2)]), frame)


def test_rest_at_the_end_of_a_pass_makes_no_strip_of_it() -> None:
    along, frames = np.linspace(-20, 20, 400), 700
    x = np.tile(along, frames)
    # forty frames in a pass, and all others at its end, with a trembling hand
    at = np.minimum(np.arange(frames), 40.0) - 20 + RNG.normal(0, 0.01, frames)
    y = np.repeat(at, len(along))
    z = 0.1 * x + 0.2 * y + RNG.normal(0, 0.01, len(x))
    found = fit_gauge_plane(np.column_stack([x, y, z]), np.repeat(np.arange(frames), len(along)))
    assert found.used < 100 * len(along)
    assert isinstance(found.shape.fit, PlaneFit)
    normal = np.array([-0.1, -0.2, 1.0]) / np.sqrt(1.05)
    off_rad = np.arccos(min(abs(float(found.shape.fit.normal @ normal)), 1.0))
    assert off_rad < np.deg2rad(60 / 3600)


def test_the_map_shows_where_a_plane_is_high() -> None:
    x, y = RNG.uniform(-20, 20, 20000), RNG.uniform(-10, 10, 20000)
    bump = np.where((x > 10) & (y > 0), 0.02, 0.0)
    points = np.column_stack([x, y, bump + RNG.normal(0, 0.01, 20000)])
    found = measure_shape("plane", points, np.arange(20000) // 400)
    assert isinstance(found.fit, PlaneFit)
    cells = deviation_map(found.fit, points)
    high = (cells.x_mm > 11) & (cells.y_mm > 1)
    assert cells.deviation_um[high].mean() > cells.deviation_um[~high].mean() + 10


@pytest.mark.parametrize("outward", [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [-0.8, 0.0, 0.6]])
@pytest.mark.parametrize("shape", ["plane", "sphere"])
def test_outliers_are_found_in_place_outward_is_positive(shape: str, outward: list[float]) -> None:
    rng = np.random.default_rng(3)
    axis = np.array(outward)
    if shape == "plane":
        a, b = perpendicular_axes(axis)
        places = rng.uniform(-20, 20, (6000, 2)) @ np.stack([a, b])
        normals = np.tile(axis, (6000, 1))
    else:
        normals = rng.normal(size=(30000, 3))
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        normals = normals[normals @ axis > 0.3][:6000]
        places = 12.7 * normals
    off = rng.normal(0, 0.01, len(places))
    dust = np.linalg.norm(places - places[0], axis=1) < 0.6
    for planted in (False, True):
        if planted:
            off[dust] += 0.4
            off[100] = -0.2
        points = places + off[:, None] * normals + [400.0, 30.0, 200.0]
        frame = np.arange(len(points)) // 100
        if shape == "plane":
            seen_from = np.array([400.0, 30.0, 200.0]) + 100 * axis
            found = fit_gauge_plane(points, frame, seen_from)
        else:
            found = fit_gauge_sphere(points, frame, 12.7)
        fit = found.shape.fit
        assert isinstance(fit, PlaneFit | SphereFit)
        cells = deviation_map(fit, found.points_mm)
        where = find_outliers(
            fit, found.points_mm, found.gate_mm, found.unfiltered.off_mm, cells.cell_mm
        )
        ends = where.deviation_um[where.is_end]
        assert np.ptp(ends) == pytest.approx(1e3 * found.unfiltered.range_mm)
        if not planted:
            assert (where.all_points, len(where.index)) == (0, 2)
            continue
        # the dust, and the one point that is too low
        assert where.all_points == where.points.sum() == int(dust.sum()) + 1
        assert where.deviation_um.max() == pytest.approx(400, abs=40)
        assert where.deviation_um.min() == pytest.approx(-200, abs=5)
        near = np.linalg.norm(found.gate_mm[where.index] - points[dust][0], axis=1)
        assert (near < 1.5).sum() == len(where.index) - 1
        # on the map they lie as far apart as on the gauge
        flat = np.hypot(where.x_mm - where.x_mm[-1], where.y_mm - where.y_mm[-1])
        apart = np.linalg.norm(found.gate_mm[where.index] - found.gate_mm[where.index[-1]], axis=1)
        assert flat == pytest.approx(apart, abs=0.5 if shape == "plane" else 0.4 * 12.7)


def test_the_map_lists_few_places_of_many_outliers_and_both_ends() -> None:
    rng = np.random.default_rng(4)
    points = np.column_stack([rng.uniform(-20, 20, (9000, 2)), rng.normal(0, 0.01, 9000)])
    points[:900, 2] += rng.uniform(0.1, 0.9, 900)
    points[7, 2] = -0.15
    fit = fit_gauge_plane(points, np.arange(9000) // 100, np.array([0.0, 0.0, 9.0])).shape.fit
    assert isinstance(fit, PlaneFit)
    where = find_outliers(fit, points, points, points[:, 2], 1.0)
    assert len(where.index) == MOST_OUTLIERS
    assert where.all_points > 800
    assert where.index[where.is_end].tolist() == [int(np.argmax(points[:, 2])), 7]
    assert (np.diff(np.abs(where.deviation_um)) <= 0).all()


def test_the_zone_holds_95_percent_and_no_more() -> None:
    off = np.concatenate([np.linspace(0, 1, 951), np.full(49, 50.0)])
    assert zone_mm(off) == pytest.approx(0.999, abs=0.002)


def outliers(share: float, size_mm: float) -> np.ndarray:
    """Every so many points, alternately outside and inside."""
    off = np.zeros(3000)
    every = round(1 / share)
    off[::every] = size_mm * np.where(np.arange(len(off[::every])) % 2, 1, -1)
    return off


def check_outliers_show(found: GaugeCloud, clean: GaugeCloud) -> None:
    """In the form of all points; from the form that is stated the filter hides them."""
    assert found.form_mm == pytest.approx(clean.form_mm, rel=0.02)
    assert found.unfiltered.dispersion_mm > 1.25 * clean.unfiltered.dispersion_mm
    assert found.unfiltered.range_mm > 0.4


def test_outliers_of_four_percent_show_in_the_form_of_all_points_of_a_sphere() -> None:
    points, frame = sphere_scan(12.7, 3000, 12000)
    clean = fit_gauge_sphere(points, frame, 12.7)
    points[:3000] += outliers(0.04, 0.2)[:, None] * unit(points[:3000])
    found = fit_gauge_sphere(points, frame, 12.7)
    check_outliers_show(found, clean)
    assert found.unfiltered.points == clean.unfiltered.points == 3000


def test_outliers_of_four_percent_show_in_the_form_of_all_points_of_a_plane() -> None:
    x, y = RNG.uniform(-20, 20, 3000), RNG.uniform(-20, 20, 3000)
    frame = RNG.integers(0, 50, 3000)
    points = np.column_stack([x, y, RNG.normal(0, 0.01, 3000)])
    clean = fit_gauge_plane(points, frame)
    points[:, 2] += outliers(0.04, 0.2)
    found = fit_gauge_plane(points, frame)
    check_outliers_show(found, clean)
    assert 2900 < found.unfiltered.points <= 3000


def test_what_lies_beside_a_gauge_is_outside_its_gate() -> None:
    ball, ball_frame = sphere_scan(12.7, 3000, 0)
    # a table on which the sphere stands, all around its foot
    x, y = RNG.uniform(-30, 30, 6000), RNG.uniform(-30, 30, 6000)
    table = np.column_stack([x, y, np.full(6000, -12.7)])
    points, frame = np.vstack([ball, table]), np.append(ball_frame, RNG.integers(0, 60, 6000))
    assert fit_gauge_sphere(points, frame, 12.7).unfiltered.points == 3000
    plate = np.column_stack([x, y, RNG.normal(0, 0.01, 6000)])
    step = np.column_stack([x + 100, y, RNG.normal(-1.0, 0.01, 6000)])[:3000]
    points, frame = np.vstack([plate, step]), RNG.integers(0, 60, 9000)
    assert 5800 < fit_gauge_plane(points, frame).unfiltered.points <= 6000


RADIUS_MM = 12.5


def touches(arm: Arm, true: Tip, count: int = 9, noise_mm: float = 0.004) -> np.ndarray:
    """Contacts of the true tip all over the upper half, the wrist turned each time."""
    rng = np.random.default_rng(3)
    real = replace(arm, tip=true)
    centre = tip_centres(arm, REST_RAD[None])[0]
    outward = on_sphere(np.linspace(1.0, 0.1, count), 2.4 * np.arange(count))
    far = RADIUS_MM + true.radius_mm + rng.normal(0, noise_mm, count)
    found = []
    for place in centre + far[:, None] * outward:
        start = REST_RAD + np.append(rng.uniform(-0.2, 0.2, 3), rng.uniform(-0.9, 0.9, 3))
        found.append(reach_tip(real, place, start))
    return np.array(found)


def test_a_sound_tip_passes(arm: Arm) -> None:
    found = check_tip(arm, touches(arm, arm.tip), 2 * RADIUS_MM, limit_um=80)
    assert (found.decision, found.cause) == ("pass", "sound")
    assert abs(found.error_um) < found.expanded_uncertainty_um + 15
    assert found.scatter_um < 20


@pytest.mark.parametrize(
    ("true", "cause"),
    [
        (Tip(0.0, 0.0, 120.0, 5.8), "small"),
        (Tip(0.0, 0.0, 120.0, 6.2), "large"),
        (Tip(0.0, 0.0, 120.0, 3.0), "other-tip"),
        (Tip(0.5, 0.0, 120.0, 6.0), "bent"),
    ],
)
def test_what_is_wrong_with_it_is_named(arm: Arm, true: Tip, cause: str) -> None:
    found = check_tip(arm, touches(arm, true), 2 * RADIUS_MM, limit_um=80)
    assert (found.decision, found.cause) == ("fail", cause)
    if cause == "bent":
        assert found.bend_um == pytest.approx(500, rel=0.2)
    else:
        assert found.diameter_mm == pytest.approx(true.diameter_mm, abs=0.03)


def test_a_touch_beside_the_sphere_is_named_and_is_no_bend(arm: Arm) -> None:
    q = touches(arm, arm.tip)
    q[4] = reach_tip(arm, tip_centres(arm, q[4][None])[0] + [0.0, 0.0, 0.6], q[4])
    found = check_tip(arm, q, 2 * RADIUS_MM, limit_um=80)
    assert (found.decision, found.cause, found.outliers) == ("fail", "outlier", (4,))
    assert abs(found.error_um) < 30


def test_without_the_wrist_turned_no_bend_is_claimed(arm: Arm) -> None:
    q = touches(arm, arm.tip)[:5]
    assert check_tip(arm, q, 2 * RADIUS_MM, limit_um=80).bend_um is None


def test_without_a_limit_nothing_is_decided(arm: Arm) -> None:
    found = check_tip(arm, touches(arm, arm.tip), 2 * RADIUS_MM)
    assert (found.decision, found.cause) == ("none", "sound")


def test_the_first_contact_on_a_sphere_misses_nothing() -> None:
    assert off_sphere_mm(np.zeros((0, 3)), np.ones(3), 12.0) == 0.0
