"""An arm whose encoders lie, in real bytes on the real line: nothing is made of what it says."""

import math
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

from app.errors import OperationError
from app.messages.message import message
from app.station.bus import Bus
from app.station.devices.rig import Rig
from app.station.scan.points import ScanCalibration
from app.station.scan.scanner import Scanner
from app.station.view3d.scene import Scene
from hardware.registry import arm_driver
from hardware.simulator.devices.arm_device import ArmFaults
from hardware.simulator.station import SimulatedStation
from tests.station.conftest import until
from tests.station.test_on_simulation import CONFIG, true_calibration

pytestmark = pytest.mark.device

Lie = Callable[[ArmFaults], None]


def frozen(faults: ArmFaults) -> None:
    faults.frozen_joint = 3


def three_turns_on(faults: ArmFaults) -> None:
    faults.odd_rad, faults.odd_every, faults.odd_joint = 6 * math.pi, 1, 0


def one_wrong_reading(faults: ArmFaults) -> None:
    faults.odd_rad, faults.odd_every, faults.odd_joint = math.pi / 2, 211, 2


LIES = {"J4": frozen, "J1": three_turns_on, "J3": one_wrong_reading}


@pytest.fixture(scope="module")
def simulation() -> Iterator[SimulatedStation]:
    with SimulatedStation(CONFIG) as simulation:
        yield simulation


@pytest.fixture
def calibration(simulation: SimulatedStation, tmp_path: Path) -> ScanCalibration:
    return true_calibration(simulation, tmp_path)


@pytest.fixture
def rig(
    simulation: SimulatedStation, bus: Bus, calibration: ScanCalibration, tmp_path: Path
) -> Iterator[Rig]:
    options = {"url": simulation.arm_url}
    rig = Rig(bus, lambda: arm_driver("serial-encoder", options), simulation.sensor, tmp_path)
    rig.arm.set_model(calibration.arm)
    rig.start()
    until(lambda: rig.arm.stillness().still and rig.sensor.fresh)
    yield rig
    simulation.arm_faults.clear()
    rig.stop()


def begin(lie: Lie, simulation: SimulatedStation, rig: Rig) -> None:
    """Returns when the lie is reported."""
    lie(simulation.arm_faults)
    until(lambda: rig.devices().arm.state == "lost")


@pytest.mark.parametrize("joint", LIES)
def test_nothing_is_taken_and_the_joint_is_named(
    joint: str, simulation: SimulatedStation, rig: Rig
) -> None:
    begin(LIES[joint], simulation, rig)
    with pytest.raises(OperationError) as refused:
        rig.arm.average()
    assert refused.value.code == "joint-implausible"
    assert f"joint {joint} reads" in str(refused.value.what)
    assert refused.value.remedy
    assert not rig.arm.stillness().still
    assert str(refused.value.what)[1:] in str(rig.arm.link().text)
    with pytest.raises(OperationError, match=f"joint {joint} reads"):
        rig.capture_pair()
    simulation.arm_faults.clear()
    until(lambda: rig.arm.stillness().still)
    assert rig.arm.average().samples > 100


@pytest.mark.parametrize("joint", LIES)
def test_a_scan_leaves_out_what_a_lying_encoder_says(
    joint: str,
    simulation: SimulatedStation,
    rig: Rig,
    calibration: ScanCalibration,
    bus: Bus,
    tmp_path: Path,
) -> None:
    """Every angle that the scan goes by is what the joints truly were."""
    scene = Scene(point_budget=10_000)
    scanner = Scanner(bus, rig, scene, tmp_path / "scans")
    scanner.set_calibration(calibration)
    try:
        until(lambda: scanner.why_not() is None)
        scanner.start("lied to")
        first_ns = time.monotonic_ns()
        sweep = threading.Thread(target=simulation.operator.scan_part, args=("sphere",))
        sweep.start()
        until(lambda: rig.arm.stillness().text != message("still"))
        time.sleep(0.5)
        begin(LIES[joint], simulation, rig)
        findings = scanner.state().findings
        assert any(f"joint {joint} reads" in str(finding.text) for finding in findings)
        time.sleep(1.0)
        simulation.operator.cancel()
        sweep.join(240.0)
        window = rig.arm.window(first_ns, time.monotonic_ns())
        assert window is not None
        assert len(window) > 100
        true_rad = simulation.joints(window.stamps_ns)
        assert np.abs(window.readings - true_rad).max() < np.radians(1.0)
        assert scanner.stop() is not None
        assert any("implausible" in str(one.text) for one in scanner.state().findings)
    finally:
        simulation.arm_faults.clear()
        scanner.close()
        scene.close()


def test_an_honest_arm_is_never_accused(simulation: SimulatedStation, rig: Rig) -> None:
    assert simulation.operator.scan_part("sphere")
    assert simulation.operator.touch("crest", 0)
    assert rig.arm.rejected_count == 0
    assert rig.arm.doubt() is None
