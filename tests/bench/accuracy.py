"""How good a calibration is, and how long it takes: tables of docs/accuracy.md.

    python -m tests.bench.accuracy [SAMPLES] [--sessions 20] [--json]

Simulated sessions of blocks, arms and cameras drawn at random, and the sample sessions
where their folder is given. Each is calibrated; the truth's pixels are rebuilt and
compared with where their light fell. Beside it in the same run: the same corners by
Faugeras' linear method alone, as in the article. The samples also by all their poses
in the joint adjustment.
"""

import argparse
import json
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from app.errors import OperationError
from app.formats.session.calibration_session import read_session
from app.metrology.adjustment.block.calibrate import BlockCalibration, calibrate_block
from app.metrology.calibration.laser_plane_fit import fit_laser_plane
from app.metrology.calibration.one_pose import OnePoseCalibration, calibrate_one_pose
from app.metrology.sensor.camera import Camera
from app.metrology.sensor.laser_plane import LaserPlane
from app.metrology.sensor.triangulation import sensor_points
from app.metrology.transforms import Floats, apply, rigid_fit
from app.workflows.calibrate import joint_inputs, one_pose_inputs
from hardware.simulator.devices.kinematics import UnreachableError
from hardware.simulator.session import SessionPlan, render_session
from tests.bench.rows import Rows, add_json_option, measured_rows

SAMPLES = ("one-pose", "many-poses", "metal")
COLUMNS = ("sensor, µm", "flange, µm", "claimed, µm", "linear only, µm")
FIRST_SEED = 9000
RUNS = 5


def rms_um(off_mm: Floats) -> float:
    return 1e3 * float(np.sqrt(np.mean(np.sum(off_mm**2, axis=1))))


def in_sensor_um(camera: Camera, plane: LaserPlane, truth: dict[str, list[list[float]]]) -> float:
    """Rms error in the sensor's frame after one rigid fit: the choice of frame is free."""
    rebuilt = sensor_points(camera, plane, np.array(truth["pixels"]))
    true = np.array(truth["points_sensor_frame_mm"])
    return rms_um(apply(rigid_fit(true, rebuilt), rebuilt) - true)


def in_flange_um(
    found: OnePoseCalibration | BlockCalibration, truth: dict[str, list[list[float]]]
) -> float:
    rebuilt = sensor_points(found.camera, found.plane, np.array(truth["pixels"]))
    return rms_um(apply(found.T_flange_sensor, rebuilt) - np.array(truth["points_flange_frame_mm"]))


def linear_um(found: OnePoseCalibration, truth: dict[str, list[list[float]]]) -> float:
    """Faugeras' matrix on the corners and a plane through the stripe, nothing refined."""
    camera, block = found.faugeras.camera, found.fit.scene.block
    try:
        plane = fit_laser_plane(camera, block, found.stripe).plane
    except OperationError:
        return float("nan")
    return in_sensor_um(camera, plane, truth)


def measure_session(folder: Path) -> tuple[float, float, float, float]:
    """Sensor frame, flange frame, claimed uncertainty, linear method: all in um."""
    session = read_session(folder)
    found = calibrate_one_pose(one_pose_inputs(session, session.poses[0]))
    truth = json.loads((folder / "truth.json").read_text())
    return (
        in_sensor_um(found.camera, found.plane, truth),
        in_flange_um(found, truth),
        found.total_um,
        linear_um(found, truth),
    )


def measure_joint(folder: Path) -> tuple[float, float, float]:
    """All poses together: sensor frame, flange frame, claimed uncertainty, all in um."""
    found = calibrate_block(joint_inputs(read_session(folder)))
    truth = json.loads((folder / "truth.json").read_text())
    in_sensor = in_sensor_um(found.camera, found.plane, truth)
    return in_sensor, in_flange_um(found, truth), found.uncertainty.total_um


def draw_sessions(count: int, folder: Path) -> Iterator[Path]:
    """``count`` random sessions: turned cameras, both lightings, six and seven joints."""
    seed = FIRST_SEED
    while count:
        rng = np.random.default_rng(seed)
        plan = SessionPlan(
            joints=int(rng.integers(6, 8)),
            lighting=str(rng.choice(["pair", "both"])),
            roll_rad=float(rng.uniform(-np.pi, np.pi)),
            distortion=(float(rng.uniform(-0.1, 0.05)), 0.0, 0.0, 0.0, 0.0),
        )
        try:
            render_session(folder / str(seed), seed, plan)
        except UnreachableError:
            pass
        else:
            count -= 1
            yield folder / str(seed)
        seed += 1


def cold_process_s(folder: Path, scratch: Path) -> float:
    """Median wall time of ``crenel calibrate`` as a process of its own, its files in the cache."""
    command = [
        sys.executable,
        "-c",
        "from app.cli.main import main; main()",
        "calibrate",
        str(folder),
    ]
    command += ["-o", str(scratch / "calibration.json")]
    times = []
    for _ in range(RUNS + 1):
        start = time.perf_counter()
        subprocess.run(command, check=True, capture_output=True)
        times.append(time.perf_counter() - start)
    return float(np.median(times[1:]))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("samples", type=Path, nargs="?")
    parser.add_argument("--sessions", type=int, default=20)
    add_json_option(parser)
    given = parser.parse_args()
    with measured_rows(given.json) as rows, tempfile.TemporaryDirectory() as scratch:
        for name in SAMPLES if given.samples is not None else ():
            rows.add(name, named(measure_session(given.samples / name)))
            rows.add(f"{name}, joint", named(measure_joint(given.samples / name)))
        last = measure_random(given.sessions, Path(scratch), rows)
        timed = last if given.samples is None else given.samples / SAMPLES[0]
        rows.add("crenel calibrate, cold process", {"s": cold_process_s(timed, Path(scratch))})


def measure_random(count: int, scratch: Path, rows: Rows) -> Path:
    """Median and worst of random sessions, and how many are refused; the folder of the last."""
    found, refused, last = [], 0, Path()
    for folder in draw_sessions(count, scratch):
        last = folder
        try:
            found.append(measure_session(folder))
        except OperationError as refusal:
            refused += 1
            rows.say(f"{folder.name}: refused: {refusal}")
    for name, of in (("median", np.median), ("worst", np.max)) if found else ():
        rows.add(f"random, {name}", named([float(of(column)) for column in np.transpose(found)]))
    rows.add("random", {"measured": len(found), "refused": refused})
    return last


def named(values: Sequence[float]) -> dict[str, float]:
    return dict(zip(COLUMNS, values, strict=False))


if __name__ == "__main__":
    main()
