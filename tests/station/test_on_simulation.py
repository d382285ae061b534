"""The devices on the simulated station: real serial driver, rendered pictures, faults, and an arm
whose encoders lie, of which nothing is made."""

import asyncio
import math
import threading
import time

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.metrology.stripe import extract_stripe
from crenel.station.bus import Bus
from crenel_hardware.interfaces import Button, ButtonEvent
from tests.refusals import refused
from tests.station.conftest import until
from tests.station.simulated import USUAL, Station, check_sphere, station

pytestmark = pytest.mark.device
__all__ = ["station"]  # a fixture
CONFIG = USUAL
LIES: dict[str, dict[str, float]] = {
    "J4": {"frozen_joint": 3},
    "J1": {"odd_rad": 6 * math.pi, "odd_every": 1, "odd_joint": 0},
    "J3": {"odd_rad": math.pi / 2, "odd_every": 211, "odd_joint": 2},
}
"""A frozen encoder, one that is three turns on, and single wrong readings; by the joint."""


def test_the_sphere_is_scanned_to_its_size(station: Station) -> None:
    result = station.scan("sphere")
    assert station.scanner.state().frames_without_joints <= 0.05 * result.frames
    check_sphere(station.simulation, result.folder / "cloud.ply")


def test_a_touch_of_the_operator_is_received_and_averaged(station: Station, bus: Bus) -> None:
    async def scenario() -> ButtonEvent:
        loop = asyncio.get_running_loop()
        bus.attach(loop)
        pressed: asyncio.Future[ButtonEvent] = loop.create_future()

        def note(event: ButtonEvent) -> None:
            if event.pressed:
                pressed.set_result(event)

        station.rig.arm.on_button = note
        assert await asyncio.to_thread(station.simulation.operator.touch, "crest", 0)
        return await asyncio.wait_for(pressed, 240)

    press = asyncio.run(scenario())
    assert press.button is Button.PRIMARY
    mean = station.rig.arm.average(0.15, until_ns=press.stamp_ns)
    assert mean.samples > 100
    assert mean.scatter.max() < 1e-4


def test_a_pair_is_captured_over_the_block_and_refused_on_the_way(station: Station) -> None:
    assert station.simulation.operator.hold_over("block")
    until(lambda: station.rig.arm.stillness().still)
    taken = station.rig.capture_pair()
    assert taken.laser is not None
    assert taken.ambient.image.shape == (CONFIG.height_px, CONFIG.width_px)
    assert len(extract_stripe(taken.laser.image).u) > CONFIG.width_px / 2
    assert taken.laser.image.mean() < taken.ambient.image.mean() / 2


def test_garbage_and_lost_packets_are_counted_and_harmless(station: Station) -> None:
    faults = station.simulation.arm_faults
    faults.corrupt_rate = faults.garbage_rate = faults.drop_rate = 0.02
    until(lambda: station.rig.arm.link().lost > 20 and station.rig.arm.link().corrupt > 20)
    assert station.rig.arm.link().state == "connected"
    until(lambda: station.rig.arm.stillness().still)
    assert station.rig.arm.average().samples > 100


def test_an_unplugged_arm_and_a_lost_camera_come_back(station: Station) -> None:
    station.simulation.arm_faults.unplugged = station.simulation.camera_faults.lost = True
    until(lambda: station.rig.arm.link().state == station.rig.sensor.link().state == "lost")
    with pytest.raises(OperationError):
        station.rig.capture_pair()
    station.simulation.arm_faults.unplugged = station.simulation.camera_faults.lost = False
    until(lambda: station.rig.arm.link().state == station.rig.sensor.link().state == "connected")
    assert station.rig.arm.info is not None


def test_an_arm_that_stalls_is_lost_and_found(station: Station) -> None:
    station.simulation.arm_faults.stalled = True
    until(lambda: station.rig.arm.link().state == "lost")
    station.simulation.arm_faults.stalled = False
    until(lambda: station.rig.arm.link().state == "connected")


def begin_lie(joint: str, station: Station) -> None:
    """Returns when the lie is reported."""
    for name, value in LIES[joint].items():
        setattr(station.simulation.arm_faults, name, value)
    until(lambda: station.rig.devices().arm.state == "lost")


@pytest.mark.parametrize("joint", LIES)
def test_nothing_is_taken_and_the_joint_is_named(joint: str, station: Station) -> None:
    until(lambda: station.rig.arm.stillness().still)
    begin_lie(joint, station)
    with refused("joint-implausible") as failed:
        station.rig.arm.average()
    assert f"joint {joint} reads" in str(failed.value.what)
    assert failed.value.remedy
    assert not station.rig.arm.stillness().still
    assert str(failed.value.what)[1:] in str(station.rig.arm.link().text)
    with pytest.raises(OperationError, match=f"joint {joint} reads"):
        station.rig.capture_pair()
    station.simulation.arm_faults.clear()
    until(lambda: station.rig.arm.stillness().still)
    assert station.rig.arm.average().samples > 100


@pytest.mark.parametrize("joint", LIES)
def test_a_scan_leaves_out_what_a_lying_encoder_says(joint: str, station: Station) -> None:
    """Every angle that the scan goes by is what the joints truly were."""
    until(lambda: station.rig.arm.stillness().still)
    station.scanner.start("lied to")
    first_ns = time.monotonic_ns()
    sweep = threading.Thread(target=station.simulation.operator.scan_part, args=("sphere",))
    sweep.start()
    until(lambda: station.rig.arm.stillness().text != message("still"))
    time.sleep(0.5)
    begin_lie(joint, station)
    findings = station.scanner.state().findings
    assert any(f"joint {joint} reads" in str(finding.text) for finding in findings)
    time.sleep(1.0)
    station.simulation.operator.cancel()
    sweep.join(240.0)
    window = station.rig.arm.window(first_ns, time.monotonic_ns())
    assert window is not None
    assert len(window) > 100
    true_rad = station.simulation.joints(window.stamps_ns)
    assert np.abs(window.readings - true_rad).max() < np.radians(1.0)
    assert station.scanner.stop() is not None
    assert any("implausible" in str(one.text) for one in station.scanner.state().findings)


def test_an_honest_arm_is_never_accused(station: Station) -> None:
    assert station.simulation.operator.scan_part("sphere")
    assert station.simulation.operator.touch("crest", 0)
    assert station.rig.arm.rejected_count == 0
    assert station.rig.arm.doubt() is None
