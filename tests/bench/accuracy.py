"""How good a calibration is, and how long it takes: tables of docs/accuracy.md.

    python -m tests.bench.accuracy [SAMPLES] [--sessions 20]

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
from collections.abc import Iterator
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
    given = parser.parse_args()
    head = ("session", "sensor um", "flange um", "claimed um", "linear only um")
    print(f"{head[0]:<24}" + "".join(f"{name:>16}" for name in head[1:]))
    if given.samples is not None:
        for name in ("one-pose", "many-poses", "metal"):
            figures = measure_session(given.samples / name)
            print(f"{name:<24}" + "".join(f"{value:>16.2f}" for value in figures))
            together = f"{name}, joint"
            print(
                f"{together:<24}"
                + "".join(f"{v:>16.2f}" for v in measure_joint(given.samples / name))
            )
    with tempfile.TemporaryDirectory() as scratch:
        rows, refused, last = [], 0, Path()
        for folder in draw_sessions(given.sessions, Path(scratch)):
            last = folder
            try:
                rows.append(measure_session(folder))
            except OperationError as refusal:
                refused += 1
                print(f"{folder.name}: refused: {refusal}")
        if rows:
            for name, of in (("median", np.median), ("worst", np.max)):
                values = [float(of(np.array(column))) for column in zip(*rows, strict=True)]
                label = f"{len(rows)} random, {name}"
                print(f"{label:<24}" + "".join(f"{value:>16.2f}" for value in values))
        print(f"refused: {refused}")
        timed = given.samples / "one-pose" if given.samples is not None else last
        print(f"crenel calibrate, cold process: {cold_process_s(timed, Path(scratch)):.2f} s")


if __name__ == "__main__":
    main()
