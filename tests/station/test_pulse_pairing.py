"""Frames and pulses, paired by their counts whatever their arrival says."""

import threading
import time
from dataclasses import replace

import numpy as np
import pytest

from crenel.station.pulses.pulse_pairing import PulsePairing
from crenel_hardware.interfaces import Frame, Line

MS = 1_000_000
PERIOD_NS = 40 * MS
EXPOSURE_US = 2000.0
IMAGE = np.zeros((2, 2), np.uint8)


class Camera:
    """Counts triggers from ``first`` on; its frames arrive late, in order, some are lost."""

    def __init__(self, first: int, seed: int, late_ms: float = 60.0, lost: float = 0.0) -> None:
        self.count = first
        self.random = np.random.default_rng(seed)
        self.late_ms, self.lost = late_ms, lost
        self.true_ns: dict[int, int] = {}

    def expose(self, pulse_ns: int) -> Frame:
        """The frame of a trigger, stamped by its arrival."""
        self.count += 1
        self.true_ns[self.count] = pulse_ns + round(500 * EXPOSURE_US)
        stamp_ns = pulse_ns + round(MS * (self.late_ms + self.random.uniform(-20, 20)))
        return Frame(self.count, stamp_ns, IMAGE, EXPOSURE_US, True, pulse=self.count)

    def deliver(self, pulse_ns: int) -> Frame | None:
        """The frame of a trigger, unless it is lost."""
        frame = self.expose(pulse_ns)
        return None if self.random.random() < self.lost else frame


def run_train(
    pairing: PulsePairing, camera: Camera, start_ns: int, count: int, lost: float = 0.0
) -> list[Frame]:
    """Starts the pulses after a pause; the paired frames, each sent after the next pulse."""
    pairing.restart()
    found: list[Frame | None] = []
    on_its_way: Frame | None = None
    random = np.random.default_rng(start_ns % 1000)
    for pulse in range(1, count + 1):
        pulse_ns = start_ns + (pulse - 1) * PERIOD_NS
        if random.random() >= lost or pulse == count:
            pairing.note_pulse(pulse, pulse_ns)
        found.append(on_its_way and pairing.pair(on_its_way))
        on_its_way = camera.deliver(pulse_ns)
    found.append(on_its_way and pairing.pair(on_its_way))
    return [one for one in found if one is not None]


def after_trains(camera: Camera, *counts: int) -> tuple[Camera, PulsePairing]:
    """A camera and its pairing after trains of so many pulses, two seconds after one another."""
    pairing = PulsePairing()
    for number, count in enumerate(counts):
        run_train(pairing, camera, (1 + 2 * number) * 10**9, count)
    return camera, pairing


def errors_ns(frames: list[Frame], camera: Camera) -> np.ndarray:
    return np.array([one.mid_exposure_ns - camera.true_ns[one.sequence] for one in frames])


@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize("late_ms", [25.0, 60.0, 120.0])
def test_frames_get_the_times_of_their_pulses(seed: int, late_ms: float) -> None:
    """Under ± 20 ms of jitter and 1 % of losses of frames and of the arm's samples."""
    camera = Camera(first=1000 + seed, seed=seed, late_ms=late_ms, lost=0.01)
    pairing = PulsePairing()
    start_ns, starts = 10**9, 0
    found: list[Frame] = []
    while not found:
        starts += 1
        assert starts < 8
        found = run_train(pairing, camera, start_ns, 400 if starts > 1 else 15, lost=0.01)
        start_ns += 30 * 10**9
        assert starts > 1 or pairing.needs_start  # the first has no frames before it
    assert len(found) > 370
    np.testing.assert_allclose(errors_ns(found, camera), 0, atol=1)


@pytest.mark.parametrize("lost_side", ["last before", "first after"])
def test_a_loss_at_the_pause_asks_for_another_start(lost_side: str) -> None:
    camera, pairing = after_trains(Camera(0, 1), 15)
    if lost_side == "last before":
        camera.expose(2 * 10**9)
    pairing.restart()
    start_ns = 3 * 10**9
    for pulse in range(1, 30):
        pairing.note_pulse(pulse, start_ns + pulse * PERIOD_NS)
        frame = camera.expose(start_ns + pulse * PERIOD_NS)
        is_lost = lost_side == "first after" and pulse == 1
        assert is_lost or pairing.pair(frame) is None
    assert pairing.needs_start
    assert not pairing.is_paired
    found = run_train(pairing, camera, 5 * 10**9, 30)
    np.testing.assert_array_equal(errors_ns(found, camera), 0)


@pytest.mark.parametrize(("held_up", "period_ns"), [(1, 160 * MS), (4, PERIOD_NS)])
def test_frames_held_up_over_the_pause_give_no_other_a_time(held_up: int, period_ns: int) -> None:
    """The last frames before the pause arrive with the first one after it."""
    camera, pairing = after_trains(Camera(0, 7), 15)
    pairing.restart()
    start_ns = 3 * 10**9
    for pulse in range(1, 40):  # pairing waits for the sample of the pulse that it supposes
        pairing.note_pulse(pulse, start_ns + (pulse - 1) * period_ns)
    arrived = [camera.expose(start_ns - 400 * MS) for _ in range(held_up)]
    arrived += [camera.expose(start_ns + at * period_ns) for at in range(20)]
    for frame in arrived:
        stamp_ns = max(frame.mid_exposure_ns, start_ns + 30 * MS)
        paired = pairing.pair(replace(frame, mid_exposure_ns=stamp_ns))
        assert paired is None or paired.sequence <= 15 + held_up  # of before the pause
        if pairing.needs_start:
            return
    raise AssertionError("the wrong pairs were never noticed")


def test_a_pause_that_a_late_frame_hides_is_not_seen_between_two_later_ones() -> None:
    """The last frame before the pause arrives shortly before the first one after it; then one
    arrives late."""
    camera, pairing = after_trains(Camera(0, 8, late_ms=20.0), 15)
    last = camera.expose(3 * 10**9 - 300 * MS)
    pairing.restart()
    pairing.pair(replace(last, mid_exposure_ns=3 * 10**9 - 120 * MS))
    for pulse in range(1, 8):
        pulse_ns = 3 * 10**9 + (pulse - 1) * PERIOD_NS
        pairing.note_pulse(pulse, pulse_ns)
        frame = camera.expose(pulse_ns)
        stamp_ns = frame.mid_exposure_ns + (220 * MS if pulse > 1 else 0)
        assert pairing.pair(replace(frame, mid_exposure_ns=stamp_ns)) is None
    assert pairing.needs_start


def test_a_frame_that_arrives_before_its_pulse_is_anothers() -> None:
    camera, pairing = after_trains(Camera(0, 9), 15, 30)
    pulse_ns = 3 * 10**9 + 30 * PERIOD_NS
    pairing.note_pulse(31, pulse_ns)
    frame = camera.expose(pulse_ns)
    assert pairing.pair(replace(frame, mid_exposure_ns=pulse_ns - 80 * MS)) is None
    assert pairing.needs_start
    assert not pairing.is_paired


def test_a_camera_that_misses_triggers_is_noticed() -> None:
    camera, pairing = after_trains(Camera(0, 2), 15, 60)
    assert pairing.is_paired
    for pulse in range(62, 120):  # pulse 61 exposed nothing, and was not counted
        pulse_ns = 3 * 10**9 + (pulse - 1) * PERIOD_NS
        pairing.note_pulse(pulse, pulse_ns)
        frame = camera.expose(pulse_ns)
        pairing.pair(frame)
        if pairing.needs_start:
            return
    raise AssertionError("the slip was never noticed")


def test_an_arm_that_counts_from_1_again_is_paired_again() -> None:
    """It was reset, and pulses on by itself: nothing is taken by the old counts."""
    _, pairing = after_trains(Camera(0, 3), 15, 30)
    assert pairing.is_paired
    pairing.note_pulse(1, 9 * 10**9)
    assert not pairing.is_paired


def test_a_frame_waits_for_its_arm_sample() -> None:
    camera, pairing = after_trains(Camera(0, 4), 15, 30)
    pulse_ns = 3 * 10**9 + 30 * PERIOD_NS
    frame = camera.expose(pulse_ns)

    def note_later() -> None:
        time.sleep(0.05)
        pairing.note_pulse(31, pulse_ns)

    later = threading.Thread(target=note_later)
    later.start()
    paired = pairing.pair(frame)
    later.join()
    assert paired is not None
    assert paired.mid_exposure_ns == camera.true_ns[paired.sequence]


def test_an_arm_that_fell_silent_pairs_nothing() -> None:
    camera, pairing = after_trains(Camera(0, 5), 15, 30)
    frame = camera.expose(3 * 10**9 + 30 * PERIOD_NS)
    assert pairing.pair(frame) is None


def test_a_delay_shifts_the_exposure() -> None:
    camera, pairing = Camera(0, 6), PulsePairing(delay_us=150.0)
    run_train(pairing, camera, 10**9, 15)
    found = run_train(pairing, camera, 3 * 10**9, 30)
    np.testing.assert_array_equal(errors_ns(found, camera), 150_000)


def test_a_camera_without_a_count_keeps_its_stamps() -> None:
    frame = Frame(1, 5, IMAGE, EXPOSURE_US, True)
    assert PulsePairing().pair(frame) is frame


def as_line(frame: Frame) -> Line:
    """A line of the same exposure."""
    at_ns, exposure_us, none = frame.mid_exposure_ns, frame.exposure_us, np.empty(0)
    laser_on, pulse = frame.laser_on, frame.pulse
    return Line(frame.sequence, at_ns, none, none, none, none, 2, 2, exposure_us, laser_on, pulse)


@pytest.mark.parametrize("missed", [0, 3])
def test_a_camera_that_missed_triggers_between_pictures_and_lines_is_paired(missed: int) -> None:
    """``missed`` triggers come during the change; the camera does not count them, it leaves one
    gap."""
    camera, pairing = Camera(first=10, seed=1), PulsePairing()
    run_train(pairing, camera, 10**9, 20)
    assert run_train(pairing, camera, 5 * 10**9, 40)
    camera.count += 1 if missed else 0
    pulse_ns = 5 * 10**9 + (40 + missed) * PERIOD_NS
    pairing.note_pulse(41 + missed, pulse_ns)
    frame = camera.expose(pulse_ns)
    paired = pairing.pair(as_line(frame))
    assert pairing.needs_start == (missed > 0)
    assert (paired is None) == (missed > 0)
    assert run_train(pairing, camera, 20 * 10**9, 40)
    assert pairing.is_paired
