"""Blocks designed for random sensors: simulated calibrations beside what the design stated.

    python -m tests.bench design-block [--sensors 20] [--operators 6] [--first 300] [--json]

Every sensor (30 to 400 mm stand-off, 0.3 to 12 megapixels) and arm is drawn by the simulator. The
block is designed from the sensor's numbers and the arm's file alone. Sensor and block as they were
truly built are then rendered in eight poses, and found in the pictures. Operators, each with an arm
that is off its file in its own way, a mounting and a place on the table, touch the block and bring
the sensor to these poses: the pictures are the same, all readings are not. Each calibrates with the
first pose, and with all. A row has the accuracy stated, the rms error over the sensor's measuring
range of all operators (flange frame, µm), the ratio of both, and that of the uncertainty that the
calibrations claim to the one stated.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from crenel.errors import OperationError
from crenel.metrology.adjustment.block.calibrate import BlockCalibration, calibrate_block
from crenel.metrology.adjustment.block.problem import BlockInputs
from crenel.metrology.adjustment.core.uncertainty import point_budget, sensor_jacobian
from crenel.metrology.design.expected_accuracy import TILTS_DEG
from crenel.metrology.design.propose_block import BlockDesign
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.targets.crenellated_block import mirror_difference_mm
from crenel.metrology.transforms import Floats, apply
from crenel_hardware.simulator.devices.kinematics import UnreachableError
from crenel_hardware.simulator.scene.stripe_sensors import SensorNumbers, range_truth
from crenel_hardware.simulator.session import SimulatedRig
from tests.bench.designed_rigs import (
    TRIES,
    DesignedFor,
    draw_design,
    look_at_block,
    read_model,
    take_rig,
    take_session,
)
from tests.bench.rows import Rows, bench_parser, measured_rows, rms

LIMIT = 1.3
"""Errors may exceed what was stated by this factor."""


@dataclass(frozen=True)
class Measured:
    """Calibrations of one sensor, each a row (S,): errors and claims in µm."""

    one_pose_um: Floats
    eight_poses_um: Floats
    one_claimed_um: Floats
    eight_claimed_um: Floats
    refused: tuple[str, ...]


def measure_sensor(made_for: DesignedFor, seed: int, operators: int) -> Measured:
    """Calibrations with one pose and all, by operators whose pictures are the same."""
    looked = look_at_block(made_for, np.random.default_rng([seed, 1000]))
    arm = read_model(made_for.arm)
    rows: list[tuple[float, ...]] = []
    refused: list[str] = []
    for attempt in range(operators + TRIES):
        if len(rows) == operators:
            break
        rng = np.random.default_rng([seed, 2000, attempt])
        rig = take_rig(made_for, looked.rig, arm, rng)
        try:
            everything = take_session(rig, arm, made_for.design.block, looked, rng)
            found = [calibrate_block(_first(everything, n)) for n in (1, len(TILTS_DEG))]
        except UnreachableError:  # the operator puts the block elsewhere
            continue
        except OperationError as refusal:  # the operator starts again
            refused.append(refusal.line)
            continue
        judged = [_error_and_claim_um(one, made_for.numbers, rig) for one in found]
        rows.append((judged[0][0], judged[1][0], judged[0][1], judged[1][1]))
    columns = np.array(rows).reshape(-1, 4).T
    return Measured(columns[0], columns[1], columns[2], columns[3], tuple(refused))


def _first(inputs: BlockInputs, poses: int) -> BlockInputs:
    return replace(inputs, observations=inputs.observations[:poses], q_rad=inputs.q_rad[:poses])


def _error_and_claim_um(
    found: BlockCalibration, numbers: SensorNumbers, rig: SimulatedRig
) -> tuple[float, float]:
    """Rms error of points over the measuring range, flange frame, and what is claimed for them."""
    uv, points = range_truth(numbers, rig.optics, rig.light_plane)
    assert found.plane is not None
    rebuilt = apply(found.T_flange_sensor, sensor_points(found.camera, found.plane, uv))
    off_mm = rebuilt - apply(rig.T_flange_sensor, points)
    J = sensor_jacobian(found.adjustment.state, uv)
    _, claimed_um = point_budget(found.adjustment, J)
    return 1e3 * float(np.sqrt(np.mean(np.sum(off_mm**2, axis=1)))), claimed_um


def measure_sensors(count: int, operators: int, first: int, rows: Rows) -> None:
    """A row for each sensor, and one of all."""
    ratios, claims, refused = [], [], 0
    for name, made_for, found in _each(count, operators, first):
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


def _each(count: int, operators: int, first: int) -> Iterator[tuple[str, DesignedFor, Measured]]:
    for seed in range(first, first + count):
        made_for = draw_design(seed)
        numbers = made_for.numbers
        found = measure_sensor(made_for, seed, operators)
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
    parser.add_argument("--operators", type=int, default=6)
    parser.add_argument("--first", type=int, default=300)
    given = parser.parse_args()
    with measured_rows(given.json) as rows:
        measure_sensors(given.sensors, given.operators, given.first, rows)


if __name__ == "__main__":
    main()
