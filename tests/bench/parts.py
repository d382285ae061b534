"""Inspections of simulated parts: claimed and observed uncertainty, and decisions.

Every draw has another true arm and sensor, from the covariance that their files state.
``--other`` takes a part, an arm and a sensor of which nothing was seen while the program was made.
"""

import argparse

import numpy as np

from tests.parts.draws import (
    difference_of_means,
    first_setting,
    inspect_draw,
    other_setting,
    ratios,
)


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m tests.bench parts", description=__doc__)
    parser.add_argument("--draws", type=int, default=16)
    parser.add_argument("--first", type=int, default=0, help="the first seed")
    parser.add_argument("--other", action="store_true")
    parser.add_argument("--datums", choices=("scan", "touch"), default="scan")
    parser.add_argument("--both", action="store_true", help="one bore by stripe and by tip")
    given = parser.parse_args()
    setting = other_setting() if given.other else first_setting()
    seeds = range(given.first, given.first + given.draws)
    if given.both:
        off = np.abs([difference_of_means(setting, seed) for seed in seeds])
        print(f"stripe and tip differ by less than 1.96 u in {np.mean(off < 1.96):.0%} of draws")
        print(f"claimed/observed {1 / np.sqrt(np.mean(off**2)):.2f}")
        return
    draws = [inspect_draw(setting, seed, given.datums)[1] for seed in seeds]
    pulls = []
    for name, ratio, bias, rms in ratios(draws):
        pulls.append(1 / ratio**2)
        print(f"{name:12} claimed/observed {ratio:5.2f}  bias {bias:+5.2f} u  rms {rms:.4f}")
    print(f"pooled claimed/observed {1 / np.sqrt(np.mean(pulls)):.2f}")
    found = [one for draw in draws for one in draw]
    decided = [one for one in found if one.result.decision in ("pass", "fail")]
    wrong = sum(one.is_wrong for one in decided)
    far = sum(one.is_needlessly_open for one in found)
    print(f"{len(decided)} of {len(found)} decided, {wrong} of them wrong")
    print(f"{far} undecided though the value is further than 2.5 u from its limits")


if __name__ == "__main__":
    main()
