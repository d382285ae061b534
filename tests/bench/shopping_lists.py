"""What accuracy to expect of the three sets of parts in docs/what_do_i_need.md.

    python -m tests.bench shopping-lists [SESSIONS] [--json]

Calibrations of simulated sessions with what each set is like: its arm, its camera's pixels and
noise, its target. The truth's points are rebuilt and compared in the frame of the flange. What the
arm itself errs by comes on top in a cloud, and is the last column.
"""

import tempfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

import numpy as np

from crenel.errors import OperationError
from crenel.formats.session.calibration_session import read_session
from crenel.metrology.adjustment.block.calibrate import calibrate_block
from crenel.metrology.adjustment.board.calibrate import calibrate_board
from crenel.metrology.targets.chessboard import Chessboard
from crenel.workflows.calibrate import joint_inputs
from crenel_hardware.simulator.rendering.noise import Detector
from crenel_hardware.simulator.session import SessionPlan
from tests.bench.rows import bench_parser, measured_rows, rms
from tests.bench.sessions import draw_camera, draw_sessions, errors_um
from tests.metrology.boards import POSES
from tests.metrology.seen_boards import BoardErrors, error_um, session

FIRST_SEED = 9101
LEVER_MM = 300.0
"""From a robot's flange to what the sensor sees: its turn errs by so much."""
ROBOT = BoardErrors(turn_rad=2e-4, shift_mm=0.1, line_mm=0.03, line_rad=5e-4)
PRINTED = Chessboard("printed board", "", (10, 7), 10.0, 0.02, 0.2)
WEBCAM = Detector(read_dn=3.0, shot_dn=0.12, blur_px=1.0)
"""Of small pixels behind a plastic lens, one raw picture without its compression."""

Measured = tuple[float, float]
"""Observed rms and claimed standard uncertainty of a session's calibration, in µm."""


@dataclass(frozen=True)
class PartsList:
    """One set of parts: its sessions, and what its arm errs by over its reach, in µm."""

    name: str
    arm_um: float
    measure: Callable[[int], Iterator[Measured]]


def measure_boards(count: int) -> Iterator[Measured]:
    """Sixteen pictures each of a printed board, taken by a robot."""
    for seed in range(FIRST_SEED, FIRST_SEED + count):
        found = calibrate_board(session(seed, ROBOT, PRINTED, POSES + POSES))
        yield error_um(found), found.uncertainty.total_um


def measure_blocks(plan: SessionPlan, count: int) -> Iterator[Measured]:
    """Pictures and touches of a block each; what is refused is left out."""

    def draw(rng: np.random.Generator) -> SessionPlan:
        return replace(plan, **draw_camera(rng))

    with tempfile.TemporaryDirectory() as scratch:
        for folder in draw_sessions(count, FIRST_SEED, draw, Path(scratch)):
            try:
                found = calibrate_block(joint_inputs(read_session(folder)))
            except OperationError:
                continue
            yield errors_um(found, folder)[1], found.uncertainty.total_um


SELF_BUILT_UM, VENDOR_UM = 400.0, 35.0
SELF_BUILT = SessionPlan(
    poses=8,
    imperfection_um=SELF_BUILT_UM,
    width_px=1920,
    height_px=1080,
    contact_sd_mm=0.05,
    certificate_sd_mm=0.02,
    detector=WEBCAM,
)
VENDOR = SessionPlan(joints=7, poses=8, imperfection_um=VENDOR_UM)
LISTS = (
    PartsList(
        "industrial camera on a robot",
        1e3 * float(np.hypot(ROBOT.shift_mm, ROBOT.turn_rad * LEVER_MM)) * 3**0.5,
        measure_boards,
    ),
    PartsList("webcam on a self-built arm", SELF_BUILT_UM, partial(measure_blocks, SELF_BUILT)),
    PartsList("sensor on a vendor's arm", VENDOR_UM, partial(measure_blocks, VENDOR)),
)


def main() -> None:
    parser = bench_parser(__doc__)
    parser.add_argument("sessions", type=int, nargs="?", default=12)
    given = parser.parse_args()
    with measured_rows(given.json) as rows:
        for one in LISTS:
            observed, claimed = np.array(list(one.measure(given.sessions))).T
            rows.add(
                one.name,
                {
                    "sessions": len(observed),
                    "median, µm": float(np.median(observed)),
                    "rms, µm": rms(observed),
                    "claimed, µm": rms(claimed),
                    "arm's own, µm": one.arm_um,
                },
            )


if __name__ == "__main__":
    main()
