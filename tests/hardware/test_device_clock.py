"""Device time brought to the host's clock, against arrivals whose truth is known."""

import numpy as np
import pytest
from numpy.typing import NDArray

from crenel_hardware.device_clock import DeviceClock

Times = NDArray[np.int64]
MS, S = 1_000_000, 1_000_000_000
LEAST_DELAY_NS = 100_000


def arrivals(taken_ns: Times, rng: np.random.Generator, busy_share: float = 0.0) -> Times:
    """In order, late by 0.1 ms and a little; in busy spells of 0.2 s all come at the end."""
    delay = LEAST_DELAY_NS + rng.exponential(60_000, taken_ns.size).astype(np.int64)
    arrival = taken_ns + delay
    spell = taken_ns // (200 * MS)
    busy = rng.random(int(spell.max()) + 1) < busy_share
    arrival = np.where(busy[spell], (spell + 1) * 200 * MS + delay, arrival)
    return np.maximum.accumulate(arrival)


def run(clock: DeviceClock, device_ns: Times, arrival_ns: Times) -> Times:
    stamps = []
    for device, arrival in zip(device_ns.tolist(), arrival_ns.tolist(), strict=True):
        clock.observe(device, arrival)
        stamps.append(clock.stamp(device))
    return np.array(stamps)


def late_us(stamps: Times, taken_ns: Times) -> NDArray[np.float64]:
    """How far stamps lie behind truth, the constant least delay aside."""
    return (stamps - taken_ns - LEAST_DELAY_NS) / 1000


def sampled(seconds: float, start_s: float = 1000.0, rate_hz: float = 200.0) -> Times:
    return (start_s * S + np.arange(int(seconds * rate_hz)) * (S / rate_hz)).astype(np.int64)


@pytest.mark.parametrize("drift", [0.0, 80e-6, -80e-6, 4e-3, -4e-3])
@pytest.mark.parametrize("busy_share", [0.0, 0.7])
def test_stamps_follow_truth_under_drift_and_load(drift: float, busy_share: float) -> None:
    taken = sampled(60)
    device = ((taken - taken[0]) * (1 + drift)).astype(np.int64) + 7 * S
    stamps = run(DeviceClock(), device, arrivals(taken, np.random.default_rng(3), busy_share))
    late = late_us(stamps, taken)
    settled = taken - taken[0] > 12 * S
    assert np.all(np.diff(stamps) > 0)
    assert np.abs(late[settled]).max() < 40


def test_a_crystal_is_good_from_the_first_second() -> None:
    taken = sampled(6)
    device = ((taken - taken[0]) * (1 + 50e-6)).astype(np.int64)
    stamps = run(DeviceClock(), device, arrivals(taken, np.random.default_rng(3)))
    assert np.abs(late_us(stamps, taken)[50:]).max() < 100


def test_a_late_first_packet_is_made_good_without_a_step_back() -> None:
    taken = sampled(3)
    arrival = arrivals(taken, np.random.default_rng(3))
    arrival[0] += 200 * MS
    arrival = np.maximum(arrival, arrival[0])
    arrival[1:] = np.maximum.accumulate(arrivals(taken, np.random.default_rng(4)))[1:]
    stamps = run(DeviceClock(), taken, arrival)
    assert np.all(np.diff(stamps) > 0)
    late = late_us(stamps, taken)
    assert late[0] > 190_000
    assert np.abs(late[taken - taken[0] > S]).max() < 100


def test_a_machine_that_is_held_up_soon_after_the_start_moves_no_stamps_far() -> None:
    taken = sampled(5)
    arrival = arrivals(taken, np.random.default_rng(3))
    since_s = (taken - taken[0]) / S
    arrival[(since_s > 1.5) & (since_s < 3.2)] += 600 * MS
    stamps = run(DeviceClock(), taken, np.maximum.accumulate(arrival))
    assert np.abs(late_us(stamps, taken)).max() < 50_000
    assert np.abs(late_us(stamps, taken)[since_s > 4.6]).max() < 100


def test_steady_sampling_stays_steady() -> None:
    taken = sampled(30)
    stamps = run(DeviceClock(), taken, arrivals(taken, np.random.default_rng(5), 0.5))
    steps_us = np.diff(stamps[2000:]) / 1000
    assert np.abs(steps_us - 5000).max() < 40


def test_a_restart_maps_again_and_still_increases() -> None:
    clock = DeviceClock()
    rng = np.random.default_rng(6)
    before, after = sampled(8, 1000), sampled(8, 1010)
    first = run(clock, before, arrivals(before, rng))
    clock.restart()
    second = run(clock, after - after[0], arrivals(after, rng))
    assert second[0] > first[-1]
    assert np.abs(late_us(second, after)[50:]).max() < 100


def test_a_clock_that_stood_still_is_followed_after_two_seconds() -> None:
    taken = sampled(30)
    stood = np.where(taken - taken[0] > 10 * S, 700 * MS, 0)
    stamps = run(DeviceClock(), taken - stood, arrivals(taken, np.random.default_rng(7)))
    late = late_us(stamps, taken)
    assert np.abs(late[taken - taken[0] > 14 * S]).max() < 100


def test_a_host_that_slept_gives_no_stamps_in_the_future() -> None:
    """The host's monotonic clock stands while it sleeps; the device's goes on."""
    taken = sampled(20)
    device = taken + np.where(taken - taken[0] > 10 * S, 3600 * S, 0)
    stamps = run(DeviceClock(), device, arrivals(taken, np.random.default_rng(8)))
    assert np.all(np.diff(stamps) > 0)
    assert np.abs(late_us(stamps, taken)[50:]).max() < 200


def test_samples_of_one_burst_get_their_own_times() -> None:
    clock = DeviceClock()
    taken = sampled(10)
    run(clock, taken, arrivals(taken, np.random.default_rng(9)))
    burst = sampled(2, 1010)
    stamps = run(clock, burst, np.full(burst.size, burst[-1] + MS))
    np.testing.assert_allclose(np.diff(stamps), 5 * MS, atol=100)
    assert np.abs(late_us(stamps, burst)).max() < 100
