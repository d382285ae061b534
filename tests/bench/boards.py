"""Does a calibration on a chessboard keep its word? Claimed against observed errors.

    python -m tests.bench.boards [SESSIONS]

Sessions of eight pictures of a bent sheet on a robot, with everything that errs drawn anew.
"""

import argparse

import numpy as np

from app.metrology.adjustment.board_joint import calibrate_board
from tests.metrology.seen_boards import Errors, error_um, session

SET_UPS = {
    "robot off by 0.3 mrad, 0.05 mm": Errors(),
    "the same, the board rocks by 1.5 mrad": Errors(tilt_rad=1.5e-3),
    "robot off by 0.05 mrad, 0.02 mm": Errors(turn_rad=5e-5, shift_mm=0.02),
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("sessions", type=int, nargs="?", default=60)
    count = parser.parse_args().sessions
    print(f"{'':<40}{'observed':>10}{'claimed':>10}{'claimed / observed':>22}")
    for name, errors in SET_UPS.items():
        found = [calibrate_board(session(seed, errors)) for seed in range(count)]
        claimed = np.sqrt(np.mean([one.known.total_um**2 for one in found]))
        observed = np.sqrt(np.mean([error_um(one) ** 2 for one in found]))
        print(f"{name:<40}{observed:>7.0f} µm{claimed:>7.0f} µm{claimed / observed:>22.2f}")


if __name__ == "__main__":
    main()
