"""The delay between arm and camera, from simulated passes over planes and other things."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from crenel.errors import OperationError
from crenel.metrology.arm.reading_interpolation import interpolate_readings
from crenel.metrology.time_delay.course import DelayCourse
from crenel.metrology.time_delay.delay import estimate_delay
from crenel.metrology.time_delay.plane_pass import PlanePass, fit_stripe_lines
from crenel.metrology.transforms import Floats
from tests.bench.clocks.delays import count_named_jumps, plan_pass
from tests.bench.clocks.passes import simulate_pass
from tests.metrology.numerics import unit
from tests.metrology.refusals import refusal_of
from tests.running.usual import usual
from tests.uncertainty_ratio import ratio_of_pulls

pytestmark = pytest.mark.slow

Path = Callable[[Floats], Floats]
AT_NS = 10**12
NORMAL = unit([0.02, -0.03, 1.0])


def up_and_down(t: Floats) -> Floats:
    """(T, 6) x, y, z (mm) and turns (rad) of a manual pass over a plate in waves."""
    waves = 8 * np.sin(5 * t) + 0.5 * np.sin(11 * t)
    turns = (0.05 * np.sin(3 * t), 0.03 * np.sin(2 * t + 1), 0.02 * np.cos(1.3 * t))
    return np.column_stack([0 * t, 15 * np.sin(1.3 * t), waves, *turns])


@dataclass(frozen=True)
class Setting:
    """A pass by its settings; the sensor looks down its z at z = -100 mm."""

    path: Path = up_and_down
    delay_ms: float = 4.0
    seconds: float = 5.0
    frames_hz: float = 25.0
    point_sd_mm: float = 0.01
    frame_sd_mm: float = 0.01
    bent_mm: float = 0.0
    """Of what the calibration does wrong over the height."""
    shape: str = "plane"
    drift_ppm: float = 0.0
    jump_ms: float = 0.0
    """Of the arm's clock, in the middle of the pass."""
    late_ms: float = 0.0
    """Mean of the random lateness of the arm's packets, which arrive in order."""
    wander_ms: float = 0.0
    """Amplitude of a lateness that wanders within seconds."""


def poses(q: Floats) -> Floats:
    T = np.tile(np.eye(4), (len(q), 1, 1))
    T[:, :3, :3] = Rotation.from_euler("xyz", np.nan_to_num(q[:, 3:])).as_matrix()
    T[:, :3, 3] = q[:, :3]
    T[~np.isfinite(q).all(axis=1)] = np.nan
    return T


def passed(setting: Setting, seed: int = 0) -> PlanePass:
    rng = np.random.default_rng(seed)
    taken_s = np.arange(0.05, setting.seconds, 1 / setting.frames_hz) + rng.uniform(0, 1e-3)
    read_s = np.arange(-0.4, setting.seconds + 0.4, 1e-3)
    across = np.linspace(-12.0, 12.0, 120)
    points = []
    for T in poses(setting.path(taken_s)):
        normal = T[:3, :3].T @ NORMAL
        down = (-100.0 - NORMAL @ T[:3, 3] - normal[0] * across) / normal[2]
        if setting.shape == "sphere":
            down = down - (across + T[0, 3]) ** 2 / 40 - T[1, 3] ** 2 / 40
        if setting.shape == "plate on a table":
            down = np.where(across > 5, down - 12.0, down)
        points.append(np.column_stack([across, 0 * across, down]))
    in_sensor = np.concatenate(points)
    height = in_sensor[:, 2] + 100
    in_sensor[:, 2] += setting.bent_mm * np.sin(height / 4 + 1)
    in_sensor[:, 2] += setting.point_sd_mm * rng.normal(size=len(in_sensor))
    q = setting.path(read_s)
    q[:, :3] += setting.frame_sd_mm * rng.normal(size=(len(q), 3))
    delays_ms = setting.delay_ms + 1e-3 * setting.drift_ppm * read_s
    delays_ms = delays_ms + setting.jump_ms * (read_s > setting.seconds / 2)
    delays_ms = delays_ms + setting.wander_ms * np.sin(read_s)
    if setting.late_ms:
        sent_ms = 1e3 * read_s + rng.exponential(setting.late_ms, len(read_s))
        delays_ms = delays_ms + np.maximum.accumulate(sent_ms) - 1e3 * read_s
    stamps_ns = AT_NS + np.round(1e9 * read_s + 1e6 * delays_ms).astype(np.int64)
    order = np.argsort(stamps_ns)
    stamps_ns, q = stamps_ns[order], q[order]
    return PlanePass(
        AT_NS + np.round(1e9 * taken_s).astype(np.int64),
        np.arange(len(taken_s) + 1) * len(across),
        in_sensor,
        np.full(len(in_sensor), setting.point_sd_mm),
        lambda at_ns: poses(interpolate_readings("joints", stamps_ns, q, at_ns, 25_000_000)),
    )


@pytest.mark.parametrize("delay_ms", [0.0, 4.0])
def test_the_delay_is_found_whatever_it_is(delay_ms: float) -> None:
    found = estimate_delay(passed(Setting(delay_ms=delay_ms)))
    assert found.standard_uncertainty_ms < 0.05
    assert abs(found.delay_ms - delay_ms) < 4 * found.standard_uncertainty_ms
    assert found.rms_um < 13.0
    assert found.rms_without_um is not None
    assert (found.rms_without_um > 100.0) == (delay_ms != 0.0)
    assert found.reversals == pytest.approx(7, abs=1)


@pytest.mark.parametrize(
    "setting",
    usual(
        [
            Setting(delay_ms=-4800.0, seconds=12.0),
            Setting(delay_ms=3100.0, seconds=9.0, shape="plate on a table"),
            Setting(delay_ms=10.0, seconds=12.0, jump_ms=50.0),
            Setting(delay_ms=10.0, seconds=12.0, jump_ms=-2.0),
            Setting(delay_ms=-300.0, seconds=12.0, jump_ms=-900.0),
            Setting(seconds=60.0, drift_ppm=-25.0),
            Setting(seconds=60.0, drift_ppm=75.0, jump_ms=7.0),
        ],
        {0, 4, 6},
        pytest.mark.soak,
    ),
)
def test_jumps_and_drift_are_found_at_any_delay(setting: Setting) -> None:
    plane = passed(setting)
    found = estimate_delay(plane)
    last_s = (found.course.stamp_ns - AT_NS) / 1e9
    drift_ms = 1e-3 * setting.drift_ppm * last_s
    true_ms = setting.delay_ms + drift_ms + setting.jump_ms
    assert abs(found.delay_ms - true_ms) < 4 * found.standard_uncertainty_ms < 0.4
    off_ppm = abs(found.course.drift_ppm - setting.drift_ppm)
    assert off_ppm <= (4 * found.drift_uncertainty_ppm if setting.drift_ppm else 0)
    assert len(found.jumps) == (setting.jump_ms != 0)
    for one in found.jumps:
        off_ms = abs(one.jump.change_ns / 1e6 - setting.jump_ms)
        assert off_ms < 4 * one.change_uncertainty_ms < 0.4
        off_s = abs((one.jump.stamp_ns - AT_NS) / 1e9 - setting.seconds / 2)
        assert off_s < 4 * one.time_uncertainty_s
    # a clock that was set back gives its stamps twice: those frames are named, and no others
    twice_s = max(-setting.jump_ms, 0) / 1e3
    assert found.frames_off <= 2 * twice_s * setting.frames_hz
    clear = found.course.is_clear(plane.stamps_ns)
    assert (not clear.all()) == (twice_s > 0.1)
    counted = found.frames + found.frames_off + found.frames_unplaced
    assert counted == len(plane.stamps_ns)


def two_waves(t: Floats) -> Floats:
    """(T, 6) a pass in no regular rhythm."""
    path = up_and_down(t)
    path[:, 2] += 5 * np.sin(3.1 * t)
    return path


def test_a_delay_that_varies_widens_the_uncertainty_and_is_no_drift_or_jump() -> None:
    setting = Setting(path=two_waves, seconds=30.0, frames_hz=15.0)
    assert estimate_delay(passed(setting)).unsteadiness_ms == 0.0
    found = estimate_delay(passed(replace(setting, wander_ms=0.6)))
    last_s = (found.course.stamp_ns - AT_NS) / 1e9
    true_ms = setting.delay_ms + 0.6 * np.sin(last_s)
    assert abs(found.delay_ms - true_ms) <= 3 * found.standard_uncertainty_ms < 2.0
    assert found.unsteadiness_ms > 0.2
    assert (found.course.drift_ppm, found.jumps) == (0.0, ())


@pytest.mark.parametrize("late_ms", [4.0, 20.0])
def test_packets_that_are_late_by_different_times_are_refused_as_such(late_ms: float) -> None:
    setting = Setting(path=two_waves, seconds=30.0, frames_hz=15.0, late_ms=late_ms)
    refusal = refusal_of(estimate_delay, passed(setting))
    assert refusal.code == "arm-times-vary"


def test_a_clock_set_far_back_soon_after_the_first_frames_is_named() -> None:
    plan = plan_pass("jump", 75)
    found = estimate_delay(simulate_pass(plan))
    assert count_named_jumps(plan, found) == len(plan.jumps) == 2
    assert found.frames_off < 40


def at_rest(t: Floats) -> Floats:
    return np.zeros((len(t), 6))


def test_an_arm_at_rest_under_a_moving_line_is_no_sensor_at_rest() -> None:
    held = replace(
        passed(Setting()), poses_at=lambda at_ns: poses(at_rest(at_ns.astype(np.float64)))
    )
    refusal = refusal_of(estimate_delay, held)
    assert refusal.code == "arm-at-rest"


def test_a_drifting_delay_holds_only_near_its_pass() -> None:
    course = DelayCourse(1e6, AT_NS, 50.0, (), 1e3, 0.5)
    course.check_age(np.array([AT_NS + 1800 * 10**9]))
    with pytest.raises(
        OperationError, match=r"drifts by \+50\.0 ppm.* 67 min away.*known to 2\.0 ms"
    ):
        course.check_age(np.array([AT_NS, AT_NS + 4000 * 10**9]))


def test_points_that_share_their_noise_tell_less_of_a_frames_line() -> None:
    plane = passed(Setting())
    everything = np.ones(len(plane.points_mm), dtype=np.bool_)
    independent = fit_stripe_lines(plane, everything).variance
    shared = fit_stripe_lines(replace(plane, number_sharing_noise=7.0), everything).variance
    np.testing.assert_allclose(shared, 7 * independent)


def test_the_stated_uncertainty_is_the_scatter() -> None:
    errors = []
    for seed in range(20):
        found = estimate_delay(passed(Setting(delay_ms=0.0, frames_hz=10.0), seed))
        errors.append(found.delay_ms / found.standard_uncertainty_ms)
    # twenty passes know the ratio to 16 %, and each takes 0.3 s
    ratio_of_pulls(np.array(errors)).assert_within(k=1.25)
    assert abs(np.mean(errors)) < 0.5


def test_errors_of_the_calibration_do_not_pass_for_a_delay() -> None:
    found = estimate_delay(passed(Setting(bent_mm=0.05)))
    assert abs(found.delay_ms - 4.0) < 2 * found.standard_uncertainty_ms
    assert abs(found.delay_ms - 4.0) < 0.2


def test_another_surface_in_the_picture_has_no_part_in_it() -> None:
    found = estimate_delay(passed(Setting(shape="plate on a table")))
    assert abs(found.delay_ms - 4.0) < 4 * found.standard_uncertainty_ms


def test_a_few_frames_far_off_do_no_harm() -> None:
    whole = passed(Setting())
    spoilt = whole.points_mm.copy()
    for frame in (20, 50, 90):
        spoilt[whole.first[frame] : whole.first[frame + 1], 2] += 0.4
    found = estimate_delay(replace(whole, points_mm=spoilt))
    assert abs(found.delay_ms - 4.0) < 4 * found.standard_uncertainty_ms


def moved(across: Path, along_mm: float = 30.0) -> Path:
    def path(t: Floats) -> Floats:
        flat = np.column_stack([0 * t, along_mm * np.sin(1.3 * t), 0 * t])
        flat[:, 2] = 0.03 * flat[:, 1] + across(t)  # along the plane, as it leans
        return np.column_stack([flat, np.zeros((len(t), 3))])

    return path


@pytest.mark.parametrize(
    ("setting", "code"),
    [
        (Setting(path=at_rest), "sensor-at-rest"),
        (Setting(path=moved(lambda t: 5 * t)), "pass-without-reversal"),
        (Setting(path=moved(lambda t: 0 * t)), "pass-along-the-plane"),
        (Setting(path=moved(lambda t: 0.1 * np.sin(2 * t), 1.0)), "pass-too-slow"),
        # up and down over one line: the plane through it could stand any way
        (Setting(path=moved(lambda t: 8 * np.sin(5 * t), 0.0)), "pass-along-the-plane"),
        (Setting(path=moved(lambda t: 2 * np.sin(5 * t)), frame_sd_mm=0.2), "pass-not-informative"),
        (Setting(shape="sphere"), "not-a-plane"),
        (Setting(seconds=0.9), "pass-too-short"),
    ],
)
def test_a_pass_that_does_not_show_the_delay_is_refused(setting: Setting, code: str) -> None:
    refusal = refusal_of(estimate_delay, passed(setting))
    assert refusal.code == code
    assert refusal.why
    assert refusal.remedy


def test_without_the_arm_around_the_frames_it_is_refused() -> None:
    lost = replace(passed(Setting()), poses_at=lambda at_ns: np.full((len(at_ns), 4, 4), np.nan))
    with pytest.raises(OperationError, match="the arm's position is unknown"):
        estimate_delay(lost)
