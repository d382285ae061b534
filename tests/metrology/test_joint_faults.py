"""Which faults of encoders are found at which rates, and that honest motion is not accused."""

from itertools import pairwise

import numpy as np
import pytest

from crenel.metrology.arm.joint_plausibility import PlausibilityFilter
from tests.metrology.joint_motions import ARM, Motion, Sample, judged, read, samples, sweep
from tests.present import present
from tests.running.usual import usual

pytestmark = pytest.mark.slow

RATES = (50.0, 100.0, 250.0, 500.0, 1000.0)
SLIPS = {50.0: (90,), 100.0: (10, 90), 250.0: (10, 90), 500.0: (2, 10, 90), 1000.0: (2, 10, 90)}
"""In degrees; a knock may do what is smaller."""
FAST = (1, 5, 14, 90)
SPIKES = {50.0: FAST[2:], 100.0: FAST[1:], 250.0: FAST, 500.0: FAST, 1000.0: (0.5, *FAST)}
OF_RATES = pytest.mark.parametrize("rate_hz", usual(RATES, {1, 3}, pytest.mark.soak))
OF_ENCODERS = pytest.mark.parametrize("bits", usual((14, 18, 22), {0}, pytest.mark.soak))


@OF_ENCODERS
@OF_RATES
def test_single_wrong_readings_are_left_out_and_nothing_else(rate_hz: float, bits: int) -> None:
    for degrees in SPIKES[rate_hz]:
        q = sweep(rate_hz)
        wrong = np.arange(len(q)) % 41 == 20
        q[wrong, 2] += np.radians(degrees)
        found = judged(samples(read(q, bits), rate_hz), rate_hz)
        np.testing.assert_array_equal(found.passed[:-3], ~wrong[:-3])
        assert present(found.judge.first).joint == "J3"


@OF_ENCODERS
@OF_RATES
def test_a_slipped_encoder_is_refused_until_the_arm_reconnects(rate_hz: float, bits: int) -> None:
    for degrees in SLIPS[rate_hz]:
        q = sweep(rate_hz, 6.0)
        slips, again = int(2.2 * rate_hz), int(4.5 * rate_hz)
        q[slips:, 2] += np.radians(degrees)
        readings = samples(read(q, bits), rate_hz)
        judge: PlausibilityFilter[Sample] = PlausibilityFilter(6, rate_hz, ARM)
        good = judge.filter(readings[:again])
        assert len(good) == slips
        assert judge.newest is not None
        said = f"joint J3 jumped by {degrees:.1f}° and stayed there"
        assert str(judge.newest.error.what) == said
        assert "reference position and switch the arm off and on" in str(judge.newest.error.remedy)
        judge.forget_place()
        assert len(judge.filter(readings[again:])) + len(judge.flush()) == len(q) - again


@OF_ENCODERS
@OF_RATES
def test_an_encoder_that_jumps_back_is_believed_at_once(rate_hz: float, bits: int) -> None:
    for lasts_s in (0.08, 1.0):
        q = sweep(rate_hz)
        slips, back = int(2.2 * rate_hz), int((2.2 + lasts_s) * rate_hz)
        q[slips:back, 2] += np.radians(-60)
        found = judged(samples(read(q, bits), rate_hz), rate_hz)
        np.testing.assert_array_equal(np.flatnonzero(~found.passed), np.arange(slips, back))


def test_what_slipped_stays_refused_over_a_gap_and_beside_other_faults() -> None:
    q = sweep(1000.0, 5.0)
    q[2200:, 2] += np.radians(10)
    q[3000, 2] += 1.0
    q[3100:3150, 4] -= 1.0
    readings = samples(read(q), 1000.0)
    found = judged([*readings[:3500], *readings[3800:]])
    np.testing.assert_array_equal(np.flatnonzero(found.passed), np.arange(2200))
    assert "J3 jumped by 10.0°" in present(found.judge.newest).error.line


def test_a_wrong_first_reading_is_not_what_the_others_are_held_against() -> None:
    q = sweep(1000.0)
    q[0, 2] += 1.0
    found = judged(samples(read(q), 1000.0))
    assert found.passed[600:].all()


@OF_RATES
def test_a_fine_encoder_frozen_from_the_start_is_found(rate_hz: float) -> None:
    """By the noise of the others, at rest as in motion."""
    for rest_s in (0.0, 1.5):
        q = read(sweep(rate_hz, rest_s=rest_s))
        q[:, 3] = q[0, 3]
        found = judged(samples(q, rate_hz), rate_hz)
        assert found.judge.newest is not None
        assert (found.judge.newest.kind, found.judge.newest.joint) == ("frozen", "J4")
        assert not found.passed[max(60, int(1.2 * rate_hz)) :].any() or rate_hz < 100


@pytest.mark.parametrize(
    ("rate_hz", "bits"),
    usual(
        [(rate, 22) for rate in RATES] + [(rate, bits) for rate in RATES[3:] for bits in (14, 18)],
        {1, 5},
        pytest.mark.soak,
    ),
)
def test_an_encoder_frozen_in_a_sweep_is_found_within_a_second(rate_hz: float, bits: int) -> None:
    q, freezes = read(sweep(rate_hz, 5.0, 3.0), bits), int(3.2 * rate_hz)
    q[freezes:, 3] = q[freezes, 3]
    readings = samples(q, rate_hz)
    found = judged(readings, rate_hz)
    np.testing.assert_array_equal(np.flatnonzero(found.passed), np.arange(freezes + 1))
    assert judged(readings[: freezes + int(rate_hz)], rate_hz).judge.frozen > 0


def test_an_encoder_that_reads_on_after_it_was_frozen_is_believed() -> None:
    for lasts in (5, 30, 60, 700):
        q = read(sweep(1000.0))
        q[1700 : 1700 + lasts, 4] = q[1700, 4]
        found = judged(samples(q, 1000.0))
        assert found.passed[1700 + lasts :].all(), lasts


def honest(motion: Motion, rate_hz: float, bits: int, seed: int) -> None:
    """Nothing is lost of a motion, however its readings come."""
    rng = np.random.default_rng(seed)
    taken_s = (np.arange(int(2.9 * rate_hz), dtype=np.float64) + 0.6) / rate_hz
    jitter_s = rng.uniform(-0.5, 0.5, len(taken_s)) / rate_hz
    whole = np.ones(len(taken_s), dtype=bool)
    gaps = rng.random(len(taken_s)) > 0.02
    for at_s in rng.uniform(0.2, 2.6, 4):
        gaps &= ~((taken_s > at_s) & (taken_s < at_s + 0.05))
    uneven_s = taken_s + 0.25 * jitter_s
    for name, at_s, stamps_s, there, noise_rad in (
        ("even", taken_s, taken_s, whole, 1e-5),
        ("stamps half a period off", taken_s, taken_s + jitter_s, whole, 1e-5),
        ("gaps and losses", taken_s, taken_s, gaps, 1e-5),
        ("taken unevenly", uneven_s, uneven_s, whole, 1e-5),
        ("without noise", taken_s, taken_s, whole, 0.0),
    ):
        q = np.clip(read(motion.at(at_s), bits, noise_rad, seed), -3.0, 3.0)
        found = judged(samples(q[there], rate_hz, stamps_s[there]), rate_hz)
        assert found.judge.newest is None, (name, rate_hz, bits, found.judge.newest)
        assert found.passed.all()


@OF_ENCODERS
@OF_RATES
@pytest.mark.parametrize("kind", ["smooth", "tremor", "hard stops", "touches", "knocks"])
def test_honest_motion_loses_nothing(kind: str, rate_hz: float, bits: int) -> None:
    for seed in range(2):
        motion = Motion(100 * bits + seed)
        if kind == "tremor":
            motion.tremble()
        elif kind == "hard stops":
            motion.stop()
        elif kind == "touches":
            motion.stop(bounces=True)
        elif kind == "knocks":
            motion.knock()
        honest(motion, rate_hz, bits, seed)


@pytest.mark.parametrize("bits", usual([14, 17, 18, 19, 20, 22], {2}, pytest.mark.soak))
def test_an_arm_that_creeps_and_stands_is_not_frozen(bits: int) -> None:
    """Nor one whose encoders show their noise between two steps only, or have none."""
    rng = np.random.default_rng(bits)
    for noise_rad in (0.0, 3e-6, 1e-5):
        places = rng.uniform(-1e-4, 1e-4, (8, 6)).cumsum(axis=0)
        creeping = [np.linspace(a, b, 400) for a, b in pairwise(places)]
        standing = [np.repeat(b[None], 1200, axis=0) for b in places[1:]]
        q = np.concatenate([part for pair in zip(creeping, standing, strict=True) for part in pair])
        found = judged(samples(read(q, bits, noise_rad), 1000.0))
        assert found.judge.newest is None, noise_rad


@OF_ENCODERS
def test_joints_that_stand_while_others_move_are_not_frozen(bits: int) -> None:
    q = sweep(1000.0)
    q[:, [1, 4]] = 0.2
    for noise_rad in (0.0, 1e-5):
        assert judged(samples(read(q, bits, noise_rad), 1000.0)).judge.newest is None


def test_a_coarser_encoder_among_fine_ones_may_stand() -> None:
    q = sweep(1000.0)
    q[:, 3] = 0.2
    fine, coarse = read(q), read(q, 14)
    fine[:, 3] = coarse[:, 3]
    fine[1990:1994, 3] += 2 * np.pi / 2**14
    found = judged(samples(fine, 1000.0))
    assert found.passed[2000:].all()
