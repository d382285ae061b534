"""Eight poses of an arm whose model is off: Crenel beside OpenCV, session by session.

    python -m tests.bench.many_poses [--sessions 12] [--arm-um 100] [--wrong-in parameters]

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
    given = parser.parse_args()
    columns: dict[str, list[tuple[float, float]]] = defaultdict(list)
    refused = 0
    with tempfile.TemporaryDirectory() as scratch:
        for folder in draw_sessions(given.sessions, given.arm_um, given.wrong_in, Path(scratch)):
            try:
                found = measure_session(folder)
            except OperationError as refusal:
                refused += 1
                print(f"{folder.name}: refused: {refusal}")
                continue
            for name, errors in found.items():
                columns[name].append(errors)
    ours = np.array(columns["Crenel"])
    head = ("sensor um", "flange um", "flange rms", "Crenel ahead")
    print(f"{len(ours)} sessions, refused: {refused}")
    print(f"{'median over the sessions':<32}" + "".join(f"{name:>14}" for name in head))
    for name, rows in columns.items():
        values = np.array(rows)
        sensor, flange = np.median(values, axis=0)
        ahead = int((ours[:, 1] < values[:, 1]).sum())
        said = f"{ahead} of {len(ours)}" if name.startswith("OpenCV") else ""
        print(f"{name:<32}{sensor:>14.2f}{flange:>14.1f}{rms(values[:, 1]):>14.1f}{said:>14}")
    over_claim = ours[:, 1] / np.array(columns[CLAIMED])[:, 1]
    print(f"Crenel's error over its claim, rms over the sessions: {rms(over_claim):.2f}")


if __name__ == "__main__":
    main()
