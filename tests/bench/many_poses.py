"""Eight poses of an arm whose model is off: Crenel beside OpenCV, session by session.

    python -m tests.bench.many_poses [--sessions 12] [--arm-um 100] [--wrong-in parameters] [--json]

Sessions of random arms, sensors and blocks are rendered, each calibrated from the same
pictures and contacts by Crenel and as a competent user of OpenCV would (`block_peers`).
The truth's pixels are rebuilt and compared with where their light fell. How often Crenel
is ahead of each way, the median and rms over the sessions, and whether Crenel's claim holds.
"""

import argparse
import tempfile
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path
from typing import get_args

import numpy as np

from app.errors import OperationError
from app.formats.images import read_grey
from app.formats.session.calibration_session import read_session
from app.metrology.adjustment.block.calibrate import calibrate_block
from app.metrology.arm.kinematics import flange_poses
from app.metrology.targets.crenellated_block import corners
from app.metrology.transforms import Floats
from app.workflows.calibrate import joint_inputs
from hardware.simulator.devices.kinematics import ErrorSource, UnreachableError
from hardware.simulator.session import SessionPlan, render_session
from tests.bench.block_peers import calibrate_opencv, click_corners, errors_um
from tests.bench.board_measures import PeerCalibration
from tests.bench.rows import Rows, add_json_option, measured_rows

FIRST_SEED = 7000
POSES = 8
CLAIMED = "Crenel, as claimed"


def draw_sessions(count: int, arm_um: float, wrong_in: ErrorSource, folder: Path) -> Iterator[Path]:
    """``count`` random sessions, half of them with seven axes, any roll of the camera."""
    seed = FIRST_SEED
    while count:
        seed += 1
        rng = np.random.default_rng(seed)
        plan = SessionPlan(
            joints=int(rng.integers(6, 8)),
            poses=POSES,
            imperfection_um=arm_um,
            wrong_in=wrong_in,
            roll_rad=float(rng.uniform(-np.pi, np.pi)),
            distortion=(float(rng.uniform(-0.1, 0.05)), 0.0, 0.0, 0.0, 0.0),
        )
        try:
            render_session(folder / str(seed), seed, plan)
        except UnreachableError:
            continue
        count -= 1
        yield folder / str(seed)


def measure_session(folder: Path) -> dict[str, tuple[float, float]]:
    """Sensor frame and flange frame, rms in um, by who calibrated.

    Raises:
        Refusal: Crenel does not calibrate this session.
    """
    session = read_session(folder)
    inputs = joint_inputs(session)
    found = calibrate_block(inputs)
    pictures = {pose.number: pose.ambient for pose in session.poses}
    views = [
        click_corners(read_grey(pictures[seen.number]), seen, session, T)
        for seen, T in zip(
            inputs.observations, flange_poses(session.arm, inputs.q_rad), strict=True
        )
    ]
    nominal = np.array(list(corners(session.block).values()))
    crenel = PeerCalibration("Crenel", found.camera, found.T_flange_sensor, nominal, found.plane)
    errors = {
        solved.name: errors_um(solved, folder)
        for solved in (*calibrate_opencv(session, views), crenel)
    }
    return errors | {CLAIMED: (float("nan"), found.uncertainty.total_um)}


def rms(values: Floats) -> float:
    return float(np.sqrt(np.mean(values**2)))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--sessions", type=int, default=12)
    parser.add_argument("--arm-um", type=float, default=100.0)
    parser.add_argument("--wrong-in", choices=get_args(ErrorSource), default="links")
    add_json_option(parser)
    given = parser.parse_args()
    with measured_rows(given.json) as rows:
        measure_sessions(given.sessions, given.arm_um, given.wrong_in, rows)


def measure_sessions(count: int, arm_um: float, wrong_in: ErrorSource, rows: Rows) -> None:
    """A row for each way to calibrate."""
    columns: dict[str, list[tuple[float, float]]] = defaultdict(list)
    refused = 0
    with tempfile.TemporaryDirectory() as scratch:
        for folder in draw_sessions(count, arm_um, wrong_in, Path(scratch)):
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
    opencv = np.array(
        [np.array(errors)[:, 1] for name, errors in columns.items() if "Open" in name]
    )
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
