"""Elements picked in simulated scans: claimed and observed uncertainty of the panel's figures.

Every draw has another true arm and sensor, from the covariance that their files state.
``--other`` takes a part, an arm and a sensor of which nothing was seen while the program was made.
"""

import argparse

import numpy as np

from tests.parts.draws import first_setting, other_setting
from tests.parts.element_draws import measure_draw, pulls_of


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m tests.bench elements", description=__doc__)
    parser.add_argument("--draws", type=int, default=16)
    parser.add_argument("--first", type=int, default=0, help="the first seed")
    parser.add_argument("--other", action="store_true")
    given = parser.parse_args()
    setting = other_setting() if given.other else first_setting()
    seeds = range(given.first, given.first + given.draws)
    draws = [measure_draw(setting, seed) for seed in seeds]
    pulls = []
    for name, ratio, bias, rms in pulls_of(draws):
        pulls.append(1 / ratio**2)
        print(f"{name:12} claimed/observed {ratio:5.2f}  bias {bias:+5.2f} u  rms {rms:.5f}")
    print(f"pooled claimed/observed {1 / np.sqrt(np.mean(pulls)):.2f}")


if __name__ == "__main__":
    main()
