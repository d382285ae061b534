"""Blocks designed for random sensors: simulated calibrations beside what the design stated.

    python -m tests.bench.design_block [--sensors 20] [--sessions 2] [--first 300] [--json]

Every sensor (30 to 400 mm stand-off, 0.3 to 12 megapixels) and arm is drawn by the simulator. The
block is designed from the sensor's numbers and the arm's file alone. Sessions of eight poses are
then rendered, in which sensor, arm and block are off their files, and calibrated from the pictures:
with the first pose, and with all. A row has the accuracy stated and the rms error over the
sensor's measuring range in all sessions (flange frame, µm), the ratio of both, and that of the
uncertainty that the calibrations claim to the one stated.
"""

import json
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from app.errors import OperationError
from app.formats.datasheets.arm import read_arm
from app.formats.session.calibration_session import read_session
from app.metrology.adjustment.block.calibrate import BlockCalibration, calibrate_block
from app.metrology.adjustment.block.problem import BlockInputs
from app.metrology.arm.kinematics import Arm
from app.metrology.design.expected_accuracy import TILTS_DEG
from app.metrology.design.making_tolerance import MEASURED_MM
from app.metrology.design.propose_block import BlockDesign, propose_block
from app.metrology.design.stripe_sensor import StripeSensor
from app.metrology.sensor.triangulation import sensor_points
from app.metrology.targets.crenellated_block import Crenellated, mirror_difference_mm
from app.metrology.transforms import Floats, apply
from app.workflows.calibrate import joint_inputs
from hardware.simulator.devices.kinematics import ArmModel, UnreachableError, perturb_arm
from hardware.simulator.scene.camera import LightPlane, Optics
from hardware.simulator.scene.datasheets import arm_datasheet
from hardware.simulator.scene.random_scenes import (
    draw_true_block,
    random_arm,
    random_block_pose,
    random_mounting,
)
from hardware.simulator.scene.stripe_sensors import (
    SensorNumbers,
    build_stripe_sensor,
    draw_sensor_numbers,
    range_truth,
)
from hardware.simulator.scene.world import CrenellatedBlock
from hardware.simulator.session import SessionPlan, SimulatedRig, render_rig_session
from tests.bench.rows import Rows, bench_parser, measured_rows, rms

LIMIT = 1.3
"""Errors may exceed what was stated by this factor."""
ARM_UM = 20.0
"""By how much an arm's tip is off over its reach, as the design takes it to be."""
TRIES = 20
PLAN = SessionPlan(
    poses=len(TILTS_DEG),
    imperfection_um=ARM_UM,
    certificate_sd_mm=MEASURED_MM,
    contact_sd_mm=0.005,
    tilts_deg=TILTS_DEG,
)


@dataclass(frozen=True)
class DesignedFor:
    """A sensor with the arm that carries it, and the block designed for both."""

    numbers: SensorNumbers
    arm: ArmModel
    design: BlockDesign


@dataclass(frozen=True)
class Measured:
    """Calibrations of one sensor, each a row (S,): errors and claims in µm."""

    one_pose_um: Floats
    eight_poses_um: Floats
    one_claimed_um: Floats
    eight_claimed_um: Floats
    refused: tuple[str, ...]


def draw_design(seed: int) -> DesignedFor:
    """A random sensor on a random arm that can do the session, and a block for it."""
    for attempt in range(TRIES):
        rng = np.random.default_rng([seed, attempt])
        numbers, arm = draw_sensor_numbers(rng), random_arm(rng)
        try:
            return DesignedFor(numbers, arm, design_for(numbers, read_model(arm)))
        except OperationError as refusal:
            if refusal.code != "arm-cannot-reach":
                raise
    raise UnreachableError(f"no arm was found for sensor {seed}")


def read_model(arm: ArmModel) -> Arm:
    """The arm as a station reads it."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "arm.json")
        path.write_text(json.dumps(arm_datasheet(arm)))
        found = read_arm(path)
    assert isinstance(found, Arm)
    return found


def design_for(numbers: SensorNumbers, arm: Arm) -> BlockDesign:
    """The block by the numbers that a sensor's maker states."""
    sensor = StripeSensor(
        numbers.field_of_view_mm,
        numbers.standoff_mm,
        numbers.depth_of_field_mm,
        numbers.width_px,
        numbers.height_px,
        "u" if numbers.stripe_axis == "u" else "v",
        numbers.angle_deg,
    )
    return propose_block(sensor, arm, "Designed block")


def measure_sensor(made_for: DesignedFor, seed: int, sessions: int, scratch: Path) -> Measured:
    """Sessions with the sensor and its block, rendered and calibrated with one pose and all."""
    rows: list[tuple[float, ...]] = []
    refused: list[str] = []
    for attempt in range(sessions + TRIES):
        if len(rows) == sessions:
            break
        folder = scratch / f"{seed}-{attempt}"
        rig = _render(made_for, [seed, 1000 + attempt], folder)
        try:
            everything = joint_inputs(read_session(folder))
            found = [calibrate_block(_first(everything, n)) for n in (1, len(TILTS_DEG))]
        except OperationError as refusal:  # the operator starts again
            refused.append(refusal.line)
            continue
        errors = [_error_um(one, made_for.numbers, rig.optics, rig) for one in found]
        rows.append((*errors, *(one.uncertainty.total_um for one in found)))
    columns = np.array(rows).reshape(-1, 4).T
    return Measured(columns[0], columns[1], columns[2], columns[3], tuple(refused))


def _render(made_for: DesignedFor, seed: list[int], folder: Path) -> SimulatedRig:
    """Renders a session into a folder; returns what it was rendered from."""
    for attempt in range(TRIES):
        rng = np.random.default_rng([*seed, attempt])
        rig = _assemble(made_for, rng)
        try:
            render_rig_session(folder, int(rng.integers(1 << 30)), rig, PLAN)
        except UnreachableError:
            continue
        return rig
    raise UnreachableError(f"the arm of sensor {seed[0]} reaches no block")


def _assemble(made_for: DesignedFor, rng: np.random.Generator) -> SimulatedRig:
    """Arm, sensor and block as truly built."""
    block = _as_certified(made_for.design.block)
    optics, light = build_stripe_sensor(made_for.numbers, rng)
    return SimulatedRig(
        perturb_arm(made_for.arm, ARM_UM, rng),
        made_for.arm,
        optics,
        light,
        random_mounting(rng, made_for.numbers.standoff_mm),
        draw_true_block(block, MEASURED_MM, rng),
        block,
        random_block_pose(rng),
    )


def _as_certified(block: Crenellated) -> CrenellatedBlock:
    return CrenellatedBlock(
        block.edges_x_mm,
        block.front_y_mm,
        block.back_y_mm,
        block.crest_z_mm,
        block.floor_z_mm,
        block.base_z_mm,
    )


def _first(inputs: BlockInputs, poses: int) -> BlockInputs:
    return replace(inputs, observations=inputs.observations[:poses], q_rad=inputs.q_rad[:poses])


def _error_um(
    found: BlockCalibration, numbers: SensorNumbers, optics: Optics, rig: SimulatedRig
) -> float:
    """Rms error of points over the measuring range, in the flange frame."""
    light: LightPlane = rig.light_plane
    uv, points = range_truth(numbers, optics, light)
    rebuilt = apply(found.T_flange_sensor, sensor_points(found.camera, found.plane, uv))
    off_mm = rebuilt - apply(rig.T_flange_sensor, points)
    return 1e3 * float(np.sqrt(np.mean(np.sum(off_mm**2, axis=1))))


def measure_sensors(count: int, sessions: int, first: int, rows: Rows) -> None:
    """A row for each sensor, and one of all."""
    ratios, claims, refused = [], [], 0
    for name, made_for, found in _each(count, sessions, first):
        design = made_for.design
        refused += len(found.refused)
        stated = np.array([design.one_pose.total_um, design.eight_poses.total_um])
        errors = np.array([rms(found.one_pose_um), rms(found.eight_poses_um)])
        claimed = np.array([rms(found.one_claimed_um), rms(found.eight_claimed_um)])
        rows.add(name, _row(design, stated, errors, claimed, len(found.refused)))
        for reason in found.refused:
            rows.say(f"{name}: {reason}")
        ratios.append(errors / stated)
        claims.append(claimed / stated)
    over, claim = np.array(ratios), np.array(claims)
    summary = {
        "one pose, rms": rms(over[:, 0]),
        "one pose, worst": over[:, 0].max(),
        "eight poses, rms": rms(over[:, 1]),
        "eight poses, worst": over[:, 1].max(),
        "sensors above 1.3": int((over > LIMIT).any(axis=1).sum()),
        "claimed, worst": claim.max(),
        "refused": refused,
    }
    rows.add("error over stated", summary)


def _each(count: int, sessions: int, first: int) -> Iterator[tuple[str, DesignedFor, Measured]]:
    for seed in range(first, first + count):
        made_for = draw_design(seed)
        numbers = made_for.numbers
        with tempfile.TemporaryDirectory() as scratch:
            found = measure_sensor(made_for, seed, sessions, Path(scratch))
        megapixels = numbers.width_px * numbers.height_px / 1e6
        name = f"{seed}: {numbers.standoff_mm:.0f} mm, {megapixels:.1f} MP"
        yield name, made_for, found


def _row(
    design: BlockDesign, stated: Floats, errors: Floats, claimed: Floats, refused: int
) -> dict[str, float]:
    return {
        "width, mm": design.block.edges_x_mm[-1] - design.block.edges_x_mm[0],
        "merlons": design.block.merlon_count,
        "off mirror, mm": mirror_difference_mm(design.block.edges_x_mm),
        "one pose": stated[0],
        "error": errors[0],
        "eight poses": stated[1],
        "their error": errors[1],
        "claimed / stated": claimed[0] / stated[0],
        "of eight": claimed[1] / stated[1],
        "refused": refused,
    }


def main() -> None:
    parser = bench_parser(__doc__)
    parser.add_argument("--sensors", type=int, default=20)
    parser.add_argument("--sessions", type=int, default=2)
    parser.add_argument("--first", type=int, default=300)
    given = parser.parse_args()
    with measured_rows(given.json) as rows:
        measure_sensors(given.sensors, given.sessions, given.first, rows)


if __name__ == "__main__":
    main()
