"""How good a calibration is, and how long it takes: tables of docs/accuracy.md.

    python -m tests.bench accuracy [SAMPLES] [--sessions 20] [--json]

Simulated sessions of blocks, arms and cameras drawn at random, and the sample sessions
where their folder is given. Each is calibrated; the truth's pixels are rebuilt and
compared with where their light fell. Beside it in the same run: the same corners by
Faugeras' linear method alone, as in the article. The samples also by all their poses
in the joint adjustment.
"""

import tempfile
import time
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from crenel.errors import OperationError
from crenel.formats.session.calibration_session import read_session
from crenel.metrology.adjustment.block.calibrate import calibrate_block
from crenel.metrology.calibration.laser_plane_fit import fit_laser_plane
from crenel.metrology.calibration.one_pose import OnePoseCalibration, calibrate_one_pose
from crenel.workflows.calibrate import joint_inputs, one_pose_inputs
from crenel_hardware.simulator.session import SessionPlan
from tests.bench.gauges import crenel
from tests.bench.rows import Rows, bench_parser, measured_rows
from tests.bench.sessions import draw_camera, draw_sessions, errors_um, in_sensor_um

SAMPLES = ("one-pose", "many-poses", "metal")
COLUMNS = ("sensor, µm", "flange, µm", "claimed, µm", "linear only, µm")
FIRST_SEED = 9000
RUNS = 5


def linear_um(found: OnePoseCalibration, folder: Path) -> float:
    """Faugeras' matrix on the corners and a plane through the stripe, nothing refined."""
    camera, block = found.faugeras.camera, found.fit.scene.block
    try:
        plane = fit_laser_plane(camera, block, found.stripe).plane
    except OperationError:
        return float("nan")
    return in_sensor_um(camera, plane, folder)


def measure_session(folder: Path) -> tuple[float, float, float, float]:
    """Sensor frame, flange frame, claimed uncertainty, linear method: all in um."""
    session = read_session(folder)
    found = calibrate_one_pose(one_pose_inputs(session, session.poses[0]))
    return (*errors_um(found, folder), found.total_um, linear_um(found, folder))


def measure_joint(folder: Path) -> tuple[float, float, float]:
    """All poses together: sensor frame, flange frame, claimed uncertainty, all in um."""
    found = calibrate_block(joint_inputs(read_session(folder)))
    return (*errors_um(found, folder), found.uncertainty.total_um)


def draw_plan(rng: np.random.Generator) -> SessionPlan:
    """Turned cameras, both lightings, six and seven joints."""
    joints, lighting = int(rng.integers(6, 8)), str(rng.choice(["pair", "both"]))
    return SessionPlan(joints=joints, lighting=lighting, **draw_camera(rng))


def cold_process_s(folder: Path, scratch: Path) -> float:
    """Median wall time of ``crenel calibrate`` as a process of its own, its files in the cache."""
    times = []
    for _ in range(RUNS + 1):
        start = time.perf_counter()
        crenel("calibrate", folder, "-o", scratch / "calibration.json")
        times.append(time.perf_counter() - start)
    return float(np.median(times[1:]))


def main() -> None:
    parser = bench_parser(__doc__)
    parser.add_argument("samples", type=Path, nargs="?")
    parser.add_argument("--sessions", type=int, default=20)
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
    for folder in draw_sessions(count, FIRST_SEED, draw_plan, scratch):
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
