"""Every figure of a one-sphere and a plane test once more, from touches and recorded stripes.

Written from docs/performance.md and docs/formats.md, with numpy and scipy alone: nothing of
``crenel.metrology`` and ``crenel.workflows`` is used. Of arms with joints in the standard
Denavit-Hartenberg convention.
"""

import csv
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares, minimize
from scipy.spatial import Delaunay

from crenel.formats.recording.decoders import JointRecord, StripeRecord
from crenel.formats.recording.reader import Recording

Floats = NDArray[np.float64]
Frames = NDArray[np.int64]
RINGS = ((0.0, 1, 0.0), (22.5, 4, 0.0), (45.0, 8, 22.5), (67.5, 4, 45.0), (90.0, 8, 22.5))


def independent_figures_um(folder: Path) -> dict[str, float]:
    """All figures in µm by the names of their quantities."""
    plan, arm, calibration = _documents(folder)
    diameter, pole = plan["sphere"]["diameter_mm"], np.array(plan["gate"]["pole"])
    tips = _tips(folder, arm)
    tip_diameter = arm["tip"]["diameter_mm"]
    found: dict[str, float] = {}
    touched_centre, radius = _sphere(tips["p1-pattern"])
    distances = np.linalg.norm(tips["p1-pattern"] - touched_centre, axis=1)
    found["size-touch"] = 2 * radius - tip_diameter - diameter
    found["form-touch"] = float(np.ptp(distances))
    touched = [_sphere(tips[f"p1-location-{i}"])[0] for i in range(1, 6)]
    found["location-touch"] = _enclosing(np.array(touched))
    contacts = touched_centre + (tips["p1-pattern"] - touched_centre) * (
        1 - tip_diameter / 2 / distances[:, None]
    )
    scans = [
        _gate(*_scan(folder / f"p1-a{i}" / "scan.mcap", arm, calibration), plan, touched_centre)
        for i in range(1, 6)
    ]
    directions = _pattern(pole)
    centres = []
    for points, frames in scans:
        centre = _sphere(points)[0]
        counts, seen_in, radii = _patches(points, frames, centre, directions)
        good = (counts >= 20) & (seen_in >= 2)
        centres.append(_sphere(centre + radii[good, None] * directions[good])[0])
    found["location-scan"] = _enclosing(np.array(centres))
    points = np.concatenate([one for one, _ in scans])
    frames = np.concatenate([1000 * i + one for i, (_, one) in enumerate(scans)])
    centre, radius = _sphere(points)
    found["size-all-scan"] = 2 * radius - diameter
    found["dispersion-scan"] = _holding_95_percent(np.linalg.norm(points - centre, axis=1))
    radii = _patches(points, frames, centre, directions)[2]
    of_25 = centre + radii[:, None] * directions
    scanned_centre, radius = _sphere(of_25)
    found["size-scan"] = 2 * radius - diameter
    found["form-scan"] = float(np.ptp(np.linalg.norm(of_25 - scanned_centre, axis=1)))
    both = np.concatenate([contacts, of_25])
    both_centre, radius = _sphere(both)
    found["size-both"] = 2 * radius - diameter
    found["form-both"] = float(np.ptp(np.linalg.norm(both - both_centre, axis=1)))
    found["location-both"] = float(np.linalg.norm(_sphere(contacts)[0] - scanned_centre))
    return {name: 1e3 * value for name, value in found.items()}


def independent_plane_um(folder: Path) -> list[float]:
    """The form of the plane in each orientation, in µm."""
    plan, arm, calibration = _documents(folder)
    found = []
    for number in (1, 2):
        points = _scan(folder / f"plane-{number}" / "scan.mcap", arm, calibration)[0]
        off = _off_plane(points, _on_plate(points, plan["gate"]["shell_mm"]))
        found.append(1e3 * _holding_95_percent(off))
    return found


def _documents(folder: Path) -> list[Any]:
    """Plan, arm and calibration."""
    names = ("plan", "arm", "calibration")
    return [json.loads((folder / f"{name}.json").read_text()) for name in names]


def _holding_95_percent(values: Floats) -> float:
    """The width of the narrowest interval with so many of the values."""
    values = np.sort(values)
    held = int(np.ceil(0.95 * len(values)))
    return float((values[held - 1 :] - values[: 1 - held or None]).min())


def _plane(points: Floats) -> tuple[Floats, Floats]:
    """Middle (3,) and axes (3, 3) of points on a plane, its normal last."""
    middle = points.mean(axis=0)
    return middle, np.linalg.eigh(np.cov((points - middle).T))[1][:, ::-1]


def _off_plane(points: Floats, chosen: NDArray[np.bool_]) -> Floats:
    """Distances of chosen points from their own plane."""
    middle, axes = _plane(points[chosen])
    return np.asarray((points[chosen] - middle) @ axes[:, 2])


def _on_plate(points: Floats, shell_mm: float) -> NDArray[np.bool_]:
    """Points that lie 1 mm or more within the outline of those near the plate, and in the shell."""
    near = np.ones(len(points), dtype=np.bool_)
    for _ in range(30):
        middle, axes = _plane(points[near])
        near = np.abs((points - middle) @ axes[:, 2]) <= 2.0
    flat = (points - middle) @ axes
    corners = flat[near][Delaunay(flat[near, :2]).convex_hull.ravel(), :2]
    around = corners - corners.mean(axis=0)
    corners = corners[np.argsort(np.arctan2(around[:, 1], around[:, 0]))]
    inside = np.abs(flat[:, 2]) <= shell_mm
    for a, b in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        side = b - a
        if (length := float(np.linalg.norm(side))) > 0:  # corners stand there twice
            away = flat[:, :2] - a
            inside &= (side[0] * away[:, 1] - side[1] * away[:, 0]) / length >= 1.0
    return np.asarray(inside)


def _flange(arm: Mapping[str, list[Mapping[str, float]]], q_rad: Floats) -> Floats:
    """(N, 4, 4) by ``Rz(sign q + theta) Tz(d) Tx(a) Rx(alpha)`` of each joint."""
    T = np.tile(np.eye(4), (len(q_rad), 1, 1))
    for joint, q in zip(arm["joints"], q_rad.T, strict=True):
        turn = joint["sign"] * q + np.radians(joint["theta_deg"])
        c, s = np.cos(turn), np.sin(turn)
        ca, sa = np.cos(np.radians(joint["alpha_deg"])), np.sin(np.radians(joint["alpha_deg"]))
        A = np.zeros((len(q), 4, 4))
        A[:, 0] = np.column_stack([c, -s * ca, s * sa, joint["a_mm"] * c])
        A[:, 1] = np.column_stack([s, c * ca, -c * sa, joint["a_mm"] * s])
        A[:, 2] = [0.0, sa, ca, joint["d_mm"]]
        A[:, 3, 3] = 1.0
        T = T @ A
    return T


def _tips(folder: Path, arm: Mapping[str, Any]) -> dict[str, Floats]:
    """Tip centres (N, 3) by the feature of the touches."""
    with (folder / "touches.csv").open() as file:
        rows = list(csv.DictReader(file))
    angles = [[float(v) for k, v in row.items() if k.endswith("_deg")] for row in rows]
    T = _flange(arm, np.radians(angles))
    tip = arm["tip"]
    tips = T[:, :3, :3] @ [tip["x_mm"], tip["y_mm"], tip["z_mm"]] + T[:, :3, 3]
    names = np.array([row["feature"] for row in rows])
    return {name: tips[names == name] for name in set(names.tolist())}


def _scan(
    path: Path, arm: Mapping[str, Any], calibration: Mapping[str, Any]
) -> tuple[Floats, Floats, Frames]:
    """Points (N, 3), unit directions to the camera (N, 3), and frames (N,) of a recording."""
    stamps, readings, stripes = [], [], []
    for record in Recording(path, path.stat().st_size).records():
        if isinstance(record, JointRecord):
            stamps.append(record.stamp_ns)
            readings.append(record.q_rad)
        elif isinstance(record, StripeRecord):
            stripes.append(record)
    at = np.array(stamps, dtype=np.float64)
    q = np.array(readings)
    when = np.array([float(one.stamp_ns) for one in stripes])
    joints = np.column_stack([np.interp(when, at, column) for column in q.T])
    T = _flange(arm, joints) @ np.array(calibration["probe_matrix"])
    camera, plane = calibration["camera"], calibration["laser_plane"]
    R = np.array(camera["rotation"])
    eye = -R.T @ np.array(camera["translation_mm"])
    n = np.array(plane["normal"])
    points, views, frames = [], [], []
    for i, stripe in enumerate(stripes):
        uv = np.column_stack([stripe.stripe.u, stripe.stripe.v])
        lines = _undistort(camera, uv) @ R
        on_plane = eye + lines * ((plane["offset_mm"] - n @ eye) / (lines @ n))[:, None]
        points.append(on_plane @ T[i, :3, :3].T + T[i, :3, 3])
        away = T[i, :3, :3] @ eye + T[i, :3, 3] - points[-1]
        views.append(away / np.linalg.norm(away, axis=1)[:, None])
        frames.append(np.full(len(uv), i))
    return np.concatenate(points), np.concatenate(views), np.concatenate(frames)


def _undistort(camera: Mapping[str, list[float]], uv: Floats) -> Floats:
    """Lines of sight (N, 3), camera frame, by Brown's model."""
    wanted = np.linalg.solve(np.array(camera["matrix"]), np.vstack([uv.T, np.ones(len(uv))])).T
    k1, k2, p1, p2, k3 = camera["distortion"]
    x, y = wanted[:, 0].copy(), wanted[:, 1].copy()
    for _ in range(60):
        r2 = x * x + y * y
        radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3))
        x = (wanted[:, 0] - 2 * p1 * x * y - p2 * (r2 + 2 * x * x)) / radial
        y = (wanted[:, 1] - p1 * (r2 + 2 * y * y) - 2 * p2 * x * y) / radial
    return np.column_stack([x, y, np.ones(len(x))])


def _gate(
    points: Floats, views: Floats, frames: Frames, plan: Mapping[str, Any], centre: Floats
) -> tuple[Floats, Frames]:
    """Points within the gate about the calibrated sphere, with their frames."""
    gate, radius = plan["gate"], plan["sphere"]["diameter_mm"] / 2
    inside = np.zeros(len(points), dtype=np.bool_)
    for _ in range(20):
        away = points - centre
        distance = np.linalg.norm(away, axis=1)
        outward = away / distance[:, None]
        now = np.abs(distance - radius) <= gate["shell_mm"]
        now &= (outward * views).sum(axis=1) >= np.cos(np.radians(gate["incidence_deg"]))
        now &= outward @ np.array(gate["pole"]) >= np.cos(np.radians(gate["cone_deg"]))
        if (now == inside).all():
            break
        inside = now
        chosen = points[inside]
        centre = least_squares(
            lambda c, p=chosen: np.linalg.norm(p - c, axis=1) - radius,
            centre,
            xtol=1e-14,
            ftol=1e-14,
        ).x
    return points[inside], frames[inside]


def _pattern(pole: Floats) -> Floats:
    """The 25 directions. The first place of a ring lies in the direction that the cross product
    of the pole and the axis least along it gives, as docs/performance.md has it."""
    a = np.cross(pole, np.eye(3)[int(np.argmin(np.abs(pole)))])
    a /= np.linalg.norm(a)
    b = np.cross(pole, a)
    rows = []
    for tilt_deg, count, turn_deg in RINGS:
        tilt = np.radians(tilt_deg)
        for turn in np.radians(turn_deg + 360.0 * np.arange(count) / count):
            rows.append(np.cos(tilt) * pole + np.sin(tilt) * (np.cos(turn) * a + np.sin(turn) * b))
    return np.array(rows)


def _patches(
    points: Floats, frames: Frames, centre: Floats, directions: Floats
) -> tuple[Frames, Frames, Floats]:
    """Number of points and frames, and mean distance, of each place."""
    away = points - centre
    distance = np.linalg.norm(away, axis=1)
    inside = [
        np.degrees(np.arccos(np.clip(away @ one / distance, -1, 1))) <= 8.0 for one in directions
    ]
    return (
        np.array([one.sum() for one in inside]),
        np.array([len(set(frames[one].tolist())) for one in inside]),
        np.array([distance[one].mean() if one.any() else np.nan for one in inside]),
    )


def _sphere(points: Floats) -> tuple[Floats, float]:
    """Centre and radius of least squares of the distances."""
    middle = points.mean(axis=0)
    local = points - middle
    A = np.column_stack([2 * local, np.ones(len(local))])
    start = np.linalg.lstsq(A, (local**2).sum(axis=1), rcond=None)[0]
    start[3] = np.sqrt(start[3] + start[:3] @ start[:3])

    def off(x: Floats) -> Floats:
        return np.asarray(np.linalg.norm(local - x[:3], axis=1) - x[3])

    found = least_squares(off, start, xtol=1e-15, ftol=1e-15, gtol=1e-15, x_scale="jac").x
    return middle + found[:3], float(found[3])


def _enclosing(points: Floats) -> float:
    """Diameter of the smallest sphere about points, as a problem with constraints."""
    local = 1e3 * (points - points.mean(axis=0))
    start = np.append(np.zeros(3), (local**2).sum(axis=1).max())
    found = minimize(
        lambda x: x[3],
        start,
        jac=lambda x: np.array([0.0, 0.0, 0.0, 1.0]),
        constraints={"type": "ineq", "fun": lambda x: x[3] - ((local - x[:3]) ** 2).sum(axis=1)},
        method="SLSQP",
        options={"ftol": 1e-12, "maxiter": 500},
    )
    return float(2e-3 * np.sqrt(found.x[3]))
