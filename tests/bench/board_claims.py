"""Does a calibration on a chessboard keep its word? Claimed against observed errors.

    python -m tests.bench board-claims [SESSIONS] [--arms N] [--json]

Sessions of eight pictures of a bent board on a robot, with everything that errs drawn again; and
of the simulated station's board, pictures rendered, by arms with datasheets true to 20 µm,
as is usual, and to 45 µm.
"""

import tempfile
from pathlib import Path

import numpy as np

from crenel.metrology.adjustment.board.calibrate import calibrate_board
from crenel_hardware.simulator.station import SimulationConfig
from tests.bench.rows import Rows, bench_parser, measured_rows, rms
from tests.metrology.rendered_boards import RenderedBoards, errors_um
from tests.metrology.seen_boards import BoardErrors, error_um, session

SET_UPS = {
    "robot off by 0.3 mrad, 0.05 mm": BoardErrors(),
    "the same, the board rocks by 1.5 mrad": BoardErrors(tilt_rad=1.5e-3),
    "robot off by 0.05 mrad, 0.02 mm": BoardErrors(turn_rad=5e-5, shift_mm=0.02),
    "the same, lines off by 5 µm, not 50": BoardErrors(5e-5, 0.02, line_mm=0.005, line_rad=1e-4),
    "the same, lines off by 200 µm": BoardErrors(5e-5, 0.02, line_mm=0.2, line_rad=4e-3),
}
ARMS_UM = (20.0, 45.0)


def main() -> None:
    parser = bench_parser(__doc__)
    parser.add_argument("sessions", type=int, nargs="?", default=60)
    parser.add_argument("--arms", type=int, default=8)
    asked = parser.parse_args()
    with measured_rows(asked.json) as rows:
        for name, errors in SET_UPS.items():
            found = [calibrate_board(session(seed, errors)) for seed in range(asked.sessions)]
            _add(rows, name, [(error_um(one), one.uncertainty.total_um) for one in found])
        for off_um in ARMS_UM if asked.arms else ():
            seeds = range(1, asked.arms + 1)
            plans = [SimulationConfig(seed=seed, imperfection_um=off_um) for seed in seeds]
            name = f"the station's board, arms off by {off_um:.0f} µm"
            _add(rows, name, [_measure_station(plan) for plan in plans])


def _measure_station(plan: SimulationConfig) -> tuple[float, float]:
    """Observed and claimed error of a simulated station, µm."""
    with tempfile.TemporaryDirectory() as folder:
        station = RenderedBoards(Path(folder), plan)
        return rms(errors_um(station)), station.calibration.uncertainty.total_um


def _add(rows: Rows, name: str, pairs: list[tuple[float, float]]) -> None:
    """The rms over sessions of observed and claimed errors."""
    observed, claimed = (rms(np.array(each)) for each in zip(*pairs, strict=True))
    ratio = claimed / observed
    rows.add(name, {"observed, µm": observed, "claimed, µm": claimed, "claimed / observed": ratio})


if __name__ == "__main__":
    main()
