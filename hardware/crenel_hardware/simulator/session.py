"""Whole calibration sessions with their truth, rendered into a folder.

``render_session`` makes another block, arm and sensor for every seed: the folder is
what an operator would bring (docs/formats.md), ``truth.json`` beside it is what only nature
knows.
"""

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path

import cv2
import numpy as np

from crenel_hardware.simulator.devices.kinematics import (
    ArmModel,
    ErrorSource,
    Floats,
    UnreachableError,
    perturb_arm,
    rotation_about,
    solve_joints,
    translation,
)
from crenel_hardware.simulator.operator.contact import choose_contact_point, contact_pose
from crenel_hardware.simulator.rendering.noise import Detector, RawImage
from crenel_hardware.simulator.rendering.render import Renderer
from crenel_hardware.simulator.scene.camera import LightPlane, Optics, to_pixels
from crenel_hardware.simulator.scene.datasheets import (
    JsonObject,
    arm_datasheet,
    block_datasheet,
    sensor_datasheet,
    write_document,
    write_table,
)
from crenel_hardware.simulator.scene.random_scenes import (
    draw_sensor,
    draw_true_block,
    random_arm,
    random_block,
    random_block_pose,
    random_mounting,
)
from crenel_hardware.simulator.scene.world import (
    CrenellatedBlock,
    Light,
    ObjectShape,
    SceneObject,
    SimulatedScene,
    make_table,
)

TRIES = 20


@dataclass(frozen=True)
class SessionPlan:
    """What kind of session to draw; everything else follows from the seed."""

    joints: int = 6
    imperfection_um: float = 0.0
    """Rms error of the tip over the arm's reach that its datasheet does not state."""
    wrong_in: ErrorSource = "links"
    """Where these errors are, as of ``kinematics.imperfect``."""
    lighting: str = "pair"
    """"pair": an ambient and a laser image a pose; "both": one with both lights."""
    poses: int = 1
    roll_rad: float = 0.0
    """The camera turned about its own axis; about 90° makes the stripe one point a row."""
    distortion: tuple[float, float, float, float, float] = (-0.04, 0.0, 0.0, 0.0, 0.0)
    width_px: int = 1280
    height_px: int = 1024
    faces: Sequence[str] = ("crest", "front", "left")
    contacts_per_face: int = 15
    contact_sd_mm: float = 0.006
    certificate_sd_mm: float = 0.002
    tolerance_mm: float | None = None
    """Nobody measured the block: it is made within this, and ``object.json`` is its drawing."""
    merlons: int | None = None
    encoder_noise: bool = True
    tilts_deg: Sequence[tuple[float, float, float]] = ()
    """How the sensor is turned about the block's X, Y and Z in each pose; where not given, at
    random and by little."""
    detector: Detector = field(default_factory=Detector)
    light: Light = field(default_factory=Light)


@dataclass(frozen=True)
class SimulatedRig:
    """One arm, sensor and block as they truly are, with the datasheets that the operator has."""

    arm: ArmModel
    nominal_arm: ArmModel
    optics: Optics
    light_plane: LightPlane
    T_flange_sensor: Floats
    block: CrenellatedBlock
    certificate: CrenellatedBlock
    T_arm_obj: Floats


@dataclass(frozen=True)
class ScanFrame:
    """One image of a scan, and what the encoders said at its middle."""

    image: RawImage
    joints_rad: Floats


def draw_rig(
    seed: int, plan: SessionPlan, block: CrenellatedBlock | None = None, arm: ArmModel | None = None
) -> SimulatedRig:
    """A station for a seed; ``block`` and ``arm`` may be given as certified."""
    rng = np.random.default_rng(seed)
    certificate = block or random_block(rng, plan.merlons)
    nominal = arm or random_arm(rng, plan.joints)
    optics, light_plane = draw_sensor(
        certificate,
        rng,
        roll_rad=plan.roll_rad,
        distortion=plan.distortion,
        width_px=plan.width_px,
        height_px=plan.height_px,
    )
    return SimulatedRig(
        perturb_arm(nominal, plan.imperfection_um, rng, plan.wrong_in),
        nominal,
        optics,
        light_plane,
        random_mounting(rng),
        draw_true_block(certificate, plan.certificate_sd_mm, rng, plan.tolerance_mm),
        certificate,
        random_block_pose(rng),
    )


def block_scene(rig: SimulatedRig, light: Light | None = None) -> SimulatedScene:
    """The rig's block alone on a dark table."""
    base = rig.T_arm_obj @ translation(0.0, 0.0, rig.block.base_z_mm)
    things = (make_table().at(base), SceneObject("block", rig.block, rig.T_arm_obj))
    return SimulatedScene(things, light or Light())


def draw_sensor_pose(
    rig: SimulatedRig,
    rng: np.random.Generator,
    spread: float,
    turned_deg: tuple[float, float, float] = (0.0, 0.0, 0.0),
) -> Floats:
    """``T_arm_sensor`` (4, 4) with the block framed; ``spread`` 1 is the usual variation.

    Then the sensor is turned about the block's X, Y and Z.
    """
    middle = (rig.block.crest_z_mm + rig.block.floor_z_mm) / 2
    T = rig.T_arm_obj @ translation(0.0, 0.0, middle)
    T = T @ translation(*(float(v) for v in rng.normal(0.0, 0.4, 3) * spread))
    for axis, sd in (("x", 0.02), ("y", 0.03), ("z", 0.02)):
        T = T @ rotation_about(axis, float(rng.normal(0.0, sd) * spread))
    for axis, angle in zip("zyx", turned_deg[::-1], strict=True):
        T = T @ rotation_about(axis, float(np.radians(angle)))
    return np.asarray(T)


def render_session(
    folder: Path,
    seed: int,
    plan: SessionPlan | None = None,
    block: CrenellatedBlock | None = None,
    arm: ArmModel | None = None,
) -> JsonObject:
    """Writes a session folder with ``truth.json`` and returns the truth.

    Args:
        folder: made where it is missing; files of these names are replaced.
        seed: another number, another session.
        plan: what kind of session; see ``SessionPlan``.
        block: the certificate, drawn at random where not given.
        arm: the arm as its datasheet has it, drawn at random where not given.

    Raises:
        UnreachableError: the arm cannot do the session; take another seed.
    """
    plan = plan or SessionPlan()
    return render_rig_session(folder, seed, draw_rig(seed, plan, block, arm), plan)


def render_rig_session(folder: Path, seed: int, rig: SimulatedRig, plan: SessionPlan) -> JsonObject:
    """A session of a given arm, sensor and block; as ``render_session``."""
    rng = np.random.default_rng(seed + 77_000)
    (folder / "images").mkdir(parents=True, exist_ok=True)
    write_document(folder / "arm.json", arm_datasheet(rig.nominal_arm))
    drawn = block_datasheet(rig.certificate, plan.certificate_sd_mm)
    if plan.tolerance_mm is not None:
        del drawn["standard_uncertainty_mm"]
        drawn["tolerance_mm"] = plan.tolerance_mm
    write_document(folder / "object.json", drawn)
    write_document(folder / "sensor.json", sensor_datasheet(rig.optics, rig.light_plane))
    angles = [f"q{i + 1}_deg" for i in range(rig.arm.joint_count)]
    images = _take_images(folder, seed, rig, plan, rng)
    write_table(folder / "images.csv", ["pose", "file", "lighting", *angles], images)
    features, contact_q_rad = touch_block(rig, plan, rng)
    contacts = [[f, *q.tolist()] for f, q in zip(features, np.degrees(contact_q_rad), strict=True)]
    write_table(folder / "probing.csv", ["feature", *angles], contacts)
    truth = ground_truth(rig)
    write_document(folder / "truth.json", truth)
    return truth


def read_encoders_rad(
    rig: SimulatedRig, plan: SessionPlan, q_rad: Floats, rng: np.random.Generator
) -> Floats:
    """What the encoders say while the joints are at ``q_rad``."""
    noise = rng.normal(0.0, rig.arm.encoder_sd_rad, len(q_rad)) if plan.encoder_noise else 0.0
    return np.asarray(q_rad + noise)


def _take_images(
    folder: Path, seed: int, rig: SimulatedRig, plan: SessionPlan, rng: np.random.Generator
) -> list[list[object]]:
    renderer = Renderer(
        block_scene(rig, plan.light), rig.optics, rig.light_plane, plan.detector, seed
    )
    kinds = {
        "pair": (("ambient", 1.0, 0.0), ("laser", 0.0, 1.0)),
        "both": (("both", 1.0, 1.0),),
    }[plan.lighting]
    rows: list[list[object]] = []
    q = np.zeros(rig.arm.joint_count)
    for pose in range(plan.poses):
        turned = plan.tilts_deg[pose] if plan.tilts_deg else (0.0, 0.0, 0.0)
        spread = 1.0 if pose == 0 or plan.tilts_deg else 3.0
        T_arm_sensor, q = _draw_reachable_pose(rig, spread, q, rng, turned)
        degrees = np.degrees(read_encoders_rad(rig, plan, q, rng)).tolist()
        for lighting, room, laser in kinds:
            name = f"images/pose{pose:02d}_{lighting}.png"
            cv2.imwrite(str(folder / name), renderer.render(T_arm_sensor, room, laser))
            rows.append([pose, name, lighting, *degrees])
    return rows


def _draw_reachable_pose(
    rig: SimulatedRig,
    spread: float,
    q_rad: Floats,
    rng: np.random.Generator,
    turned_deg: tuple[float, float, float] = (0.0, 0.0, 0.0),
) -> tuple[Floats, Floats]:
    """A sensor pose over the block, and joint angles for it."""
    for _ in range(TRIES):
        T_arm_sensor = draw_sensor_pose(rig, rng, spread, turned_deg)
        with suppress(UnreachableError):
            target = T_arm_sensor @ np.linalg.inv(rig.T_flange_sensor)
            return T_arm_sensor, solve_joints(rig.arm, target, q_rad, rng)
    raise UnreachableError("the arm cannot hold the sensor over the block")


def touch_block(
    rig: SimulatedRig,
    plan: SessionPlan,
    rng: np.random.Generator,
    start_rad: Floats | None = None,
) -> tuple[tuple[str, ...], Floats]:
    """The face of each contact, and the encoder angles (N, n) in rad that were read there.

    Args:
        start_rad: joint angles (n,) from which the arm comes, whose posture it keeps if it can.

    Raises:
        UnreachableError: the arm cannot touch a face.
    """
    features: list[str] = []
    readings: list[Floats] = []
    radius = rig.arm.tip_diameter_mm / 2
    q = np.zeros(rig.arm.joint_count) if start_rad is None else start_rad
    for face in plan.faces:
        for i in range(plan.contacts_per_face):
            spot = choose_contact_point(rig.block, face, i, radius, rng)
            gap = radius + float(rng.normal(0.0, plan.contact_sd_mm))
            q = _contact_joints(rig, face, spot, gap, q, rng)
            features.append(face)
            readings.append(read_encoders_rad(rig, plan, q, rng))
    return tuple(features), np.array(readings)


def _contact_joints(
    rig: SimulatedRig,
    face: str,
    spot: Floats,
    gap_mm: float,
    q_rad: Floats,
    rng: np.random.Generator,
) -> Floats:
    """Joint angles with the ball on a spot; holds the stylus otherwise where out of reach."""
    for _ in range(TRIES):
        target = contact_pose(rig.arm, rig.T_arm_obj, face, spot, gap_mm, rng)
        with suppress(UnreachableError):
            return solve_joints(rig.arm, target, q_rad, rng, attempts=12)
    raise UnreachableError(f"the arm cannot touch the {face} face at {spot.round(1).tolist()}")


def ground_truth(rig: SimulatedRig) -> JsonObject:
    """Where the light that fell on a grid of pixels came from, and everything else true."""
    width = rig.block.edges_x_mm[-1] - rig.block.edges_x_mm[0]
    height = rig.block.crest_z_mm - rig.block.floor_z_mm
    middle = (rig.block.edges_x_mm[-1] + rig.block.edges_x_mm[0]) / 2
    x = middle + width * np.linspace(-0.43, 0.43, 15)
    z = np.linspace(-0.5 * height - 6.0, 0.5 * height + 6.0, 11)
    grid_z, grid_x = (axis.ravel() for axis in np.meshgrid(z, x, indexing="ij"))
    n = np.array(rig.light_plane.normal)
    y = (rig.light_plane.offset_mm - n[0] * grid_x - n[2] * grid_z) / n[1]
    points = np.column_stack([grid_x, y, grid_z])
    pixels = to_pixels(rig.optics, points)
    size = np.array([rig.optics.width_px, rig.optics.height_px])
    seen = np.all((pixels > -0.5) & (pixels < size - 0.5), axis=1)
    T = rig.T_flange_sensor
    return {
        "pixels": pixels[seen].tolist(),
        "points_sensor_frame_mm": points[seen].tolist(),
        "points_flange_frame_mm": (points[seen] @ T[:3, :3].T + T[:3, 3]).tolist(),
        "T_arm_obj": rig.T_arm_obj.tolist(),
        "T_flange_sensor": T.tolist(),
        "camera": {
            "matrix": rig.optics.matrix.tolist(),
            "distortion": list(rig.optics.distortion),
            "T_cam_sensor": rig.optics.T_cam_sensor.tolist(),
        },
        "laser_plane": {
            "normal": list(rig.light_plane.normal),
            "offset_mm": rig.light_plane.offset_mm,
        },
        "block": block_datasheet(rig.block, 0.0),
    }


def render_scan(
    rig: SimulatedRig,
    shape: ObjectShape,
    T_arm_shape: Floats,
    path: Sequence[Floats],
    plan: SessionPlan | None = None,
    seed: int = 0,
) -> Iterator[ScanFrame]:
    """Laser images of a shape along a path of sensor poses, with the joints of each.

    Args:
        rig: arm and sensor, as from ``draw_rig``.
        shape: what is scanned, e.g. ``Ball()`` or a ``Box`` whose top is a gauge plane.
        T_arm_shape: (4, 4) where it stands.
        path: ``T_arm_sensor`` (4, 4) of each frame.
    """
    plan = plan or SessionPlan()
    rng = np.random.default_rng(seed)
    scene = SimulatedScene((SceneObject("part", shape, T_arm_shape),), plan.light)
    renderer = Renderer(scene, rig.optics, rig.light_plane, plan.detector, seed)
    q = np.zeros(rig.arm.joint_count)
    for T_arm_sensor in path:
        q = solve_joints(rig.arm, T_arm_sensor @ np.linalg.inv(rig.T_flange_sensor), q, rng)
        image = renderer.render(T_arm_sensor, room=0.0, laser=1.0)
        yield ScanFrame(image, read_encoders_rad(rig, plan, q, rng))
