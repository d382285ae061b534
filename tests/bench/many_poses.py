"""Eight poses of an arm whose model is off: Crenel beside OpenCV, session by session.

    python -m tests.bench many-poses [--sessions 12] [--arm-um 100] [--wrong-in parameters] [--json]

Sessions of random arms, sensors and blocks are rendered, each calibrated from the same
pictures and contacts by Crenel and as a competent user of OpenCV would (`block_peers`).
The truth's pixels are rebuilt and compared with where their light fell. How often Crenel
is ahead of each way, the median and rms over the sessions, and whether Crenel's claim holds.
"""

import tempfile
from collections import defaultdict
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import get_args

import numpy as np

from crenel.errors import OperationError
from crenel.formats.session.calibration_session import read_session
from crenel.metrology.adjustment.block.calibrate import calibrate_block
from crenel.workflows.calibrate import joint_inputs
from crenel_hardware.simulator.devices.kinematics import ErrorSource
from crenel_hardware.simulator.session import SessionPlan
from tests.bench.block_peers import calibrate_opencv
from tests.bench.rows import Rows, bench_parser, measured_rows, rms
from tests.bench.sessions import draw_camera, draw_sessions, errors_um

FIRST_SEED = 7001
POSES = 8
CLAIMED = "Crenel, as claimed"


def draw_plan(arm_um: float, wrong_in: ErrorSource, rng: np.random.Generator) -> SessionPlan:
    """Half of them with seven axes, any roll of the camera."""
    joints = int(rng.integers(6, 8))
    plan = SessionPlan(joints, poses=POSES, imperfection_um=arm_um, wrong_in=wrong_in)
    return replace(plan, **draw_camera(rng))


def measure_session(folder: Path) -> dict[str, tuple[float, float]]:
    """Sensor frame and flange frame, rms in um, by who calibrated. Refusal: Crenel does not."""
    session = read_session(folder)
    inputs = joint_inputs(session)
    found = calibrate_block(inputs)
    errors = {one.name: errors_um(one, folder) for one in calibrate_opencv(session, inputs)}
    errors["Crenel"] = errors_um(found, folder)
    return errors | {CLAIMED: (float("nan"), found.uncertainty.total_um)}


def main() -> None:
    parser = bench_parser(__doc__)
    parser.add_argument("--sessions", type=int, default=12)
    parser.add_argument("--arm-um", type=float, default=100.0)
    parser.add_argument("--wrong-in", choices=get_args(ErrorSource), default="links")
    given = parser.parse_args()
    with measured_rows(given.json) as rows:
        measure_sessions(given.sessions, given.arm_um, given.wrong_in, rows)


def measure_sessions(count: int, arm_um: float, wrong_in: ErrorSource, rows: Rows) -> None:
    """A row for each way to calibrate."""
    columns: dict[str, list[tuple[float, float]]] = defaultdict(list)
    refused = 0
    draw = partial(draw_plan, arm_um, wrong_in)
    with tempfile.TemporaryDirectory() as scratch:
        for folder in draw_sessions(count, FIRST_SEED, draw, Path(scratch)):
            try:
                found = measure_session(folder)
            except OperationError as refusal:
                refused += 1
                rows.say(f"{folder.name}: refused: {refusal}")
                continue
            for name, of_session in found.items():
                columns[name].append(of_session)
    ours = np.array(columns["Crenel"])
    for name, errors in columns.items():
        values = np.array(errors)
        sensor, flange = np.median(values, axis=0)
        medians = {"sensor, median µm": sensor, "flange, median µm": flange}
        ahead = int((ours[:, 1] < values[:, 1]).sum())
        rows.add(name, medians | {"flange, rms µm": rms(values[:, 1]), "Crenel ahead": ahead})
    opencv = np.array([errors for name, errors in columns.items() if "Open" in name])[:, :, 1]
    over_claim = ours[:, 1] / np.array(columns[CLAIMED])[:, 1]
    sessions = {
        "measured": len(ours),
        "refused": refused,
        "Crenel ahead of all": int((ours[:, 1] < opencv.min(axis=0)).sum()),
        "Crenel's error over its claim, rms": rms(over_claim),
    }
    rows.add("sessions", sessions)


if __name__ == "__main__":
    main()
