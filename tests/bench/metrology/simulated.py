"""Calibration sessions simulated without pictures: what would be measured, with its noise.

Arm, sensor and block are drawn by the simulator; edge points, stripe points and contacts are
then drawn as the adjustment takes them to be, so that its claims can be checked against
hundreds of solves.
"""

import json
import tempfile
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

import numpy as np

from crenel.formats.datasheets.arm import read_arm
from crenel.formats.datasheets.target import read_block
from crenel.metrology.adjustment.block.observations import BlockView, block_contacts, block_prior
from crenel.metrology.adjustment.block.predicted_view import ObservationNoise, predict_view
from crenel.metrology.adjustment.core.arm_errors import arm_motion
from crenel.metrology.adjustment.core.observations import AdjustmentProblem
from crenel.metrology.adjustment.core.parameters import AdjustmentState
from crenel.metrology.adjustment.core.variance_components import Scales
from crenel.metrology.arm.kinematics import (
    Arm,
    Joint,
    flange_poses,
    geometric_jacobians,
    tip_centres,
)
from crenel.metrology.arm.link_error import LinkError
from crenel.metrology.calibration.observation_model import SHARED_EDGE_PX, with_coordinates
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.targets.crenellated_block import Crenellated, probing_face
from crenel.metrology.transforms import Floats, apply, inverse, rigid, rotation_from_vector
from crenel_hardware.simulator.devices.kinematics import UnreachableError, solve_joints
from crenel_hardware.simulator.operator.contact import choose_contact_point, contact_pose
from crenel_hardware.simulator.scene.datasheets import arm_datasheet, block_datasheet
from crenel_hardware.simulator.session import SessionPlan, SimulatedRig, draw_rig, draw_sensor_pose

# How far a start may be off: focal length (share), mounting and place (mm, rad).
START_FOCAL, START_MM, START_RAD = 0.01, 0.5, 0.004
TRIES = 30
USUAL = Scales(links_rad=7.5e-6, links_mm=0.003, noise=1.0, touch_mm=0.004)


@dataclass(frozen=True)
class SetUp:
    """What kind of calibration is simulated; the rest follows from the seed."""

    name: str
    poses: int
    joints: int = 6
    faces: tuple[str, ...] = ("crest", "front", "left")
    contacts_per_face: int = 12
    roll_rad: float = 0.0
    distortion: tuple[float, float, float, float, float] = (-0.04, 0.0, 0.0, 0.0, 0.0)
    scales: Scales = USUAL
    """What the noise is drawn with."""
    tolerance_mm: float | None = None
    """Nobody measured the block: it is made within this, and the certificate is its drawing."""
    seed: int = 1


@dataclass(frozen=True)
class SimulatedSetup:
    """A set-up as designed: true sensor, block by its certificate, joint angles."""

    setup: SetUp
    arm: Arm
    certificate: Crenellated
    camera: Camera  # its own frame as sensor frame
    plane: LaserPlane
    T_flange_cam: Floats
    T_arm_obj: Floats
    features: tuple[str, ...]
    contact_q_rad: Floats
    spots_mm: Floats  # (N, 3) where each contact is, object frame
    q_rad: Floats  # (P, n)
    view_model: ObservationNoise


def draw_setup(setup: SetUp) -> SimulatedSetup:
    """Draws a station whose arm can do the set-up."""
    for attempt in range(TRIES):
        seed = setup.seed + 1000 * attempt
        try:
            return design_setup(setup, draw_setup_rig(setup, seed), np.random.default_rng(seed))
        except UnreachableError:
            continue
    raise UnreachableError(f"no arm was found that can do {setup.name}")


def draw_setup_rig(setup: SetUp, seed: int) -> SimulatedRig:
    """Arm, sensor and block of a set-up."""
    plan = SessionPlan(joints=setup.joints, roll_rad=setup.roll_rad, distortion=setup.distortion)
    return draw_rig(seed, plan)


def design_setup(setup: SetUp, rig: SimulatedRig, rng: np.random.Generator) -> SimulatedSetup:
    """Where the contacts are taken and how the sensor is held.

    Raises:
        UnreachableError: the arm cannot do it.
    """
    arm, certificate = _read_datasheets(rig, setup.tolerance_mm)
    T_cam_sensor = np.array(rig.optics.T_cam_sensor)
    optics = rig.optics
    K = np.array([[optics.fx_px, 0, optics.cx_px], [0, optics.fy_px, optics.cy_px], [0, 0, 1.0]])
    camera = Camera(
        K, np.eye(3), np.zeros(3), optics.width_px, optics.height_px, np.array(optics.distortion)
    )
    normal = T_cam_sensor[:3, :3] @ np.array(rig.light_plane.normal)
    length = float(np.linalg.norm(normal))
    offset = (rig.light_plane.offset_mm + normal @ T_cam_sensor[:3, 3]) / length
    features, spots, contact_q = _contacts(rig, setup, rng)
    stripe_axis = "u" if abs(np.sin(setup.roll_rad)) < 0.7 else "v"
    return SimulatedSetup(
        setup,
        arm,
        certificate,
        camera,
        LaserPlane(normal / length, float(offset)),
        rig.T_flange_sensor @ np.linalg.inv(T_cam_sensor),
        rig.T_arm_obj,
        features,
        contact_q,
        spots,
        _hold_joints(rig, setup, rng),
        ObservationNoise(axis=stripe_axis),
    )


def _read_datasheets(rig: SimulatedRig, tolerance_mm: float | None) -> tuple[Arm, Crenellated]:
    with tempfile.TemporaryDirectory() as folder:
        arm, block = Path(folder, "arm.json"), Path(folder, "object.json")
        arm.write_text(json.dumps(arm_datasheet(rig.nominal_arm)))
        drawn = block_datasheet(rig.certificate, 0.002)
        if tolerance_mm is not None:
            del drawn["standard_uncertainty_mm"]
            drawn["tolerance_mm"] = tolerance_mm
        block.write_text(json.dumps(drawn))
        return read_arm(arm), read_block(block)


def _contacts(
    rig: SimulatedRig, setup: SetUp, rng: np.random.Generator
) -> tuple[tuple[str, ...], Floats, Floats]:
    features, spots, angles = [], [], []
    radius = rig.arm.tip_diameter_mm / 2
    q = np.zeros(rig.arm.joint_count)
    for face in setup.faces:
        for i in range(setup.contacts_per_face):
            spot = choose_contact_point(rig.certificate, face, i, radius, rng)
            touching = partial(
                contact_pose, rig.nominal_arm, rig.T_arm_obj, face, spot, radius, rng
            )
            q = _reach_target(rig, touching, q, rng)
            features.append(face)
            spots.append(spot)
            angles.append(q)
    return tuple(features), np.array(spots), np.array(angles)


def _hold_joints(rig: SimulatedRig, setup: SetUp, rng: np.random.Generator) -> Floats:
    q, angles = np.zeros(rig.arm.joint_count), []
    for pose in range(setup.poses):
        held = partial(_flange_pose_over, rig, rng, 1.0 if pose == 0 else 5.0)
        q = _reach_target(rig, held, q, rng)
        angles.append(q)
    return np.array(angles)


def _flange_pose_over(rig: SimulatedRig, rng: np.random.Generator, spread: float) -> Floats:
    """The flange's pose (4, 4) with the sensor over the block."""
    return np.asarray(draw_sensor_pose(rig, rng, spread) @ np.linalg.inv(rig.T_flange_sensor))


def _reach_target(
    rig: SimulatedRig, target: Callable[[], Floats], q_rad: Floats, rng: np.random.Generator
) -> Floats:
    """Joint angles for a target that is drawn again where it is out of reach."""
    for _ in range(TRIES):
        try:
            return solve_joints(rig.arm, target(), q_rad, rng, attempts=12)
        except UnreachableError:
            continue
    raise UnreachableError("the arm cannot do this set-up")


@dataclass(frozen=True)
class Draw:
    """One simulated session: what is true, what was measured, and where a solve starts."""

    truth: AdjustmentState
    problem: AdjustmentProblem
    start: AdjustmentState


def draw_session(
    station: SimulatedSetup,
    rng: np.random.Generator,
    noisy: bool = True,
    links: Floats | None = None,
) -> Draw:
    """A session of a station: the arm's links, the block and all noise drawn again.

    Without noise everything is as the datasheets have it, for the bound at the truth;
    ``links`` (6n,) are the errors of one arm that is the same in every session.
    """
    scales = station.setup.scales
    share = 1.0 if noisy else 0.0
    if links is None:
        sd = share * scales.link_error_sds(station.arm.joint_count)
        links = sd * rng.normal(size=len(sd))
    arm = _with_links(station.arm, links)
    prior = block_prior(station.certificate)
    off = prior.sd * rng.normal(size=len(prior.sd))
    if (tolerance_mm := station.setup.tolerance_mm) is not None:
        off = rng.uniform(-tolerance_mm, tolerance_mm, len(prior.sd))
    values = prior.coordinates + share * off
    block = with_coordinates(station.certificate, values)
    contact_q = _contact_joints(station, arm, block, share * scales.touch_mm, rng)
    encoders = share * scales.noise * station.arm.encoder_sd_rad
    T_arm_cam = flange_poses(arm, station.q_rad) @ station.T_flange_cam
    views = tuple(
        _simulate_view(station, block, inverse(T) @ station.T_arm_obj, rng, share)
        for T in T_arm_cam
    )
    read_q = station.q_rad + encoders * rng.normal(size=station.q_rad.shape)
    read_contacts = contact_q + encoders * rng.normal(size=contact_q.shape)
    kept = np.ones(len(station.features), dtype=np.bool_)
    moves = arm_motion(station.arm, read_q)
    problem = AdjustmentProblem(
        tuple(range(len(views))),
        views,
        moves,
        block_contacts(station.arm, station.certificate, station.features, read_contacts, kept),
        prior,
        station.camera.width_px,
        station.camera.height_px,
    )
    truth = AdjustmentState(
        station.camera,
        station.plane,
        station.T_flange_cam,
        station.T_arm_obj,
        values,
        links,
        (station.q_rad - read_q) if noisy else np.zeros(station.q_rad.shape),
    )
    return Draw(truth, problem, _draw_start(truth, prior.coordinates, rng))


def _with_links(arm: Arm, links: Floats) -> Arm:
    """The arm with an error behind each link, to first order as the adjustment has them."""
    joints: list[Joint] = []
    for joint, (rx, ry, rz, x, y, z) in zip(arm.joints, links.reshape(-1, 6), strict=True):
        joints.append(replace(joint, error=LinkError(x, y, z, rx, ry, rz)))
    return replace(arm, joints=tuple(joints))


def _contact_joints(
    station: SimulatedSetup, arm: Arm, block: Crenellated, touch_mm: float, rng: np.random.Generator
) -> Floats:
    """Joint angles (N, n) at which the true arm's tip touches the true block."""
    faces = [probing_face(block, face) for face in station.features]
    normals, offsets_mm = (np.array(part) for part in zip(*faces, strict=True))
    spots_mm = np.asarray(station.spots_mm)
    off_mm = arm.tip.radius_mm + touch_mm * rng.normal(size=len(faces))
    off_mm += offsets_mm - np.sum(normals * spots_mm, axis=1)
    targets_mm = apply(station.T_arm_obj, spots_mm + off_mm[:, None] * normals)
    q = station.contact_q_rad.copy()
    for _ in range(4):
        miss_mm = targets_mm - tip_centres(arm, q)
        J = geometric_jacobians(arm, q, arm.tip.centre_mm)[:, :3]
        q += np.einsum("nij,nj->ni", np.linalg.pinv(J), miss_mm)
    return q


def _simulate_view(
    station: SimulatedSetup,
    block: Crenellated,
    T_cam_obj: Floats,
    rng: np.random.Generator,
    share: float,
) -> BlockView:
    """A pose's edge and stripe points, with the noise that the adjustment takes them to have."""
    R, t = T_cam_obj[:3, :3], T_cam_obj[:3, 3]
    n = station.plane.normal
    plane = LaserPlane(R.T @ n, float(station.plane.offset_mm - n @ t))
    camera = replace(station.camera, rotation=R, translation_mm=t)
    view = predict_view(camera, plane, block, station.view_model)
    edges = []
    for edge in view.edges:
        off = edge.sigma_px * rng.normal(size=len(edge.sigma_px))
        off = share * (off + SHARED_EDGE_PX * float(rng.normal()))
        edges.append(replace(edge, uv_px=edge.uv_px + off[:, None] * edge.normal))
    stripe = view.stripe
    off = share * stripe.sigma_px * rng.normal(size=len(stripe.u))
    u, v = (stripe.uv_px + off[:, None] * stripe.across).T
    return replace(
        view, block=station.certificate, edges=tuple(edges), stripe=replace(stripe, u=u, v=v)
    )


def _draw_start(
    truth: AdjustmentState, by_prior: Floats, rng: np.random.Generator
) -> AdjustmentState:
    """Off the truth as a first guess is."""
    matrix = truth.camera.matrix.copy()
    matrix[[0, 1], [0, 1]] *= 1 + START_FOCAL * float(rng.uniform(-1, 1))
    camera = replace(truth.camera, matrix=matrix, distortion=np.zeros(5))
    off = [
        rigid(
            rotation_from_vector(rng.uniform(-START_RAD, START_RAD, 3)),
            rng.uniform(-START_MM, START_MM, 3),
        )
        for _ in range(2)
    ]
    return replace(
        truth,
        camera=camera,
        T_flange_cam=truth.T_flange_cam @ off[0],
        T_arm_obj=truth.T_arm_obj @ off[1],
        coordinates=by_prior,
        links=np.zeros_like(truth.links),
        noise=np.zeros_like(truth.noise),
    )
