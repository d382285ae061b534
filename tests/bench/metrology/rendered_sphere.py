"""A one-sphere test on the rendered simulated station: its pictures are measured as any others.

The pictures are rendered once; a fault is a difference between the station as it is and what its
datasheets and its calibration state, so the same recordings serve every fault.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.recording.writer import RecordingWriter
from crenel.formats.results.calibration import CalibrationFile
from crenel.formats.session.calibration_session import contact_readings, write_contacts
from crenel.gauges.plan.document import ARTICULATIONS, PLAN, TOUCHES, SpherePart, sphere_scan
from crenel.gauges.sphere.maths_articulation import articulation_directions
from crenel.metrology.stripe import Stripe
from crenel.metrology.stripe.extraction import extract_stripe
from crenel.metrology.transforms import Floats
from crenel.progress import Progress, no_progress
from crenel_hardware.simulator.configuration import SimulationConfig, build_rig
from crenel_hardware.simulator.devices.kinematics import (
    ArmModel,
    UnreachableError,
    follow_poses,
    rotation_about,
    solve_joints,
    translation,
)
from crenel_hardware.simulator.operator.on_sphere import plan_view
from crenel_hardware.simulator.rendering.render import Renderer
from crenel_hardware.simulator.scene.datasheets import arm_datasheet, stripe_axis, write_document
from crenel_hardware.simulator.scene.tabletop import build_table_scene, part_pose
from crenel_hardware.simulator.scene.world import GaugeSphere
from crenel_hardware.simulator.session import SimulatedRig
from tests.bench.metrology.synthetic_sphere import (
    FRAME_NS,
    POLE,
    PlantedFaults,
    TouchGroup,
    sphere_plan,
    touch_groups,
)

SPHERE_HEIGHT_MM = 34.0
CONTACT_SD_MM = 0.003
TOUCH_SAMPLES = 100
"""Of the encoders, that one touch is the mean of."""
FAULTLESS = PlantedFaults()
TRIES = 60
OUTLIER_MM = 0.25
"""Points that are false lie up to this far off the line, as the camera sees them."""


@dataclass(frozen=True, eq=False)
class RenderedScan:
    """One scan: the stripe of each picture, and where the arm truly was."""

    stripes: tuple[Stripe, ...]
    q_rad: Floats
    """(F, n) encoder angles."""
    T_arm_sensor: Floats
    """(F, 4, 4) as they truly are."""


class RenderedStation:
    """A station with a sphere on its table, whose every scan is rendered once.

    Args:
        width_px, height_px: of the pictures.
        frames: of each pass.

    Raises:
        UnreachableError: the arm cannot scan the sphere.
    """

    def __init__(
        self,
        width_px: int = 1280,
        height_px: int = 1024,
        frames: int = 80,
        seed: int = 1,
        progress: Progress = no_progress,
    ) -> None:
        config = SimulationConfig(
            seed=seed, imperfection_um=0.0, width_px=width_px, height_px=height_px
        )
        self._seed, self._random = seed, np.random.default_rng(seed)
        self.touched_rad: dict[str, Floats] = {}
        """Encoder angles (N, n) of the latest touches by their feature."""
        self.rig, self._home_rad = build_rig(config, self._random)
        self._scene = build_table_scene(
            self.rig.block, self.rig.T_arm_obj, config.board, np.eye(4), config.light
        )
        self.T_arm_sphere = part_pose("sphere", SPHERE_HEIGHT_MM)
        ball = self._scene.find_object("sphere").shape
        assert isinstance(ball, GaugeSphere)
        self.radius_mm = ball.radius_mm
        self.sphere = SpherePart(
            name="Simulated sphere",
            serial_number="TWIN-K1",
            certificate="simulated",
            diameter_mm=2 * ball.radius_mm,
            diameter_sd_um=0.2,
            form_um=0.4,
        )
        renderer = Renderer(
            self._scene, self.rig.optics, self.rig.light_plane, config.detector, seed
        )
        directions = articulation_directions(POLE, -self.centre_mm)
        self.scans: list[RenderedScan] = []
        for number, direction in enumerate(directions, 1):
            progress((number - 1) / ARTICULATIONS, f"rendering scan {number} of {ARTICULATIONS}")
            self.scans.append(self._scan(renderer, direction, frames))

    @property
    def centre_mm(self) -> Floats:
        """(3,) of the sphere, arm frame."""
        return np.asarray(self.T_arm_sphere[:3, 3])

    def _scan(self, renderer: Renderer, direction: Floats, frames: int) -> RenderedScan:
        rig = self.rig
        poses, q_rad = self._pass(direction, frames)
        axis = stripe_axis(rig.optics, rig.light_plane)
        stripes = [extract_stripe(renderer.render(T, room=0.0, laser=1.0), axis) for T in poses]
        return RenderedScan(tuple(stripes), self._read_encoders(q_rad), poses)

    def _pass(self, direction: Floats, frames: int) -> tuple[Floats, Floats]:
        """Sensor poses (F, 4, 4) and joint angles (F, n) of a pass in a direction."""
        rig, share = self.rig, np.linspace(0.0, 1.0, frames)[:, None]
        in_sphere = self.T_arm_sphere[:3, :3].T @ direction
        for sweep in plan_view(self.radius_mm, in_sphere, rig.optics.centre_mm):
            poses = np.tile(sweep.start, (frames, 1, 1))
            poses[:, :3, 3] = (1 - share) * sweep.start[:3, 3] + share * sweep.end[:3, 3]
            poses = self.T_arm_sphere @ poses
            targets = poses @ np.linalg.inv(rig.T_flange_sensor)
            try:
                start = solve_joints(rig.arm, targets[0], self._home_rad, self._random)
                return poses, follow_poses(rig.arm, targets, start)
            except UnreachableError:
                continue
        raise UnreachableError("the arm cannot scan the sphere from there")

    def _read_encoders(self, q_rad: Floats, samples: int = 1) -> Floats:
        sd_rad = self.rig.arm.encoder_sd_rad / np.sqrt(samples)
        return np.asarray(q_rad + self._random.normal(0.0, sd_rad, q_rad.shape))

    def write(self, folder: Path, faults: PlantedFaults = FAULTLESS) -> Path:
        """The folder of a one-sphere test with faults; the noise is the same each time."""
        folder.mkdir(parents=True)
        sphere_plan(self.sphere).write(folder / PLAN)
        write_document(folder / "arm.json", arm_datasheet(with_wrong_link(self.rig, faults)))
        write_calibration(folder / "calibration.json", self.rig, faults)
        groups = touch_groups(self.centre_mm, np.array(faults.moved_mm))
        self.write_touches(folder, groups, faults)
        for number, scan in enumerate(self.scans, 1):
            self._write_scan(folder / sphere_scan(1, number), scan, faults)
        return folder

    def write_touches(
        self, folder: Path, groups: Sequence[TouchGroup], faults: PlantedFaults
    ) -> None:
        """``touches.csv`` of spheres of the same size; the noise is the same each time."""
        self._random = np.random.default_rng(self._seed)
        features: list[str] = []
        readings: list[Floats] = []
        for group in groups:
            features += [group.feature] * len(group.outward)
            q_rad = [self._touch(group, one, faults) for one in group.outward]
            self.touched_rad[group.feature] = np.array(q_rad)
            readings += q_rad
        arm = read_any_arm(folder / "arm.json")
        write_contacts(folder / TOUCHES, contact_readings(features, arm, np.array(readings)))

    def _touch(self, group: TouchGroup, outward: Floats, faults: PlantedFaults) -> Floats:
        """Encoder angles (n,) with the true tip in contact."""
        arm = self.rig.arm
        reach = self.radius_mm + (arm.tip_diameter_mm + faults.tip_excess_mm) / 2
        reach += self._random.normal(0.0, CONTACT_SD_MM)
        stylus = outward + POLE if group.stylus_from is None else group.stylus_from
        tip = np.array(arm.tip_mm)
        for _ in range(TRIES):
            R = _orient(tip, -stylus, float(self._random.uniform(-np.pi, np.pi)))
            T = np.eye(4)
            T[:3, :3] = R
            T[:3, 3] = group.centre_mm + reach * outward - R @ tip
            try:
                q_rad = solve_joints(arm, T, self._home_rad, self._random, attempts=3)
                return self._read_encoders(q_rad, TOUCH_SAMPLES)
            except UnreachableError:
                continue
        raise UnreachableError("the arm cannot touch the sphere like that")

    def _write_scan(self, folder: Path, scan: RenderedScan, faults: PlantedFaults) -> None:
        folder.mkdir()
        optics = self.rig.optics
        names = [f"J{i + 1}" for i in range(self.rig.arm.joint_count)]
        with RecordingWriter(folder / "scan.mcap", names) as writer:
            for i, (stripe, q) in enumerate(zip(scan.stripes, scan.q_rad, strict=True)):
                stamp_ns = 10**9 + i * FRAME_NS
                for ms in (-4, 4):
                    writer.reading(stamp_ns + ms * 10**6, q)
                if len(stripe.u):
                    spoilt = self._with_outliers(stripe, faults.outliers)
                    writer.stripe(stamp_ns, spoilt, optics.width_px, optics.height_px)

    def _with_outliers(self, stripe: Stripe, share: float) -> Stripe:
        optics = self.rig.optics
        most_px = OUTLIER_MM * optics.fx_px / float(np.linalg.norm(optics.centre_mm))
        wrong = self._random.random(len(stripe.u)) < share
        off = wrong * self._random.uniform(-most_px, most_px, len(stripe.u))
        u, v = stripe.uv_px.T + stripe.across[:, None] * off
        return replace(stripe, u=u, v=v)


def with_wrong_link(rig: SimulatedRig, faults: PlantedFaults) -> ArmModel:
    """The arm by a datasheet that has its second link shorter than it is."""
    links = list(rig.nominal_arm.links)
    links[1] = replace(links[1], a_mm=links[1].a_mm - faults.link_mm)
    return replace(rig.nominal_arm, links=tuple(links))


def write_calibration(path: Path, rig: SimulatedRig, faults: PlantedFaults) -> None:
    """What the sensor is, but for the faults: the matrix is off, or lengths are too large."""
    optics, plane = rig.optics, rig.light_plane
    T = optics.T_cam_sensor.copy()
    T[:3, 3] *= faults.scale
    matrix = rig.T_flange_sensor @ translation(*(-np.array(faults.matrix_offset_mm)).tolist())
    document = {
        "format": "crenel/calibration",
        "version": 1,
        "camera": {
            "projection_matrix": (optics.matrix @ T[:3]).tolist(),
            "matrix": optics.matrix.tolist(),
            "rotation": T[:3, :3].tolist(),
            "translation_mm": T[:3, 3].tolist(),
            "distortion": list(optics.distortion),
            "width_px": optics.width_px,
            "height_px": optics.height_px,
        },
        "laser_plane": {"normal": list(plane.normal), "offset_mm": plane.offset_mm * faults.scale},
        "probe_matrix": matrix.tolist(),
        "stripe_axis": stripe_axis(optics, plane),
        "serial_numbers": {"arm": rig.arm.serial_number, "object": "TWIN-B1", "sensor": "TWIN-S1"},
    }
    CalibrationFile.model_validate(document).write(path)


def _orient(direction: Floats, wanted: Floats, turn_rad: float) -> Floats:
    """A rotation (3, 3) that lays one direction on another, turned about it."""
    return np.asarray(_axes(wanted) @ rotation_about("z", turn_rad)[:3, :3] @ _axes(direction).T)


def _axes(direction: Floats) -> Floats:
    z = direction / np.linalg.norm(direction)
    x = np.cross(z, np.eye(3)[int(np.argmin(np.abs(z)))])
    x /= np.linalg.norm(x)
    return np.column_stack([x, np.cross(z, x), z])
