"""A measured sphere: touches and scans of a one-sphere test, as an arm would record them.

Everything is exact but for the noise and the faults that are planted.
"""

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.recording.writer import RecordingWriter
from crenel.formats.results.calibration import CalibrationFile
from crenel.formats.session.calibration_session import contact_readings, write_contacts
from crenel.gauges.plan.document import (
    PLAN,
    TOUCHES,
    GatePart,
    LimitPart,
    PerformancePlan,
    SpherePart,
    sphere_feature,
    sphere_scan,
)
from crenel.gauges.sphere.maths_articulation import articulation_directions, location_places
from crenel.gauges.sphere.maths_pattern import RIM_DEG, pattern_directions
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.stripe import Stripe
from crenel.metrology.transforms import Floats, inverse, rigid
from tests.bench.metrology.synthetic_arm import TIP, JointArm, PoseArm

CENTRE = np.array([650.0, 120.0, 210.0])
SPHERE = SpherePart(
    name="Ceramic sphere",
    serial_number="K-17",
    certificate="DKD 4711",
    valid_until="2030-01-31",
    diameter_mm=25.0,
    diameter_sd_um=0.2,
    form_um=0.4,
)
WIDTH, HEIGHT = 1280, 1024
DISTANCE_MM = 140.0
POLE = np.array(GatePart().pole)
STYLUS_RAD, HELD_RAD = 0.7, 0.07
"""By how much the stylus is tilted at most, where it is held freely and in an articulation."""
FRAME_NS = 20_000_000
STEP_MM = 0.25
TRIES = 50
T_FLANGE_SENSOR = rigid(
    Rotation.from_euler("xyz", [4, -3, 8], degrees=True).as_matrix(), np.array([30.0, -12.0, 60.0])
)


def true_camera() -> Camera:
    """Looks at the laser plane z = 0 of the sensor frame from 140 mm, inclined by 30°."""
    tilt = np.deg2rad(30)
    rotation = np.array(
        [[1, 0, 0], [0, np.cos(tilt), -np.sin(tilt)], [0, np.sin(tilt), np.cos(tilt)]]
    )
    matrix = np.array([[2600.0, 0, WIDTH / 2], [0, 2600.0, HEIGHT / 2], [0, 0, 1]])
    return Camera(matrix, rotation, np.array([0.0, 0.0, DISTANCE_MM]), WIDTH, HEIGHT)


@dataclass(frozen=True)
class PlantedFaults:
    """What is wrong with a station."""

    matrix_offset_mm: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """The sensor is really this far from where the calibration has it, in its own frame."""
    scale: float = 1.0
    """Lengths that the sensor measures, about the middle of its range."""
    tip_excess_mm: float = 0.0
    """The tip is really this much larger."""
    moved_mm: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """Of the sphere, before the touches at the end."""
    outliers: float = 0.0
    """Share of scanned points that lie up to 0.5 mm off."""
    link_mm: float = 0.0
    """Error of the second link of a jointed arm."""


@dataclass(frozen=True)
class Faults(PlantedFaults):
    """What is wrong, and how noisy it is."""

    touch_sd_mm: float = 0.0
    point_sd_mm: float = 0.0
    """Of scanned points along the surface's normal."""
    articulations: int = 5
    second_like_first: bool = False
    """The second articulation is held like the first, by touch and by scan."""
    seed: int = 1


@dataclass(frozen=True, eq=False)
class TouchGroup:
    """The touches of one part of the test."""

    feature: str
    centre_mm: Floats  # (3,)
    outward: Floats
    """(N, 3) where the sphere is touched, from its centre."""
    stylus_from: Floats | None
    """(3,) direction from the tip to the wrist; None: any."""


def touch_groups(centre_mm: Floats, moved_mm: Floats) -> list[TouchGroup]:
    """All touches of a one-sphere test; the sphere moves before those at the end."""
    pattern = pattern_directions(POLE, RIM_DEG)
    towards = -centre_mm
    groups = [TouchGroup(sphere_feature(1, "pattern"), centre_mm, pattern, None)]
    for number, held in enumerate(articulation_directions(POLE, towards), 1):
        name = sphere_feature(1, "location", number)
        groups.append(TouchGroup(name, centre_mm, location_places(held, POLE, towards), held))
    end = location_places(POLE, POLE, towards)
    groups.append(TouchGroup(sphere_feature(1, "end"), centre_mm + moved_mm, end, None))
    return groups


def sphere_plan(sphere: SpherePart, limits: tuple[LimitPart, ...] = ()) -> PerformancePlan:
    """The plan of a one-sphere test."""
    return PerformancePlan(
        id="test",
        kind="sphere",
        started_at="2026-11-26T10:00:00+00:00",
        sphere=sphere,
        gate=GatePart(),
        limits=limits,
    )


@dataclass
class SphereSession:
    """Writes the folder of a one-sphere test; ``joints``: by an arm with joints."""

    folder: Path
    faults: Faults = field(default_factory=Faults)
    sphere: SpherePart = SPHERE
    limits: tuple[LimitPart, ...] = ()
    joints: bool = False

    def write(self) -> Path:
        """The folder, written."""
        self._arm = JointArm(self.faults.link_mm) if self.joints else PoseArm()
        self.folder.mkdir(parents=True, exist_ok=True)
        self._random = np.random.default_rng(self.faults.seed)
        sphere_plan(self.sphere, self.limits).write(self.folder / PLAN)
        self._arm.write(self.folder / "arm.json")
        write_calibration(self.folder / "calibration.json")
        self._write_touches()
        for number in range(1, self.faults.articulations + 1):
            self._write_scan(number)
        return self.folder

    def _write_touches(self) -> None:
        features: list[str] = []
        readings: list[Floats] = []
        for group in touch_groups(CENTRE, np.array(self.faults.moved_mm)):
            features += [group.feature] * len(group.outward)
            stylus = group.stylus_from
            if self.faults.second_like_first and group.feature == sphere_feature(1, "location", 2):
                stylus = POLE
            readings += [self._touch(group.centre_mm, one, stylus) for one in group.outward]
        arm = read_any_arm(self.folder / "arm.json")
        contacts = contact_readings(features, arm, np.array(readings))
        write_contacts(self.folder / TOUCHES, contacts)

    def _touch(self, centre: Floats, outward: Floats, stylus_from: Floats | None) -> Floats:
        """The arm's reading with the true tip in contact, its wrist turned at random."""
        reach = self.sphere.diameter_mm / 2 + (TIP.diameter_mm + self.faults.tip_excess_mm) / 2
        at = centre + outward * (reach + self.faults.touch_sd_mm * self._random.normal())
        for _ in range(TRIES):
            R = self._stylus_orientation(stylus_from)
            reading = self._arm.reading(rigid(R, at - R @ np.array([TIP.x_mm, TIP.y_mm, TIP.z_mm])))
            if reading is not None:
                return reading
        raise RuntimeError("the arm does not reach the sphere")

    def _stylus_orientation(self, stylus_from: Floats | None) -> Floats:
        """(3, 3) of the flange, the stylus in an articulation or downward within 40°."""
        most = STYLUS_RAD if stylus_from is None else HELD_RAD
        turn, tilt, side = self._random.uniform([-0.6, 0.0, 0.0], [0.6, most, 2 * np.pi])
        axis = tilt * np.array([np.cos(side), np.sin(side), 0.0])
        down = Rotation.from_euler("x", 180, degrees=True)
        spin = Rotation.from_euler("z", turn)
        held = POLE if stylus_from is None else stylus_from
        lean = Rotation.align_vectors([held], [POLE])[0]
        return np.asarray((lean * Rotation.from_rotvec(axis) * down * spin).as_matrix())

    def _write_scan(self, number: int) -> None:
        """The sensor passes over the sphere, tilted as the articulation says."""
        faults = self.faults
        held = 1 if faults.second_like_first and number == 2 else number
        R_arm_sensor = scan_orientation(held)
        camera = true_camera()
        offset = np.array(faults.matrix_offset_mm)
        folder = self.folder / sphere_scan(1, number)
        folder.mkdir(exist_ok=True)
        radius = self.sphere.diameter_mm / 2
        way = np.arange(-radius, radius, STEP_MM)
        with RecordingWriter(folder / "scan.mcap", self._arm.joint_names) as writer:
            for i, step in enumerate(way):
                stamp_ns = 10**9 + i * FRAME_NS
                # the laser plane is z = 0 of the sensor; it passes along its normal
                at = CENTRE + R_arm_sensor @ np.array([0.0, 0.0, step])
                T_true = rigid(R_arm_sensor, at)
                # the calibration has the sensor elsewhere: the flange follows the true one
                T_flange_true = T_FLANGE_SENSOR @ rigid(np.eye(3), offset)
                T_arm_flange = T_true @ inverse(T_flange_true)
                reading = self._arm.reading(T_arm_flange)
                if reading is None:
                    continue
                for ms in (-4, 4):
                    writer.reading(stamp_ns + ms * 10**6, reading)
                stripe = self._stripe(camera, T_true, radius)
                if stripe is not None:
                    writer.stripe(stamp_ns, stripe, WIDTH, HEIGHT)

    def _stripe(self, camera: Camera, T_arm_sensor: Floats, radius: float) -> Stripe | None:
        """The lit points of the sphere that the camera sees, as pixels."""
        centre = (inverse(T_arm_sensor) @ np.append(CENTRE, 1.0))[:3]
        cut = cut_sphere(centre, radius)
        return None if cut is None else stripe_of_points(camera, *cut, self.faults, self._random)


def cut_sphere(centre_mm: Floats, radius_mm: float) -> tuple[Floats, Floats] | None:
    """Points (N, 3) of a sphere in the laser plane, 0.06 mm apart, and its normals there, in the
    sensor frame; None beside it."""
    circle = np.sqrt(max(radius_mm**2 - centre_mm[2] ** 2, 0.0))
    if circle < 0.5:
        return None
    turn = np.linspace(0, 2 * np.pi, max(int(2 * np.pi * circle / 0.06), 8), endpoint=False)
    outward = np.column_stack(
        [circle * np.cos(turn), circle * np.sin(turn), np.full(len(turn), -centre_mm[2])]
    )
    outward /= radius_mm
    return centre_mm + radius_mm * outward, outward


def stripe_of_points(
    camera: Camera, points: Floats, outward: Floats, faults: Faults, random: np.random.Generator
) -> Stripe | None:
    """The points (N, 3) that the camera sees at up to 70°, as pixels, with noise and faults."""
    views = camera.centre_mm - points
    views /= np.linalg.norm(views, axis=1)[:, None]
    lit = np.einsum("ij,ij->i", outward, views) > np.cos(np.radians(70))
    points, outward = points[lit], outward[lit]
    if len(points) < 3:
        return None
    # within the laser plane, so that triangulation gives these very points
    sideways = outward.copy()
    sideways[:, 2] = 0.0
    sideways /= np.linalg.norm(sideways, axis=1)[:, None]
    off = faults.point_sd_mm * random.normal(size=len(points))
    wrong = random.random(len(points)) < faults.outliers
    off[wrong] += random.uniform(-0.5, 0.5, int(wrong.sum()))
    points = points + off[:, None] * sideways
    points = points * np.array([faults.scale, faults.scale, 1.0])
    uv = project(camera, points)
    count = len(uv)
    return Stripe(uv[:, 0], uv[:, 1], np.full(count, 120.0), np.full(count, 0.05))


def scan_orientation(number: int) -> Floats:
    """(3, 3) of the sensor: its camera above the sphere, and tilted by 40° to four sides."""
    away = true_camera().centre_mm
    up = Rotation.align_vectors([[0, 0, 1.0]], [away / np.linalg.norm(away)])[0]
    # away from the arm, to the right, towards it, to the left
    tilts = {1: ("x", 0), 2: ("y", 40), 3: ("x", 40), 4: ("y", -40), 5: ("x", -40)}
    axis, angle = tilts[number]
    turn = Rotation.from_euler("z", 30.0 * number, degrees=True)
    return np.asarray((Rotation.from_euler(axis, angle, degrees=True) * turn * up).as_matrix())


def write_calibration(path: Path) -> None:
    """The calibration that the sensor has, if the matrix is not wrong."""
    camera = true_camera()
    T = rigid(camera.rotation, camera.translation_mm)
    document = {
        "format": "crenel/calibration",
        "version": 1,
        "camera": {
            "projection_matrix": (camera.matrix @ T[:3]).tolist(),
            "matrix": camera.matrix.tolist(),
            "rotation": camera.rotation.tolist(),
            "translation_mm": camera.translation_mm.tolist(),
            "distortion": [0.0, 0.0, 0.0, 0.0, 0.0],
            "width_px": WIDTH,
            "height_px": HEIGHT,
        },
        "laser_plane": {"normal": [0.0, 0.0, 1.0], "offset_mm": 0.0},
        "probe_matrix": T_FLANGE_SENSOR.tolist(),
        "stripe_axis": "u",
        "serial_numbers": {"arm": "A-1", "object": "B-1", "sensor": "S-1"},
    }
    CalibrationFile.model_validate(document).write(path)
