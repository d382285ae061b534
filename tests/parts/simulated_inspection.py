"""Inspections with their truth: a part, an arm and a sensor as truly built, scanned and touched.

The true sensor and arm differ from their files by errors that are drawn from the covariance in
``calibration.json``. Nothing of the mathematics under test is used.
"""

import json
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from crenel.formats.recording.writer import RecordingWriter
from crenel.metrology.stripe import Stripe
from crenel_hardware.simulator.devices.kinematics import (
    ArmLink,
    ArmModel,
    flange_poses,
    follow_poses,
    solve_joints,
)
from crenel_hardware.simulator.scene.datasheets import arm_datasheet
from tests.parts.simulated_solid import Bracket

Floats = NDArray[np.float64]
WIDTH, HEIGHT = 1280, 1024
RIGHT = np.pi / 2
CAMERA_NAMES = (
    *("fx", "fy", "u0", "v0", "rx", "ry", "rz", "tx", "ty", "tz", "k1", "k2", "p1", "p2"),
    *("plane_a", "plane_b", "plane_offset"),
    *(f"probe_{axis}" for axis in ("rx", "ry", "rz", "tx", "ty", "tz")),
)
LINK_AXES = ("rx", "ry", "rz", "tx", "ty", "tz")
RAYS = 200
STEP_MM = 1.0
SIGMA_PX = 0.12
FRAME_NS = 10_000_000
POSTURES, OBSERVED_MM = 12, 0.025


def rigid(R: Floats, t: Floats) -> Floats:
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, t
    return T


PART_PLACE = rigid(
    Rotation.from_euler("xyz", [3.0, -4.0, 25.0], degrees=True).as_matrix(),
    np.array([380.0, -120.0, 60.0]),
)


@dataclass(frozen=True)
class Sensor:
    """Camera and laser plane, in the frame of the camera, and how they are mounted."""

    f_px: tuple[float, float] = (1500.0, 1504.0)
    centre_px: tuple[float, float] = (642.0, 508.0)
    lens: tuple[float, float, float, float] = (-0.08, 0.05, 2e-4, -3e-4)
    normal: tuple[float, float, float] = (0.02, 0.866, 0.4995)
    depth_mm: float = 150.0
    T_flange_camera: Floats = None  # type: ignore[assignment]

    @property
    def unit_normal(self) -> Floats:
        n = np.array(self.normal)
        return np.asarray(n / np.linalg.norm(n))

    @property
    def offset_mm(self) -> float:
        return float(self.unit_normal[2] * self.depth_mm)


@dataclass(frozen=True)
class Station:
    """Arm and sensor as their files have them, and their dense covariance."""

    arm: ArmModel
    sensor: Sensor
    pivot_mm: Floats
    covariance: Floats
    seed: int

    @property
    def names(self) -> tuple[str, ...]:
        links = (f"link{n}_{a}" for n in range(1, self.arm.joint_count + 1) for a in LINK_AXES)
        return (*CAMERA_NAMES, *links)


def seven_axis_arm(encoder_sd_rad: float = 6e-6, scale: float = 1.0) -> ArmModel:
    rows = (
        (0.0, -RIGHT, 340.0),
        (0.0, RIGHT, 0.0),
        (0.0, RIGHT, 400.0),
        (0.0, -RIGHT, 0.0),
        (0.0, -RIGHT, 400.0),
        (0.0, RIGHT, 0.0),
        (0.0, 0.0, 126.0),
    )
    links = tuple(
        ArmLink(a * scale, alpha, d * scale, limits_rad=(-3.05, 3.05)) for a, alpha, d in rows
    )
    return ArmModel(links, (15.0, -20.0, 95.0), 4.0, encoder_sd_rad, serial_number="P-7")


def draw_station(
    seed: int,
    arm_um: float = 20.0,
    arm: ArmModel | None = None,
    sensor: Sensor | None = None,
) -> Station:
    """A station after a calibration: errors of sensor and links are correlated."""
    rng = np.random.default_rng(seed)
    arm = arm or seven_axis_arm()
    mount = rigid(
        Rotation.from_euler("xyz", [8.0, -5.0, 30.0], degrees=True).as_matrix(),
        np.array([30.0, 45.0, 60.0]),
    )
    sensor = replace(sensor or Sensor(), T_flange_camera=mount)
    pivot = (mount @ np.array([0, 0, sensor.depth_mm, 1]))[:3]
    count = len(CAMERA_NAMES) + 6 * arm.joint_count
    station = Station(arm, sensor, pivot, np.zeros((count, count)), seed)
    return replace(station, covariance=_adjusted_covariance(station, arm_um, rng))


def _adjusted_covariance(station: Station, arm_um: float, rng: np.random.Generator) -> Floats:
    """What a calibration on one object in many postures leaves: errors that points hardly show are
    large, and those of sensor and links hang together."""
    before = np.array(
        [3, 3, 2, 2, 0, 0, 0, 0, 0, 0, 0.01, 0.05, 1e-3, 1e-3, 3e-3, 3e-3, 0.5]
        + [3e-3, 3e-3, 3e-3, 0.5, 0.5, 0.5]
        + 6 * station.arm.joint_count * [0.0]
    )
    of_link = np.repeat([2e-5, 8e-3], 3) * arm_um / 20
    before[len(CAMERA_NAMES) :] = np.tile(of_link, station.arm.joint_count)
    free = np.flatnonzero(before)
    X = np.linalg.inv(station.sensor.T_flange_camera)
    uv = np.stack(np.meshgrid([200, 640, 1080], [300, 500, 700]), axis=-1).reshape(-1, 2) + 0.0
    N = np.diag(np.r_[before[free] ** -2.0, np.zeros(6)])
    start, postures = np.array([-0.3, 0.5, 0.0, -1.6, 0.0, 1.2, 0.0]), 0
    while postures < POSTURES:
        lean = Rotation.from_euler("xyz", rng.uniform(-30, 30, 3), degrees=True)
        look = (lean * Rotation.from_euler("x", 180.0, degrees=True)).as_matrix()
        shift = np.array([60.0, 40.0, 20.0]) + rng.uniform(-15, 15, 3)
        camera = PART_PLACE @ rigid(look, shift - look @ [0.0, 0.0, 150.0])
        try:
            q = solve_joints(station.arm, camera @ X, start, rng)
        except ValueError:
            continue
        start, postures = q, postures + 1
        places = _points(station, np.zeros(len(before)), uv, q)
        J = np.zeros((places.size, len(free) + 6))
        for column, k in enumerate(free):
            step = np.zeros(len(before))
            step[k] = 1e-3 * before[k]
            moved = _points(station, step, uv, q) - _points(station, -step, uv, q)
            J[:, column] = moved.ravel() / (2 * step[k])
        for axis in np.eye(3):  # the object stands anywhere
            J[:, len(free) + int(np.argmax(axis))] = np.cross(axis, places).ravel()
            J[:, len(free) + 3 + int(np.argmax(axis))] = np.tile(axis, len(places))
        N += J.T @ J / OBSERVED_MM**2
    scale = 1 / np.sqrt(np.diag(N))
    known = np.linalg.inv(N * np.outer(scale, scale)) * np.outer(scale, scale)
    found = np.zeros((len(before), len(before)))
    found[np.ix_(free, free)] = known[: len(free), : len(free)]
    return found


def _points(station: Station, errors: Floats, uv: Floats, q: Floats) -> Floats:
    """Points (N, 3) of pixels, arm frame, if the station errs so."""
    true = draw_truth(station, 0, errors)
    sensor = true.sensor
    wanted = (uv - sensor.centre_px) / sensor.f_px
    at = wanted.copy()
    for _ in range(12):
        rays = np.column_stack([at, np.ones(len(at))])
        seen = (to_pixels(sensor, rays) - sensor.centre_px) / sensor.f_px
        at += wanted - seen
    rays = np.column_stack([at, np.ones(len(at))])
    X = rays * (true.offset_mm / (rays @ true.normal))[:, None]
    T = flange_poses(true.arm, q[None])[0] @ sensor.T_flange_camera
    return np.asarray(X @ T[:3, :3].T + T[:3, 3])


@dataclass(frozen=True)
class TrueStation:
    """A station as it truly is."""

    arm: ArmModel
    sensor: Sensor
    normal: Floats
    offset_mm: float


def draw_truth(station: Station, seed: int, by: Floats | None = None) -> TrueStation:
    """The true station: off its files by errors drawn from its covariance, or by those given."""
    rng = np.random.default_rng(seed)
    if by is None:
        sizes, axes = np.linalg.eigh(station.covariance)
        by = axes @ (np.sqrt(np.maximum(sizes, 0)) * rng.normal(size=len(sizes)))
    e = dict(zip(station.names, by, strict=True))
    s = station.sensor
    n = s.unit_normal
    # plane_a along n x e, plane_b along n x (n x e), e the axis of the smallest component
    axis = np.eye(3)[int(np.argmin(np.abs(n)))]
    a = np.cross(n, axis) / np.linalg.norm(np.cross(n, axis))
    b = np.cross(n, a)
    tilted = n + e["plane_a"] * a + e["plane_b"] * b
    turn = Rotation.from_rotvec([e["probe_rx"], e["probe_ry"], e["probe_rz"]]).as_matrix()
    mount = s.T_flange_camera.copy()
    mount[:3, 3] = turn @ (mount[:3, 3] - station.pivot_mm) + station.pivot_mm
    mount[:3, 3] += [e["probe_tx"], e["probe_ty"], e["probe_tz"]]
    mount[:3, :3] = turn @ mount[:3, :3]
    sensor = replace(
        s,
        f_px=(s.f_px[0] + e["fx"], s.f_px[1] + e["fy"]),
        centre_px=(s.centre_px[0] + e["u0"], s.centre_px[1] + e["v0"]),
        lens=(
            s.lens[0] + e["k1"],
            s.lens[1] + e["k2"],
            s.lens[2] + e["p1"],
            s.lens[3] + e["p2"],
        ),
        T_flange_camera=mount,
    )
    links = []
    for number, link in enumerate(station.arm.links, 1):
        t = tuple(e[f"link{number}_{one}"] for one in ("tx", "ty", "tz", "rx", "ry", "rz"))
        links.append(replace(link, error_mm_rad=t))
    arm = replace(station.arm, links=tuple(links))
    length = float(np.linalg.norm(tilted))
    return TrueStation(arm, sensor, tilted / length, (s.offset_mm + e["plane_offset"]) / length)


def to_pixels(sensor: Sensor, points: Floats) -> Floats:
    """Distorted pixels of points (N, 3) in the camera's frame."""
    x, y = points[:, 0] / points[:, 2], points[:, 1] / points[:, 2]
    k1, k2, p1, p2 = sensor.lens
    r2 = x * x + y * y
    radial = 1 + k1 * r2 + k2 * r2 * r2
    u = x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x)
    v = y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y
    return np.column_stack(
        [
            sensor.f_px[0] * u + sensor.centre_px[0],
            sensor.f_px[1] * v + sensor.centre_px[1],
        ]
    )


def pass_poses(
    tilt_deg: float, turn_deg: float, across_mm: float, length: tuple[float, float], about: Floats
) -> Floats:
    """Poses (F, 4, 4) of the camera in the part frame: the stripe crosses the part while it moves
    along ``turn_deg``, leaning by ``tilt_deg``."""
    heading = Rotation.from_euler("z", turn_deg, degrees=True)
    # looking down, the picture's x across the way
    look = heading * Rotation.from_euler("x", 180.0, degrees=True)
    lean = Rotation.from_euler("x", tilt_deg, degrees=True)
    R = (look * lean).as_matrix()
    forward, sideways = heading.as_matrix()[:, 1], heading.as_matrix()[:, 0]
    way = np.arange(*length, STEP_MM)
    aim = about + across_mm * sideways + way[:, None] * forward
    return np.array([rigid(R, one - R @ [0.0, 0.0, 150.0]) for one in aim])


def usual_passes(part: Bracket) -> list[Floats]:
    w, h = part.size_mm
    middle = np.array([w / 2, h / 2, part.top_mm])
    passes = []
    for tilt, turn in ((-50, 0), (20, 0), (-50, 90), (20, 90)):
        wide, long = (w, h) if turn == 0 else (h, w)
        strips = [-wide / 4, wide / 4] if wide > 90 else [0.0]
        passes += [
            pass_poses(tilt, turn, one, (-long / 2 - 14, long / 2 + 14), middle) for one in strips
        ]
    return passes


@dataclass(frozen=True)
class Planned:
    """A pass as the operator drives it: readings (F, n)."""

    q_rad: Floats


def plan_passes(station: Station, passes: list[Floats], seed: int) -> list[Planned]:
    """Joint angles of passes, by the arm of the file."""
    rng = np.random.default_rng(seed)
    X = np.linalg.inv(station.sensor.T_flange_camera)
    start = np.array([-0.3, 0.5, 0.0, -1.6, 0.0, 1.2, 0.0])
    planned = []
    for poses in passes:
        targets = PART_PLACE @ poses @ X
        for _ in range(40):
            first = solve_joints(station.arm, targets[0], start, rng)
            try:
                planned.append(Planned(follow_poses(station.arm, targets, first)))
                break
            except ValueError:
                start = rng.uniform(-2, 2, 7)
        else:
            raise ValueError("a pass is out of reach")
        start = planned[-1].q_rad[-1]
    return planned


def scan_part(
    path: Path,
    part: Bracket,
    truth: TrueStation,
    planned: list[Planned],
    seed: int,
    slip: tuple[int, Floats] | None = None,
) -> int:
    """Writes the recording of all passes; returns the number of points.

    Args:
        slip: from which pass on the part has moved, and its motion (4, 4), arm frame.
    """
    rng = np.random.default_rng(seed)
    sensor, count, stamp = truth.sensor, 0, 1_000_000_000
    names = [f"J{i + 1}" for i in range(truth.arm.joint_count)]
    T_part_arm = np.linalg.inv(PART_PLACE)
    n, d = truth.normal, truth.offset_mm
    emitter = np.array([0.0, (d - n[2] * 10.0) / n[1], 10.0])
    fan = np.linspace(-0.22, 0.22, RAYS)
    centre = np.array([0.0, (d - n[2] * 150.0) / n[1], 150.0]) - emitter
    centre /= np.linalg.norm(centre)
    side = np.cross(n, centre)
    rays = np.cos(fan)[:, None] * centre + np.sin(fan)[:, None] * side
    with RecordingWriter(path, names, {"arm_serial": "P-7"}) as writer:
        for number, one in enumerate(planned):
            if slip is not None and number == slip[0]:
                T_part_arm = np.linalg.inv(slip[1] @ PART_PLACE)
            noise = rng.normal(size=one.q_rad.shape) * truth.arm.encoder_sd_rad
            T = T_part_arm @ flange_poses(truth.arm, one.q_rad) @ sensor.T_flange_camera
            hits, lit = _cast(part, T, emitter, rays)
            for f, q in enumerate(one.q_rad + noise):
                stamp += FRAME_NS
                writer.reading(stamp, q)
                X = hits[f][lit[f]]
                uv = to_pixels(sensor, X) if len(X) else np.zeros((0, 2))
                inside = ((uv > 2) & (uv < [WIDTH - 3, HEIGHT - 3])).all(axis=1)
                uv = uv[inside]
                uv = uv[np.argsort(uv[:, 0])]
                uv[:, 1] += rng.normal(size=len(uv)) * SIGMA_PX
                count += len(uv)
                full = np.ones(len(uv))
                writer.stripe(
                    stamp, Stripe(uv[:, 0], uv[:, 1], 100 * full, SIGMA_PX * full), WIDTH, HEIGHT
                )
            stamp += 500_000_000
    return count


def _cast(
    part: Bracket, T_part_camera: Floats, emitter: Floats, rays: Floats
) -> tuple[Floats, NDArray[np.bool_]]:
    """Points (F, R, 3) in the camera's frame, and which of them the camera sees."""
    R, t = T_part_camera[:, :3, :3], T_part_camera[:, :3, 3]
    origin = (R @ emitter + t)[:, None, :] + np.zeros((1, len(rays), 1))
    along = np.einsum("fij,rj->fri", R, rays)
    shape = along.shape
    origin, along = origin.reshape(-1, 3), along.reshape(-1, 3)
    reach = part.meet(origin, along, 60.0)
    lit = np.isfinite(reach)
    points = origin + np.where(lit, reach, 0.0)[:, None] * along
    eyes = np.repeat(t, len(rays), axis=0)
    sight = eyes - points
    away = np.linalg.norm(sight, axis=1)
    sight /= away[:, None]
    seen = lit.copy()
    back = part.meet(points[lit] + 0.05 * sight[lit], sight[lit], 0.05)
    seen[np.flatnonzero(lit)[np.isfinite(back) & (back < away[lit])]] = False
    local = np.einsum("fji,frj->fri", R, points.reshape(shape) - t[:, None, :])
    return local, seen.reshape(shape[:2])


def touch_rows(
    station: Station,
    truth: TrueStation,
    touched: dict[str, list[tuple[Floats, Floats]]],
    seed: int,
    touch_sd_mm: float = 0.003,
) -> list[list[object]]:
    """Rows of ``touches.csv``: places and outward normals (part frame) by feature."""
    rng = np.random.default_rng(seed)
    rows: list[list[object]] = []
    start = np.array([-0.3, 0.5, 0.0, -1.6, 0.0, 1.2, 0.0])
    tip = np.array(truth.arm.tip_mm)
    for name, places in touched.items():
        for place, normal in places:
            lean = Rotation.from_euler("xy", rng.uniform(-25, 25, 2), degrees=True)
            R = (
                (PART_PLACE[:3, :3])
                @ (lean * Rotation.from_euler("x", 180.0, degrees=True)).as_matrix()
            )
            off = rng.normal() * touch_sd_mm
            centre = place + normal * (truth.arm.tip_diameter_mm / 2 + off)
            centre = PART_PLACE[:3, :3] @ centre + PART_PLACE[:3, 3]
            q = solve_joints(truth.arm, rigid(R, centre - R @ tip), start, rng)
            start = q
            q = q + rng.normal(size=len(q)) * truth.arm.encoder_sd_rad
            rows.append([name, *np.degrees(q).tolist()])
    return rows


def write_station(folder: Path, station: Station, links: bool = True) -> None:
    """``arm.json`` and ``calibration.json``."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "arm.json").write_text(json.dumps(arm_datasheet(station.arm)))
    s, count = station.sensor, len(station.names) if links else len(CAMERA_NAMES)
    K = [[s.f_px[0], 0.0, s.centre_px[0]], [0.0, s.f_px[1], s.centre_px[1]], [0.0, 0.0, 1.0]]
    P = np.column_stack([K, np.zeros(3)])
    document = {
        "format": "crenel/calibration",
        "version": 1,
        "camera": {
            "projection_matrix": P.tolist(),
            "matrix": K,
            "rotation": np.eye(3).tolist(),
            "translation_mm": [0.0, 0.0, 0.0],
            "distortion": [*s.lens, 0.0],
            "width_px": WIDTH,
            "height_px": HEIGHT,
        },
        "laser_plane": {"normal": s.unit_normal.tolist(), "offset_mm": s.offset_mm},
        "probe_matrix": s.T_flange_camera.tolist(),
        "stripe_axis": "u",
        "method": "joint",
        "serial_numbers": {"arm": "P-7"},
        "scales": {
            "links_rad": 2e-5,
            "links_mm": 7e-3,
            "reading_factor": 1.0,
            "touch_mm": 0.003,
        },
        "covariance": {
            "parameters": list(station.names[:count]),
            "matrix": station.covariance[:count, :count].tolist(),
            "pivot_mm": station.pivot_mm.tolist(),
            **({"links": [0.0] * (6 * station.arm.joint_count)} if links else {}),
        },
    }
    (folder / "calibration.json").write_text(json.dumps(document))


def write_touches(folder: Path, station: Station, rows: list[list[object]]) -> None:
    """``touches.csv`` of rows as ``touch_rows`` gives them."""
    columns = ["feature", *(f"q{i + 1}_deg" for i in range(station.arm.joint_count))]
    lines = [",".join(columns), *(",".join(map(str, row)) for row in rows)]
    (folder / "touches.csv").write_text("\n".join(lines) + "\n")
