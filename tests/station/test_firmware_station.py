"""The station on the arm's firmware, run by simavr: touches, and a camera that it triggers."""

from collections.abc import Iterator
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from crenel.guide.calibration.touch.block import suggest_places
from crenel.metrology.arm.kinematics import tip_centres
from crenel.metrology.arm.reading_interpolation import shortest_turn
from crenel.metrology.probing.alignment import align
from crenel.station.bus import Bus
from crenel.station.devices.rig import Rig
from crenel.station.pulses.pulse_trigger import TriggerSettings
from crenel_hardware.clock import now_ns
from crenel_hardware.registry import arm_driver
from crenel_hardware.simulator.station import SimulatedStation, SimulationConfig
from tests.guide.builders import contact_joints
from tests.hardware.firmware.board import Board, build_board, build_firmware, missing_tool
from tests.station.conftest import collect_readings, running, six_axis_arm, until, until_paired
from tests.station.test_scene import BLOCK

pytestmark = [
    pytest.mark.device,
    pytest.mark.skipif(missing_tool() is not None, reason=f"{missing_tool()} is not installed"),
]

PER_TURN = 1 << 14
FACES = ("crest", "front", "left")
RATE_HZ = 6.0
SWING_MS = 300
"""As a hand does: a jump would be an encoder's fault to the station."""


@pytest.fixture
def board(tmp_path: Path) -> Iterator[Board]:
    firmware = build_firmware(tmp_path, NAME="Built arm", SERIAL_NUMBER="A-1")
    made = Board(build_board(tmp_path), firmware, tmp_path / "ttyARM")
    yield made
    made.power_off()


def options(board: Board) -> dict[str, object]:
    return {"url": board.url, "baudrate": 500_000, "timeout_s": 20.0}


def test_a_calibrations_touches_are_taken_through_it(board: Board, tmp_path: Path) -> None:
    """Nine on each of three faces; each is read to the step of the encoders."""
    arm = six_axis_arm()
    config = SimulationConfig(width_px=320, height_px=256)
    driver = partial(arm_driver, "bridge", options(board))
    with (
        SimulatedStation(config) as simulation,
        running(Rig(Bus(), driver, simulation.sensor, tmp_path)) as rig,
    ):
        rig.arm.set_model(arm)
        until(lambda: rig.arm.fresh)
        board.tell("glide", SWING_MS)
        readings, faces = [], []
        for face in FACES:
            for place in suggest_places(BLOCK, face):
                q = contact_joints(arm, BLOCK, face, place)
                counts = np.rint(q * PER_TURN / (2 * np.pi)).astype(int)
                board.turn(counts.tolist())
                expected = counts * 2 * np.pi / PER_TURN
                until(partial(is_at, rig, expected))
                mean = rig.arm.average()
                assert np.abs(shortest_turn(mean.reading - expected)).max() < 1e-9
                readings.append(mean.reading)
                faces.append(face)
    tips = tip_centres(arm, np.array(readings))
    found = align(faces, tips, arm.tip.radius_mm, BLOCK)
    # 14 bits are 0.38 mrad: a tenth of a millimetre at half a metre
    assert np.sqrt(np.mean(found.residuals_mm**2)) < 0.25


def is_at(rig: Rig, expected: np.ndarray) -> bool:
    """Whether the arm is there, and still."""
    newest = rig.arm.latest()
    if newest is None or not rig.arm.stillness().still:
        return False
    return bool(np.abs(shortest_turn(np.array(newest.reading) - expected)).max() < 1e-9)


@pytest.mark.soak  # pictures of a listener that is held up for longer than a pulse are others'
def test_its_pulses_pair_arm_and_camera(board: Board, tmp_path: Path) -> None:
    """The first encoder turns on after each pulse, so that its angle numbers the pulses; frames
    arrive with ± 20 ms of jitter, and 1 % of them are lost."""
    config = SimulationConfig(triggered=True, jitter_ms=20.0, width_px=320, height_px=256)
    with SimulatedStation(config) as simulation:
        simulation.camera_faults.drop_rate = 0.01
        sensor = simulation.sensor()
        arm = partial(arm_driver, "bridge", options(board))
        rig = Rig(Bus(), arm, lambda: sensor, tmp_path, TriggerSettings(RATE_HZ))
        board.tell("step", 20)
        board.on_pulse = lambda number: simulation.trigger_camera(now_ns())
        with running(rig):
            until_paired(rig.sensor)
            frames = collect_readings(rig, 24)
    offsets = []
    for frame in frames:
        at = rig.arm.at(frame.mid_exposure_ns - round(500 * frame.exposure_us), 0.0)
        assert at is not None
        steps = at[0] * PER_TURN / (2 * np.pi) / 20
        if abs(steps - round(steps)) < 0.01:  # else the sample was lost on its way: those beside it
            offsets.append(frame.sequence - round(steps))
    assert len(offsets) >= 16
    # the camera's own count and the angle at the pulse go together, without one exception
    assert len(set(offsets)) == 1
