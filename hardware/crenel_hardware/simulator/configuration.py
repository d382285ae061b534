"""What station to simulate, and its rig: arm, sensor and block as they truly are."""

from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from crenel_hardware.interfaces import Delivery
from crenel_hardware.simulator.devices.kinematics import (
    ArmModel,
    Floats,
    perturb_arm,
    rigid_fit,
    rotation_about,
    solve_joints,
    tip_centres,
    translation,
)
from crenel_hardware.simulator.rendering.noise import Detector
from crenel_hardware.simulator.scene.random_scenes import (
    demo_arm,
    draw_sensor,
    draw_true_block,
    random_mounting,
)
from crenel_hardware.simulator.scene.tabletop import part_pose
from crenel_hardware.simulator.scene.world import Board, CrenellatedBlock, Light
from crenel_hardware.simulator.session import SimulatedRig


@dataclass(frozen=True)
class SimulationConfig:
    """What station to simulate; the defaults are the demonstration."""

    seed: int = 1
    arm: ArmModel = field(default_factory=demo_arm)
    """As its datasheet has it."""
    imperfection_um: float = 45.0
    """Rms error of the tip over the arm's whole reach that the datasheets do not state."""
    arm_reports: Literal["joints", "pose"] = "joints"
    """Poses are those that a controller computes from the arm's nominal model."""
    robot: bool = False
    """A robot of Universal Robots carries the sensor, and speaks RTDE; it has no tip. Its poses
    are computed from the nominal model, too."""
    rate_hz: float = 1000.0
    counts_per_revolution: int = 1 << 22
    line: str = "tcp"
    """"tcp" or "pty"."""
    host: str = "127.0.0.1"
    port: int = 0
    """The port of the arm's TCP line; 0: any that is free."""
    block: CrenellatedBlock = field(default_factory=CrenellatedBlock)
    """As its certificate has it."""
    board: Board = field(default_factory=Board)
    """As its certificate has it."""
    certificate_sd_mm: float = 0.002
    """The standard deviation of the block's sizes and of the board's."""
    contact_sd_mm: float = 0.006
    tremor_um: float = 0.0
    """How much the tip trembles while the sensor is held."""
    pace: float = 1.0
    """The simulated operator's speed; 1 is a person's."""
    distortion: tuple[float, float, float, float, float] = (-0.04, 0.0, 0.0, 0.0, 0.0)
    roll_rad: float = 0.0
    width_px: int = 1280
    height_px: int = 1024
    frames_hz: float = 25.0
    arm_delay_ms: float = 0.0
    """By how much the arm's stamps are later than the camera's."""
    detector: Detector = field(default_factory=Detector)
    light: Light = field(default_factory=Light)
    delivers: frozenset[Delivery] = frozenset({"picture"})
    """Pictures, lines that the camera finds itself, or both; a triggered camera: pictures; a GigE
    camera: pictures, or both."""
    second_sensor: bool = False
    """A second sensor of the same kind sits beside the first one, and measures the same place."""
    triggered: bool = False
    """The arm's pulses trigger the camera."""
    jitter_ms: float = 0.0
    """By how much the frames of a triggered camera arrive earlier or later than usual."""
    laser_switch: bool = True
    """Whether the station can switch the laser, or only a person at the sensor."""
    camera: Literal["built-in", "gige"] = "built-in"
    """The driver of the simulated sensor; or the driver ``genicam``, with a camera that sends the
    pictures over GigE Vision, and switches the laser."""
    camera_address: str = "127.0.0.1"
    """The address of the GigE camera; the port is always the same, so one address serves one
    camera."""


def build_rig(config: SimulationConfig, rng: np.random.Generator) -> tuple[SimulatedRig, Floats]:
    """The rig, and joint angles with the sensor well above the table."""
    optics, light_plane = draw_sensor(
        config.block,
        rng,
        roll_rad=config.roll_rad,
        distortion=config.distortion,
        width_px=config.width_px,
        height_px=config.height_px,
    )
    arm = perturb_arm(config.arm, config.imperfection_um, rng)
    T_flange_sensor = random_mounting(rng)
    T_arm_obj = part_pose("block", -config.block.base_z_mm)
    over_table = translation(740.0, 0.0, 110.0) @ rotation_about("z", 0.1)
    start = np.zeros(arm.joint_count)
    home = solve_joints(arm, over_table @ np.linalg.inv(T_flange_sensor), start, rng)
    block = draw_true_block(config.block, config.certificate_sd_mm, rng)
    rig = SimulatedRig(
        arm, config.arm, optics, light_plane, T_flange_sensor, block, config.block, T_arm_obj
    )
    return rig, home


def model_frame(rig: SimulatedRig, home: Floats, rng: np.random.Generator) -> Floats:
    """Where the arm's model, imperfect as it is, best has its frame around the table (4, 4).

    Gauges are certified in the frame that a perfect model would measure in; without
    this their nominals would be off by what no calibration of the sensor can mend.
    """
    q = home + rng.uniform(-0.25, 0.25, (300, len(home)))
    return rigid_fit(tip_centres(rig.nominal_arm, q), tip_centres(rig.arm, q))
