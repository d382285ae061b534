"""Blocks, arms and sensors of every kind, drawn at random within what a workshop would build."""

from dataclasses import replace

import numpy as np

from crenel_hardware.simulator.devices.kinematics import (
    ArmLink,
    ArmModel,
    Floats,
    rotation_about,
    translation,
)
from crenel_hardware.simulator.scene.camera import (
    LightPlane,
    Optics,
    camera_looking_at,
    light_plane_through,
    to_pixels,
)
from crenel_hardware.simulator.scene.world import Board, CrenellatedBlock

RIGHT_ANGLE = np.pi / 2


def draw_true_block(
    certificate: CrenellatedBlock,
    sd_mm: float,
    rng: np.random.Generator,
    tolerance_mm: float | None = None,
) -> CrenellatedBlock:
    """The block as truly made: each size off its certificate by a few micrometres, or anywhere
    within its tolerance."""

    def near(value: float) -> float:
        if tolerance_mm is not None:
            return float(value + rng.uniform(-tolerance_mm, tolerance_mm))
        return float(value + rng.normal(0.0, sd_mm)) if sd_mm else value

    return CrenellatedBlock(
        tuple(near(x) for x in certificate.edges_x_mm),
        near(certificate.front_y_mm),
        near(certificate.back_y_mm),
        near(certificate.crest_z_mm),
        near(certificate.floor_z_mm),
        near(certificate.base_z_mm),
    )


def draw_true_board(certificate: Board, sd_mm: float, rng: np.random.Generator) -> Board:
    """The chessboard as truly made: width and height between the outermost inner corners off
    its certificate by a few micrometres."""
    columns, rows = certificate.inner_corners
    wide, tall = rng.normal(0.0, sd_mm, 2) if sd_mm else np.zeros(2)
    return replace(
        certificate,
        square_x_mm=certificate.square_x_mm + float(wide) / (columns - 1),
        square_y_mm=certificate.square_y_mm + float(tall) / (rows - 1),
    )


def random_block(rng: np.random.Generator, merlons: int | None = None) -> CrenellatedBlock:
    """A block about 40 to 48 mm wide whose mirror image has other widths.

    ``merlons`` is 3 to 5 where not given.
    """
    count = merlons or int(rng.integers(3, 6))
    total = rng.uniform(40.0, 48.0)
    while True:
        widths = np.round(rng.uniform(1.0, 2.1, 2 * count - 1) * 2) / 2
        widths = np.round(widths / widths.sum() * total * 2) / 2
        if widths.min() >= 3.0 and np.max(np.abs(widths - widths[::-1])) >= 2.0:
            break
    edges = np.concatenate([[0.0], np.cumsum(widths)])
    edges -= np.round(edges[-1] / 2)
    depth = float(np.round(rng.uniform(20.0, 28.0)))
    front = -float(np.round(depth * rng.uniform(0.42, 0.58)))
    return CrenellatedBlock(
        tuple(float(x) for x in edges),
        front,
        front + depth,
        float(np.round(rng.uniform(11.0, 18.0))),
        0.0,
        -float(np.round(rng.uniform(8.0, 13.0))),
    )


def demo_arm() -> ArmModel:
    """A six-axis portable arm by its datasheet: yaw, shoulder, elbow, a wrist of three."""
    return ArmModel(
        (
            ArmLink(0.0, -RIGHT_ANGLE, 320.0, 0.0, 1, _symmetric_limits(np.radians(170.0))),
            ArmLink(560.0, 0.0, 0.0, -RIGHT_ANGLE, 1, _symmetric_limits(np.radians(125.0))),
            ArmLink(32.0, -RIGHT_ANGLE, 0.0, 0.0, 1, _symmetric_limits(np.radians(155.0))),
            ArmLink(0.0, RIGHT_ANGLE, 540.0, 0.0, 1, _symmetric_limits(np.radians(175.0))),
            ArmLink(0.0, -RIGHT_ANGLE, 0.0, 0.0, -1, _symmetric_limits(np.radians(125.0))),
            ArmLink(0.0, 0.0, 82.0, 0.0, 1, _symmetric_limits(np.radians(175.0))),
        ),
        tip_mm=(0.0, -12.0, 165.0),
        tip_diameter_mm=3.0,
        name="Simulated six-axis arm",
    )


def demo_robot() -> ArmModel:
    """The same chain as a robot."""
    return replace(demo_arm(), name="Simulated robot", serial_number="TWIN-R1")


def _symmetric_limits(limit: float) -> tuple[float, float]:
    return (-float(limit), float(limit))


def random_arm(rng: np.random.Generator, joints: int = 6) -> ArmModel:
    """A nominal arm of six or seven joints: any of the usual layouts, signs and offsets."""
    limits = _symmetric_limits(np.radians(175.0))
    base, upper, fore, end = (
        float(rng.uniform(low, high))
        for low, high in ((270, 330), (520, 650), (480, 570), (60, 100))
    )
    small = float(rng.uniform(0.0, 38.0))

    def link(a: float, quarter: int, d: float) -> ArmLink:
        theta = float(rng.choice([0.0, np.pi / 2, -np.pi / 2, np.pi / 6]))
        sign = int(rng.choice([-1, 1]))
        return ArmLink(a, quarter * RIGHT_ANGLE, d, theta, sign, limits)

    shoulder = [link(0.0, -1, base), link(small, 1, 0.0), link(-small, -1, upper)]
    elbow = [link(small, 1, 0.0), link(-small, -1, fore)]
    wrist = [link(0.0, 1, 0.0), link(0.0, 0, end)] if joints == 7 else [link(0.0, 0, end)]
    chain = [*shoulder, *elbow, *wrist]
    if joints == 6 and rng.uniform() < 0.5:
        chain = [
            link(0.0, -1, base),
            link(upper, 0, 0.0),
            link(small, -1, 0.0),
            link(0.0, 1, fore),
            link(0.0, -1, 0.0),
            link(0.0, 0, end),
        ]
    return ArmModel(
        tuple(chain),
        tip_mm=(
            float(rng.uniform(-8, 8)),
            float(rng.uniform(-14, 10)),
            float(rng.uniform(150, 185)),
        ),
        tip_diameter_mm=float(rng.choice([3.0, 4.0, 6.0])),
        encoder_sd_rad=float(rng.uniform(7e-6, 1.1e-5)),
        name="Drawn at random",
    )


def random_mounting(rng: np.random.Generator, standoff_mm: float = 125.0) -> Floats:
    """``T_flange_sensor`` (4, 4): the sensor below the flange, looking along its axis."""
    turn = np.eye(4)
    for axis in "xyz":
        turn = turn @ rotation_about(axis, float(rng.normal(0.0, 0.08)))
    x, y = float(rng.uniform(-6, 6)), float(rng.uniform(-64, -50))
    place = translation(x, y, float(rng.uniform(standoff_mm + 80, standoff_mm + 100)))
    return np.asarray(place @ np.diag([1.0, -1.0, -1.0, 1.0]) @ turn)


def draw_sensor(
    block: CrenellatedBlock,
    rng: np.random.Generator | None = None,
    *,
    roll_rad: float = 0.0,
    distortion: tuple[float, float, float, float, float] = (0.0,) * 5,
    width_px: int = 1280,
    height_px: int = 1024,
    fill: float = 0.86,
) -> tuple[Optics, LightPlane]:
    """Optics that frame a block about the sensor's origin, and a light plane through it.

    Sensor frame: x along the stripe, z towards the sensor, the light plane near y = 0, the
    origin half way between crest and floor. ``rng`` scatters everything as in real
    assembly; without it all is square. ``fill`` of the image is taken by the block.
    """

    def jitter(sd: float) -> Floats:
        return rng.normal(0.0, sd, 3) if rng else np.zeros(3)

    eye = np.array([0.0, -72.0, 114.0]) + jitter(2.0)
    mid_z = (block.crest_z_mm + block.floor_z_mm) / 2
    low = np.array([block.edges_x_mm[0], block.front_y_mm, block.base_z_mm - mid_z])
    high = np.array([block.edges_x_mm[-1], block.back_y_mm, block.crest_z_mm - mid_z])
    box = np.array([np.where(np.array(bits), high, low) for bits in np.ndindex(2, 2, 2)])
    T = camera_looking_at(eye, (low + high) / 2 + jitter(0.5), np.array([1.0, 0.0, 0.0]), roll_rad)
    shift = jitter(8.0)
    optics = Optics(
        width_px,
        height_px,
        1000.0,
        1000.0 * (1 + 2e-4 * float(jitter(1.0)[0])),
        (width_px - 1) / 2 + float(shift[0]),
        (height_px - 1) / 2 + float(shift[1]),
        distortion,
        T,
    )
    reach = np.abs(to_pixels(optics, box) - [optics.cx_px, optics.cy_px]).max(axis=0)
    focal = float(fill * 0.5 * np.min([width_px, height_px] / reach))
    optics = replace(optics, fx_px=1000.0 * focal, fy_px=optics.fy_px * focal)
    normal = np.array([0.0, 1.0, -0.016]) + 0.01 * jitter(1.0)
    light_plane = light_plane_through(
        normal, 0.3 * jitter(1.0), np.array([0.0, 0.0, 128.0]) + jitter(2.0)
    )
    return optics, light_plane


def random_block_pose(rng: np.random.Generator, yaw_rad: float = 0.7) -> Floats:
    """``T_arm_obj`` (4, 4) of a block on a table within an arm's comfortable reach."""
    bearing, distance = rng.uniform(-0.5, 0.6), rng.uniform(480.0, 640.0)
    place = translation(
        float(distance * np.cos(bearing)),
        float(distance * np.sin(bearing)),
        float(rng.uniform(80.0, 135.0)),
    )
    turn = rotation_about("z", float(bearing + rng.uniform(-yaw_rad, yaw_rad)))
    for axis in "xy":
        turn = turn @ rotation_about(axis, float(rng.normal(0.0, 0.03)))
    return np.asarray(place @ turn)
