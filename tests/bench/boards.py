"""Does a calibration on a chessboard keep its word? Claimed against observed errors.

    python -m tests.bench.boards [SESSIONS] [--arms N] [--json]

Sessions of eight pictures of a bent board on a robot, with everything that errs drawn again; and
of the simulated station's board, pictures rendered, by arms with datasheets true to 20 µm,
as is usual, and to 45 µm.
"""

import argparse
import tempfile
from pathlib import Path

import numpy as np

from app.metrology.adjustment.board.calibrate import calibrate_board
from hardware.simulator.station import SimulationConfig
from tests.bench.rows import add_json_option, measured_rows
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
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("sessions", type=int, nargs="?", default=60)
    parser.add_argument("--arms", type=int, default=8)
    add_json_option(parser)
    asked = parser.parse_args()
    with measured_rows(asked.json) as rows:
        for name, errors in SET_UPS.items():
            found = [calibrate_board(session(seed, errors)) for seed in range(asked.sessions)]
            claimed = np.sqrt(np.mean([one.uncertainty.total_um**2 for one in found]))
            observed = np.sqrt(np.mean([error_um(one) ** 2 for one in found]))
            rows.add(name, _values(observed, claimed))
        for off_um in ARMS_UM if asked.arms else ():
            name = f"the station's board, arms off by {off_um:.0f} µm"
            rows.add(name, _values(*_measure_on_arms(asked.arms, off_um)))


def _measure_on_arms(count: int, off_um: float) -> tuple[float, float]:
    """Observed and claimed error over so many simulated stations, rms, µm."""
    observed, claimed = [], []
    for seed in range(1, count + 1):
        with tempfile.TemporaryDirectory() as folder:
            station = RenderedBoards(
                Path(folder), SimulationConfig(seed=seed, imperfection_um=off_um)
            )
            observed.append(np.mean(errors_um(station) ** 2))
            claimed.append(station.calibration.uncertainty.total_um**2)
    return float(np.sqrt(np.mean(observed))), float(np.sqrt(np.mean(claimed)))


def _values(observed_um: float, claimed_um: float) -> dict[str, float]:
    ratio = claimed_um / observed_um
    return {"observed, µm": observed_um, "claimed, µm": claimed_um, "claimed / observed": ratio}


if __name__ == "__main__":
    main()
