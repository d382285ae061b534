"""How often a fault in all contacts, or in the block's certificate, is told as what it is.

    python -m tests.bench.told_faults [--draws 40]

Sessions of random stations (six poses, forty touches on four faces) are drawn without pictures,
as ``crenel bench calibration`` does, with arms of three qualities; each is given one fault.
Counted is how often it is told by its name, and how often as something else.
"""

import argparse
from collections.abc import Callable
from dataclasses import replace

import numpy as np
from scipy.spatial.transform import Rotation

from app.bench.metrology.simulated import USUAL, Draw, SetUp, Station, drawn, station_of
from app.metrology.adjustment.core.gauss_newton import adjust
from app.metrology.adjustment.core.observations import Touches
from app.metrology.adjustment.outliers.fault_hypotheses import about_block_faults
from app.metrology.limits import LIMITS
from app.metrology.transforms import Floats

FACES = ("crest", "front", "left", "right")
STATIONS, POSES, PER_FACE = 4, 6, 10
CODES = ("tip-diameter", "tip-place", "object-moved", "object-size", "size")
# The tip's error over the arm's reach, and the links' errors that make it.
ARMS = {
    "25 um": USUAL,
    "100 um": replace(USUAL, links_mm=0.012, links_rad=3e-5),
    "250 um": replace(USUAL, links_mm=0.03, links_rad=7.5e-5),
}

Fault = Callable[[Draw, Station, np.random.Generator], Draw]


def none(session: Draw, _station: Station, _rng: np.random.Generator) -> Draw:
    return session


def diameter(by_mm: float) -> Fault:
    def spoilt(session: Draw, _station: Station, _rng: np.random.Generator) -> Draw:
        touches = touched(session)
        return with_touches(session, replace(touches, radius_mm=touches.radius_mm + by_mm / 2))

    return spoilt


def place(by_mm: float) -> Fault:
    def spoilt(session: Draw, _station: Station, rng: np.random.Generator) -> Draw:
        touches = touched(session)
        return moved(session, touches.R_arm_flange @ (by_mm * direction(rng)))

    return spoilt


def nudged(by_mm: float, by_deg: float) -> Fault:
    def spoilt(session: Draw, _station: Station, rng: np.random.Generator) -> Draw:
        tips = touched(session).tips_mm
        turn = Rotation.from_rotvec(np.radians(by_deg) * direction(rng)).as_matrix()
        arms = tips - tips.mean(axis=0)
        return moved(session, arms @ turn.T - arms + by_mm * direction(rng))

    return spoilt


def scaled(share: float) -> Fault:
    def spoilt(session: Draw, _station: Station, _rng: np.random.Generator) -> Draw:
        papers, state = session.problem.papers, session.start
        papers = replace(papers, coordinates=papers.coordinates * (1 + share))
        state = replace(state, coordinates=state.coordinates * (1 + share))
        return replace(session, problem=replace(session.problem, papers=papers), start=state)

    return spoilt


FAULTS: dict[str, tuple[str, Fault]] = {
    "none": ("", none),
    "tip 0.1 mm too large": ("tip-diameter", diameter(0.1)),
    "tip 0.1 mm from its place": ("tip-place", place(0.1)),
    "tip 0.3 mm from its place": ("tip-place", place(0.3)),
    "block moved by 0.1 mm, 0.05 deg": ("object-moved", nudged(0.1, 0.05)),
    "block moved by 0.3 mm, 0.2 deg": ("object-moved", nudged(0.3, 0.2)),
    "certificate 0.3 % too large": ("object-size", scaled(0.003)),
    "certificate 1 % too large": ("object-size", scaled(0.01)),
}


def touched(session: Draw) -> Touches:
    assert session.problem.touches is not None
    return session.problem.touches


def with_touches(session: Draw, touches: Touches) -> Draw:
    return replace(session, problem=replace(session.problem, touches=touches))


def moved(session: Draw, by_mm: Floats) -> Draw:
    touches = touched(session)
    return with_touches(session, replace(touches, tips_mm=touches.tips_mm + by_mm))


def direction(rng: np.random.Generator) -> Floats:
    drawn_mm = rng.normal(size=3)
    return np.asarray(drawn_mm / np.linalg.norm(drawn_mm))


def told(station: Station, fault: Fault, seed: int) -> str:
    """The fault that is named, or none."""
    rng = np.random.default_rng(seed)
    session = fault(drawn(station, rng), station, rng)
    found = about_block_faults(adjust(session.problem, session.start), LIMITS)
    named = [one.code for one in found if one.code in CODES and one.quality != "good"]
    return named[0] if named else ""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--draws", type=int, default=40)
    draws = parser.parse_args().draws
    print(f"{'told as what it is, and as something else':<42}" + "".join(f"{a:>14}" for a in ARMS))
    for name, (code, fault) in FAULTS.items():
        line = f"{name:<42}"
        for scales in ARMS.values():
            stations = [
                station_of(
                    SetUp(name, POSES, 6 + k % 2, FACES, PER_FACE, scales=scales, seed=k + 1)
                )
                for k in range(STATIONS)
            ]
            codes = [told(stations[k % STATIONS], fault, k) for k in range(draws)]
            right = sum(one == code for one in codes if code)
            other = sum(one not in (code, "") for one in codes)
            line += f"{f'{100 * right / draws:.0f} %, {100 * other / draws:.0f} %':>14}"
        print(line, flush=True)


if __name__ == "__main__":
    main()
