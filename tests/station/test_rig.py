"""The devices under one roof: lost and found again, still or moving, captured or refused."""

import asyncio
import time

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.station.bus import Bus
from crenel.station.devices.rig import Rig
from crenel.station.devices.sensor_device import LaserBelief
from crenel_hardware.clock import now_ns
from crenel_hardware.interfaces import Button, ButtonEvent
from tests.present import present
from tests.refusals import refused
from tests.station.conftest import RATE_HZ, REST_RAD, TAKEN_S, Bench, ScriptedArm, ready, until

pytestmark = pytest.mark.device


def lose_sensor(rig: Rig, bench: Bench) -> None:
    bench.sensor_plugged = False
    until(lambda: rig.sensor.link().state == "lost")


def swing(seconds: float) -> np.ndarray:
    return np.asarray(REST_RAD + 0.2 * np.sin(3 * seconds))


def test_both_devices_are_found_and_shown_with_their_rates(rig: Rig) -> None:
    until(lambda: rig.devices().arm.rate_hz == pytest.approx(500, rel=0.3))
    until(lambda: (age_s := rig.devices().arm.age_s) is not None and age_s < 0.5)
    devices = rig.devices()
    assert (devices.arm.state, devices.sensor.state) == ("connected", "connected")
    assert "A-1" in str(devices.arm.text)
    assert devices.tip_mm is not None
    assert present(devices.disk_free_gb) > 0


def test_an_unplugged_arm_is_said_lost_and_comes_back(rig: Rig, bench: Bench) -> None:
    bench.arm_plugged = False
    until(lambda: rig.arm.link().state == "lost")
    assert "bench:1" in str(rig.arm.link().text)
    assert rig.arm.latest() is None
    assert rig.sensor.link().state == "connected"
    with pytest.raises(OperationError, match="sends no joint angles"):
        rig.arm.average()
    received = rig.arm.link().received
    bench.arm_plugged = True
    ready(rig)
    assert bench.arm_opened == 2
    assert rig.arm.link().received >= received


def test_an_arm_that_goes_silent_is_lost_and_opened_again(rig: Rig, bench: Bench) -> None:
    bench.arm_silent = True
    until(lambda: rig.arm.link().state == "lost")
    assert "No data from the arm" in str(rig.arm.link().text)
    until(lambda: bench.arm_opened >= 2)
    bench.arm_silent = False
    ready(rig)


@pytest.mark.parametrize("longest_gap_s", [0.0, 3.0])
def test_a_slow_sensor_that_says_so_is_kept(rig: Rig, bench: Bench, longest_gap_s: float) -> None:
    bench.sensor_plugged = False
    until(lambda: rig.sensor.link().state == "lost" or not rig.sensor.info)
    bench.longest_gap_s, bench.frame_period_s = longest_gap_s, 1.2
    bench.sensor_plugged = True
    until(lambda: rig.sensor.fresh)
    if longest_gap_s:
        received = rig.sensor.link().received
        while (link := rig.sensor.link()).received < received + 2:
            assert link.state == "connected"
            time.sleep(0.02)
    else:
        until(lambda: rig.sensor.link().state == "lost")
        until(lambda: rig.sensor.link().state == "connected")
    lose_sensor(rig, bench)


def test_losses_and_finds_of_devices_are_events(rig: Rig, bench: Bench, bus: Bus) -> None:
    async def scenario() -> list[str]:
        bus.attach(asyncio.get_running_loop())
        kinds: list[str] = []
        with bus.subscribe() as reader:
            while "sensor-lost" not in kinds:
                bench.sensor_plugged = not rig.sensor.fresh and not bench.sensor_opened
                kinds += [e.kind for e in (await asyncio.wait_for(reader.next(), 240)).events]
            bench.sensor_plugged = True
            while kinds[-1] != "sensor-connected":
                kinds += [e.kind for e in (await asyncio.wait_for(reader.next(), 240)).events]
        bus.detach()
        return kinds

    assert asyncio.run(scenario())[-2:] == ["sensor-lost", "sensor-connected"]


def test_a_driver_that_fails_in_its_way_does_not_end_the_station(rig: Rig, bench: Bench) -> None:

    def broken(seconds: float) -> np.ndarray:
        raise ZeroDivisionError("a mistake in the driver")

    bench.joints_at = broken
    until(lambda: "a mistake in the driver" in str(rig.arm.link().text))
    bench.joints_at = lambda seconds: REST_RAD
    ready(rig)


def test_a_driver_that_fails_to_state_its_counts_is_opened_again(rig: Rig) -> None:
    first, received = rig.arm.reader.driver, rig.arm.link().received
    assert isinstance(first, ScriptedArm)
    first.health = None  # type: ignore[assignment]
    until(lambda: rig.arm.link().state == "connected" and rig.arm.reader.driver is not first)
    assert rig.arm.link().received >= received


def test_a_lost_packet_is_counted(rig: Rig, bench: Bench) -> None:
    newest = rig.arm.latest()
    assert newest is not None
    first = newest.sequence + int(2 * RATE_HZ)
    bench.arm_skips = set(range(first, first + 10))
    until(lambda: rig.arm.link().lost == 10)


def test_a_moving_arm_is_not_captured_or_averaged_a_still_one_is(rig: Rig, bench: Bench) -> None:
    bench.joints_at = swing
    until(lambda: rig.arm.stillness().moved_um > 1000)
    # the scripted arm jumps to its swing, which is noticed too
    until(lambda: not rig.arm.stillness().still and rig.arm.doubt() is None)
    with refused("arm-moving"):
        rig.arm.average()
    with refused("arm-moving") as failed:
        rig.capture_pair()
    assert "hold the arm still" in failed.value.line.lower()
    bench.joints_at = lambda seconds: REST_RAD
    ready(rig)
    mean = rig.arm.average(0.2)
    np.testing.assert_allclose(mean.reading, REST_RAD, atol=5e-6)
    np.testing.assert_allclose(mean.scatter, bench.noise_rad, rtol=0.5)
    assert mean.samples == pytest.approx(100, abs=3)


def test_an_arm_that_was_away_for_a_moment_is_not_called_still(rig: Rig, bench: Bench) -> None:
    """Nobody knows where it was meanwhile."""
    newest = rig.arm.latest()
    assert newest is not None
    bench.arm_silent = True
    until(lambda: bench.silent_reads >= 2)
    bench.arm_silent = False
    until(lambda: (now := rig.arm.latest()) and now.stamp_ns > newest.stamp_ns + 50_000_000)
    assert rig.arm.latest() is not None
    with refused("no-joints"):
        rig.arm.average(0.2, until_ns=newest.stamp_ns + 220_000_000)


def test_a_press_is_averaged_over_what_came_before_it(rig: Rig, bench: Bench) -> None:
    newest = rig.arm.latest()
    assert newest is not None
    bench.joints_at = swing
    mean = rig.arm.average(0.2, until_ns=newest.stamp_ns)
    np.testing.assert_allclose(mean.reading, REST_RAD, atol=5e-6)
    assert mean.last_ns <= newest.stamp_ns


def test_a_button_reaches_subscribers_on_the_event_loop(rig: Rig, bench: Bench, bus: Bus) -> None:
    async def scenario() -> ButtonEvent:
        loop = asyncio.get_running_loop()
        bus.attach(loop)
        pressed: asyncio.Future[ButtonEvent] = loop.create_future()
        rig.arm.on_button = pressed.set_result
        bench.presses.append(Button.UNDO)
        return await asyncio.wait_for(pressed, 240)

    ready(rig)
    event = asyncio.run(scenario())
    assert (event.button, event.pressed) == (Button.UNDO, True)


def test_the_joints_at_a_frames_stamp_are_found(rig: Rig, bench: Bench) -> None:
    bench.joints_at, bench.noise_rad = swing, 0.0
    ready_frames = rig.sensor.frames.tap(20)
    time.sleep(2 * TAKEN_S)
    swinging_since_ns = now_ns()
    checked = 0
    while checked < 10:
        (frame,) = ready_frames.get(1, 240.0)
        at_ns = frame.mid_exposure_ns
        if at_ns < swinging_since_ns:
            continue
        until(lambda at_ns=at_ns: rig.arm.at(at_ns) is not None)  # type: ignore[misc]
        q = present(rig.arm.at(at_ns))
        truth = swing(at_ns / 1e9 - bench.start_s)
        np.testing.assert_allclose(q, truth, atol=2e-6)
        checked += 1


def test_a_pair_is_captured_while_still_and_the_laser_put_back(rig: Rig, bench: Bench) -> None:
    taken = rig.capture_pair()
    assert taken.lighting == "pair"
    assert taken.laser is not None
    assert (taken.ambient.laser_on, taken.laser.laser_on) == (False, True)
    assert taken.laser.image.max() > taken.ambient.image.max() + 100
    assert not bench.laser_on
    np.testing.assert_allclose(taken.joints.reading, REST_RAD, atol=1e-5)
    rig.sensor.set_laser(True)
    rig.capture_pair()
    assert bench.laser_on


def test_a_capture_is_refused_when_the_arm_moved_meanwhile(rig: Rig, bench: Bench) -> None:
    bench.frame_period_s = 0.4
    since: list[float] = []

    def late_move(seconds: float) -> np.ndarray:
        if bench.laser_on or since:  # between the two pictures
            since.append(seconds)
        return REST_RAD + 0.01 * (seconds - since[0] if since else 0.0)

    bench.joints_at = late_move
    with refused("arm-moved"):
        rig.capture_pair()
    assert not bench.laser_on


def test_a_laser_that_does_not_obey_is_named(rig: Rig, bench: Bench) -> None:
    bench.laser_obeys = False
    with refused("laser-stuck"):
        rig.capture_pair()


def test_where_the_laser_may_be_missing_the_ambient_picture_is_kept(rig: Rig, bench: Bench) -> None:
    rig.sensor.set_laser(False)
    until(lambda: not bench.laser_on)
    bench.laser_obeys = False
    taken = rig.capture_pair(needs_laser=False)
    assert (taken.lighting, taken.laser) == ("ambient", None)
    assert not taken.ambient.laser_on
    assert taken.joints.samples > 10


def test_a_sensor_without_a_laser_switch_gives_one_picture(rig: Rig, bench: Bench) -> None:
    bench.has_laser_switch = bench.sensor_plugged = False
    until(lambda: rig.sensor.info is None)
    bench.sensor_plugged = bench.laser_on = True
    ready(rig)
    taken = rig.capture_pair()
    assert (taken.lighting, taken.laser) == ("both", None)
    assert rig.laser == LaserBelief("unknown", "no-switch")  # nor is there a camera that sees one
    with pytest.raises(OperationError, match="cannot be switched from here"):
        rig.sensor.set_laser(True)
    lose_sensor(rig, bench)
    assert rig.laser == LaserBelief("unknown", "lost")


def test_the_exposure_is_found_and_kept_over_a_reconnection(rig: Rig, bench: Bench) -> None:
    bench.scene_level, bench.exposure_us = 0.5, 2000.0
    found = rig.sensor.auto_exposure()
    assert found * bench.scene_level == pytest.approx(0.7 * 255, rel=0.12)
    lose_sensor(rig, bench)
    bench.exposure_us = 100.0
    bench.sensor_plugged = True
    until(lambda: rig.sensor.fresh and rig.sensor.exposure_us == pytest.approx(found))


def test_a_scene_too_bright_for_the_range_ends_at_its_end(rig: Rig, bench: Bench) -> None:
    bench.scene_level = 100.0
    assert rig.sensor.auto_exposure() == pytest.approx(100.0)


def test_the_laser_returns_after_a_short_loss_and_is_off_after_stop(rig: Rig, bench: Bench) -> None:
    rig.sensor.set_laser(True)
    lose_sensor(rig, bench)
    assert not bench.laser_on
    assert rig.devices().laser == LaserBelief("unknown", "lost")
    bench.sensor_plugged = True
    until(lambda: rig.sensor.fresh)
    assert bench.laser_on
    assert rig.laser == LaserBelief("on", "switch")
    rig.sensor.laser_off()
    assert not bench.laser_on
    assert rig.laser == LaserBelief("off", "switch")
    rig.sensor.set_laser(True)
    rig.stop()
    assert not bench.laser_on
    assert rig.arm.link().state == "off"


def test_a_lost_sensor_refuses_in_words(rig: Rig, bench: Bench) -> None:
    lose_sensor(rig, bench)
    for act in (rig.capture_pair, rig.sensor.auto_exposure, lambda: rig.sensor.set_laser(True)):
        with refused("sensor-lost"):
            act()
    rig.sensor.laser_off()


def test_a_triggered_sensor_is_lost_once_it_does_not_answer(rig: Rig, bench: Bench) -> None:
    bench.sensor_plugged = False
    until(lambda: not rig.sensor.info)
    bench.sensor_free_running, bench.sensor_silent, bench.sensor_plugged = False, True, True
    until(lambda: rig.sensor.fresh)
    opened, quiet_until = bench.sensor_opened, time.monotonic() + 4.0
    while time.monotonic() < quiet_until:
        assert rig.sensor.link().state == "connected"
        time.sleep(0.05)
    assert bench.sensor_opened == opened
    bench.sensor_answers = False
    until(lambda: rig.sensor.link().state == "lost")
    until(lambda: bench.sensor_opened > opened)
