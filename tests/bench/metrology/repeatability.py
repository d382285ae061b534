"""The article's test: the same clouds of a plane, rebuilt with ten calibrations each.

Whatever a calibration has wrong shows as a plane that turns and shifts from one
calibration to the next (the article, section 4: 230″ and 100 µm, with one pose).
"""

from dataclasses import dataclass, replace

import numpy as np

from crenel.gauges.quick.maths.errors import angle_ranges_arcsec, offset_ranges_um
from crenel.metrology.adjustment.core.gauss_newton import AdjustmentResult, solve_adjustment
from crenel.metrology.adjustment.core.parameters import pose_scene
from crenel.metrology.arm.kinematics import Arm, flange_poses
from crenel.metrology.fitting.plane_sphere import fit_plane
from crenel.metrology.probing.alignment import align
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.transforms import Floats, apply, inverse, rigid
from crenel.progress import Progress, no_progress
from crenel_hardware.simulator.devices.kinematics import UnreachableError, perturb_arm, solve_joints
from crenel_hardware.simulator.session import SimulatedRig, draw_sensor_pose
from tests.bench.metrology.simulated import (
    SetUp,
    SimulatedSetup,
    design_setup,
    draw_session,
    draw_setup_rig,
)

ARM_UM = 250.0
CLOUDS, FRAMES, POINTS, STEP_MM = 10, 12, 30, 5.0
ARTICLE_ARCSEC, ARTICLE_UM = 230.0, 100.0
METHODS = (
    ("the article's method, one pose", 1, True),
    ("joint, one pose", 1, False),
    ("joint, 8 poses", 8, False),
    ("joint, 20 poses", 20, False),
)
COLUMNS = ("calibrations of one arm", "range of the angle", "range of the offset")


@dataclass(frozen=True)
class CalibrationRanges:
    """Over the calibrations: how far a plane turns and shifts, median over the arms."""

    method: str
    angle_arcsec: float
    offset_um: float


@dataclass(frozen=True)
class _Cloud:
    """Stripe pixels (F, N, 2) of a plane, and what the encoders said at each frame (F, n)."""

    uv_px: Floats
    q_rad: Floats


def run(
    arms: int, progress: Progress = no_progress, calibrations: int = 10
) -> list[CalibrationRanges]:
    """``calibrations`` by each method on each of ``arms`` whose models are 250 µm off."""
    found: dict[str, list[tuple[float, float]]] = {name: [] for name, _, _ in METHODS}
    seed, done = 200, 0
    while done < arms:
        seed += 1
        try:
            rig = _rig(seed)
            clouds = [_cloud(rig, np.random.default_rng([seed, i])) for i in range(CLOUDS)]
            own = []
            for k, (name, poses, alone) in enumerate(METHODS):
                progress((done + k / len(METHODS)) / arms, f"arm {done + 1}: {name}")
                own.append(_ranges(rig, seed, poses, alone, calibrations, clouds))
        except UnreachableError:
            continue
        for (name, _, _), ranges in zip(METHODS, own, strict=True):
            found[name].append(ranges)
        done += 1
    medians = {name: np.median(np.array(values), axis=0) for name, values in found.items()}
    return [
        CalibrationRanges(name, float(median[0]), float(median[1]))
        for name, median in medians.items()
    ]


def table(results: list[CalibrationRanges]) -> list[tuple[str, ...]]:
    """Rows to print, the article's own figures last."""
    rows = [(one.method, f"{one.angle_arcsec:.0f}″", f"{one.offset_um:.0f} µm") for one in results]
    article = ("the article, on real hardware", f"{ARTICLE_ARCSEC:.0f}″", f"{ARTICLE_UM:.0f} µm")
    return [*rows, article]


def _rig(seed: int) -> SimulatedRig:
    rig = draw_setup_rig(SetUp("", 1), seed)
    return replace(rig, arm=perturb_arm(rig.nominal_arm, ARM_UM, np.random.default_rng(seed)))


def _link_errors(rig: SimulatedRig) -> Floats:
    """(6n,) turn and shift of each link's error, as the adjustment orders them."""
    errors = np.array([link.error_mm_rad for link in rig.arm.links])
    return np.concatenate([errors[:, 3:], errors[:, :3]], axis=1).ravel()


def _cloud(rig: SimulatedRig, rng: np.random.Generator) -> _Cloud:
    """A sweep of the true arm over a plane through the middle of the block."""
    length = float(np.linalg.norm(rig.light_plane.normal))
    normal, offset_mm = (
        np.array(rig.light_plane.normal) / length,
        rig.light_plane.offset_mm / length,
    )
    height = (rig.block.crest_z_mm + rig.block.floor_z_mm) / 2
    first, q = draw_sensor_pose(rig, rng, 4.0), np.zeros(rig.arm.joint_count)
    x = np.linspace(-18.0, 18.0, POINTS)
    pixels, angles = [], []
    for frame in range(FRAMES):
        T = first.copy()
        T[:3, 3] += rig.T_arm_obj[:3, 1] * (frame - FRAMES / 2) * STEP_MM
        q = solve_joints(rig.arm, T @ np.linalg.inv(rig.T_flange_sensor), q, rng)
        T_sensor_obj = np.linalg.inv(T) @ rig.T_arm_obj
        n = T_sensor_obj[:3, :3].T @ normal
        y = (offset_mm - normal @ T_sensor_obj[:3, 3] - n[0] * x - n[2] * height) / n[1]
        camera = _camera(rig, np.array(rig.optics.T_cam_sensor) @ T_sensor_obj)
        pixels.append(project(camera, np.column_stack([x, y, np.full(POINTS, height)])))
        angles.append(q + rng.normal(0.0, rig.arm.encoder_sd_rad, len(q)))
    return _Cloud(np.array(pixels), np.array(angles))


def _camera(rig: SimulatedRig, T_cam_obj: Floats) -> Camera:
    o = rig.optics
    K = np.array([[o.fx_px, 0, o.cx_px], [0, o.fy_px, o.cy_px], [0, 0, 1.0]])
    R, t = T_cam_obj[:3, :3], T_cam_obj[:3, 3]
    return Camera(K, R, t, o.width_px, o.height_px, np.array(o.distortion))


def _ranges(
    rig: SimulatedRig, seed: int, poses: int, alone: bool, calibrations: int, clouds: list[_Cloud]
) -> tuple[float, float]:
    """Mean over the clouds of the range over the calibrations: angle, offset."""
    planes = []
    for i in range(calibrations):
        station = _design_setup(rig, poses, np.random.default_rng([seed, poses, i]))
        draw = draw_session(station, np.random.default_rng([seed, i]), links=_link_errors(rig))
        found = solve_adjustment(draw.problem, draw.start)
        X = _place_by_contacts(station, found) if alone else found.state.T_flange_cam
        camera, plane = found.state.camera, found.state.plane
        planes.append([_fit_plane(rig, station.arm, camera, plane, X, cloud) for cloud in clouds])
    normals = np.array([[n for n, _ in one] for one in planes])  # (C, clouds, 3)
    offsets = np.array([[d for _, d in one] for one in planes])
    return float(angle_ranges_arcsec(normals).mean()), float(offset_ranges_um(offsets).mean())


def _design_setup(rig: SimulatedRig, poses: int, rng: np.random.Generator) -> SimulatedSetup:
    for _ in range(20):
        try:
            return design_setup(SetUp("", poses), replace(rig, arm=rig.nominal_arm), rng)
        except UnreachableError:
            continue
    raise UnreachableError("the arm cannot do this calibration")


def _place_by_contacts(station: SimulatedSetup, found: AdjustmentResult) -> Floats:
    """``T_flange_cam`` as the article has it: contacts alone place the object (Eq. 8)."""
    touches = found.problem.contacts
    assert touches is not None
    alignment = align(
        touches.features, touches.tips_mm, touches.radius_mm, station.certificate, touches.noise_mm2
    )
    camera = pose_scene(found.state, found.problem, found.layout, 0).camera
    T_cam_obj = rigid(camera.rotation, camera.translation_mm)
    T_arm_flange = found.problem.motion.T_arm_flange[0]
    return np.asarray(inverse(T_arm_flange) @ alignment.T_arm_obj @ inverse(T_cam_obj))


def _fit_plane(
    rig: SimulatedRig,
    arm: Arm,
    camera: Camera,
    plane: LaserPlane,
    T_flange_cam: Floats,
    cloud: _Cloud,
) -> tuple[Floats, float]:
    """Normal (3,) of a cloud's plane, and its offset (mm) at the block."""
    T_arm_flange = flange_poses(arm, cloud.q_rad)
    points = np.concatenate(
        [
            apply(T @ T_flange_cam, sensor_points(camera, plane, uv))
            for T, uv in zip(T_arm_flange, cloud.uv_px, strict=True)
        ]
    )
    up = rig.T_arm_obj[:3, 2]
    fit = fit_plane(points)
    normal = fit.normal * np.sign(fit.normal @ up)
    return normal, float((points.mean(axis=0) - rig.T_arm_obj[:3, 3]) @ up)
