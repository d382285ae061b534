"""Blocks designed for random sensors, and sessions of operators who calibrate with them."""

import json
import tempfile
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from crenel.errors import OperationError
from crenel.formats.datasheets.arm import read_arm
from crenel.metrology.adjustment.block.calibrate import observe_block
from crenel.metrology.adjustment.block.problem import BlockInputs
from crenel.metrology.adjustment.core.arm_errors import LEVER_MM, link_errors_mm
from crenel.metrology.adjustment.core.observations import BlockObservation
from crenel.metrology.arm.kinematics import Arm
from crenel.metrology.design.expected_accuracy import TILTS_DEG, TIP_OFF_MM
from crenel.metrology.design.making_tolerance import MEASURED_MM
from crenel.metrology.design.propose_block import BlockDesign, propose_block
from crenel.metrology.design.stripe_sensor import StripeSensor
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.transforms import Floats, inverse
from crenel_hardware.simulator.devices.kinematics import ArmModel, UnreachableError, solve_joints
from crenel_hardware.simulator.rendering.render import Renderer
from crenel_hardware.simulator.scene.datasheets import arm_datasheet
from crenel_hardware.simulator.scene.random_scenes import (
    draw_true_block,
    random_arm,
    random_block_pose,
    random_mounting,
)
from crenel_hardware.simulator.scene.stripe_sensors import (
    SensorNumbers,
    build_stripe_sensor,
    draw_sensor_numbers,
)
from crenel_hardware.simulator.scene.world import CrenellatedBlock
from crenel_hardware.simulator.session import (
    SessionPlan,
    SimulatedRig,
    block_scene,
    draw_sensor_pose,
    read_encoders_rad,
    touch_block,
)

TRIES = 20
PLAN = SessionPlan(
    poses=len(TILTS_DEG), certificate_sd_mm=MEASURED_MM, contact_sd_mm=0.005, tilts_deg=TILTS_DEG
)


@dataclass(frozen=True)
class DesignedFor:
    """A sensor with the arm that carries it, and the block designed for both."""

    numbers: SensorNumbers
    arm: ArmModel
    design: BlockDesign


@dataclass(frozen=True)
class Looked:
    """A sensor and a block as truly built, and what the pictures of eight poses show."""

    rig: SimulatedRig
    T_obj_sensor: Floats  # (P, 4, 4)
    observations: tuple[BlockObservation, ...]


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


def look_at_block(made_for: DesignedFor, rng: np.random.Generator) -> Looked:
    """Renders and detects; raises ``OperationError`` where the block is not found in a picture."""
    block = _as_certified(made_for.design.block)
    optics, light = build_stripe_sensor(made_for.numbers, rng)
    rig = SimulatedRig(
        made_for.arm,
        made_for.arm,
        optics,
        light,
        random_mounting(rng, made_for.numbers.standoff_mm),
        draw_true_block(block, MEASURED_MM, rng),
        block,
        random_block_pose(rng),
    )
    renderer = Renderer(block_scene(rig), optics, light, PLAN.detector, int(rng.integers(1 << 30)))
    holds, seen = [], []
    for number, turned_deg in enumerate(TILTS_DEG):
        T_arm_sensor = draw_sensor_pose(rig, rng, 1.0, turned_deg)
        ambient, laser = (renderer.render(T_arm_sensor, *lit) for lit in ((1.0, 0.0), (0.0, 1.0)))
        axis = made_for.numbers.stripe_axis
        seen.append(observe_block(number, made_for.design.block, ambient, laser, axis))
        holds.append(inverse(rig.T_arm_obj) @ T_arm_sensor)
    return Looked(rig, np.array(holds), tuple(seen))


def take_rig(
    made_for: DesignedFor, looked: SimulatedRig, arm: Arm, rng: np.random.Generator
) -> SimulatedRig:
    """The sensor and the block on another arm of the same model, elsewhere."""
    return replace(
        looked,
        arm=_draw_true_arm(made_for.arm, link_errors_mm(arm, TIP_OFF_MM), rng),
        T_flange_sensor=random_mounting(rng, made_for.numbers.standoff_mm),
        T_arm_obj=random_block_pose(rng),
    )


def _draw_true_arm(model: ArmModel, link_mm: float, rng: np.random.Generator) -> ArmModel:
    """An arm whose links are off by so much: as many of them have the tip off over the reach by
    what the design states, one by more and another by less."""
    links = []
    for link in model.links:
        x, y, z, rx, ry, rz = rng.normal(0.0, link_mm, 6) / np.repeat([1.0, LEVER_MM], 3)
        links.append(replace(link, error_mm_rad=(x, y, z, rx, ry, rz)))
    return replace(model, links=tuple(links))


def take_session(
    rig: SimulatedRig, arm: Arm, block: Crenellated, looked: Looked, rng: np.random.Generator
) -> BlockInputs:
    """What an operator brings who touches in the posture of his first picture; raises
    ``UnreachableError``."""
    q, held, readings = np.zeros(rig.arm.joint_count), [], []
    for T_obj_sensor in looked.T_obj_sensor:
        target = rig.T_arm_obj @ T_obj_sensor @ inverse(rig.T_flange_sensor)
        q = solve_joints(rig.arm, target, q, rng)
        held.append(q)
        readings.append(read_encoders_rad(rig, PLAN, q, rng))
    features, contact_q_rad = touch_block(rig, PLAN, rng, held[0])
    return BlockInputs(
        arm=arm,
        block=block,
        features=features,
        contact_q_rad=contact_q_rad,
        observations=looked.observations,
        q_rad=np.array(readings),
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
